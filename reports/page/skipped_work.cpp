// SPDX-License-Identifier: Apache-2.0
#include "page/skipped_work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "page/number_text.hpp"
#include "tribo/operating_points.hpp"

namespace tribo::report {
namespace {

constexpr std::size_t count = 10000;  // speeds of each scene, log-spaced over its range

std::vector<double> speeds_of(const SolvedCase& one) {
  Speeds speeds;
  speeds.from = one.range.low;
  speeds.to = one.range.high;
  speeds.count = count;
  speeds.spacing = Spacing::log;
  std::vector<double> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = speeds[i];
  return all;
}

// The steps of all roots; a root that is λ₀ or λ_b without a step counts as one step.
std::uint64_t steps_of_all(const MixedContact<double>& contact, const std::vector<double>& speeds) {
  OutputSet film;
  film.insert(Output::film_flooded);
  OperatingPoints points;
  points.resize(speeds.size(), film);
  WorkCounts work;
  solve(contact, speeds, film, points, work);
  return work[Work::root_step] + work[Work::root_is_film] + work[Work::root_is_floor];
}

struct Asked {
  const char* name;
  OutputSet outputs;
};

OutputSet set_of(std::initializer_list<Output> outputs) {
  OutputSet set;
  for (const Output output : outputs) set.insert(output);
  return set;
}

struct Saved {
  double least = 1;
  double greatest = 0;
};

// A row of the table: root steps, skipped work, and the part of the moments that is saved, compared
// with all outputs when every root takes a step or more.
std::vector<std::string> skip_row(const SolvedCase& one, const std::vector<double>& speeds,
                                  std::uint64_t all_steps, const Asked& asked, Saved& saved) {
  OperatingPoints points;
  points.resize(speeds.size(), asked.outputs);
  WorkCounts work;
  solve(one.contact, speeds, asked.outputs, points, work);
  const std::uint64_t done = work[Work::root_step] + work[Work::share] + work[Work::moment];
  const std::uint64_t full = all_steps + 3 * count;  // a share and two moments a point
  const double part = static_cast<double>(full - std::min(full, done)) / static_cast<double>(full);
  saved = {std::min(saved.least, part), std::max(saved.greatest, part)};
  return {one.source.stem(),
          asked.name,
          grouped(work[Work::root_step]),
          grouped(work[Work::root_is_film]),
          grouped(work[Work::root_is_floor]),
          grouped(work[Work::share_not_asked] + work[Work::share_is_nothing]),
          grouped(count - work[Work::starvation]),
          fmt::format("{:.0f} %", 100 * part)};
}

}  // namespace

Section skipped_work_section(const std::vector<SolvedCase>& solved) {
  const std::vector<Asked> requests{
      {"all outputs", OutputSet::all()},
      {"`film`", set_of({Output::film})},
      {"`fluid_load_share`, `regime`", set_of({Output::fluid_load_share, Output::regime})},
      {"`real_area_ratio`", set_of({Output::real_area_ratio})}};
  Section section{"skipped-work", "What was skipped"};
  section.paragraphs = {fmt::format(
      "What a scene does not ask for is not computed. {} speeds over each scene's range, counted "
      "by "
      "the model itself for this page. A root is λ~0~ or λ~b~ to half an ulp where a bound proves "
      "it. Starvation is skipped past a collapse too.",
      grouped(count))};
  TextTable table{
      "Work skipped, by what is asked",
      {"scene", "asked", "root steps", "roots skipped: λ = λ~0~", "roots skipped: λ = λ~b~",
       "load shares skipped", "starvation skipped", "moments saved"},
      {false, false, true, true, true, true, true, true},
      {},
      "Saved are evaluations of F~n~: of those that all outputs take with a step or more for every "
      "root."};
  Saved least_and_most;
  for (const SolvedCase& one : solved) {
    const std::vector<double> speeds = speeds_of(one);
    const std::uint64_t all_steps = steps_of_all(one.contact, speeds);
    for (const Asked& asked : requests)
      table.rows.push_back(skip_row(one, speeds, all_steps, asked, least_and_most));
  }
  section.tables = {std::move(table)};
  section.verdicts = {{Standing::measured, "Skipped work",
                       fmt::format("By what it asks, a scene saves {:.0f} % to {:.0f} % of the "
                                   "evaluations of F~n~. Counted for this page.",
                                   100 * least_and_most.least, 100 * least_and_most.greatest)}};
  return section;
}

}  // namespace tribo::report
