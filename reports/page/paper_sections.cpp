// SPDX-License-Identifier: Apache-2.0
#include "page/paper_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "page/data_files.hpp"
#include "page/number_text.hpp"
#include "page/observations.hpp"
#include "page/paper_figures.hpp"
#include "page/paper_tables.hpp"

namespace tribo::report {
namespace {

// Does the verdict count this row? It needs a reported number; of several onset criteria only
// film_maximum counts.
bool is_told(const ComparisonRow& row) {
  return row.reported &&
         (row.criterion.empty() || row.criterion == name(OnsetCriterion::film_maximum));
}

Verdict verdict(const ComparisonTable& table) {
  std::size_t told = 0, inside = 0;
  std::optional<RatioRange> factors;
  for (const ComparisonRow& row : table.rows) {
    if (!is_told(row)) continue;
    ++told;
    inside += row.agrees() ? 1 : 0;
    if (const auto factor = row.factor())
      factors = factors ? RatioRange{std::min(factors->least, *factor),
                                     std::max(factors->greatest, *factor)}
                        : RatioRange{*factor, *factor};
  }
  const std::string subject =
      table.has_criteria ? table.title + ", by `film_maximum`" : table.title;
  if (told == 0) return {Standing::absent, subject, "The paper gives no number."};
  std::string ratio;
  if (factors) {
    const std::string least = rounded(factors->least, 3), greatest = rounded(factors->greatest, 3);
    ratio = "; computed/reported is " + (least == greatest ? least : least + " to " + greatest);
  }
  return {inside == told ? Standing::holds : Standing::differs, subject,
          fmt::format("{} of {} computed values agree with the paper to its last printed digit{}. "
                      "Computed for this page.",
                      inside, told, ratio)};
}

}  // namespace

Section figures_section(const Findings& findings, const std::vector<ComparisonTable>& comparisons) {
  Section section{"figures", "The paper's figures, redrawn"};
  section.figures = paper_figures(findings);
  section.data = data_files(findings, comparisons);
  section.paragraphs = {
      "C1 to C17 number the paper's claims. GT is the asperity model of Greenwood and Tripp, GW "
      "that of Greenwood and Williamson."};
  return section;
}

Section comparison_section(const Findings& findings,
                           const std::vector<ComparisonTable>& comparisons) {
  Section section{"comparison", "Computed beside reported"};
  section.paragraphs = {fmt::format(
      "Numbers that the paper prints, from `{}`, and what the model gives for the same scenes.",
      findings.reported.file())};
  for (const ComparisonTable& comparison : comparisons) {
    section.tables.push_back(text_table(comparison));
    section.tables.back().data = "data/comparison.tsv";
    section.verdicts.push_back(verdict(comparison));
  }
  return section;
}

Section inputs_section(const Findings& findings) {
  Section section{"inputs", "Inputs"};
  std::string files;
  for (const SolvedCase& one : findings.solved)
    files += fmt::format("{}`{}`", files.empty() ? "" : ", ", one.source.file);
  section.paragraphs = {fmt::format("The scenes are {}.", files)};
  section.tables = {inputs_table(findings.solved)};
  return section;
}

}  // namespace tribo::report
