// SPDX-License-Identifier: Apache-2.0
#include "conformance/wrong_numbers.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <utility>

namespace tribo::conformance {
namespace {

// The argument whose values are branches of the function, or null.
const catalogue::Parameter* branching(const catalogue::Function& function) {
  for (const catalogue::Parameter& one : function.parameters)
    if (!one.words.empty() || one.range == catalogue::Range::half_order) return &one;
  return nullptr;
}

std::string branch_of(const Question& question) {
  if (question.function == nullptr) return {};
  const catalogue::Parameter* const parameter = branching(*question.function);
  if (parameter == nullptr) return {};
  const nlohmann::json& written = question.asked->inputs.at(std::string(parameter->name));
  return written.is_string() ? written.get<std::string>()
                             : fmt::format("{} {}", parameter->name, written.get<double>());
}

struct FittedNumber {
  const AnsweredCase* one;
  double number;
};

// The inputs that a power can be of: numbers above zero.
std::vector<std::size_t> powers_of(const catalogue::Function& function) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < function.parameters.size(); ++i)
    if (function.parameters[i].words.empty() &&
        function.parameters[i].range == catalogue::Range::above_zero)
      places.push_back(i);
  return places;
}

std::optional<PowerLaw> fit(const std::vector<FittedNumber>& samples,
                            std::vector<std::size_t> places, std::size_t parameters) {
  // An input that is the same everywhere says nothing.
  std::erase_if(places, [&](std::size_t place) {
    return std::all_of(samples.begin(), samples.end(), [&](const FittedNumber& one) {
      return one.one->question.arguments[place] == samples.front().one->question.arguments[place];
    });
  });
  const auto rows = static_cast<Eigen::Index>(samples.size());
  const auto columns = static_cast<Eigen::Index>(places.size() + 1);
  if (rows < columns + 3) return std::nullopt;
  Eigen::MatrixXd inputs(rows, columns);
  Eigen::VectorXd logarithms(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const FittedNumber& sample = samples[static_cast<std::size_t>(i)];
    inputs(i, 0) = 1;
    for (Eigen::Index k = 1; k < columns; ++k)
      inputs(i, k) =
          std::log(sample.one->question.arguments[places[static_cast<std::size_t>(k - 1)]]);
    logarithms(i) = std::log(std::abs(sample.number));
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(inputs);
  if (solver.rank() < columns) return std::nullopt;
  const Eigen::VectorXd found = solver.solve(logarithms);
  PowerLaw law{std::vector<double>(parameters),
               std::copysign(std::exp(found(0)), samples[0].number),
               (inputs * found - logarithms).lpNorm<Eigen::Infinity>()};
  for (std::size_t k = 0; k < places.size(); ++k)
    law.exponents[places[k]] = found(static_cast<Eigen::Index>(k + 1));
  return law;
}

// The value of an argument that most samples have.
double commonest(const std::vector<FittedNumber>& samples, std::size_t place) {
  std::map<double, std::size_t> counts;
  for (const FittedNumber& one : samples) ++counts[one.one->question.arguments[place]];
  return std::max_element(counts.begin(), counts.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

// Part of the cases, and of the right or the wrong ones, that may lie on the wrong side of a
// border.
constexpr double stray = 0.02, stray_of_few = 0.1;
constexpr std::size_t fewest_cases = 8, fewest_right = 3;

struct InputPoint {
  double input;
  const AnsweredNumber* number;
};

std::vector<InputPoint> along(const std::vector<AnsweredCase>& cases, const std::string& branch,
                              std::size_t place, std::size_t input) {
  std::vector<InputPoint> points;
  for (const AnsweredCase& one : cases) {
    if (!branch.empty() && one.branch != branch) continue;
    for (const AnsweredNumber& number : one.numbers)
      if (number.place == place) points.push_back({one.question.arguments[input], &number});
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const InputPoint& a, const InputPoint& b) { return a.input < b.input; });
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

Stretch best_stretch(const std::vector<InputPoint>& points, bool of_wrong) {
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

std::optional<Where> where_along(const std::vector<InputPoint>& points, const std::string& symbol) {
  const Stretch right = best_stretch(points, false), wrong = best_stretch(points, true);
  const bool inside_is_wrong = wrong.misplaced < right.misplaced;
  const Stretch& inside = inside_is_wrong ? wrong : right;
  const auto wrong_count = static_cast<std::size_t>(std::count_if(
      points.begin(), points.end(), [](const InputPoint& one) { return one.number->is_wrong; }));
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

std::vector<AnsweredCase> answered_cases(const std::string& function,
                                         const std::vector<TestCase>& cases,
                                         const Conversation& conversation,
                                         const Tolerance& tolerance) {
  std::vector<AnsweredCase> all;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Reply& answer = conversation.answers[i];
    if (cases[i].function != function || answer.outcome != Outcome::answered) continue;
    AnsweredCase one{question_of(cases[i]), {}, {}};
    one.branch = branch_of(one.question);
    for (const Expected& expected : cases[i].expected) {
      if (!expected.word.empty() || expected.is_undefined) continue;
      const auto value = answer.fields.find(expected.field);
      if (!expected.place || value == answer.fields.end() || !value->is_number()) continue;
      AnsweredNumber number{&expected, *expected.place, value->get<double>(),
                            allowed_error(cases[i], expected, tolerance), false};
      if (!std::isfinite(number.got)) continue;
      number.is_wrong = std::abs(number.error()) > number.allowed;
      one.numbers.push_back(number);
    }
    if (!one.numbers.empty()) all.push_back(std::move(one));
  }
  return all;
}

std::optional<PowerLaw> fit_power_law(const std::vector<AnsweredCase>& cases,
                                      const std::string& branch, std::size_t place,
                                      const NumberOf& number_of, double closeness) {
  if (cases.empty() || cases.front().question.function == nullptr) return std::nullopt;
  const catalogue::Function& function = *cases.front().question.function;
  std::vector<FittedNumber> samples;
  for (const AnsweredCase& one : cases) {
    if (!branch.empty() && one.branch != branch) continue;
    for (const AnsweredNumber& number : one.numbers) {
      if (number.place != place) continue;
      const double value = number_of(one, number);
      if (!std::isfinite(value) || value == 0) return std::nullopt;
      if (!samples.empty() && std::signbit(value) != std::signbit(samples.front().number))
        return std::nullopt;
      samples.push_back({&one, value});
    }
  }
  if (samples.empty()) return std::nullopt;
  const std::vector<std::size_t> places = powers_of(function);
  const auto is_close = [&](const std::optional<PowerLaw>& law) {
    return law && law->residual <= closeness;
  };
  if (const auto law = fit(samples, places, function.parameters.size()); is_close(law)) return law;
  for (const std::size_t held : places) {
    const double value = commonest(samples, held);
    std::vector<FittedNumber> of_value;
    std::copy_if(
        samples.begin(), samples.end(), std::back_inserter(of_value),
        [&](const FittedNumber& one) { return one.one->question.arguments[held] == value; });
    if (auto law = fit(of_value, places, function.parameters.size()); is_close(law)) {
      law->held = fmt::format("{} = {:.4g}", symbol_of(function.parameters[held]), value);
      return law;
    }
  }
  return std::nullopt;
}

std::string symbol_of(const catalogue::Parameter& parameter) {
  return std::string(parameter.meaning.substr(0, parameter.meaning.find_first_of(", ")));
}

std::string power_in_words(const catalogue::Parameter& parameter, double exponent) {
  for (const int denominator : {1, 2, 3, 4, 6}) {
    const double numerator = exponent * denominator;
    if (std::abs(numerator - std::round(numerator)) > 1e-6 * denominator) continue;
    return denominator == 1
               ? fmt::format("{}^{:+.0f}", symbol_of(parameter), numerator)
               : fmt::format("{}^({:+.0f}/{})", symbol_of(parameter), numerator, denominator);
  }
  return fmt::format("{}^{:+.4g}", symbol_of(parameter), std::round(exponent * 1e5) / 1e5);
}

std::string powers_in_words(const catalogue::Function& function,
                            const std::vector<double>& exponents) {
  std::string text;
  for (std::size_t i = 0; i < exponents.size(); ++i)
    if (std::abs(exponents[i]) > 1e-4)
      text += (text.empty() ? "" : " ") + power_in_words(function.parameters[i], exponents[i]);
  return text;
}

std::string where_wrong(const std::vector<AnsweredCase>& cases, const std::string& branch,
                        std::size_t place) {
  std::optional<Where> best;
  for (const std::size_t input : number_inputs(cases)) {
    const std::vector<InputPoint> points = along(cases, branch, place, input);
    const auto right = static_cast<std::size_t>(std::count_if(
        points.begin(), points.end(), [](const InputPoint& one) { return !one.number->is_wrong; }));
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
  std::vector<InputPoint> points = along(cases, branch, place, inputs.front());
  std::erase_if(points, [](const InputPoint& one) {
    return !one.number->is_wrong || one.number->expected->high == 0;
  });
  if (points.size() < fewest_cases) return {};
  const auto relative = [](const InputPoint& one) {
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
  const double before = middle_of(0, third), after = middle_of(sizes.size() - third, sizes.size());
  if (flips >= 3 && part(flips) > 0.05 && (after > 100 * before || before > 100 * after))
    return "the errors have no order and grow: digits cancel there";
  const double greatest = *std::max_element(sizes.begin(), sizes.end());
  const double least = *std::min_element(sizes.begin(), sizes.end());
  if (part(flips) < 0.05 && greatest <= 1 && greatest > 3 * least &&
      (part(falls) < 0.2 || part(falls) > 0.8))
    return "the errors are smooth and grow, as of a quadrature or a series with too few terms";
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
