// SPDX-License-Identifier: Apache-2.0
#include "page/ledger_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "page/ledger_cells.hpp"
#include "page/ledger_data.hpp"
#include "page/ledger_tables.hpp"
#include "page/number_text.hpp"
#include "page/onset_uncertainty_section.hpp"
#include "page/typeset.hpp"
#include "reproduction/ledger_file.hpp"

namespace tribo::report {
namespace {

using reproduction::Ledger;
using reproduction::NamedReading;
using reproduction::Quantity;

constexpr const char* how_to = "`tribocheck reproduce`";

// "C2, C3", of the claims with a verdict from `least` to `most`.
std::string with_verdict(const Ledger& ledger, const NamedReading& reading,
                         reproduction::Verdict least, reproduction::Verdict most) {
  std::vector<std::string> found;
  for (std::size_t k = 0; k < ledger.claims.size(); ++k)
    if (reading.verdicts[k] >= least && reading.verdicts[k] <= most)
      found.push_back(ledger.claims[k]);
  return ledger_cells::list(found);
}

// computed/reported of the onset speeds, least and greatest.
std::pair<double, double> onset_factors(const Ledger& ledger, const NamedReading& reading) {
  double least = INFINITY, greatest = 0;
  for (std::size_t i = 0; i < ledger.items.size(); ++i) {
    const auto& value = reading.results[i].observed.value;
    if (ledger.items[i].quantity != Quantity::onset_speed || !value) continue;
    least = std::min(least, *value / ledger.items[i].reported);
    greatest = std::max(greatest, *value / ledger.items[i].reported);
  }
  return {least, greatest};
}

Figure figure(std::string stem, std::string label, std::string heading, std::string caption,
              std::string alternative, std::vector<std::string> data, std::string title) {
  const std::string script = stem + ".gp";
  return {stem,
          std::move(label),
          std::move(heading),
          std::move(caption),
          std::move(alternative),
          std::move(data),
          {"ledger.gp", script, "data", stem, std::move(title), "Table 1, misprints mended", 640}};
}

// computed/reported of the asperity share on a surface.
std::string share_factor(const Ledger& ledger, std::size_t surface) {
  for (std::size_t i = 0; i < ledger.items.size(); ++i)
    if (ledger.items[i].quantity == Quantity::slow_asperity_share &&
        static_cast<std::size_t>(ledger.items[i].surface) == surface)
      if (const auto& value = ledger.readings.front().results[i].observed.value)
        return rounded(*value / ledger.items[i].reported, 3);
  return ledger_cells::no_entry;
}

std::vector<Figure> claim_figures(const Ledger& ledger) {
  const auto [least, greatest] = onset_factors(ledger, ledger.readings.front());
  const auto& print = ledger.uncertainty[0];
  const std::vector<std::string> data{"data/ledger_surfaces.tsv", "data/ledger_law.tsv"};
  return {
      figure(
          "onset_against_roughness", "Onset", "Onset speeds against roughness",
          fmt::format(
              "C1: the greatest film (full line) lies at {} to {} times the speeds that the paper "
              "reports (triangles). The law rises as σ~s~^1/0.67^, but for load sharing. Dark "
              "band: "
              "inputs within the precision that Table 1 prints; of {} draws {} have all three "
              "speeds as reported. Light band: inputs within what is plausible.",
              rounded(least, 3), rounded(greatest, 3), print.draws, print.all_onsets_reported),
          "Onset speed against the standard deviation of summit heights on logarithmic axes: two "
          "bands of uncertainty, two computed curves, computed points and the three reported "
          "points.",
          data, "Onset of starvation against roughness"),
      figure(
          "share_against_roughness", "Shares",
          "Asperity share at the lowest speed against roughness",
          fmt::format("C4: computed/reported is {} on the rough surface and {} on the smooth one. "
                      "The print precision of the summits' radius and heights alone leaves the "
                      "share as open as the dark band.",
                      share_factor(ledger, 0), share_factor(ledger, 2)),
          "Load share of the asperities against the standard deviation of summit heights: two "
          "bands "
          "of uncertainty, the computed curve and two reported points.",
          data, "Load share of the asperities at the lowest speed")};
}

// Did a verdict change? Without a committed ledger this is not known.
void compare_with_committed(Section& section, const Ledger& ledger, const ReportPlaces& places) {
  const std::string path = (places.reference / "baselines" / "ledger.csv").string();
  try {
    const reproduction::LedgerChanges changes =
        reproduction::changes_since(path, ledger, ledger.readings, {});
    section.verdicts.push_back(
        changes.verdicts.empty()
            ? Verdict{Standing::holds, "The ledger",
                      "No verdict on a claim changed against the committed ledger."}
            : Verdict{Standing::fails, "The ledger",
                      fmt::format("{} verdicts changed against the committed ledger: {}.",
                                  changes.verdicts.size(), changes.verdicts.front())});
  } catch (const std::runtime_error& error) {
    section.verdicts.push_back({Standing::absent, "The ledger", error.what()});
    section.not_run.push_back(
        {"Comparison with the committed ledger", error.what(), "`make ledger`"});
  }
}

Section claims_section(const Ledger& ledger, const ReportPlaces& places) {
  Section section{"claims", "The paper's claims, and what comes out"};
  const NamedReading& corrected = ledger.readings.front();
  const auto [least, greatest] = onset_factors(ledger, corrected);
  using reproduction::Verdict;
  section.verdicts.push_back(
      {Standing::differs, "The paper's claims",
       fmt::format(
           "With its misprints mended the paper's model reproduces {} of its {} claims ({}); in "
           "part, within 10 % or to the order of magnitude: {}; not: {}.",
           corrected.score, ledger.claims.size(),
           with_verdict(ledger, corrected, Verdict::reproduced, Verdict::reproduced),
           with_verdict(ledger, corrected, Verdict::within_ten_percent, Verdict::in_part),
           with_verdict(ledger, corrected, Verdict::not_reproduced, Verdict::not_reproduced))});
  section.verdicts.push_back(
      {Standing::differs, "Onset speeds under all readings",
       fmt::format(
           "The onset speeds (C1) come out {} to {} times as high as reported, by the greatest "
           "film; {}",
           rounded(least, 3), rounded(greatest, 3),
           ledger.claim_parts.front() == 0
               ? no_reading_sentence
               : fmt::format("{} of all combinations of interpretations give all three.",
                             ledger_cells::percent(ledger.claim_parts.front())))});
  compare_with_committed(section, ledger, places);
  section.paragraphs = {
      "C1 to C17 are what the paper says of its results. Each is computed and judged by a rule "
      "that stands in `reference/published/claims.tsv`; nothing is tuned. A verdict that is not "
      "“reproduced” is a "
      "result."};
  section.tables = {verdict_table(ledger, ledger.readings), readings_table(ledger, ledger.readings),
                    reading_table(ledger, corrected), statement_table(ledger)};
  section.figures = claim_figures(ledger);
  section.data = {ledger_surfaces_data(ledger),
                  ledger_law_data(ledger),
                  {"data/ledger.csv", reproduction::ledger_csv(ledger, ledger.readings, {})}};
  return section;
}

// "1.4: `flooded_inlet`, line gap; …"
std::string identified(const Ledger& ledger) {
  std::string text;
  for (const reproduction::Argument& argument : ledger.arguments) {
    if (argument.agreeing() != 1) continue;
    for (const reproduction::Candidate& one : argument.candidates)
      if (one.agrees)
        text += fmt::format("{}{}, by {}", text.empty() ? "" : "; ", argument.reported,
                            typeset(one.name));
  }
  return text.empty() ? "none" : text;
}

Section readings_section(const Ledger& ledger) {
  Section section{"readings", "Readings, and which number identifies which"};
  section.paragraphs = {
      "The paper's misprints leave open what its authors computed with. A reading is a choice at "
      "each of "
      "those places; all combinations are evaluated, and ranked by how many claims they reproduce.",
      "A number identifies a reading where all that reproduce it share a choice: the tables below "
      "give "
      "each such argument with its numbers."};
  section.tables = {ranking_table(ledger), switch_table(), identification_table(ledger)};
  for (TextTable& table : argument_tables(ledger)) section.tables.push_back(std::move(table));
  for (std::size_t i = 1; i < ledger.readings.size(); ++i)
    section.tables.push_back(reading_table(ledger, ledger.readings[i]));
  section.figures = {figure(
      "readings_by_score", "Readings", "How many readings reproduce how many claims",
      fmt::format("A reading drawn at random reproduces {} claims (standard deviation {}). Named: "
                  "where the corrected reading, the literal one and the best few stand.",
                  rounded(ledger.ranking.mean_score, 3), rounded(ledger.ranking.score_sd, 2)),
      "Bars: number of readings, on a logarithmic axis, against the number of claims they "
      "reproduce.",
      {"data/ledger_scores.tsv"}, "Readings by the number of claims they reproduce")};
  section.figures.front().drawing.subtitle =
      fmt::format("{} readings", reproduction::reading_count());
  section.data = {ledger_scores_data(ledger)};
  section.verdicts.push_back(
      {Standing::measured, "Readings",
       fmt::format(
           "Of {} readings the best reproduce {} claims, one at random {}. These printed numbers "
           "fit only one interpretation: {}.",
           reproduction::reading_count(), ledger.ranking.best.front().score,
           rounded(ledger.ranking.mean_score, 2), identified(ledger))});
  return section;
}

Section requirements_section(const Ledger& ledger) {
  Section section{"requirements", "What would have to be true"};
  section.paragraphs = {
      "For each item that fails: the change of a single input that would make it hold, whether "
      "that is "
      "plausible, and which claims it mends or breaks."};
  for (TextTable& table : requirement_tables(ledger)) {
    if (table.rows.empty())
      section.paragraphs.push_back(fmt::format("{}. {}", table.caption, table.note));
    else
      section.tables.push_back(std::move(table));
  }
  section.tables.push_back(departure_table(ledger));
  return section;
}

Section uncertainty_section(const Ledger& ledger) {
  Section section{"uncertainty", "How sure the computed numbers are"};
  section.tables = {uncertainty_table(ledger), independent_table(ledger)};
  const auto held =
      static_cast<std::size_t>(std::count_if(ledger.independent.begin(), ledger.independent.end(),
                                             [](const auto& one) { return one.reproduced; }));
  section.verdicts.push_back(
      {held == ledger.independent.size() ? Standing::holds : Standing::fails, "Independent numbers",
       fmt::format("{} of {} film and Hertz values of another library are met to their last digit.",
                   held, ledger.independent.size())});
  return section;
}

Section errata_section(const Ledger& ledger) {
  Section section{"misprints", "The paper's misprints"};
  section.tables = {errata_table(ledger)};
  return section;
}

}  // namespace

std::vector<Section> ledger_sections(const ReportPlaces& places) {
  try {
    reproduction::LedgerOptions options;
    options.published = places.scenes.string();
    const Ledger ledger = reproduction::make_ledger(options);
    return {claims_section(ledger, places),
            readings_section(ledger),
            requirements_section(ledger),
            uncertainty_section(ledger),
            onset_uncertainty_section(places, ledger),
            errata_section(ledger)};
  } catch (const std::runtime_error& error) {
    return {excused({"claims", "The paper's claims, and what comes out"}, error.what(), how_to)};
  }
}

}  // namespace tribo::report
