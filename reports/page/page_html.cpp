// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "page/drawing.hpp"
#include "page/inline_svg.hpp"
#include "page/markup.hpp"
#include "page/page.hpp"
#include "page/page_style.hpp"

namespace tribo::report {
namespace {

std::string link_to(const std::string& path) {
  return fmt::format("<a href=\"{0}\">{1}</a>", escape_html(path),
                     escape_html(path.substr(path.rfind('/') + 1)));
}

std::string links_to(const std::vector<std::string>& paths) {
  std::string text;
  for (const std::string& path : paths) text += (text.empty() ? "" : ", ") + link_to(path);
  return text;
}

std::string paragraphs(const std::vector<std::string>& markup) {
  std::string text;
  for (const std::string& paragraph : markup)
    text += fmt::format("<p>{}</p>\n", to_html(paragraph));
  return text;
}

std::string picture(const Figure& figure) {
  if (figure.svg.empty())
    return "<p class=\"undrawn\">Not drawn: gnuplot was not found, or failed.</p>\n";
  const std::string title = to_plain(figure.heading);
  return fmt::format(
      "<div class=\"scroll picture\" tabindex=\"0\" role=\"region\" aria-label=\"{}, picture\">\n{}"
      "</div>\n<p class=\"hint\">Wider than this screen: scroll it sideways, or open the "
      "picture.</p>\n",
      escape_html(title), inline_svg(figure.svg, figure.stem, title, figure.alternative));
}

std::string files_of(const Figure& figure) {
  std::string text = fmt::format("<span class=\"files\">Data: {}.", links_to(figure.data));
  if (!figure.svg.empty())
    text += fmt::format(" Picture: {}, {}.", link_to(picture_path(figure, "svg")),
                        link_to(picture_path(figure, "png")));
  return text + "</span>";
}

std::string figure_text(const Figure& figure) {
  return fmt::format(
      "<figure id=\"{}\">\n<h3>{}</h3>\n{}<figcaption>{}\n{}</figcaption>\n</figure>\n",
      figure.stem, to_html(figure.heading), picture(figure), to_html(figure.caption),
      files_of(figure));
}

// Where a section has many figures, each is one click away.
std::string figure_index(const std::vector<Figure>& figures) {
  if (figures.size() < 2) return {};
  std::string text = "<ul class=\"index\">\n";
  for (const Figure& figure : figures)
    text += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", figure.stem, to_html(figure.heading));
  return text + "</ul>\n";
}

std::string table_text(const TextTable& table) {
  if (table.data.empty()) return html_table(table);
  return html_table(table) + fmt::format("<p class=\"note\">Data: {}.</p>\n", link_to(table.data));
}

std::string in_section(std::string_view id, const std::string& title, const std::string& content) {
  return fmt::format(
      "<section id=\"{0}\" aria-labelledby=\"{0}-heading\">\n<h2 id=\"{0}-heading\">{1}</h2>\n{2}"
      "</section>\n",
      id, to_html(title), content);
}

std::string section_text(const Section& section) {
  std::string text = paragraphs(section.paragraphs);
  for (const TextTable& table : section.tables) text += table_text(table);
  text += figure_index(section.figures);
  for (const Figure& figure : section.figures) text += figure_text(figure);
  return in_section(section.id, section.title, text);
}

std::string_view standing_class(Standing standing) {
  switch (standing) {
    case Standing::holds:
      return "holds";
    case Standing::differs:
      return "differs";
    case Standing::fails:
      return "fails";
    case Standing::measured:
      return "measured";
    case Standing::absent:
      return "absent";
  }
  return "";
}

std::string verdict_text(const Page& page) {
  std::string text =
      fmt::format("<p>{}</p>\n<ul class=\"verdicts\">\n", to_html(standing_summary(page)));
  for (const PlacedVerdict& one : verdicts(page))
    text += fmt::format(
        "<li><span class=\"badge {}\">{}</span> <span><a href=\"#{}\">{}</a>: {}</span></li>\n",
        standing_class(one.verdict.standing), standing_word(one.verdict.standing), one.section,
        to_html(one.verdict.subject), to_html(one.verdict.text));
  return in_section(verdict_id, "Verdict", text + "</ul>\n");
}

std::string data_list(const Page& page) {
  std::string text = "<ul class=\"data\">\n";
  for (const std::string& path : data_paths(page))
    text += fmt::format("<li>{}</li>\n", link_to(path));
  return in_section("data", "Data",
                    text + "<li><a href=\"report.json\">report.json</a></li>\n</ul>\n");
}

std::string contents(const Page& page) {
  std::string text = fmt::format(
      "<nav aria-labelledby=\"contents\">\n<h2 id=\"contents\">Contents</h2>\n<ul>\n"
      "<li><a href=\"#{}\">Verdict</a></li>\n",
      verdict_id);
  for (const Section& section : page.sections)
    text += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", section.id, to_html(section.title));
  return text + "<li><a href=\"#data\">Data</a></li>\n</ul>\n</nav>\n";
}

}  // namespace

std::string html_page(const Page& page) {
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n"
      "<title>{0}</title>\n<style>\n{1}\n</style>\n</head>\n<body>\n"
      "<a class=\"skip\" href=\"#main\">Skip to the verdict</a>\n<div class=\"page\">\n"
      "<header>\n<h1>{0}</h1>\n{2}</header>\n{3}<main id=\"main\" tabindex=\"-1\">\n{4}",
      escape_html(page.title), page_style, paragraphs(page.introduction), contents(page),
      verdict_text(page));
  for (const Section& section : page.sections) text += section_text(section);
  return text + data_list(page) + "</main>\n</div>\n</body>\n</html>\n";
}

}  // namespace tribo::report
