// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "engine.hpp"
#include "tribo/scene.hpp"

namespace tribo {

void Speeds::fill(std::size_t first, std::span<double> speeds) const {
  if (!list.empty()) {
    std::copy_n(list.begin() + static_cast<std::ptrdiff_t>(first), speeds.size(), speeds.begin());
    return;
  }
  const detail::Kernels& engine = detail::engine();
  const double log_range =
      spacing == Spacing::log ? engine.logarithm(to) - engine.logarithm(from) : 0;
  const bool in_halves = log_range >= 700;  // e^log_range may overflow, the speeds do not
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    const double t = static_cast<double>(first + i) / static_cast<double>(count - 1);
    speeds[i] = spacing == Spacing::lin ? from * (1 - t) + to * t
                                        : t * (in_halves ? log_range / 2 : log_range);
  }
  if (spacing == Spacing::log) {
    engine.exponentials(speeds.data(), speeds.data(), speeds.size());
    for (double& speed : speeds) speed = in_halves ? from * speed * speed : from * speed;
  }
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    if (first + i == 0) speeds[i] = from;
    if (first + i + 1 == count) speeds[i] = to;
  }
}

}  // namespace tribo
