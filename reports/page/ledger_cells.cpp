// SPDX-License-Identifier: Apache-2.0
#include "page/ledger_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "page/ledger_tables.hpp"
#include "page/number_text.hpp"

namespace tribo::report::ledger_cells {

using namespace reproduction;

bool is_wanted(const std::vector<std::string>& claims, const std::string& claim) {
  return claims.empty() || std::find(claims.begin(), claims.end(), claim) != claims.end();
}

std::string number(const std::optional<double>& value, int digits) {
  return value && std::isfinite(*value) ? rounded(*value, digits) : no_entry;
}

std::string percent(double part) {
  if (part == 0) return "none";
  if (part < 0.001) return "< 0.1 %";
  if (part == 1) return "100 %";
  const std::string digits = fmt::format("{:.1f}", 100 * part);
  return (part < 1 && digits == "100.0" ? "> 99.9" : digits) + " %";
}

std::string with_unit(const std::string& number, const std::string& unit) {
  return unit == no_entry || number == no_entry ? number : fmt::format("{} {}", number, unit);
}

std::string asked(const Item& item) {
  switch (item.rule) {
    case Rule::number:
      return with_unit(unrounded(item.reported), item.unit);
    case Rule::order:
      return "above 1";
    case Rule::equal:
      return fmt::format("1 ± {:.4g} %", 100 * item.tolerance);
    case Rule::at_least:
      return fmt::format("from {}", unrounded(item.tolerance));
  }
  return {};
}

std::string computed(const Item& item, const ItemResult& result) {
  if (!result.observed.value) return no_entry;
  if (is_over_speeds(item))
    return fmt::format("{} to {}",
                       number(std::min(*result.observed.value, result.observed.other_end), 3),
                       number(std::max(*result.observed.value, result.observed.other_end), 3));
  return with_unit(number(*result.observed.value), item.unit);
}

std::string against_the_paper(const Item& item, const ItemResult& result) {
  if (!result.observed.value) return no_entry;
  if (item.rule == Rule::number)
    return fmt::format("{} times", number(*result.observed.value / item.reported, 3));
  if (!is_over_speeds(item)) return no_entry;
  const double part = result.observed.part;
  return part == 0   ? "at no speed"
         : part == 1 ? "at all speeds"
                     : fmt::format("at {} of speeds", percent(part));
}

std::string verdict(const ItemResult& result) {
  std::string text(name(result.verdict));
  if (!result.observed.value && !result.observed.none.empty())
    text += fmt::format(": {}", result.observed.none);
  if (!result.is_decided()) text += fmt::format("; {}", undecided_words);
  return text;
}

std::string margin(const ItemResult& result) {
  if (!result.margin) return no_entry;
  return fmt::format("{}{} ± {:.0e}", number(result.margin->distance, 3),
                     result.margin->of == MarginOf::part ? " of speeds" : "", result.margin->error);
}

std::string list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& one : names) text += (text.empty() ? "" : ", ") + one;
  return text.empty() ? no_entry : text;
}

}  // namespace tribo::report::ledger_cells
