// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "accuracy/accuracy.hpp"
#include "page/baselines.hpp"
#include "page/number_text.hpp"
#include "page/verification_sections.hpp"

namespace tribo::report {
namespace {

using verification::QuantityResult;

// Worst error/condition of each quantity when the baseline was made, and what to say of it.
struct Before {
  std::map<std::string, double> worst;
  std::string provenance;
};

Before read_before(const ReportPlaces& places) {
  const Json baseline = read_baseline(places, "accuracy.json");
  Before before;
  for (const Json& row : baseline.at("quantities"))
    before.worst[row.at("quantity").get<std::string>()] =
        row.at("worst_ulp_per_condition").get<double>();
  before.provenance = provenance(baseline);
  return before;
}

Before before_or_why_not(const ReportPlaces& places, Section& section) {
  try {
    return read_before(places);
  } catch (const std::exception& error) {
    section.not_run.push_back({"accuracy of an earlier version, to compare with", error.what(),
                               target_of("accuracy.json")});
    return {{}, fmt::format("Not here: {}.", error.what())};
  }
}

std::string allowed(const QuantityResult& result) {
  std::string text = rounded(result.allowed_ulp, 3);
  if (result.allowed_ulp_per_condition > 0)
    text += " or " + rounded(result.allowed_ulp_per_condition, 3) + " × condition";
  return text;
}

std::string worst_before(const Before& before, const std::string& quantity) {
  const auto found = before.worst.find(quantity);
  return found == before.worst.end() ? "–" : rounded(found->second, 3);
}

Verdict verdict(const std::vector<QuantityResult>& results) {
  std::size_t held = 0, cases = 0;
  double greatest = 0;
  for (const QuantityResult& one : results) {
    held += one.passed() ? 1 : 0;
    cases += one.cases;
    greatest = std::max(greatest, one.worst_part_of_bound);
  }
  return {
      !results.empty() && held == results.size() ? Standing::holds : Standing::fails,
      "Certified values",
      fmt::format("{} of {} quantities keep their declared accuracy on {} certified values; the "
                  "worst error takes {} % of its bound. Computed for this page.",
                  held, results.size(), grouped(cases), rounded(100 * greatest, 3))};
}

void fill(Section& section, const ReportPlaces& places) {
  const auto results = verification::check_accuracy((places.reference / "exact").string());
  const Before before = before_or_why_not(places, section);
  TextTable table{
      "The model in double against the certified tables of `reference/exact`",
      {"quantity", "cases", "worst error, ulp", "worst error/condition, ulp",
       "the same before, ulp", "allowed, ulp", "of the bound", "worst row", "verdict"},
      {false, true, true, true, true, true, true, false, false},
      {},
      "Where two numbers are allowed, the second counts times the condition number of "
      "the row: where the condition is large, so is the worst error, and a double cannot do "
      "better. `tribocheck verify` prints the same. Before: " +
          before.provenance};
  for (const QuantityResult& r : results)
    table.rows.push_back({fmt::format("`{}`", r.quantity), grouped(r.cases),
                          rounded(r.worst_ulp, 3), rounded(r.worst_ulp_per_condition, 3),
                          worst_before(before, r.quantity), allowed(r),
                          rounded(100 * r.worst_part_of_bound, 3) + " %",
                          fmt::format("`{}`", r.worst_row), r.passed() ? "held" : "FAILED"});
  section.tables.push_back(std::move(table));
  section.verdicts.push_back(verdict(results));
}

}  // namespace

Section certified_section(const ReportPlaces& places) {
  Section section{"verification", "Verification, quantity by quantity"};
  section.paragraphs = {
      "Each row of the certified tables is a value that ball arithmetic encloses, by two methods. "
      "The model's double is held to it within the bound that stands beside the "
      "function."};
  return filled_or_excused(section,
                           "The checkout's folder `reference/exact`, or `make references`,",
                           [&](Section& to) { fill(to, places); });
}

}  // namespace tribo::report
