// SPDX-License-Identifier: Apache-2.0
#include "conformance/conformance.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
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

// The judgement on the answer to one quantity of a case. The defaults are the judgement on an
// answer that is no number.
struct Measured {
  std::string reason = {};  // why it fails
  Failure how = Failure::wrong;
  double got = none;
  double part_of_bound = infinity;
  double relative = infinity;
  double per_condition = 0;  // relative error over the condition; 0 if the value is too small
};

Measured measured_if(bool holds, const std::string& reason) {
  return holds ? Measured{.part_of_bound = 0, .relative = 0} : Measured{.reason = reason};
}

Measured measure_number(const TestCase& asked, const Expected& expected,
                        const nlohmann::json& value, const Tolerance& tolerance) {
  if (!value.is_number()) return {.reason = value.dump() + " is no number"};
  Measured made{.how = Failure::number, .got = value.get<double>()};
  if (!std::isfinite(made.got)) return {.reason = "not finite", .got = made.got};
  const double error = std::abs((made.got - expected.high) - expected.low);
  const double limit = allowed_error(asked, expected, tolerance);
  if (error == 0 || limit > 0) made.part_of_bound = error == 0 ? 0 : error / limit;
  if (error == 0 || expected.high != 0)
    made.relative = error == 0 ? 0 : error / std::abs(expected.high);
  const bool plays_a_part = tolerance.is_strict || limit > least_of_engineering;
  if (plays_a_part && std::abs(expected.high) >= least_of_engineering)
    made.per_condition = made.relative / std::max(1.0, expected.condition);
  if (made.part_of_bound > 1)
    made.reason = expected.high == 0
                      ? fmt::format("{}, not 0; allowed {:.3g}", made.got, limit)
                      : fmt::format("{}, not {}; off by {:.3g} of it, allowed {:.3g}", made.got,
                                    expected.high, made.relative, limit / std::abs(expected.high));
  return made;
}

Measured measure(const TestCase& asked, const Expected& expected, const nlohmann::json& value,
                 const Tolerance& tolerance) {
  if (!expected.word.empty())
    return measured_if(value == expected.word,
                       fmt::format("{}, not {}", value.dump(), expected.word));
  return measure_number(asked, expected, value, tolerance);
}

// The subject ended, or was late, when it had to answer this case.
bool is_loss(const Reply& answer) {
  return answer.outcome == Outcome::died || answer.outcome == Outcome::late;
}

// The worse of two answers to a case, field by field. If a case was answered first and is skipped
// when it is asked again, the first answer stands.
Reply worse_of(const TestCase& asked, Reply first, const Reply& second,
               const Tolerance& tolerance) {
  const bool has_answer = second.outcome == Outcome::answered || second.outcome == Outcome::skipped;
  if (is_loss(second) ||
      (first.outcome == Outcome::answered && !has_answer && second.outcome != Outcome::not_asked))
    return {second.outcome, {}, "when it is asked again: " + second.reason};
  if (first.outcome != Outcome::answered || second.outcome != Outcome::answered) return first;
  for (const Expected& expected : asked.expected) {
    const auto one = first.fields.find(expected.field);
    const auto other = second.fields.find(expected.field);
    if (one == first.fields.end()) continue;
    const auto part = [&](const nlohmann::json& value) {
      return measure(asked, expected, value, tolerance).part_of_bound;
    };
    if (other == second.fields.end())
      first.fields.erase(one);
    else if (part(*other) > part(*one))
      *one = *other;
  }
  return first;
}

void take_worse_answers(Conversation& conversation, const std::vector<TestCase>& cases,
                        const Tolerance& tolerance) {
  for (std::size_t i = 0; i < conversation.again.size(); ++i) {
    const std::size_t of = conversation.again[i];
    Reply& answer = conversation.answers[of];
    answer = worse_of(cases[of], std::move(answer), conversation.second_answers[i], tolerance);
  }
}

void mark_unsteady(ConformanceResult& result) {
  for (QuantityVerdict& one : result.quantities)
    for (const Unsteady& changing : result.unsteady) {
      const double change = changing.apart_per_condition;
      if (changing.quantity == one.quantity) one.change_asked_again = change;
      if (function_of(changing.quantity) == function_of(one.quantity))
        one.change_of_function = std::max(one.change_of_function, change);
    }
}

// One quantity of one case.
struct AskedQuantity {
  const TestCase& asked;
  const Expected& expected;
  const Reply& answer;
};

Example example_of(const AskedQuantity& of, const Tolerance& tolerance) {
  Example made{of.asked.id, of.asked.request(),
               of.expected, allowed_error(of.asked, of.expected, tolerance),
               {},          of.answer.reason};
  if (of.answer.outcome != Outcome::answered) return made;
  const auto field = of.answer.fields.find(of.expected.field);
  if (field != of.answer.fields.end())
    made.got = *field;
  else
    made.reason = fmt::format("the answer has no field {}", of.expected.field);
  return made;
}

// The subject ended or was late at this case, or was given up before the case was asked.
bool is_lost(const Reply& answer) {
  return is_loss(answer) || answer.outcome == Outcome::not_asked;
}

// The functions and fields that a subject offers, as all its answers together show.
class Offers {
 public:
  Offers(const std::vector<TestCase>& cases, const std::vector<Reply>& answers) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const std::string& function = cases[i].function;
      if (answers[i].outcome == Outcome::skipped) skipped_.insert(function);
      if (answers[i].outcome != Outcome::answered) continue;
      answered_.insert(function);
      for (const auto& [field, value] : answers[i].fields.items())
        fields_.insert(function + '.' + field);
    }
  }

  // A field is not offered if its function has answers, but none of them has the field. A lost case
  // (is_lost) counts as not offered if its function has skipped cases and no answers.
  bool has(const AskedQuantity& of) const {
    const std::string& function = of.asked.function;
    if (fields_.contains(function + '.' + of.expected.field)) return true;
    if (answered_.contains(function)) return false;
    return !(is_lost(of.answer) && skipped_.contains(function));
  }

 private:
  std::set<std::string> answered_, skipped_;  // functions
  std::set<std::string> fields_;              // "hertz_point.radius"
};

// The judgement on an answer. Empty if the case was skipped or the quantity is not offered; then
// `why_not` gets the reason.
std::optional<Measured> measured(const AskedQuantity& of, const Offers& offers,
                                 const Tolerance& tolerance, std::string& why_not) {
  if (of.answer.outcome == Outcome::skipped) {
    why_not = of.answer.reason;
    return std::nullopt;
  }
  if (!offers.has(of)) {
    why_not = "the field is never there";
    return std::nullopt;
  }
  if (of.answer.outcome != Outcome::answered)
    return Measured{.reason = of.answer.reason, .how = Failure::no_answer};
  const auto value = of.answer.fields.find(of.expected.field);
  if (value != of.answer.fields.end()) return measure(of.asked, of.expected, *value, tolerance);
  return Measured{.reason = "the field is missing", .how = Failure::no_answer};
}

void add(QuantityVerdict& verdict, const AskedQuantity& of, const Offers& offers,
         const Tolerance& tolerance) {
  if (verdict.asked++ == 0) verdict.worst = example_of(of, tolerance);
  std::string why_not;
  const std::optional<Measured> found = measured(of, offers, tolerance, why_not);
  if (!found) {
    if (verdict.skipped++ == 0) {
      verdict.first_skipped = fmt::format("{}: {}", of.asked.id, why_not);
      if (verdict.failed == 0) verdict.first_reason = why_not;
    }
    return;
  }
  const bool is_physical = of.expected.is_physical;
  if (found->part_of_bound > 1) {
    // The reason is that of the first failure in the physical range, or else of the first of all.
    if (verdict.failed == 0 || (is_physical && verdict.failed_physical == 0))
      verdict.first_reason = fmt::format("{}: {}", of.asked.id, found->reason);
    const double error = of.expected.high != 0 ? found->relative : std::abs(found->got);
    const bool is_beyond = found->how == Failure::number && !std::isfinite(error);
    verdict.failed_cases.push_back(
        {of.asked.id, is_beyond ? Failure::wrong : found->how, error, is_lost(of.answer)});
    ++verdict.failed;
    verdict.failed_physical += is_physical ? 1 : 0;
  } else {
    verdict.held_cases.push_back({of.asked.id, found->per_condition});
    ++verdict.held;
    verdict.held_physical += is_physical ? 1 : 0;
  }
  const bool is_lesser = found->part_of_bound <= verdict.worst.part_of_bound;
  if (verdict.judged() > 1 && (is_lesser || (verdict.failed > 1 && is_lost(of.answer)))) return;
  verdict.worst = example_of(of, tolerance);
  verdict.worst.part_of_bound = found->part_of_bound;
  verdict.worst_relative = found->relative;
}

Verdict status_of(const QuantityVerdict& one, const Tolerance& tolerance) {
  const bool has_failed = one.failed_physical > 0 || one.held_physical == 0 || tolerance.is_strict;
  if (one.failed > 0) return has_failed ? Verdict::failed : Verdict::held_physically;
  if (one.held == 0) return Verdict::not_offered;
  return one.skipped > 0 ? Verdict::partly_held : Verdict::held;
}

std::vector<QuantityVerdict> verdicts_on(const std::vector<TestCase>& cases,
                                         const std::vector<Reply>& answers,
                                         const Tolerance& tolerance) {
  const Offers offers(cases, answers);
  std::vector<QuantityVerdict> verdicts;
  std::map<std::string, std::size_t> places;
  // Lost cases are added last, so that another failure, if any, gives the reason and worst case.
  for (const bool lost : {false, true})
    for (std::size_t i = 0; i < cases.size(); ++i)
      for (const Expected& expected : cases[i].expected) {
        const auto [place, is_new] = places.try_emplace(expected.quantity, verdicts.size());
        if (is_new) verdicts.emplace_back().quantity = expected.quantity;
        if (is_lost(answers[i]) == lost)
          add(verdicts[place->second], {cases[i], expected, answers[i]}, offers, tolerance);
      }
  for (QuantityVerdict& one : verdicts) one.status = status_of(one, tolerance);
  return verdicts;
}

// All cases that were given up for the same reason are one loss.
std::vector<Loss> losses_of(const std::vector<TestCase>& cases, const std::vector<Reply>& answers,
                            const Tolerance& tolerance) {
  std::vector<Loss> losses;
  std::set<std::string> given_up;
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (is_loss(answers[i]) ||
        (answers[i].outcome == Outcome::not_asked && given_up.insert(answers[i].reason).second)) {
      const bool is_physical = std::any_of(cases[i].expected.begin(), cases[i].expected.end(),
                                           [](const Expected& one) { return one.is_physical; });
      losses.push_back(
          {cases[i].id, cases[i].function, answers[i].reason, is_physical || tolerance.is_strict});
    }
  return losses;
}

Overall overall_of(const ConformanceResult& result) {
  const auto any = [&](Verdict status) {
    return std::any_of(result.quantities.begin(), result.quantities.end(),
                       [&](const QuantityVerdict& one) { return one.status == status; });
  };
  if (any(Verdict::failed) || result.conversation.violation_count > 0) return Overall::failed;
  // The subject may have ended at a case of a function that it does not offer.
  if (std::any_of(result.losses.begin(), result.losses.end(),
                  [](const Loss& one) { return one.is_physical; }))
    return Overall::failed;
  if (any(Verdict::held_physically)) return Overall::physical;
  if (!any(Verdict::held) && !any(Verdict::partly_held)) return Overall::nothing;
  return any(Verdict::partly_held) || any(Verdict::not_offered) ? Overall::partial
                                                                : Overall::complete;
}

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
    return {};  // the answers merely have more than was asked for
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

bool QuantityVerdict::fails_by_losses_alone() const {
  return failed > 0 && std::all_of(failed_cases.begin(), failed_cases.end(),
                                   [](const FailedCase& one) { return one.is_lost; });
}

std::string function_of(const std::string& quantity) {
  return quantity.substr(0, quantity.find('.'));
}

std::string loss_text(const std::vector<Loss>& losses, const std::vector<std::string>& quantities) {
  const Loss& first = losses.front();
  std::string text = fmt::format("at case {} ({})", first.id, first.function);
  if (losses.size() > 1) text += fmt::format(" and at {} more", losses.size() - 1);
  text += ": " + first.reason;
  if (const Loss& last = losses.back(); last.reason != first.reason)
    text += fmt::format("; at case {}: {}", last.id, last.reason);
  if (!quantities.empty()) text += fmt::format("; lost by this: {}", fmt::join(quantities, ", "));
  return text + fmt::format("; --show {} asks it alone", first.id);
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
  if (!file || std::filesystem::is_directory(text))
    throw std::runtime_error(fmt::format(
        "tolerance: \"{}\" is no file that can be read; allowed: engineering, strict, or "
        "the path of a file with bounds of quantities",
        text));
  std::set<std::string> known = quantity_names(cases), seen;
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
    if (!seen.insert(quantity).second)
      throw std::runtime_error(
          fmt::format("{}:{}: {} has a bound already; give it one line", text, number, quantity));
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
  result.unsteady = unsteady_quantities(cases, conversation);
  take_worse_answers(conversation, cases, tolerance);
  result.conversation = std::move(conversation);
  result.quantities = verdicts_on(cases, result.conversation.answers, tolerance);
  mark_unsteady(result);
  result.losses = losses_of(cases, result.conversation.answers, tolerance);
  result.overall = overall_of(result);
  result.notes = notes_on(cases, result.conversation);
  return result;
}

std::string expected_text(const Expected& expected, double allowed) {
  if (!expected.word.empty()) return expected.word;
  return fmt::format("{}, give or take {:.2g}",
                     with_unit(fmt::format("{}", expected.high), expected.unit), allowed);
}

std::string got_text(const Example& example) {
  if (!example.got) return fmt::format("nothing ({})", example.reason);
  const std::string text = line_of(*example.got);
  return example.got->is_number() ? with_unit(text, example.expected.unit) : start_of(text);
}

std::string error_text(const Example& example) {
  const bool is_number = example.got && example.got->is_number() && example.expected.word.empty();
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
