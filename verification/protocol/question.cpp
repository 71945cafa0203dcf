// SPDX-License-Identifier: Apache-2.0
#include "protocol/question.hpp"

#include <fmt/compile.h>

#include <algorithm>
#include <cstring>
#include <span>

#include "catalogue/ways_to_ask.hpp"
#include "protocol/ordinary_scene.hpp"

namespace tribo::protocol {
namespace {

using catalogue::Parameter;
using catalogue::place_in;
using catalogue::WayToAsk;
using Members = std::span<const scene_detail::Entry>;
using scene_detail::Entry;
using scene_detail::NumberFault;
using scene_detail::ValueKind;

const Entry* find(Members members, std::string_view name) {
  for (const Entry& member : members)
    if (member.path == name) return &member;
  return nullptr;
}

// The name as it was given, in printable characters. A path has an odd name in quotes.
std::string name_of(const Entry& member) {
  const std::string& path = member.path;
  return path.starts_with('"') ? path.substr(1, path.size() - 2) : path;
}

std::optional<double> word_argument(const Parameter& parameter, const Entry& member,
                                    std::string& complaint) {
  if (member.value.kind != ValueKind::text) {
    complaint = "this is no text";
    return std::nullopt;
  }
  const std::optional<double> place = catalogue::place_of(member.value.text, parameter);
  if (!place) complaint = '"' + printable(member.value.text) + "\" is not known";
  return place;
}

std::optional<double> number_argument(const Parameter& parameter, const Entry& member,
                                      std::string& complaint) {
  const scene_detail::Value& value = member.value;
  const double number = value.number + 0.0;  // −0 becomes 0
  if (value.kind != ValueKind::number)
    complaint = "this is no number";
  else if (value.fault == NumberFault::underflow)
    complaint = value.text.substr(0, 40) + " underflows: it is nearer to 0 than 4.9e-324";
  else if (value.fault == NumberFault::overflow)
    complaint = value.text.substr(0, 40) + " is beyond 1.8e308; it must be finite";
  else if (!catalogue::is_in_range(number, parameter.range))
    complaint = fmt::format("{} is not allowed", number);
  else
    return number;
  return std::nullopt;
}

std::optional<double> argument(const Parameter& parameter, Members members,
                               std::string& complaint) {
  const Entry* member = find(members, parameter.name);
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

bool has(std::span<const Parameter> parameters, std::string_view name) {
  return place_in(parameters, name) < parameters.size();
}

// The function's way to ask in which a number of this name is given. Null if there is none.
const WayToAsk* way_with(const catalogue::Function& function, std::string_view name) {
  for (const WayToAsk& way : catalogue::ways_to_ask())
    if (has_way(function, way) && has(way.given, name)) return &way;
  return nullptr;
}

// The way by which the line gives this argument indirectly, by a number that stands for it. Null if
// there is none.
const WayToAsk* way_to(const catalogue::Function& function, std::string_view argument,
                       Members members) {
  for (const WayToAsk& way : catalogue::ways_to_ask()) {
    if (!has_way(function, way) || std::find(way.in_place_of.begin(), way.in_place_of.end(),
                                             argument) == way.in_place_of.end())
      continue;
    for (const Parameter& given : way.given)
      if (!has(function.parameters, given.name) && find(members, given.name) != nullptr)
        return &way;
  }
  return nullptr;
}

std::optional<CallFault> fault_in_names(const catalogue::Function& function, Members members) {
  for (const Entry& member : members) {
    const std::string& name = member.path;
    if (name != "id" && name != "function" && !has(function.parameters, name)) {
      const WayToAsk* const way = way_with(function, name);
      if (way == nullptr)
        return CallFault{printable(name_of(member)),
                         "unknown argument; known: " + parameter_names(function)};
      for (const std::string_view own : way->in_place_of)
        if (!has(way->given, own) && find(members, own) != nullptr)
          return CallFault{name, fmt::format("it stands for {}, which is given, too; leave one of "
                                             "them out",
                                             own)};
    }
    if (find(members, name) != &member) return CallFault{name, "given twice"};
  }
  return std::nullopt;
}

// Reads the parameters of a list from the line. The first one that cannot be read is the fault.
std::optional<CallFault> read_list(std::span<const Parameter> list, Members members,
                                   catalogue::Arguments& arguments) {
  std::size_t place = 0;
  for (const Parameter& parameter : list) {
    std::string complaint;
    const std::optional<double> value = argument(parameter, members, complaint);
    if (!value)
      return CallFault{std::string(parameter.name),
                       complaint + "; allowed: " + allowed_with_unit(parameter)};
    arguments[place++] = *value;
  }
  return std::nullopt;
}

// Reads the arguments of a function. Some of them may be given in another way.
std::optional<CallFault> read_arguments(const catalogue::Function& function, Members members,
                                        catalogue::Arguments& arguments) {
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const Parameter& parameter = function.parameters[i];
    const WayToAsk* const way = find(members, parameter.name) == nullptr
                                    ? way_to(function, parameter.name, members)
                                    : nullptr;
    catalogue::Arguments numbers{};
    if (auto fault = way == nullptr ? read_list({&parameter, 1}, members, numbers)
                                    : read_list(way->given, members, numbers))
      return fault;
    if (way == nullptr) {
      arguments[i] = numbers[0];
      continue;
    }
    const auto place = std::find(way->in_place_of.begin(), way->in_place_of.end(), parameter.name);
    arguments[i] = way->value(numbers, static_cast<std::size_t>(place - way->in_place_of.begin()));
    if (!catalogue::is_in_range(arguments[i], parameter.range) || !is_finite(arguments[i]))
      return CallFault{std::string(way->given[0].name),
                       fmt::format("with the others it gives {} = {}; allowed: {}", parameter.name,
                                   arguments[i], allowed_with_unit(parameter))};
  }
  return std::nullopt;
}

CallFault unknown_function(const scene_detail::Value& name) {
  std::string message = name.kind == ValueKind::text
                            ? '"' + printable(name.text) + "\" is not known"
                            : "this is no text";
  const char* before = "; allowed: ";
  for (const catalogue::Function& function : catalogue::functions()) {
    message += before + std::string(function.name);
    before = ", ";
  }
  return {"function", message};
}

std::optional<CallFault> read_call(Members members, FunctionCall& call) {
  if (const Entry* const id = find(members, "id")) {
    call.id = scene_detail::line_id(id->value);
    if (!call.id)
      return CallFault{"id",
                       fmt::format("this is no id; allowed: {}", scene_detail::allowed_line_ids)};
    call.id_is_number = id->value.kind == ValueKind::number;
  }
  const scene_detail::Value& name = find(members, "function")->value;
  call.function = name.kind == ValueKind::text ? catalogue::function_named(name.text) : nullptr;
  if (call.function == nullptr) return unknown_function(name);
  if (auto fault = fault_in_names(*call.function, members)) return fault;
  if (auto fault = read_arguments(*call.function, members, call.arguments)) return fault;
  if (call.function->refusal == nullptr) return std::nullopt;
  const std::optional<catalogue::Refusal> refusal = call.function->refusal(call.arguments);
  if (!refusal) return std::nullopt;
  return CallFault{std::string(refusal->parameter), std::string(refusal->reason)};
}

std::optional<FunctionCall> call_of(Members members) {
  if (find(members, "function") == nullptr) return std::nullopt;
  FunctionCall call;
  call.fault = read_call(members, call);
  return call;
}

// The call that a line asks for; nullopt where it is no JSON object with a member "function".
std::optional<FunctionCall> read_function_call(std::string_view line) {
  if (const auto members = ordinary_members(line)) return call_of(*members);
  SceneReading unused;
  scene_detail::Problems problems(unused, "");
  auto members = scene_detail::json_entries(line, problems, line.size());
  if (!members) return std::nullopt;
  // json_entries() also has entries for the fields of tables. A call needs only the table's own.
  std::erase_if(*members, [](const Entry& one) {
    return !one.path.starts_with('"') && one.path.find('.') != std::string::npos;
  });
  return call_of(*members);
}

}  // namespace

Question read_question(std::string_view line, std::size_t number) {
  const std::string source = fmt::format(FMT_COMPILE("line {}"), number);
  // Only a line that may call a function is parsed for a call.
  constexpr std::string_view member = "\"function\"";
  if (::memmem(line.data(), line.size(), member.data(), member.size()) != nullptr)
    if (std::optional<FunctionCall> call = read_function_call(line)) return *std::move(call);
  if (std::optional<SceneReading> reading = read_ordinary_scene(line, source))
    return *std::move(reading);
  return parse_scene_json(line, source, SceneUse::one_speed);
}

bool is_blank(std::string_view line) {
  return line.find_first_not_of(" \t\r") == std::string_view::npos;
}

}  // namespace tribo::protocol
