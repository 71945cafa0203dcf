// SPDX-License-Identifier: Apache-2.0
#include "conformance/conformance_baseline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <stdexcept>

#include "protocol/bounded_json.hpp"

namespace tribo::conformance {
namespace {

using nlohmann::json;

constexpr double ratchet = 4;
constexpr int schema = 2;

// The rank of a status; `failed` has the lowest.
int worth(const std::string& status) {
  for (int i = 0; i < 5; ++i)
    if (name(std::array{Verdict::failed, Verdict::not_offered, Verdict::held_physically,
                        Verdict::partly_held, Verdict::held}[static_cast<std::size_t>(i)]) ==
        status)
      return i;
  throw std::runtime_error(fmt::format("{} is no status", status));
}

bool is_beyond_ratchet(double now, double before) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  return now > ratchet * std::max(epsilon, before);
}

// --- One case that failed.

constexpr const char* wrong_text = "wrong";
constexpr const char* no_answer_text = "no answer";

json json_of(const FailedCase& one) {
  if (one.how == Failure::number) return one.error;
  return one.how == Failure::wrong ? wrong_text : no_answer_text;
}
FailedCase failed_case(const std::string& id, const json& written) {
  if (written.is_number()) return {id, Failure::number, written.get<double>()};
  if (written == wrong_text) return {id, Failure::wrong, 0};
  if (written == no_answer_text) return {id, Failure::no_answer, 0};
  throw std::runtime_error(fmt::format("{} is no error of a case that failed", written.dump()));
}
std::string text_of(const FailedCase& one) {
  if (one.how == Failure::number) return fmt::format("off by {:.3g}", one.error);
  return one.how == Failure::wrong ? wrong_text : "without an answer";
}
bool is_worse(const FailedCase& now, const FailedCase& before) {
  if (now.how != before.how) return now.how > before.how;
  return now.how == Failure::number && is_beyond_ratchet(now.error, before.error);
}
bool is_lesser(const FailedCase& one, const FailedCase& other) {
  return one.how != other.how ? one.how < other.how : one.error < other.error;
}

// --- One quantity.

// The worst of the held cases for which is_meant(id) is true.
template <class Which>
HeldCase worst_of(const QuantityVerdict& now, Which&& is_meant) {
  HeldCase worst{{}, 0};
  for (const HeldCase& one : now.held_cases)
    if (one.error > worst.error && is_meant(one.id)) worst = one;
  return worst;
}

// The worst of the cases that held before, too; nothing where that is not known, as some were
// skipped then.
std::optional<HeldCase> worst_of_old(const QuantityVerdict& now, const json& before) {
  const json& failed = before.at("failed");
  std::size_t old = 0;
  for (const HeldCase& one : now.held_cases) old += failed.contains(one.id) ? 0 : 1;
  if (old > before.at("held").get<std::size_t>()) return std::nullopt;
  return worst_of(now, [&](const std::string& id) { return !failed.contains(id); });
}

json row_of(const QuantityVerdict& one) {
  json failed = json::object();
  for (const FailedCase& fault : one.failed_cases) failed[fault.id] = json_of(fault);
  const HeldCase worst = worst_of(one, [](const std::string&) { return true; });
  return {{"status", name(one.status)}, {"asked", one.asked},         {"held", one.held},
          {"skipped", one.skipped},     {"worst_error", worst.error}, {"failed", failed}};
}

// The row of a quantity that became better. Numbers of it that became worse meanwhile, but not by
// so much as to be red, stay as they were, so that a baseline does not get worse step by step.
json merged_row(const QuantityVerdict& now, const json& before) {
  json row = row_of(now);
  for (const FailedCase& one : now.failed_cases)
    if (const auto old = before.at("failed").find(one.id); old != before.at("failed").end())
      if (is_lesser(failed_case(one.id, *old), one)) row["failed"][one.id] = *old;
  if (const std::optional<HeldCase> old = worst_of_old(now, before)) {
    const HeldCase fresh =
        worst_of(now, [&](const std::string& id) { return before.at("failed").contains(id); });
    row["worst_error"] =
        std::max(fresh.error, std::min(old->error, before.at("worst_error").get<double>()));
  }
  return row;
}

std::string cases_text(std::size_t count) {
  return fmt::format("{} {}", count, count == 1 ? "case" : "cases");
}

// "2 cases fail that did not before, the first is f0012 (off by 0.0066)"; empty where none is.
std::string worse_cases(const QuantityVerdict& now, const json& failed_before) {
  std::size_t fresh = 0, grown = 0;
  std::string first_fresh, first_grown;
  for (const FailedCase& one : now.failed_cases) {
    const auto before = failed_before.find(one.id);
    if (before == failed_before.end()) {
      if (fresh++ == 0) first_fresh = fmt::format("{} ({})", one.id, text_of(one));
    } else if (const FailedCase old = failed_case(one.id, *before); is_worse(one, old)) {
      if (grown++ == 0)
        first_grown = fmt::format("{}, which was {}, is {}", one.id, text_of(old), text_of(one));
    }
  }
  std::string text;
  if (fresh > 0)
    text = fmt::format("{} failed that did not before; the first is {}", cases_text(fresh),
                       first_fresh);
  if (grown > 0)
    text += fmt::format("{}{} failed before and {} worse by more than {} times; the first is {}",
                        text.empty() ? "" : "; ", cases_text(grown), grown == 1 ? "is" : "are",
                        ratchet, first_grown);
  return text;
}

std::size_t better_cases(const QuantityVerdict& now, const json& failed_before) {
  std::size_t count = failed_before.size();
  for (const FailedCase& one : now.failed_cases)
    if (const auto before = failed_before.find(one.id); before != failed_before.end())
      count -= is_worse(failed_case(one.id, *before), one) ? 0 : 1;
  return count;
}

std::string what_is_worse(const QuantityVerdict& now, const json& before) {
  const std::string was(before.at("status").get<std::string>()), is(name(now.status));
  std::string cases = worse_cases(now, before.at("failed"));
  if (worth(is) < worth(was))
    return fmt::format("was {}, is {}{}", was, is,
                       now.first_reason.empty() ? "" : " (" + now.first_reason + ")");
  if (!cases.empty()) return cases;
  const auto held = before.at("held").get<std::size_t>();
  if (now.held < held) return fmt::format("{} held, {} hold", cases_text(held), now.held);
  const double error = before.at("worst_error").get<double>();
  const std::optional<HeldCase> worst = worst_of_old(now, before);
  if (worst && is_beyond_ratchet(worst->error, error))
    return fmt::format("the worst error was {:.3g}, is {:.3g} (case {}); more than {} times", error,
                       worst->error, worst->id, ratchet);
  return {};
}

std::string what_is_better(const QuantityVerdict& now, const json& before) {
  const std::string was(before.at("status").get<std::string>()), is(name(now.status));
  if (worth(is) > worth(was)) return fmt::format("was {}, is {}", was, is);
  const auto held = before.at("held").get<std::size_t>();
  if (now.held > held) return fmt::format("{} held, {} hold", cases_text(held), now.held);
  if (const std::size_t count = better_cases(now, before.at("failed")); count > 0)
    return fmt::format("{} that failed {} better", cases_text(count), count == 1 ? "is" : "are");
  const double error = before.at("worst_error").get<double>();
  const std::optional<HeldCase> worst = worst_of_old(now, before);
  if (worst && is_beyond_ratchet(error, worst->error))
    return fmt::format("the worst error was {:.3g}, is {:.3g}", error, worst->error);
  return {};
}

// --- The whole file.

json tolerance_json(const Tolerance& tolerance) {
  if (tolerance.is_strict) return tolerance.name;
  json content{{"default", tolerance.relative}};
  for (const auto& [quantity, relative] : tolerance.quantity)
    if (relative != tolerance.relative) content[quantity] = relative;
  return content;
}

const json& quantities_of(const json& baseline) {
  if (!baseline.is_object() || !baseline.contains("quantities") || !baseline.contains("schema"))
    throw std::runtime_error("it is no baseline of `tribocheck verify`");
  if (baseline.at("schema") != schema)
    throw std::runtime_error(fmt::format("it is a baseline of schema {}, and this program has {}",
                                         baseline.at("schema").dump(), schema));
  return baseline.at("quantities");
}

std::invalid_argument no_baseline(const BaselineUse& use, const std::exception& error) {
  return std::invalid_argument(
      fmt::format("{}: {}; this makes it anew: {}", use.file, error.what(), use.renewal));
}

}  // namespace

json baseline_of(const ConformanceResult& result, const json& before) {
  json rows = before.is_null() ? json::object() : quantities_of(before);
  for (const QuantityVerdict& one : result.quantities)
    if (!rows.contains(one.quantity))
      rows[one.quantity] = row_of(one);
    else if (const json& row = rows.at(one.quantity);
             what_is_worse(one, row).empty() && !what_is_better(one, row).empty())
      rows[one.quantity] = merged_row(one, row);
  return {{"schema", schema},
          {"tolerance", tolerance_json(result.tolerance)},
          {"sample", result.sample == 0 ? json("all") : json(result.sample)},
          {"subject", result.subject},
          {"quantities", std::move(rows)}};
}

void check_comparable(const json& baseline, const Tolerance& tolerance, std::size_t sample) {
  quantities_of(baseline);
  const auto check = [&](const char* what, const json& now) {
    const json before = baseline.value(what, json());
    if (before != now)
      throw std::runtime_error(fmt::format("it was made with the {} {}, and this is {}", what,
                                           before.dump(), now.dump()));
  };
  check("tolerance", tolerance_json(tolerance));
  check("sample", sample == 0 ? json("all") : json(sample));
}

BaselineChanges compare(const ConformanceResult& result, const json& baseline) {
  check_comparable(baseline, result.tolerance, result.sample);
  BaselineChanges changes;
  const json& rows = quantities_of(baseline);
  const auto note = [](std::vector<QuantityNote>& to, const std::string& quantity,
                       const std::string& text) {
    if (!text.empty()) to.push_back({quantity, fmt::format("{}: {}", quantity, text)});
  };
  bool any_compared = false, any_offered = false;
  for (const QuantityVerdict& one : result.quantities) {
    any_offered |= one.judged() > 0;
    const bool has_failed = one.status == Verdict::failed;
    if (!rows.contains(one.quantity)) {
      note(has_failed ? changes.worse : changes.better, one.quantity,
           has_failed ? "is new, and fails" : fmt::format("is new, {}", name(one.status)));
      continue;
    }
    const json& before = rows.at(one.quantity);
    any_compared |= before.at("held").get<std::size_t>() > 0 || !before.at("failed").empty();
    const std::string worse = what_is_worse(one, before);
    note(changes.worse, one.quantity, worse);
    if (!worse.empty()) continue;
    note(changes.better, one.quantity, what_is_better(one, before));
    if (has_failed) changes.failed_already.push_back(one.quantity);
  }
  for (const auto& row : rows.items())
    if (std::none_of(result.quantities.begin(), result.quantities.end(),
                     [&](const QuantityVerdict& one) { return one.quantity == row.key(); }))
      note(changes.worse, row.key(), "is no longer asked");
  if (const Conversation& talk = result.conversation; talk.violation_count > 0)
    changes.worse.push_back(
        {"protocol", fmt::format("the protocol was broken {} times{}", talk.violation_count,
                                 talk.violations.empty() ? "" : ": " + talk.violations.front())});
  if (!any_offered)
    changes.worse.push_back({"anything", "no quantity is offered, so that nothing is tested"});
  else if (!any_compared)
    changes.worse.push_back(
        {"anything", "the baseline has no answers, so that nothing is compared with it"});
  return changes;
}

json usable_baseline(const BaselineUse& use, const std::function<void(const json&)>& check) {
  if (use.file.empty()) return nullptr;
  json content;
  try {
    if (std::filesystem::exists(use.file)) {
      std::ifstream file(use.file);
      content = protocol::read_bounded_json(file);
      if (content.is_discarded()) throw std::runtime_error("it is no JSON");
      if (!content.is_null()) check(content);
    }
  } catch (const std::runtime_error& error) {
    if (use.force) return nullptr;
    throw no_baseline(use, error);
  }
  if (content.is_null() && !use.update)
    throw std::invalid_argument(
        fmt::format("{}: there is no such baseline; --update-baseline writes it", use.file));
  return content;
}

std::optional<BaselineChanges> changes_since(const json& before, const BaselineUse& use,
                                             const ConformanceResult& result) {
  if (before.is_null()) return std::nullopt;
  try {
    return compare(result, before);
  } catch (const std::exception& error) {
    if (!use.force) throw no_baseline(use, error);
    return std::nullopt;
  }
}

}  // namespace tribo::conformance
