// SPDX-License-Identifier: Apache-2.0
// A Stribeck curve of 200 points, and a million operating points of one scene (fewer for the
// others: the time is a point's).
#include <memory>

#include "cases/curve_cases.hpp"
#include "kernels/measured.hpp"

namespace tribo::benchmarks {
namespace {

void register_curve(const CurveContender& contender, const std::string& job, std::size_t count) {
  struct Room {
    std::vector<double> speeds;
    OperatingPoints points;
  };
  const auto room = std::make_shared<Room>();
  register_benchmark({job,
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
                      {}});
}

}  // namespace

void register_curves() {
  describe_job("curve_200", "Stribeck curve of 200 points: film, load share, friction");
  describe_job("points_1e6", "A million operating points of one scene, a point");
  const std::vector<CurveContender> all = curve_contenders();
  for (const CurveContender& contender : all) register_curve(contender, "curve_200", 200);
  for (const CurveContender& contender : all)
    register_curve(contender, "points_1e6",
                   contender.is_slow                  ? 1000
                   : contender.family == "tribocheck" ? 1000000
                                                      : 100000);
}

}  // namespace tribo::benchmarks
