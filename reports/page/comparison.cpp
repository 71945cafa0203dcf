// SPDX-License-Identifier: Apache-2.0
#include "page/comparison.hpp"

#include <algorithm>

namespace tribo::report {

using reproduction::Item;
using reproduction::Quantity;

std::optional<double> ComparisonRow::factor() const {
  if (!computed || claim == nullptr) return std::nullopt;
  return *computed / claim->reported;
}

std::optional<reproduction::Verdict> ComparisonRow::verdict() const {
  if (!computed || claim == nullptr) return std::nullopt;
  return reproduction::judge(*claim, {computed, *computed});
}

const Item* reported(const std::vector<Item>& claims, Quantity quantity, const Case& source) {
  const auto found = std::find_if(claims.begin(), claims.end(), [&](const Item& item) {
    return item.rule == reproduction::Rule::number && item.quantity == quantity &&
           item.surface_text == source.surface &&
           (item.model == source.short_model() || item.model == "both");
  });
  return found == claims.end() ? nullptr : &*found;
}

std::vector<ComparisonRow> compare(const std::vector<SolvedCase>& solved,
                                   const std::vector<Item>& claims) {
  std::vector<ComparisonRow> rows;
  const auto add = [&](Quantity quantity, const SolvedCase& one, std::string_view criterion,
                       std::optional<double> computed, std::string_view none) {
    rows.push_back({quantity, one.source.surface, one.source.short_model(), criterion, computed,
                    none, reported(claims, quantity, one.source)});
  };
  const auto add_onsets = [&](Quantity quantity, double Onset<double>::*number) {
    for (const SolvedCase& one : solved)
      for (const Onset<double>& onset : one.onsets)
        add(quantity, one, name(onset.criterion),
            onset.exists ? std::optional(onset.*number) : std::nullopt, onset.reason);
  };
  add_onsets(Quantity::onset_speed, &Onset<double>::speed);
  add_onsets(Quantity::onset_film_parameter, &Onset<double>::film_parameter);
  for (const SolvedCase& one : solved)
    add(Quantity::slow_asperity_share, one, "", one.slowest.asperity_load_share, "");
  return rows;
}

}  // namespace tribo::report
