// SPDX-License-Identifier: Apache-2.0
// A group of report.json: the numbers of one part of the page, computed and judged once.
// groups/report.py makes the others, and joins them.
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "page/data_file.hpp"

namespace tribo::report {

using Json = nlohmann::ordered_json;

// null where there is no number. JSON has no NaN and no infinity: they are written as null too.
inline Json number(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

enum class Standing : std::uint8_t {
  holds,     // agrees, within what is declared
  differs,   // does not agree with what the paper reports, or agrees in part
  fails,     // a promise of this software is broken
  missed,    // a target that this software sets itself is not reached
  measured,  // a result, neither good nor bad
  absent,    // not known: its source is missing, or it was not run
};
// In the order of the enumeration.
inline constexpr std::array<std::string_view, 6> standing_words{"holds",  "differs",  "fails",
                                                                "missed", "measured", "absent"};
enum class About : std::uint8_t { paper, software };

// A line at the top of the page. Its sentence stands in the section's template, as finding_<id>.
struct Finding {
  std::string id;
  std::string section;
  About about;
  Standing standing;
  std::string why = {};  // one plain sentence where the template has none: what is wrong or missing
};

struct NotRun {
  std::string what;
  std::string why;
  std::string how_to;  // Markdown: the command that gives it
};

struct Group {
  Json data = Json::object();
  std::vector<Finding> findings = {};
  std::vector<NotRun> not_run = {};
  std::vector<DataFile> files = {};  // below the report's folder: what figures are drawn from
};

}  // namespace tribo::report
