// SPDX-License-Identifier: Apache-2.0
#include "subject_template.hpp"

#include <fmt/format.h>

#include <kainjow/mustache.hpp>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "catalogue/catalogue.hpp"
#include "page/text_table.hpp"

namespace tribo::cli {
namespace {

using kainjow::mustache::data;
using kainjow::mustache::mustache;

constexpr std::size_t widest_comment = 92;  // columns

std::string text_of(std::string_view text) { return std::string(text); }

// Its lines, for a comment: {{#about}}{{line}}{{/about}}.
data lines_of(const std::string& text) {
  data lines(data::type::list);
  for (const std::string& line : report::wrapped(text, widest_comment)) lines << data("line", line);
  return lines;
}

// Entries of each item in a list: name, meaning, unit, number from 1 and from 0, and whether it is
// the last item.
template <class Named>
data entry_of(const Named& named, std::size_t place, std::size_t count) {
  data entry;
  entry.set("name", text_of(named.name));
  entry.set("meaning", text_of(named.meaning));
  entry.set("in_unit", named.unit.empty() ? "" : fmt::format(", in {}", named.unit));
  entry.set("number", std::to_string(place + 1));
  entry.set("place", std::to_string(place));
  entry.set("last", data(place + 1 == count ? data::type::bool_true : data::type::bool_false));
  return entry;
}

// {{allowed}}: "a number above 0", or the words. {{coded}}: the words with their codes of
// tribocheck_plugin.h.
data parameters_of(const catalogue::Function& function) {
  data list(data::type::list);
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const catalogue::Parameter& parameter = function.parameters[i];
    data entry = entry_of(parameter, i, function.parameters.size());
    entry.set("allowed", catalogue::allowed_text(parameter));
    std::string coded;
    for (std::size_t code = 0; code < parameter.words.size(); ++code)
      coded += fmt::format("{}{} {}", code == 0 ? "" : ", ", code, parameter.words[code]);
    entry.set("coded", coded.empty() ? catalogue::allowed_text(parameter) : coded);
    list << entry;
  }
  return list;
}

data results_of(const catalogue::Function& function) {
  data list(data::type::list);
  for (std::size_t i = 0; i < function.results.size(); ++i)
    list << entry_of(function.results[i], i, function.results.size());
  return list;
}

data function_of(const catalogue::Function& function) {
  data entry;
  entry.set("name", text_of(function.name));
  entry.set("about", lines_of(fmt::format("{}: {}. Source: {}.", function.meaning,
                                          function.equation, function.source)));
  entry.set("parameters", parameters_of(function));
  entry.set("results", results_of(function));
  // Each of several results has a name; a single result is the answer itself.
  if (function.results.size() == 1) entry.set("only_result", results_of(function));
  return entry;
}

}  // namespace

std::string filled_template(const std::string& text, const std::string& path,
                            const std::string& next) {
  mustache filled(text);
  if (!filled.is_valid()) throw std::runtime_error(path + ": " + filled.error_message());
  filled.set_custom_escape([](const std::string& plain) { return plain; });  // no HTML
  data functions(data::type::list);
  for (const catalogue::Function& function : catalogue::functions())
    functions << function_of(function);
  data all("functions", functions);
  all.set("next", next);
  return filled.render(all);
}

}  // namespace tribo::cli
