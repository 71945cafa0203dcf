// SPDX-License-Identifier: Apache-2.0
// One table says which functions there are and what their arguments may be.
#include "protocol/function_call.hpp"

#include <array>
#include <cstddef>
#include <span>

#include "protocol/flat_json.hpp"
#include "protocol/output_stream.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::protocol {
namespace {

using Words = std::span<const std::string_view>;

enum class Range : std::uint8_t { above_zero, not_below_zero, any, order };

struct Parameter {
  std::string_view name;
  Range range = Range::above_zero;
  std::string_view unit = "";
  Words words = {};  // not empty: the argument is one of these
  std::optional<double> default_value = {};
};

struct FunctionInfo {
  std::string_view name;
  std::span<const Parameter> parameters;
};

// In the order of the enumerations of scene.hpp.
constexpr std::array<std::string_view, 2> asperity_words{"greenwood_tripp", "greenwood_williamson"};
constexpr std::array<std::string_view, 4> closure_words{"flooded_inlet", "starved_inlet",
                                                        "printed_exponents", "damiens"};

constexpr std::array<Parameter, 2> gaussian_moment_parameters{{
    {.name = "order", .range = Range::order},
    {.name = "argument", .range = Range::any},
}};

constexpr std::array<Parameter, 3> hertz_point_parameters{{
    {.name = "load", .unit = "N"},
    {.name = "effective_modulus", .unit = "Pa"},
    {.name = "reduced_radius", .unit = "m"},
}};

constexpr std::array<Parameter, 7> hamrock_dowson_parameters{{
    {.name = "speed", .unit = "m/s"},
    {.name = "viscosity", .unit = "Pa·s"},
    {.name = "pressure_viscosity", .unit = "1/Pa"},
    {.name = "load", .unit = "N"},
    {.name = "effective_modulus", .unit = "Pa"},
    {.name = "reduced_radius", .unit = "m"},
    {.name = "ellipticity", .default_value = 1},
}};

constexpr std::array<Parameter, 3> starvation_ratio_parameters{{
    {.name = "closure", .words = closure_words},
    {.name = "flooded_over_inlet"},
    {.name = "damiens_exponent", .default_value = 3},
}};

constexpr std::array<Parameter, 4> load_sharing_parameters{{
    {.name = "asperity", .words = asperity_words},
    {.name = "flooded_film_parameter"},
    {.name = "stiffness", .range = Range::not_below_zero},
    {.name = "offset", .range = Range::not_below_zero},
}};

// In the order of the enumeration.
constexpr std::array<FunctionInfo, 5> functions{{
    {"gaussian_moment", gaussian_moment_parameters},
    {"hertz_point", hertz_point_parameters},
    {"hamrock_dowson_central", hamrock_dowson_parameters},
    {"starvation_ratio", starvation_ratio_parameters},
    {"load_sharing", load_sharing_parameters},
}};

std::string joined(Words words) {
  std::string text;
  for (const std::string_view word : words) {
    if (!text.empty()) text += ", ";
    text += word;
  }
  return text;
}

std::string allowed_text(const Parameter& parameter) {
  if (!parameter.words.empty()) return joined(parameter.words);
  std::string text = "a number";
  if (parameter.range == Range::above_zero) text += " above 0";
  if (parameter.range == Range::not_below_zero) text += " not below 0";
  if (parameter.range == Range::order) return "0, 0.5, 1, 1.5, 2 or 2.5";
  if (!parameter.unit.empty()) text += ", in " + std::string(parameter.unit);
  return text;
}

bool is_in_range(double number, Range range) {
  switch (range) {
    case Range::above_zero:
      return number > 0;
    case Range::not_below_zero:
      return number >= 0;
    case Range::order:
      return number >= 0 && number <= 2.5 && 2 * number == static_cast<int>(2 * number);
    case Range::any:
      return true;
  }
  return false;
}

// The place of a text among words; `words.size()` if it is not there.
std::size_t place_of(std::string_view text, Words words) {
  std::size_t place = 0;
  while (place < words.size() && words[place] != text) ++place;
  return place;
}

std::optional<double> word_argument(const Parameter& parameter, const FlatMember& member,
                                    std::string& complaint) {
  if (member.kind != FlatMember::Kind::text) {
    complaint = "this is no text";
    return std::nullopt;
  }
  const std::size_t place = place_of(member.text, parameter.words);
  if (place < parameter.words.size()) return static_cast<double>(place);
  complaint = '"' + printable(member.text) + "\" is not known";
  return std::nullopt;
}

std::optional<double> number_argument(const Parameter& parameter, const FlatMember& member,
                                      std::string& complaint) {
  if (member.kind != FlatMember::Kind::number)
    complaint = "this is no number";
  else if (!member.fault.empty())
    complaint = member.fault;
  else if (!is_in_range(member.number, parameter.range))
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

std::string parameter_names(const FunctionInfo& function) {
  std::string text;
  for (const Parameter& parameter : function.parameters) {
    if (!text.empty()) text += ", ";
    text += parameter.name;
  }
  return text;
}

bool is_known(const FunctionInfo& function, std::string_view name) {
  if (name == "id" || name == "function") return true;
  for (const Parameter& parameter : function.parameters)
    if (parameter.name == name) return true;
  return false;
}

std::optional<Mistake> mistake_in_names(const FunctionInfo& function, const FlatObject& object) {
  for (const FlatMember& member : object.members) {
    if (!is_known(function, member.name))
      return Mistake{printable(member.name),
                     "unknown argument; known: " + parameter_names(function)};
    if (object.find(member.name) != &member) return Mistake{member.name, "given twice"};
  }
  return std::nullopt;
}

std::optional<Mistake> read_arguments(const FunctionInfo& function, const FlatObject& object,
                                      FunctionArguments& arguments) {
  std::size_t place = 0;
  for (const Parameter& parameter : function.parameters) {
    std::string complaint;
    const std::optional<double> value = argument(parameter, object, complaint);
    if (!value)
      return Mistake{std::string(parameter.name),
                     complaint + "; allowed: " + allowed_text(parameter)};
    arguments[place++] = *value;
  }
  return std::nullopt;
}

const FunctionInfo* find_function(const FlatMember& member) {
  for (const FunctionInfo& function : functions)
    if (member.kind == FlatMember::Kind::text && member.text == function.name) return &function;
  return nullptr;
}

Mistake unknown_function(const FlatMember& member) {
  std::string message = member.kind == FlatMember::Kind::text
                            ? '"' + printable(member.text) + "\" is not known"
                            : "this is no text";
  const char* before = "; allowed: ";
  for (const FunctionInfo& function : functions) {
    message += before + std::string(function.name);
    before = ", ";
  }
  return {"function", message};
}

std::optional<Mistake> read_call(const FlatObject& object, FunctionCall& call) {
  const FlatMember& name = *object.find("function");
  const FunctionInfo* function = find_function(name);
  if (function == nullptr) return unknown_function(name);
  if (auto mistake = mistake_in_names(*function, object)) return mistake;
  call.function = static_cast<Function>(function - functions.data());
  return read_arguments(*function, object, call.arguments);
}

}  // namespace

std::string_view name(Function function) {
  return functions[static_cast<std::size_t>(function)].name;
}

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
