// The contact radius of the paper's Table 1: F = 50 N, E* = 107.9 GPa, R = 9.5 mm.
#include <cstdio>
#include <tribo/hertz.hpp>
#include <tribo/scene_reader.hpp>

int main() {
  const auto contact = tribo::hertz_point(50.0, 107.9e9, 9.5e-3);
  std::printf("%.1f µm\n", contact.radius * 1e6);
  // Something out of the archive too, so that it is linked and not only compiled against.
  return tribo::scene_fields().empty() ? 1 : 0;
}
