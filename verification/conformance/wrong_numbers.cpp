// SPDX-License-Identifier: Apache-2.0
#include "conformance/wrong_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

namespace tribo::conformance {
namespace {

constexpr double few = 0.03;  // of the explained wrong answers

}  // namespace

std::string branch_of(const Question& question) {
  if (question.function == nullptr) return {};
  const auto& parameters = question.function->parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const double value = question.arguments[i];
    const auto& words = parameters[i].words;
    if (value >= 0 && value < static_cast<double>(words.size()))
      return std::string(words[static_cast<std::size_t>(value)]);
    if (parameters[i].range == catalogue::Range::half_order)
      return fmt::format("{} {}", parameters[i].name, value);
  }
  return {};
}

std::vector<AnsweredCase> answered_cases(const std::string& function,
                                         const std::vector<TestCase>& cases,
                                         const Conversation& conversation,
                                         const Tolerance& tolerance) {
  std::vector<AnsweredCase> all;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Reply& answer = conversation.answers[i];
    if (cases[i].function != function || answer.outcome != Outcome::answered) continue;
    AnsweredCase one{question_of(cases[i]), {}, {}, {}};
    one.asked = one.question;
    one.branch = branch_of(one.question);
    for (const Expected& expected : cases[i].expected) {
      if (!expected.word.empty()) continue;
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

std::vector<Part::Number> wrong_of(const Part& part) {
  std::vector<Part::Number> wrong;
  for (const Part::Number& one : part.all)
    if (one.answered->is_left()) wrong.push_back(one);
  return wrong;
}

std::vector<Part::Number> far_apart(const std::vector<Part::Number>& numbers, std::size_t most) {
  if (numbers.size() <= most) return numbers;
  std::vector<Part::Number> some;
  for (std::size_t i = 0; i < most; ++i)
    some.push_back(numbers[i * (numbers.size() - 1) / (most - 1)]);
  return some;
}

std::vector<Part> parts_left(const std::vector<AnsweredCase>& cases) {
  std::map<std::pair<std::size_t, std::string>, Part> parts;
  std::map<std::string, std::pair<std::size_t, std::size_t>> counts;  // explained, left
  for (const AnsweredCase& one : cases)
    for (const AnsweredNumber& number : one.numbers) {
      Part& part = parts[{number.place, one.branch}];
      part.place = number.place;
      part.branch = one.branch;
      part.all.push_back({&one, &number});
      if (number.is_left()) part.wrong.push_back(&number);
      counts[one.branch].first += number.is_wrong && number.is_explained ? 1 : 0;
      counts[one.branch].second += number.is_left() ? 1 : 0;
    }
  // After a named mistake a few other wrong answers, such as near a border, are not reported.
  std::vector<Part> all;
  for (auto& [key, part] : parts) {
    const auto [explained, rest] = counts[part.branch];
    const bool is_news = static_cast<double>(rest) > few * static_cast<double>(explained);
    if (!part.wrong.empty() && is_news) all.push_back(std::move(part));
  }
  return all;
}

std::string few_digits(const std::vector<AnsweredCase>& cases, double greatest) {
  constexpr int fewest = 3, of_single = 8, most = 9;
  constexpr double half_a_digit = 0.51;  // 0.01 more than rounding: the solver's own error
  constexpr double of_formula = 1e-5;    // single precision is off by only a few 2^−24
  std::size_t count = 0;
  int digits = fewest;
  for (const AnsweredCase& one : cases)
    for (const AnsweredNumber& number : one.numbers) {
      const auto has_more = [&] {
        return std::strtod(fmt::format("{:.{}g}", number.got, digits).c_str(), nullptr) !=
               number.got;
      };
      while (digits < most && has_more()) ++digits;
      if (has_more() && static_cast<double>(static_cast<float>(number.got)) != number.got)
        return {};
      ++count;
    }
  if (count < fewest_cases) return {};
  if (digits >= of_single)
    return greatest >= of_formula ? ""
                                  : "All answers have at most nine digits: they are computed, or "
                                    "written, in single precision.";
  if (greatest > half_a_digit * std::pow(10, 1 - digits)) return {};
  return fmt::format(
      "All answers have at most {} digits: they are written with so few, or rounded to them.",
      digits);
}

}  // namespace tribo::conformance
