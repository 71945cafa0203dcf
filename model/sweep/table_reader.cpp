// SPDX-License-Identifier: Apache-2.0
#include "sweep/table_reader.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/fault_text.hpp"
#include "scene/schema.hpp"

namespace tribo::sweep {

using scene_detail::Entry;
using scene_detail::NumberFault;
using scene_detail::Value;
using scene_detail::value_text;
using scene_detail::ValueKind;
using scene_detail::wrong_kind;

namespace {

std::string list_of(std::span<const std::string_view> words) {
  return scene_detail::joined(words, ", ");
}

}  // namespace

TableReader::TableReader(std::string path, std::span<const Entry> entries,
                         std::span<const std::string_view> names, scene_detail::Problems& problems)
    : path_(std::move(path)), entries_(entries), problems_(problems) {
  for (const Entry& entry : entries_) {
    if (std::find(names.begin(), names.end(), entry.path) != names.end()) continue;
    const std::string_view nearest = scene_detail::nearest_choice(entry.path, names);
    refuse(entry.path, {Fault::unknown, "", "field", nearest.empty() ? list_of(names) : "",
                        std::string(nearest)});
  }
}

const Entry* entry_of(std::span<const Entry> entries, std::string_view path) {
  const auto found = std::ranges::find(entries, path, &Entry::path);
  return found == entries.end() ? nullptr : &*found;
}

void TableReader::refuse(std::string_view name, Fault fault) {
  problems_.error(path_ + '.' + std::string(name), std::move(fault));
  good_ = false;
}

const Value* TableReader::value_of(std::string_view name, ValueKind kind,
                                   std::string_view allowed) {
  const Entry* const entry = find(name);
  if (entry == nullptr || entry->value.kind == kind)
    return entry == nullptr ? nullptr : &entry->value;
  refuse(name, wrong_kind(entry->value, std::string(allowed)));
  return nullptr;
}

std::optional<double> TableReader::number(std::string_view name, std::string_view allowed,
                                          std::string_view unit, scene_detail::Measure measure) {
  const Entry* const entry = find(name);
  if (entry == nullptr) return std::nullopt;
  const Value value = scene_detail::in_si(entry->value, unit, measure);
  if (value.kind != ValueKind::number) {
    refuse(name, scene_detail::no_number(value, unit, std::string(allowed)));
    return std::nullopt;
  }
  if (value.fault == NumberFault::none && std::isfinite(value.number)) return value.number;
  refuse(name,
         {Fault::other, "", value_text(value) + " is not a finite double", std::string(allowed)});
  return std::nullopt;
}

std::optional<double> TableReader::needed_number(std::string_view name, std::string_view allowed,
                                                 std::string_view unit,
                                                 scene_detail::Measure measure) {
  if (!has(name)) refuse(name, {Fault::presence, "", "", std::string(allowed)});
  return number(name, allowed, unit, measure);
}

std::optional<std::uint64_t> TableReader::whole(std::string_view name, std::uint64_t least,
                                                std::uint64_t greatest, std::string_view allowed) {
  const auto value = number(name, allowed);
  if (!value) return std::nullopt;
  if (std::trunc(*value) == *value && *value >= static_cast<double>(least) &&
      *value <= static_cast<double>(greatest))
    return static_cast<std::uint64_t>(*value);
  refuse(name, {Fault::range, value_text(find(name)->value), "", std::string(allowed)});
  return std::nullopt;
}

std::optional<bool> TableReader::boolean(std::string_view name) {
  const Value* const value = value_of(name, ValueKind::boolean, "true or false");
  return value == nullptr ? std::nullopt : std::optional(value->number != 0);
}

std::optional<std::string> TableReader::text(std::string_view name, std::string_view allowed) {
  const Value* const value = value_of(name, ValueKind::text, allowed);
  return value == nullptr ? std::nullopt : std::optional(value->text);
}

std::optional<std::size_t> TableReader::place(const Value& value, const std::string& name,
                                              std::span<const std::string_view> words) {
  const auto found = value.kind == ValueKind::text
                         ? std::find(words.begin(), words.end(), value.text)
                         : words.end();
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  refuse(name, value.kind == ValueKind::text
                   ? scene_detail::unknown_word(value, words, list_of(words))
                   : wrong_kind(value, list_of(words)));
  return std::nullopt;
}

std::optional<std::size_t> TableReader::word(std::string_view name,
                                             std::span<const std::string_view> words) {
  const Entry* const entry = find(name);
  return entry == nullptr ? std::nullopt : place(entry->value, std::string(name), words);
}

std::optional<std::vector<std::size_t>> TableReader::words(
    std::string_view name, std::span<const std::string_view> words) {
  const Entry* const entry = find(name);
  if (entry == nullptr) return std::nullopt;
  if (entry->value.kind != ValueKind::list || entry->elements.empty()) {
    const std::string allowed = "a list of " + list_of(words);
    refuse(name, entry->value.kind == ValueKind::list ? Fault{Fault::emptiness, "", "", allowed}
                                                      : wrong_kind(entry->value, allowed));
    return std::nullopt;
  }
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < entry->elements.size(); ++i) {
    const std::string element = std::string(name) + '[' + std::to_string(i) + ']';
    const auto found = place(entry->elements[i], element, words);
    if (!found) continue;
    if (std::find(places.begin(), places.end(), *found) != places.end())
      refuse(element, scene_detail::repeated(entry->elements[i]));
    places.push_back(*found);
  }
  return places;
}

}  // namespace tribo::sweep
