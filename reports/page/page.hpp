// SPDX-License-Identifier: Apache-2.0
// The report as one page, in HTML, in Markdown and as JSON: a verdict collected from the sections,
// the sections in order, what did not run collected from them too, and the files of data.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "page/section.hpp"

namespace tribo::report {

struct Page {
  std::string title;
  std::vector<std::string> introduction;  // paragraphs of markup
  std::vector<Section> sections;          // the environment, then in order
};

inline constexpr std::string_view verdict_id = "verdict";

struct PlacedVerdict {
  Verdict verdict;
  std::string section;  // its id
};

// Promises that are broken, then all else in the order of the sections, and last what did not run.
std::vector<PlacedVerdict> verdicts(const Page& page);

// “Of 11 findings 7 hold, …”: markup, above the verdicts.
std::string standing_summary(const Page& page);

// A few lines of plain text: the paper's claims, how many findings on this software hold, and each
// one that fails or did not run.
std::string verdict_in_short(const Page& page);

// "holds", "differs", "FAILS", "measured", "not run".
std::string_view standing_word(Standing standing);

// To be the last section: what the sections before it could not show.
Section not_run_section(const std::vector<Section>& sections);

// Paths of all data of the sections, in their order.
std::vector<std::string> data_paths(const Page& page);

std::string html_page(const Page& page);
std::string markdown_page(const Page& page);
std::string json_page(const Page& page);

}  // namespace tribo::report
