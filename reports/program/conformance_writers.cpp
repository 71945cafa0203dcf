// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "build_info.hpp"
#include "junit.hpp"
#include "page/text_table.hpp"
#include "page/texts.hpp"
#include "table.hpp"
#include "verify_subject.hpp"

namespace tribo::cli {
namespace {

using namespace conformance;

// The worst relative error, and the worst error over its bound; empty if no answer was judged.
std::string worst_error(const QuantityVerdict& one) {
  if (one.judged() == 0) return {};
  return std::isfinite(one.worst_relative) ? fmt::format("{:.2g}", one.worst_relative) : "-";
}
std::string worst_margin(const QuantityVerdict& one) {
  if (one.judged() == 0) return {};
  const double part = one.worst.part_of_bound;
  return std::isfinite(part) ? fmt::format("{:.3g}", part) : "no number";
}

std::size_t count(const ConformanceResult& result, Verdict status) {
  return static_cast<std::size_t>(
      std::count_if(result.quantities.begin(), result.quantities.end(),
                    [&](const QuantityVerdict& one) { return one.status == status; }));
}

// Does a quantity fail that also failed when the baseline was written?
bool failed_already(const SubjectVerdict& verdict, const QuantityVerdict& one) {
  if (!verdict.changes) return false;
  const std::vector<std::string>& known = verdict.changes->failed_already;
  return std::find(known.begin(), known.end(), one.quantity) != known.end();
}

std::string status_text(const SubjectVerdict& verdict, const QuantityVerdict& one) {
  return failed_already(verdict, one) ? "failed as before" : std::string(name(one.status));
}

// "complete", "partial", "failed", "nothing"; with a baseline "no worse", "worse".
std::string overall(const SubjectVerdict& verdict) {
  if (verdict.changes && !verdict.changes->worse.empty()) return "worse";
  if (!verdict.missing.empty()) return "failed";
  return verdict.changes ? "no worse" : std::string(name(verdict.result.overall));
}

std::string headword(const SubjectVerdict& verdict) {
  if (verdict.changes && !verdict.changes->worse.empty())
    return "FAILED, worse than " + verdict.baseline;
  if (!verdict.missing.empty()) return "FAILED";
  if (verdict.changes) return "PASSED, no worse than " + verdict.baseline;
  constexpr std::array<const char*, 5> words{"COMPLETE", "PARTIAL", "HELD IN THE PHYSICAL RANGE",
                                             "FAILED", "NOTHING"};
  return words[static_cast<std::size_t>(verdict.result.overall)];
}

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

// The quantities that failed or became worse only because the subject ended or did not answer.
std::vector<std::string> lost(const SubjectVerdict& verdict) {
  if (verdict.changes && !verdict.changes->lost.empty()) return verdict.changes->lost;
  std::vector<std::string> quantities;
  for (const QuantityVerdict& one : verdict.result.quantities)
    if (one.fails_by_losses_alone()) quantities.push_back(one.quantity);
  return quantities;
}

// A breach of the protocol without the case and the answer: "is answered twice, or out of order".
std::string kind_of_violation(const std::string& text) {
  std::string kind, word;
  std::istringstream words(text.substr(0, text.find(": ")));
  while (words >> word)
    if (word.find_first_of("0123456789") == std::string::npos) kind += word + ' ';
  return kind;
}

// Breaches of the protocol, and facts of the run that a user should know.
std::vector<std::string> remarks(const SubjectVerdict& verdict) {
  const ConformanceResult& result = verdict.result;
  const Conversation& talk = result.conversation;
  std::vector<std::string> lines = result.notes;
  for (std::string& one : unsteady_lines(result.unsteady)) lines.push_back(std::move(one));
  if (!result.losses.empty()) {
    lines.push_back("The subject failed " + loss_text(result.losses, lost(verdict)) + ":");
    lines.push_back(fmt::format("  {} --show {}", verdict.same_question, result.losses.front().id));
  }
  if (talk.violation_count > 0)
    lines.push_back(fmt::format("The protocol was broken {} times:", talk.violation_count));
  std::vector<KindLine> violations;
  for (const std::string& one : talk.violations)
    violations.push_back({"  " + one, kind_of_violation(one), {}});
  for (std::string& one : without_repeats(violations)) lines.push_back(std::move(one));
  if (talk.violation_count > talk.violations.size()) lines.emplace_back("  …");
  if (talk.answers_at_end_of_input)
    lines.emplace_back(
        "It answers when its input ends only: it should flush its output after each line.");
  if (talk.starts > 1)
    lines.push_back(
        fmt::format("It was started {} times, as it died or did not answer.", talk.starts));
  return lines;
}

// The last lines of stderr; empty if the verdict is COMPLETE.
std::vector<std::string> shown_errors(const ConformanceResult& result) {
  if (result.overall == Overall::complete) return {};
  return result.conversation.error_lines;
}

// "got 2.3e-08 m, expected 3.2e-08 m, give or take 3.2e-14: 99 times as far off as is allowed"
std::string comparison(const Example& one) {
  const std::string error = error_text(one);
  return fmt::format("got {}, expected {}{}", got_text(one),
                     expected_text(one.expected, one.allowed), error.empty() ? "" : ": " + error);
}

// The diagnoses of the quantity's function. Each explains all quantities of its functions.
std::vector<const Diagnosis*> diagnoses_of(const SubjectVerdict& verdict,
                                           const std::string& quantity) {
  std::vector<const Diagnosis*> found;
  for (const Diagnosis& one : verdict.diagnoses)
    if (std::find(one.functions.begin(), one.functions.end(), function_of(quantity)) !=
        one.functions.end())
      found.push_back(&one);
  return found;
}

// A line for each change: `kind`, and the change's text. Of more than three quantities in a row
// with the same change, only the first has a line, and the next line names the others.
std::vector<std::string> change_lines(const std::string& kind,
                                      const std::vector<BaselineChange>& changes) {
  std::vector<KindLine> lines;
  for (const BaselineChange& one : changes)
    lines.push_back({fmt::format("{} {}", kind, one.text),
                     one.text.substr(std::min(one.quantity.size(), one.text.size())),
                     one.quantity});
  return without_repeats(lines);
}

// All changes against the baseline.
std::vector<std::string> change_lines(const SubjectVerdict& verdict) {
  std::vector<std::string> lines;
  if (!verdict.changes) return lines;
  const auto add = [&](const char* kind, const std::vector<BaselineChange>& changes) {
    for (std::string& one : change_lines(kind + std::string(":"), changes))
      lines.push_back(std::move(one));
  };
  add("Better than the baseline", verdict.changes->better);
  add("Not in the baseline", verdict.changes->fresh);
  add("In the baseline alone", verdict.changes->gone);
  add("Worse than the baseline", verdict.changes->worse);
  return lines;
}

std::string summary(const SubjectVerdict& verdict) {
  const ConformanceResult& result = verdict.result;
  std::string text = headword(verdict);
  text += fmt::format(": {} of {} quantities held", count(result, Verdict::held),
                      result.quantities.size());
  const auto add = [&](std::size_t n, const std::string& what) {
    if (n > 0) text += fmt::format(", {} {}", n, what);
  };
  const std::vector<std::string> then =
      verdict.changes ? verdict.changes->failed_already : std::vector<std::string>{};
  add(count(result, Verdict::held_physically), "held in the physical range");
  add(count(result, Verdict::partly_held), "held in part");
  add(count(result, Verdict::failed) - then.size(), "failed");
  add(then.size(), fmt::format("failed as before ({})", joined(then)));
  add(count(result, Verdict::not_offered), "not offered");
  std::vector<std::string> missing;
  for (const QuantityNote& one : verdict.missing) missing.push_back(one.quantity);
  if (!missing.empty()) text += "; required, but not held: " + joined(missing);
  if (const auto& broken = result.conversation.violations; !broken.empty())
    text += "; the protocol was broken: " + broken.front();
  return text + fmt::format(" (tolerance: {}).", result.tolerance.name);
}

// Is the worst case of a quantity to be shown? Not if cases failed only because the subject ended
// or did not answer: remarks() tells them all together.
bool has_example(const QuantityVerdict& one) {
  return one.failed > 0 && !one.fails_by_losses_alone();
}

// The worst cases of the quantities that failed. If successive quantities have the same worst case,
// its request is written once.
void append_examples(Text& to, const ConformanceResult& result) {
  std::string last;
  for (const QuantityVerdict& one : result.quantities) {
    if (!has_example(one)) continue;
    append(to, "\n");
    append_line(to, fmt::format("Worst of {}, in case {}: {}", one.quantity, one.worst.id,
                                comparison(one.worst)));
    if (one.worst.id != last) append(to, "  " + one.worst.request.dump() + "\n");
    last = one.worst.id;
  }
}

// A sentence with the quantities that are not offered, which have no rows in tables, and with the
// reason if it is the same for all. If no quantity of a function is offered, the function is named
// instead. Empty if all quantities are offered.
std::string not_offered(const ConformanceResult& result) {
  std::vector<std::string> names;
  std::set<std::string> reasons;
  for (const QuantityVerdict& one : result.quantities) {
    if (one.status != Verdict::not_offered) continue;
    const bool is_whole =
        std::all_of(result.quantities.begin(), result.quantities.end(), [&](const auto& other) {
          return function_of(other.quantity) != function_of(one.quantity) ||
                 other.status == Verdict::not_offered;
        });
    reasons.insert(one.first_reason);
    const std::string name = is_whole ? function_of(one.quantity) : one.quantity;
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  if (names.empty()) return "";
  return fmt::format("Not offered: {}{}.", joined(names),
                     reasons.size() == 1 ? fmt::format(" ({})", *reasons.begin()) : "");
}

void append_subject_table(Text& to, const SubjectVerdict& verdict) {
  std::size_t widest = 36;
  for (const QuantityVerdict& one : verdict.result.quantities)
    if (one.status != Verdict::not_offered) widest = std::max(widest, one.quantity.size());
  const std::vector<ColumnHead> heads{{"quantity", "", widest}, {"asked", "", 6},
                                      {"held", "", 6},          {"failed", "", 6},
                                      {"skipped", "", 7},       {"worst_relative_error", "", 11},
                                      {"of_bound", "", 9},      {"verdict", "", 16}};
  append_heads(to, heads);
  for (const QuantityVerdict& one : verdict.result.quantities) {
    if (one.status == Verdict::not_offered) continue;
    append_row(to, heads,
               {one.quantity, std::to_string(one.asked), std::to_string(one.held),
                std::to_string(one.failed), std::to_string(one.skipped), worst_error(one),
                worst_margin(one), status_text(verdict, one)});
  }
  if (const std::string rest = not_offered(verdict.result); !rest.empty()) {
    append(to, "\n");
    for (const std::string& line : report::wrapped(rest, 100)) append_line(to, line);
  }
  append_examples(to, verdict.result);
  for (const Diagnosis& one : verdict.diagnoses) {
    append(to, "\n");
    append_line(to, "Diagnosis: " + one.text);
  }
  const std::vector<std::string> lines = remarks(verdict);
  const std::vector<std::string> errors = shown_errors(verdict.result);
  if (!lines.empty() || !errors.empty()) append(to, "\n");
  for (const std::string& line : lines) append_line(to, line);
  if (!errors.empty()) append(to, "The last it wrote to stderr:\n");
  for (const std::string& line : errors) append_line(to, "  " + line);
  for (const std::string& line : change_lines(verdict)) append_line(to, line);
  append(to, "\n");
  append_line(to, summary(verdict));
}

nlohmann::ordered_json expected_json(const Expected& one) {
  if (!one.word.empty()) return one.word;
  return one.high;
}

using nlohmann::ordered_json;

ordered_json unsteady_json(const std::vector<Unsteady>& unsteady) {
  ordered_json all = ordered_json::array();
  const auto value = [](const Said& one) {
    return one.value ? ordered_json(*one.value) : ordered_json(nullptr);
  };
  for (const Unsteady& one : unsteady)
    all.push_back({{"quantity", one.quantity},
                   {"asked_again", one.asked_again},
                   {"changed", one.changed},
                   {"case", one.id},
                   {"first", value(one.first)},
                   {"second", value(one.second)},
                   {"first_place", one.first_place},
                   {"second_place", one.second_place},
                   {"reason", one.second.value ? one.first.reason : one.second.reason},
                   {"relative_difference", one.apart}});
  return all;
}

ordered_json seconds_json(const Durations& seconds) {
  ordered_json functions = ordered_json::array();
  for (const auto& [function, taken] : seconds.functions)
    functions.push_back({{"function", function}, {"seconds", taken}});
  return {{"run", seconds.run}, {"cpu", seconds.cpu}, {"functions", std::move(functions)}};
}

ordered_json changes_json(const std::vector<BaselineChange>& changes) {
  ordered_json list = ordered_json::array();
  for (const BaselineChange& one : changes) {
    ordered_json cases = ordered_json::array();
    for (const CaseChange& of : one.cases)
      cases.push_back({{"case", of.id}, {"before", of.before}, {"after", of.after}});
    list.push_back({{"quantity", one.quantity},
                    {"text", one.text},
                    {"fact", one.fact.empty() ? ordered_json() : ordered_json(one.fact)},
                    {"before", one.before},
                    {"after", one.after},
                    {"cases", std::move(cases)}});
  }
  return list;
}

// A list or an object becomes text, so that a subject cannot add members to the document.
ordered_json got_json(const Example& one) {
  if (!one.got) return nullptr;
  return one.got->is_structured() ? ordered_json(got_text(one)) : ordered_json(*one.got);
}

void append_subject_json(Text& to, const SubjectVerdict& verdict) {
  const ConformanceResult& result = verdict.result;
  const Conversation& talk = result.conversation;
  // Numbers that are not finite are written as null.
  ordered_json all =
      document("verify-subject/1",
               {{"subject", result.subject},
                {"tolerance", result.tolerance.name},
                {"sample", result.sample == 0 ? ordered_json("all") : ordered_json(result.sample)},
                {"overall", overall(verdict)},
                {"summary", summary(verdict)},
                {"quantities", ordered_json::array()},
                {"examples", ordered_json::array()},
                {"diagnoses", ordered_json::array()},
                {"losses", ordered_json::array()},
                {"violation_count", talk.violation_count},
                {"violations", talk.violations},
                {"starts", talk.starts},
                {"answers_at_end_of_input", talk.answers_at_end_of_input},
                {"notes", result.notes},
                {"last_errors", talk.last_errors}});
  for (const QuantityVerdict& one : result.quantities) {
    const Example& worst = one.worst;
    all["quantities"].push_back({{"quantity", one.quantity},
                                 {"status", name(one.status)},
                                 {"asked", one.asked},
                                 {"held", one.held},
                                 {"failed", one.failed},
                                 {"skipped", one.skipped},
                                 {"worst_relative_error", one.worst_relative},
                                 {"worst_part_of_bound", worst.part_of_bound},
                                 {"worst_case", one.judged() > 0 ? worst.id : ""},
                                 {"reason", one.first_reason}});
    if (one.failed > 0)
      all["examples"].push_back({{"quantity", one.quantity},
                                 {"case", worst.id},
                                 {"request", worst.request},
                                 {"expected", expected_json(worst.expected)},
                                 {"allowed_error", worst.allowed},
                                 {"unit", worst.expected.unit},
                                 {"got", got_json(worst)},
                                 {"reason", worst.reason},
                                 {"part_of_bound", worst.part_of_bound}});
  }
  for (const Diagnosis& one : verdict.diagnoses)
    all["diagnoses"].push_back({{"quantity", one.quantity},
                                {"functions", one.functions},
                                {"mistakes", one.mistakes},
                                {"explained", one.explained},
                                {"wrong", one.wrong},
                                {"text", one.text}});
  all["unsteady"] = unsteady_json(result.unsteady);
  all["seconds"] = seconds_json(talk.seconds);
  for (const Loss& one : result.losses)
    all["losses"].push_back({{"case", one.id}, {"function", one.function}, {"reason", one.reason}});
  if (verdict.changes) {
    all["baseline"] = {{"file", verdict.baseline},
                       {"failed_already", verdict.changes->failed_already},
                       {"lost", verdict.changes->lost}};
    all["changes"] = {{"better", changes_json(verdict.changes->better)},
                      {"worse", changes_json(verdict.changes->worse)},
                      {"new", changes_json(verdict.changes->fresh)},
                      {"gone", changes_json(verdict.changes->gone)}};
  }
  append(to, all.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n");
}

void append_subject_markdown(Text& to, const SubjectVerdict& verdict) {
  const auto cell = [](const std::string& text) { return report::escape_markdown(text); };
  append(to, fmt::format("### tribocheck: {}\n\n", cell(summary(verdict))));
  append(to,
         "| quantity | verdict | held | failed | skipped | worst relative error | of its bound |\n"
         "|---|---|---:|---:|---:|---:|---:|\n");
  for (const QuantityVerdict& one : verdict.result.quantities) {
    if (one.status == Verdict::not_offered) continue;
    append(to, fmt::format("| `{}` | {} | {} | {} | {} | {} | {} |\n", one.quantity,
                           one.status == Verdict::failed && !failed_already(verdict, one)
                               ? "**FAILED**"
                               : status_text(verdict, one),
                           one.held, one.failed, one.skipped, worst_error(one), worst_margin(one)));
  }
  append(to, "\n");
  if (const std::string rest = not_offered(verdict.result); !rest.empty())
    append(to, "- " + cell(rest) + "\n");
  for (const Diagnosis& one : verdict.diagnoses)
    append(to, fmt::format("- **Diagnosis.** {}\n", cell(one.text)));
  for (const QuantityVerdict& one : verdict.result.quantities)
    if (has_example(one))
      append(to, fmt::format("- Worst of `{}`, in case {}: {}\n\n  ```json\n  {}\n  ```\n",
                             one.quantity, cell(one.worst.id), cell(comparison(one.worst)),
                             one.worst.request.dump()));
  for (const std::string& line : remarks(verdict)) append(to, "- " + cell(line) + "\n");
  append(to, markdown_of_stderr(shown_errors(verdict.result)));
  if (!verdict.changes) return;
  const auto add = [&](const char* kind, const std::vector<BaselineChange>& changes) {
    std::vector<BaselineChange> escaped = changes;
    for (BaselineChange& one : escaped) {
      one.text = cell(one.text);
      one.quantity = cell(one.quantity);
    }
    for (const std::string& line : change_lines(kind, escaped))
      append(to, (line.starts_with(' ') ? "  - " + line.substr(2) : "- " + line) + '\n');
  };
  add("**Worse than the baseline.**", verdict.changes->worse);
  add("Better than the baseline:", verdict.changes->better);
  add("Not in the baseline:", verdict.changes->fresh);
  add("In the baseline alone:", verdict.changes->gone);
}

// An equal part of the seconds of the quantity's function, because one request asks for all of its
// quantities. The parts of all quantities add up to the run.
double seconds_of(const ConformanceResult& result, const std::string& quantity) {
  const auto sharing = std::count_if(result.quantities.begin(), result.quantities.end(),
                                     [&](const QuantityVerdict& one) {
                                       return function_of(one.quantity) == function_of(quantity);
                                     });
  const auto& all = result.conversation.seconds.functions;
  const auto found = all.find(function_of(quantity));
  return found == all.end() ? 0 : found->second / static_cast<double>(sharing);
}

// The diagnoses of the quantity's function, and its worst case if it failed. Empty if it failed
// only because the subject ended or did not answer.
std::string junit_details(const SubjectVerdict& verdict, const QuantityVerdict& one) {
  std::string text;
  for (const Diagnosis* diagnosis : diagnoses_of(verdict, one.quantity))
    text += "Diagnosis: " + diagnosis->text + "\n";
  if (!has_example(one)) return one.failed > 0 ? "" : text;
  return text + fmt::format("Worst in case {}: {}\n{}\n", one.worst.id, comparison(one.worst),
                            one.worst.request.dump());
}

}  // namespace

std::vector<QuantityNote> failures(const SubjectVerdict& verdict) {
  const ConformanceResult& result = verdict.result;
  std::vector<QuantityNote> all;
  if (verdict.changes) {
    for (const BaselineChange& one : verdict.changes->worse)
      all.push_back({one.quantity, one.text});
  } else {
    bool any_lost = false;
    for (const Loss& one : result.losses) any_lost |= one.is_physical;
    for (const QuantityVerdict& one : result.quantities)
      if (one.status == Verdict::failed && one.fails_by_losses_alone())
        any_lost = true;
      else if (one.status == Verdict::failed)
        all.push_back(
            {one.quantity, fmt::format("{} of {}: {}", one.failed, one.asked, one.first_reason)});
    if (any_lost) all.push_back({"subject", loss_text(result.losses, lost(verdict))});
    if (result.conversation.violation_count > 0)
      all.push_back({"protocol", result.conversation.violations.front()});
    if (result.overall == Overall::nothing)
      all.push_back({"anything", "no quantity is offered, so that nothing is tested"});
  }
  for (const QuantityNote& missing : verdict.missing)
    if (std::none_of(all.begin(), all.end(),
                     [&](const QuantityNote& one) { return one.quantity == missing.quantity; }))
      all.push_back(missing);
  return all;
}

void append_verdict(Text& to, const SubjectVerdict& verdict, const std::string& format) {
  if (format == "json")
    append_subject_json(to, verdict);
  else if (format == "markdown")
    append_subject_markdown(to, verdict);
  else
    append_subject_table(to, verdict);
}

std::string subject_junit(const SubjectVerdict& verdict) {
  using End = JunitTest::End;
  const ConformanceResult& result = verdict.result;
  const std::vector<QuantityNote> failed = failures(verdict);
  const std::vector<std::string> lost_quantities = lost(verdict);
  const auto is_lost = [&](const QuantityVerdict& one) {
    return std::find(lost_quantities.begin(), lost_quantities.end(), one.quantity) !=
           lost_quantities.end();
  };
  JunitSuite suite{"conformance", {}, true};
  suite.seconds = result.conversation.seconds.run;
  suite.properties = {{"version", version_line()},
                      {"subject", result.subject},
                      {"tolerance", result.tolerance.name}};
  if (verdict.changes) suite.properties.emplace_back("baseline", verdict.baseline);
  for (const QuantityVerdict& one : result.quantities) {
    const auto add = [&](End end, const std::string& message) {
      const bool is_offered = one.status != Verdict::not_offered;
      suite.tests.push_back({one.quantity, end, message,
                             is_offered ? junit_details(verdict, one) : "",
                             seconds_of(result, one.quantity)});
    };
    const auto why = std::find_if(failed.begin(), failed.end(), [&](const QuantityNote& failure) {
      return failure.quantity == one.quantity;
    });
    if (why != failed.end())
      add(End::failure, why->text);
    else if (failed_already(verdict, one))
      add(End::skipped, fmt::format("failed as before ({}): {} of {}: {}", verdict.baseline,
                                    one.failed, one.asked, one.first_reason));
    else if (is_lost(one))
      add(End::skipped, "lost by the subject's end or silence: " + one.first_reason);
    else if (one.status == Verdict::not_offered)
      add(End::skipped, one.first_reason);
    else
      add(End::passed, "");
  }
  for (const QuantityNote& one : failed)  // failures that belong to no quantity
    if (std::none_of(result.quantities.begin(), result.quantities.end(),
                     [&](const QuantityVerdict& known) { return known.quantity == one.quantity; }))
      suite.tests.push_back({one.quantity, End::failure, one.text});
  if (result.conversation.violation_count == 0) suite.tests.push_back({"protocol"});
  for (const std::string& line : remarks(verdict)) suite.output += line + "\n";
  for (const std::string& line : change_lines(verdict)) suite.output += line + "\n";
  suite.errors = fmt::format("{}", fmt::join(shown_errors(result), "\n"));
  return junit_xml(suite);
}

void append_request(Text& to, const TestCase& asked, const Tolerance& tolerance) {
  append(to, asked.line() + "\n");
  for (const Expected& one : asked.expected)
    append_line(to, fmt::format("  {}: expected {}", one.quantity,
                                expected_text(one, allowed_error(asked, one, tolerance))));
}

void append_shown_case(Text& to, const TestCase& asked, const ConformanceResult& result) {
  const Reply& answer = result.conversation.answers.front();
  append(to, "asked:    " + asked.line() + "\n");
  append_line(to, "answered: " + (answer.outcome == Outcome::answered ? line_of(answer.fields)
                                                                      : answer.reason));
  for (const QuantityVerdict& one : result.quantities)
    append_line(to, fmt::format("  {}: {}", one.quantity, comparison(one.worst)));
  for (const std::string& violation : result.conversation.violations)
    append(to, "  the protocol was broken: " + violation + "\n");
}

}  // namespace tribo::cli
