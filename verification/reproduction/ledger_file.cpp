// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "accuracy/reference_table.hpp"
#include "reproduction/ledger.hpp"

namespace tribo::reproduction {
namespace {

constexpr double moved = 1e-6;

bool is_wanted(const std::vector<std::string>& claims, const std::string& claim) {
  return claims.empty() || std::find(claims.begin(), claims.end(), claim) != claims.end();
}

std::string number(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? fmt::format("{}", *value) : std::string();
}

std::size_t claim_index(const Ledger& ledger, const Item& item) {
  return static_cast<std::size_t>(
      std::find(ledger.claims.begin(), ledger.claims.end(), item.claim) - ledger.claims.begin());
}

struct Row {
  std::string departures, verdict, decided, computed, holds_at, met_by;
};

std::string_view yes_or_no(bool yes) { return yes ? "yes" : "no"; }

// Only the size of an error is known, so it is printed with two digits.
std::string error_text(double error) { return fmt::format("{:.2g}", error); }

bool is_moved(const std::string& before, const std::string& now) {
  if (before == now) return false;
  if (before.empty() || now.empty()) return true;
  const double a = std::stod(before), b = std::stod(now);
  return !(std::abs(a - b) <= moved * std::max(std::abs(a), std::abs(b)) + 1e-300);
}

}  // namespace

std::string ledger_csv(const Ledger& ledger, const std::vector<NamedReading>& readings,
                       const std::vector<std::string>& claims) {
  std::string text =
      "reading,departures,item,claim,computed,other_end,numerical_error,holds_at,reported,factor,"
      "verdict,claim_verdict,margin,margin_of,margin_error,decided,beyond_collapse,met_by\n";
  for (const NamedReading& reading : readings)
    for (std::size_t i = 0; i < ledger.items.size(); ++i) {
      const Item& item = ledger.items[i];
      if (!is_wanted(claims, item.claim)) continue;
      const ItemResult& result = reading.results[i];
      const bool is_number = item.rule == Rule::number,
                 has_value = result.observed.value.has_value();
      const std::optional<Margin>& margin = result.margin;
      std::optional<double> factor;
      if (is_number && result.observed.value) factor = *result.observed.value / item.reported;
      text += fmt::format(
          "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", reading.name,
          departures(reading.reading), item.id, item.claim, number(result.observed.value),
          has_value ? number(result.observed.other_end) : std::string(),
          has_value ? error_text(result.observed.error) : std::string(), result.observed.part,
          is_number ? fmt::format("{}", item.reported) : std::string(), number(factor),
          name(result.verdict), name(reading.verdicts[claim_index(ledger, item)]),
          margin ? number(margin->distance) : std::string(),
          margin ? name(margin->of) : std::string_view(),
          margin ? error_text(margin->error) : std::string(), yes_or_no(result.is_decided()),
          fmt::join(beyond_collapse(result.observed), " "), ledger.item_statistics[i].part);
    }
  return text;
}

LedgerChanges changes_since(const std::string& path, const Ledger& ledger,
                            const std::vector<NamedReading>& readings,
                            const std::vector<std::string>& claims) {
  std::map<std::pair<std::string, std::string>, Row> before;
  for (const auto& row : verification::read_reference_table(path))
    before[{row.text("reading"), row.text("item")}] = {row.text("departures"), row.text("verdict"),
                                                       row.text("decided"),    row.text("computed"),
                                                       row.text("holds_at"),   row.text("met_by")};
  LedgerChanges changes;
  for (const NamedReading& reading : readings) {
    bool is_another = false;
    for (std::size_t i = 0; i < ledger.items.size() && !is_another; ++i) {
      const Item& item = ledger.items[i];
      const auto found = before.find({reading.name, item.id});
      if (!is_wanted(claims, item.claim)) continue;
      if (found == before.end()) {
        if (before.contains({reading.name, ledger.items.front().id}))
          changes.verdicts.push_back(fmt::format("{}, {}: was not there", item.id, reading.name));
        continue;
      }
      const Row& row = found->second;
      is_another = row.departures != departures(reading.reading);
      const std::string_view verdict = name(reading.results[i].verdict);
      if (is_another)
        changes.verdicts.push_back(fmt::format("{}: was {}, is {}", reading.name, row.departures,
                                               departures(reading.reading)));
      else if (row.verdict != verdict)
        changes.verdicts.push_back(fmt::format("{}, {}: was {} ({}), is {} ({})", item.id,
                                               reading.name, row.verdict, row.computed, verdict,
                                               number(reading.results[i].observed.value)));
      else if (row.decided != yes_or_no(reading.results[i].is_decided()))
        changes.numbers.push_back(fmt::format("{}, {}: was {}decided, is {}decided", item.id,
                                              reading.name, row.decided == "yes" ? "" : "un",
                                              reading.results[i].is_decided() ? "" : "un"));
      else if (is_moved(row.computed, number(reading.results[i].observed.value)))
        changes.numbers.push_back(fmt::format("{}, {}: was {}, is {}", item.id, reading.name,
                                              row.computed,
                                              number(reading.results[i].observed.value)));
      else if (is_moved(row.holds_at, fmt::format("{}", reading.results[i].observed.part)))
        changes.numbers.push_back(fmt::format("{}, {}: held at a part of {}, holds at {}", item.id,
                                              reading.name, row.holds_at,
                                              reading.results[i].observed.part));
      else if (is_moved(row.met_by, fmt::format("{}", ledger.item_statistics[i].part)))
        changes.numbers.push_back(fmt::format("{}: was met by {} of the readings, is by {}",
                                              item.id, row.met_by, ledger.item_statistics[i].part));
    }
  }
  return changes;
}

}  // namespace tribo::reproduction
