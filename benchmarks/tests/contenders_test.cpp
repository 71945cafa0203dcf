// SPDX-License-Identifier: Apache-2.0
// The contenders are what they claim to be: right where they should be, and wrong where they are
// known to be.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "cases/curve_cases.hpp"
#include "cases/ellipse_cases.hpp"
#include "cases/moment_cases.hpp"
#include "cases/root_cases.hpp"
#include "support/case_count.hpp"
#include "support/judge.hpp"
#include "tribo/batch.hpp"
#include "tribo/gaussian_moment.hpp"
#include "tribo/hertz_ellipse.hpp"

namespace tribo::benchmarks {
namespace {

using verification::is_within;

double at(const MomentContender& contender, double d) {
  double value = std::numeric_limits<double>::quiet_NaN();
  contender.run({&d, 1}, {&value, 1});
  return value;
}

const MomentContender& moment_named(const std::string& name) {
  static const std::vector<MomentContender> all = moment_contenders();
  for (const MomentContender& contender : all)
    if (contender.name == name) return contender;
  throw std::runtime_error("no contender " + name);
}

bool is_of_another_set_than_the_best(const std::string& name) {
  const auto others = instruction_sets().subspan(1);
  return std::any_of(others.begin(), others.end(),
                     [&](std::string_view set) { return name.ends_with(set); });
}

// Contenders that differ only in their instruction set are all checked, but only the cases of the
// best set are counted, so that the manifest of checks is the same on every machine.
template <class Contender, class Visitor>
void on_each(const std::vector<Contender>& contenders, Visitor&& visit) {
  for (const Contender& contender : contenders) {
    const std::size_t before = verification::case_count.held;
    visit(contender);
    if (is_of_another_set_than_the_best(contender.name)) verification::case_count.held = before;
  }
}

const EllipseContender& ellipse_named(const std::string& name) {
  static const std::vector<EllipseContender> all = ellipse_contenders();
  for (const EllipseContender& contender : all)
    if (contender.name == name) return contender;
  throw std::runtime_error("no contender " + name);
}

// What each family promises at d = 1, relative; 0: it promises nothing.
double promised(const MomentContender& contender) {
  if (contender.family == "tribocheck") return 4e-16;
  if (contender.family == "fixed rule") return contender.name.starts_with("gen") ? 1e-5 : 1e-2;
  if (contender.family == "published fit" || contender.family == "control") return 0;
  return contender.name.find("1e-13") != std::string::npos ? 1e-13 : 1e-7;
}

TEST(MomentContenders, AgreeAtOneToWhatTheyPromise) {
  on_each(moment_contenders(), [](const MomentContender& contender) {
    if (promised(contender) == 0 || contender.family == "SciPy") return;
    const double exact = gaussian_moment(contender.order, 1.0);
    EXPECT_TRUE(is_within(at(contender, 1), exact, promised(contender) * exact))
        << contender.family << ", " << contender.name;
  });
}

TEST(MomentContenders, OfOneIntegrandCountItAlikeInBothSpellings) {
  const std::vector<double> d{0.5, 1, 2};
  std::vector<double> values(d.size());
  for (const char* method : {"QAGIU 1e-08", "QAGS 1e-08", "CQUAD 1e-08"}) {
    const std::string name = method;
    const double by_pow = evaluations_of([&] { moment_named(name + " pow").counted(d, values); });
    const double by_root = evaluations_of([&] { moment_named(name + " sqrt").counted(d, values); });
    EXPECT_GT(by_pow, 15 * 3) << method;
    EXPECT_TRUE(is_within(by_root, by_pow, 0.1 * by_pow)) << method;
  }
}

// GSL says success and gives about 0: the peak at s = 0 lies between the abscissas.
TEST(MomentContenders, QagiuLosesThePeakFarBelowZero) {
  EXPECT_LT(at(moment_named("QAGIU 1e-10 pow"), -37.5), 1e-3);
  EXPECT_GT(at(moment_named("QAGIU 1e-10 pow"), -37), 1e3);
}

TEST(MomentContenders, BesselFormHasNoValueAtZero) {
  EXPECT_FALSE(std::isfinite(at(moment_named("Bessel K and I"), 0)));
  const double exact = gaussian_moment(Order::five_halves, -2.0);
  EXPECT_TRUE(is_within(at(moment_named("Bessel K and I"), -2), exact, 1e-13 * exact));
}

TEST(MomentContenders, OursHoldTheirContractOnTheCertifiedRows) {
  on_each(moment_contenders(), [](const MomentContender& contender) {
    if (contender.family != "tribocheck") return;
    const Errors errors = judge(contender, -40, 40);
    EXPECT_GT(errors.judged, 300U);
    EXPECT_EQ(errors.failures, 0U) << contender.name;
    EXPECT_LE(errors.max_ulp, 2) << contender.name;
  });
}

TEST(PublishedFits, AreOffByWhatIsKnown) {
  struct Known {
    const char* name;
    double percent[4];    // at d = 0, 1, 2, 3
    double half_unit[4];  // of the last digit printed
  };
  const Known all[] = {
      {"4.4086e-5 (4-d)^6.804", {-10.7, -3.5, -9.2, -74}, {0.05, 0.05, 0.05, 0.5}},
      {"0.6189 exp(-1.973 d)", {0.4, 6.8, 121, 874}, {0.05, 0.05, 0.5, 0.5}},
      {"F(0) (1 - erf d)", {0, 20, -47, -92}, {0.5, 0.5, 0.5, 0.5}},
      {"3.5e-5 (4-d)^6.9", {-0.2, -9.0, -27.5, -83}, {0.05, 0.05, 0.05, 0.5}},
      {"0.5025 exp(-1.844 d)", {0.5, 5.5, 118, 878}, {0.05, 0.05, 0.5, 0.5}},
  };
  for (const Known& known : all)
    for (int d = 0; d < 4; ++d) {
      const MomentContender& fit = moment_named(known.name);
      const double exact = gaussian_moment(fit.order, static_cast<double>(d));
      const double percent = 100 * (at(fit, d) / exact - 1);
      EXPECT_TRUE(is_within(percent, known.percent[d], known.half_unit[d]))
          << known.name << " at " << d;
    }
  EXPECT_TRUE(is_within(
      at(moment_named("4.4068e-5 (4-d)^6.804"), 1) / at(moment_named("4.4086e-5 (4-d)^6.804"), 1),
      4.4068 / 4.4086, 1e-15));
}

bool uses_a_fit(const RootContender& contender) {
  return contender.name.find("fit") != std::string::npos;
}

TEST(RootContenders, AgreeOnOneEasyCase) {
  StoredRootCases one;
  one.add(0.3, 1.146, 0.5);
  const double exact =
      LoadSharing<double>(AsperityModel::greenwood_tripp, 0.3, 1.146).solve(0.5).film_parameter;
  for (const auto& family : {wide_root_contenders(), one_surface_root_contenders()})
    on_each(family, [&](const RootContender& contender) {
      if (contender.family == "SciPy" || uses_a_fit(contender)) return;
      double film = 0;
      contender.prepare(one.view())(one.view(), {&film, 1});
      EXPECT_TRUE(is_within(film, exact, 1e-8 * exact))
          << contender.family << ", " << contender.name;
      if (contender.evaluations) {
        EXPECT_GE(contender.evaluations(one.view()), 1) << contender.name;
      }
    });
}

// Only a solver that leaves the brackets, or another moment, fails.
TEST(RootContenders, FailOnlyWhereTheyAreUnsafe) {
  for (const RootJob job : {RootJob::wide, RootJob::one_surface})
    on_each(job == RootJob::wide ? wide_root_contenders() : one_surface_root_contenders(),
            [job](const RootContender& contender) {
              if (contender.family == "SciPy") return;
              const Errors errors = judge(contender, job);
              EXPECT_GE(errors.judged, 40U);
              if (contender.family != "textbook") {
                EXPECT_EQ(errors.failures, 0U) << contender.name;
              } else if (job == RootJob::wide) {
                EXPECT_GT(errors.failures, 0U) << contender.name;
              }
            });
}

TEST(CurveContenders, DrawOneCurve) {
  on_each(curve_contenders(), [](const CurveContender& contender) {
    if (contender.name.find("fit") != std::string::npos) return;
    const Errors errors = judge(contender, 20);
    EXPECT_GE(errors.judged, 10U) << contender.name;
    EXPECT_EQ(errors.failures, 0U) << contender.name;
  });
}

// Of each fit the percent of the semi-axis a_x and of the peak pressure that it is off at R_y/R_x.
TEST(EllipseFits, AreOffByWhatIsKnown) {
  struct Known {
    const char* name;
    double ratio[4], axis[4], pressure[4];
  };
  constexpr Known all[] = {
      {"1.0339 a^0.636",
       {1.5, 10, 100, 1e4},
       {-0.53, 0.21, -2.01, -12.49},
       {-1.03, 0.20, -2.06, -12.51}},
      {"a^(2/pi)", {1.5, 10, 100, 1e4}, {0.14, 1.19, -1.03, -11.68}, {0.91, 1.46, -1.03, -11.68}},
      {"1.03 a^0.64",
       {1.5, 10, 100, 1e4},
       {-0.88, -0.06, -2.51, -13.45},
       {-0.12, 0.20, -2.51, -13.45}},
      {"logarithms", {1.5, 10, 100, 1e4}, {0.38, -0.02, -0.21, -0.10}, {-0.11, 0.21, -0.15, -0.09}},
  };
  for (const Known& known : all)
    for (int i = 0; i < 4; ++i) {
      const EllipseCase one{50, 107.9e9, 9.5e-3, 9.5e-3 * known.ratio[i]};
      const HertzEllipse<double> exact = hertz_ellipse(50.0, 107.9e9, 9.5e-3, one.radius_y);
      EllipseAnswer got{};
      ellipse_named(known.name).run({&one, 1}, {&got, 1});
      EXPECT_TRUE(is_within(100 * (got.semi_axis_x / exact.semi_axis_x - 1), known.axis[i], 0.005))
          << known.name << " at " << known.ratio[i];
      EXPECT_TRUE(
          is_within(100 * (got.peak_pressure / exact.peak_pressure - 1), known.pressure[i], 0.005))
          << known.name << " at " << known.ratio[i];
    }
}

TEST(EllipseContenders, FailOnlyWhereTheyAreFits) {
  for (const EllipseContender& contender : ellipse_contenders()) {
    const Errors errors = judge(contender);
    EXPECT_GE(errors.judged, 60U);
    EXPECT_EQ(errors.no_numbers, 0U) << contender.name;
    EXPECT_EQ(errors.failures > 0, contender.family == "published fit") << contender.name;
    if (contender.family == "tribocheck") {
      EXPECT_LE(errors.max_ulp, hertz_ellipse_contract.ulp);
    }
    if (contender.counted) {
      const EllipseCase one{50, 107.9e9, 9.5e-3, 19e-3};
      EllipseAnswer got{};
      EXPECT_GE(evaluations_of([&] {
                  contender.counted({&one, 1}, {&got, 1});
                }),
                5)
          << contender.name;
    }
  }
}

TEST(ErrorTally, MeasuresInUnitsInTheLastPlace) {
  EXPECT_EQ(ulps_off(1 + 0x1p-52, 1, 0), 1);
  EXPECT_EQ(ulps_off(1, 1, 0x1p-54), 0.25);
  EXPECT_EQ(ulps_off(0, 0x1p-1074, 0), 1);
  ErrorTally tally;
  tally.add(2 + 0x1p-50, 2, 0);
  tally.add(2, 2, 0);
  tally.add(std::numeric_limits<double>::quiet_NaN(), 2, 0);
  const Errors errors = tally.errors();
  EXPECT_EQ(errors.judged, 3U);
  EXPECT_EQ(errors.failures, 1U);
  EXPECT_EQ(errors.max_ulp, 2);
  EXPECT_EQ(errors.mean_ulp, 1);
}

TEST(ErrorTally, AllowsSoMuchTimesTheConditionAndSkipsWhatIsNotOffered) {
  const auto failures = [](double got, double condition) {
    ErrorTally tally;
    tally.add(got, 2, 0, condition);
    return tally.errors().failures;
  };
  EXPECT_EQ(failures(2 + 1.9e-6, 1), 0U);
  EXPECT_EQ(failures(2 + 2.1e-6, 1), 1U);
  EXPECT_EQ(failures(2 + 1.9e-5, 10), 0U);
  EXPECT_EQ(failures(2 + 2.1e-5, 10), 1U);
  EXPECT_EQ(failures(2 + 1.9e-6, 0.1), 0U);
  ErrorTally tally;
  tally.add(not_offered, 2, 0);
  EXPECT_EQ(tally.errors().judged, 0U);
}

}  // namespace
}  // namespace tribo::benchmarks
