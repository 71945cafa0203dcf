// SPDX-License-Identifier: Apache-2.0
#include "conformance/conformance.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

#include "catalogue/catalogue.hpp"
#include "conformance/conversation.hpp"
#include "scene/schema.hpp"
#include "tribo/outputs.hpp"

namespace tribo::conformance {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double none = std::numeric_limits<double>::quiet_NaN();

double unit_in_last_place(double value) {
  return std::max(std::numeric_limits<double>::denorm_min(),
                  std::ldexp(1.0, value == 0 ? -1074 : std::ilogb(value) - 52));
}

struct Measured {
  double got = none;
  double part_of_bound = infinity;
  double relative = infinity;
  std::string reason;  // where it fails
  Failure how = Failure::wrong;
  double per_condition = 0;  // the relative error over the condition; 0 where it plays no part
};

Measured without_answer(std::string reason) {
  return {none, infinity, infinity, std::move(reason), Failure::no_answer};
}

Measured measure_word(const Expected& expected, const nlohmann::json& value) {
  if (value == expected.word) return {none, 0, 0, {}};
  return {none, infinity, infinity, fmt::format("{}, not {}", value.dump(), expected.word)};
}

Measured measure_undefined(const nlohmann::json& value) {
  if (value.is_null()) return {none, 0, 0, {}};
  return {none, infinity, infinity, fmt::format("{}, where it is undefined", value.dump())};
}

Measured measure_number(const TestCase& asked, const Expected& expected,
                        const nlohmann::json& value, const Tolerance& tolerance) {
  if (!value.is_number()) return {none, infinity, infinity, value.dump() + " is no number"};
  const double got = value.get<double>();
  if (!std::isfinite(got)) return {got, infinity, infinity, "not finite"};
  const double error = std::abs((got - expected.high) - expected.low);
  const double limit = allowed_error(asked, expected, tolerance);
  Measured made{got,
                error == 0  ? 0
                : limit > 0 ? error / limit
                            : infinity,
                error == 0           ? 0
                : expected.high != 0 ? error / std::abs(expected.high)
                                     : infinity,
                {},
                Failure::number};
  const bool plays_a_part = tolerance.is_strict || limit > least_of_engineering;
  if (plays_a_part && std::abs(expected.high) >= least_of_engineering)
    made.per_condition = made.relative / std::max(1.0, expected.condition);
  if (made.part_of_bound > 1)
    made.reason = expected.high == 0
                      ? fmt::format("{}, not 0; allowed {:.3g}", got, limit)
                      : fmt::format("{}, not {}; off by {:.3g} of it, allowed {:.3g}", got,
                                    expected.high, made.relative, limit / std::abs(expected.high));
  return made;
}

class Judge {
 public:
  Judge(const std::vector<TestCase>& cases, const Conversation& conversation,
        const Tolerance& tolerance, ConformanceResult& result)
      : cases_(cases), conversation_(conversation), tolerance_(tolerance), result_(result) {
    // A field that no answer of its function has is not offered.
    for (std::size_t i = 0; i < cases.size(); ++i)
      if (conversation.answers[i].outcome == Outcome::answered)
        for (const auto& [field, value] : conversation.answers[i].fields.items())
          offered_.insert(cases[i].function + '.' + field);
  }

  void run() {
    for (std::size_t i = 0; i < cases_.size(); ++i)
      for (std::size_t k = 0; k < cases_[i].expected.size(); ++k) judge(i, k);
    for (QuantityVerdict& one : result_.quantities) {
      const bool has_failed =
          one.failed_physical > 0 || one.held_physical == 0 || tolerance_.is_strict;
      one.status = one.failed > 0 && has_failed ? Verdict::failed
                   : one.failed > 0             ? Verdict::held_physically
                   : one.held == 0              ? Verdict::not_offered
                   : one.skipped > 0            ? Verdict::partly_held
                                                : Verdict::held;
    }
  }

 private:
  QuantityVerdict& quantity(const std::string& name) {
    const auto [place, is_new] = place_.try_emplace(name, result_.quantities.size());
    if (is_new) {
      result_.quantities.emplace_back();
      result_.quantities.back().quantity = name;
    }
    return result_.quantities[place->second];
  }

  void judge(std::size_t i, std::size_t k) {
    const TestCase& asked = cases_[i];
    const Expected& expected = asked.expected[k];
    const Reply& answer = conversation_.answers[i];
    QuantityVerdict& verdict = quantity(quantity_name(asked, expected));
    ++verdict.asked;
    if (answer.outcome == Outcome::skipped) return skip(verdict, answer.reason);
    if (answer.outcome != Outcome::answered)
      return fail(verdict, i, k, without_answer(answer.reason));
    const auto value = answer.fields.find(expected.field);
    if (value == answer.fields.end()) {
      if (!offered_.contains(asked.function + '.' + expected.field))
        return skip(verdict, "the field is never there");
      return fail(verdict, i, k, without_answer("the field is missing"));
    }
    const Measured measured = !expected.word.empty() ? measure_word(expected, *value)
                              : expected.is_undefined
                                  ? measure_undefined(*value)
                                  : measure_number(asked, expected, *value, tolerance_);
    if (measured.part_of_bound > 1) return fail(verdict, i, k, measured);
    ++verdict.held;
    verdict.held_physical += expected.is_physical ? 1 : 0;
    verdict.held_cases.push_back({asked.id, measured.per_condition});
    note_worst(verdict, asked, measured);
  }

  static void skip(QuantityVerdict& verdict, const std::string& reason) {
    if (verdict.skipped++ == 0 && verdict.failed == 0) verdict.first_reason = reason;
  }

  void fail(QuantityVerdict& verdict, std::size_t i, std::size_t k, const Measured& measured) {
    // The first failure is told, but rather one in the physical range.
    const bool is_physical = cases_[i].expected[k].is_physical;
    if (verdict.failed == 0 || (is_physical && verdict.failed_physical == 0))
      verdict.first_reason = fmt::format("{}: {}", cases_[i].id, measured.reason);
    ++verdict.failed;
    verdict.failed_cases.push_back(failed_case(cases_[i], cases_[i].expected[k], measured));
    verdict.failed_physical += is_physical ? 1 : 0;
    note_worst(verdict, cases_[i], measured);
  }

  static FailedCase failed_case(const TestCase& asked, const Expected& expected,
                                const Measured& measured) {
    const double error = expected.high != 0 ? measured.relative : std::abs(measured.got);
    const bool is_beyond = measured.how == Failure::number && !std::isfinite(error);
    return {asked.id, is_beyond ? Failure::wrong : measured.how, error};
  }

  static void note_worst(QuantityVerdict& verdict, const TestCase& asked,
                         const Measured& measured) {
    if (measured.part_of_bound < verdict.worst_part_of_bound ||
        (measured.part_of_bound == verdict.worst_part_of_bound && !verdict.worst_case.empty()))
      return;
    verdict.worst_part_of_bound = measured.part_of_bound;
    verdict.worst_relative = measured.relative;
    verdict.worst_case = asked.id;
  }

  const std::vector<TestCase>& cases_;
  const Conversation& conversation_;
  const Tolerance& tolerance_;
  ConformanceResult& result_;
  std::set<std::string> offered_;
  std::map<std::string, std::size_t> place_;
};

Overall overall_of(const ConformanceResult& result) {
  const auto any = [&](Verdict status) {
    return std::any_of(result.quantities.begin(), result.quantities.end(),
                       [&](const QuantityVerdict& one) { return one.status == status; });
  };
  if (any(Verdict::failed) || result.violation_count > 0) return Overall::failed;
  if (any(Verdict::held_physically)) return Overall::physical;
  if (!any(Verdict::held) && !any(Verdict::partly_held)) return Overall::nothing;
  return any(Verdict::partly_held) || any(Verdict::not_offered) ? Overall::partial
                                                                : Overall::complete;
}

using nlohmann::json;

constexpr std::size_t most_error_lines = 20;

struct ResultName {
  std::string_view name, unit;
};

// The results of a function of the catalogue, or of an operating point.
std::vector<ResultName> results_of(const std::string& function) {
  std::vector<ResultName> results;
  if (const catalogue::Function* const found = catalogue::function_named(function))
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

double allowed_error(const TestCase& asked, const Expected& expected, const Tolerance& tolerance) {
  if (tolerance.is_strict)
    return unit_in_last_place(expected.high) *
           std::max(asked.contract.ulp, asked.contract.ulp_per_condition * expected.condition);
  const auto own = tolerance.quantity.find(quantity_name(asked, expected));
  const double relative = own == tolerance.quantity.end() ? tolerance.relative : own->second;
  return std::max(relative * expected.condition * std::abs(expected.high), least_of_engineering);
}

std::string_view name(Verdict status) {
  constexpr std::array<std::string_view, 5> names{"held", "held in the physical range",
                                                  "held in part", "FAILED", "not offered"};
  return names[static_cast<std::size_t>(status)];
}

std::string_view name(Overall overall) {
  constexpr std::array<std::string_view, 5> names{
      "complete", "partial", "held in the physical range", "failed", "nothing"};
  return names[static_cast<std::size_t>(overall)];
}

Tolerance strict_tolerance() { return {"strict", true, 0, {}}; }
Tolerance engineering_tolerance() { return {"engineering", false, 1e-6, {}}; }

Tolerance read_tolerance(const std::string& path, const std::vector<TestCase>& cases) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(fmt::format("{}: cannot be read", path));
  std::set<std::string> known{"default"};
  for (const TestCase& one : cases)
    for (const Expected& expected : one.expected) known.insert(quantity_name(one, expected));
  Tolerance tolerance = engineering_tolerance();
  tolerance.name = path;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    line.erase(std::min(line.find('#'), line.size()));
    std::istringstream words(line);
    std::string quantity, rest;
    double relative = 0;
    if (!(words >> quantity)) continue;
    if (!known.contains(quantity))
      throw std::runtime_error(fmt::format(
          "{}:{}: {} is no quantity; `default`, or as in the table", path, number, quantity));
    if (!(words >> relative) || words >> rest || !(relative > 0) || !(relative < 1))
      throw std::runtime_error(
          fmt::format("{}:{}: {} needs one number above 0 and below 1", path, number, quantity));
    if (quantity == "default")
      tolerance.relative = relative;
    else
      tolerance.quantity[quantity] = relative;
  }
  return tolerance;
}

std::vector<TestCase> cases_for(std::vector<TestCase> cases, const Tolerance& tolerance) {
  if (!tolerance.is_strict)
    std::erase_if(cases, [](const TestCase& one) { return one.is_extreme; });
  return cases;
}

ConformanceResult judge(std::string subject, const std::vector<TestCase>& cases,
                        const Conversation& conversation, const Tolerance& tolerance) {
  ConformanceResult result;
  result.subject = std::move(subject);
  result.tolerance = tolerance;
  result.violation_count = conversation.violation_count;
  result.violations = conversation.violations;
  result.last_errors = conversation.last_errors;
  result.starts = conversation.starts;
  result.answers_at_end_of_input = conversation.answers_at_end_of_input;
  Judge(cases, conversation, tolerance, result).run();
  result.overall = overall_of(result);
  return result;
}

Example example_of(const TestCase& asked, const Expected& expected, const Reply& answer,
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

std::vector<Example> worst_examples(const ConformanceResult& result,
                                    const std::vector<TestCase>& cases,
                                    const Conversation& conversation, const Tolerance& tolerance,
                                    bool of_all) {
  std::map<std::string, std::size_t> index_of;
  for (std::size_t i = 0; i < cases.size(); ++i) index_of[cases[i].id] = i;
  std::vector<Example> examples;
  for (const QuantityVerdict& one : result.quantities) {
    if (one.failed == 0 && !of_all) continue;
    const auto place = index_of.find(one.worst_case.empty() ? cases.front().id : one.worst_case);
    if (place == index_of.end()) continue;
    const TestCase& asked = cases[place->second];
    for (const Expected& expected : asked.expected) {
      if (quantity_name(asked, expected) != one.quantity) continue;
      examples.push_back(
          example_of(asked, expected, conversation.answers[place->second], tolerance));
      examples.back().part_of_bound = one.worst_part_of_bound;
    }
  }
  return examples;
}

std::vector<std::string> notes_on(const std::vector<TestCase>& cases,
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
    const Reply& answer = conversation.answers[i];
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
      std::any_of(conversation.answers.begin(), conversation.answers.end(), [](const Reply& one) {
        return one.outcome != Outcome::answered && one.outcome != Outcome::skipped;
      });
  const std::size_t kept = std::min(lines.size(), has_failures ? most_error_lines : 1);
  lines.erase(lines.begin(), lines.end() - static_cast<std::ptrdiff_t>(kept));
  return lines;
}

}  // namespace tribo::conformance
