// SPDX-License-Identifier: Apache-2.0
#include "report/verification_tables.hpp"

#include <fmt/format.h>

#include <exception>
#include <nlohmann/json.hpp>

#include "accuracy/accuracy.hpp"
#include "report/baselines.hpp"
#include "report/number_text.hpp"

namespace tribo::report {
namespace {

using Json = nlohmann::json;

TextTable certified_table(const ReportPlaces& places) {
  TextTable table{"The model in double against the certified tables of `reference/exact`",
                  {"quantity", "cases", "worst error, ulp", "worst error/condition, ulp",
                   "allowed, ulp", "verdict"},
                  {false, true, true, true, true, false},
                  {},
                  "Each row of the tables is a value that ball arithmetic encloses to 40 digits. "
                  "Where two numbers are allowed, the second counts times the condition number of "
                  "the row. `tribocheck verify` prints the same."};
  for (const verification::QuantityResult& r :
       verification::check_accuracy((places.reference / "exact").string())) {
    std::string allowed = rounded(r.allowed_ulp, 3);
    if (r.allowed_ulp_per_condition > 0)
      allowed += " or " + rounded(r.allowed_ulp_per_condition, 3) + " × condition";
    table.rows.push_back({fmt::format("`{}`", r.quantity), std::to_string(r.cases),
                          rounded(r.worst_ulp, 3), rounded(r.worst_ulp_per_condition, 3),
                          std::move(allowed), r.passed() ? "held" : "FAILED"});
  }
  return table;
}

TextTable fault_table(const ReportPlaces& places) {
  TextTable table{"Faults planted in the tree, and the check that caught each",
                  {"fault", "in", "check", "time, s", "verdict"},
                  {false, false, false, true, false},
                  {},
                  {}};
  const Baseline baseline = read_baseline(places, "planted_faults.json");
  if (!baseline.missing.empty()) {
    table.note = baseline.missing + "; `make faults` writes it.";
    return table;
  }
  std::size_t caught = 0;
  for (const Json& fault : baseline.content.at("faults")) {
    const bool is_caught = fault.at("caught").get<bool>();
    caught += is_caught ? 1 : 0;
    table.rows.push_back(
        {fault.at("id").get<std::string>() + ": " + fault.at("fault").get<std::string>(),
         fmt::format("`{}`", fault.at("file").get<std::string>()),
         fmt::format("`{}`", fault.at("check").get<std::string>()),
         rounded(fault.at("seconds").get<double>(), 3), is_caught ? "caught" : "SURVIVED"});
  }
  table.note =
      fmt::format("{} of {} caught; the time is that of building and running the check. {}", caught,
                  table.rows.size(), provenance(baseline.content));
  return table;
}

// Of the worst point; nothing where every case was exact.
std::string input_list(const Json& at) {
  if (at.is_null()) return "";
  std::string text;
  for (const auto& [name, value] : at.at("inputs").items())
    text += fmt::format("{}`{}` {}", text.empty() ? "" : ", ", name,
                        rounded(value.at(0).get<double>(), 5));
  return text;
}

// The worst of an output: infinity is null in JSON.
std::string worst(const Json& output, const char* key) {
  const Json& value = output.at(key);
  return value.is_null() ? "∞" : rounded(value.get<double>(), 3);
}

TextTable stress_table(const ReportPlaces& places) {
  TextTable table{"Random points through the whole model, double against long double",
                  {"output", "cases", "worst error, ulp", "worst error/condition, ulp", "in balls",
                   "verdict", "inputs of the worst error/condition"},
                  {false, true, true, true, true, false, false},
                  {},
                  {}};
  const Baseline baseline = read_baseline(places, "stress.json");
  if (!baseline.missing.empty()) {
    table.note = baseline.missing + "; `make stress` writes it.";
    return table;
  }
  for (const Json& output : baseline.content.at("outputs")) {
    table.rows.push_back({fmt::format("`{}`", output.at("output").get<std::string>()),
                          std::to_string(output.at("cases").get<long long>()),
                          worst(output, "worst_ulp"), worst(output, "worst_ulp_per_condition"),
                          worst(output.at("in_balls"), "worst_ulp_per_condition"),
                          output.at("held").get<bool>() ? "held" : "BROKEN",
                          input_list(output.at("worst_ulp_per_condition_at"))});
  }
  table.note = fmt::format(
      "{} points, seed {}. The worst were repeated in ball arithmetic: the column in balls is "
      "their worst error/condition against an enclosure. Where the condition is large, so is the "
      "worst error. `reference/baselines/stress.json` has the inputs to the bit. {}",
      baseline.content.at("points").get<long long>(), baseline.content.at("seed").get<long long>(),
      provenance(baseline.content));
  return table;
}

}  // namespace

std::vector<TextTable> verification_tables(const ReportPlaces& places) {
  return {made_or_excused("Certified tables", [&] { return certified_table(places); }),
          made_or_excused("Random points", [&] { return stress_table(places); }),
          made_or_excused("Planted faults", [&] { return fault_table(places); })};
}

}  // namespace tribo::report
