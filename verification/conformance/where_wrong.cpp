// SPDX-License-Identifier: Apache-2.0
#include "conformance/where_wrong.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "conformance/power_law.hpp"

namespace tribo::conformance {
namespace {

// Part of the cases, and of the right or the wrong ones, that may lie on the wrong side of a
// border.
constexpr double stray = 0.02, stray_of_few = 0.1;
constexpr std::size_t fewest_cases = 8, fewest_right = 3;

struct Point {
  double input;
  const AnsweredNumber* number;
};

std::vector<Point> along(const std::vector<AnsweredCase>& cases, const std::string& branch,
                         std::size_t place, std::size_t input) {
  std::vector<Point> points;
  for (const AnsweredCase& one : cases) {
    if (!branch.empty() && one.branch != branch) continue;
    for (const AnsweredNumber& number : one.numbers)
      if (number.place == place) points.push_back({one.question.arguments[input], &number});
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const Point& a, const Point& b) { return a.input < b.input; });
  return points;
}

// Inputs that vary.
std::vector<std::size_t> number_inputs(const std::vector<AnsweredCase>& cases) {
  std::vector<std::size_t> inputs;
  if (cases.empty() || cases.front().question.function == nullptr) return inputs;
  const auto& parameters = cases.front().question.function->parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (parameters[i].words.empty() && parameters[i].range != catalogue::Range::half_order)
      inputs.push_back(i);
  return inputs;
}

// The stretch [first, last) in which answers are right (or wrong), and how many cases it misplaces:
// the best of all stretches, by the greatest sum of a run.
struct Stretch {
  std::size_t first = 0, last = 0;
  std::size_t misplaced = 0;
};

Stretch best_stretch(const std::vector<Point>& points, bool of_wrong) {
  // +1 for a case that belongs inside, −1 for one that does not.
  Stretch best;
  long sum = 0, greatest = 0;
  std::size_t first = 0, belonging = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool belongs = points[i].number->is_wrong == of_wrong;
    belonging += belongs ? 1 : 0;
    sum += belongs ? 1 : -1;
    if (sum > greatest) {
      greatest = sum;
      best.first = first;
      best.last = i + 1;
    }
    if (sum < 0) {
      sum = 0;
      first = i + 1;
    }
  }
  best.misplaced = belonging - static_cast<std::size_t>(greatest);
  return best;
}

struct Where {
  std::string text;
  std::size_t misplaced;
};

std::optional<Where> where_along(const std::vector<Point>& points, const std::string& symbol) {
  const Stretch right = best_stretch(points, false), wrong = best_stretch(points, true);
  const bool inside_is_wrong = wrong.misplaced < right.misplaced;
  const Stretch& inside = inside_is_wrong ? wrong : right;
  const auto wrong_count = static_cast<std::size_t>(std::count_if(
      points.begin(), points.end(), [](const Point& one) { return one.number->is_wrong; }));
  const std::size_t fewer = std::min(wrong_count, points.size() - wrong_count);
  if (static_cast<double>(inside.misplaced) > std::min(stray * static_cast<double>(points.size()),
                                                       stray_of_few * static_cast<double>(fewer)))
    return std::nullopt;
  const bool from_start = inside.first == 0, to_end = inside.last == points.size();
  if (from_start && to_end) return std::nullopt;
  const double low = points[inside.first].input, high = points[inside.last - 1].input;
  const char* const word = inside_is_wrong ? "wrong" : "right";
  const char* const other = inside_is_wrong ? "right" : "wrong";
  if (!from_start && points[inside.first - 1].input == low) return std::nullopt;
  if (!to_end && points[inside.last].input == high) return std::nullopt;
  std::string text;
  if (from_start)
    text = fmt::format("{} up to {} = {:.4g}, {} from {:.4g} on", word, symbol, high, other,
                       points[inside.last].input);
  else if (to_end)
    text = fmt::format("{} up to {} = {:.4g}, {} from {:.4g} on", other, symbol,
                       points[inside.first - 1].input, word, low);
  else
    text = fmt::format("{} from {} = {:.4g} to {:.4g}, {} below and beyond", word, symbol, low,
                       high, other);
  return Where{std::move(text), inside.misplaced};
}

}  // namespace

std::string where_wrong(const std::vector<AnsweredCase>& cases, const std::string& branch,
                        std::size_t place) {
  std::optional<Where> best;
  for (const std::size_t input : number_inputs(cases)) {
    const std::vector<Point> points = along(cases, branch, place, input);
    const auto right = static_cast<std::size_t>(std::count_if(
        points.begin(), points.end(), [](const Point& one) { return !one.number->is_wrong; }));
    if (points.size() < fewest_cases || right < fewest_right) return {};
    auto found = where_along(points, symbol_of(cases.front().question.function->parameters[input]));
    if (found && (!best || found->misplaced < best->misplaced)) best = std::move(found);
  }
  return best ? best->text : std::string();
}

std::string manner_of_errors(const std::vector<AnsweredCase>& cases, const std::string& branch,
                             std::size_t place) {
  const std::vector<std::size_t> inputs = number_inputs(cases);
  if (inputs.size() != 1) return {};  // along one of several inputs errors look like noise
  for (const std::size_t input : inputs) {
    std::vector<Point> points = along(cases, branch, place, input);
    std::erase_if(points, [](const Point& one) {
      return !one.number->is_wrong || one.number->expected->high == 0;
    });
    if (points.size() < fewest_cases) return {};
    const auto relative = [](const Point& one) {
      return one.number->error() / std::abs(one.number->expected->high);
    };
    std::size_t flips = 0, falls = 0, zeros = 0;
    std::vector<double> sizes;
    for (std::size_t i = 0; i < points.size(); ++i) {
      sizes.push_back(std::abs(relative(points[i])));
      zeros += points[i].number->got == 0 ? 1 : 0;
      if (i == 0) continue;
      flips += (relative(points[i]) < 0) != (relative(points[i - 1]) < 0) ? 1 : 0;
      falls += sizes[i] < sizes[i - 1] ? 1 : 0;
    }
    const auto part = [&](std::size_t count) {
      return static_cast<double>(count) / static_cast<double>(points.size());
    };
    const auto middle_of = [&](std::size_t first, std::size_t last) {
      std::vector<double> some(sizes.begin() + static_cast<std::ptrdiff_t>(first),
                               sizes.begin() + static_cast<std::ptrdiff_t>(last));
      const auto middle = some.begin() + static_cast<std::ptrdiff_t>(some.size() / 2);
      std::nth_element(some.begin(), middle, some.end());
      return *middle;
    };
    if (part(zeros) > 0.9) return "the answers are 0 there, as of an integral that ends too early";
    const std::size_t third = sizes.size() / 3;
    const double before = middle_of(0, third),
                 after = middle_of(sizes.size() - third, sizes.size());
    if (flips >= 3 && part(flips) > 0.05 && (after > 100 * before || before > 100 * after))
      return "the errors have no order and grow: digits cancel there";
    const double greatest = *std::max_element(sizes.begin(), sizes.end());
    const double least = *std::min_element(sizes.begin(), sizes.end());
    if (part(flips) < 0.05 && greatest <= 1 && greatest > 3 * least &&
        (part(falls) < 0.2 || part(falls) > 0.8))
      return "the errors are smooth and grow, as of a quadrature or a series with too few terms";
  }
  return {};
}

bool is_single_precision(const std::vector<AnsweredCase>& cases) {
  std::size_t count = 0;
  for (const AnsweredCase& one : cases)
    for (const AnsweredNumber& number : one.numbers) {
      const double nine_digits = std::strtod(fmt::format("{:.9g}", number.got).c_str(), nullptr);
      if (nine_digits != number.got &&
          static_cast<double>(static_cast<float>(number.got)) != number.got)
        return false;
      ++count;
    }
  return count >= fewest_cases;
}

}  // namespace tribo::conformance
