// SPDX-License-Identifier: Apache-2.0
#include "sweep/table_reader.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/schema.hpp"
#include "scene/value_text.hpp"

namespace tribo::sweep {

using scene_detail::Entry;
using scene_detail::NumberFault;
using scene_detail::Value;
using scene_detail::value_text;
using scene_detail::ValueKind;
using scene_detail::what_came;

namespace {

std::string joined(std::span<const std::string_view> words) {
  std::string text;
  for (const std::string_view word : words) {
    if (!text.empty()) text += ", ";
    text += word;
  }
  return text;
}

std::string did_you_mean(std::string_view word, std::span<const std::string_view> words) {
  const std::string_view nearest = scene_detail::nearest_choice(word, words);
  return nearest.empty() ? "" : "; did you mean " + std::string(nearest) + "?";
}

}  // namespace

TableReader::TableReader(std::string path, std::span<const Entry> entries,
                         std::span<const std::string_view> names, scene_detail::Problems& problems)
    : path_(std::move(path)), entries_(entries), problems_(problems) {
  for (const Entry& entry : entries_) {
    if (std::find(names.begin(), names.end(), entry.path) != names.end()) continue;
    const std::string hint = did_you_mean(entry.path, names);
    problems_.error(path_of(entry.path),
                    "unknown field" + (hint.empty() ? "; known here: " + joined(names) : hint));
    good_ = false;
  }
}

const Entry* TableReader::find(std::string_view name) const {
  for (const Entry& entry : entries_)
    if (entry.path == name) return &entry;
  return nullptr;
}

void TableReader::refuse(std::string_view name, const std::string& what, std::string_view allowed) {
  problems_.error(path_of(name), what + "; allowed: " + std::string(allowed));
  good_ = false;
}

std::optional<double> TableReader::number(std::string_view name, std::string_view allowed) {
  const Entry* const entry = find(name);
  if (entry == nullptr) return std::nullopt;
  const Value& value = entry->value;
  if (value.kind != ValueKind::number) {
    refuse(name, what_came(value), allowed);
  } else if (value.fault != NumberFault::none || !std::isfinite(value.number)) {
    refuse(name, value_text(value) + " is not a finite double", allowed);
  } else {
    return value.number;
  }
  return std::nullopt;
}

std::optional<double> TableReader::needed_number(std::string_view name, std::string_view allowed) {
  if (find(name) == nullptr) refuse(name, "missing", allowed);
  return number(name, allowed);
}

std::optional<std::uint64_t> TableReader::whole(std::string_view name, std::uint64_t least,
                                                std::uint64_t greatest, std::string_view allowed) {
  const auto value = number(name, allowed);
  if (!value) return std::nullopt;
  if (std::trunc(*value) == *value && *value >= static_cast<double>(least) &&
      *value <= static_cast<double>(greatest))
    return static_cast<std::uint64_t>(*value);
  refuse(name, value_text(find(name)->value) + " is not allowed", allowed);
  return std::nullopt;
}

std::optional<bool> TableReader::boolean(std::string_view name) {
  const Entry* const entry = find(name);
  if (entry == nullptr) return std::nullopt;
  if (entry->value.kind == ValueKind::boolean) return entry->value.number != 0;
  refuse(name, what_came(entry->value), "true or false");
  return std::nullopt;
}

std::optional<std::string> TableReader::text(std::string_view name, std::string_view allowed) {
  const Entry* const entry = find(name);
  if (entry == nullptr) return std::nullopt;
  if (entry->value.kind == ValueKind::text) return entry->value.text;
  refuse(name, what_came(entry->value), allowed);
  return std::nullopt;
}

std::optional<std::size_t> TableReader::place(const Value& value, const std::string& path,
                                              std::span<const std::string_view> words) {
  const auto found = value.kind == ValueKind::text
                         ? std::find(words.begin(), words.end(), value.text)
                         : words.end();
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  const bool is_text = value.kind == ValueKind::text;
  problems_.error(path, (is_text ? value_text(value) + " is not known" : what_came(value)) +
                            "; allowed: " + joined(words) +
                            (is_text ? did_you_mean(value.text, words) : ""));
  good_ = false;
  return std::nullopt;
}

std::optional<std::size_t> TableReader::word(std::string_view name,
                                             std::span<const std::string_view> words) {
  const Entry* const entry = find(name);
  return entry == nullptr ? std::nullopt : place(entry->value, path_of(name), words);
}

std::optional<std::vector<std::size_t>> TableReader::words(
    std::string_view name, std::span<const std::string_view> words) {
  const Entry* const entry = find(name);
  if (entry == nullptr) return std::nullopt;
  if (entry->value.kind != ValueKind::list || entry->elements.empty()) {
    refuse(name,
           entry->value.kind == ValueKind::list ? "the list is empty" : what_came(entry->value),
           "a list of " + joined(words));
    return std::nullopt;
  }
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < entry->elements.size(); ++i) {
    const std::string path = path_of(name) + '[' + std::to_string(i) + ']';
    const auto found = place(entry->elements[i], path, words);
    if (!found) continue;
    if (std::find(places.begin(), places.end(), *found) != places.end()) {
      problems_.error(path, value_text(entry->elements[i]) + " is given twice; allowed: each once");
      good_ = false;
    }
    places.push_back(*found);
  }
  return places;
}

}  // namespace tribo::sweep
