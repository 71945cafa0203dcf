// SPDX-License-Identifier: Apache-2.0
#include "report/ledger_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/ledger_cells.hpp"
#include "report/number_text.hpp"
#include "report/typeset.hpp"

namespace tribo::report {
using namespace reproduction;
using namespace ledger_cells;

namespace {

void drop_column(TextTable& table, std::ptrdiff_t column) {
  table.headings.erase(table.headings.begin() + column);
  table.is_number.erase(table.is_number.begin() + column);
  for (auto& row : table.rows) row.erase(row.begin() + column);
}

}  // namespace

TextTable reading_table(const Ledger& ledger, const NamedReading& reading,
                        const std::vector<std::string>& claims, bool with_statements) {
  TextTable table{
      fmt::format("Reading “{}”: {} of {} claims reproduced", reading.name, reading.score,
                  ledger.claims.size()),
      {"item", "verdict", "asked", "computed", "factor, or where it holds", "the paper says"},
      {false, false, true, true, true, false},
      {},
      {}};
  for (std::size_t i = 0; i < ledger.items.size(); ++i) {
    const Item& item = ledger.items[i];
    if (!is_wanted(claims, item.claim)) continue;
    const ItemResult& result = reading.results[i];
    table.rows.push_back({item.id, verdict(result), asked(item), computed(item, result),
                          factor(item, result), typeset(item.statement)});
  }
  if (!with_statements) drop_column(table, 5);
  const std::string where = departures(reading.reading);
  table.note =
      where == "corrected"
          ? "All misprints mended, as the model has it. Ratios over speeds: least … greatest."
          : fmt::format("Departs from the corrected reading by `{}`.", where);
  return table;
}

TextTable statement_table(const Ledger& ledger, const std::vector<std::string>& claims) {
  TextTable table{
      "The claims, and how each is computed",
      {"item", "the paper says", "printed", "place", "computed as"},
      {false, false, false, false, false},
      {},
      "From `reference/published/claims.tsv`. A number is reproduced within half a unit of its "
      "last printed digit, else within 10 %, else to the order of magnitude (a factor √10). "
      "A comparison is reproduced where it holds at all speeds compared, in part where at half "
      "of them (logarithmically) or more. A claim has the worst verdict of its items."};
  for (const Item& item : ledger.items)
    if (is_wanted(claims, item.claim))
      table.rows.push_back(
          {item.id, typeset(item.statement), item.printed, item.place, typeset(item.computed_as)});
  return table;
}

TextTable verdict_table(const Ledger& ledger, const std::vector<std::string>& claims) {
  TextTable table{"The claims under the corrected reading, the literal one, and the best few",
                  {"claim"},
                  {false},
                  {},
                  {}};
  for (const NamedReading& reading : ledger.readings) {
    table.headings.push_back(reading.name);
    table.is_number.push_back(false);
  }
  table.headings.emplace_back("met by, of all readings");
  table.is_number.push_back(true);
  for (std::size_t k = 0; k < ledger.claims.size(); ++k) {
    if (!is_wanted(claims, ledger.claims[k])) continue;
    std::vector<std::string> cells{ledger.claims[k]};
    for (const NamedReading& reading : ledger.readings)
      cells.emplace_back(name(reading.verdicts[k]));
    cells.push_back(percent(ledger.claim_parts[k]));
    table.rows.push_back(std::move(cells));
  }
  std::vector<std::string> sum{"reproduced"};
  for (const NamedReading& reading : ledger.readings)
    sum.push_back(fmt::format("{} of {}", reading.score, ledger.claims.size()));
  sum.push_back(
      fmt::format("mean {} of {}", rounded(ledger.ranking.mean_score, 2), ledger.claims.size()));
  table.rows.push_back(std::move(sum));
  for (const NamedReading& reading : ledger.readings)
    if (reading.name != "corrected")
      table.note += fmt::format("{}{}: `{}`.", table.note.empty() ? "" : " ", reading.name,
                                departures(reading.reading));
  return table;
}

TextTable ranking_table(const Ledger& ledger) {
  const Ranking& ranking = ledger.ranking;
  TextTable table{"Readings by the number of claims they reproduce",
                  {"claims reproduced", "readings", "part of all", "who"},
                  {true, true, true, false},
                  {},
                  {}};
  for (std::size_t score = ranking.histogram.size(); score-- > 0;) {
    const std::size_t readings = ranking.histogram[score];
    std::string who;
    for (const NamedReading& reading : ledger.readings)
      if (reading.score == static_cast<int>(score)) who += (who.empty() ? "" : ", ") + reading.name;
    if (readings == 0 && table.rows.empty()) continue;
    table.rows.push_back(
        {std::to_string(score), std::to_string(readings),
         percent(static_cast<double>(readings) / static_cast<double>(reading_count())),
         who.empty() ? no_entry : who});
  }
  const Standing corrected = standing(ranking, ledger.readings.front().score);
  table.note = fmt::format(
      "{} readings: every combination of the {} switches. One drawn at random reproduces {} claims "
      "(standard deviation {}). {} readings tie for the best, {} claims. {} readings reproduce "
      "more than "
      "the corrected one, and {} others as many: agreeing with more of the paper is not being more "
      "right. A claim that nearly all readings meet identifies nothing.",
      reading_count(), switch_count, rounded(ranking.mean_score, 3), rounded(ranking.score_sd, 2),
      ranking.best_ties, ranking.best.front().score, corrected.above, corrected.equal - 1);
  for (std::size_t i = 0; i < ranking.best.size(); ++i) {
    const RankedGroup& group = ranking.best[i];
    table.note += fmt::format(
        " best {}: {} readings reproduce the same {} claims; all of them have {}, and they differ "
        "in {}.",
        i + 1, group.ties, group.score,
        group.fixed.empty() ? "nothing else in common" : fmt::format("`{}`", group.fixed),
        group.free.empty() ? "nothing" : group.free);
  }
  return table;
}

TextTable switch_table() {
  TextTable table{
      "The switches of a reading",
      {"switch", "misprint", "choices, the corrected one first", "literal", "what it changes"},
      {false, false, false, false, false},
      {},
      "`tribocheck reproduce --reading speed=sum,inlet=printed_exponents` shows one."};
  for (std::size_t i = 0; i < switch_count; ++i) {
    const SwitchInfo& one = info(static_cast<Switch>(i));
    std::string choices;
    for (const std::string_view choice : one.choices)
      choices += fmt::format("{}`{}`", choices.empty() ? "" : ", ", choice);
    table.rows.push_back({fmt::format("`{}`", one.name), std::string(one.errata), choices,
                          fmt::format("`{}`", one.choices[one.literal]), typeset(one.meaning)});
  }
  return table;
}

}  // namespace tribo::report
