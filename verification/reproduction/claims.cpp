// SPDX-License-Identifier: Apache-2.0
#include "reproduction/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "accuracy/reference_table.hpp"
#include "reproduction/in_file.hpp"

namespace tribo::reproduction {
namespace {

using verification::ReferenceRow;

constexpr std::array<std::string_view, 19> quantity_names{"onset_speed",
                                                          "onset_film_parameter",
                                                          "onset_speed_order",
                                                          "slow_asperity_share",
                                                          "equal_share_speed_order",
                                                          "late_share_rise",
                                                          "area_gw_over_gt",
                                                          "slow_area_spread",
                                                          "area_rough_over_smooth",
                                                          "area_transition_gw_over_gt",
                                                          "slow_count_gt_over_gw",
                                                          "count_gw_over_gt",
                                                          "count_smoother_over_rougher",
                                                          "film_gw_over_gt",
                                                          "friction_gt_over_gw",
                                                          "onset_gw_over_gt",
                                                          "flooded_slope",
                                                          "starved_slope_range",
                                                          "film_constant"};
constexpr std::array<std::string_view, 4> rule_names{"number", "order", "equal", "at_least"};
constexpr std::array<std::string_view, 3> surface_names{"rough", "medium", "smooth"};
constexpr std::string_view nothing = "–";

template <class Enum, std::size_t n>
Enum by_name(const ReferenceRow& row, std::string_view column,
             const std::array<std::string_view, n>& names) {
  const auto found = std::find(names.begin(), names.end(), row.text(column));
  if (found == names.end())
    throw std::runtime_error(
        fmt::format("row {}: {} is no {}", row.text("item"), row.text(column), column));
  return static_cast<Enum>(found - names.begin());
}

double number_if(bool wanted, const ReferenceRow& row, std::string_view column) {
  return wanted ? row.number(column) : 0;
}

Item item_of(const ReferenceRow& row) {
  const Rule rule = by_name<Rule>(row, "rule", rule_names);
  const bool has_surface = row.text("surface") != nothing;
  const bool has_tolerance = rule == Rule::equal || rule == Rule::at_least;
  return {row.text("item"),
          row.text("claim"),
          by_name<Quantity>(row, "quantity", quantity_names),
          has_surface ? by_name<PaperSurface>(row, "surface", surface_names) : PaperSurface::smooth,
          has_surface,
          row.text("surface"),
          row.text("model"),
          rule,
          row.text("printed"),
          number_if(rule == Rule::number, row, "value"),
          number_if(rule == Rule::number, row, "last_digit"),
          number_if(has_tolerance, row, "tolerance"),
          row.text("unit"),
          row.text("place"),
          row.text("statement"),
          row.text("computed_as"),
          row.text("label")};
}

Verdict judge_number(const Item& item, double value) {
  if (is_as_printed(value, item.reported, item.last_digit)) return Verdict::reproduced;
  const double factor = value / item.reported;
  if (!(factor > 0)) return Verdict::not_reproduced;
  if (std::abs(factor - 1) <= 0.1) return Verdict::within_ten_percent;
  return std::abs(std::log10(factor)) <= 0.5 ? Verdict::order_only : Verdict::not_reproduced;
}

}  // namespace

std::string_view name(Quantity quantity) {
  return quantity_names[static_cast<std::size_t>(quantity)];
}

std::string_view name(PaperSurface surface) {
  return surface_names[static_cast<std::size_t>(surface)];
}

std::string_view name(Verdict verdict) {
  constexpr std::array<std::string_view, 5> names{"reproduced", "within 10 %", "order only",
                                                  "in part", "not reproduced"};
  return names[static_cast<std::size_t>(verdict)];
}

Verdict worst(Verdict a, Verdict b) { return std::max(a, b); }

bool is_as_printed(double value, double reported, double last_digit) {
  return std::abs(value - reported) <= last_digit / 2 * (1 + 1e-9);
}

Verdict judge(const Item& item, const Observed& observed) {
  if (!observed.value || !std::isfinite(*observed.value)) return Verdict::not_reproduced;
  const double value = *observed.value;
  const Verdict in_part = observed.part >= 0.5 ? Verdict::in_part : Verdict::not_reproduced;
  switch (item.rule) {
    case Rule::number:
      return judge_number(item, value);
    case Rule::order:
      return value > 1 && observed.part == 1 ? Verdict::reproduced : in_part;
    case Rule::equal:
      if (std::abs(std::log(value)) <= std::log1p(item.tolerance)) return Verdict::reproduced;
      if (std::abs(value - 1) <= 0.1) return Verdict::within_ten_percent;
      return in_part;
    case Rule::at_least:
      return value >= item.tolerance ? Verdict::reproduced : in_part;
  }
  return Verdict::not_reproduced;
}

std::optional<double> margin(const Item& item, const Observed& observed) {
  if (!observed.value || !(*observed.value > 0) || !std::isfinite(*observed.value))
    return std::nullopt;
  const double value = *observed.value;
  switch (item.rule) {
    case Rule::number:
      return std::log(value / item.reported);
    case Rule::order:
      return std::log(value);
    case Rule::equal:
      return std::log1p(item.tolerance) - std::abs(std::log(value));
    case Rule::at_least:
      return std::log(value / item.tolerance);
  }
  return std::nullopt;
}

std::vector<Item> read_claims(const std::string& path) {
  return in_file(path, [&] {
    std::vector<Item> items;
    for (const ReferenceRow& row : verification::read_reference_table(path, '\t'))
      items.push_back(item_of(row));
    if (items.size() > 32) throw std::runtime_error("more than 32 items");
    return items;
  });
}

std::vector<std::string> read_statements(const std::string& path,
                                         const std::vector<std::string>& claims) {
  return in_file(path, [&] {
    std::vector<std::string> statements(claims.size());
    for (const ReferenceRow& row : verification::read_reference_table(path, '\t')) {
      const auto found = std::find(claims.begin(), claims.end(), row.text("claim"));
      if (found == claims.end())
        throw std::runtime_error(fmt::format("{} is no claim of claims.tsv", row.text("claim")));
      statements[static_cast<std::size_t>(found - claims.begin())] = row.text("statement");
    }
    for (std::size_t k = 0; k < claims.size(); ++k)
      if (statements[k].empty())
        throw std::runtime_error(fmt::format("{} has no statement", claims[k]));
    return statements;
  });
}

std::vector<std::string> claim_names(const std::vector<Item>& items) {
  std::vector<std::string> names;
  for (const Item& item : items)
    if (names.empty() || names.back() != item.claim) names.push_back(item.claim);
  return names;
}

}  // namespace tribo::reproduction
