// SPDX-License-Identifier: Apache-2.0
#include "live/least_films.hpp"

#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace tribo::live {
namespace {

// A table as make_live.py packs it: the first number of all nodes, then the second, and so on.
struct PackedFilms {
  double unit, first_load, load_step, material_step;
  std::size_t load_steps, material_steps;
  const unsigned char* bytes;
};
#include "least_films.inc"

// Reads the next code that packed() of make_live.py wrote, and moves `byte` behind it. The code is
// 0 where there is no number; for a difference n it is 2n + 1 if n ≥ 0, and −2n if n < 0.
long next_code(const unsigned char*& byte) {
  long code = 0;
  for (int shift = 0;; shift += 7) {
    code += static_cast<long>(*byte & 127) << shift;
    if (*byte++ > 127) return code;
  }
}

struct Unpacked {
  explicit Unpacked(const PackedFilms& packed) {
    const std::size_t row = packed.material_steps + 1, count = row * (packed.load_steps + 1);
    nodes = std::make_unique<double[][4]>(count);
    const unsigned char* byte = packed.bytes;
    std::vector<long> known(count);
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t i = 0; i < count; ++i) {
        const long left = i % row > 0 ? known[i - 1] : 0, above = i >= row ? known[i - row] : 0,
                   between = i % row > 0 && i >= row ? known[i - row - 1] : 0;
        const long code = next_code(byte);
        const long difference = code % 2 == 1 ? code / 2 : -(code / 2);
        known[i] = left + above - between + difference;
        nodes[i][k] = code == 0 ? std::numeric_limits<double>::quiet_NaN()
                                : static_cast<double>(known[i]) * packed.unit;
      }
    table = {packed.first_load, packed.load_step,      packed.material_step,
             packed.load_steps, packed.material_steps, nodes.get()};
  }
  std::unique_ptr<double[][4]> nodes;
  FilmTable table{};
};

}  // namespace

const FilmTable& least_film_table(bool is_of_lines) {
  static const Unpacked lines(line_minimum), points(point_minimum);
  return (is_of_lines ? lines : points).table;
}

}  // namespace tribo::live
