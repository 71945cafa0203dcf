// SPDX-License-Identifier: Apache-2.0
#include "scene/fault_text.hpp"

#include <array>
#include <utility>

#include "scene/schema.hpp"
#include "scene/text.hpp"

namespace tribo {
namespace scene_detail {
namespace {

// In the order of ValueKind.
constexpr auto kind_names = std::to_array<const char*>(
    {"a number", "a text", "a boolean", "null", "a date or time", "a list", "a table"});

// The sentence of a rule: the value if `tells_value`, then `words`, then the fault's `what`.
struct Clause {
  bool tells_value;
  std::string_view words;
};

// In the order of the rules.
constexpr std::array<Clause, Fault::reach + 1> clauses{{
    {false, ""},
    {false, "unknown "},
    {false, "given twice"},
    {false, "missing"},
    {false, "given beside "},
    {true, " is "},
    {true, " is not known"},
    {true, " is given twice"},
    {false, "the list is empty"},
    {true, " is beyond 1.8e308; it must be finite"},
    {true, " underflows: it is nearer to 0 than 4.9e-324"},
    {true, " is not allowed: it must be finite"},
    {true, " is not whole"},
    {true, " is not allowed"},
    {false, ""},
    {true, " is not allowed"},
    {true, ""},
}};

}  // namespace

std::string value_text(const Value& value) {
  switch (value.kind) {
    case ValueKind::number:
      return value.fault == NumberFault::none ? number_text(value.number) : printable(value.text);
    case ValueKind::text:
      return '"' + printable(value.text) + '"';
    case ValueKind::boolean:
      return value.number == 0 ? "false" : "true";
    default:
      return {};
  }
}

Fault wrong_kind(const Value& value, std::string allowed) {
  return {Fault::kind, value_text(value), kind_names[static_cast<std::size_t>(value.kind)],
          std::move(allowed)};
}

Fault unknown_word(const Value& value, std::span<const std::string_view> words,
                   std::string allowed) {
  return {Fault::word, value_text(value), "", std::move(allowed),
          std::string(nearest_choice(value.text, words))};
}

Fault repeated(const Value& value) {
  return {Fault::repetition, value_text(value), "", "each once"};
}

std::string sentence(std::string_view field, const Fault& fault) {
  const auto& [tells_value, words] = clauses[fault.rule];
  std::string text = fault.where;
  if (tells_value) text += fault.value.empty() ? "this" : fault.value;
  text += words;
  if (fault.rule == Fault::reach)
    text += "; " + std::string(last_part(field)) + " must be " + fault.allowed;
  text += fault.what;
  if (fault.rule == Fault::unknown && !fault.value.empty()) text += " (" + fault.value + ")";
  if (fault.rule != Fault::reach && !fault.allowed.empty())
    text += (fault.rule == Fault::unknown ? "; known here: " : "; allowed: ") + fault.allowed;
  if (!fault.nearest.empty()) text += "; did you mean " + fault.nearest + "?";
  return text;
}

}  // namespace scene_detail

std::string InputProblem::message() const {
  constexpr std::size_t longest = 800;
  return printable(scene_detail::sentence(field, fault), longest);
}

std::string InputProblem::line() const {
  std::string text = source;
  if (row > 0) text += ':' + std::to_string(row) + ':' + std::to_string(column);
  if (!field.empty()) text += ": " + field;
  return text + ": " + message();
}

}  // namespace tribo
