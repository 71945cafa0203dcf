// SPDX-License-Identifier: Apache-2.0
// JSON to entries, by nlohmann's event parser, which has no recursion to overflow and reports every
// key, also those given twice.
//
// The parser stops at a number beyond the range of double. It is replaced by 0 and remembered, and
// the text is parsed again. So its field is named, and other problems are found.
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "scene/entries.hpp"
#include "scene/schema.hpp"
#include "scene/text.hpp"

namespace tribo {
namespace scene_detail {
namespace {

using Json = nlohmann::json;

struct Overflow {
  std::size_t number;  // the place of the number among all numbers of the text, from 0
  std::string written;
};

// The parser's events, put into entries.
class EntryCollector {
 public:
  EntryCollector(const std::vector<Overflow>& overflows, std::size_t most_fields)
      : overflows_(overflows), most_fields_(most_fields) {
    entries_.reserve(32);
  }

  // The results, once the text is parsed.
  std::vector<Entry>& entries() { return entries_; }
  const std::string& complaint() const { return complaint_; }
  std::size_t complaint_position() const { return position_; }
  bool overflowed() const { return overflowed_; }
  const std::string& last_token() const { return last_token_; }
  std::size_t numbers() const { return numbers_; }
  std::string path() const {
    if (section_.empty()) return key_;
    return section_ + '.' + key_;
  }

  // --- Called by the parser; false stops it.

  bool null() { return take({.kind = ValueKind::null, .text = {}}); }
  bool boolean(bool value) {
    return take({.kind = ValueKind::boolean, .number = value ? 1.0 : 0.0, .text = {}});
  }
  bool number_integer(Json::number_integer_t value) {
    return take_number(static_cast<double>(value));
  }
  bool number_unsigned(Json::number_unsigned_t value) {
    return take_number(static_cast<double>(value));
  }
  bool number_float(double value, const std::string& written) {
    if (value == 0 && has_nonzero_digit(written)) {
      ++numbers_;
      return take({.kind = ValueKind::number, .fault = NumberFault::underflow, .text = written});
    }
    return take_number(value);
  }
  bool string(std::string& value) {
    return take({.kind = ValueKind::text, .text = std::move(value)});
  }
  bool binary(Json::binary_t&) { return false; }  // no such thing in text

  bool start_object(std::size_t) {
    if (!go_deeper()) return false;
    if (depth_ == 1 || skipping()) return true;
    const bool section = depth_ == 2 && is_section(key_);
    if (!take({.kind = ValueKind::table, .text = {}})) return false;
    if (section)
      section_ = key_;
    else
      skip_from_ = depth_;
    return true;
  }
  bool key(std::string& name) {
    if (!skipping()) key_ = path_part(name);
    return true;
  }
  bool end_object() {
    if (depth_ == 2 && !skipping()) section_.clear();
    return go_up();
  }

  bool start_array(std::size_t) {
    if (depth_ == 0) return complain(not_an_object);
    if (!go_deeper()) return false;
    if (skipping()) return true;
    if (!take({.kind = ValueKind::list, .text = {}})) return false;
    if (levels_of_lists_ == 2) {
      skip_from_ = depth_;
      return true;
    }
    if (++levels_of_lists_ == 2) {
      Entry& list = entries_.back();
      list.inner.push_back({'[' + std::to_string(list.elements.size() - 1) + ']',
                            {.kind = ValueKind::list, .text = {}},
                            {}});
    }
    return true;
  }
  bool end_array() {
    if (!skipping()) --levels_of_lists_;
    return go_up();
  }

  bool parse_error(std::size_t position, const std::string& last_token,
                   const Json::exception& error) {
    constexpr int number_overflow = 406;
    position_ = position;
    last_token_ = last_token;
    overflowed_ = error.id == number_overflow;
    const std::string what = error.what();
    const std::size_t start = what.find("syntax error");
    return complain("not JSON: " + what.substr(start == std::string::npos ? 0 : start));
  }

  static constexpr const char* not_an_object = "a scene in JSON is an object, { … }";

 private:
  bool skipping() const { return skip_from_ != 0; }

  bool go_deeper() {
    if (++depth_ <= max_depth) return true;
    return complain(std::string(too_deep_text));
  }

  bool go_up() {
    if (skip_from_ == depth_) skip_from_ = 0;
    --depth_;
    return true;
  }

  bool complain(std::string text) {
    complaint_ = std::move(text);
    return false;
  }

  static bool has_nonzero_digit(const std::string& number) {
    for (const char c : number) {
      if (c == 'e' || c == 'E') return false;
      if (c >= '1' && c <= '9') return true;
    }
    return false;
  }

  bool take_number(double number) {
    const std::size_t place = numbers_++;
    for (const Overflow& overflow : overflows_)
      if (overflow.number == place)
        return take(
            {.kind = ValueKind::number, .fault = NumberFault::overflow, .text = overflow.written});
    return take({.kind = ValueKind::number, .number = number, .text = {}});
  }

  bool take(Value value) {
    if (depth_ == 0) return complain(not_an_object);
    if (skipping()) return true;
    if (levels_of_lists_ > 0) {
      Entry& list = levels_of_lists_ == 1 ? entries_.back() : entries_.back().inner.back();
      list.elements.push_back(std::move(value));
      return true;
    }
    if (entries_.size() == most_fields_) return complain(std::string(too_many_fields_text));
    entries_.push_back({path(), std::move(value), {}});
    return true;
  }

  const std::vector<Overflow>& overflows_;
  std::size_t most_fields_;
  std::vector<Entry> entries_;
  std::string key_, section_;
  std::size_t depth_ = 0;
  std::size_t skip_from_ = 0;  // depth of the table or list whose content is skipped; 0: none
  int levels_of_lists_ = 0;    // open lists; 1: the last entry, 2: its last inner entry, too
  std::size_t numbers_ = 0;
  std::string complaint_, last_token_;
  std::size_t position_ = 0;
  bool overflowed_ = false;
};

struct Place {
  std::size_t row = 1;
  std::size_t column = 1;
};

// Row and column of the last sign of text[0, bytes).
Place place_of(std::string_view text, std::size_t bytes) {
  Place place;
  for (std::size_t at = 0; at + 1 < bytes && at < text.size(); ++at) {
    if (text[at] == '\n')
      place = {place.row + 1, 1};
    else if ((static_cast<unsigned char>(text[at]) & 0xC0) != 0x80)
      ++place.column;
  }
  return place;
}

bool starts_like_infinity_or_nan(std::string_view text, std::size_t bytes) {
  const std::size_t last_sign = std::min(bytes, text.size());
  std::size_t start = last_sign;
  while (start > 0 && last_sign - start < 12 && text[start - 1] != ':' && text[start - 1] != ',' &&
         text[start - 1] != '[')
    --start;
  std::string_view token = text.substr(start, 20);
  while (!token.empty() && (token.front() == ' ' || token.front() == '-' || token.front() == '+'))
    token.remove_prefix(1);
  constexpr auto words =
      std::to_array<std::string_view>({"NaN", "nan", "NAN", "Inf", "inf", "INF"});
  for (const std::string_view word : words)
    if (token.starts_with(word)) return true;
  return false;
}

void report(const EntryCollector& collector, std::string_view text, Problems& problems) {
  const std::size_t bytes = collector.complaint_position();
  if (bytes == 0) return problems.error("", {.what = collector.complaint()});
  const Place place = place_of(text, bytes);
  if (starts_like_infinity_or_nan(text, bytes))
    return problems.error_at(place.row, place.column, collector.path(),
                             {.what = "NaN and infinity are not JSON; a number must be finite"});
  problems.error_at(place.row, place.column, "", {.what = collector.complaint()});
}

// Replaces the number that the collector stopped at by 0 and blanks; false if it cannot.
bool mend_overflow(const EntryCollector& collector, std::string& text,
                   std::vector<Overflow>& overflows) {
  constexpr std::size_t most = 32;
  const std::string& token = collector.last_token();
  const std::size_t end = collector.complaint_position();
  if (!collector.overflowed() || overflows.size() == most || token.size() > end) return false;
  const std::size_t start = end - token.size();
  if (text.compare(start, token.size(), token) != 0) return false;
  text.replace(start, token.size(), '0' + std::string(token.size() - 1, ' '));
  overflows.push_back({collector.numbers(), token});
  return true;
}

}  // namespace

std::optional<std::vector<Entry>> json_entries(std::string_view text, Problems& problems,
                                               std::size_t most_fields) {
  if (const std::string refusal = too_large_text(text.size()); !refusal.empty()) {
    problems.error("", {.what = refusal});
    return std::nullopt;
  }
  std::vector<Overflow> overflows;
  std::string mended;
  for (;;) {
    EntryCollector collector(overflows, most_fields);
    if (Json::sax_parse(text.begin(), text.end(), &collector))
      return std::move(collector.entries());
    if (mended.empty()) mended = text;
    if (!mend_overflow(collector, mended, overflows)) {
      report(collector, text, problems);
      return std::nullopt;
    }
    text = mended;
  }
}

}  // namespace scene_detail

SceneReading parse_scene_json(std::string_view text, std::string_view source, SceneUse use,
                              std::span<const std::string_view> outputs) {
  SceneReading reading;
  scene_detail::Problems problems(reading, source);
  auto entries = scene_detail::json_entries(text, problems);
  if (!entries) return reading;
  scene_detail::put_outputs(outputs, *entries);
  scene_detail::bind_scene(*entries, use, problems, reading);
  return reading;
}

}  // namespace tribo
