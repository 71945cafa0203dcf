// SPDX-License-Identifier: Apache-2.0
#include "conformance/modulus.hpp"

namespace tribo::conformance {
namespace {

constexpr const char* modulus_field = "effective_modulus";  // and the function that gives it

void double_in(nlohmann::json& object) {
  const auto found = object.find(modulus_field);
  if (found != object.end()) *found = 2 * found->get<double>();
}

void halve(Reply& answer) {
  const auto value = answer.fields.find("value");
  if (value != answer.fields.end() && value->is_number()) *value = value->get<double>() / 2;
}

}  // namespace

std::vector<TestCase> asked_in_twice_the_modulus(std::vector<TestCase> cases) {
  for (TestCase& one : cases) {
    double_in(one.inputs);
    const auto bodies = one.inputs.find("bodies");
    if (bodies != one.inputs.end()) double_in(*bodies);
  }
  return cases;
}

void halve_moduli(const std::vector<TestCase>& cases, Conversation& conversation) {
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (cases[i].function == modulus_field) halve(conversation.answers[i]);
  for (std::size_t i = 0; i < conversation.again.size(); ++i)
    if (cases[conversation.again[i]].function == modulus_field)
      halve(conversation.second_answers[i]);
}

}  // namespace tribo::conformance
