// SPDX-License-Identifier: Apache-2.0
// The tables of the evidence for the verdicts.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "page/ledger_tables.hpp"
#include "page/texts.hpp"

namespace tribo::report {

using namespace reproduction;
using namespace ledger_cells;

namespace {

// The sensitivity d ln(result)/d ln(input), told as the effect of +1 % of the input.
std::string per_cent(const std::optional<double>& sensitivity) {
  if (!sensitivity) return no_entry;
  return fmt::format("{}{} %", *sensitivity < 0 ? "" : "+", number(sensitivity, 2));
}

}  // namespace

TextTable identification_table(const Ledger& ledger) {
  TextTable table{
      "What each item tells apart",
      {"item", "readings that meet it", "part of all", "bits", "identifies"},
      {false, true, true, true, false},
      {},
      "Identifies: choices that at least 95 % of the readings that meet the item share (in "
      "brackets), without those that the print precision of the inputs leaves open, by the "
      "candidates below. Bits: log_2 of all readings over those that meet the item."};
  for (std::size_t i = 0; i < ledger.items.size(); ++i) {
    const ItemStatistics& one = ledger.item_statistics[i];
    std::string found;
    for (const Identification& choice : one.identified)
      found += fmt::format("{}{}={} ({})", found.empty() ? "" : ", ", info(choice.which).name,
                           info(choice.which).choices[choice.choice], percent(choice.share));
    if (one.readings == 0) found = "no reading meets it";
    if (one.part > 0.9) found = "nothing: nearly all meet it";
    table.rows.push_back(
        {ledger.items[i].id, std::to_string(one.readings), percent(one.part),
         one.readings == 0 ? no_entry : fmt::format("{:.1f}", std::abs(std::log2(one.part))),
         found.empty() ? "no single choice" : found});
  }
  return table;
}

std::vector<TextTable> argument_tables(const Ledger& ledger) {
  std::vector<TextTable> tables;
  for (const Argument& argument : ledger.arguments) {
    TextTable table{argument.question,
                    {"candidate", "gives", "by print precision", "agrees"},
                    {false, true, false, false},
                    {},
                    fmt::format("Reported: {}, by print precision {} to {}. ", argument.reported,
                                rounded(argument.low, 5), rounded(argument.high, 5))};
    for (const Candidate& one : argument.candidates)
      table.rows.push_back(
          {one.name, number(one.value, 5),
           one.value ? fmt::format("{} to {}", number(one.low, 4), number(one.high, 4)) : no_entry,
           one.agrees ? "yes" : "no"});
    const std::size_t agreeing = argument.agreeing();
    table.note += agreeing == 0   ? "No candidate agrees."
                  : agreeing == 1 ? "One agrees."
                                  : fmt::format("{} agree.", agreeing);
    tables.push_back(std::move(table));
  }
  return tables;
}

std::vector<TextTable> requirement_tables(const Ledger& ledger,
                                          const std::vector<std::string>& claims) {
  std::vector<TextTable> tables;
  for (std::size_t i = 0; i < ledger.items.size(); ++i) {
    const Item& item = ledger.items[i];
    if (ledger.readings.front().results[i].verdict == Verdict::reproduced ||
        !is_wanted(claims, item.claim))
      continue;
    std::vector<const Requirement*> found;
    std::vector<std::string> none;
    for (const Requirement& one : ledger.requirements) {
      if (one.item != i) continue;
      if (one.factor)
        found.push_back(&one);
      else
        none.emplace_back(name(one.field));
    }
    std::stable_sort(found.begin(), found.end(), [](const Requirement* a, const Requirement* b) {
      return std::abs(std::log(*a->factor)) < std::abs(std::log(*b->factor));
    });
    TextTable table{fmt::format("What would make {} hold: {}", item.id, item.statement),
                    {"input", "effect of +1 %", "value of the paper", "value needed",
                     "times the paper's", "plausible?", "claims mended", "claims broken"},
                    {false, true, true, true, true, false, false, false},
                    {},
                    fmt::format("Computed: {}; the paper has: {}.",
                                computed(item, ledger.readings.front().results[i]), asked(item))};
    for (const Requirement* one : found)
      table.rows.push_back({with_unit(std::string(name(one->field)),
                                      one->unit == no_entry ? no_entry : "(" + one->unit + ")"),
                            per_cent(one->sensitivity), unrounded(one->paper_value),
                            number(one->value, 3), number(one->factor, 4),
                            fmt::format("{}: {} to {}",
                                        one->plausible  ? "yes"
                                        : one->at_limit ? "at the limit"
                                                        : "no",
                                        unrounded(one->low), unrounded(one->high)),
                            list(one->mended), list(one->broken)});
    if (!found.empty())
      table.note += fmt::format(
          " Values are those of the {} surface; the same factor goes on the input of all surfaces.",
          found.front()->surface);
    const bool has_speed = std::any_of(found.begin(), found.end(), [](const Requirement* one) {
      return one->field == Field::speed;
    });
    if (has_speed) table.note += " speed is a factor on the speed in the film formula.";
    if (!none.empty())
      table.note += fmt::format(" No factor from 1/30 to 30 on {} makes it hold.", list(none));
    tables.push_back(std::move(table));
  }
  return tables;
}

TextTable departure_table(const Ledger& ledger) {
  const CommonDeparture& found = ledger.departure;
  TextTable table{
      "C1 as a departure h* = (1 − ε) h_ff",
      {"surface", "ε that gives its reported speed", "computed/reported at the common ε"},
      {false, true, true},
      {},
      {}};
  for (std::size_t i = 0; i < surface_count; ++i)
    table.rows.push_back({surface_names[i], number(found.own[i]), rounded(found.factor[i], 3)});
  std::array<double, surface_count> reported{}, computed_speed{};
  for (std::size_t i = 0; i < ledger.items.size(); ++i) {
    const Item& item = ledger.items[i];
    if (item.quantity != Quantity::onset_speed) continue;
    reported[static_cast<std::size_t>(item.surface)] = item.reported;
    computed_speed[static_cast<std::size_t>(item.surface)] =
        ledger.readings.front().results[i].observed.value.value_or(0);
  }
  table.note = fmt::format(
      "The best common ε is {}. A criterion on r = h_ff/h_oil alone puts the onset at one λ on all "
      "surfaces, so that the speeds rise as σ_s^1/0.67 but for load sharing: by {} from smooth to "
      "medium and by {} from medium to rough (film_maximum). The reported ones rise by {} and by "
      "{}, the one less and the other more: no common criterion fits all three.",
      rounded(found.best, 4), rounded(computed_speed[1] / computed_speed[2], 3),
      rounded(computed_speed[0] / computed_speed[1], 3), rounded(reported[1] / reported[2], 3),
      rounded(reported[0] / reported[1], 3));
  return table;
}

TextTable uncertainty_table(const Ledger& ledger) {
  TextTable table{"How sure: inputs varied, corrected reading",
                  {"number", "inputs varied", "2.5 %", "median", "97.5 %", "reported"},
                  {false, false, true, true, true, true},
                  {},
                  {}};
  const auto reported = [&](Quantity quantity, std::size_t surface) {
    for (const Item& item : ledger.items)
      if (item.quantity == quantity && static_cast<std::size_t>(item.surface) == surface)
        return item.reported;
    return std::nan("");
  };
  for (const Uncertainty& one : ledger.uncertainty) {
    const char* const spread = one.spread == Spread::print ? "print precision" : "plausible ranges";
    const auto add = [&](const std::string& what, const Interval& interval, double printed) {
      table.rows.push_back({what, spread, rounded(interval.low, 3), rounded(interval.median, 3),
                            rounded(interval.high, 3),
                            std::isnan(printed) ? no_entry : rounded(printed, 3)});
    };
    for (std::size_t i = 0; i < surface_count; ++i)
      add(fmt::format("onset speed, {}, m/s", surface_names[i]), one.onset_speed[i],
          reported(Quantity::onset_speed, i));
    add("onset speeds, medium/smooth", one.medium_over_smooth,
        reported(Quantity::onset_speed, 1) / reported(Quantity::onset_speed, 2));
    add("onset speeds, rough/medium", one.rough_over_medium,
        reported(Quantity::onset_speed, 0) / reported(Quantity::onset_speed, 1));
    add("λ at the onset", one.film_parameter, reported(Quantity::onset_film_parameter, 0));
    for (std::size_t i = 0; i < surface_count; ++i)
      add(fmt::format("asperity share at the lowest speed, {}", surface_names[i]),
          one.slow_asperity_share[i], reported(Quantity::slow_asperity_share, i));
    table.note +=
        fmt::format("{}{}: {} draws; all three onset speeds print as reported in {} of them.",
                    table.note.empty() ? "" : " ", spread, one.draws, one.all_onsets_reported);
  }
  table.note +=
      " Onset by film_maximum. Print precision is half a unit of the last digit; the rough "
      "surface's σ_s = 0.1 µm has one digit, which is ± 50 %, and so has β = 10 µm, which is "
      "assumed (E17), not printed. Ranges: reference/published/inputs.tsv.";
  return table;
}

std::vector<TextTable> errata_tables(const Ledger& ledger) {
  TextTable settled{"The misprints, and how each is settled",
                    {"erratum", "place", "printed", "right", "settled by", "kind"},
                    {false, false, false, false, false, false},
                    {},
                    "A reading is a form that the author may have used, and a switch; a finding is "
                    "kept as printed; the others are mended everywhere."};
  TextTable effects{"The misprints, and what each would do",
                    {"erratum", "what is computed", "first form", "second form", "against"},
                    {false, false, true, true, false},
                    {},
                    "First and second form: those that “what is computed” names."};
  for (const Erratum& one : ledger.errata) {
    settled.rows.push_back(
        {one.id, one.place, one.printed, one.right, one.settled_by,
         one.kind == "reading" ? fmt::format("reading: {}", one.switch_or_reason) : one.kind});
    if (!one.evidence.empty())
      effects.rows.push_back({one.id, one.evidence, number(one.as_printed),
                              number(one.as_corrected),
                              one.decided_by.empty() ? no_entry : one.decided_by});
  }
  return {std::move(settled), std::move(effects)};
}

TextTable independent_table(const Ledger& ledger) {
  TextTable table{
      "Film and Hertz contact beside another library",
      {"case", "number", "other library", "computed", "within its last digit"},
      {false, false, true, true, false},
      {},
      "The other library rounds the film's constant to 1.9; the films here are computed with "
      "that. reference/published/independent.tsv."};
  for (const IndependentNumber& one : ledger.independent)
    table.rows.push_back({one.case_name, fmt::format("{}, {}", one.quantity, one.unit),
                          rounded(one.reported, static_cast<int>(one.digits)),
                          rounded(one.computed, static_cast<int>(one.digits)),
                          one.reproduced ? "yes" : "no"});
  return table;
}

}  // namespace tribo::report
