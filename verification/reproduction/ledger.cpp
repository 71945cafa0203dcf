// SPDX-License-Identifier: Apache-2.0
#include "reproduction/ledger.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tribo::reproduction {
namespace {

ReportedOnsets reported_onsets(const std::vector<Item>& items) {
  ReportedOnsets reported{};
  for (const Item& item : items)
    if (item.quantity == Quantity::onset_speed) {
      reported.speed[static_cast<std::size_t>(item.surface)] = item.reported;
      reported.last_digit[static_cast<std::size_t>(item.surface)] = item.last_digit;
    }
  return reported;
}

int score_with(const std::vector<Item>& items, const std::vector<ItemResult>& results,
               double factor) {
  std::vector<ItemResult> judged_again;
  for (std::size_t i = 0; i < items.size(); ++i)
    judged_again.push_back(judged(with_tolerance(items[i], factor), results[i].observed));
  const std::vector<Verdict> verdicts = claim_verdicts(items, judged_again);
  return static_cast<int>(std::count(verdicts.begin(), verdicts.end(), Verdict::reproduced));
}

}  // namespace

NamedReading named_reading(const PaperScenes& scenes, const std::vector<Item>& items,
                           std::string name, const Reading& reading) {
  NamedReading made{std::move(name), reading, evaluate(scenes, reading, items), {}, 0};
  made.verdicts = claim_verdicts(items, made.results);
  made.score =
      static_cast<int>(std::count(made.verdicts.begin(), made.verdicts.end(), Verdict::reproduced));
  return made;
}

Ledger make_ledger(const LedgerOptions& options) {
  Ledger ledger;
  ledger.scenes = read_paper_scenes(options.published);
  ledger.items = read_claims(options.published + "/claims.tsv");
  ledger.claims = claim_names(ledger.items);
  ledger.statements = read_statements(options.published + "/statements.tsv", ledger.claims);
  const std::vector<Input> inputs = read_inputs(options.published + "/inputs.tsv");
  ledger.errata = read_errata(options.published + "/errata.tsv", ledger.scenes);
  ledger.independent = independent_numbers(options.published + "/independent.tsv");

  ledger.work = enumerate(ledger.scenes, ledger.items);
  ledger.ranking = rank(ledger.work, ledger.items, options.best);
  ledger.item_statistics = item_statistics(ledger.work, ledger.items);
  ledger.claim_parts = claim_parts(ledger.work, ledger.items);
  for (std::vector<ItemMask>* const masks :
       {&ledger.work.items, &ledger.work.claims, &ledger.work.refined, &ledger.work.undecided})
    masks->clear();

  const auto add = [&](std::string name, const Reading& reading) {
    ledger.readings.push_back(named_reading(ledger.scenes, ledger.items, std::move(name), reading));
  };
  add("corrected", corrected_reading());
  add("m = 2", with(Switch::offset_planes, 1));
  add("equal faces", with(Switch::offset_planes, 2));
  add("literal", literal_reading());
  for (std::size_t i = 0; i < ledger.ranking.best.size(); ++i)
    add(fmt::format("best {}", i + 1), ledger.ranking.best[i].representative);
  for (const Reading& reading : options.asked) {
    const bool is_there =
        std::any_of(ledger.readings.begin(), ledger.readings.end(),
                    [&](const NamedReading& one) { return one.reading == reading; });
    if (!is_there) add(departures(reading), reading);
  }

  for (const double factor : {0.5, 1.0, 2.0, 4.0}) {
    ToleranceScores& row = ledger.tolerances.emplace_back();
    row.factor = factor;
    for (const NamedReading& reading : ledger.readings)
      row.scores.push_back(score_with(ledger.items, reading.results, factor));
  }

  ledger.arguments = arguments(ledger.scenes, ledger.items, inputs);
  keep_what_print_precision_identifies(ledger.item_statistics, ledger.items, ledger.arguments);
  const NamedReading& corrected = ledger.readings.front();
  if (options.requirements)
    ledger.requirements =
        requirements(ledger.scenes, corrected.reading, ledger.items, corrected.results, inputs);
  const ReportedOnsets reported = reported_onsets(ledger.items);
  ledger.departure = common_departure(ledger.scenes, corrected.reading, reported.speed);
  for (const Spread spread : {Spread::print, Spread::plausible})
    ledger.uncertainty.push_back(
        uncertainty(ledger.scenes, inputs, spread, options.draws, reported));
  return ledger;
}

}  // namespace tribo::reproduction
