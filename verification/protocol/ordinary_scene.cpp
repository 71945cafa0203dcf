// SPDX-License-Identifier: Apache-2.0
// Reads a line with simdjson in place of the model's JSON parser, into the model's own entries.
#include "protocol/ordinary_scene.hpp"

#include <simdjson.h>

#include <array>
#include <cstddef>

#include "scene/schema.hpp"

namespace tribo::protocol {
namespace {

namespace dom = simdjson::dom;
using scene_detail::Entry;
using scene_detail::Value;
using scene_detail::ValueKind;

// The memory kept from line to line grows with both limits; a scene needs less than either.
constexpr std::size_t most_bytes = 4096;
constexpr std::size_t most_entries = 64;

// May a number of the line be nearer to 0 than 4.9e-324? Such a number has an exponent of at least
// three digits, or more than a hundred digits.
bool may_underflow(std::string_view line) {
  std::size_t digits = 0;  // in a row, with the point
  bool negative_exponent = false;
  for (std::size_t at = 0; at < line.size(); ++at) {
    const char c = line[at];
    if ((c >= '0' && c <= '9') || c == '.') {
      ++digits;
      if (digits > 100 || (negative_exponent && digits == 3)) return true;
      continue;
    }
    digits = 0;
    negative_exponent = c == '-' && at > 0 && (line[at - 1] == 'e' || line[at - 1] == 'E');
  }
  return false;
}

class OrdinaryReader {
 public:
  explicit OrdinaryReader(bool is_of_scenes) : is_of_scenes_(is_of_scenes) {}

  bool read(std::string_view line) {
    count_ = 0;
    if (line.size() > most_bytes) return false;
    dom::object scene;
    if (parser_.parse(line.data(), line.size()).get(scene) != simdjson::SUCCESS) return false;
    zero_ = false;
    for (const auto& [name, element] : scene)
      if (!take(name, element)) return false;
    return !zero_ || !may_underflow(line);
  }

  std::span<const Entry> entries() const { return {entries_.data(), count_}; }

 private:
  bool take(std::string_view name, const dom::element& element) {
    dom::object section;
    // json_entries() puts a name with a point or a quote in quotes, and escapes it.
    for (const char sign : {'.', '"'})
      if (name.find(sign) != std::string_view::npos) return false;
    if (element.get(section) != simdjson::SUCCESS) return take_field("", name, element);
    if (!is_of_scenes_ || !scene_detail::is_section(name)) return false;
    Entry* const entry = next_entry();
    if (entry == nullptr) return false;
    set_path(*entry, "", name);
    entry->value.kind = ValueKind::table;
    for (const auto& [inner_name, inner] : section)
      if (!take_field(name, inner_name, inner)) return false;
    return true;
  }

  bool take_field(std::string_view section, std::string_view name, const dom::element& element) {
    Entry* const entry = next_entry();
    if (entry == nullptr) return false;
    set_path(*entry, section, name);
    if (!is_of_scenes_) return take_value(element, entry->value);
    if (!entry->field) return false;
    dom::array list;
    if (element.get(list) != simdjson::SUCCESS) return take_value(element, entry->value);
    entry->value.kind = ValueKind::list;
    for (const dom::element& part : list)
      if (!take_value(part, entry->elements.emplace_back())) return false;
    return true;
  }

  // Successive lines mostly have the same names in the same order. The entry then still has this
  // path and its field from the line before.
  void set_path(Entry& entry, std::string_view section, std::string_view name) const {
    const std::string_view path = entry.path;
    const std::size_t start = section.empty() ? 0 : section.size() + 1;
    if (path.size() == start + name.size() && path.substr(start) == name &&
        path.starts_with(section) && (start == 0 || path[start - 1] == '.'))
      return;
    entry.path = section;
    if (!section.empty()) entry.path += '.';
    entry.path += name;
    if (is_of_scenes_) entry.field = scene_detail::find_field(entry.path);
  }

  bool take_value(const dom::element& element, Value& value) {
    switch (element.type()) {
      case dom::element_type::DOUBLE:
        value.kind = ValueKind::number;
        value.number = element.get_double().value_unsafe();
        zero_ = zero_ || value.number == 0;  // 0 or an underflow: simdjson does not say
        return true;
      case dom::element_type::INT64:
        value.kind = ValueKind::number;
        value.number = static_cast<double>(element.get_int64().value_unsafe());
        return true;
      case dom::element_type::STRING:
        value.kind = ValueKind::text;
        value.text = element.get_string().value_unsafe();
        return true;
      default:
        return false;
    }
  }

  Entry* next_entry() {
    if (count_ == entries_.size()) return nullptr;
    Entry& entry = entries_[count_++];
    entry.value.number = 0;
    entry.value.text.clear();
    entry.elements.clear();
    return &entry;
  }

  bool is_of_scenes_;
  dom::parser parser_;
  std::array<Entry, most_entries> entries_;  // their texts and lists keep their memory
  std::size_t count_ = 0;                    // entries of this line
  bool zero_ = false;                        // is there a 0.0 among them?
};

}  // namespace

std::optional<SceneReading> read_ordinary_scene(std::string_view line, std::string_view source) {
  thread_local OrdinaryReader reader(true);
  if (!reader.read(line)) return std::nullopt;
  std::optional<SceneReading> reading(std::in_place);
  scene_detail::Problems problems(*reading, source);
  bind_scene(reader.entries(), SceneUse::one_speed, problems, *reading);
  return reading;
}

std::optional<std::span<const Entry>> ordinary_members(std::string_view line) {
  thread_local OrdinaryReader reader(false);
  return reader.read(line) ? std::optional(reader.entries()) : std::nullopt;
}

}  // namespace tribo::protocol
