// SPDX-License-Identifier: Apache-2.0
#include "protocol/function_call.hpp"

#include <cstddef>

#include "protocol/flat_json.hpp"
#include "protocol/output_stream.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::protocol {
namespace {

using catalogue::Parameter;

std::string allowed_with_unit(const Parameter& parameter) {
  std::string text = catalogue::allowed_text(parameter);
  if (!parameter.unit.empty()) text += ", in " + std::string(parameter.unit);
  return text;
}

std::optional<double> word_argument(const Parameter& parameter, const FlatMember& member,
                                    std::string& complaint) {
  if (member.kind != FlatMember::Kind::text) {
    complaint = "this is no text";
    return std::nullopt;
  }
  const std::optional<double> place = catalogue::place_of(member.text, parameter);
  if (!place) complaint = '"' + printable(member.text) + "\" is not known";
  return place;
}

std::optional<double> number_argument(const Parameter& parameter, const FlatMember& member,
                                      std::string& complaint) {
  if (member.kind != FlatMember::Kind::number)
    complaint = "this is no number";
  else if (!member.fault.empty())
    complaint = member.fault;
  else if (!catalogue::is_in_range(member.number, parameter.range))
    complaint = fmt::format("{} is not allowed", member.number);
  else
    return member.number;
  return std::nullopt;
}

std::optional<double> argument(const Parameter& parameter, const FlatObject& object,
                               std::string& complaint) {
  const FlatMember* member = object.find(parameter.name);
  if (member == nullptr) {
    complaint = "missing";
    return parameter.default_value;
  }
  return parameter.words.empty() ? number_argument(parameter, *member, complaint)
                                 : word_argument(parameter, *member, complaint);
}

std::string parameter_names(const catalogue::Function& function) {
  std::string text;
  for (const Parameter& parameter : function.parameters) {
    if (!text.empty()) text += ", ";
    text += parameter.name;
  }
  return text;
}

bool is_known(const catalogue::Function& function, std::string_view name) {
  if (name == "id" || name == "function") return true;
  for (const Parameter& parameter : function.parameters)
    if (parameter.name == name) return true;
  return false;
}

std::optional<Mistake> mistake_in_names(const catalogue::Function& function,
                                        const FlatObject& object) {
  for (const FlatMember& member : object.members) {
    if (!is_known(function, member.name))
      return Mistake{printable(member.name),
                     "unknown argument; known: " + parameter_names(function)};
    if (object.find(member.name) != &member) return Mistake{member.name, "given twice"};
  }
  return std::nullopt;
}

std::optional<Mistake> read_arguments(const catalogue::Function& function, const FlatObject& object,
                                      catalogue::Arguments& arguments) {
  std::size_t place = 0;
  for (const Parameter& parameter : function.parameters) {
    std::string complaint;
    const std::optional<double> value = argument(parameter, object, complaint);
    if (!value)
      return Mistake{std::string(parameter.name),
                     complaint + "; allowed: " + allowed_with_unit(parameter)};
    arguments[place++] = *value;
  }
  return std::nullopt;
}

Mistake unknown_function(const FlatMember& member) {
  std::string message = member.kind == FlatMember::Kind::text
                            ? '"' + printable(member.text) + "\" is not known"
                            : "this is no text";
  const char* before = "; allowed: ";
  for (const catalogue::Function& function : catalogue::functions()) {
    message += before + std::string(function.name);
    before = ", ";
  }
  return {"function", message};
}

std::optional<Mistake> read_call(const FlatObject& object, FunctionCall& call) {
  const FlatMember& name = *object.find("function");
  call.function = name.kind == FlatMember::Kind::text ? catalogue::find(name.text) : nullptr;
  if (call.function == nullptr) return unknown_function(name);
  if (auto mistake = mistake_in_names(*call.function, object)) return mistake;
  if (auto mistake = read_arguments(*call.function, object, call.arguments)) return mistake;
  if (call.function->refusal == nullptr) return std::nullopt;
  const std::optional<catalogue::Refusal> refusal = call.function->refusal(call.arguments);
  if (!refusal) return std::nullopt;
  return Mistake{std::string(refusal->parameter), std::string(refusal->reason)};
}

}  // namespace

std::optional<FunctionCall> read_function_call(std::string_view line) {
  const std::optional<FlatObject> object = parse_flat_json(line);
  if (!object || object->find("function") == nullptr) return std::nullopt;
  FunctionCall call;
  if (const FlatMember* member = object->find("id")) {
    if (member->kind == FlatMember::Kind::text)
      call.id = member->text;
    else
      call.mistake = Mistake{"id", "this is no text; allowed: a text"};
  }
  if (!call.mistake) call.mistake = read_call(*object, call);
  return call;
}

}  // namespace tribo::protocol
