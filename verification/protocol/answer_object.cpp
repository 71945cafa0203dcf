// SPDX-License-Identifier: Apache-2.0
#include "protocol/answer_object.hpp"

#include <fmt/compile.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "scene/text.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::protocol {
namespace {

bool is_plain(std::string_view text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return c >= 0x20 && c < 0x7F && c != '"' && c != '\\'; });
}

}  // namespace

void append_json_text(Text& to, std::string_view text) {
  if (!is_plain(text)) {
    using Json = nlohmann::json;
    append(to, without_controls(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace)));
    return;
  }
  to.push_back('"');
  append(to, text);
  to.push_back('"');
}

void append_number(Text& to, double number) {
  fmt::format_to(fmt::appender(to), FMT_COMPILE("{}"), number);
}

AnswerObject::AnswerObject(Text& to, std::optional<std::string_view> id) : to_(to) {
  append(to_, "{\"id\": ");
  if (id)
    append_json_text(to_, *id);
  else
    append(to_, "null");
}

void AnswerObject::start_member(std::string_view name) {
  append(to_, ", \"");
  append(to_, name);
  append(to_, "\": ");
}

void AnswerObject::number(std::string_view name, double value) {
  if (!std::isfinite(value)) return undefined(name, beyond_double);
  start_member(name);
  append_number(to_, value);
}

void AnswerObject::word(std::string_view name, std::string_view value) {
  start_member(name);
  append_json_text(to_, value);
}

void AnswerObject::undefined(std::string_view name, std::string_view reason) {
  start_member(name);
  append(to_, "null");
  if (undefined_count_ < undefined_.size()) undefined_[undefined_count_++] = {name, reason};
}

void AnswerObject::value(std::string_view name, const OutputValue& value) {
  if (!value.undefined.empty())
    undefined(name, value.undefined);
  else if (!value.word.empty())
    word(name, value.word);
  else
    number(name, value.number);
}

void AnswerObject::error(std::string_view field, std::string_view message) {
  append(to_, ", \"error\": {\"field\": ");
  append_json_text(to_, field);
  append(to_, ", \"message\": ");
  append_json_text(to_, message);
  to_.push_back('}');
}

void AnswerObject::close() {
  const char* before = ", \"undefined\": {";
  for (std::size_t i = 0; i < undefined_count_; ++i) {
    append(to_, before);
    append_json_text(to_, undefined_[i].name);
    append(to_, ": ");
    append_json_text(to_, undefined_[i].reason);
    before = ", ";
  }
  append(to_, undefined_count_ > 0 ? "}}" : "}");
}

}  // namespace tribo::protocol
