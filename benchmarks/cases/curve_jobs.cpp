// SPDX-License-Identifier: Apache-2.0
// A Stribeck curve of 200 points, and a million operating points of one scene. In the second job
// the contenders of other families solve fewer points; times are therefore compared per point.
#include <cmath>
#include <memory>
#include <stdexcept>

#include "cases/jobs.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::benchmarks {
namespace {

Measured curve_job(const CurveContender& contender, const std::string& job, std::size_t count) {
  struct Room {
    std::vector<double> speeds;
    OperatingPoints points;
  };
  const auto room = std::make_shared<Room>();
  return {job,
          contender.family,
          contender.name,
          count,
          [=] {
            if (room->speeds.empty()) {
              room->speeds = curve_speeds(count);
              room->points.resize(count, curve_outputs());
            }
            contender.run(curve_scene(), room->speeds, room->points);
          },
          [=] { return judge(contender); }};
}

}  // namespace

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
    if (film > 0) tally.add(points.film[i], film);  // every contender has 0 for a collapsed film
  }
  return tally.errors();
}

std::vector<Measured> jobs_of(const std::vector<CurveContender>& contenders) {
  std::vector<Measured> all;
  for (const CurveContender& contender : contenders)
    all.push_back(curve_job(contender, "curve_200", 200));
  for (const CurveContender& contender : contenders)
    all.push_back(curve_job(contender, "points_1e6",
                            contender.is_slow                  ? 1000
                            : contender.family == "tribocheck" ? 1000000
                                                               : 100000));
  return all;
}

}  // namespace tribo::benchmarks
