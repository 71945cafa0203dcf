// SPDX-License-Identifier: Apache-2.0
#include "cases/curve_cases.hpp"

#include <cmath>
#include <stdexcept>

#include "tribo/mixed_contact.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::benchmarks {

const Scene& curve_scene() {
  static const Scene scene = [] {
    const SceneReading reading =
        read_scene(TRIBOCHECK_REFERENCE "/published/rough.toml", SceneUse::speeds);
    if (!reading.scene) throw std::runtime_error("reference/published/rough.toml is no scene");
    return *reading.scene;
  }();
  return scene;
}

std::vector<double> curve_speeds(std::size_t count) {
  const Speeds& range = curve_scene().speeds;
  const double ratio = range[range.size() - 1] / range[0];
  std::vector<double> speeds(count);
  for (std::size_t i = 0; i < count; ++i)
    speeds[i] = range[0] * std::pow(ratio, static_cast<double>(i) / static_cast<double>(count - 1));
  return speeds;
}

Errors judge(const CurveContender& contender, std::size_t count) {
  OperatingPoints points;
  points.resize(count, curve_outputs());
  contender.run(curve_scene(), curve_speeds(count), points);
  const MixedContact<long double> exact(curve_scene());
  ErrorTally tally;
  for (std::size_t i = 0; i < count; ++i) {
    const long double film =
        exact.solve(static_cast<long double>(points.speed[i]), curve_outputs()).film;
    if (film > 0) tally.add(points.film[i], film);  // a collapsed film is 0 to all
  }
  return tally.errors();
}

}  // namespace tribo::benchmarks
