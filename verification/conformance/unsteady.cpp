// SPDX-License-Identifier: Apache-2.0
#include "conformance/unsteady.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace tribo::conformance {
namespace {

constexpr std::size_t most_lines = 10;

Said said(const Reply& reply, const std::string& field) {
  if (reply.outcome != Outcome::answered) return {std::nullopt, reply.reason};
  const auto value = reply.fields.find(field);
  if (value == reply.fields.end()) return {std::nullopt, "the answer has no field " + field};
  return {*value, {}};
}

bool differ(const Reply& first, const Reply& second, const std::string& field) {
  if (first.outcome != second.outcome) return true;
  return first.outcome == Outcome::answered &&
         said(first, field).value != said(second, field).value;
}

double distance(const Said& first, const Said& second) {
  const auto is_number = [](const Said& one) { return one.value && one.value->is_number(); };
  if (!is_number(first) || !is_number(second)) return std::numeric_limits<double>::infinity();
  const double a = first.value->get<double>(), b = second.value->get<double>();
  const double greater = std::max(std::abs(a), std::abs(b));
  return greater == 0 ? 0 : std::abs(a / greater - b / greater);
}

std::string text_of(const Said& one, std::string_view unit) {
  if (!one.value) return fmt::format("no answer ({})", one.reason);
  const bool has_unit = one.value->is_number() && !unit.empty();
  return start_of(line_of(*one.value)) + (has_unit ? fmt::format(" {}", unit) : "");
}

}  // namespace

std::vector<Unsteady> unsteady_quantities(const std::vector<TestCase>& cases,
                                          const Conversation& conversation) {
  std::vector<Unsteady> all;
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < conversation.again.size(); ++i) {
    const TestCase& asked = cases[conversation.again[i]];
    const Reply& first = conversation.answers[conversation.again[i]];
    const Reply& second = conversation.second_answers[i];
    if (second.outcome == Outcome::not_asked) continue;
    for (const Expected& expected : asked.expected) {
      const auto [place, is_new] = places.try_emplace(expected.quantity, all.size());
      if (is_new) all.emplace_back().quantity = expected.quantity;
      Unsteady& one = all[place->second];
      ++one.asked_again;
      if (!differ(first, second, expected.field)) continue;
      const Said before = said(first, expected.field), after = said(second, expected.field);
      const double apart = distance(before, after);
      one.apart_per_condition =
          std::max(one.apart_per_condition, apart / std::max(1.0, expected.condition));
      if (one.changed++ > 0 && apart <= one.apart) continue;
      one.id = asked.id;
      one.first = before;
      one.second = after;
      one.first_place = first.place;
      one.second_place = second.place;
      one.unit = expected.unit;
      one.apart = apart;
    }
  }
  std::erase_if(all, [](const Unsteady& one) { return one.changed == 0; });
  return all;
}

std::string change_text(const Unsteady& one) {
  return fmt::format("{}, then {}{}{}", text_of(one.first, one.unit), text_of(one.second, one.unit),
                     std::isfinite(one.apart) ? fmt::format(", {:.2g} of it apart", one.apart) : "",
                     one.first_place.empty() || one.second_place.empty()
                         ? ""
                         : fmt::format("; asked {}, then {}", one.first_place, one.second_place));
}

std::vector<std::string> unsteady_lines(const std::vector<Unsteady>& unsteady) {
  if (unsteady.empty()) return {};
  std::vector<std::string> lines{
      "Asked the same again, after other questions, it gives another answer: it keeps something "
      "from one question to the next, as a cache with a wrong key, reads memory that is not set, "
      "or adds in another order each time:"};
  for (const Unsteady& one : unsteady) {
    if (lines.size() > most_lines) {
      lines.push_back(fmt::format("  and {} more", unsteady.size() - most_lines));
      break;
    }
    lines.push_back(fmt::format("  {} changes in {} of {} cases; in {} most: {}", one.quantity,
                                one.changed, one.asked_again, one.id, change_text(one)));
  }
  return lines;
}

}  // namespace tribo::conformance
