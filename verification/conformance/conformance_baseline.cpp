// SPDX-License-Identifier: Apache-2.0
#include "conformance/conformance_baseline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>

#include "protocol/bounded_json.hpp"
#include "tribo/scene_reader.hpp"
#include "tribo/version.hpp"

namespace tribo::conformance {
namespace {

using nlohmann::json;

constexpr double ratchet = 4;
constexpr int oldest_schema = 2, schema = 3;
constexpr std::size_t longest_quoted = 60;  // of a line of a file
constexpr std::string_view schema_name = "verify-baseline/";

// The rank of a status; `failed` has the lowest.
int worth(const std::string& status) {
  for (int i = 0; i < 5; ++i)
    if (name(std::array{Verdict::failed, Verdict::not_offered, Verdict::held_physically,
                        Verdict::partly_held, Verdict::held}[static_cast<std::size_t>(i)]) ==
        status)
      return i;
  throw std::runtime_error(fmt::format("{} is no status", status));
}

// A right formula with its operations in another order may have this rounding error.
constexpr double least_error = 4 * std::numeric_limits<double>::epsilon();

bool is_beyond_ratchet(double now, double before) { return now > greatest_as_before(before); }

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

// The number of cases that hold and did not fail before.
std::size_t held_without_mended(const QuantityVerdict& now, const json& before) {
  const json& failed = before.at("failed");
  return static_cast<std::size_t>(
      std::count_if(now.held_cases.begin(), now.held_cases.end(),
                    [&](const HeldCase& one) { return !failed.contains(one.id); }));
}

// The worst of the cases that held before, too. If more cases hold now, some of them were skipped
// before. The file does not name these, so the result is empty.
std::optional<HeldCase> worst_of_old(const QuantityVerdict& now, const json& before) {
  const json& failed = before.at("failed");
  if (held_without_mended(now, before) > before.at("held").get<std::size_t>()) return std::nullopt;
  return worst_of(now, [&](const std::string& id) { return !failed.contains(id); });
}

// Answers may change when they are asked again at another place of an array, where the compiler
// takes other instructions. That is rounding, and no loss.
bool is_more_than_rounding(double change) { return is_beyond_ratchet(change, 0); }

// Whether answers of the function change when they are asked again. The member is in the rows of
// all quantities of the function, because any of them may change next time. A function without the
// member is steady.
bool is_unsteady(const json& row) { return row.value("unsteady", false); }
void put_unsteady(json& row, bool is_so) {
  if (is_so)
    row["unsteady"] = true;
  else
    row.erase("unsteady");
}

json row_of(const QuantityVerdict& one) {
  json failed = json::object();
  for (const FailedCase& fault : one.failed_cases) failed[fault.id] = json_of(fault);
  const HeldCase worst = worst_of(one, [](const std::string&) { return true; });
  json row{{"status", name(one.status)}, {"asked", one.asked},         {"held", one.held},
           {"skipped", one.skipped},     {"worst_error", worst.error}, {"failed", failed}};
  put_unsteady(row, is_more_than_rounding(one.change_of_function));
  return row;
}

// The row of a quantity that became better. Its numbers that became worse, but within the ratchet,
// stay as they were, so that a baseline does not get worse step by step.
json merged_row(const QuantityVerdict& now, const json& before) {
  json row = row_of(now);
  put_unsteady(row, is_unsteady(before));  // one run in which it is steady proves nothing
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

// How a quantity differs from its row of the baseline; the text is empty if it does not.
struct Difference {
  std::string text = {};
  std::string fact = {};
  json before = {}, after = {};
  std::vector<CaseChange> cases = {};
};

// "2 cases failed that did not before; the first is f0012 (off by 0.0066)".
Difference worse_cases(const QuantityVerdict& now, const json& failed_before) {
  Difference found;
  std::size_t fresh = 0, grown = 0;
  std::string first_fresh, first_grown;
  for (const FailedCase& one : now.failed_cases) {
    const auto before = failed_before.find(one.id);
    if (before == failed_before.end()) {
      if (fresh++ == 0) first_fresh = fmt::format("{} ({})", one.id, text_of(one));
      found.cases.push_back({one.id, nullptr, json_of(one)});
    } else if (const FailedCase old = failed_case(one.id, *before); is_worse(one, old)) {
      if (grown++ == 0)
        first_grown = fmt::format("{}, which was {}, is {}", one.id, text_of(old), text_of(one));
      found.cases.push_back({one.id, *before, json_of(one)});
    }
  }
  if (fresh > 0)
    found.text = fmt::format("{} failed that did not before; the first is {}", cases_text(fresh),
                             first_fresh);
  if (grown > 0)
    found.text +=
        fmt::format("{}{} failed before and {} worse by more than {} times; the first is {}",
                    found.text.empty() ? "" : "; ", cases_text(grown), grown == 1 ? "is" : "are",
                    ratchet, first_grown);
  return found;
}

Difference better_cases(const QuantityVerdict& now, const json& failed_before) {
  std::map<std::string_view, const FailedCase*> failing;
  for (const FailedCase& one : now.failed_cases) failing[one.id] = &one;
  Difference found;
  for (const auto& [id, before] : failed_before.items()) {
    const auto one = failing.find(id);
    if (one == failing.end())
      found.cases.push_back({id, before, nullptr});
    else if (is_worse(failed_case(id, before), *one->second))
      found.cases.push_back({id, before, json_of(*one->second)});
  }
  if (const std::size_t count = found.cases.size(); count > 0)
    found.text =
        fmt::format("{} that failed {} better", cases_text(count), count == 1 ? "is" : "are");
  return found;
}

// "; the first case without an answer is h0012: no root"; empty if no more cases are skipped than
// before. The file does not name the cases that were skipped then.
std::string lost_answers(const QuantityVerdict& now, const json& before) {
  const auto skipped = before.at("skipped").get<std::size_t>();
  if (now.skipped <= skipped) return {};
  const std::string then = skipped == 0 ? ""
                                        : fmt::format("{} had no answer, {} have none; ",
                                                      cases_text(skipped), now.skipped);
  return fmt::format("; {}the first case without an answer is {}", then, now.first_skipped);
}

Difference what_is_worse(const QuantityVerdict& now, const json& before) {
  const std::string was(before.at("status").get<std::string>()), is(name(now.status));
  Difference cases = worse_cases(now, before.at("failed"));
  if (worth(is) < worth(was)) {
    const std::string reason = now.failed == 0            ? lost_answers(now, before)
                               : now.first_reason.empty() ? ""
                                                          : " (" + now.first_reason + ")";
    return {fmt::format("was {}, is {}{}", was, is, reason), "status", was, is,
            std::move(cases.cases)};
  }
  if (!cases.text.empty()) return cases;
  // A case that failed and now holds does not make up for one that held and is lost.
  const auto held = before.at("held").get<std::size_t>();
  if (const std::size_t still = held_without_mended(now, before); still < held)
    return {fmt::format("{} held, {} hold{}", cases_text(held), still, lost_answers(now, before)),
            "held", held, still};
  const double error = before.at("worst_error").get<double>();
  const std::optional<HeldCase> worst = worst_of_old(now, before);
  if (worst && is_beyond_ratchet(worst->error, error))
    return {fmt::format("the worst error was {:.3g}, is {:.3g} (case {}); more than {} times",
                        error, worst->error, worst->id, ratchet),
            "worst_error", error, worst->error};
  if (is_more_than_rounding(now.change_asked_again) && !is_unsteady(before))
    return {"its answers were the same each time, and change now when they are asked again"};
  return {};
}

Difference what_is_better(const QuantityVerdict& now, const json& before) {
  const std::string was(before.at("status").get<std::string>()), is(name(now.status));
  Difference cases = better_cases(now, before.at("failed"));
  if (worth(is) > worth(was))
    return {fmt::format("was {}, is {}", was, is), "status", was, is, std::move(cases.cases)};
  const auto held = before.at("held").get<std::size_t>();
  if (now.held > held)
    return {fmt::format("{} held, {} hold", cases_text(held), now.held), "held", held, now.held,
            std::move(cases.cases)};
  if (!cases.text.empty()) return cases;
  const double error = before.at("worst_error").get<double>();
  const std::optional<HeldCase> worst = worst_of_old(now, before);
  if (worst && is_beyond_ratchet(error, worst->error))
    return {fmt::format("the worst error was {:.3g}, is {:.3g}", error, worst->error),
            "worst_error", error, worst->error};
  return {};
}

// --- Cases that the subject's end or silence has cost.

// The quantity as if the lost cases that did not fail before had held.
QuantityVerdict without_losses(const QuantityVerdict& now, const json& before) {
  QuantityVerdict mended = now;
  mended.change_asked_again = 0;  // the loss may be the change
  mended.failed_cases.clear();
  bool is_as_before = true;  // all other failures are old ones
  for (const FailedCase& one : now.failed_cases) {
    const bool failed_before = before.at("failed").contains(one.id);
    if (one.is_lost && !failed_before) {
      mended.held_cases.push_back({one.id, 0});
      continue;
    }
    mended.failed_cases.push_back(one);
    is_as_before &= failed_before;
  }
  mended.held = mended.held_cases.size();
  mended.failed = mended.failed_cases.size();
  for (const Verdict status : {Verdict::held, Verdict::held_physically, Verdict::partly_held,
                               Verdict::failed, Verdict::not_offered})
    if (is_as_before && name(status) == before.at("status").get<std::string>() &&
        worth(std::string(name(status))) > worth(std::string(name(now.status))))
      mended.status = status;
  return mended;
}

bool was_lost(const Loss& loss, const json& baseline) {
  const json losses = baseline.value("losses", json::array());
  if (std::find(losses.begin(), losses.end(), loss.id) != losses.end()) return true;
  const json& rows = baseline.at("quantities");
  return std::any_of(rows.begin(), rows.end(), [&](const json& row) {
    return row.at("failed").value(loss.id, json()) == no_answer_text;
  });
}

std::vector<Loss> new_losses(const ConformanceResult& result, const json& baseline) {
  std::vector<Loss> found;
  for (const Loss& one : result.losses)
    if (!was_lost(one, baseline)) found.push_back(one);
  return found;
}

// The cases at which the subject ended or was late then, but not now.
std::vector<std::string> mended_losses(const ConformanceResult& result, const json& baseline) {
  std::vector<std::string> found;
  for (const json& id : baseline.value("losses", json::array()))
    if (std::none_of(result.losses.begin(), result.losses.end(),
                     [&](const Loss& one) { return one.id == id; }))
      found.push_back(id.get<std::string>());
  return found;
}

// --- The whole file.

json tolerance_json(const Tolerance& tolerance) {
  if (tolerance.is_strict) return tolerance.name;
  json content{{"default", tolerance.relative}};
  for (const auto& [quantity, relative] : tolerance.quantity)
    if (relative != tolerance.relative) content[quantity] = relative;
  return content;
}

// The number 3 of "verify-baseline/3". Schema 2 was written as the number alone.
json schema_of(const json& baseline) {
  const json& written = baseline.at("schema");
  if (!written.is_string()) return written;
  const std::string text = written.get<std::string>();
  if (!text.starts_with(schema_name))
    throw std::runtime_error("it is no baseline of `tribocheck verify`");
  const json number = json::parse(text.substr(schema_name.size()), nullptr, false);
  return number.is_number_integer() ? number : written;
}

// Whether 0.10.1 is newer than 0.9.0. Other texts are no versions, and not newer.
bool is_newer(const std::string& one, const std::string& other) {
  const auto numbers_of = [](const std::string& text) {
    std::array<int, 3> numbers{-1, -1, -1};
    std::sscanf(text.c_str(), "%d.%d.%d", &numbers[0], &numbers[1], &numbers[2]);
    return numbers;
  };
  return numbers_of(one) > numbers_of(other);
}

std::string version_of(const json& baseline) {
  const auto written = baseline.find("version");
  return written != baseline.end() && written->is_string() ? written->get<std::string>() : "";
}

const json& quantities_of(const json& baseline) {
  if (!baseline.is_object() || !baseline.contains("quantities") || !baseline.contains("schema"))
    throw std::runtime_error("it is no baseline of `tribocheck verify`");
  if (const json number = schema_of(baseline); number != schema && number != oldest_schema)
    throw std::runtime_error(other_schema_text(baseline, number, schema));
  return baseline.at("quantities");
}

// The rows of the baseline. Files of the oldest schema do not tell which functions are steady:
// their rows count as unsteady.
json rows_of(const json& baseline) {
  json rows = quantities_of(baseline);
  if (schema_of(baseline) == oldest_schema)
    for (json& row : rows) put_unsteady(row, true);
  return rows;
}

bool is_asked(const std::string& quantity, const ConformanceResult& result) {
  return std::any_of(result.quantities.begin(), result.quantities.end(),
                     [&](const QuantityVerdict& one) { return one.quantity == quantity; });
}

// Another version of this program may ask for other quantities. Files of the oldest schema have no
// version.
bool is_of_version(const json& baseline) { return version_of(baseline) == version; }
bool is_of_other_version(const json& baseline) {
  return baseline.contains("version") && !is_of_version(baseline);
}

// Why a text is no JSON, and in which line: "it is broken at line 7, and no JSON: …".
std::string broken_text(const std::string& text) {
  std::size_t number = 1;
  for (std::size_t at = 0; at < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = std::string_view(text).substr(at, end - at);
    for (const std::string_view mark : {"<<<<<<<", "|||||||", "=======", ">>>>>>>"})
      if (line.starts_with(mark))
        return fmt::format(
            "it is broken at line {}, and no JSON: `{}` is a mark of a merge conflict", number,
            printable(line, longest_quoted));
    at = end + 1;
  }
  std::size_t at = text.size();
  try {
    [[maybe_unused]] const json whole = json::parse(text);
  } catch (const json::parse_error& error) {
    at = std::min(text.size(), error.byte - std::min<std::size_t>(error.byte, 1));
  } catch (const json::exception&) {
    at = 0;
  }
  const bool ends = text.find_first_not_of(" \t\r\n", at) == std::string::npos;
  if (ends) at = text.find_last_not_of(" \t\r\n") + 1;
  const auto before = text.begin() + static_cast<std::ptrdiff_t>(at);
  const std::size_t start = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
  const std::size_t stop = std::min(text.find('\n', at), text.size());
  return fmt::format("it is broken at line {}, and no JSON: {} `{}`",
                     1 + std::count(text.begin(), before, '\n'),
                     ends ? "it ends too early, after" : "the line is",
                     printable(std::string_view(text).substr(start, stop - start), longest_quoted));
}

// The file is no JSON. A user who has committed it can restore it.
struct Broken : std::runtime_error {
  using std::runtime_error::runtime_error;
};

std::invalid_argument broken_baseline(const BaselineUse& use, const Broken& error) {
  return std::invalid_argument(
      fmt::format("{}: {}; restore it, for example by {}, or write it anew: {}", use.file,
                  error.what(), use.restoration, use.renewal));
}

std::invalid_argument no_baseline(const BaselineUse& use, const std::exception& error) {
  return std::invalid_argument(
      fmt::format("{}: {}; this makes it anew: {}", use.file, error.what(), use.renewal));
}

}  // namespace

double greatest_as_before(double error) { return ratchet * std::max(least_error, error); }

json baseline_of(const ConformanceResult& result, const json& before) {
  json rows = before.is_null() ? json::object() : rows_of(before);
  for (const QuantityVerdict& one : result.quantities) {
    const bool is_new = !rows.contains(one.quantity);
    if (before.is_null() || (is_new && one.status != Verdict::failed && !is_of_version(before)))
      rows[one.quantity] = row_of(one);
    else if (is_new)
      continue;
    else if (const json& row = rows.at(one.quantity);
             what_is_worse(one, row).text.empty() && !what_is_better(one, row).text.empty())
      rows[one.quantity] = merged_row(one, row);
    if (!before.is_null() && schema_of(before) == oldest_schema)
      put_unsteady(rows.at(one.quantity), is_more_than_rounding(one.change_of_function));
  }
  if (!before.is_null() && is_of_other_version(before))
    for (auto row = rows.begin(); row != rows.end();)
      row = is_asked(row.key(), result) ? std::next(row) : rows.erase(row);
  json losses = json::array();
  for (const Loss& one : result.losses)
    if (before.is_null() || was_lost(one, before)) losses.push_back(one.id);
  return {{"schema", fmt::format("{}{}", schema_name, schema)},
          {"version", version},
          {"subject", result.subject},
          {"tolerance", tolerance_json(result.tolerance)},
          {"sample", result.sample == 0 ? json("all") : json(result.sample)},
          {"losses", std::move(losses)},
          {"quantities", std::move(rows)}};
}

bool hold_the_same(const json& one, const json& other) {
  return one.at("tolerance") == other.at("tolerance") && one.at("sample") == other.at("sample") &&
         one.at("quantities") == other.at("quantities") &&
         one.value("losses", json::array()) == other.value("losses", json::array());
}

std::string baseline_text(const json& baseline, std::string_view commit, const std::string& date) {
  using nlohmann::ordered_json;
  ordered_json file;
  const auto copy = [&](ordered_json& to, const json& from,
                        std::initializer_list<const char*> members) {
    for (const char* member : members) to[member] = ordered_json(from.at(member));
  };
  copy(file, baseline, {"schema", "version"});
  file["commit"] = commit;
  file["date"] = date;
  copy(file, baseline, {"subject", "tolerance", "sample", "losses"});
  ordered_json& rows = file["quantities"] = ordered_json::object();
  for (const auto& [quantity, row] : baseline.at("quantities").items()) {
    copy(rows[quantity], row, {"status", "asked", "held", "skipped", "worst_error"});
    if (is_unsteady(row)) copy(rows[quantity], row, {"unsteady"});
    copy(rows[quantity], row, {"failed"});
  }
  return file.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
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
  const json rows = rows_of(baseline);
  const auto note = [](std::vector<BaselineChange>& to, const std::string& quantity,
                       Difference&& found) {
    if (!found.text.empty())
      to.push_back({quantity, fmt::format("{}: {}", quantity, found.text), std::move(found.fact),
                    std::move(found.before), std::move(found.after), std::move(found.cases)});
  };
  const std::vector<Loss> losses = new_losses(result, baseline);
  bool any_compared = false, any_offered = false;
  for (const QuantityVerdict& one : result.quantities) {
    any_offered |= one.judged() > 0;
    const bool has_failed = one.status == Verdict::failed;
    if (!rows.contains(one.quantity)) {
      const std::string status(name(one.status));
      const bool is_missed = is_of_version(baseline);  // this version writes all that it asks
      const std::string where = is_missed ? "is missing in the file" : "is new";
      note(has_failed || is_missed ? changes.worse : changes.fresh, one.quantity,
           {where + (has_failed ? ", and fails" : ", " + status), "status", nullptr, status});
      continue;
    }
    const json& before = rows.at(one.quantity);
    any_compared |= before.at("held").get<std::size_t>() > 0 || !before.at("failed").empty();
    Difference worse = what_is_worse(one, before);
    if (!worse.text.empty() && !losses.empty()) {
      worse = what_is_worse(without_losses(one, before), before);
      if (worse.text.empty()) {
        changes.lost.push_back(one.quantity);
        continue;
      }
    }
    const bool is_worse_now = !worse.text.empty();
    note(changes.worse, one.quantity, std::move(worse));
    if (is_worse_now) continue;
    note(changes.better, one.quantity, what_is_better(one, before));
    if (has_failed) changes.failed_already.push_back(one.quantity);
  }
  for (const auto& row : rows.items()) {
    if (is_asked(row.key(), result)) continue;
    const bool is_explained = is_of_other_version(baseline);
    note(is_explained ? changes.gone : changes.worse, row.key(),
         {is_explained ? fmt::format("is {} by version {}; the baseline is of {}",
                                     is_newer(version_of(baseline), std::string(version))
                                         ? "not asked yet"
                                         : "no longer asked",
                                     version, version_of(baseline))
                       : "is no longer asked",
          "status", row.value().at("status"), nullptr});
  }
  if (!losses.empty()) note(changes.worse, "subject", {loss_text(losses, changes.lost)});
  if (const std::vector<std::string> mended = mended_losses(result, baseline); !mended.empty())
    note(changes.better, "subject",
         {fmt::format("it goes on at {} at which it ended or was late; the first is {}",
                      cases_text(mended.size()), mended.front())});
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

std::string newer_version_text(const json& baseline) {
  const std::string written = version_of(baseline);
  if (!is_newer(written, std::string(version))) return {};
  return fmt::format(
      "the baseline was written by tribocheck {}, which is newer than this {}: what it adds is not "
      "judged",
      printable(written), version);
}

std::string other_schema_text(const json& baseline, const json& number, int known) {
  const std::string written = version_of(baseline);
  return fmt::format("it is a baseline of schema {}, and this program has {}{}", number.dump(),
                     known,
                     is_newer(written, std::string(version))
                         ? fmt::format("; tribocheck {} wrote it, which is newer than this {}",
                                       printable(written), version)
                         : "");
}

json usable_baseline(const BaselineUse& use, const std::function<void(const json&)>& check) {
  if (use.file.empty()) return nullptr;
  json content;
  try {
    if (std::filesystem::exists(use.file)) {
      std::ifstream file(use.file);
      const std::string text{std::istreambuf_iterator<char>(file),
                             std::istreambuf_iterator<char>()};
      content = protocol::parse_bounded_json(text);
      if (content.is_discarded()) throw Broken(broken_text(text));
      check(content);
    }
  } catch (const Broken& error) {
    if (use.force) return nullptr;
    throw broken_baseline(use, error);
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
