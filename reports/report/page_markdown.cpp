// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "report/markup.hpp"
#include "report/page.hpp"

namespace tribo::report {
namespace {

std::string figure_text(const Figure& figure) {
  const std::string picture =
      figure.drawn
          ? fmt::format("![{}](figures/{}.png)", to_markdown(figure.alternative), figure.stem)
          : "*Not drawn: gnuplot was not found, or failed.*";
  return fmt::format("### {}\n\n{}\n\n{}\n\n", to_markdown(figure.heading()), picture,
                     to_markdown(figure.caption));
}

}  // namespace

std::string markdown_page(const Page& page) {
  std::string text = fmt::format("# {}\n\n", to_markdown(page.title));
  for (const std::string& paragraph : page.introduction) text += to_markdown(paragraph) + "\n\n";
  text += "## Computed beside reported\n\n";
  for (const TextTable& table : page.comparisons) text += markdown_table(table) + '\n';
  text += "## Figures\n\n";
  for (const Figure& figure : page.figures) text += figure_text(figure);
  text += "## Verification\n\n";
  for (const TextTable& table : page.verification) text += markdown_table(table) + '\n';
  text += "## Speed and work\n\n";
  for (const TextTable& table : page.performance) text += markdown_table(table) + '\n';
  text += "## Inputs\n\n" + markdown_table(page.inputs) + "\n## Data\n\n";
  for (const std::string& file : page.data_files) text += fmt::format("- [{0}]({0})\n", file);
  return text;
}

}  // namespace tribo::report
