// SPDX-License-Identifier: Apache-2.0
#include "conformance/conformance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>

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

Measured measure_number(const Case& asked, const Expected& expected, const nlohmann::json& value,
                        const Tolerance& tolerance) {
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
  Judge(const std::vector<Case>& cases, const Conversation& conversation,
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
      one.status = one.failed > 0 && has_failed ? Status::failed
                   : one.failed > 0             ? Status::held_physically
                   : one.held == 0              ? Status::not_offered
                   : one.skipped > 0            ? Status::partly_held
                                                : Status::held;
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
    const Case& asked = cases_[i];
    const Expected& expected = asked.expected[k];
    const Answer& answer = conversation_.answers[i];
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
    result_.judged.push_back({i, k, measured.got, measured.part_of_bound});
  }

  static FailedCase failed_case(const Case& asked, const Expected& expected,
                                const Measured& measured) {
    const double error = expected.high != 0 ? measured.relative : std::abs(measured.got);
    const bool is_beyond = measured.how == Failure::number && !std::isfinite(error);
    return {asked.id, is_beyond ? Failure::wrong : measured.how, error};
  }

  static void note_worst(QuantityVerdict& verdict, const Case& asked, const Measured& measured) {
    if (measured.part_of_bound < verdict.worst_part_of_bound ||
        (measured.part_of_bound == verdict.worst_part_of_bound && !verdict.worst_case.empty()))
      return;
    verdict.worst_part_of_bound = measured.part_of_bound;
    verdict.worst_relative = measured.relative;
    verdict.worst_case = asked.id;
  }

  const std::vector<Case>& cases_;
  const Conversation& conversation_;
  const Tolerance& tolerance_;
  ConformanceResult& result_;
  std::set<std::string> offered_;
  std::map<std::string, std::size_t> place_;
};

Overall overall_of(const ConformanceResult& result) {
  const auto any = [&](Status status) {
    return std::any_of(result.quantities.begin(), result.quantities.end(),
                       [&](const QuantityVerdict& one) { return one.status == status; });
  };
  if (any(Status::failed) || result.violation_count > 0) return Overall::failed;
  if (any(Status::held_physically)) return Overall::physical;
  if (!any(Status::held) && !any(Status::partly_held)) return Overall::nothing;
  return any(Status::partly_held) || any(Status::not_offered) ? Overall::partial
                                                              : Overall::complete;
}

}  // namespace

double allowed_error(const Case& asked, const Expected& expected, const Tolerance& tolerance) {
  if (tolerance.is_strict)
    return unit_in_last_place(expected.high) *
           std::max(asked.contract.ulp, asked.contract.ulp_per_condition * expected.condition);
  const auto own = tolerance.quantity.find(quantity_name(asked, expected));
  const double relative = own == tolerance.quantity.end() ? tolerance.relative : own->second;
  return std::max(relative * expected.condition * std::abs(expected.high), least_of_engineering);
}

std::string_view name(Status status) {
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

Tolerance read_tolerance(const std::string& path, const std::vector<Case>& cases) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(fmt::format("{}: cannot be read", path));
  std::set<std::string> known{"default"};
  for (const Case& one : cases)
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

std::vector<Case> cases_for(std::vector<Case> cases, const Tolerance& tolerance) {
  if (!tolerance.is_strict) std::erase_if(cases, [](const Case& one) { return one.is_extreme; });
  return cases;
}

ConformanceResult judge(std::string subject, const std::vector<Case>& cases,
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

}  // namespace tribo::conformance
