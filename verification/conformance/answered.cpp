// SPDX-License-Identifier: Apache-2.0
#include "conformance/answered.hpp"

#include <fmt/format.h>

#include <cmath>
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

}  // namespace

std::vector<AnsweredCase> answered_cases(const std::string& function,
                                         const std::vector<Case>& cases,
                                         const Conversation& conversation,
                                         const Tolerance& tolerance) {
  std::vector<AnsweredCase> all;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Answer& answer = conversation.answers[i];
    if (cases[i].function != function || answer.outcome != Outcome::answered) continue;
    AnsweredCase one{question_of(cases[i]), {}, {}};
    one.branch = branch_of(one.question);
    for (const Expected& expected : cases[i].expected) {
      if (!expected.word.empty() || expected.is_undefined) continue;
      const auto value = answer.fields.find(expected.field);
      const auto place = place_of_field(one.question, expected.field);
      if (!place || value == answer.fields.end() || !value->is_number()) continue;
      AnsweredNumber number{&expected, *place, value->get<double>(),
                            allowed_error(cases[i], expected, tolerance), false};
      if (!std::isfinite(number.got)) continue;
      number.is_wrong = std::abs(number.error()) > number.allowed;
      one.numbers.push_back(number);
    }
    if (!one.numbers.empty()) all.push_back(std::move(one));
  }
  return all;
}

}  // namespace tribo::conformance
