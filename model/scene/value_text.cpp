// SPDX-License-Identifier: Apache-2.0
#include "scene/value_text.hpp"

#include "scene/text.hpp"

namespace tribo::scene_detail {
namespace {

std::string kind_name(ValueKind kind) {
  switch (kind) {
    case ValueKind::number:
      return "a number";
    case ValueKind::text:
      return "a text";
    case ValueKind::boolean:
      return "a boolean";
    case ValueKind::null:
      return "null";
    case ValueKind::date_time:
      return "a date or time";
    case ValueKind::list:
      return "a list";
    case ValueKind::table:
      return "a table";
  }
  return {};
}

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

std::string what_came(const Value& value) {
  const std::string text = value_text(value);
  if (text.empty()) return "this is " + kind_name(value.kind);
  return text + " is " + kind_name(value.kind);
}

}  // namespace tribo::scene_detail
