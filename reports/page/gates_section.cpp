// SPDX-License-Identifier: Apache-2.0
#include "page/gates_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "page/baselines.hpp"
#include "page/number_text.hpp"

namespace tribo::report {
namespace {

constexpr const char* proof_file = "gates.json";
constexpr const char* baseline_file = "performance.json";

std::string ratio(const Json& value) {
  return value.is_number() ? rounded(value.get<double>(), 5) : "–";
}

// What a gate found of one program, and how many findings were red.
struct Proof {
  std::string program;
  const Json* row;
};

std::vector<Proof> proofs(const Json& ledger) {
  std::vector<Proof> all;
  for (const Json& row : ledger.at("same_program"))
    all.push_back({"the same program twice (A/A)", &row});
  for (const Json& plant : ledger.at("planted"))
    for (const Json& row : plant.at("gates"))
      all.push_back({fmt::format("`{}`: {}", plant.at("id").get<std::string>(),
                                 plant.at("work").get<std::string>()),
                     &row});
  return all;
}

TextTable proof_table(const Json& ledger) {
  TextTable table{"What the gates found of a program with the same work, and of one with more",
                  {"held against the base", "gate", "workloads", "greatest ratio", "red findings",
                   "has to be", "is", "verdict"},
                  {false, false, true, true, true, false, false, false},
                  {},
                  "Greatest ratio: of a count, of instructions or of a median time to the base's."};
  for (const Proof& proof : proofs(ledger)) {
    const Json& row = *proof.row;
    table.rows.push_back(
        {proof.program, row.at("gate").get<std::string>(), row.at("workloads").dump(),
         ratio(row.at("greatest_ratio")), std::to_string(row.at("red").size()),
         row.at("expected").get<std::string>(), row.at("verdict").get<std::string>(),
         row.at("proved").get<bool>() ? "proved" : "NOT PROVED"});
  }
  return table;
}

// From the least to the median of a workload's repetitions, in units of the control kernel's time.
struct Band {
  double least;
  double median;
  double width() const { return median / least - 1; }
};

Band band_of(const Json& interval) {
  return {interval.at(0).get<double>(), interval.at(1).get<double>()};
}

double widest_band(const Json& baseline) {
  double widest = 0;
  for (const auto& [workload, interval] : baseline.at("time").items())
    widest = std::max(widest, band_of(interval).width());
  return widest;
}

TextTable baseline_table(const Json& baseline) {
  TextTable table{"The baseline that the gates hold",
                  {"workload", "instructions", "least time", "median time", "band"},
                  {false, true, true, true, true},
                  {},
                  "Instructions of a pass, by callgrind. Times of a pass over that of the control "
                  "kernel, `std::exp`; the band reaches from the least of the repetitions to their "
                  "median. A dash: not counted, or not timed, on that instruction set. " +
                      provenance(baseline)};
  const Json& instructions = baseline.at("instructions");
  const Json& time = baseline.at("time");
  const auto name = [](const std::string& workload) { return fmt::format("`{}`", workload); };
  for (const auto& [workload, interval] : time.items()) {
    const Band band = band_of(interval);
    const std::string counted = instructions.contains(workload)
                                    ? grouped(instructions.at(workload).get<std::uint64_t>())
                                    : "–";
    table.rows.push_back({name(workload), counted, rounded(band.least, 4), rounded(band.median, 4),
                          rounded(100 * band.width(), 2) + " %"});
  }
  for (const auto& [workload, counted] : instructions.items())
    if (!time.contains(workload))
      table.rows.push_back({name(workload), grouped(counted.get<std::uint64_t>()), "–", "–", "–"});
  return table;
}

// A sentence on the same program against itself, by the gate of time; empty: no such measurement.
std::string same_time(const Json& ledger) {
  for (const Json& row : ledger.at("same_program"))
    if (row.at("gate") == "time" && row.at("greatest_ratio").is_number())
      return fmt::format(" A program held against itself came to at most {} times its own time.",
                         ratio(row.at("greatest_ratio")));
  return {};
}

void fill_proof(Section& section, const Json& ledger) {
  std::size_t proved = 0;
  const auto all = proofs(ledger);
  for (const Proof& proof : all) {
    proved += proof.row->at("proved").get<bool>() ? 1 : 0;
    if (proof.row->contains("why"))
      section.not_run.push_back(
          {fmt::format("gate `{}`, {}", proof.row->at("gate").get<std::string>(), proof.program),
           proof.row->at("why").get<std::string>(), target_of(proof_file)});
  }
  section.tables.push_back(proof_table(ledger));
  section.paragraphs.push_back(
      "Three gates hold the kernels: exact work counters, instructions by callgrind, and CPU time. "
      "They have to pass a program against itself and to turn red when work is planted." +
      same_time(ledger) + " " + provenance(ledger));
  section.verdicts.push_back(
      {!all.empty() && proved == all.size() ? Standing::holds : Standing::fails, section.title,
       fmt::format("{} of {} gates said what they had to, of the same program and of planted "
                   "work.{} {}",
                   proved, all.size(), same_time(ledger), measured_when(ledger))});
}

void fill_baseline(Section& section, const Json& baseline) {
  section.tables.push_back(baseline_table(baseline));
  section.paragraphs.push_back(
      fmt::format("Repetitions of one program spread by at most {} % from the least to the median: "
                  "the widest A/A band of the baseline.",
                  rounded(100 * widest_band(baseline), 2)));
}

}  // namespace

Section gates_section(const ReportPlaces& places) {
  const Section proved = from_baseline({"gates", "Gates of speed"}, places, proof_file, fill_proof);
  return from_baseline(proved, places, baseline_file, fill_baseline);
}

}  // namespace tribo::report
