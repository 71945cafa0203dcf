// SPDX-License-Identifier: Apache-2.0
#include "conformance/dependence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "conformance/misread.hpp"
#include "conformance/variable.hpp"

namespace tribo::conformance {
namespace {

constexpr std::size_t fewest_values = 12;  // different values of the variable
constexpr std::size_t fewest_of_form = 4;
constexpr double same_factor = 1e-6;  // of the range of the logarithms of the factors
// The greatest roughness() of a curve: of the logarithms of the factors, and of their ranks. By
// ranks a few extreme cases cannot decide.
constexpr double most_rough = 2e-3, most_rough_ranks = 0.1;
constexpr double as_good = 4;  // an earlier variable may be rougher by this factor

struct Sample {
  double x, y;   // x: the variable or its logarithm; y: the logarithm of the factor
  double value;  // the variable
};

double interpolated(const Sample& a, const Sample& b, double x) {
  return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
}

// The squared distances of all inner samples from the line between their neighbours, added up, over
// the squared distances of all samples from their mean.
double roughness(const std::vector<Sample>& samples) {
  const auto count = static_cast<double>(samples.size());
  const double mean = std::accumulate(samples.begin(), samples.end(), 0.0,
                                      [](double sum, const Sample& one) { return sum + one.y; }) /
                      count;
  double unexpected = 0, all = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    all += (samples[i].y - mean) * (samples[i].y - mean);
    if (i == 0 || i + 1 == samples.size()) continue;
    const double off = samples[i].y - interpolated(samples[i - 1], samples[i + 1], samples[i].x);
    unexpected += off * off;
  }
  return all > 0 ? unexpected / all : INFINITY;
}

std::vector<Sample> ranks_of(std::vector<Sample> samples) {
  std::vector<double> sorted;
  for (const Sample& one : samples) sorted.push_back(one.y);
  std::sort(sorted.begin(), sorted.end());
  double place = 0;
  for (Sample& one : samples) {
    one.y =
        static_cast<double>(std::lower_bound(sorted.begin(), sorted.end(), one.y) - sorted.begin());
    one.x = place++;
  }
  return samples;
}

struct Curve {
  std::string symbol;
  std::function<double(const Question&)> value;
  // The scale is ln(x + log_offset). Empty: it is linear, because x may be below 0.
  std::optional<double> log_offset = {};
  std::vector<Sample> samples = {};
  double rough = INFINITY;

  double scaled(double x) const { return log_offset ? std::log(x + *log_offset) : x; }
};

// Empty: too few values, a factor not above 0, different factors at one value, or a rough curve.
std::optional<Curve> curve_of(const Part& part, const Variable& variable) {
  Curve curve{variable.symbol, variable.value};
  double least = INFINITY, greatest = -INFINITY;  // of the logarithms of the factors
  double lowest = 0, least_positive = INFINITY;   // of the variable
  for (const Part::Number& one : part.all) {
    if (one.answered->is_explained) continue;
    const double factor = one.answered->got / one.answered->expected->high;
    const double x = variable.value(one.of->asked);
    if (!(factor > 0) || !std::isfinite(factor) || !std::isfinite(x)) return std::nullopt;
    lowest = std::min(lowest, x);
    if (x > 0) least_positive = std::min(least_positive, x);
    curve.samples.push_back({x, std::log(factor), x});
    least = std::min(least, curve.samples.back().y);
    greatest = std::max(greatest, curve.samples.back().y);
  }
  std::sort(curve.samples.begin(), curve.samples.end(),
            [](const Sample& a, const Sample& b) { return a.x < b.x; });
  std::vector<Sample> different;
  for (const Sample& one : curve.samples) {
    const bool is_same =
        !different.empty() && std::abs(one.x - different.back().x) <= 1e-12 * std::abs(one.x);
    if (!is_same)
      different.push_back(one);
    else if (std::abs(one.y - different.back().y) > same_factor * (greatest - least) + 1e-9)
      return std::nullopt;
  }
  if (different.size() < fewest_values) return std::nullopt;
  if (lowest == 0 && std::isfinite(least_positive))
    curve.log_offset = different.front().x > 0 ? 0 : least_positive;
  for (Sample& one : different) one.x = curve.scaled(one.x);
  curve.samples = std::move(different);
  curve.rough = roughness(curve.samples);
  if (curve.rough > most_rough || roughness(ranks_of(curve.samples)) > most_rough_ranks)
    return std::nullopt;
  return curve;
}

// The factor by a cubic through the four samples around the value, or the four at an end of the
// curve. NaN beyond the ends.
double factor_at(const Curve& curve, double value) {
  const double x = curve.scaled(value);
  const auto& samples = curve.samples;
  if (!(x >= samples.front().x && x <= samples.back().x)) return unsaid;
  const auto after = static_cast<std::size_t>(
      std::upper_bound(samples.begin(), samples.end(), x,
                       [](double one, const Sample& sample) { return one < sample.x; }) -
      samples.begin());
  const std::size_t first = std::min(after >= 2 ? after - 2 : 0, samples.size() - 4);
  const std::size_t last = first + 4;
  double sum = 0;
  for (std::size_t i = first; i < last; ++i) {
    double term = samples[i].y;
    for (std::size_t k = first; k < last; ++k)
      if (k != i) term *= (x - samples[k].x) / (samples[i].x - samples[k].x);
    sum += term;
  }
  return std::exp(sum);
}

std::string text_of(const Curve& curve, bool is_only_input) {
  const std::string& symbol = curve.symbol;
  const auto at = [&](std::size_t i) {
    const Sample& one = curve.samples[i];
    return fmt::format("{:.4g} at {} = {:.4g}", std::exp(one.y), symbol, one.value);
  };
  return fmt::format("The factor {}: {}, {}, {}.",
                     is_only_input ? fmt::format("changes smoothly with {}", symbol)
                                   : fmt::format("depends on {} alone", symbol),
                     at(0), at(curve.samples.size() / 2), at(curve.samples.size() - 1));
}

// A form of x with two numbers a and b: Y(y) = a + b X(x), a straight line in X and Y.
struct Form {
  double (*of_x)(double);
  double (*of_y)(double);
  double (*y_of)(double);
  bool is_power;     // Y = ln y: the first number is e^a
  const char* text;  // {0}: a or e^a, {1}: b, {2}: x
};
double same(double x) { return x; }
double reciprocal(double x) { return 1 / x; }
double logarithm(double x) { return std::log(x); }
double exponential(double x) { return std::exp(x); }
constexpr std::array forms{Form{same, same, same, false, "{1} {2}{0}"},
                           Form{logarithm, same, same, false, "{1} ln {2}{0}"},
                           Form{logarithm, logarithm, exponential, true, "{0}{2}^({1})"},
                           Form{same, logarithm, exponential, true, "{0}e^({1} {2})"},
                           Form{same, reciprocal, reciprocal, false, "1/({1} {2}{0})"}};

// The form through the two end points, if it fits all points and both numbers have few digits.
std::string form_through(const std::vector<Sample>& points, std::string symbol) {
  if (symbol.find('/') != std::string::npos) symbol = '(' + symbol + ')';
  constexpr double closeness = 1e-6;
  const auto [first, last] = std::minmax_element(
      points.begin(), points.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  for (const Form& form : forms) {
    const double from = form.of_x(first->x), y = form.of_y(first->y);
    const double slope = round_number((form.of_y(last->y) - y) / (form.of_x(last->x) - from));
    double constant = y - slope * from;
    const double written = round_number(form.is_power ? std::exp(constant) : constant);
    if (form.is_power) constant = std::log(written);
    const bool is_of_all = std::all_of(points.begin(), points.end(), [&](const Sample& one) {
      const double given = form.y_of(constant + slope * form.of_x(one.x));
      return std::abs(given - one.y) <= closeness * std::abs(one.y);
    });
    if (!is_of_all || slope == 0 || !is_of_few_digits(slope) || !is_of_few_digits(written))
      continue;
    const std::string number =
        form.is_power ? (written == 1 ? "" : fmt::format("{:.6g} ", written))
                      : fmt::format(" {} {:.6g}", written < 0 ? "−" : "+", std::abs(written));
    return fmt::format(fmt::runtime(form.text), number, fmt::format("{:.6g}", slope), symbol);
  }
  return {};
}

}  // namespace

std::string form_of(const Part& part) {
  if (part.function() == nullptr) return {};
  for (const Variable& variable : variables_of(part.function())) {
    std::vector<Sample> answers, factors;
    std::set<double> values;
    for (const Part::Number& one : part.all) {
      if (!one.answered->is_left()) continue;
      const double x = variable.value(one.of->asked);
      values.insert(x);
      answers.push_back({x, one.answered->got, x});
      factors.push_back({x, one.answered->got / one.answered->expected->high, x});
    }
    if (variable.is_result || values.size() < fewest_of_form) continue;
    if (const std::string text = form_through(answers, variable.symbol); !text.empty())
      return fmt::format("All {} wrong answers are {}.", answers.size(), text);
    if (const std::string text = form_through(factors, variable.symbol); !text.empty())
      return fmt::format("All {} wrong answers are {} times the right ones.", factors.size(), text);
  }
  return {};
}

std::string form_of_right(const Part& part) {
  struct RightForm {
    double (*of)(double right);
    const char* text;
  };
  constexpr std::array right_forms{
      RightForm{[](double x) { return 1 / x; }, "1 over the right ones"},
      RightForm{[](double x) { return 1 - x; }, "1 less the right ones"},
      RightForm{[](double x) { return x - 1; }, "the right ones less 1"},
      RightForm{[](double x) { return 1 / x - 1; }, "1 over the right ones, less 1"},
      RightForm{[](double x) { return x * x; }, "the squares of the right ones"},
      RightForm{[](double x) { return std::sqrt(x); }, "the roots of the right ones"},
      RightForm{[](double x) { return x * x * x; }, "the cubes of the right ones"},
      RightForm{[](double x) { return std::cbrt(x); }, "the cube roots of the right ones"},
      RightForm{[](double x) { return std::pow(x, 1.5); }, "the right ones to the power 3/2"},
      RightForm{[](double x) { return std::pow(x, 2. / 3); }, "the right ones to the power 2/3"},
      RightForm{[](double x) { return std::log(x); }, "the logarithms of the right ones"},
      RightForm{[](double x) { return std::log10(x); },
                "the decimal logarithms of the right ones"}};
  constexpr double closeness = 1e-6, of_difference = 1e-11;  // the latter where digits cancel
  std::size_t wrong = 0;
  for (const Part::Number& one : part.all) wrong += one.answered->is_left() ? 1 : 0;
  for (const RightForm& form : right_forms)
    if (wrong >= fewest_of_form &&
        std::all_of(part.all.begin(), part.all.end(), [&](const Part::Number& one) {
          const double given = form.of(one.answered->expected->high);
          return one.answered->is_explained ||
                 std::abs(one.answered->got - given) <=
                     closeness * std::abs(given) +
                         of_difference * std::min(1.0, std::abs(one.answered->expected->high));
        }))
      return fmt::format("All {} wrong answers are {}.", wrong, form.text);
  return {};
}

std::optional<Dependence> dependence_of(const Part& part) {
  if (part.wrong.size() < fewest_cases || part.function() == nullptr) return std::nullopt;
  const std::vector<Variable> variables = variables_of(part.function());
  const auto inputs = std::count_if(variables.begin(), variables.end(), [&](const Variable& one) {
    return one.is_input &&
           std::any_of(part.all.begin(), part.all.end(), [&](const Part::Number& number) {
             return one.value(number.of->asked) != one.value(part.all.front().of->asked);
           });
  });
  std::vector<Curve> curves;
  for (const Variable& one : variables)
    if (inputs > 1 || one.is_input)
      if (auto curve = curve_of(part, one)) curves.push_back(std::move(*curve));
  if (curves.empty()) return std::nullopt;
  const double least =
      std::min_element(curves.begin(), curves.end(), [](const Curve& a, const Curve& b) {
        return a.rough < b.rough;
      })->rough;
  const Curve& best = *std::find_if(curves.begin(), curves.end(),
                                    [&](const Curve& one) { return one.rough <= as_good * least; });
  Dependence found{text_of(best, inputs == 1), {}};
  found.factor = [curve = best](const Question& question) {
    return factor_at(curve, curve.value(question));
  };
  return found;
}

}  // namespace tribo::conformance
