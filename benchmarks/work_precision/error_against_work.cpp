// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <regex>
#include <utility>

#include "work_precision/measures.hpp"

namespace tribo::benchmarks {
namespace {

// A contender's name without its setting: a diagram joins contenders of one series by a line.
std::string series_of(const Measured& measured) {
  static const std::regex setting("( [0-9]e-[0-9]+| [0-9]+ (knots|bits)| [0-9]+$)");
  return measured.family + ": " + std::regex_replace(measured.name, setting, "");
}

// The contenders that can run here; SciPy may be missing.
std::vector<std::pair<Measured, Errors>> judged(std::vector<Measured> all) {
  std::vector<std::pair<Measured, Errors>> able;
  for (Measured& measured : all) {
    try {
      const Errors errors = measured.judge();
      able.emplace_back(std::move(measured), errors);
    } catch (const std::exception& error) {
      fmt::print(stderr, "left out: {}, {}: {}\n", measured.job, measured.name, error.what());
    }
  }
  return able;
}

nlohmann::ordered_json ulps(const Errors& errors, double value) {
  if (errors.judged == 0) return nullptr;
  return four_digits(value);
}

}  // namespace

Rows errors_against_work(std::vector<Measured> offered, const Effort& effort) {
  const auto all = judged(std::move(offered));
  std::vector<Timed> timed;
  for (const auto& [measured, errors] : all) timed.push_back({measured.run, measured.own_seconds});
  const std::vector<double> seconds = median_seconds(timed, effort.rounds, effort.least_seconds);
  Rows rows;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& [measured, errors] = all[i];
    nlohmann::ordered_json evaluations;
    if (measured.evaluations) evaluations = four_digits(measured.evaluations());
    rows.push_back({{"job", measured.job},
                    {"family", measured.family},
                    {"series", series_of(measured)},
                    {"name", measured.name},
                    {"ns", four_digits(1e9 * seconds[i] / static_cast<double>(measured.points))},
                    {"evaluations", evaluations},
                    {"max_ulp", ulps(errors, errors.max_ulp)},
                    {"p99_ulp", ulps(errors, errors.p99_ulp)},
                    {"mean_ulp", ulps(errors, errors.mean_ulp)},
                    {"failures", errors.failures},
                    {"no_numbers", errors.no_numbers},
                    {"judged", errors.judged}});
  }
  return rows;
}

Rows errors_by_range() {
  constexpr std::pair<double, double> ranges[] = {{-40, -37}, {-37, -5}, {-5, 0}, {0, 5},
                                                  {5, 12},    {12, 37},  {37, 40}};
  Rows rows;
  for (const MomentContender& contender : moment_contenders()) {
    if (contender.order != Order::five_halves || contender.own_seconds) continue;
    nlohmann::ordered_json row{{"family", contender.family}, {"name", contender.name}};
    for (const auto& [from, to] : ranges) {
      const Errors errors = judge(contender, from, to);
      row[fmt::format("{}..{}", from, to)] = ulps(errors, errors.max_ulp);
      row[fmt::format("failures {}..{}", from, to)] =
          ulps(errors, static_cast<double>(errors.failures));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace tribo::benchmarks
