// SPDX-License-Identifier: Apache-2.0
// Reads the fields of a small table of a sweep file by name, each once. It reports, in one line
// each, fields that are wrong, unknown or missing.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/entries.hpp"
#include "scene/units.hpp"

namespace tribo::sweep {

// The entry of this path; null: there is none.
const scene_detail::Entry* entry_of(std::span<const scene_detail::Entry> entries,
                                    std::string_view path);

class TableReader {
 public:
  // `path` names the table in messages. `entries` and `problems` must outlive the reader.
  TableReader(std::string path, std::span<const scene_detail::Entry> entries,
              std::span<const std::string_view> names, scene_detail::Problems& problems);

  bool has(std::string_view name) const { return find(name) != nullptr; }

  // The number of a field, which may be a text with a unit that fits `unit`; nothing where the
  // field is absent or wrong. A wrong field is reported.
  std::optional<double> number(std::string_view name, std::string_view allowed,
                               std::string_view unit = "",
                               scene_detail::Measure measure = scene_detail::Measure::value);
  std::optional<std::uint64_t> whole(std::string_view name, std::uint64_t least,
                                     std::uint64_t greatest, std::string_view allowed);
  std::optional<bool> boolean(std::string_view name);
  std::optional<std::string> text(std::string_view name, std::string_view allowed);
  // The place of a field's word in `words`.
  std::optional<std::size_t> word(std::string_view name, std::span<const std::string_view> words);
  // The places of a field's list of words; no word may come twice.
  std::optional<std::vector<std::size_t>> words(std::string_view name,
                                                std::span<const std::string_view> words);
  // As number(), but a missing field is reported.
  std::optional<double> needed_number(std::string_view name, std::string_view allowed,
                                      std::string_view unit = "",
                                      scene_detail::Measure measure = scene_detail::Measure::value);

  void refuse(std::string_view name, Fault fault);
  bool good() const { return good_; }  // nothing has been reported yet

 private:
  const scene_detail::Entry* find(std::string_view name) const { return entry_of(entries_, name); }
  // The value of a field; null: it is absent, or reported because it is of another kind.
  const scene_detail::Value* value_of(std::string_view name, scene_detail::ValueKind kind,
                                      std::string_view allowed);
  std::optional<std::size_t> place(const scene_detail::Value& value, const std::string& name,
                                   std::span<const std::string_view> words);

  std::string path_;
  std::span<const scene_detail::Entry> entries_;
  scene_detail::Problems& problems_;
  bool good_ = true;
};

}  // namespace tribo::sweep
