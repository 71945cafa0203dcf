// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "report/markup.hpp"
#include "report/page.hpp"

namespace tribo::report {
namespace {

constexpr std::string_view style = R"(:root { color-scheme: light dark; }
body { margin: 0 auto; padding: 1rem; max-width: 64rem; font: 1rem/1.5 system-ui, sans-serif;
  color: #1a1a1a; background: #f6f7f8; }
h1 { font-size: 1.7rem; line-height: 1.25; }
h2 { font-size: 1.25rem; margin-top: 2.5rem; }
figure { margin: 1.5rem 0; }
figure img { display: block; width: 100%; height: auto; background: #fff; border-radius: 6px;
  box-shadow: 0 0 0 1px #0002; }
figcaption { margin-top: .6rem; max-width: 48rem; }
.undrawn { padding: 2rem; text-align: center; color: #1a1a1a; background: #fff; border-radius: 6px;
  box-shadow: 0 0 0 1px #0002; }
.scroll { overflow-x: auto; margin-top: 1rem; }
table { border-collapse: collapse; font-size: .9rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; font-weight: 600; padding: .3rem .6rem .3rem 0; }
th, td { padding: .2rem .6rem; text-align: left; border-bottom: 1px solid #8884; }
th { font-weight: 600; }
tbody th { font-weight: 400; }
td:last-child:not(.number) { min-width: 14rem; }
.number { text-align: right; white-space: nowrap; }
.note { font-size: .9rem; max-width: 48rem; }
code { font-size: .92em; overflow-wrap: anywhere; }
td code { white-space: nowrap; overflow-wrap: normal; }
ul { padding-left: 1.2rem; }
a { color: #0060a8; }
@media (prefers-color-scheme: dark) {
  body { color: #e6e6e6; background: #16191c; }
  a { color: #7fc4ff; }
})";

std::string picture(const Figure& figure) {
  if (!figure.drawn)
    return "<p class=\"undrawn\">Not drawn: gnuplot was not found, or failed.</p>\n";
  return fmt::format(
      "<a href=\"figures/{0}.png\"><img src=\"figures/{0}.svg\" width=\"960\" height=\"{1}\" "
      "alt=\"{2}\"></a>\n",
      figure.stem, figure.height, escape_html(figure.alternative));
}

std::string figure_text(const Figure& figure) {
  return fmt::format(
      "<figure id=\"{}\">\n{}<figcaption><strong>{}.</strong> {}</figcaption>\n</figure>\n",
      figure.stem, picture(figure), escape_html(figure.heading()), to_html(figure.caption));
}

std::string data_list(const Page& page) {
  std::string text = "<ul>\n";
  for (const std::string& file : page.data_files)
    text += fmt::format("<li><a href=\"{0}\">{0}</a></li>\n", escape_html(file));
  return text + "</ul>\n";
}

}  // namespace

std::string html_page(const Page& page) {
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{0}</title>\n<style>\n{1}\n</style>\n</head>\n<body>\n<main>\n<h1>{0}</h1>\n",
      escape_html(page.title), style);
  for (const std::string& paragraph : page.introduction)
    text += fmt::format("<p>{}</p>\n", to_html(paragraph));
  text += "<h2>Computed beside reported</h2>\n";
  for (const TextTable& table : page.comparisons) text += html_table(table);
  text += "<h2>Figures</h2>\n";
  for (const Figure& figure : page.figures) text += figure_text(figure);
  text += "<h2>Verification</h2>\n";
  for (const TextTable& table : page.verification) text += html_table(table);
  text += "<h2>Speed and work</h2>\n";
  for (const TextTable& table : page.performance) text += html_table(table);
  text += "<h2>Inputs</h2>\n" + html_table(page.inputs);
  text += "<h2>Data</h2>\n" + data_list(page);
  return text + "</main>\n</body>\n</html>\n";
}

}  // namespace tribo::report
