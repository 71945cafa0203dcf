// SPDX-License-Identifier: Apache-2.0
// How sure the paper's onset speeds are: the shipped sweeps, run while the report is made.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "page/groups.hpp"
#include "page/sweep_tables.hpp"
#include "page/write_file.hpp"
#include "sweep/plan_reader.hpp"
#include "sweep/run.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/onset.hpp"

namespace tribo::report {
namespace {

using sweep::ColumnResult;

// In the order of the ledger's surfaces.
constexpr std::array<const char*, 3> table_one_surfaces{"rough", "medium", "smooth"};
constexpr const char* result_path = "sweep/onset_uncertainty.h5";
constexpr const char* compared_column = "onset.film_maximum.speed";
constexpr double most_deviations = 3.5;  // nine comparisons exceed it by chance once in 200 times

sweep::SceneSweep read_one(const ReportPlaces& places, const std::string& surface) {
  const std::filesystem::path path =
      places.scenes / "sweeps" / fmt::format("onset_{}.toml", surface);
  sweep::SweepReading reading = sweep::read_sweep(path.string());
  if (!reading.sweep) throw std::runtime_error(reading.errors.front().line());
  if (reading.sweep->scene.id != surface)
    throw std::runtime_error(
        fmt::format("{} has the id {}, not {}", path.string(), reading.sweep->scene.id, surface));
  if (!reading.sweep->sensitivity)
    throw std::runtime_error(path.string() + " asks for no sensitivity");
  reading.sweep->file = places.shown(path);
  return std::move(*reading.sweep);
}

sweep::SweepResult run_sweep(const ReportPlaces& places, const sweep::SweepPlan& plan) {
  const std::filesystem::path path = places.out / result_path;
  make_folder(path.parent_path());
  sweep::RunSettings settings;
  settings.result = path.string();
  settings.force = true;
  const sweep::Ranks ranks;
  sweep::run(plan, settings, ranks);
  return sweep::ResultFile(settings.result).read();
}

// A number to hold the onset speeds of a surface against, as it was printed.
struct Reported {
  double value, low, high;  // m/s; the ends are what rounds to the value
};

Reported reported_onset(const reproduction::Ledger& ledger, std::size_t surface) {
  for (const reproduction::Item& item : ledger.items)
    if (item.quantity == reproduction::Quantity::onset_speed &&
        static_cast<std::size_t>(item.surface) == surface)
      return {item.reported, item.reported - item.last_digit / 2,
              item.reported + item.last_digit / 2};
  throw std::runtime_error(fmt::format("no onset speed of the {} surface is reported in claims.tsv",
                                       table_one_surfaces[surface]));
}

Json nominal_speed(const sweep::SceneSweep& sweep, OnsetCriterion criterion) {
  const MixedContact<double> contact(sweep.scene);
  const Onset<double> found = onset(contact, sweep.scene, criterion, sweep.departure);
  return found.exists ? Json(found.speed) : Json(nullptr);
}

// The part of the cases below a speed, from the counts of the histogram; linear within a bar.
double part_below(const ColumnResult::Value& value, double speed) {
  double below = 0;
  for (const auto& bin : value.histogram)
    below += static_cast<double>(bin.count) *
             std::clamp((speed - bin.low) / (bin.high - bin.low), 0.0, 1.0);
  return below / static_cast<double>(value.count);
}

const char* place_of(const ColumnResult::Value& value, double speed) {
  if (value.count == 0) return "no onsets";
  if (speed < value.least) return "below all";
  if (speed > value.greatest) return "above all";
  return "among them";
}

const ColumnResult& speed_column(const sweep::SceneResult& scene, std::string_view criterion) {
  const ColumnResult* const column = scene.column(fmt::format("onset.{}.speed", criterion));
  if (column == nullptr)
    throw std::runtime_error(
        fmt::format("{} does not ask for the onset by {}", scene.file, criterion));
  return *column;
}

// The onset speeds of a surface by each criterion, and where the reported one lies among them.
Json speeds_json(const sweep::SceneSweep& scene, const sweep::SceneResult& result,
                 const Reported& reported) {
  Json speeds = Json::array();
  for (const OnsetCriterion criterion : scene.criteria) {
    const ColumnResult& column = speed_column(result, name(criterion));
    const ColumnResult::Value& value = column.values.front();
    speeds.push_back(
        {{"criterion", name(criterion)},
         {"column", column.name},
         {"as_printed", nominal_speed(scene, criterion)},
         {"reported_lies", place_of(value, reported.value)},
         {"cases_below_reported",
          value.count > 0 ? Json(part_below(value, reported.value)) : Json()},
         {"reported_is_within_95_percent", reported.high >= quantile(value, 0.025).value &&
                                               reported.low <= quantile(value, 0.975).value}});
  }
  return speeds;
}

// The print-precision draws of the ledger, compared with the draws of this sweep.
struct Agreement {
  double farthest = 0;       // relative, of 2.5 %, 50 %, 97.5 % on all surfaces
  double in_deviations = 0;  // the greatest distance in standard deviations of sampling
};
Agreement agreement(const sweep::SweepResult& result, const reproduction::Uncertainty& print) {
  Agreement found;
  for (std::size_t i = 0; i < table_one_surfaces.size(); ++i) {
    const ColumnResult::Value& value = result.scenes[i].column(compared_column)->values.front();
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

// The JSON of `tribocheck sweep show --format json`, with the speed of each onset alone.
Json result_json(const sweep::SweepResult& result) {
  Json json = sweep_json(result);
  for (Json& scene : json["scenes"]) {
    Json& columns = scene["columns"];
    columns.erase(std::remove_if(columns.begin(), columns.end(),
                                 [](const Json& column) {
                                   return !column["name"].get<std::string>().ends_with(".speed");
                                 }),
                  columns.end());
  }
  return json;
}

DataFile result_file(const ReportPlaces& places) {
  std::ifstream file(places.out / result_path, std::ios::binary);
  return {result_path, {std::istreambuf_iterator<char>(file), {}}};
}

}  // namespace

Group onset_uncertainty_group(const ReportPlaces& places, const reproduction::Ledger& ledger) {
  std::vector<sweep::SceneSweep> scenes;
  for (const char* const surface : table_one_surfaces) scenes.push_back(read_one(places, surface));
  const sweep::SweepPlan plan = sweep::make_plan(std::move(scenes));
  const sweep::SweepResult result = run_sweep(places, plan);
  const reproduction::Uncertainty& print = ledger.uncertainty.front();

  Group group;
  Json per_surface = Json::array();
  for (std::size_t i = 0; i < table_one_surfaces.size(); ++i) {
    const Reported reported = reported_onset(ledger, i);
    per_surface.push_back(
        {{"surface", table_one_surfaces[i]},
         {"reported", {{"value", reported.value}, {"low", reported.low}, {"high", reported.high}}},
         {"speeds", speeds_json(plan.scenes[i], result.scenes[i], reported)}});
  }
  const Agreement found = agreement(result, print);
  const bool agree = found.in_deviations <= most_deviations;
  group.data = {{"inputs_drawn", plan.scenes.front().drawn()},
                {"surfaces", std::move(per_surface)},
                {"agreement",
                 {{"column", compared_column},
                  {"ledger_draws", print.draws},
                  {"farthest", found.farthest},
                  {"in_deviations", found.in_deviations},
                  {"most_deviations", most_deviations},
                  {"agree", agree}}},
                {"sweep", result_json(result)}};
  group.findings = {{"onset_speeds_drawn", "uncertainty", About::paper, Standing::measured},
                    {"onset_speeds_drawn_twice", "uncertainty", About::software,
                     agree ? Standing::holds : Standing::fails}};
  group.files = {result_file(places)};
  return group;
}

}  // namespace tribo::report
