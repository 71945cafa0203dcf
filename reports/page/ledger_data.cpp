// SPDX-License-Identifier: Apache-2.0
#include "page/ledger_data.hpp"

#include <fmt/format.h>

#include <cmath>

#include "page/number_text.hpp"
#include "tribo/onset.hpp"

namespace tribo::report {
namespace {

using namespace reproduction;

constexpr const char* surface_names[] = {"rough", "medium", "smooth"};
constexpr double nanometres = 1e9;

double onset_speed(const Scene& scene, OnsetCriterion criterion) {
  const auto found = onset(MixedContact<double>(scene), scene, criterion, default_departure);
  return found.exists ? found.speed : std::nan("");
}

double slow_share(const Scene& scene) {
  return MixedContact<double>(scene).solve(scene.speeds.from).asperity_load_share;
}

// The number of an item with half of its last digit down and up; NaN where the paper gives none.
std::array<double, 3> reported(const Ledger& ledger, Quantity quantity, std::size_t surface) {
  for (const Item& item : ledger.items)
    if (item.quantity == quantity && static_cast<std::size_t>(item.surface) == surface)
      return {item.reported, item.reported - item.last_digit / 2,
              item.reported + item.last_digit / 2};
  const double none = std::nan("");
  return {none, none, none};
}

std::string row(const std::vector<double>& cells) {
  std::string text;
  for (const double cell : cells) text += (text.empty() ? "" : "\t") + exact(cell);
  return text;
}

}  // namespace

DataFile ledger_surfaces_data(const Ledger& ledger) {
  std::string text =
      "# Onset speeds (m/s) and asperity shares at the lowest speed, corrected reading, with the "
      "intervals of 95 % that varied inputs give\n"
      "# surface\tsd_nm\tonset_median\tonset_plausible_low\tonset_plausible_high\tonset_print_low\t"
      "onset_print_high\tonset_reported\treported_low\treported_high\tfilm_maximum\t"
      "friction_minimum\tshare_plausible_low\tshare_plausible_high\tshare_print_low\t"
      "share_print_high\tshare_reported\tshare_reported_low\tshare_reported_high\n";
  const Uncertainty& print = ledger.uncertainty[0];
  const Uncertainty& plausible = ledger.uncertainty[1];
  for (std::size_t i = 0; i < surface_count; ++i) {
    const Scene& scene = ledger.scenes.scene[i];
    const auto speed = reported(ledger, Quantity::onset_speed, i);
    const auto share = reported(ledger, Quantity::slow_asperity_share, i);
    text +=
        fmt::format("{}\t{}\n", surface_names[i],
                    row({nanometres * scene.surface.summit_height_sd, print.onset_speed[i].median,
                         plausible.onset_speed[i].low, plausible.onset_speed[i].high,
                         print.onset_speed[i].low, print.onset_speed[i].high, speed[0], speed[1],
                         speed[2], onset_speed(scene, OnsetCriterion::film_maximum),
                         onset_speed(scene, OnsetCriterion::friction_minimum),
                         plausible.slow_asperity_share[i].low,
                         plausible.slow_asperity_share[i].high, print.slow_asperity_share[i].low,
                         print.slow_asperity_share[i].high, share[0], share[1], share[2]}));
  }
  return {"data/ledger_surfaces.tsv", text};
}

DataFile ledger_law_data(const Ledger& ledger) {
  std::string text =
      "# Closed forms at constant n·β·σ_s, corrected reading: onset speeds (m/s), asperity share "
      "at "
      "the lowest speed\n# sd_nm\tfilm_maximum\tfilm_departure_0.05\tslow_asperity_share\n";
  const Scene& smooth = ledger.scenes.scene[static_cast<std::size_t>(ContactName::smooth)];
  for (int i = 0; i <= 60; ++i) {
    Scene scene = smooth;
    const double factor = 0.8 * std::pow(6.25, i / 60.0);  // 20 to 125 nm
    scene.surface.summit_height_sd *= factor;
    scene.surface.summit_density /= factor;
    text += row({nanometres * scene.surface.summit_height_sd,
                 onset_speed(scene, OnsetCriterion::film_maximum),
                 onset_speed(scene, OnsetCriterion::film_departure), slow_share(scene)}) +
            '\n';
  }
  return {"data/ledger_law.tsv", text};
}

DataFile ledger_scores_data(const Ledger& ledger) {
  std::string text =
      "# Of all readings, how many reproduce how many claims\n# claims\treadings\twho\n";
  for (std::size_t score = 0; score < ledger.ranking.histogram.size(); ++score) {
    std::string who;
    for (const NamedReading& reading : ledger.readings)
      if (reading.score == static_cast<int>(score)) who += (who.empty() ? "" : ", ") + reading.name;
    text += fmt::format("{}\t{}\t{}\n", score, ledger.ranking.histogram[score],
                        who.empty() ? "-" : who);
  }
  return {"data/ledger_scores.tsv", text};
}

}  // namespace tribo::report
