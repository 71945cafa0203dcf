// SPDX-License-Identifier: Apache-2.0
// A Stribeck curve of 200 points, and a million operating points of one scene. The contenders of
// other families solve fewer points there: times are per point.
#include <memory>

#include "cases/curve_cases.hpp"
#include "cases/measured.hpp"

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
          [=] { return judge(contender); },
          {},
          {}};
}

}  // namespace

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

std::vector<Measured> curve_jobs(Settings settings) { return jobs_of(curve_contenders(settings)); }

}  // namespace tribo::benchmarks
