// SPDX-License-Identifier: Apache-2.0
// The group `ledger`: the paper's claims under each reading.
#include "reproduction/ledger.hpp"

#include <algorithm>

#include "page/groups.hpp"
#include "page/ledger_data.hpp"
#include "page/ledger_json.hpp"

namespace tribo::report {
namespace {

using reproduction::Ledger;

// Did a verdict change? Without a committed ledger this is not known.
void compare_with_committed(Group& group, const Ledger& ledger, const ReportPlaces& places) {
  Finding finding{"committed_ledger", "claims", About::software, Standing::absent};
  Json& committed = group.data["committed"];
  try {
    const reproduction::LedgerChanges changes = reproduction::changes_since(
        (places.reference / "baselines" / "ledger.csv").string(), ledger, ledger.readings, {});
    committed = {{"verdicts_changed", changes.verdicts}, {"numbers_moved", changes.numbers}};
    finding.standing = changes.verdicts.empty() ? Standing::holds : Standing::fails;
    if (!changes.verdicts.empty()) finding.why = "verdict changed: " + changes.verdicts.front();
  } catch (const std::runtime_error& error) {
    committed = {{"missing", error.what()}};
    finding.why = error.what();
    group.not_run.push_back(
        {"Comparison with the committed ledger", error.what(), "`make ledger`"});
  }
  group.findings.push_back(std::move(finding));
}

}  // namespace

Group ledger_group(const ReportPlaces& places, const Ledger& ledger) {
  Group group;
  group.data = ledger_json(ledger, ledger.readings, {});
  group.files = {ledger_surfaces_data(ledger),
                 ledger_law_data(ledger),
                 ledger_scores_data(ledger),
                 {"data/ledger.csv", reproduction::ledger_csv(ledger, ledger.readings, {})}};
  const bool all_reproduced =
      ledger.readings.front().score == static_cast<int>(ledger.claims.size());
  const bool all_independent =
      std::all_of(ledger.independent.begin(), ledger.independent.end(),
                  [](const reproduction::IndependentNumber& one) { return one.reproduced; });
  group.findings = {
      {"claims", "claims", About::paper, all_reproduced ? Standing::holds : Standing::differs},
      {"readings", "readings", About::paper, Standing::measured},
      {"independent_numbers", "uncertainty", About::software,
       all_independent ? Standing::holds : Standing::fails}};
  compare_with_committed(group, ledger, places);
  return group;
}

}  // namespace tribo::report
