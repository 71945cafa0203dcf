// SPDX-License-Identifier: Apache-2.0
#include "validity_writers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "page/text_table.hpp"
#include "scene/text.hpp"

namespace tribo::cli {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t table_width = 120;

// A number in the unit that engineers have for its size: "1.08 GPa", "3.2 nm".
std::string quantity_text(double value, std::string_view unit, int digits = 3) {
  const double size = std::fabs(value);
  if (unit == "Pa" && size >= 1e4 && std::isfinite(value))
    return size >= 1e9 ? fmt::format("{:.{}g} GPa", value / 1e9, digits)
                       : fmt::format("{:.{}g} MPa", value / 1e6, digits);
  if (unit == "m" && size > 0 && size < 1e-3)
    return size < 1e-6 ? fmt::format("{:.{}g} nm", value / 1e-9, digits)
                       : fmt::format("{:.{}g} µm", value / 1e-6, digits);
  return fmt::format("{:.{}g}{}{}", value, digits, unit.empty() ? "" : " ", unit);
}

// The text of a limit's value or bound. For a field it is written as in scenes.
std::string number_of(const Validity& limit, double number) {
  if (limit.field.empty() || (limit.value_follows && number == limit.value))
    return quantity_text(number, limit.unit);
  return scene_detail::number_text(number) + (limit.unit.empty() ? "" : " ") +
         std::string(limit.unit);
}

// The text of the value, with more digits if it would read like the bound that it is beyond.
std::string value_text(const Validity& limit) {
  std::string text = number_of(limit, limit.value);
  const bool reads_as_bound =
      limit.field.empty() && limit.is_known() && !limit.holds() &&
      (text == number_of(limit, limit.least) || text == number_of(limit, limit.greatest));
  return reads_as_bound ? quantity_text(limit.value, limit.unit, 6) : text;
}

// The bounds, such as "at most 4 GPa" or "1e-05 Pa·s to 10 Pa·s".
std::string bounds_text(const Validity& limit) {
  const std::string least = number_of(limit, limit.least);
  const std::string greatest = number_of(limit, limit.greatest);
  if (limit.least == limit.greatest) return least;
  if (!limit.is_known()) return "not known";
  if (limit.least == 0) return "at most " + greatest;
  return std::isfinite(limit.greatest) ? least + " to " + greatest : "at least " + least;
}

std::string_view holds_text(const Validity& limit) {
  if (!limit.is_known()) return "not known";
  return limit.holds() ? "yes" : limit.is_accepted ? "accepted" : "no";
}

}  // namespace

std::string passed_text(const Validity& limit, bool is_short) {
  const std::string_view name = limit.field.empty() ? limit.word : limit.field;
  std::string text = fmt::format("{}{} {} ({}", name, limit.value_follows ? ", which follows," : "",
                                 value_text(limit), bounds_text(limit));
  if (limit.judged_cases > 0)
    text +=
        fmt::format("; in {} of {} cases{}, furthest in case {}", limit.cases, limit.judged_cases,
                    limit.judged_cases < limit.all_cases
                        ? fmt::format(" looked at, a sample of {}", limit.all_cases)
                        : "",
                    limit.furthest_case);
  if (!is_short && limit.touches != "everything")
    text += fmt::format("; touches {}", limit.touches);
  if (!is_short && !limit.advice.empty()) text += fmt::format("; {}", limit.advice);
  if (!limit.likely_unit.empty()) text += fmt::format("; perhaps {} was meant", limit.likely_unit);
  return text + ')';
}

void append_validity(Text& to, std::string_view id, const std::vector<Validity>& limits) {
  report::TextTable table{
      fmt::format("{}: is the model valid here?", id),
      {"holds", "value here", "limit", "touches", "word", "what the model assumes"},
      std::vector<bool>(6, false),
      {},
      ""};
  for (const Validity& limit : limits) {
    std::string assumption = limit.field.empty()
                                 ? std::string(limit.assumption)
                                 : fmt::format("{} is in the range of real contacts.", limit.field);
    if (!limit.advice.empty()) assumption += fmt::format(" Here {}.", limit.advice);
    if (!limit.likely_unit.empty())
      assumption += fmt::format(" Perhaps {} was meant.", limit.likely_unit);
    table.rows.push_back({std::string(holds_text(limit)), value_text(limit), bounds_text(limit),
                          std::string(limit.touches), std::string(limit.word), assumption});
  }
  append(to, report::plain_table(table, table_width));
}

ordered_json validity_json(const std::vector<Validity>& limits) {
  ordered_json rows = ordered_json::array();
  for (const Validity& limit : limits) {
    const auto bound = [](double number, bool is_there) {
      return is_there ? ordered_json(number) : ordered_json(nullptr);
    };
    rows.push_back({{"word", limit.word},
                    {"assumption", limit.assumption},
                    {"value", limit.value},
                    {"least", bound(limit.least, limit.least != 0)},
                    {"greatest", bound(limit.greatest, std::isfinite(limit.greatest))},
                    {"unit", limit.unit},
                    {"holds", holds_text(limit)},
                    {"touches", limit.touches},
                    {"advice", limit.advice},
                    {"source", limit.source}});
  }
  return rows;
}

void Warnings::add(std::string_view source, std::string_view id,
                   const std::vector<Validity>& passed) {
  if (!passed.empty()) scenes_.push_back({std::string(source), std::string(id), passed});
}

void Warnings::tell(std::string_view where) const {
  if (scenes_.empty()) return;
  std::vector<std::string_view> words;
  std::string slips, others;  // numbers that are likely in another unit are told first
  for (const OfScene& scene : scenes_)
    for (const Validity& limit : scene.passed) {
      if (std::find(words.begin(), words.end(), limit.word) != words.end()) continue;
      words.push_back(limit.word);
      std::string& told = limit.likely_unit.empty() ? others : slips;
      told += (told.empty() ? "" : ", ") + passed_text(limit, true);
      const auto passes_too = [&](const OfScene& other) {
        return std::any_of(other.passed.begin(), other.passed.end(),
                           [&](const Validity& one) { return one.word == limit.word; });
      };
      const auto count = std::count_if(scenes_.begin(), scenes_.end(), passes_too);
      if (scenes_.size() > 1)
        told += " of " + scene.source + (count > 1 ? fmt::format(" and {} more", count - 1) : "");
    }
  std::string accepted;
  for (const std::string_view word : words)
    accepted += fmt::format("{}\"{}\"", accepted.empty() ? "" : ", ", word);
  complain(fmt::format(
      "warning: {}outside of the model's limits: {}; {}, and accept = [{}] in the scene "
      "accepts them",
      scenes_.size() == 1 ? scenes_.front().source + ": " : "",
      slips + (slips.empty() || others.empty() ? "" : ", ") + others, where, accepted));
}

ordered_json Warnings::json() const {
  ordered_json rows = ordered_json::array();
  for (const OfScene& scene : scenes_)
    for (const Validity& limit : scene.passed)
      rows.push_back({{"id", scene.id},
                      {"word", limit.word},
                      {"value", limit.value},
                      {"limit", limit.limit()},
                      {"unit", limit.unit},
                      {"text", passed_text(limit)}});
  return rows;
}

}  // namespace tribo::cli
