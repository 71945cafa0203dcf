// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "page/drawing.hpp"
#include "page/markup.hpp"
#include "page/page.hpp"

namespace tribo::report {
namespace {

std::string link_to(const std::string& path) { return fmt::format("[`{0}`]({0})", path); }

std::string links_to(const std::vector<std::string>& paths) {
  std::string text;
  for (const std::string& path : paths) text += (text.empty() ? "" : ", ") + link_to(path);
  return text;
}

std::string figure_text(const Figure& figure) {
  const std::string picture =
      figure.svg.empty()
          ? "*Not drawn: gnuplot was not found, or failed.*"
          : fmt::format("![{}]({})", to_markdown(figure.alternative), picture_path(figure, "png"));
  return fmt::format("### {}\n\n{}\n\n{}\n\nData: {}\n\n", to_markdown(figure.heading), picture,
                     to_markdown(figure.caption), links_to(figure.data));
}

std::string table_text(const TextTable& table) {
  const std::string data =
      table.data.empty() ? "" : fmt::format("\nData: {}\n", link_to(table.data));
  return markdown_table(table) + data + '\n';
}

std::string section_text(const Section& section) {
  std::string text = fmt::format("## {}\n\n", to_markdown(section.title));
  for (const std::string& paragraph : section.paragraphs) text += to_markdown(paragraph) + "\n\n";
  for (const TextTable& table : section.tables) text += table_text(table);
  for (const Figure& figure : section.figures) text += figure_text(figure);
  return text;
}

}  // namespace

std::string markdown_page(const Page& page) {
  std::string text = fmt::format("# {}\n\n", to_markdown(page.title));
  for (const std::string& paragraph : page.introduction) text += to_markdown(paragraph) + "\n\n";
  text += fmt::format("## Verdict\n\n{}\n\n", to_markdown(standing_summary(page)));
  for (const PlacedVerdict& one : verdicts(page))
    text += fmt::format("- **{}** {}: {}\n", standing_word(one.verdict.standing),
                        to_markdown(one.verdict.subject), to_markdown(one.verdict.text));
  text += '\n';
  for (const Section& section : page.sections) text += section_text(section);
  text += "## Data\n\n";
  for (const std::string& path : data_paths(page)) text += fmt::format("- {}\n", link_to(path));
  return text + "- [`report.json`](report.json)\n";
}

}  // namespace tribo::report
