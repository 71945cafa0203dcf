// SPDX-License-Identifier: Apache-2.0
// Loops that end when a step vanishes must end in each rounding mode. This file is compiled with
// -frounding-math. The values in each mode are checked by contract/contract_test.cpp.
#include <gtest/gtest.h>

#include <cfenv>
#include <vector>

#include "support/condition.hpp"
#include "support/judge.hpp"
#include "support/scenes.hpp"
#include "tribo/onset.hpp"

namespace tribo::verification {
namespace {

struct Mode {
  int mode;
  const char* name;
  double multiple;  // the allowed error over the contract's
};
constexpr std::array modes{Mode{FE_TONEAREST, "nearest", 1}, Mode{FE_UPWARD, "upward", 2},
                           Mode{FE_DOWNWARD, "downward", 2}, Mode{FE_TOWARDZERO, "toward zero", 2}};

// A rounding mode for the life of the object.
class RoundingMode {
 public:
  explicit RoundingMode(int mode) : before_(std::fegetround()) { std::fesetround(mode); }
  ~RoundingMode() { std::fesetround(before_); }
  RoundingMode(const RoundingMode&) = delete;
  RoundingMode& operator=(const RoundingMode&) = delete;

 private:
  int before_;
};

// The value of f() in a rounding mode. The numbers to compare are computed outside of it.
template <class Function>
auto rounded(const Mode& mode, Function&& f) {
  const RoundingMode in_force(mode.mode);
  auto value = f();
  asm volatile("" : "+m"(value));  // g++ -O1 would move a division past the end of the mode
  return value;
}

// This test makes sure that the other tests do not test rounding to nearest four times. The
// compiler must not fold, hoist or share an expression that depends on the mode. clang++ folds
// constants in spite of -frounding-math, so that the numbers are volatile.
TEST(RoundingModes, AreInForceInsideTheModelAndEndWithTheirScope) {
  volatile int one = 1, three = 3;
  for (const Mode& mode : modes) {
    const double third = rounded(mode, [&] { return ratio<double>(one, three); });
    const double minus_third = rounded(mode, [&] { return ratio<double>(-one, three); });
    const double below = 0x1.5555555555555p-2;  // the nearer neighbour of 1/3
    const double above = std::nextafter(below, 1.0);
    EXPECT_EQ(third, mode.mode == FE_UPWARD ? above : below) << mode.name;
    EXPECT_EQ(minus_third, mode.mode == FE_DOWNWARD ? -above : -below) << mode.name;
    int different = 0;
    for (double d = -9; d < 9; d += 0.37)
      different += rounded(mode, [&] { return gaussian_moment(Order::five_halves, d); }) !=
                   gaussian_moment(Order::five_halves, d);
    if (mode.mode == FE_TONEAREST) {
      EXPECT_EQ(different, 0);
    } else {
      EXPECT_GT(different, 10) << mode.name;  // of 49; about half differ if rounded correctly
    }
    EXPECT_EQ(std::fegetround(), FE_TONEAREST) << mode.name;
  }
}

// The loops end when a step is small or not positive. With rounding to one side such a step might
// never come. Each mode may therefore take at most three steps more than rounding to nearest. The
// contract test checks the roots.
TEST(RoundingModes, RootsAtTheEndsOfTheRangeTakeNoMoreStepsThanInNearest) {
  for (const auto model : asperity_models)
    for (const double stiffness : {1e-300, 1e-20, 0.3, 1.0, 7.0, 1e6, 1e300})
      for (const double offset : {0.0, 1.146, 10.0})
        for (const double lambda0 : {1e-300, 1e-20, 1e-3, 0.7, 2.1, 40.0, 1e10, 1e300}) {
          const auto solve = [&] {
            return LoadSharing<double>(model, stiffness, offset).solve(lambda0);
          };
          const int in_nearest = solve().iterations;
          for (const Mode& mode : modes)
            EXPECT_LE(rounded(mode, solve).iterations, in_nearest + 3)
                << mode.name
                << describe({{"K", stiffness}, {"delta", offset}, {"lambda0", lambda0}});
        }
}

// Curves, the brackets at constant flow and the golden section end, and in each mode they end at
// the same place as in rounding to nearest.
TEST(RoundingModes, CurvesAndOnsetsComeToTheirEnd) {
  for (const auto closure : starvation_closures)
    for (const auto supply : {SupplyKind::inlet_film_ratio, SupplyKind::inlet_flow})
      for (const int planes : {1, 2}) {
        Scene scene = starved_scene(PaperSurface::rough, closure, supply);
        scene.speeds.count = 40;
        scene.surface.offset_planes = planes;
        const auto onset_by = [&](OnsetCriterion criterion) {
          return onset(MixedContact<double>(scene), scene, criterion, default_departure);
        };
        for (const Mode& mode : modes) {
          int points = 0;
          double last_speed = 0;
          rounded(mode, [&] {
            stribeck_curve(MixedContact<double>(scene), scene.speeds.from, scene.speeds.to,
                           scene.speeds.count, scene.outputs, [&](const auto& point) {
                             ++points;
                             last_speed = point.speed;
                           });
            return 0;
          });
          EXPECT_EQ(points, 40) << mode.name;
          EXPECT_TRUE(is_close(last_speed, scene.speeds.to, 1.1e-9, {})) << mode.name;
          for (const CriterionInfo& info : onset_criteria) {
            const OnsetCriterion criterion = info.criterion;
            const Onset<double> nearest = onset_by(criterion);
            const Onset<double> got = rounded(mode, [&] { return onset_by(criterion); });
            EXPECT_EQ(got.exists, nearest.exists) << mode.name << ' ' << name(criterion);
            if (!nearest.exists) continue;
            if (criterion != OnsetCriterion::friction_minimum) {
              EXPECT_TRUE(is_close(got.speed, nearest.speed, mode.multiple * 1e-13, {}))
                  << mode.name << ' ' << name(criterion);
              continue;
            }
            // A minimum is flat, and its place therefore uncertain. Its value is compared.
            const auto friction = [&](double speed) {
              return MixedContact<double>(scene).solve(speed).friction;
            };
            const double condition =
                conditions_at(scene, nearest.speed)[static_cast<std::size_t>(Output::friction)];
            EXPECT_TRUE(keeps(operating_point_contract, friction(got.speed),
                              friction(nearest.speed), condition, mode.multiple + 1,
                              {{"u", got.speed}, {"u in nearest", nearest.speed}}))
                << mode.name;
          }
        }
      }
}

}  // namespace
}  // namespace tribo::verification
