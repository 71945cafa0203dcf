// SPDX-License-Identifier: Apache-2.0
// Certified values, random points and planted faults: each is held, or a promise is broken.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "accuracy/accuracy.hpp"
#include "page/baselines.hpp"
#include "page/groups.hpp"

namespace tribo::report {
namespace {

using verification::QuantityResult;

// A promise that is kept where all are held.
Finding promise(const char* id, const char* section, std::size_t held, std::size_t all) {
  if (all > 0 && held == all) return {id, section, About::software, Standing::holds};
  return {id, section, About::software, Standing::fails,
          fmt::format("{} of {} are not held.", all - held, all)};
}

Json quantity_json(const QuantityResult& one) {
  return {{"quantity", one.quantity},
          {"cases", one.cases},
          {"worst_ulp", one.worst_ulp},
          {"worst_ulp_per_condition", one.worst_ulp_per_condition},
          {"allowed_ulp", one.allowed_ulp},
          {"allowed_ulp_per_condition", one.allowed_ulp_per_condition},
          {"worst_part_of_bound", one.worst_part_of_bound},
          {"worst_row", one.worst_row},
          {"held", one.passed()}};
}

// The worst error of each quantity when the baseline was made.
Json accuracy_before(const Json& baseline) {
  Json before = run_of(baseline);
  before["worst_ulp_per_condition"] = Json::object();
  for (const Json& row : baseline.at("quantities"))
    before["worst_ulp_per_condition"][row.at("quantity").get<std::string>()] =
        row.at("worst_ulp_per_condition").get<double>();
  return before;
}

// The point at which an output is worst; null where every case was exact.
Json worst_point(const Json& at) {
  if (at.is_null()) return nullptr;
  Json point{{"index", at.at("index").get<std::size_t>()}, {"inputs", Json::object()}};
  for (const auto& [name, value] : at.at("inputs").items())
    point["inputs"][name] = value.at(0).get<double>();
  return point;
}

Json stressed_output(const Json& output) {
  Json json;
  copy<std::string>(output, {"output"}, json);
  copy<std::size_t>(output, {"cases", "beyond_contract"}, json);
  copy<double>(output, {"worst_part_of_bound"}, json);
  copy<bool>(output, {"held"}, json);
  for (const char* const key : {"worst_ulp", "worst_ulp_per_condition"})
    json[key] = number_or_null(output.at(key));
  json["worst_ulp_per_condition_in_balls"] =
      number_or_null(output.at("in_balls").at("worst_ulp_per_condition"));
  json["worst_point"] = worst_point(output.at("worst_ulp_per_condition_at"));
  return json;
}

// How many of the rows are held, and the worst of them.
void judge(Group& group, const char* rows, const char* finding, const char* section) {
  std::size_t held = 0, cases = 0;
  double greatest = 0;
  for (const Json& row : group.data[rows]) {
    held += row.at("held").get<bool>() ? 1 : 0;
    cases += row.at("cases").get<std::size_t>();
    greatest = std::max(greatest, row.at("worst_part_of_bound").get<double>());
  }
  group.data["held"] = held;
  group.data["cases"] = cases;
  group.data["worst_part_of_bound"] = greatest;
  group.findings = {promise(finding, section, held, group.data[rows].size())};
}

Group planted(const Json& baseline) {
  Json faults = Json::array();
  std::size_t caught = 0;
  for (const Json& one : baseline.at("faults")) {
    Json fault;
    copy<std::string>(one, {"id", "fault", "file", "check", "said"}, fault);
    copy<bool>(one, {"caught"}, fault);
    copy<double>(one, {"seconds"}, fault);
    caught += fault["caught"].get<bool>() ? 1 : 0;
    faults.push_back(std::move(fault));
  }
  const std::size_t all = faults.size();
  const auto catalogue = baseline.at("catalogue").get<std::size_t>();
  Group group{run_of(baseline)};
  group.data.update({{"catalogue", catalogue}, {"caught", caught}, {"faults", std::move(faults)}});
  group.findings = {promise("planted_faults", "planted-faults", caught, all)};
  if (catalogue > all)
    group.not_run = {{"planted faults",
                      fmt::format("{} of the {} in the catalogue were planted", all, catalogue),
                      "`make faults`"}};
  return group;
}

// Answers of `verify --subject` on wrong solvers, and whether it accused right ones.
Group diagnosed(const Json& baseline) {
  Json solvers = Json::array();
  std::size_t named = 0;
  for (const Json& one : baseline.at("wrong_solvers")) {
    Json solver;
    copy<std::string>(one, {"function", "said"}, solver);
    copy<std::vector<std::string>>(one, {"fakes"}, solver);
    copy<bool>(one, {"named"}, solver);
    named += solver["named"].get<bool>() ? 1 : 0;
    solvers.push_back(std::move(solver));
  }
  const std::size_t all = solvers.size();
  Json right;
  copy<std::size_t>(baseline.at("right_solvers"), {"tries"}, right);
  copy<bool>(baseline.at("right_solvers"), {"accused"}, right);
  const bool accuses = right["accused"].get<bool>();
  Group group{run_of(baseline)};
  group.data.update({{"right_solvers", std::move(right)},
                     {"named", named},
                     {"wrong_solvers", std::move(solvers)}});
  group.findings = {promise("diagnosis", "diagnosis", accuses ? 0 : named, all)};
  return group;
}

}  // namespace

Group certified_group(const ReportPlaces& places) {
  Group group;
  group.data["quantities"] = Json::array();
  for (const QuantityResult& one :
       verification::check_accuracy((places.reference / "exact").string()))
    group.data["quantities"].push_back(quantity_json(one));
  judge(group, "quantities", "certified_values", "verification");
  add_part(group, places,
           {"before", "accuracy.json", "accuracy of an earlier version, to compare with"},
           accuracy_before);
  return group;
}

Group stress_group(const ReportPlaces& places) {
  return from_baseline(places, "stress.json", [](const Json& baseline) {
    Group group{run_of(baseline)};
    copy<std::size_t>(baseline, {"points", "seed"}, group.data);
    group.data["outputs"] = Json::array();
    for (const Json& output : baseline.at("outputs"))
      group.data["outputs"].push_back(stressed_output(output));
    judge(group, "outputs", "random_inputs", "worst-inputs");
    return group;
  });
}

Group planted_faults_group(const ReportPlaces& places) {
  return from_baseline(places, "planted_faults.json", planted);
}

Group diagnosis_group(const ReportPlaces& places) {
  return from_baseline(places, "diagnosis.json", diagnosed);
}

}  // namespace tribo::report
