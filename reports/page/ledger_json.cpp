// SPDX-License-Identifier: Apache-2.0
#include "page/ledger_tables.hpp"

namespace tribo::report {
namespace {

using namespace reproduction;
using Json = nlohmann::ordered_json;

// null if there is no number. NaN and infinity are written as null too: JSON has neither.
Json number(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json switches(const Reading& reading) {
  Json object = Json::object();
  for (std::size_t i = 0; i < switch_count; ++i) {
    const SwitchInfo& one = info(static_cast<Switch>(i));
    object[std::string(one.name)] = one.choices[reading.choice[i]];
  }
  return object;
}

constexpr std::string_view rule_words[] = {"number", "order", "equal", "at_least"};

Json result_json(const Item& item, const ItemResult& result) {
  const Observed& observed = result.observed;
  Json object{{"computed", number(observed.value)}, {"verdict", name(result.verdict)}};
  object["decided"] = result.is_decided();
  if (!observed.value) {
    object["none"] = observed.none;
    return object;
  }
  object["numerical_error"] = number(observed.error);
  if (item.rule == Rule::number) object["factor"] = *observed.value / item.reported;
  if (observed.other_end != *observed.value) object["other_end"] = number(observed.other_end);
  if (item.rule != Rule::number) object["holds_at"] = observed.part;
  if (observed.part_error) object["holds_at_error"] = *observed.part_error;
  if (result.margin)
    object["margin"] = {{"of", name(result.margin->of)},
                        {"distance", result.margin->distance},
                        {"error", number(result.margin->error)}};
  if (observed.beyond_collapse != 0) object["beyond_collapse"] = beyond_collapse(observed);
  return object;
}

Json item_json(const Ledger& ledger, const std::vector<NamedReading>& readings, std::size_t i) {
  const Item& item = ledger.items[i];
  const double met_by = ledger.item_statistics[i].part;
  Json object{{"item", item.id},
              {"claim", item.claim},
              {"quantity", name(item.quantity)},
              {"surface", item.surface_text},
              {"model", item.model},
              {"label", item.label},
              {"statement", item.statement},
              {"rule", rule_words[static_cast<std::size_t>(item.rule)]},
              {"is_over_speeds", is_over_speeds(item)},
              {"is_arithmetic", item.is_arithmetic},
              {"printed", item.printed},
              {"place", item.place},
              {"computed_as", item.computed_as},
              {"reported", item.rule == Rule::number ? Json(item.reported) : Json(nullptr)},
              {"tolerance", number(item.tolerance)},
              {"unit", item.unit},
              {"met_by", met_by},
              {"met_by_readings", ledger.item_statistics[i].readings},
              {"undecided_readings", ledger.item_statistics[i].undecided},
              {"bits", met_by > 0 ? Json(std::abs(std::log2(met_by))) : Json(nullptr)},
              {"readings", Json::object()}};
  for (const NamedReading& reading : readings)
    object["readings"][reading.name] = result_json(item, reading.results[i]);
  object["identifies"] = Json::array();
  for (const Identification& one : ledger.item_statistics[i].identified)
    object["identifies"].push_back({{"switch", info(one.which).name},
                                    {"choice", info(one.which).choices[one.choice]},
                                    {"share", one.share},
                                    {"by_chance", one.chance}});
  return object;
}

Json requirement_json(const Ledger& ledger, const Requirement& one) {
  return {{"item", ledger.items[one.item].id},
          {"input", name(one.field)},
          {"sensitivity", number(one.sensitivity)},
          {"factor_by_sensitivity", number(one.by_sensitivity)},
          {"factor", number(one.factor)},
          {"distance", one.factor ? Json(std::abs(std::log(*one.factor))) : Json(nullptr)},
          {"surface", one.surface},
          {"unit", one.unit},
          {"paper_value", one.paper_value},
          {"value", one.factor ? Json(one.value) : Json(nullptr)},
          {"low", one.low},
          {"high", one.high},
          {"plausible", one.plausible},
          {"at_limit", one.at_limit},
          {"mends", one.mended},
          {"breaks", one.broken}};
}

Json interval_json(const Interval& one) {
  return {{"low", number(one.low)},
          {"median", number(one.median)},
          {"high", number(one.high)},
          {"least", number(one.least)},
          {"greatest", number(one.greatest)}};
}

Json uncertainty_json(const Uncertainty& one) {
  Json object{{"inputs_varied", one.spread == Spread::print ? "print" : "plausible"},
              {"draws", one.draws},
              {"all_onsets_as_reported", one.all_onsets_reported}};
  for (std::size_t i = 0; i < surface_count; ++i) {
    object["onset_speed"][ledger_cells::surface_names[i]] = interval_json(one.onset_speed[i]);
    object["slow_asperity_share"][ledger_cells::surface_names[i]] =
        interval_json(one.slow_asperity_share[i]);
  }
  object["onset_speed_medium_over_smooth"] = interval_json(one.medium_over_smooth);
  object["onset_speed_rough_over_medium"] = interval_json(one.rough_over_medium);
  object["onset_film_parameter"] = interval_json(one.film_parameter);
  return object;
}

Json ranking_json(const Ledger& ledger) {
  const reproduction::ReadingRank corrected =
      standing(ledger.ranking, ledger.readings.front().score);
  Json object{{"readings", reading_count()},
              {"readings_by_score", ledger.ranking.histogram},
              {"mean_score", ledger.ranking.mean_score},
              {"score_standard_deviation", ledger.ranking.score_sd},
              {"best_score", ledger.ranking.best.front().score},
              {"best_ties", ledger.ranking.best_ties},
              {"above_corrected", corrected.above},
              {"equal_to_corrected", corrected.equal},
              {"best", Json::array()}};
  for (const RankedGroup& group : ledger.ranking.best)
    object["best"].push_back({{"score", group.score},
                              {"readings_with_the_same_claims", group.ties},
                              {"representative", switches(group.representative)},
                              {"departures", departures(group.representative)},
                              {"in_common", group.fixed},
                              {"differ_in", group.free}});
  return object;
}

Json switches_json() {
  Json made = Json::array();
  for (std::size_t i = 0; i < switch_count; ++i) {
    const SwitchInfo& one = info(static_cast<Switch>(i));
    made.push_back({{"name", one.name},
                    {"errata", one.errata},
                    {"choices", one.choices},
                    {"corrected", one.choices[one.corrected]},
                    {"literal", one.choices[one.literal]},
                    {"meaning", one.meaning}});
  }
  return made;
}

Json departure_json(const CommonDeparture& found) {
  Json object{{"common", found.best}, {"own", Json::array()}, {"factor", found.factor}};
  for (const auto& own : found.own) object["own"].push_back(number(own));
  return object;
}

}  // namespace

Json ledger_json(const Ledger& ledger, const std::vector<NamedReading>& readings,
                 const std::vector<std::string>& claims) {
  Json object{{"summary", verdict_sentence(ledger, ledger.readings.front())},
              {"headline", headline_items},
              {"switches", switches_json()},
              {"readings", Json::array()},
              {"claims", Json::array()},
              {"items", Json::array()}};
  for (const NamedReading& reading : readings)
    object["readings"].push_back({{"name", reading.name},
                                  {"score", reading.score},
                                  {"departures", departures(reading.reading)},
                                  {"switches", switches(reading.reading)}});
  for (std::size_t k = 0; k < ledger.claims.size(); ++k) {
    if (!ledger_cells::is_wanted(claims, ledger.claims[k])) continue;
    Json claim{{"claim", ledger.claims[k]},
               {"statement", ledger.statements[k]},
               {"met_by", ledger.claim_parts[k]}};
    for (const NamedReading& reading : readings)
      claim["verdicts"][reading.name] = name(reading.verdicts[k]);
    claim["undecided"] = Json::array();
    for (const NamedReading& reading : readings)
      if (!is_decided(ledger.claims[k], ledger.items, reading.results))
        claim["undecided"].push_back(reading.name);
    object["claims"].push_back(claim);
  }
  for (std::size_t i = 0; i < ledger.items.size(); ++i)
    if (ledger_cells::is_wanted(claims, ledger.items[i].claim))
      object["items"].push_back(item_json(ledger, readings, i));
  object["ranking"] = ranking_json(ledger);
  object["tolerances"] = Json::array();
  for (const ToleranceScores& one : ledger.tolerances) {
    Json row{{"factor", one.factor}, {"scores", Json::object()}};
    for (std::size_t i = 0; i < one.scores.size(); ++i)
      row["scores"][ledger.readings[i].name] = one.scores[i];
    object["tolerances"].push_back(std::move(row));
  }
  for (const Argument& one : ledger.arguments) {
    Json argument{
        {"question", one.question}, {"reported", one.reported},   {"low", one.low},
        {"high", one.high},         {"agreeing", one.agreeing()}, {"candidates", Json::array()}};
    for (const Candidate& candidate : one.candidates)
      argument["candidates"].push_back({{"name", candidate.name},
                                        {"value", number(candidate.value)},
                                        {"low", number(candidate.low)},
                                        {"high", number(candidate.high)},
                                        {"agrees", candidate.agrees}});
    object["arguments"].push_back(argument);
  }
  object["requirements"] = Json::array();
  for (const Requirement& one : ledger.requirements)
    if (ledger_cells::is_wanted(claims, ledger.items[one.item].claim))
      object["requirements"].push_back(requirement_json(ledger, one));
  object["common_departure"] = departure_json(ledger.departure);
  for (const Uncertainty& one : ledger.uncertainty)
    object["uncertainty"].push_back(uncertainty_json(one));
  for (const Erratum& one : ledger.errata)
    object["errata"].push_back({{"erratum", one.id},
                                {"place", one.place},
                                {"printed", one.printed},
                                {"right", one.right},
                                {"settled_by", one.settled_by},
                                {"kind", one.kind},
                                {"switch_or_reason", one.switch_or_reason},
                                {"computed", one.evidence},
                                {"as_printed", number(one.as_printed)},
                                {"as_corrected", number(one.as_corrected)},
                                {"against", one.decided_by}});
  for (const IndependentNumber& one : ledger.independent)
    object["independent"].push_back({{"case", one.case_name},
                                     {"quantity", one.quantity},
                                     {"unit", one.unit},
                                     {"reported", one.reported},
                                     {"computed", one.computed},
                                     {"digits", one.digits},
                                     {"reproduced", one.reproduced}});
  return object;
}

}  // namespace tribo::report
