// SPDX-License-Identifier: Apache-2.0
#include "page/onset_uncertainty_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "page/number_text.hpp"
#include "page/pending_file.hpp"
#include "page/sweep_picture_parts.hpp"
#include "page/sweep_values.hpp"
#include "sweep/plan_reader.hpp"
#include "sweep/run.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/onset.hpp"

namespace tribo::report {
namespace {

using sweep::ColumnResult;
using sweep::SceneResult;

// In the order of the ledger's surfaces.
constexpr std::array<const char*, 3> surface_names{"rough", "medium", "smooth"};
constexpr const char* result_path = "sweep/onset_uncertainty.h5";
constexpr const char* first_criterion = "film_maximum";

std::string speed_column(std::string_view criterion) {
  return fmt::format("onset.{}.speed", criterion);
}

// The data of this section. A surface is given by its index in surface_names.
struct Swept {
  sweep::SweepPlan plan;
  sweep::SweepResult result;
  std::vector<ReportedOnset> reported;

  const ColumnResult::Value& speeds(std::size_t surface, std::string_view criterion) const {
    const ColumnResult* const column = result.scenes[surface].column(speed_column(criterion));
    if (column == nullptr)
      throw std::runtime_error(
          fmt::format("{} does not ask for the onset by {}", plan.scenes[surface].file, criterion));
    return column->values.front();
  }
};

sweep::SceneSweep read_one(const ReportPlaces& places, const std::string& surface) {
  const std::filesystem::path path =
      places.scenes / "sweeps" / fmt::format("onset_{}.toml", surface);
  sweep::SweepReading reading = sweep::read_sweep(path.string());
  if (!reading.sweep) throw std::runtime_error(reading.errors.front().line());
  if (reading.sweep->scene.id != surface)
    throw std::runtime_error(
        fmt::format("{} has the id {}, not {}", path.string(), reading.sweep->scene.id, surface));
  reading.sweep->file = places.shown(path);
  return std::move(*reading.sweep);
}

std::vector<ReportedOnset> reported_onsets(const reproduction::Ledger& ledger) {
  std::vector<ReportedOnset> reported;
  for (const reproduction::Item& item : ledger.items)
    if (item.quantity == reproduction::Quantity::onset_speed)
      reported.push_back({surface_names.at(static_cast<std::size_t>(item.surface)), item.reported,
                          item.reported - item.last_digit / 2,
                          item.reported + item.last_digit / 2});
  return reported;
}

Swept swept(const ReportPlaces& places, const reproduction::Ledger& ledger) {
  std::vector<sweep::SceneSweep> scenes;
  for (const char* const surface : surface_names) scenes.push_back(read_one(places, surface));
  Swept all{sweep::make_plan(std::move(scenes)), {}, reported_onsets(ledger)};
  const std::filesystem::path path = places.out / result_path;
  make_folder(path.parent_path());
  sweep::RunSettings settings;
  settings.result = path.string();
  settings.force = true;
  const sweep::Ranks ranks;
  sweep::run(all.plan, settings, ranks);
  all.result = sweep::read_result(settings.result);
  return all;
}

DataFile result_file(const ReportPlaces& places) {
  std::ifstream file(places.out / result_path, std::ios::binary);
  return {result_path, {std::istreambuf_iterator<char>(file), {}}};
}

double nominal_speed(const sweep::SceneSweep& sweep, OnsetCriterion criterion) {
  const MixedContact<double> contact(sweep.scene);
  const Onset<double> found = onset(contact, sweep.scene, criterion, sweep.departure);
  return found.exists ? found.speed : std::nan("");
}

// The part of the cases below a speed, from the counts of the histogram; linear within a bar.
double part_below(const ColumnResult::Value& value, double speed) {
  double below = 0;
  for (const auto& bin : value.histogram)
    below += static_cast<double>(bin.count) *
             std::clamp((speed - bin.low) / (bin.high - bin.low), 0.0, 1.0);
  return below / static_cast<double>(value.count);
}

std::string place_of(const ColumnResult::Value& value, double speed) {
  if (value.count == 0) return "–";
  if (speed < value.least) return "below all";
  if (speed > value.greatest) return "above all";
  return rounded(100 * part_below(value, speed), 2) + " %";
}

std::string speed_text(double value) { return std::isnan(value) ? "–" : rounded(value, 3); }

TextTable speed_table(const Swept& all) {
  TextTable table{"Onset speeds within the precision of Table 1, m/s",
                  {"surface", "criterion", "as printed", "2.5 %", "median", "97.5 %", "no onset in",
                   "reported", "the reported one lies at"},
                  {false, false, true, true, true, true, true, true, true},
                  {},
                  "As printed: with every number as Table 1 has it, misprints mended. The last "
                  "column is the part of the cases "
                  "that set in below the reported speed."};
  for (std::size_t i = 0; i < surface_names.size(); ++i) {
    const sweep::SceneSweep& scene = all.plan.scenes[i];
    const auto mark = std::find_if(all.reported.begin(), all.reported.end(),
                                   [&](const auto& one) { return one.scene == scene.scene.id; });
    for (const OnsetCriterion criterion : scene.criteria) {
      const ColumnResult::Value& value = all.speeds(i, name(criterion));
      const auto cases = static_cast<double>(value.count + value.undefined);
      table.rows.push_back(
          {surface_names[i], fmt::format("`{}`", name(criterion)),
           speed_text(nominal_speed(scene, criterion)), speed_text(quantile(value, 0.025).value),
           speed_text(quantile(value, 0.5).value), speed_text(quantile(value, 0.975).value),
           value.undefined == 0
               ? "0 %"
               : rounded(100 * static_cast<double>(value.undefined) / cases, 2) + " %",
           mark == all.reported.end() ? "–" : unrounded(mark->value),
           mark == all.reported.end() ? "–" : place_of(value, mark->value)});
    }
  }
  return table;
}

const sweep::SobolIndex* total_of(const Swept& all, std::size_t surface, std::string_view criterion,
                                  const std::string& variable) {
  const auto& variables = all.result.scenes[surface].sensitivity_variables;
  const auto place = static_cast<std::size_t>(
      std::find(variables.begin(), variables.end(), variable) - variables.begin());
  const auto& totals = all.speeds(surface, criterion).sensitivity.total;
  return place < totals.size() ? &totals[place] : nullptr;
}

// All fields that vary on any surface, those of the greatest total first.
std::vector<std::pair<double, std::string>> ranked(const Swept& all, std::string_view criterion) {
  std::vector<std::pair<double, std::string>> list;
  for (const SceneResult& scene : all.result.scenes)
    for (const std::string& variable : scene.sensitivity_variables) {
      if (std::any_of(list.begin(), list.end(),
                      [&](const auto& one) { return one.second == variable; }))
        continue;
      double greatest = 0;
      for (std::size_t i = 0; i < surface_names.size(); ++i)
        if (const auto* const total = total_of(all, i, criterion, variable))
          greatest = std::max(greatest, total->value);
      list.emplace_back(greatest, variable);
    }
  std::stable_sort(list.begin(), list.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  return list;
}

TextTable total_table(const Swept& all) {
  constexpr double shown_from = 0.005;
  TextTable table{
      "What carries the uncertainty: total Sobol indices of the onset speed",
      {"criterion", "input", "rough", "medium", "smooth"},
      {false, false, true, true, true},
      {},
      fmt::format("The part of the variance that the input brings with all others, ± 1.96 standard "
                  "errors. Inputs below {} on all surfaces are left out.",
                  shown_from)};
  for (const OnsetCriterion criterion : all.plan.scenes.front().criteria) {
    for (const auto& [greatest, variable] : ranked(all, name(criterion))) {
      if (greatest < shown_from) continue;
      std::vector<std::string> row{fmt::format("`{}`", name(criterion)),
                                   fmt::format("`{}`", variable)};
      for (std::size_t i = 0; i < surface_names.size(); ++i) {
        const auto* const total = total_of(all, i, name(criterion), variable);
        row.push_back(total == nullptr ? "–" : with_error(*total));
      }
      table.rows.push_back(std::move(row));
    }
    for (std::size_t i = 0; i < surface_names.size(); ++i) {
      const std::uint64_t groups = all.speeds(i, name(criterion)).sensitivity.groups;
      const std::uint64_t draws = all.plan.scenes[i].draws;
      if (groups < draws)
        table.note +=
            fmt::format(" `{}`, {}: over the {} of {} groups of cases that all have an onset.",
                        name(criterion), surface_names[i], grouped(groups), grouped(draws));
    }
  }
  return table;
}

std::string carriers(const Swept& all) {
  std::string text;
  for (std::size_t i = 0; i < surface_names.size(); ++i) {
    const SceneResult& scene = all.result.scenes[i];
    const auto& totals = all.speeds(i, first_criterion).sensitivity.total;
    if (totals.empty()) throw std::runtime_error(scene.file + " asks for no sensitivity");
    const auto first =
        std::max_element(totals.begin(), totals.end(),
                         [](const auto& a, const auto& b) { return a.value < b.value; });
    const auto place = static_cast<std::size_t>(first - totals.begin());
    text += fmt::format("{}`{}` with {} % on the {} surface", text.empty() ? "" : ", ",
                        scene.sensitivity_variables[place], rounded(100 * first->value, 2),
                        surface_names[i]);
  }
  return text;
}

// The print-precision draws of the ledger, compared with the draws of this sweep by film_maximum.
struct Agreement {
  double farthest = 0;       // of 2.5 %, 50 %, 97.5 % on all surfaces: part of the value
  double in_deviations = 0;  // the greatest distance in standard deviations of sampling
};
Agreement agreement(const Swept& all, const reproduction::Uncertainty& print) {
  Agreement found;
  for (std::size_t i = 0; i < surface_names.size(); ++i) {
    const ColumnResult::Value& value = all.speeds(i, first_criterion);
    const reproduction::Interval& drawn = print.onset_speed[i];
    for (const auto& [level, other] : {std::pair{0.025, drawn.low}, std::pair{0.5, drawn.median},
                                       std::pair{0.975, drawn.high}}) {
      const sweep::Quantile& ours = quantile(value, level);
      const double distance = std::abs(ours.value - other);
      // The interval of ours spans 2 · 1.96 standard deviations of independent draws.
      const double deviation =
          (ours.high - ours.low) / (2 * 1.96) *
          std::sqrt(1 + static_cast<double>(value.count) / static_cast<double>(print.draws));
      found.farthest = std::max(found.farthest, distance / other);
      found.in_deviations = std::max(found.in_deviations, distance / deviation);
    }
  }
  return found;
}

constexpr double most_deviations = 3.5;  // of nine comparisons: by chance once in 200 times

std::string agreement_text(const Agreement& found, const reproduction::Uncertainty& print) {
  return fmt::format(
      "Medians and ends of the intervals are within {} % of those of the ledger's {} draws of "
      "another generator (`film_maximum`), at most {} standard deviations of sampling apart: {}.",
      rounded(100 * found.farthest, 2), grouped(print.draws), rounded(found.in_deviations, 2),
      found.in_deviations <= most_deviations ? "the two agree" : "the two do not agree");
}

// "rough 0.5 (below all)"
std::string reported_text(const Swept& all, std::string_view criterion) {
  std::string text;
  for (const ReportedOnset& one : all.reported)
    for (std::size_t i = 0; i < surface_names.size(); ++i)
      if (one.scene == surface_names[i])
        text += fmt::format("{}{} {} ({})", text.empty() ? "" : ", ", one.scene,
                            unrounded(one.value), place_of(all.speeds(i, criterion), one.value));
  return text;
}

bool any_inside(const Swept& all, std::string_view criterion) {
  for (const ReportedOnset& one : all.reported)
    for (std::size_t i = 0; i < surface_names.size(); ++i) {
      const ColumnResult::Value& value = all.speeds(i, criterion);
      if (one.scene == surface_names[i] && one.high >= quantile(value, 0.025).value &&
          one.low <= quantile(value, 0.975).value)
        return true;
    }
  return false;
}

std::string inside_text(const Swept& all) {
  std::string inside, outside;
  for (const OnsetCriterion criterion : all.plan.scenes.front().criteria) {
    std::string& list = any_inside(all, name(criterion)) ? inside : outside;
    list += fmt::format("{}`{}`", list.empty() ? "" : ", ", name(criterion));
  }
  if (inside.empty())
    return "By no criterion does a reported speed lie in the 95 % of its surface: the print "
           "precision does not explain the differences.";
  return fmt::format("A reported speed lies in the 95 % of its surface by {}{}.", inside,
                     outside.empty() ? "" : "; none does by " + outside);
}

void add_figure(Section& section, std::optional<SweepPicture> picture, std::string label) {
  if (!picture) return;
  picture->figure.label = std::move(label);
  section.figures.push_back(std::move(picture->figure));
  section.data.push_back(std::move(picture->data));
}

void fill(Section& section, const ReportPlaces& places, const reproduction::Ledger& ledger) {
  const Swept all = swept(places, ledger);
  const reproduction::Uncertainty& print = ledger.uncertainty[0];
  const Agreement found = agreement(all, print);
  const sweep::SceneSweep& scene = all.plan.scenes.front();
  section.paragraphs = {
      fmt::format("Table 1 prints its numbers to one to four digits. Here each of the {} inputs is "
                  "drawn uniformly within half a unit of its last digit, independently of the "
                  "others, and each of {} cases a surface is solved for its onsets "
                  "(`tribocheck sweep`, `reference/published/sweeps`). The intervals say what is "
                  "left open by the print alone, if model and closures are right; they say "
                  "nothing of the model.",
                  scene.drawn(), grouped(scene.cases())),
      fmt::format("Most of the variance of the onset speed (`{}`) is carried by {}. {}",
                  first_criterion, carriers(all), inside_text(all)),
      agreement_text(found, print)};
  section.tables = {speed_table(all), total_table(all)};
  section.data = {result_file(places)};
  add_figure(section, onset_distribution(all.result, all.reported), "Scatter");
  add_figure(section, sensitivity(all.result, speed_column(first_criterion)), "Sobol");
  section.verdicts = {
      {Standing::measured, "Onset speeds and the print precision",
       fmt::format("Where the reported onset speeds (m/s) lie among those that Table 1's last "
                   "digits allow, by `{}`: {}. Most of the variance is carried by {}.",
                   first_criterion, reported_text(all, first_criterion), carriers(all))},
      {found.in_deviations <= most_deviations ? Standing::holds : Standing::fails,
       "Onset speeds drawn twice", agreement_text(found, print)}};
}

}  // namespace

Section onset_uncertainty_section(const ReportPlaces& places, const reproduction::Ledger& ledger) {
  return filled_or_excused({"sweep", "How sure the onset speeds are"},
                           "`sweeps` beside the scenes, and `make report`,",
                           [&](Section& section) { fill(section, places, ledger); });
}

}  // namespace tribo::report
