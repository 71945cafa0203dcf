// SPDX-License-Identifier: Apache-2.0
#include "protocol/flat_json.hpp"

#include <simdjson.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "scene/entries.hpp"

namespace tribo::protocol {
namespace {

using Json = nlohmann::json;

// A number over 1.8e308, at which the parser stops.
struct Overflow {
  std::string member;
  std::string written;
};

// nlohmann's parser calls these; false stops it. It has no recursion that depth could overflow.
class Collector {
 public:
  explicit Collector(const std::vector<Overflow>& known) : known_(known) {}

  FlatObject object;
  std::optional<Overflow> overflow;  // a new one
  std::size_t position = 0;          // where it ends

  bool null() { return take({}, FlatMember::Kind::other); }
  bool boolean(bool) { return take({}, FlatMember::Kind::other); }
  bool number_integer(Json::number_integer_t value) { return number(static_cast<double>(value)); }
  bool number_unsigned(Json::number_unsigned_t value) { return number(static_cast<double>(value)); }
  bool number_float(double value, const std::string& written) {
    const std::size_t exponent = std::min(written.find_first_of("eE"), written.size());
    const bool is_zero = written.find_first_of("123456789") >= exponent;
    if (value != 0 || is_zero) return number(value);
    return faulty_number(" underflows: it is nearer to 0 than 4.9e-324", written);
  }
  bool string(std::string& value) {
    FlatMember member;
    member.text = std::move(value);
    return take(std::move(member), FlatMember::Kind::text);
  }
  bool binary(Json::binary_t&) { return false; }  // no such thing in text

  bool start_object(std::size_t) { return start(); }
  bool start_array(std::size_t) { return depth_ > 0 && start(); }
  bool end_object() { return end(); }
  bool end_array() { return end(); }
  bool key(std::string& name) {
    if (depth_ == 1) name_ = std::move(name);
    return true;
  }

  bool parse_error(std::size_t bytes, const std::string& last_token, const Json::exception& error) {
    constexpr int number_overflow = 406;
    if (error.id != number_overflow) return false;
    overflow = {name_, last_token};
    position = bytes;
    return false;
  }

 private:
  bool start() {
    if (depth_ == 1) take({}, FlatMember::Kind::other);
    return ++depth_ <= scene_detail::max_depth;
  }
  bool end() {
    --depth_;
    return true;
  }
  bool number(double value) {
    for (const Overflow& known : known_)
      if (known.member == name_)
        return faulty_number(" is beyond 1.8e308; it must be finite", known.written);
    FlatMember member;
    member.number = value + 0.0;  // −0 becomes 0
    return take(std::move(member), FlatMember::Kind::number);
  }
  bool faulty_number(const char* fault, const std::string& written) {
    FlatMember member;
    member.fault = written.substr(0, 40) + fault;
    return take(std::move(member), FlatMember::Kind::number);
  }
  bool take(FlatMember member, FlatMember::Kind kind) {
    if (depth_ == 0) return false;  // a number or text alone
    if (depth_ > 1) return true;
    member.name = name_;
    member.kind = kind;
    object.members.push_back(std::move(member));
    return true;
  }

  const std::vector<Overflow>& known_;
  std::string name_;
  std::size_t depth_ = 0;
};

// A line without oddities, by simdjson; nothing where there may be one: a number of which simdjson
// does not say whether it underflows, something nested, or no JSON at all.
std::optional<FlatObject> parse_plain(std::string_view text) {
  constexpr std::size_t most_bytes = 4096;  // what is kept from line to line grows with it
  thread_local simdjson::dom::parser parser;
  simdjson::dom::object object;
  if (text.size() > most_bytes ||
      parser.parse(text.data(), text.size()).get(object) != simdjson::SUCCESS)
    return std::nullopt;
  std::optional<FlatObject> flat(std::in_place);
  for (const auto& [name, element] : object) {
    FlatMember& member = flat->members.emplace_back();
    member.name = name;
    std::string_view word;
    if (element.get(word) == simdjson::SUCCESS) {
      member.kind = FlatMember::Kind::text;
      member.text = word;
    } else if (element.get(member.number) == simdjson::SUCCESS) {
      member.kind = FlatMember::Kind::number;
      if (member.number == 0 && !element.is_int64()) return std::nullopt;
    } else {
      return std::nullopt;
    }
  }
  return flat;
}

// Puts a 0 of equal length where the number stands; false if it is not found there.
bool mend(std::string& text, std::size_t end, const std::string& written) {
  if (written.size() > end || end > text.size()) return false;
  const std::size_t start = end - written.size();
  if (text.compare(start, written.size(), written) != 0) return false;
  text.replace(start, written.size(), '0' + std::string(written.size() - 1, ' '));
  return true;
}

}  // namespace

const FlatMember* FlatObject::find(std::string_view name) const {
  for (const FlatMember& member : members)
    if (member.name == name) return &member;
  return nullptr;
}

std::optional<FlatObject> parse_flat_json(std::string_view text) {
  if (std::optional<FlatObject> plain = parse_plain(text)) return plain;
  constexpr std::size_t most_overflows = 16;
  std::vector<Overflow> overflows;
  std::string mended;
  for (;;) {
    Collector collector(overflows);
    if (Json::sax_parse(text.begin(), text.end(), &collector)) return std::move(collector.object);
    if (!collector.overflow || overflows.size() == most_overflows) return std::nullopt;
    if (mended.empty()) mended = text;
    if (!mend(mended, collector.position, collector.overflow->written)) return std::nullopt;
    overflows.push_back(*collector.overflow);
    text = mended;
  }
}

}  // namespace tribo::protocol
