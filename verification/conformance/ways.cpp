// SPDX-License-Identifier: Apache-2.0
#include "conformance/ways.hpp"

#include "catalogue/ways_to_ask.hpp"

namespace tribo::conformance {
namespace {

using catalogue::WayToAsk;

constexpr const char* modulus_field = "effective_modulus";  // also the function's name

void double_in(nlohmann::json& object) {
  const auto found = object.find(modulus_field);
  if (found != object.end()) *found = 2 * found->get<double>();
}

void halve(Reply& answer) {
  const auto value = answer.fields.find("value");
  if (value != answer.fields.end() && value->is_number()) *value = value->get<double>() / 2;
}

// Replaces inputs by the numbers of the way, from which these inputs follow. An argument with a
// default may be left out.
void ask_by(const WayToAsk& way, const catalogue::Function* function, nlohmann::json& inputs) {
  catalogue::Arguments replaced{};
  for (std::size_t i = 0; i < way.in_place_of.size(); ++i) {
    const std::string name(way.in_place_of[i]);
    const auto found = inputs.find(name);
    if (found == inputs.end())
      replaced[i] = *function->parameters[place_in(function->parameters, name)].default_value;
    else
      replaced[i] = found->get<double>();
    inputs.erase(name);
  }
  const catalogue::Arguments numbers = way.numbers(replaced);
  for (std::size_t i = 0; i < way.given.size(); ++i)
    inputs[std::string(way.given[i].name)] = numbers[i];
}

void ask_by(const WayToAsk& way, TestCase& one) {
  if (one.in_catalogue != nullptr) {
    if (has_way(*one.in_catalogue, way)) ask_by(way, one.in_catalogue, one.inputs);
    return;
  }
  const auto bodies = one.inputs.find("bodies");  // a scene has both radii anyway
  if (way.name == "bodies" && bodies != one.inputs.end() && bodies->contains(modulus_field))
    ask_by(way, nullptr, *bodies);
}

}  // namespace

std::vector<TestCase> asked_by(const AskedWays& ways, std::vector<TestCase> cases) {
  for (TestCase& one : cases) {
    if (ways.has_twice_the_modulus()) {
      double_in(one.inputs);
      const auto bodies = one.inputs.find("bodies");
      if (bodies != one.inputs.end()) double_in(*bodies);
    }
    for (const WayToAsk& way : catalogue::ways_to_ask())
      if (way.name == ways.modulus || way.name == ways.ellipticity) ask_by(way, one);
  }
  return cases;
}

void put_back(const AskedWays& ways, const std::vector<TestCase>& cases,
              Conversation& conversation) {
  if (!ways.has_twice_the_modulus()) return;
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (cases[i].function == modulus_field) halve(conversation.answers[i]);
  for (std::size_t i = 0; i < conversation.again.size(); ++i)
    if (cases[conversation.again[i]].function == modulus_field)
      halve(conversation.second_answers[i]);
}

}  // namespace tribo::conformance
