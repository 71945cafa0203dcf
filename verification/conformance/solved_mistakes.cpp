// SPDX-License-Identifier: Apache-2.0
#include "conformance/solved_mistakes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "conformance/misread.hpp"
#include "tribo/viscosity_index.hpp"

namespace tribo::conformance {
namespace {

constexpr double of_answer = 1e-4;  // of an error: how closely a candidate must give the answer
constexpr std::size_t most_looked_at = 12;

struct WrongAnswer {
  const AnsweredCase* of;
  const AnsweredNumber* number;
};

// At most `most_looked_at` of the wrong answers, evenly spread.
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

constexpr int most_points = 40;  // of Gauss' rule

// The points of Gauss' rule between 0 and 1, and their weights.
const std::vector<std::pair<double, double>>& gauss_points(int count) {
  static const auto all = [] {
    std::array<std::vector<std::pair<double, double>>, most_points + 1> points;
    for (int n = 2; n <= most_points; ++n)
      for (const double zero : boost::math::legendre_p_zeros<double>(n)) {
        const double slope = boost::math::legendre_p_prime(n, zero);
        const double weight = 1 / ((1 - zero * zero) * slope * slope);
        points[static_cast<std::size_t>(n)].emplace_back((1 - zero) / 2, weight);
        if (zero > 0) points[static_cast<std::size_t>(n)].emplace_back((1 + zero) / 2, weight);
      }
    return points;
  }();
  return all[static_cast<std::size_t>(count)];
}

// A quadrature rule for the integral from d to an end: trapezoids, Simpson's rule, midpoints of
// intervals, or the rule of Gauss and Legendre.
enum class Rule { trapezoids, simpson, midpoints, gauss };
struct Quadrature {
  Rule rule;
  int count;  // of intervals, or of points of Gauss' rule
  double end;
  bool is_distance;  // `end` is a distance from d

  std::string name() const {
    const char* const rules[] = {"trapezoids", "simpson", "midpoints", "gauss"};
    return fmt::format("moment-by-{}-{}{}{:g}", rules[static_cast<std::size_t>(rule)], count,
                       is_distance ? "-d-plus-" : "-to-", end);
  }
  std::string text() const {
    const char* const rules[] = {"trapezoids", "intervals of Simpson's rule", "midpoints",
                                 "points of Gauss and Legendre"};
    return fmt::format("the integral by {} {} up to s = {}{:g}", count,
                       rules[static_cast<std::size_t>(rule)], is_distance ? "d + " : "", end);
  }
  // The sum for ∫ (s − d)ⁿ φ(s) ds; 0 where the end is not beyond d.
  double value(double order, double d) const {
    const double width = is_distance ? end : end - d;
    if (!(width > 0)) return 0;
    const auto at = [&](double part) {
      const double t = part * width, s = d + t;
      return (order == 0 ? 1 : std::pow(t, order)) * std::exp(-s * s / 2);
    };
    double sum = 0;
    if (rule == Rule::gauss) {
      for (const auto& [place, weight] : gauss_points(count)) sum += weight * at(place);
    } else if (rule == Rule::midpoints) {
      for (int i = 0; i < count; ++i) sum += at((i + 0.5) / count) / count;
    } else {
      const double share = rule == Rule::simpson ? 3 : 2;
      for (int i = 0; i <= count; ++i) {
        const double inner = rule == Rule::simpson && i % 2 == 1 ? 4 : 2;
        sum += (i == 0 || i == count ? 1 : inner) * at(static_cast<double>(i) / count);
      }
      sum /= share * count;
    }
    return sum * width / std::sqrt(2 * std::numbers::pi);
  }
};

// Quadratures that give at least `fewest` of the wrong answers.
std::vector<Mistake> coarse_integrals(std::vector<WrongAnswer> wrong) {
  constexpr int tried_all = 64;
  // The numbers and ends that people write: round ones, powers of 2, and one point more or less.
  constexpr int others[] = {79,  80,  99,  100, 101, 119, 120, 127,  128,  149,  150,  160, 199,
                            200, 201, 249, 250, 255, 256, 299, 300,  399,  400,  499,  500, 501,
                            511, 512, 599, 600, 799, 800, 999, 1000, 1023, 1024, 1999, 2000};
  constexpr double ends[] = {3, 4, 4.5, 5, 6, 7, 8, 9, 10, 12, 15, 20, 30, 50, 100};
  constexpr double times_off = 3;    // allowed factor between an error and its estimate
  constexpr std::size_t fewest = 3;  // answers that a quadrature must give
  if (wrong.size() < fewest) return {};
  const auto meets = [](const WrongAnswer& one, double value) {
    return std::abs(value - one.number->got) <=
           of_answer * std::abs(one.number->error()) + 1e-14 * std::abs(value);
  };
  const auto size = [](const WrongAnswer& one) {
    return std::abs(one.number->error() / one.number->expected->high);
  };
  std::sort(wrong.begin(), wrong.end(),
            [&](const WrongAnswer& a, const WrongAnswer& b) { return size(a) < size(b); });
  // Small errors come from the rule; great ones may come from the end of the range.
  std::map<std::string, Mistake> found;
  for (const std::size_t quarter : {1, 2}) {
    const WrongAnswer& first = wrong[quarter * wrong.size() / 4];
    const double order = first.of->question.arguments[0], d = first.of->question.arguments[1];
    const auto look = [&](const Quadrature& one) {
      const double value = one.value(order, d);
      if (!meets(first, value)) return value;
      const auto met = std::count_if(wrong.begin(), wrong.end(), [&](const WrongAnswer& other) {
        const auto& a = other.of->question.arguments;
        return meets(other, one.value(a[0], a[1]));
      });
      if (static_cast<std::size_t>(met) >= fewest)
        found.try_emplace(one.name(), with_formula("gaussian_moment", one.name(), one.text(),
                                                   [one](const catalogue::Arguments& a) {
                                                     return std::optional(one.value(a[0], a[1]));
                                                   }));
      return value;
    };
    for (const double end : ends)
      for (const bool is_distance : {true, false}) {
        if (!is_distance && end <= d) continue;
        const double whole = moment_to(order, d, is_distance ? d + end : end);
        if (meets(first, whole)) continue;  // an integral that only ends too early
        for (const Rule rule : {Rule::trapezoids, Rule::simpson, Rule::midpoints}) {
          const int step = rule == Rule::simpson ? 2 : 1;
          double half = 0, last = 0;
          for (int count = 2; count <= tried_all; count += step) {
            const double value = look({rule, count, end, is_distance});
            if (count == tried_all / 2) half = value - whole;
            last = value - whole;
          }
          // The error falls at least as 1/count, and at most as the power of 1/count found here.
          const double power = std::max(1.0, std::log2(std::abs(half / last)));
          const double wanted = std::abs(first.number->got - whole) / std::abs(last);
          for (const int count : others) {
            const double finer = static_cast<double>(count) / tried_all;
            if (count % step != 0 || wanted * finer > times_off ||
                wanted * std::pow(finer, power) < 1 / times_off)
              continue;
            look({rule, count, end, is_distance});
          }
        }
        for (int count = 2; count <= most_points; ++count)
          look({Rule::gauss, count, end, is_distance});
      }
  }
  std::vector<Mistake> all;
  for (auto& [name, mistake] : found) all.push_back(std::move(mistake));
  return all;
}

// `by_e`: with e in place of 10 above 100.
std::optional<double> index_by_row(const catalogue::Arguments& a, std::size_t row, bool by_e) {
  const detail::IndexOils<double> oils = detail::index_oils(a[1], row);
  double value = detail::index_among(a[0], a[1], oils);
  if (const double u = 1e6 * a[0]; by_e && u < oils.hundred)
    value = 100 + std::expm1(std::log(oils.hundred / u) / std::log(1e6 * a[1])) / 0.00715;
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::vector<Mistake> other_rows(const std::vector<WrongAnswer>& wrong, bool by_e) {
  const auto rows = static_cast<std::ptrdiff_t>(detail::index_rows.size());
  const auto row_of = [](const catalogue::Arguments& a) {
    return static_cast<std::ptrdiff_t>(detail::index_row(a[1]));
  };
  // The right row, and the row whose numbers give the wrong answer.
  std::set<std::pair<std::ptrdiff_t, std::ptrdiff_t>> taken;
  for (const auto& [of, number] : wrong)
    for (std::ptrdiff_t row = 0; row < rows; ++row)
      if (const auto value =
              index_by_row(of->question.arguments, static_cast<std::size_t>(row), by_e);
          value &&
          std::abs(*value - number->got) <= of_answer * std::abs(*value - number->expected->high))
        taken.insert({row_of(of->question.arguments), row});
  std::vector<Mistake> found;
  const auto add = [&](std::string name, std::string text, auto row_for) {
    if (by_e) {
      name += "-by-e";
      text += ", and e in place of 10 above 100";
    }
    found.push_back(with_formula("viscosity_index", std::move(name), std::move(text),
                                 [=](const catalogue::Arguments& a) -> std::optional<double> {
                                   const std::ptrdiff_t row =
                                       std::clamp<std::ptrdiff_t>(row_for(row_of(a)), 0, rows - 1);
                                   return index_by_row(a, static_cast<std::size_t>(row), by_e);
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

std::vector<Mistake> of_function(const std::vector<AnsweredCase>& cases) {
  const std::string_view function = cases.front().question.function->name;
  if (function != "gaussian_moment" && function != "viscosity_index") return {};
  const std::vector<WrongAnswer> wrong = some_wrong(cases);
  const bool is_moment = function == "gaussian_moment";
  std::vector<Mistake> all = is_moment ? cut_integrals(wrong) : other_rows(wrong, false);
  std::vector<Mistake> more = is_moment ? coarse_integrals(wrong) : other_rows(wrong, true);
  std::move(more.begin(), more.end(), std::back_inserter(all));
  return all;
}

// Answers below 0 that are set to 0, beside another mistake.
std::optional<Mistake> none_below_zero(const std::vector<AnsweredCase>& cases) {
  bool is_cut = false, is_other = false;
  for (const AnsweredCase& one : cases)
    for (const AnsweredNumber& number : one.numbers) {
      is_cut = is_cut || (number.is_wrong && number.got == 0 && number.expected->high < 0);
      is_other = is_other || (number.is_wrong && number.got != 0);
      if (number.place != 0 || number.got < 0) return std::nullopt;
    }
  if (!is_cut || !is_other) return std::nullopt;
  Mistake mistake{.function = std::string(cases.front().question.function->name),
                  .name = "none-below-0",
                  .text = "0 in place of each answer below 0",
                  .touches = {"sign of the answer"}};
  mistake.after = [](const Question&, Numbers& given) { given[0] = std::max(0.0, given[0]); };
  return mistake;
}

}  // namespace

// With s = d + t², so that half orders are smooth.
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

std::vector<Mistake> solved_mistakes(const std::vector<AnsweredCase>& cases) {
  if (cases.empty() || cases.front().question.function == nullptr) return {};
  std::vector<Mistake> found = of_function(cases);
  if (auto cut = none_below_zero(cases)) found.push_back(std::move(*cut));
  return found;
}

}  // namespace tribo::conformance
