// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "reproduction/ledger.hpp"
#include "sweep/on_threads.hpp"
#include "tribo/bracketed_root.hpp"
#include "tribo/interior_minimum.hpp"

namespace tribo::reproduction {
namespace {

constexpr double widest = 30;  // factors between 1/30 and 30
constexpr int steps = 40;      // on each side of 1

class Search {
 public:
  Search(const PaperScenes& scenes, const Reading& reading, const Item& item, Field field)
      : scenes_(scenes), reading_(reading), item_(item), field_(field) {}

  Observed at(double log_factor) const {
    PaperScenes changed = scenes_;
    scale_all(changed, field_, std::exp(log_factor));
    return evaluate(changed, reading_, item_);
  }
  // The margin of each threshold. A number has two: the ends of the interval that prints alike.
  std::array<double, 2> margins_at(double log_factor) const {
    return threshold_margins(item_, at(log_factor));
  }

  std::optional<double> sensitivity() const {
    constexpr double step = 1e-3;
    const Observed below = at(-step), above = at(step);
    if (!below.value || !above.value || !(*below.value > 0) || !(*above.value > 0))
      return std::nullopt;
    return std::log(*above.value / *below.value) / (2 * step);
  }

  // ln of the factor nearest to 1 at which the item holds by its rule. It is a zero of the margin
  // of a threshold, or a little beyond.
  std::optional<double> nearest_log_factor() const {
    const double width = std::log(widest) / steps;
    const std::array<double, 2> here = margins_at(0);
    std::array<std::array<double, 2>, 2> last{here, here};  // upwards, downwards
    for (int i = 1; i <= steps; ++i) {
      std::optional<double> nearest;
      for (const int side : {1, -1}) {
        std::array<double, 2>& before = last[side > 0 ? 0 : 1];
        const double from = side * (i - 1) * width, to = side * i * width;
        const std::array<double, 2> after = margins_at(to);
        for (std::size_t end = 0; end < 2; ++end) {
          const std::optional<double> found =
              holds_between(end, {from, before[end]}, {to, after[end]}, side);
          if (found && (!nearest || std::abs(*found) < std::abs(*nearest))) nearest = found;
        }
        before = after;
      }
      if (nearest) return nearest;
    }
    return std::nullopt;
  }

 private:
  struct Place {
    double log_factor, margin;
  };

  // Where the margin of a threshold is 0 between two places, if the item holds there.
  std::optional<double> holds_between(std::size_t end, Place from, Place to, int side) const {
    const bool crosses = (from.margin < 0) != (to.margin < 0) && from.margin == from.margin &&
                         to.margin == to.margin;
    if (!crosses) return std::nullopt;
    const double zero = bracketed_root([&](double x) { return margins_at(x)[end]; },
                                       from.log_factor, to.log_factor, 1e-10);
    for (const double beyond : {0.0, side * 1e-8, side * 1e-6})
      if (judge(item_, at(zero + beyond)) == Verdict::reproduced) return zero + beyond;
    return std::nullopt;
  }

  const PaperScenes& scenes_;
  const Reading& reading_;
  const Item& item_;
  Field field_;
};

void add_effects(Requirement& requirement, const PaperScenes& scenes, const Reading& reading,
                 const std::vector<Item>& items, const std::vector<Verdict>& before) {
  PaperScenes changed = scenes;
  scale_all(changed, requirement.field, *requirement.factor);
  const std::vector<Verdict> after = claim_verdicts(items, evaluate(changed, reading, items));
  const std::vector<std::string> names = claim_names(items);
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (before[k] == Verdict::reproduced && after[k] != Verdict::reproduced)
      requirement.broken.push_back(names[k]);
    if (before[k] != Verdict::reproduced && after[k] == Verdict::reproduced)
      requirement.mended.push_back(names[k]);
  }
}

}  // namespace

std::vector<Requirement> requirements(const PaperScenes& scenes, const Reading& reading,
                                      const std::vector<Item>& items,
                                      const std::vector<ItemResult>& results,
                                      const std::vector<Input>& inputs) {
  const std::vector<Verdict> before = claim_verdicts(items, results);
  std::vector<Requirement> found;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (results[i].verdict == Verdict::reproduced) continue;
    const std::string surface(name(items[i].has_surface ? items[i].surface : PaperSurface::rough));
    for (const Input& input : inputs)
      if (input.surface == "all" || input.surface == surface)
        found.push_back({.item = i,
                         .field = input.field,
                         .surface = surface,
                         .unit = input.unit,
                         .paper_value = input.value,
                         .value = input.value,
                         .low = input.low,
                         .high = input.high});
  }
  each_on_threads(0, found.size(), [&](std::size_t k) {
    Requirement& one = found[k];
    const Item& item = items[one.item];
    const Search search(scenes, reading, item, one.field);
    one.sensitivity = search.sensitivity();
    const std::optional<double>& value = results[one.item].observed.value;
    if (item.rule == Rule::number && value && one.sensitivity &&
        std::abs(*one.sensitivity) > 1e-9) {
      const double log_factor =
          std::log(nearest_as_printed(item, *value) / *value) / *one.sensitivity;
      if (std::abs(log_factor) < std::log(1000.0)) one.by_sensitivity = std::exp(log_factor);
    }
    const std::optional<double> log_factor = search.nearest_log_factor();
    if (!log_factor) return;
    one.factor = std::exp(*log_factor);
    one.value *= *one.factor;
    one.plausible = one.value >= one.low && one.value <= one.high;
    const double beside = std::pow(one.high / one.low, 0.1 / 2);
    one.at_limit =
        !one.plausible && one.value >= one.low / beside && one.value <= one.high * beside;
    add_effects(one, scenes, reading, items, before);
  });
  return found;
}

CommonDeparture common_departure(const PaperScenes& scenes, const Reading& reading,
                                 const std::array<double, surface_count>& reported) {
  const ReadInlet inlet(reading);
  std::vector<ReadContact> contacts;
  for (std::size_t i = 0; i < surface_count; ++i)
    contacts.emplace_back(scenes.scene[i], reading, scenes.film_scale());
  const auto log_factor = [&](std::size_t i, double departure) {
    const auto onset = contacts[i].onset_at_ratio(inlet.departure(departure), inlet);
    return onset ? std::log(onset->speed / reported[i]) : -1e3;
  };
  CommonDeparture found{};
  constexpr double least = 1e-4, most = 0.9999;
  for (std::size_t i = 0; i < surface_count; ++i) {
    const double epsilon =
        bracketed_root([&](double e) { return log_factor(i, e); }, least, most, 1e-12);
    if (epsilon == epsilon) found.own[i] = epsilon;
  }
  const auto worst_factor = [&](double departure) {
    double worst = 0;
    for (std::size_t i = 0; i < surface_count; ++i)
      worst = std::max(worst, std::abs(log_factor(i, departure)));
    return worst;
  };
  // Each ln of a factor rises with ε, so that their greatest magnitude has one minimum.
  found.best = golden_section_minimum(worst_factor, least, most, 1e-9);
  for (std::size_t i = 0; i < surface_count; ++i)
    found.factor[i] = std::exp(log_factor(i, found.best));
  return found;
}

}  // namespace tribo::reproduction
