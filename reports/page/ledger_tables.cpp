// SPDX-License-Identifier: Apache-2.0
#include "page/ledger_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "page/texts.hpp"

namespace tribo::report {

using namespace reproduction;

namespace ledger_cells {

bool is_wanted(const std::vector<std::string>& claims, const std::string& claim) {
  return claims.empty() || std::find(claims.begin(), claims.end(), claim) != claims.end();
}

std::string number(const std::optional<double>& value, int digits) {
  return value && std::isfinite(*value) ? rounded(*value, digits) : no_entry;
}

std::string percent(double part) {
  if (part == 0) return "none";
  if (part < 0.001) return "< 0.1 %";
  if (part == 1) return "100 %";
  const std::string digits = fmt::format("{:.1f}", 100 * part);
  return (part < 1 && digits == "100.0" ? "> 99.9" : digits) + " %";
}

std::string with_unit(const std::string& number, const std::string& unit) {
  return unit == no_entry || number == no_entry ? number : fmt::format("{} {}", number, unit);
}

std::string asked(const Item& item) {
  switch (item.rule) {
    case Rule::number:
      return with_unit(unrounded(item.reported), item.unit);
    case Rule::order:
      return "above 1";
    case Rule::equal:
      return fmt::format("1 ± {:.4g} %", 100 * item.tolerance);
    case Rule::at_least:
      return fmt::format("from {}", unrounded(item.tolerance));
  }
  return {};
}

std::string computed(const Item& item, const ItemResult& result) {
  if (!result.observed.value) return no_entry;
  if (is_over_speeds(item))
    return fmt::format("{} to {}",
                       number(std::min(*result.observed.value, result.observed.other_end), 3),
                       number(std::max(*result.observed.value, result.observed.other_end), 3));
  return with_unit(number(*result.observed.value), item.unit);
}

std::string against_the_paper(const Item& item, const ItemResult& result) {
  if (!result.observed.value) return no_entry;
  if (item.rule == Rule::number)
    return fmt::format("{} times", number(*result.observed.value / item.reported, 3));
  if (!is_over_speeds(item)) return no_entry;
  const double part = result.observed.part;
  if (part < 0.5 && percent(part) == percent(0.5)) return "just under half of speeds";
  return part == 0   ? "at no speed"
         : part == 1 ? "at all speeds"
                     : fmt::format("at {} of speeds", percent(part));
}

std::string verdict(const ItemResult& result) {
  std::string text(name(result.verdict));
  if (!result.observed.value && !result.observed.none.empty())
    text += fmt::format(": {}", result.observed.none);
  if (!result.is_decided()) text += fmt::format("; {}", undecided_words);
  return text;
}

std::string margin(const ItemResult& result) {
  if (!result.margin) return no_entry;
  return fmt::format("{}{} ± {:.0e}", number(result.margin->distance, 3),
                     result.margin->of == MarginOf::part ? " of speeds" : "", result.margin->error);
}

std::string with_nature(const std::string& text, bool is_arithmetic) {
  return text + (is_arithmetic ? " (arithmetic)" : "");
}

std::string list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& one : names) text += (text.empty() ? "" : ", ") + one;
  return text.empty() ? no_entry : text;
}

}  // namespace ledger_cells

using namespace ledger_cells;

bool is_over_speeds(const Item& item) {
  switch (item.quantity) {
    case Quantity::area_gw_over_gt:
    case Quantity::area_rough_over_smooth:
    case Quantity::count_gw_over_gt:
    case Quantity::count_smoother_over_rougher:
    case Quantity::film_gw_over_gt:
    case Quantity::friction_gt_over_gw:
      return true;
    default:
      return false;
  }
}

TextTable reading_table(const Ledger& ledger, const NamedReading& reading,
                        const std::vector<std::string>& claims) {
  TextTable table{
      fmt::format("The numbers and comparisons that decide, under the reading “{}”", reading.name),
      {"part of claim", "what is computed", "the paper", "computed", "against the paper", "verdict",
       "margin"},
      {false, false, true, true, false, false, false},
      {},
      "The verdict on a claim is the worst of its parts'. A number is reproduced within "
      "half a unit of its last printed digit, else within 10 %, else to the order of "
      "magnitude (a factor √10: “order only”). A comparison is reproduced if it holds at all "
      "speeds "
      "that are compared, and in part if it holds at half of them or more (on a logarithmic axis). "
      "“1 ± 2 %”: the greater is at most 2 % above the other. Margin: the distance of ln of the "
      "computed number, or of the part of the speeds, from the value that would change the "
      "verdict, ± its numerical error."};
  for (std::size_t i = 0; i < ledger.items.size(); ++i) {
    const Item& item = ledger.items[i];
    if (!is_wanted(claims, item.claim)) continue;
    const ItemResult& result = reading.results[i];
    table.rows.push_back({item.id, with_nature(item.label, item.is_arithmetic), asked(item),
                          computed(item, result), against_the_paper(item, result), verdict(result),
                          margin(result)});
    if (result.observed.beyond_collapse != 0)
      table.note +=
          fmt::format(" {} {} ({}): there the numbers are limits, as printed.", item.id,
                      beyond_collapse_words, fmt::join(beyond_collapse(result.observed), ", "));
  }
  return table;
}

TextTable statement_table(const Ledger& ledger, const std::vector<std::string>& claims) {
  TextTable table{"The parts of the claims, and how each is computed",
                  {"part of claim", "the paper says", "printed", "place", "computed as"},
                  {false, false, false, false, false},
                  {},
                  "From reference/published/claims.tsv."};
  for (const Item& item : ledger.items)
    if (is_wanted(claims, item.claim))
      table.rows.push_back({item.id, item.statement, item.printed, item.place, item.computed_as});
  return table;
}

namespace {

// How many of the claims are reproduced, partly or not.
std::ptrdiff_t count(const NamedReading& reading, std::string_view scale) {
  return std::count_if(reading.verdicts.begin(), reading.verdicts.end(),
                       [&](Verdict one) { return short_name(one) == scale; });
}

}  // namespace

std::string verdict_sentence(const Ledger& ledger, const NamedReading& reading) {
  return fmt::format("{} of the paper's {} claims are reproduced, {} partly, {} not",
                     count(reading, "yes"), ledger.claims.size(), count(reading, "partly"),
                     count(reading, "no"));
}

std::string other_planes_sentence(const Ledger& ledger) {
  std::string text;
  for (const NamedReading& one : ledger.readings)
    if (one.name == "m = 2" || one.name == "equal faces")
      text += fmt::format("{}{} they are {}, {} and {}", text.empty() ? "With " : ", with ",
                          one.name, count(one, "yes"), count(one, "partly"), count(one, "no"));
  return fmt::format("{}. {}", text, partly_words);
}

namespace {

std::set<std::string> claims_beyond_collapse(const Ledger& ledger,
                                             const std::vector<NamedReading>& readings) {
  std::set<std::string> claims;
  for (const NamedReading& reading : readings)
    for (std::size_t i = 0; i < ledger.items.size(); ++i)
      if (reading.results[i].observed.beyond_collapse != 0) claims.insert(ledger.items[i].claim);
  return claims;
}

// Are all parts of a claim arithmetic?
bool is_arithmetic(const Ledger& ledger, std::size_t claim) {
  return std::all_of(ledger.items.begin(), ledger.items.end(), [&](const Item& one) {
    return one.claim != ledger.claims[claim] || one.is_arithmetic;
  });
}

}  // namespace

TextTable verdict_table(const Ledger& ledger, const std::vector<NamedReading>& readings,
                        const std::vector<std::string>& claims) {
  TextTable table{"What the paper claims, and whether it is reproduced under each reading",
                  {"claim", "the paper says"},
                  {false, false},
                  {},
                  {}};
  for (const NamedReading& reading : readings) {
    table.headings.push_back(reading.name);
    table.is_number.push_back(false);
  }
  table.headings.emplace_back("of all readings");
  table.is_number.push_back(true);
  bool has_open = false;
  for (std::size_t k = 0; k < ledger.claims.size(); ++k) {
    if (!is_wanted(claims, ledger.claims[k])) continue;
    std::vector<std::string> cells{ledger.claims[k],
                                   with_nature(ledger.statements[k], is_arithmetic(ledger, k))};
    for (const NamedReading& reading : readings) {
      const bool decided = is_decided(ledger.claims[k], ledger.items, reading.results);
      has_open = has_open || !decided;
      cells.push_back(fmt::format("{}{}", short_name(reading.verdicts[k]), decided ? "" : " (?)"));
    }
    cells.push_back(percent(ledger.claim_parts[k]));
    table.rows.push_back(std::move(cells));
  }
  table.note = fmt::format(
      "GT: contact by Greenwood and Tripp; GW: by Greenwood and Williamson. Last column: how "
      "many of the {} reproduce the claim. {} {}",
      grouped(reading_count()), partly_words, arithmetic_words);
  if (is_wanted(claims, ledger.claims.front()) && ledger.claim_parts.front() == 0)
    table.note += fmt::format(" {}: {}", ledger.claims.front(), no_reading_sentence);
  if (has_open) table.note += fmt::format(" (?): {}.", undecided_words);
  for (const std::string& claim : claims_beyond_collapse(ledger, readings))
    if (is_wanted(claims, claim))
      table.note += fmt::format(" {} {}.", claim, beyond_collapse_words);
  return table;
}

TextTable readings_table(const Ledger& ledger, const std::vector<NamedReading>& readings) {
  TextTable table{"The readings: what each puts in the place of a misprint",
                  {"reading", "claims reproduced", "where it departs from the corrected reading"},
                  {false, true, false},
                  {},
                  "What the switches mean: tribocheck reproduce --section switches."};
  for (const NamedReading& reading : readings) {
    const std::string where = departures(reading.reading);
    std::string text = where == "corrected"    ? "nowhere: all misprints mended but for E13 and E26"
                       : where == reading.name ? "as its name says"
                                               : where;
    for (const RankedGroup& group : ledger.ranking.best)
      if (reading.name.starts_with("best ") && group.representative == reading.reading &&
          group.ties > 1)
        text += fmt::format("; {} more reproduce the same claims: they differ in {}",
                            group.ties - 1, group.free);
    table.rows.push_back(
        {reading.name, fmt::format("{} of {}", reading.score, ledger.claims.size()), text});
  }
  return table;
}

TextTable ranking_table(const Ledger& ledger) {
  const Ranking& ranking = ledger.ranking;
  TextTable table{"How many readings reproduce how many claims",
                  {"claims reproduced", "readings", "part of all", "among them"},
                  {true, true, true, false},
                  {},
                  {}};
  for (std::size_t score = ranking.histogram.size(); score-- > 0;) {
    const std::size_t readings = ranking.histogram[score];
    if (readings == 0) continue;
    std::string named;
    for (const NamedReading& reading : ledger.readings)
      if (reading.score == static_cast<int>(score))
        named += (named.empty() ? "" : ", ") + reading.name;
    table.rows.push_back(
        {std::to_string(score), grouped(readings),
         percent(static_cast<double>(readings) / static_cast<double>(reading_count())),
         named.empty() ? no_entry : named});
  }
  const ReadingRank corrected = standing(ranking, ledger.readings.front().score);
  table.note = fmt::format(
      "There are {} readings: every combination of the {} switches. One drawn at random reproduces "
      "{} claims (standard deviation {}). {} readings reproduce more than the corrected one, and "
      "{} "
      "others as many: agreeing with more of the paper is not being more right. A claim that "
      "nearly "
      "all readings reproduce tells nothing about which one the author used.",
      grouped(reading_count()), switch_count, rounded(ranking.mean_score, 3),
      rounded(ranking.score_sd, 2), grouped(corrected.above), grouped(corrected.equal - 1));
  return table;
}

TextTable tolerance_table(const Ledger& ledger) {
  TextTable table{"Claims reproduced, by how wide the tolerances are",
                  {"tolerances times"},
                  {true},
                  {},
                  "The factor multiplies the print precision of numbers and the width of "
                  "comparisons of equality, and divides thresholds; comparisons of order have no "
                  "tolerance."};
  for (const NamedReading& reading : ledger.readings) {
    table.headings.push_back(reading.name);
    table.is_number.push_back(true);
  }
  for (const ToleranceScores& one : ledger.tolerances) {
    std::vector<std::string> cells{unrounded(one.factor)};
    for (const int score : one.scores) cells.push_back(std::to_string(score));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

TextTable switch_table() {
  TextTable table{
      "The switches of a reading",
      {"switch", "misprint", "choices, the corrected one first", "literal", "what it changes"},
      {false, false, false, false, false},
      {},
      "tribocheck reproduce --reading speed=sum,inlet=printed_exponents shows one."};
  for (std::size_t i = 0; i < switch_count; ++i) {
    const SwitchInfo& one = info(static_cast<Switch>(i));
    std::string choices;
    for (const std::string_view choice : one.choices)
      choices += fmt::format("{}{}", choices.empty() ? "" : ", ", choice);
    table.rows.push_back({std::string(one.name), std::string(one.errata), choices,
                          std::string(one.choices[one.literal]), std::string(one.meaning)});
  }
  return table;
}

}  // namespace tribo::report
