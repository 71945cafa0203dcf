// SPDX-License-Identifier: Apache-2.0
// The gates of speed and the speed of sweeps.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "page/baselines.hpp"
#include "page/groups.hpp"

namespace tribo::report {
namespace {

// The verdict of a gate on one program.
Json proof_json(const Json& row, const Json& program) {
  Json proof = program;
  copy<std::string>(row, {"gate", "expected", "verdict"}, proof);
  copy<std::size_t>(row, {"workloads"}, proof);
  copy<bool>(row, {"proved"}, proof);
  proof["greatest_ratio"] = number_or_null(row.at("greatest_ratio"));
  proof["red"] = row.at("red").size();
  if (row.contains("why")) copy<std::string>(row, {"why"}, proof);
  return proof;
}

Json all_proofs(const Json& baseline) {
  Json proofs = Json::array();
  for (const Json& row : baseline.at("same_program"))
    proofs.push_back(proof_json(row, Json::object()));
  for (const Json& plant : baseline.at("planted")) {
    Json program;
    copy<std::string>(plant, {"id", "work"}, program["planted"]);
    for (const Json& row : plant.at("gates")) proofs.push_back(proof_json(row, program));
  }
  return proofs;
}

Group proved_gates(const Json& baseline) {
  Group group{run_of(baseline)};
  Json proofs = all_proofs(baseline);
  std::size_t proved = 0;
  Json same_time;
  for (const Json& proof : proofs) {
    proved += proof["proved"].get<bool>() ? 1 : 0;
    if (!proof.contains("planted") && proof["gate"] == "time") same_time = proof["greatest_ratio"];
    if (proof.contains("why"))
      group.not_run.push_back({"gate `" + proof["gate"].get<std::string>() + "`",
                               proof["why"].get<std::string>(), "`make gate-proof`"});
  }
  group.findings = {{"gates", "gates", About::software, Standing::holds}};
  if (proofs.empty() || proved < proofs.size())
    group.findings = {{"gates", "gates", About::software, Standing::fails,
                       fmt::format("{} of {} gates did not say what they had to.",
                                   proofs.size() - proved, proofs.size())}};
  group.data.update({{"proved", proved},
                     {"greatest_time_of_the_same_program", same_time},
                     {"proofs", std::move(proofs)}});
  return group;
}

// Instructions and times of each workload; null where it is not counted or not timed.
Json gate_baseline(const Json& baseline) {
  const Json& instructions = baseline.at("instructions");
  const Json& time = baseline.at("time");
  Json workloads = Json::array();
  double widest = 0;
  const auto counted = [&](const std::string& workload) {
    return instructions.contains(workload) ? Json(instructions.at(workload).get<std::size_t>())
                                           : Json();
  };
  for (const auto& [workload, interval] : time.items()) {
    const auto least = interval.at(0).get<double>(), median = interval.at(1).get<double>();
    const double band = median / least - 1;
    widest = std::max(widest, band);
    workloads.push_back({{"workload", workload},
                         {"instructions", counted(workload)},
                         {"least_time", least},
                         {"median_time", median},
                         {"band", band}});
  }
  for (const auto& entry : instructions.items())
    if (!time.contains(entry.key()))
      workloads.push_back({{"workload", entry.key()},
                           {"instructions", counted(entry.key())},
                           {"least_time", nullptr},
                           {"median_time", nullptr},
                           {"band", nullptr}});
  Json json = run_of(baseline);
  json.update({{"widest_band", widest}, {"workloads", std::move(workloads)}});
  return json;
}

// Times of a point of each sweep beside those of its scenes and roots alone.
Json sweep_ratios(const Json& ratios) {
  Json rows = Json::array();
  for (const auto& [sweep, times] : ratios.items()) {
    const auto alone = times.at("alone").get<double>();
    const auto summaries = times.at("summaries").get<double>();
    const auto points = times.at("points").get<double>();
    rows.push_back({{"sweep", sweep},
                    {"alone_ns", alone},
                    {"summaries_ns", summaries},
                    {"summaries_times_alone", summaries / alone},
                    {"points_ns", points},
                    {"points_times_alone", points / alone},
                    {"drawing_ns", times.at("stage: draw").get<double>()}});
  }
  return rows;
}

double greatest_memory(const Json& memory) {
  double greatest = 0;
  for (const auto& run : memory.items())
    for (const auto& rank : run.value().at("mb_of_rank").items())
      greatest = std::max(greatest, rank.value().get<double>());
  return greatest;
}

// The targets, the values reached, and whether each target is met.
Json targets_json(const Json& ratios, const Json& baseline) {
  double greatest = 0;
  for (const Json& row : ratios)
    greatest = std::max(greatest, row["summaries_times_alone"].get<double>());
  const auto speedup = baseline.at("threads").at("speedup").at("summaries").get<double>();
  const double memory = greatest_memory(baseline.at("memory"));
  const auto target = [](double is, const char* kind, double aim, bool reached) -> Json {
    return {{"is", is}, {kind, aim}, {"reached", reached}};
  };
  return {{"times_alone", target(greatest, "at_most", 1.5, greatest <= 1.5)},
          {"two_threads", target(speedup, "at_least", 1.8, speedup >= 1.8)},
          {"mb_of_rank", target(memory, "below", 300, memory < 300)}};
}

Group sweep_speed(const Json& baseline) {
  Group group{run_of(baseline)};
  copy<std::size_t>(baseline, {"processors"}, group.data);
  copy<double>(baseline, {"others"}, group.data);
  group.data["ratios"] = sweep_ratios(baseline.at("ratios"));
  group.data["targets"] = targets_json(group.data["ratios"], baseline);
  const Json& ranks = baseline.at("ranks");
  Json two;
  for (const char* const key : {"speedup", "cpu_speedup"})
    two[key] = ranks.at(key).at("2").get<double>();
  copy<double>(ranks, {"weak_efficiency", "weak_cpu_efficiency"}, two);
  group.data["two_ranks"] = std::move(two);
  std::size_t missed = 0;
  for (const Json& target : group.data["targets"]) missed += target["reached"].get<bool>() ? 0 : 1;
  group.data["targets_missed"] = missed;
  group.findings = {{"sweep_speed", "sweep-speed", About::software, Standing::holds}};
  if (missed > 0)
    group.findings = {
        {"sweep_speed", "sweep-speed", About::software, Standing::missed,
         fmt::format("{} of {} speed targets are missed.", missed, group.data["targets"].size())}};
  return group;
}

}  // namespace

Group gates_group(const ReportPlaces& places) {
  Group group = from_baseline(places, "gates.json", proved_gates);
  add_part(group, places, {"baseline", "performance.json", "the work and time that the gates hold"},
           gate_baseline);
  return group;
}

Group sweep_speed_group(const ReportPlaces& places) {
  return from_baseline(places, "sweep.json", sweep_speed);
}

}  // namespace tribo::report
