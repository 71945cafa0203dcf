// SPDX-License-Identifier: Apache-2.0
// The report as one page, in HTML and in Markdown.
#pragma once

#include <string>
#include <vector>

#include "report/figures.hpp"
#include "report/text_table.hpp"

namespace tribo::report {

struct Page {
  std::string title;
  std::vector<std::string> introduction;  // paragraphs of markup
  TextTable inputs;
  std::vector<TextTable> comparisons;
  std::vector<Figure> figures;
  std::vector<TextTable> verification;
  std::vector<TextTable> performance;
  std::vector<std::string> data_files;  // paths below the report's folder
};

Page make_page(const Findings& findings, const std::vector<ComparisonTable>& comparisons,
               std::vector<Figure> figures, std::vector<TextTable> verification,
               std::vector<TextTable> performance, std::vector<std::string> data_files);

std::string html_page(const Page& page);
std::string markdown_page(const Page& page);

}  // namespace tribo::report
