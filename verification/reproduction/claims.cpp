// SPDX-License-Identifier: Apache-2.0
#include "reproduction/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

#include "accuracy/reference_table.hpp"

namespace tribo::reproduction {
namespace {

using verification::ReferenceRow;

constexpr auto rule_names =
    std::to_array<std::string_view>({"number", "order", "equal", "at_least"});
constexpr auto surface_names = std::to_array<std::string_view>({"rough", "medium", "smooth"});
constexpr std::string_view nothing = "–";
constexpr double near_by = 0.1;                       // “within 10 %”
constexpr double order_factor = 3.16227766016837933;  // “order only”: √10

// The least (side −1) or greatest (side 1) number that prints as reported. The factor 1 + 1e-9
// allows for the rounding of the decimals.
double printed_limit(double reported, double last_digit, int side) {
  return reported + side * (last_digit / 2 * (1 + 1e-9));
}

// The enumerator whose name is in a column.
template <class Enum>
Enum by_name(const ReferenceRow& row, std::string_view column, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    if (name(static_cast<Enum>(i)) == row.text(column)) return static_cast<Enum>(i);
  throw std::runtime_error(
      fmt::format("row {}: {} is no {}", row.text("item"), row.text(column), column));
}

double number_if(bool wanted, const ReferenceRow& row, std::string_view column) {
  return wanted ? row.number(column) : 0;
}

// A tolerance. For two speeds it may be a part of a logarithmic axis: "0.01 of 0.0001 to 3" is the
// factor of a hundredth of that axis, less 1.
double tolerance(const ReferenceRow& row) {
  const std::string& text = row.text("tolerance");
  double part = 0, from = 0, to = 0;
  int end = 0;
  const int read = std::sscanf(text.c_str(), "%lf of %lf to %lf%n", &part, &from, &to, &end);
  if (read < 2) return row.number("tolerance");
  if (read < 3 || static_cast<std::size_t>(end) != text.size() || !(part > 0) || !(0 < from) ||
      !(from < to))
    throw std::runtime_error(fmt::format(
        "row {}: {} is no part of an axis, such as 0.01 of 0.0001 to 3", row.text("item"), text));
  return std::expm1(part * std::log(to / from));
}

// The column `nature`: model, or arithmetic.
bool is_arithmetic(const ReferenceRow& row) {
  const std::string& nature = row.text("nature");
  if (nature != "model" && nature != "arithmetic")
    throw std::runtime_error(fmt::format("row {}: {} is no nature", row.text("item"), nature));
  return nature == "arithmetic";
}

Item item_of(const ReferenceRow& row) {
  const Rule rule = by_name<Rule>(row, "rule", rule_names.size());
  const bool has_surface = row.text("surface") != nothing;
  const bool has_tolerance = rule == Rule::equal || rule == Rule::at_least;
  return {row.text("item"),
          row.text("claim"),
          by_name<Quantity>(row, "quantity", quantity_count),
          has_surface ? by_name<PaperSurface>(row, "surface", surface_count) : PaperSurface::smooth,
          has_surface,
          row.text("surface"),
          row.text("model"),
          rule,
          row.text("printed"),
          number_if(rule == Rule::number, row, "value"),
          number_if(rule == Rule::number, row, "last_digit"),
          has_tolerance ? tolerance(row) : 0,
          row.text("unit"),
          row.text("place"),
          row.text("statement"),
          row.text("computed_as"),
          row.text("label"),
          is_arithmetic(row)};
}

Verdict judge_number(const Item& item, double value) {
  if (is_as_printed(value, item.reported, item.last_digit)) return Verdict::reproduced;
  const double factor = value / item.reported;
  if (!(factor > 0)) return Verdict::not_reproduced;
  if (std::abs(factor - 1) <= near_by) return Verdict::within_ten_percent;
  return std::abs(std::log(factor)) <= std::log(order_factor) ? Verdict::order_only
                                                              : Verdict::not_reproduced;
}

}  // namespace

std::string_view name(Rule rule) { return rule_names[static_cast<std::size_t>(rule)]; }

std::string_view name(PaperSurface surface) {
  return surface_names[static_cast<std::size_t>(surface)];
}

std::string_view name(Verdict verdict) {
  constexpr auto names = std::to_array<std::string_view>(
      {"reproduced", "within 10 %", "order only", "in part", "not reproduced"});
  return names[static_cast<std::size_t>(verdict)];
}

std::string_view short_name(Verdict verdict) {
  if (verdict == Verdict::reproduced) return "yes";
  return verdict == Verdict::not_reproduced ? "no" : "partly";
}

std::string_view name(MarginOf of) { return of == MarginOf::number ? "number" : "part"; }

Verdict worst(Verdict a, Verdict b) { return std::max(a, b); }

bool is_as_printed(double value, double reported, double last_digit) {
  return value >= printed_limit(reported, last_digit, -1) &&
         value <= printed_limit(reported, last_digit, 1);
}

Verdict judge(const Item& item, const Observed& observed) {
  if (!observed.value || !std::isfinite(*observed.value)) return Verdict::not_reproduced;
  const double value = *observed.value;
  const Verdict in_part = observed.part >= 0.5 ? Verdict::in_part : Verdict::not_reproduced;
  switch (item.rule) {
    case Rule::number:
      return judge_number(item, value);
    case Rule::order:
      // A ratio that exceeds 1 by no more than its numerical error is not greater than 1.
      return value > 1 + observed.error && observed.part == 1 ? Verdict::reproduced : in_part;
    case Rule::equal:
      if (std::abs(std::log(value)) <= std::log1p(item.tolerance)) return Verdict::reproduced;
      if (std::abs(value - 1) <= near_by) return Verdict::within_ten_percent;
      return in_part;
    case Rule::at_least:
      return value >= item.tolerance ? Verdict::reproduced : in_part;
  }
  return Verdict::not_reproduced;
}

Item with_tolerance(Item item, double factor) {
  item.last_digit *= factor;
  if (item.rule == Rule::at_least)
    item.tolerance /= factor;
  else
    item.tolerance *= factor;
  return item;
}

std::array<double, 2> threshold_margins(const Item& item, const Observed& observed) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (!observed.value || !(*observed.value > 0) || !std::isfinite(*observed.value))
    return {none, none};
  const double value = *observed.value;
  switch (item.rule) {
    case Rule::number:
      return {std::log(value / printed_limit(item.reported, item.last_digit, -1)),
              std::log(printed_limit(item.reported, item.last_digit, 1) / value)};
    case Rule::order:
      return {std::log(value), none};
    case Rule::equal:
      return {std::log1p(item.tolerance) - std::abs(std::log(value)), none};
    case Rule::at_least:
      return {std::log(value / item.tolerance), none};
  }
  return {none, none};
}

double nearest_as_printed(const Item& item, double value) {
  return std::clamp(value, printed_limit(item.reported, item.last_digit, -1),
                    printed_limit(item.reported, item.last_digit, 1));
}

namespace {

// |ln(number/threshold)|; a number below its error counts as that error.
Margin distance(double number, double error, double threshold) {
  const double known = std::max({number, error, std::numeric_limits<double>::min()});
  const double towards =
      threshold < known ? -std::log1p(-error / known) : std::log1p(error / known);
  return {std::abs(std::log(known / threshold)), towards, MarginOf::number};
}

// The margin of the verdict `reproduced`.
Margin first_margin(const Item& item, const Observed& observed) {
  const double value = *observed.value;
  const auto to = [&](double threshold) { return distance(value, observed.error, threshold); };
  const auto nearer = [](Margin a, Margin b) { return a.distance < b.distance ? a : b; };
  switch (item.rule) {
    case Rule::number:
      return nearer(to(printed_limit(item.reported, item.last_digit, -1)),
                    to(printed_limit(item.reported, item.last_digit, 1)));
    case Rule::order:
      return to(1);
    case Rule::equal:
      return nearer(to(1 / (1 + item.tolerance)), to(1 + item.tolerance));
    case Rule::at_least:
      break;
  }
  return to(item.tolerance);
}

}  // namespace

bool is_sure(const Item& item, const Observed& observed) {
  return !observed.value || !std::isfinite(*observed.value) ||
         first_margin(item, observed).is_decided();
}

std::optional<Margin> margin_of_verdict(const Item& item, const Observed& observed) {
  if (!observed.value || !std::isfinite(*observed.value)) return std::nullopt;
  Margin nearest = first_margin(item, observed);
  const auto consider = [&](Margin other) {
    const bool is_open = nearest.is_decided() && !other.is_decided();
    if (is_open ||
        (nearest.is_decided() == other.is_decided() && other.distance < nearest.distance))
      nearest = other;
  };
  const auto consider_ends = [&](double low, double high) {
    for (const double end : {low, high}) consider(distance(*observed.value, observed.error, end));
  };
  const Verdict verdict = judge(item, observed);
  if (verdict == Verdict::reproduced) return nearest;
  if (item.rule == Rule::number || item.rule == Rule::equal) {
    const double one = item.rule == Rule::number ? item.reported : 1;
    consider_ends((1 - near_by) * one, (1 + near_by) * one);
    if (item.rule == Rule::number && verdict != Verdict::within_ten_percent)
      consider_ends(item.reported / order_factor, item.reported * order_factor);
  }
  if (item.rule == Rule::number || verdict == Verdict::within_ten_percent) return nearest;
  if (observed.middle) {
    Observed half = observed;
    half.value = observed.middle;
    consider(first_margin(item, half));
  }
  if (observed.part_error)
    consider({std::abs(observed.part - 0.5), *observed.part_error, MarginOf::part});
  return nearest;
}

std::vector<Item> read_claims(const std::string& path) {
  std::vector<Item> items;
  verification::each_published_row(path, [&](const ReferenceRow& row) {
    if (items.size() == 32) throw std::runtime_error("more than 32 items");
    items.push_back(item_of(row));
  });
  return items;
}

std::vector<std::string> read_statements(const std::string& path,
                                         const std::vector<std::string>& claims) {
  std::vector<std::string> statements(claims.size());
  verification::each_published_row(path, [&](const ReferenceRow& row) {
    const auto found = std::find(claims.begin(), claims.end(), row.text("claim"));
    if (found == claims.end())
      throw std::runtime_error(fmt::format("{} is no claim of claims.tsv", row.text("claim")));
    statements[static_cast<std::size_t>(found - claims.begin())] = row.text("statement");
  });
  for (std::size_t k = 0; k < claims.size(); ++k)
    if (statements[k].empty())
      throw std::runtime_error(fmt::format("{}: {} has no statement", path, claims[k]));
  return statements;
}

std::vector<std::string> claim_names(const std::vector<Item>& items) {
  std::vector<std::string> names;
  for (const Item& item : items)
    if (names.empty() || names.back() != item.claim) names.push_back(item.claim);
  return names;
}

}  // namespace tribo::reproduction
