// SPDX-License-Identifier: Apache-2.0
// Tables of error against work, made of ways whose errors and times are known.
#include "work_precision/measures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <ctime>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "ehl/line_contact.hpp"
#include "support/judge.hpp"

namespace tribo::benchmarks {
namespace {

using Row = nlohmann::ordered_json;

constexpr Effort short_effort{1, 1e-9};

// A way that gives the time of its last run itself.
Measured made_up(const std::string& name, std::size_t points, double seconds,
                 const Errors& errors) {
  return {.job = "job of " + name,
          .family = "family of " + name,
          .name = name,
          .points = points,
          .run = [] {},
          .judge = [errors] { return errors; },
          .evaluations = {},
          .own_seconds = [seconds] { return seconds; }};
}

TEST(ErrorsAgainstWork, EachRowSaysWhatItsWayDoes) {
  Measured first = made_up("first", 10, 2e-6, {7, 3, 2, 4.56789, 3.5, 1.25});
  first.evaluations = [] { return 12.34567; };
  Measured missing = made_up("missing", 1, 1, {});
  missing.judge = []() -> Errors { throw std::runtime_error("it is not installed"); };
  const Rows rows = errors_against_work(
      {first, missing, made_up("second", 4, 1e-3, {0, 0, 0, 0, 0, 0})}, short_effort);
  const Row expected{{{"job", "job of first"},
                      {"family", "family of first"},
                      {"series", "family of first: first"},
                      {"name", "first"},
                      {"ns", 200.},
                      {"evaluations", 12.35},
                      {"max_ulp", 4.568},
                      {"p99_ulp", 3.5},
                      {"mean_ulp", 1.25},
                      {"failures", 3},
                      {"no_numbers", 2},
                      {"judged", 7}},
                     {{"job", "job of second"},
                      {"family", "family of second"},
                      {"series", "family of second: second"},
                      {"name", "second"},
                      {"ns", 250000.},
                      {"evaluations", nullptr},
                      {"max_ulp", nullptr},
                      {"p99_ulp", nullptr},
                      {"mean_ulp", nullptr},
                      {"failures", 0},
                      {"no_numbers", 0},
                      {"judged", 0}}};
  EXPECT_EQ(Row(rows).dump(1), expected.dump(1));
}

TEST(ErrorsAgainstWork, AWayWithoutItsSettingIsASeries) {
  for (const auto& [name, series] : {std::pair{"Gauss 1e-06", "Gauss"},
                                     {"spline 64 knots", "spline"},
                                     {"bisection 40 bits", "bisection"},
                                     {"Simpson 200", "Simpson"},
                                     {"200 intervals", "200 intervals"},
                                     {"order 2 fit", "order 2 fit"}}) {
    const Rows rows = errors_against_work({made_up(name, 1, 1, {})}, short_effort);
    EXPECT_EQ(rows.at(0).at("series"), "family of " + std::string(name) + ": " + series);
  }
}

TEST(ErrorsByRange, AreOfTheRangeAndNoneWhereNothingIsClaimed) {
  const Rows rows = errors_by_range();
  EXPECT_GT(rows.size(), 10U);
  bool has_ours = false;
  for (const MomentContender& contender : moment_contenders()) {
    if (contender.order != Order::five_halves || contender.own_seconds) continue;
    for (const Row& row : rows) {
      if (row.at("family") != contender.family || row.at("name") != contender.name) continue;
      has_ours = true;
      for (const auto& [from, to] :
           {std::pair{-40, -37}, {-37, -5}, {-5, 0}, {0, 5}, {5, 12}, {12, 37}, {37, 40}}) {
        const std::string range = std::to_string(from) + ".." + std::to_string(to);
        const Errors errors = judge(contender, from, to);
        const bool is_claimed = errors.judged > 0;
        EXPECT_EQ(row.at(range).dump(),
                  (is_claimed ? Row(four_digits(errors.max_ulp)) : Row(nullptr)).dump())
            << contender.name;
        EXPECT_EQ(row.at("failures " + range).dump(),
                  (is_claimed ? Row(static_cast<double>(errors.failures)) : Row(nullptr)).dump())
            << contender.name;
      }
    }
  }
  EXPECT_TRUE(has_ours);
}

// The measured contenders and their evaluations are those of the baseline. So are the errors,
// unless more cases have been certified since. SciPy may be missing. The last digits depend on the
// system's functions, and so do errors near rounding. If the last bits differ (without FMA), a
// search may end a step sooner or later. If it does so in one case of fifty, the mean changes by
// 1/50 of the greatest error.
TEST(Contenders, AreThoseOfTheBaselineAndAsFarOff) {
  std::ifstream file(TRIBOCHECK_SOURCE_DIR "/reference/baselines/work_precision.json");
  const Row baseline = Row::parse(file);
  std::map<std::tuple<std::string, std::string, std::string>, Row> kept;
  for (const Row& row : baseline.at("error_against_work"))
    if (row.at("family") != "SciPy" && row.at("family") != "tribocheck")
      kept[{row.at("job"), row.at("family"), row.at("name")}] = row;
  std::size_t compared = 0;
  for (const Measured& one : all_jobs(Settings::swept)) {
    if (one.family == "SciPy" || one.family == "tribocheck") continue;
    const auto found = kept.extract({one.job, one.family, one.name});
    ASSERT_FALSE(found.empty()) << one.job << ", " << one.name << " is not in the baseline";
    const Row& row = found.mapped();
    const auto is_near = [&](const char* what, double got, double more = 0) {
      const auto expected = row.at(what).get<double>();
      EXPECT_TRUE(verification::is_within(got, expected, 0.01 * expected + more))
          << what << " of " << one.job << ", " << one.name;
    };
    EXPECT_EQ(one.evaluations != nullptr, row.at("evaluations").is_number()) << one.name;
    if (one.evaluations) is_near("evaluations", one.evaluations());
    if (one.job == "points_1e6") continue;  // judged as curve_200 is
    const Errors errors = one.judge();
    const auto judged = row.at("judged").get<std::size_t>();
    EXPECT_GE(errors.judged, judged) << one.job << ", " << one.name;
    if (errors.judged != judged) continue;
    ++compared;
    is_near("failures", static_cast<double>(errors.failures));
    is_near("no_numbers", static_cast<double>(errors.no_numbers));
    if (judged > 0 && errors.mean_ulp > 1e5) {
      is_near("mean_ulp", errors.mean_ulp, 0.02 * row.at("max_ulp").get<double>());
    }
  }
  EXPECT_TRUE(kept.empty());
  EXPECT_GT(compared, 150U);
}

// All ways are judged by the films of these contacts.
TEST(LineFilmErrors, AreJudgedAtFourContactsFromSoftToHighPressure) {
  const std::vector<std::pair<double, double>> expected{{1, 0}, {10, 5}, {100, 10}, {200, 20}};
  const std::vector<JudgedFilm<ehl::LineContact>> contacts = judged_contacts(1e-4);
  ASSERT_EQ(contacts.size(), expected.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto& [contact, exact] = contacts[i];
    EXPECT_EQ(contact.load_number, expected[i].first);
    EXPECT_EQ(contact.material_number, expected[i].second);
    const FilmAnswer again =
        film_numbers(contact, ehl::solve_line_film(contact, {.tolerance = 1e-3}));
    EXPECT_TRUE(verification::is_within(exact.central, again.central, 2e-3 * again.central));
    EXPECT_TRUE(verification::is_within(exact.minimum, again.minimum, 2e-3 * again.minimum));
  }
}

TEST(LineFilmErrors, AreThoseOfTheNumbersThatAWayGives) {
  const std::vector<JudgedFilm<ehl::LineContact>> contacts{
      {ehl::barus_contact(10, 0), {.central = 2, .minimum = 1, .at_greatest_pressure = 3}},
      {ehl::barus_contact(10, 5), {.central = 4, .minimum = 2, .at_greatest_pressure = 5}}};
  const auto factor_of = [&](const ehl::LineContact& contact) {
    return contact.material_number == 0 ? 1. : 2.;
  };
  const std::vector<LineFilmWay> ways{
      {"solver", "s", "two numbers", nullptr,
       [&](const ehl::LineContact& contact) {
         const double f = factor_of(contact);
         return FilmAnswer{2.04 * f, 0.95 * f, 300, f > 1 ? 5 : 2};
       }},
      {"solver", "s", "no minimum", nullptr,
       [&](const ehl::LineContact& contact) {
         return FilmAnswer{2 * factor_of(contact), std::nan(""), 300, 1};
       }},
      {"formula", "f", "at the greatest pressure", &FilmAnswer::at_greatest_pressure,
       [](const ehl::LineContact&) {
         return FilmAnswer{1, 1, 5.5, 9};
       }}};
  const Rows rows = film_errors("line_film", ways, contacts, short_effort);
  ASSERT_EQ(rows.size(), 3U);
  Rows without_time = rows;
  for (Row& row : without_time) {
    EXPECT_GE(row.at("ns").get<double>(), 0);
    row.erase("ns");
  }
  const auto row = [](const LineFilmWay& way, Row steps, Row greatest, Row mean, int nothing,
                      int judged) {
    return Row{{"job", "line_film"},    {"family", way.family},      {"series", way.series},
               {"name", way.name},      {"steps", std::move(steps)}, {"max_relative", greatest},
               {"mean_relative", mean}, {"no_numbers", nothing},     {"judged", judged}};
  };
  const Row expected{row(ways[0], 3.5, 0.05, 0.035, 0, 4), row(ways[1], 1., 0., 0., 2, 4),
                     row(ways[2], nullptr, 0.1, 0.1, 0, 1)};
  EXPECT_EQ(Row(without_time).dump(1), expected.dump(1));
}

TEST(CpuSeconds, AreThatOfTheOtherClockOfTheProcess) {
  const std::clock_t begin = std::clock();
  const double start = cpu_seconds();
  while (std::clock() - begin < CLOCKS_PER_SEC / 4) {
  }
  const double passed = cpu_seconds() - start;
  const double told = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  EXPECT_TRUE(verification::is_within(passed, told, 0.02 * told));
}

TEST(MedianSeconds, AreOfACallHoweverManyAreTimed) {
  std::size_t calls = 0;
  const double start = cpu_seconds();
  const double median = median_seconds({{[&] { ++calls; }, {}}}, 1, 0.01).front();
  const double passed = cpu_seconds() - start;
  EXPECT_GE(passed, 0.01);
  EXPECT_LE(median * static_cast<double>(calls), passed);
  EXPECT_GE(median * static_cast<double>(calls), 0.01);
}

TEST(Table, OfRowsHasNothingWhereThereIsNothing) {
  const Rows rows{{{"series", "a"}, {"x", 1}, {"y", nullptr}},
                  {{"series", "b"}, {"x", 2.5}, {"y", "text"}},
                  {{"series", "a"}, {"x", 3}, {"y", 4}}};
  EXPECT_EQ(tsv(rows), "series\tx\ty\na\t1\t\nb\t2.5\ttext\na\t3\t4\n");
  EXPECT_EQ(tsv_blocks(rows, "series"), "\"a\"\na\t1\tNaN\na\t3\t4\n\n\n\"b\"\nb\t2.5\ttext\n");
  EXPECT_EQ(tsv({}), "");
  EXPECT_EQ(four_digits(123456), 123500);
}

TEST(LineFilmExponents, OfPowersAreThesePowers) {
  Rows growth;
  for (int cells = 128; cells <= 4096; cells *= 2)
    growth.push_back({{"solver", "one"},
                      {"cells", cells},
                      {"kernel_ns", 3. * cells},
                      {"step_ns", 1e-3 * std::pow(cells, 2.5)},
                      {"bytes", 8. * cells * cells}});
  const Rows rows = film_exponents(growth);
  ASSERT_EQ(rows.size(), 3U);
  for (const auto& [at, expected] : {std::pair{0U, 1.}, {1U, 2.5}, {2U, 2.}}) {
    EXPECT_NEAR(rows[at].at("exponent").get<double>(), expected, 1e-9);
    EXPECT_LT(rows[at].at("uncertainty").get<double>(), 1e-9);
    EXPECT_EQ(rows[at].at("from_cells"), 512);
    EXPECT_EQ(rows[at].at("to_cells"), 4096);
  }
}

}  // namespace
}  // namespace tribo::benchmarks
