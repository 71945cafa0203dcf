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

#include "conformance/conversation.hpp"
#include "conformance/question.hpp"
#include "scene/schema.hpp"

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

Example example_of(const TestCase& asked, const Expected& expected, const Reply& answer,
                   const Tolerance& tolerance) {
  Example made{asked.id, asked.request(), expected, allowed_error(asked, expected, tolerance),
               {},       answer.reason};
  if (answer.outcome != Outcome::answered) return made;
  if (const auto field = answer.fields.find(expected.field); field != answer.fields.end())
    made.got = *field;
  else
    made.reason = fmt::format("the answer has no field {}", expected.field);
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
    QuantityVerdict& verdict = quantity(expected.quantity);
    if (verdict.asked++ == 0) verdict.worst = example_of(asked, expected, answer, tolerance_);
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
    note_worst(verdict, i, k, measured);
  }

  static void skip(QuantityVerdict& verdict, const std::string& reason) {
    if (verdict.skipped++ == 0 && verdict.failed == 0) verdict.first_reason = reason;
  }

  void fail(QuantityVerdict& verdict, std::size_t i, std::size_t k, const Measured& measured) {
    // The first failure in the physical range is told, or else the first one of all.
    const bool is_physical = cases_[i].expected[k].is_physical;
    if (verdict.failed == 0 || (is_physical && verdict.failed_physical == 0))
      verdict.first_reason = fmt::format("{}: {}", cases_[i].id, measured.reason);
    ++verdict.failed;
    verdict.failed_cases.push_back(failed_case(cases_[i], cases_[i].expected[k], measured));
    verdict.failed_physical += is_physical ? 1 : 0;
    note_worst(verdict, i, k, measured);
  }

  static FailedCase failed_case(const TestCase& asked, const Expected& expected,
                                const Measured& measured) {
    const double error = expected.high != 0 ? measured.relative : std::abs(measured.got);
    const bool is_beyond = measured.how == Failure::number && !std::isfinite(error);
    return {asked.id, is_beyond ? Failure::wrong : measured.how, error};
  }

  void note_worst(QuantityVerdict& verdict, std::size_t i, std::size_t k,
                  const Measured& measured) {
    if (verdict.judged() > 1 && measured.part_of_bound <= verdict.worst.part_of_bound) return;
    verdict.worst =
        example_of(cases_[i], cases_[i].expected[k], conversation_.answers[i], tolerance_);
    verdict.worst.part_of_bound = measured.part_of_bound;
    verdict.worst_relative = measured.relative;
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
  if (any(Verdict::failed) || result.conversation.violation_count > 0) return Overall::failed;
  if (any(Verdict::held_physically)) return Overall::physical;
  if (!any(Verdict::held) && !any(Verdict::partly_held)) return Overall::nothing;
  return any(Verdict::partly_held) || any(Verdict::not_offered) ? Overall::partial
                                                                : Overall::complete;
}

using nlohmann::json;

std::string with_unit(const std::string& number, std::string_view unit) {
  return unit.empty() ? number : fmt::format("{} {}", number, unit);
}

// A field of an answer that is no result of the function.
struct Stranger {
  std::string function, field;
  const catalogue::Function* in_catalogue;
  auto operator<=>(const Stranger&) const = default;
};

std::string text_of(const Stranger& one, std::size_t count, bool any_known) {
  std::vector<std::string_view> names;
  for (const ResultName& result : results_of(one.in_catalogue)) names.push_back(result.name);
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
    const std::vector<ResultName> results = results_of(cases[i].in_catalogue);
    for (const auto& [field, value] : answer.fields.items()) {
      if (field == "id" || field == "undefined") continue;
      if (std::any_of(results.begin(), results.end(),
                      [&field = field](const ResultName& one) { return one.name == field; }))
        with_known.insert(cases[i].function);
      else
        ++strangers[{cases[i].function, field, cases[i].in_catalogue}];
    }
  }
  for (const auto& [one, count] : strangers) {
    std::string text = text_of(one, count, with_known.contains(one.function));
    if (!text.empty()) notes.push_back(std::move(text));
  }
  return notes;
}

// The name of a function stands for each of its quantities.
bool stands_for(const std::string& wanted, const std::string& quantity) {
  return quantity == wanted || quantity.starts_with(wanted + ".");
}

std::set<std::string> quantity_names(const std::vector<TestCase>& cases) {
  std::set<std::string> quantities;
  for (const TestCase& asked : cases)
    for (const Expected& one : asked.expected) quantities.insert(one.quantity);
  return quantities;
}

}  // namespace

double allowed_error(const TestCase& asked, const Expected& expected, const Tolerance& tolerance) {
  if (tolerance.is_strict)
    return unit_in_last_place(expected.high) *
           std::max(asked.contract.ulp, asked.contract.ulp_per_condition * expected.condition);
  const auto own = tolerance.quantity.find(expected.quantity);
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

Tolerance tolerance_of(const std::string& text, const std::vector<TestCase>& cases) {
  if (text == "strict") return strict_tolerance();
  Tolerance tolerance = engineering_tolerance();
  if (text == tolerance.name) return tolerance;
  tolerance.name = text;
  std::ifstream file(text);
  if (!file) throw std::runtime_error(fmt::format("{}: cannot be read", text));
  std::set<std::string> known = quantity_names(cases);
  known.insert("default");
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    line.erase(std::min(line.find('#'), line.size()));
    std::istringstream words(line);
    std::string quantity, rest;
    double relative = 0;
    if (!(words >> quantity)) continue;
    if (!known.contains(quantity))
      throw std::runtime_error(fmt::format(
          "{}:{}: {} is no quantity; give one of the table or `default`", text, number, quantity));
    if (!(words >> relative) || words >> rest || !(relative > 0) || !(relative < 1))
      throw std::runtime_error(
          fmt::format("{}:{}: {} needs one number above 0 and below 1", text, number, quantity));
    if (quantity == "default")
      tolerance.relative = relative;
    else
      tolerance.quantity[quantity] = relative;
  }
  return tolerance;
}

std::vector<TestCase> cases_for(std::vector<TestCase> cases, const Tolerance& tolerance,
                                std::size_t sample) {
  if (!tolerance.is_strict)
    std::erase_if(cases, [](const TestCase& one) { return one.is_extreme; });
  if (sample == 0) return cases;
  std::map<std::string, std::size_t> count, seen;
  for (const TestCase& one : cases) ++count[one.function];
  std::vector<TestCase> kept;
  for (TestCase& one : cases) {
    const std::size_t i = seen[one.function]++, n = count[one.function];
    // Keeps the first case, and each one at which i·sample/n reaches another whole number.
    if (n <= sample || i == 0 || i * sample / n != (i - 1) * sample / n)
      kept.push_back(std::move(one));
  }
  return kept;
}

ConformanceResult judge(std::string subject, const std::vector<TestCase>& cases,
                        Conversation conversation, const Tolerance& tolerance) {
  ConformanceResult result;
  result.subject = std::move(subject);
  result.tolerance = tolerance;
  result.conversation = std::move(conversation);
  Judge(cases, result.conversation, tolerance, result).run();
  result.overall = overall_of(result);
  result.notes = notes_on(cases, result.conversation);
  return result;
}

std::string expected_text(const Expected& expected, double allowed) {
  if (!expected.word.empty()) return expected.word;
  if (expected.is_undefined) return "null, as it is undefined there";
  return fmt::format("{}, give or take {:.2g}",
                     with_unit(fmt::format("{}", expected.high), expected.unit), allowed);
}

std::string got_text(const Example& example) {
  if (!example.got) return fmt::format("nothing ({})", example.reason);
  const std::string text = example.got->dump(-1, ' ', true, json::error_handler_t::replace);
  return example.got->is_number() ? with_unit(text, example.expected.unit) : start_of(text);
}

std::string error_text(const Example& example) {
  const bool is_number = example.got && example.got->is_number() && example.expected.word.empty() &&
                         !example.expected.is_undefined;
  if (!is_number || !std::isfinite(example.part_of_bound)) return {};
  return example.part_of_bound > 1
             ? fmt::format("{:.3g} times as far off as is allowed", example.part_of_bound)
             : fmt::format("{:.3g} of the error that is allowed", example.part_of_bound);
}

std::optional<std::string> unknown_of(const std::vector<std::string>& required,
                                      const std::vector<TestCase>& cases) {
  const std::set<std::string> known = quantity_names(cases);
  for (const std::string& wanted : required)
    if (std::none_of(known.begin(), known.end(),
                     [&](const std::string& one) { return stands_for(wanted, one); }))
      return wanted;
  return std::nullopt;
}

std::vector<QuantityNote> missing_of(const std::vector<std::string>& required,
                                     const ConformanceResult& result) {
  std::vector<QuantityNote> missing;
  for (const QuantityVerdict& one : result.quantities) {
    const bool is_required =
        std::any_of(required.begin(), required.end(),
                    [&](const std::string& wanted) { return stands_for(wanted, one.quantity); });
    if (is_required && one.status != Verdict::held)
      missing.push_back(
          {one.quantity, fmt::format("required, but {}: {}", name(one.status), one.quantity)});
  }
  return missing;
}

}  // namespace tribo::conformance
