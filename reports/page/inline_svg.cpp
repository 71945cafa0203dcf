// SPDX-License-Identifier: Apache-2.0
#include "page/inline_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "page/markup.hpp"

namespace tribo::report {
namespace {

// What stands before an identifier, where it is set and where it is used.
constexpr std::array<std::string_view, 6> before_identifiers{" id=\"",  " id='", "href=\"#",
                                                             "href='#", "url(#", "url('#"};

std::string with_prefix(std::string_view svg, std::string_view prefix) {
  std::string text;
  while (!svg.empty()) {
    std::size_t at = std::string_view::npos, length = 0;
    for (const std::string_view mark : before_identifiers)
      if (const std::size_t found = svg.find(mark); found < at) {
        at = found;
        length = mark.size();
      }
    if (at == std::string_view::npos) break;
    text += svg.substr(0, at + length);
    text += fmt::format("{}-", prefix);
    svg.remove_prefix(at + length);
  }
  return text += svg;
}

// Without the first <name>…</name>, which gnuplot writes about itself.
std::string without_element(std::string text, std::string_view name) {
  const std::string close = fmt::format("</{}>", name);
  const std::size_t from = text.find(fmt::format("<{}>", name));
  const std::size_t to = text.find(close);
  if (from == std::string::npos || to == std::string::npos || to < from) return text;
  return text.erase(from, to + close.size() - from);
}

}  // namespace

std::string inline_svg(std::string_view svg, std::string_view prefix, std::string_view title,
                       std::string_view description) {
  constexpr std::string_view element = "<svg";
  svg.remove_prefix(std::min(svg.find(element), svg.size()));
  std::string text = without_element(without_element(with_prefix(svg, prefix), "title"), "desc");
  const std::size_t end = text.find('>');
  if (end == std::string::npos) return {};
  text.insert(end + 1,
              fmt::format("\n<title id=\"{0}-title\">{1}</title>\n<desc id=\"{0}-desc\">{2}</desc>",
                          prefix, escape_html(title), escape_html(description)));
  text.insert(element.size(),
              fmt::format(" role=\"img\" aria-labelledby=\"{0}-title {0}-desc\"", prefix));
  return text;
}

}  // namespace tribo::report
