// SPDX-License-Identifier: Apache-2.0
// What the page is made of. A section says everything about itself: the page's verdict and its list
// of what did not run are collected from the sections.
#pragma once

#include <cstdint>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "page/data_file.hpp"
#include "page/figure.hpp"
#include "page/text_table.hpp"

namespace tribo::report {

enum class Standing : std::uint8_t {
  holds,     // agrees, within what is declared
  differs,   // does not agree with what others report, or agrees in part
  fails,     // one of our own promises is broken
  measured,  // a finding, neither good nor bad
  absent,    // not known: its source is missing, or it was not run
};

// A line of the verdict on top of the page.
struct Verdict {
  Standing standing;
  std::string subject;  // markup, both: “Onset speeds”
  std::string text;     // in a sentence or two, and when it was measured
};

struct NotRun {
  std::string what;  // markup, all three
  std::string why;
  std::string how_to;  // have it
};

struct Section {
  std::string id;                            // in the page
  std::string title;                         // markup
  std::vector<std::string> paragraphs = {};  // markup
  std::vector<TextTable> tables = {};
  std::vector<Figure> figures = {};
  std::vector<DataFile> data = {};  // written below the report's folder, before figures are drawn
  std::vector<Verdict> verdicts = {};
  std::vector<NotRun> not_run = {};
};

// A section whose source cannot be used. It says so in its own text, in its verdict and in the list
// of what did not run.
Section excused(Section empty, const std::string& why, const std::string& how_to);

// `fill` adds to the section what it is to show; what it throws excuses the section.
template <class Fill>
Section filled_or_excused(const Section& empty, const std::string& how_to, Fill&& fill) {
  try {
    Section section = empty;
    fill(section);
    return section;
  } catch (const std::exception& error) {
    return excused(empty, error.what(), how_to);
  }
}

}  // namespace tribo::report
