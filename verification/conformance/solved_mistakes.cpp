// SPDX-License-Identifier: Apache-2.0
#include "conformance/solved_mistakes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "conformance/misread.hpp"
#include "tribo/viscosity_index.hpp"

namespace tribo::conformance {
namespace {

constexpr double of_answer = 1e-4;  // how closely a candidate has to meet answers
constexpr std::size_t most_looked_at = 12;

struct WrongAnswer {
  const AnsweredCase* of;
  const AnsweredNumber* number;
};

// Some of the wrong answers, far from each other.
std::vector<WrongAnswer> some_wrong(const std::vector<AnsweredCase>& cases) {
  std::vector<WrongAnswer> all, some;
  for (const AnsweredCase& one : cases)
    for (const AnsweredNumber& number : one.numbers)
      if (number.is_wrong) all.push_back({&one, &number});
  const std::size_t count = std::min(all.size(), most_looked_at);
  for (std::size_t i = 0; i < count; ++i) some.push_back(all[i * all.size() / count]);
  return some;
}

using Formula = std::function<std::optional<double>(const catalogue::Arguments&)>;
Mistake with_formula(const char* function, std::string name, std::string text, Formula formula) {
  return {
      .function = function,
      .name = std::move(name),
      .text = std::move(text),
      .touches = {"formula"},
      .instead = [formula = std::move(formula)](const Question& asked) -> std::optional<Numbers> {
        const std::optional<double> value = formula(asked.arguments);
        return value ? std::optional(Numbers{*value}) : std::nullopt;
      }};
}

// ∫ (s − d)ⁿ φ(s) ds from d to the end, with s = d + t², so that half orders are smooth.
double moment_to(double order, double d, double end) {
  const double from = std::sqrt(std::max(0.0, std::min(end, 0.0) - 9 - d));
  const double to =
      std::sqrt(std::min(std::max(0.0, end - d), std::max(0.0, -d) + 60 / (std::max(d, 0.0) + 4)));
  constexpr int strips = 6;
  double sum = 0;
  for (int i = 0; i < strips && to > from; ++i)
    sum += boost::math::quadrature::gauss<double, 20>::integrate(
        [&](double t) {
          const double s = d + t * t;
          return 2 * std::pow(t, 2 * order + 1) * std::exp(-s * s / 2);
        },
        from + (to - from) * i / strips, from + (to - from) * (i + 1) / strips);
  return sum / std::sqrt(2 * std::numbers::pi);
}

std::vector<Mistake> cut_integrals(const std::vector<WrongAnswer>& wrong) {
  std::set<std::string> names;
  std::vector<Mistake> found;
  const auto add = [&](double end, bool is_distance) {
    const std::string text = fmt::format("{}{:.3g}", is_distance ? "d + " : "", end);
    const std::string name =
        fmt::format("moment-cut-at-{}{:.3g}", is_distance ? "d-plus-" : "", end);
    const double rounded = of_digits(end, 3);
    constexpr double farthest = 40, round_enough = 1e-3;
    if (!(rounded > 0 && rounded < farthest && std::abs(end / rounded - 1) < round_enough) ||
        !names.insert(name).second)
      return;
    found.push_back(with_formula("gaussian_moment", name, "the integral cut off at s = " + text,
                                 [rounded, is_distance](const catalogue::Arguments& a) {
                                   return std::optional(
                                       moment_to(a[0], a[1], rounded + (is_distance ? a[1] : 0)));
                                 }));
  };
  for (const auto& [of, number] : wrong) {
    const double order = of->question.arguments[0], d = of->question.arguments[1];
    if (!(number->got > 0 && number->got < number->expected->high)) continue;
    double low = d, high = std::max(d, 0.0) + 20;
    for (int i = 0; i < 50; ++i) {
      const double middle = (low + high) / 2;
      (moment_to(order, d, middle) < number->got ? low : high) = middle;
    }
    add(high, false);
    add(high - d, true);
  }
  return found;
}

std::optional<double> index_by_row(const catalogue::Arguments& a, std::size_t row) {
  const double value = detail::index_among(a[0], a[1], detail::index_oils(a[1], row));
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::vector<Mistake> other_rows(const std::vector<WrongAnswer>& wrong) {
  const auto rows = static_cast<std::ptrdiff_t>(detail::index_rows.size());
  const auto row_of = [](const catalogue::Arguments& a) {
    return static_cast<std::ptrdiff_t>(detail::index_row(a[1]));
  };
  // The rows whose numbers the wrong answers are.
  std::set<std::pair<std::ptrdiff_t, std::ptrdiff_t>> taken;
  for (const auto& [of, number] : wrong)
    for (std::ptrdiff_t row = 0; row < rows; ++row)
      if (const auto value = index_by_row(of->question.arguments, static_cast<std::size_t>(row));
          value &&
          std::abs(*value - number->got) <= of_answer * std::abs(*value - number->expected->high))
        taken.insert({row_of(of->question.arguments), row});
  std::vector<Mistake> found;
  const auto add = [&](std::string name, std::string text, auto row_for) {
    found.push_back(with_formula("viscosity_index", std::move(name), std::move(text),
                                 [=](const catalogue::Arguments& a) -> std::optional<double> {
                                   const std::ptrdiff_t row =
                                       std::clamp<std::ptrdiff_t>(row_for(row_of(a)), 0, rows - 1);
                                   return index_by_row(a, static_cast<std::size_t>(row));
                                 }));
  };
  for (const std::ptrdiff_t by : {-1, 1})
    if (std::any_of(taken.begin(), taken.end(),
                    [&](const auto& one) { return one.second == one.first + by; }))
      add(by < 0 ? "index-of-row-before" : "index-of-row-after",
          fmt::format("the row {} the right one in the table of L and H",
                      by < 0 ? "before" : "after"),
          [by](std::ptrdiff_t row) { return row + by; });
  const auto from = [](std::ptrdiff_t row) {
    return 1e6 * detail::index_rows[static_cast<std::size_t>(row)].from;
  };
  for (const auto& [right, given] : taken) {
    add(fmt::format("index-of-row-{:g}-for-{:g}", from(given), from(right)),
        fmt::format(
            "the numbers of the row from {:g} mm²/s in place of those of the row from {:g} mm²/s",
            from(given), from(right)),
        [right = right, given = given](std::ptrdiff_t row) { return row == right ? given : row; });
    add(fmt::format("index-of-row-{:g}", from(given)),
        fmt::format("the numbers of the row from {:g} mm²/s for every Y", from(given)),
        [given = given](std::ptrdiff_t) { return given; });
  }
  return found;
}

}  // namespace

std::vector<Mistake> solved_mistakes(const std::vector<AnsweredCase>& cases) {
  if (cases.empty() || cases.front().question.function == nullptr) return {};
  const std::string_view function = cases.front().question.function->name;
  if (function == "gaussian_moment") return cut_integrals(some_wrong(cases));
  if (function == "viscosity_index") return other_rows(some_wrong(cases));
  return {};
}

}  // namespace tribo::conformance
