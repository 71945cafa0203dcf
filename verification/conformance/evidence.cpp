// SPDX-License-Identifier: Apache-2.0
#include "conformance/evidence.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "catalogue/catalogue.hpp"
#include "conformance/answer_line.hpp"
#include "scene/schema.hpp"
#include "tribo/outputs.hpp"

namespace tribo::conformance {
namespace {

using nlohmann::json;

constexpr std::size_t most_error_lines = 20;

struct ResultName {
  std::string_view name, unit;
};

// The results of a function of the catalogue, or of an operating point.
std::vector<ResultName> results_of(const std::string& function) {
  std::vector<ResultName> results;
  if (const catalogue::Function* const found = catalogue::find(function))
    for (const catalogue::Result& one : found->results) results.push_back({one.name, one.unit});
  else
    for (const OutputInfo& one : output_infos) results.push_back({one.name, one.unit});
  return results;
}

std::string unit_of(const std::string& function, const std::string& field) {
  for (const ResultName& one : results_of(function))
    if (one.name == field) return std::string(one.unit);
  return {};
}

std::string with_unit(const std::string& number, const std::string& unit) {
  return unit.empty() ? number : number + " " + unit;
}

// A field of an answer that is no result of the function.
struct Stranger {
  std::string function, field;
  auto operator<=>(const Stranger&) const = default;
};

std::string text_of(const Stranger& one, std::size_t count, bool any_known) {
  std::vector<std::string_view> names;
  for (const ResultName& result : results_of(one.function)) names.push_back(result.name);
  const std::string_view nearest = scene_detail::nearest_choice(one.field, names);
  std::string hint;
  if (!nearest.empty())
    hint = fmt::format("did you mean {}?", nearest);
  else if (any_known)
    return {};  // it tells more than it was asked for
  else
    hint = fmt::format("{} {}", names.size() == 1 ? "its result is called" : "its results are",
                       fmt::join(names, ", "));
  return fmt::format("{} of {} has a field \"{}\", which is no result of it; {}",
                     count == 1 ? "An answer" : fmt::format("Each of {} answers", count),
                     one.function, start_of(one.field), hint);
}

}  // namespace

Example example_of(const Case& asked, const Expected& expected, const Answer& answer,
                   const Tolerance& tolerance) {
  Example made{quantity_name(asked, expected),
               asked.id,
               json::parse(asked.line()),
               expected,
               allowed_error(asked, expected, tolerance),
               unit_of(asked.function, expected.field),
               {},
               answer.reason,
               0};
  if (answer.outcome != Outcome::answered) return made;
  if (const auto field = answer.fields.find(expected.field); field != answer.fields.end())
    made.got = *field;
  else
    made.reason = fmt::format("the answer has no field {}", expected.field);
  return made;
}

std::string expected_text(const Example& example) {
  const Expected& expected = example.expected;
  if (!expected.word.empty()) return expected.word;
  if (expected.is_undefined) return "null, as it is undefined there";
  return fmt::format("{}, give or take {:.2g}",
                     with_unit(fmt::format("{}", expected.high), example.unit), example.allowed);
}

std::string got_text(const Example& example) {
  if (!example.got) return fmt::format("nothing ({})", example.reason);
  const std::string text = example.got->dump(-1, ' ', true, json::error_handler_t::replace);
  return example.got->is_number() ? with_unit(text, example.unit) : start_of(text);
}

std::string error_text(const Example& example) {
  const bool is_number = example.got && example.got->is_number() && example.expected.word.empty() &&
                         !example.expected.is_undefined;
  if (!is_number || !std::isfinite(example.part_of_bound)) return {};
  return example.part_of_bound > 1
             ? fmt::format("{:.3g} times as far off as is allowed", example.part_of_bound)
             : fmt::format("{:.3g} of the error that is allowed", example.part_of_bound);
}

std::vector<Example> worst_examples(const ConformanceResult& result, const std::vector<Case>& cases,
                                    const Conversation& conversation, const Tolerance& tolerance,
                                    bool of_all) {
  std::map<std::string, std::size_t> index_of;
  for (std::size_t i = 0; i < cases.size(); ++i) index_of[cases[i].id] = i;
  std::vector<Example> examples;
  for (const QuantityVerdict& one : result.quantities) {
    if (one.failed == 0 && !of_all) continue;
    const auto place = index_of.find(one.worst_case.empty() ? cases.front().id : one.worst_case);
    if (place == index_of.end()) continue;
    const Case& asked = cases[place->second];
    for (const Expected& expected : asked.expected) {
      if (quantity_name(asked, expected) != one.quantity) continue;
      examples.push_back(
          example_of(asked, expected, conversation.answers[place->second], tolerance));
      examples.back().part_of_bound = one.worst_part_of_bound;
    }
  }
  return examples;
}

std::vector<std::string> notes_on(const std::vector<Case>& cases,
                                  const Conversation& conversation) {
  std::vector<std::string> notes;
  if (conversation.print_count > 0)
    notes.push_back(fmt::format(
        "It wrote {} lines to stdout that are no answers; print to stderr instead. The first: {}",
        conversation.print_count, conversation.first_print));
  if (conversation.stays)
    notes.push_back("It did not end when its input had ended, and was killed.");
  std::map<Stranger, std::size_t> strangers;
  std::set<std::string> with_known;  // functions
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Answer& answer = conversation.answers[i];
    if (answer.outcome != Outcome::answered) continue;
    const std::vector<ResultName> results = results_of(cases[i].function);
    for (const auto& [field, value] : answer.fields.items()) {
      if (field == "id" || field == "undefined") continue;
      if (std::any_of(results.begin(), results.end(),
                      [&field = field](const ResultName& one) { return one.name == field; }))
        with_known.insert(cases[i].function);
      else
        ++strangers[{cases[i].function, field}];
    }
  }
  for (const auto& [one, count] : strangers) {
    std::string text = text_of(one, count, with_known.contains(one.function));
    if (!text.empty()) notes.push_back(std::move(text));
  }
  return notes;
}

std::vector<std::string> last_error_lines(const Conversation& conversation) {
  std::vector<std::string> lines;
  std::istringstream text(conversation.last_errors);
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  while (!lines.empty() && lines.back().empty()) lines.pop_back();
  const bool has_failures =
      std::any_of(conversation.answers.begin(), conversation.answers.end(), [](const Answer& one) {
        return one.outcome != Outcome::answered && one.outcome != Outcome::skipped;
      });
  const std::size_t kept = std::min(lines.size(), has_failures ? most_error_lines : 1);
  lines.erase(lines.begin(), lines.end() - static_cast<std::ptrdiff_t>(kept));
  return lines;
}

}  // namespace tribo::conformance
