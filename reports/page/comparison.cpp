// SPDX-License-Identifier: Apache-2.0
#include "page/comparison.hpp"

#include <fmt/format.h>

#include <utility>

#include "page/number_text.hpp"
#include "reproduction/claims.hpp"

namespace tribo::report {
namespace {

bool is_reproduced(double computed, const Reported& reported) {
  return reproduction::is_as_printed(computed, reported.value, reported.last_digit);
}

// Facts only: the distance from the reported number, in its own last digit or as a factor.
std::string words_for(double computed, const std::optional<Reported>& reported) {
  if (!reported) return "the paper gives no number";
  if (is_reproduced(computed, *reported)) return "inside half a unit of the last printed digit";
  return rounded(computed / reported->value, 2) + " × the reported";
}

ComparisonRow row(const SolvedCase& solved, std::string_view criterion,
                  std::optional<double> computed, const std::optional<Reported>& reported) {
  return {solved.source.surface,
          solved.source.short_model(),
          criterion,
          computed,
          reported,
          computed ? words_for(*computed, reported) : std::string()};
}

ComparisonRow onset_row(const SolvedCase& solved, const Onset<double>& onset,
                        double Onset<double>::*quantity, const std::optional<Reported>& reported) {
  if (onset.exists) return row(solved, name(onset.criterion), onset.*quantity, reported);
  ComparisonRow none = row(solved, name(onset.criterion), std::nullopt, reported);
  none.in_words = fmt::format("none: {}", onset.reason);
  return none;
}

ComparisonTable onset_table(ComparisonTable table, double Onset<double>::*quantity,
                            const std::vector<SolvedCase>& solved, const ReportedValues& reported) {
  for (const SolvedCase& one : solved)
    for (const Onset<double>& onset : one.onsets)
      table.rows.push_back(
          onset_row(one, onset, quantity,
                    reported.find(table.quantity, one.source.surface, one.source.short_model())));
  return table;
}

ComparisonTable share_table(ComparisonTable table, const std::vector<SolvedCase>& solved,
                            const ReportedValues& reported) {
  for (const SolvedCase& one : solved)
    table.rows.push_back(
        row(one, "", one.slowest.asperity_load_share,
            reported.find(table.quantity, one.source.surface, one.source.short_model())));
  return table;
}

std::string criteria_note() {
  return fmt::format(
      "`film_maximum`: the film h* is greatest. `film_departure`: h* falls {} % below the flooded "
      "film. "
      "`friction_minimum`: the lowest interior minimum of friction. `asperity_minimum`: the "
      "asperities "
      "carry least. The paper does not say by which criterion it reads its onsets, and finds "
      "the same for GT and GW.",
      rounded(100 * default_departure, 1));
}

}  // namespace

std::optional<double> ComparisonRow::factor() const {
  if (!computed || !reported) return std::nullopt;
  return *computed / reported->value;
}

bool ComparisonRow::agrees() const {
  return computed && reported && is_reproduced(*computed, *reported);
}

std::vector<ComparisonTable> compare(const std::vector<SolvedCase>& solved,
                                     const ReportedValues& reported) {
  return {onset_table({"onset_speed",
                       "Onset of starvation: entrainment speed",
                       "computed, m/s",
                       criteria_note(),
                       4,
                       true,
                       {}},
                      &Onset<double>::speed, solved, reported),
          onset_table({"onset_film_parameter",
                       "Film parameter at the onset: λ = h*/σ~s~",
                       "computed",
                       "The paper reports one λ for all three surfaces.",
                       5,
                       true,
                       {}},
                      &Onset<double>::film_parameter, solved, reported),
          share_table({"slow_asperity_share",
                       "Load share of the asperities at the lowest speed",
                       "computed",
                       "The paper gives numbers for two surfaces, from its Figure 9.",
                       4,
                       false,
                       {}},
                      solved, reported)};
}

}  // namespace tribo::report
