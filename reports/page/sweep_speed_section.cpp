// SPDX-License-Identifier: Apache-2.0
#include "page/sweep_speed_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "page/baselines.hpp"
#include "page/number_text.hpp"

namespace tribo::report {
namespace {

constexpr const char* file = "sweep.json";
constexpr double most_times_alone = 1.5;  // with summaries kept
constexpr double least_speedup = 1.8;     // on two cores
constexpr double most_mb = 300;           // of a rank

double number(const Json& value) { return value.get<double>(); }

TextTable ratio_table(const Json& ratios) {
  TextTable table{"Time a point of a sweep beside that of its scenes and roots alone",
                  {"sweep", "alone, ns", "summaries, ns", "times alone", "points, ns",
                   "times alone", "drawing, ns"},
                  {false, true, true, true, true, true, true},
                  {},
                  "Alone: scenes prepared, roots in batches, films and onsets completed, of inputs "
                  "that are there. Summaries and points: from a chunk's number to its record in "
                  "the journal. CPU time of one thread, medians of the fastest third of "
                  "interleaved repetitions."};
  for (const auto& entry : ratios.items()) {
    const Json& times = entry.value();
    const double alone = number(times.at("alone"));
    const auto cells = [&](const char* kept) {
      const double ns = number(times.at(kept));
      return std::pair(rounded(ns, 3), rounded(ns / alone, 3));
    };
    const auto [summaries, times_summaries] = cells("summaries");
    const auto [points, times_points] = cells("points");
    table.rows.push_back({fmt::format("`{}`", entry.key()), rounded(alone, 3), summaries,
                          times_summaries, points, times_points,
                          rounded(number(times.at("stage: draw")), 3)});
  }
  return table;
}

double greatest_ratio(const Json& ratios) {
  double greatest = 0;
  for (const auto& [sweep, times] : ratios.items())
    greatest = std::max(greatest, number(times.at("summaries")) / number(times.at("alone")));
  return greatest;
}

double greatest_memory(const Json& memory) {
  double greatest = 0;
  for (const auto& [name, of] : memory.items())
    for (const auto& [rank, mb] : of.at("mb_of_rank").items())
      greatest = std::max(greatest, number(mb));
  return greatest;
}

TextTable model_table(const Json& model) {
  TextTable table{"What more ranks would take, by the model of `benchmarks/sweep/README.md`",
                  {"kept", "points", "chunks"},
                  {false, true, true},
                  {},
                  "Time, the part of it that all ranks use well, and what takes the most of it."};
  for (const Json& time : model.at("rows").at(0).at("times")) {
    const auto ranks = time.at("ranks").get<std::uint64_t>();
    table.headings.push_back(grouped(ranks) + (ranks == 1 ? " rank" : " ranks"));
    table.is_number.push_back(true);
  }
  for (const Json& row : model.at("rows")) {
    std::vector<std::string> cells{row.at("keep").get<std::string>(),
                                   rounded(number(row.at("points")), 1),
                                   grouped(row.at("chunks").get<std::uint64_t>())};
    for (const Json& time : row.at("times"))
      cells.push_back(fmt::format("{} s, {} %, {}", rounded(number(time.at("seconds")), 2),
                                  rounded(100 * number(time.at("efficiency")), 2),
                                  time.at("most").get<std::string>()));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

void fill(Section& section, const Json& baseline) {
  const Json& ratios = baseline.at("ratios");
  const Json& ranks = baseline.at("ranks");
  const Json& model = baseline.at("model");
  const double speedup = number(baseline.at("threads").at("speedup").at("summaries"));
  const double ratio = greatest_ratio(ratios), memory = greatest_memory(baseline.at("memory"));
  section.tables = {ratio_table(ratios), model_table(model)};
  section.paragraphs = {
      "Sweeps beside what they cannot do without, and on threads and ranks. " +
          provenance(baseline),
      fmt::format(
          "Two threads are {} times as fast as one, without what other processes made them wait. "
          "Two "
          "ranks are {} times as fast by the clock, and at most {} times by their CPU time; with "
          "twice the points they keep {} % and at most {} %. The clock's numbers suffer from other "
          "processes, which used up to {} of {} processors meanwhile.",
          rounded(speedup, 3), rounded(number(ranks.at("speedup").at("2")), 3),
          rounded(number(ranks.at("cpu_speedup").at("2")), 3),
          rounded(100 * number(ranks.at("weak_efficiency")), 3),
          rounded(100 * number(ranks.at("weak_cpu_efficiency")), 3),
          rounded(number(baseline.at("others")), 2), baseline.at("processors").get<int>()),
      fmt::format(
          "Rank 0 is busy with requests from {} ranks on. Journals of points fill the disk from {} "
          "ranks on, and writing points takes as long as computing them on {} ranks: beyond these "
          "only summaries gain.",
          rounded(number(model.at("ranks_that_fill_rank_0")), 2),
          rounded(number(model.at("ranks_whose_journals_fill_the_disk")), 2),
          rounded(number(model.at("ranks_that_compute_as_long_as_points_are_written")), 2))};
  const bool reached = ratio <= most_times_alone && speedup >= least_speedup && memory < most_mb;
  section.verdicts = {
      {Standing::measured, section.title,
       fmt::format(
           "What is aimed at is {}: a point takes at most {} times its scene and root alone "
           "where summaries are kept (aimed at: {}), two threads are {} times as fast as "
           "one (at least {}), and a rank has at most {} MB (below {}). {}",
           reached ? "reached" : "NOT REACHED", rounded(ratio, 3), rounded(most_times_alone, 2),
           rounded(speedup, 3), rounded(least_speedup, 2), rounded(memory, 3), rounded(most_mb, 3),
           measured_when(baseline))}};
}

}  // namespace

Section sweep_speed_section(const ReportPlaces& places) {
  return from_baseline({"sweep-speed", "Speed of sweeps"}, places, file, fill);
}

}  // namespace tribo::report
