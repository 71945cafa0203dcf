// SPDX-License-Identifier: Apache-2.0
// The contenders do as they claim: they are right where they should be, and wrong where that is
// known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cases/jobs.hpp"
#include "support/case_count.hpp"
#include "support/judge.hpp"
#include "tribo/batch.hpp"
#include "tribo/gaussian_moment.hpp"
#include "tribo/hertz_ellipse.hpp"
#include "tribo/mixed_contact.hpp"
#include "work_precision/timing.hpp"

namespace tribo::benchmarks {
namespace {

using verification::is_within;

double at(const MomentContender& contender, double d) {
  double value = std::numeric_limits<double>::quiet_NaN();
  contender.run({&d, 1}, {&value, 1});
  return value;
}

template <class Contender>
const Contender& named(const std::vector<Contender>& all, const std::string& name) {
  for (const Contender& contender : all)
    if (contender.name == name) return contender;
  throw std::runtime_error("no contender " + name);
}
const MomentContender& moment_named(const std::string& name) {
  static const std::vector<MomentContender> all = moment_contenders();
  return named(all, name);
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

// The relative error that each family promises at d = 1; 0: the family promises nothing.
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

// GSL reports success and gives about 0, because the peak at s = 0 lies between the abscissas.
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
    double half_unit[4];  // half the last printed digit
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

// Only solvers without brackets or with another moment fail.
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

// The error of each fit at R_y/R_x, in percent of the semi-axis a_x and of the peak pressure.
TEST(EllipseFits, AreOffByWhatIsKnown) {
  constexpr double ratios[] = {1.5, 10, 100, 1e4};
  struct Known {
    const char* name;
    double axis[4], pressure[4];
  };
  constexpr Known all[] = {
      {"1.0339 a^0.636", {-0.53, 0.21, -2.01, -12.49}, {-1.03, 0.20, -2.06, -12.51}},
      {"a^(2/pi)", {0.14, 1.19, -1.03, -11.68}, {0.91, 1.46, -1.03, -11.68}},
      {"1.03 a^0.64", {-0.88, -0.06, -2.51, -13.45}, {-0.12, 0.20, -2.51, -13.45}},
      {"logarithms", {0.38, -0.02, -0.21, -0.10}, {-0.11, 0.21, -0.15, -0.09}},
  };
  const std::vector<EllipseContender> contenders = ellipse_contenders();
  for (const Known& known : all)
    for (int i = 0; i < 4; ++i) {
      const EllipseCase one{50, 107.9e9, 9.5e-3, 9.5e-3 * ratios[i]};
      const HertzEllipse<double> exact = hertz_ellipse(50.0, 107.9e9, 9.5e-3, one.radius_y);
      EllipseAnswer got{};
      named(contenders, known.name).run({&one, 1}, {&got, 1});
      EXPECT_TRUE(is_within(100 * (got.semi_axis_x / exact.semi_axis_x - 1), known.axis[i], 0.005))
          << known.name << " at " << ratios[i];
      EXPECT_TRUE(
          is_within(100 * (got.peak_pressure / exact.peak_pressure - 1), known.pressure[i], 0.005))
          << known.name << " at " << ratios[i];
    }
}

TEST(EllipseContenders, FailOnlyWhereTheyAreFits) {
  for (const EllipseContender& contender : ellipse_contenders()) {
    const Errors errors = judge(contender);
    EXPECT_GE(errors.judged, 60U);
    EXPECT_EQ(errors.no_numbers, 0U) << contender.name;
    EXPECT_EQ(errors.failures > 0, contender.family == "published fit") << contender.name;
    if (contender.family == "tribocheck") {
      // The other way rounds the numbers of the ellipse first. It has the bound of hertz_contact().
      EXPECT_LE(errors.max_ulp, contender.name == "scalar" ? hertz_ellipse_contract.ulp : 6)
          << contender.name;
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

TEST(ErrorTally, ItsFiguresAreThoseOfAllAnswers) {
  for (const std::size_t count : {1U, 2U, 99U, 100U, 101U, 102U, 1000U}) {
    ErrorTally tally;
    for (std::size_t i = 0; i < count; ++i)  // 0, 1, 2 … ulp, in some order
      tally.add(1 + 0x1p-52 * static_cast<double>(i * 7919 % count), 1, 0);
    const Errors errors = tally.errors();
    const auto greatest = static_cast<double>(count - 1);
    EXPECT_EQ(errors.judged, count);
    EXPECT_EQ(errors.max_ulp, greatest);
    EXPECT_EQ(errors.p99_ulp, std::floor(0.99 * greatest));
    EXPECT_EQ(errors.mean_ulp, greatest / 2);
  }
}

// The cases lie in the ranges that the README gives, and reach to the ends of these ranges.
TEST(Cases, FillTheRangesOfTheirJobs) {
  const auto fill = [](std::vector<double> points, double from, double to, double unit) {
    std::sort(points.begin(), points.end());
    EXPECT_TRUE(is_within(points.front(), from + unit / 2, unit / 2)) << from;
    EXPECT_TRUE(is_within(points.back(), to - unit / 2, unit / 2)) << to;
  };
  const auto logarithms = [](std::vector<double> points) {
    for (double& point : points) point = std::log(point);
    return points;
  };
  fill(moment_arguments(2048), 0, 6, 0.003);
  for (const RootJob job : {RootJob::wide, RootJob::one_surface}) {
    const StoredRootCases cases = random_root_cases(job, 1024);
    fill(logarithms(cases.flooded), std::log(1e-4), std::log(100), 0.06);
    if (job == RootJob::one_surface) continue;
    fill(logarithms(cases.stiffness), std::log(1e-6), std::log(10), 0.06);
    fill(cases.offset, 0, 3, 0.01);
  }
  EXPECT_TRUE(is_within(curve_speeds(200).front(), 1e-4, 1e-18));
  EXPECT_TRUE(is_within(curve_speeds(200).back(), 3, 1e-14));
  std::vector<double> ratios;
  for (const EllipseCase& one : random_ellipses(1024))
    ratios.push_back(one.radius_y / one.radius_x);
  fill(logarithms(ratios), 0, std::log(1e4), 0.04);
}

// --- Counting: contenders that count their points and give known answers.

struct Counts {
  std::size_t points = 0, judged = 0, failures = 0, no_numbers = 0;
  double sum = 0;  // the sum tells which points these were

  // Answers 0, 3, 6 … are wrong by 1/1000, answers 1, 10 … are NaN, answers 2, 11 … not offered.
  double answer(double point, double right) {
    const std::size_t kind = points++ % 9;
    sum += point;
    judged += kind == 2 ? 0 : 1;
    failures += kind % 3 == 0 || kind == 1 ? 1 : 0;
    no_numbers += kind == 1 ? 1 : 0;
    Counted::one();
    return kind == 1       ? std::numeric_limits<double>::quiet_NaN()
           : kind == 2     ? not_offered
           : kind % 3 == 0 ? 1.001 * right
                           : right;
  }
};

// Runs the jobs one after another. All their contenders add to `counts`.
void expect_counted(const std::vector<Measured>& jobs, Counts& counts,
                    const std::vector<std::pair<std::size_t, double>>& points_and_sums) {
  ASSERT_EQ(jobs.size(), points_and_sums.size());
  for (std::size_t k = 0; k < jobs.size(); ++k) {
    const Measured& one = jobs[k];
    counts = {};
    one.run();
    EXPECT_EQ(one.points, points_and_sums[k].first) << one.job;
    EXPECT_EQ(counts.points, one.points) << one.job << ' ' << one.name;
    EXPECT_TRUE(is_within(counts.sum, points_and_sums[k].second, 1e-12 * counts.sum)) << one.job;
    EXPECT_EQ(one.evaluations ? one.evaluations() : 1, 1) << one.job;
    counts = {};
    const Errors errors = one.judge();
    EXPECT_GT(errors.judged, 20U);
    EXPECT_EQ(errors.judged, counts.judged) << one.job;
    EXPECT_EQ(errors.failures, counts.failures) << one.job;
    EXPECT_EQ(errors.no_numbers, counts.no_numbers) << one.job;
  }
}
std::pair<std::size_t, double> of(const std::vector<double>& points) {
  return {points.size(), std::accumulate(points.begin(), points.end(), 0.0)};
}

// Each contender solves the points that its job counts; a slow one solves only the first of them.
// Wrong answers, NaN and cases that are not offered are counted as such.
TEST(Jobs, CountThePointsAndTheAnswersOfEachContender) {
  Counts counts;
  const MomentBatch moments = [&](std::span<const double> d, std::span<double> answers) {
    for (std::size_t i = 0; i < d.size(); ++i)
      answers[i] = counts.answer(d[i], gaussian_moment(Order::two, d[i]));
  };
  const auto of_moments = of(moment_arguments(2048));
  expect_counted(
      jobs_of(std::vector<MomentContender>{{"a", "", Order::two, moments, {}, {}, {}},
                                           {"b", "", Order::two, moments, moments, {}, {}}}),
      counts, {of_moments, of_moments});

  for (const RootJob job : {RootJob::wide, RootJob::one_surface}) {
    const RootRun run = [&](const RootCases& cases, std::span<double> films) {
      for (std::size_t i = 0; i < cases.size(); ++i)
        films[i] = counts.answer(cases[i].flooded,
                                 film_parameter(AsperityModel::greenwood_tripp, cases[i].stiffness,
                                                cases[i].offset, cases[i].flooded));
    };
    const auto prepare = [&](const RootCases&) { return run; };
    const auto count = [](const RootCases& cases) { return static_cast<double>(cases.size()); };
    std::vector<double> flooded = random_root_cases(job, 1024).flooded;
    const auto all = of(flooded);
    flooded.resize(256);
    expect_counted(
        jobs_of(
            {{"a", "", prepare, count}, {"b", "", prepare, count, true}, {"c", "", prepare, {}}},
            job),
        counts, {all, of(flooded), all});
  }

  const auto curve = [&](const Scene& scene, std::span<const double> speeds,
                         OperatingPoints& points) {
    solve(MixedContact<double>(scene), speeds, curve_outputs(), points);
    // A film that has collapsed is 0, and is not judged.
    for (std::size_t i = 0; i < speeds.size(); ++i)
      if (points.film[i] > 0)
        points.film[i] = counts.answer(speeds[i], points.film[i]);
      else
        ++counts.points, counts.sum += speeds[i];
  };
  std::vector<std::pair<std::size_t, double>> of_curves;
  for (const std::size_t size : {200U, 200U, 200U, 1000000U, 100000U, 1000U})
    of_curves.push_back(of(curve_speeds(size)));
  expect_counted(
      jobs_of(std::vector<CurveContender>{
          {"tribocheck", "", curve, false}, {"a", "", curve, false}, {"b", "", curve, true}}),
      counts, of_curves);

  const EllipseBatch ellipses = [&](std::span<const EllipseCase> cases,
                                    std::span<EllipseAnswer> answers) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const EllipseCase& one = cases[i];
      const auto right = hertz_ellipse(one.load, one.effective_modulus, one.radius_x, one.radius_y);
      answers[i].semi_axis_x = counts.answer(one.radius_y, right.semi_axis_x);
      answers[i].peak_pressure = right.peak_pressure;
      ++counts.judged;
    }
  };
  std::vector<double> radii;
  for (const EllipseCase& one : random_ellipses(1024)) radii.push_back(one.radius_y);
  expect_counted(jobs_of(std::vector<EllipseContender>{{"a", "", ellipses, {}},
                                                       {"b", "", ellipses, ellipses}}),
                 counts, {of(radii), of(radii)});
}

TEST(MedianSeconds, AreTheMedianOfEachContendersOwnRounds) {
  for (const int rounds : {1, 3, 5, 9}) {
    std::vector<Timed> timed;
    for (int k = 0; k < 3; ++k)  // seconds 10 + k, 20 + k …, in another order
      timed.push_back(
          {[] {},
           [k, rounds, i = 0]() mutable { return 10.0 * (1 + (i++ * 7 + k) % rounds) + k; }});
    const double middle = 10.0 * (rounds + 1) / 2;
    EXPECT_EQ(median_seconds(timed, rounds, 0),
              (std::vector<double>{middle, middle + 1, middle + 2}));
  }
}

}  // namespace
}  // namespace tribo::benchmarks
