// SPDX-License-Identifier: Apache-2.0
#include "verify_subject.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <stdexcept>

#include "build_info.hpp"
#include "conformance/readings.hpp"
#include "junit.hpp"
#include "messages.hpp"
#include "options.hpp"
#include "page/project_files.hpp"
#include "progress.hpp"
#include "shell.hpp"

namespace tribo::cli {
namespace {

using namespace conformance;

constexpr const char* last_errors = "the last it wrote to stderr:";

// The solver that is asked, and the way to start it.
struct Subject {
  std::string name;     // as the user gave it
  std::string command;  // a command of the shell
  Limits limits;
  AskedWays ways;

  bool is_plugin() const { return limits.flushes; }
};

// Returns std::nullopt if neither --subject nor --plugin is given. Throws std::invalid_argument if
// a program does not exist: that is bad input, and not a solver that fails.
std::optional<Subject> subject_of(const SubjectArguments& given) {
  if (!given.has_subject()) return std::nullopt;
  check_solver(given.plugin, given.command);
  const bool is_plugin = !given.plugin.empty();
  if (is_plugin && given.ways.has_other_arguments())
    throw std::invalid_argument(fmt::format(
        "--{} is for --subject: the arrays of a plug-in are effective_modulus and ellipticity",
        given.ways.has_radii() ? "ellipticity radii" : "modulus bodies"));
  return Subject{is_plugin ? given.plugin : given.command,
                 is_plugin ? plugin_host_command(given.plugin, "--places") : given.command,
                 {milliseconds(given.case_timeout), milliseconds(given.start_timeout),
                  milliseconds(given.timeout), is_plugin},
                 given.ways};
}

// This check follows the run, because only the shell (exit codes 126 and 127) or the process that
// loads the plug-in (2) can tell that the subject did not start.
void check_started(const Subject& subject, const Conversation& conversation) {
  const int code = conversation.exit_code_without_answer;
  const bool of_plugin = subject.is_plugin() && code == exit_bad;
  if (code != 126 && code != 127 && !of_plugin) return;
  throw std::invalid_argument(
      fmt::format("{}: {}", of_plugin ? "--plugin" : "--subject: it cannot be started",
                  last_line(conversation.last_errors)));
}

Conversation conversation_with(const Subject& subject, const std::vector<TestCase>& cases,
                               const std::function<void(std::size_t)>& progress,
                               const Manner& manner) {
  Conversation conversation =
      ask(subject.command, asked_by(subject.ways, cases), subject.limits, progress, manner);
  check_started(subject, conversation);
  put_back(subject.ways, cases, conversation);
  return conversation;
}

std::string option_text(const char* option, const std::string& value) {
  return fmt::format(" {} {}", option, shell_word(value));
}

// The start of a command line that asks the same subject with the same tables and tolerance.
std::string same_question(const SubjectArguments& arguments) {
  std::string line = "tribocheck verify";
  line += arguments.plugin.empty() ? option_text("--subject", arguments.command)
                                   : option_text("--plugin", arguments.plugin);
  if (!arguments.exact.empty()) line += option_text("--reference", arguments.exact);
  if (arguments.tolerance != "engineering") line += option_text("--tolerance", arguments.tolerance);
  const AskedWays usual;
  if (arguments.ways.modulus != usual.modulus)
    line += option_text("--modulus", arguments.ways.modulus);
  if (arguments.ways.ellipticity != usual.ellipticity)
    line += option_text("--ellipticity", arguments.ways.ellipticity);
  return line;
}

// The command line that writes the baseline anew.
std::string renewal(const SubjectArguments& arguments) {
  std::string line = same_question(arguments);
  if (arguments.sample > 0) line += option_text("--sample", std::to_string(arguments.sample));
  return line + option_text("--baseline", arguments.baseline.file) + " --update-baseline --force";
}

// Writes the new baseline if that was asked for, unless it would demand the same as the old one.
void update_baseline(const BaselineUse& use, const nlohmann::json& before,
                     SubjectVerdict& verdict) {
  if (!use.update) return;
  const nlohmann::json after =
      baseline_of(verdict.result, use.force ? nlohmann::json(nullptr) : before);
  const bool is_new = before.is_null() || !hold_the_same(before, after);
  if (is_new) report::write_file(use.file, baseline_text(after, program_commit(), today()));
  if (!verdict.changes) {
    verdict.changes = compare(verdict.result, after);
    return complain("baseline written: " + use.file);
  }
  const auto tell = [](const char* what, const std::vector<BaselineChange>& changes) {
    for (const BaselineChange& one : changes)
      complain(fmt::format("baseline {}: {}", what, one.text));
  };
  tell("improved", verdict.changes->better);
  tell("extended", verdict.changes->fresh);
  tell("shortened", verdict.changes->gone);
  tell(use.force ? "lowered" : "kept", verdict.changes->worse);
  if (!is_new) complain("baseline unchanged: " + use.file);
  if (!use.force) return;
  for (const BaselineChange& one : verdict.changes->worse)
    verdict.result.notes.push_back("The baseline was lowered: " + one.text);
  verdict.changes = compare(verdict.result, after);
}

// Diagnoses of quantities that are within the tolerance, but worse than in the baseline. They are
// found with another tolerance: it allows such a quantity only what the baseline allows, and all
// other quantities any error.
std::vector<Diagnosis> slight_diagnoses(const std::vector<TestCase>& cases,
                                        const SubjectVerdict& verdict,
                                        const std::vector<Mistake>& mistakes) {
  Tolerance tight{.name = "baseline", .relative = 1e300, .quantity = {}};
  for (const BaselineChange& one : verdict.changes->worse)
    if (one.fact == "worst_error")
      tight.quantity[one.quantity] = greatest_as_before(one.before.get<double>());
  if (tight.quantity.empty()) return {};
  std::vector<Diagnosis> found;
  for (Diagnosis& one : diagnose(cases, verdict.result.conversation, tight, mistakes)) {
    const bool is_known = std::any_of(
        verdict.diagnoses.begin(), verdict.diagnoses.end(), [&](const Diagnosis& known) {
          return function_of(known.quantity) == function_of(one.quantity);
        });
    if (is_known || !tight.quantity.contains(one.quantity)) continue;
    one.text = "Worse than the baseline, still within the tolerance: " + one.text;
    found.push_back(std::move(one));
  }
  return found;
}

// The cases that --show names.
std::vector<TestCase> shown_of(const std::vector<std::string>& ids,
                               const std::vector<TestCase>& all) {
  std::vector<TestCase> cases;
  for (const std::string& id : ids) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const TestCase& one) { return one.id == id; });
    if (found == all.end())
      throw std::invalid_argument(
          fmt::format("--show: no case is called {}; --save-cases - lists all", id));
    cases.push_back(*found);
  }
  return cases;
}

// Asks and judges each case alone, because the verdict on a quantity is about all of its cases.
int show(const std::optional<Subject>& subject, const SubjectArguments& arguments,
         const std::vector<TestCase>& cases, const Tolerance& tolerance, OutputStream& output) {
  const auto asked = [&](const TestCase& one) { return asked_by(arguments.ways, {one}).front(); };
  bool any_failed = false, all_hold = true;
  for (const TestCase& one : shown_of(arguments.shown, cases)) {
    if (!subject) {
      append_request(output.text(), asked(one), tolerance);
      continue;
    }
    std::vector<TestCase> alone{one};
    Conversation conversation = conversation_with(*subject, alone, [](std::size_t) {}, {});
    take_readings(alone, conversation, tolerance, arguments.ways);
    const ConformanceResult result =
        judge(subject->name, alone, std::move(conversation), tolerance);
    any_failed |= result.overall == Overall::failed;
    all_hold &= result.overall == Overall::complete || result.overall == Overall::partial;
    append_shown_case(output.text(), asked(alone[0]), result);
    complain_of(last_errors, result.conversation.error_lines);
  }
  output.flush();
  if (subject && all_hold)
    complain(
        "all of it holds where each case is asked alone, of a new process; if a verdict says that "
        "a case fails, the solver keeps something from the cases before it");
  return any_failed ? exit_failed : exit_done;
}

void save_cases(const std::string& path, const std::vector<TestCase>& cases, OutputStream& output) {
  std::string lines;
  for (const TestCase& one : cases) lines += one.line() + "\n";
  if (path != "-") return report::write_file(path, lines);
  append(output.text(), lines);
  output.flush();
}

// Ends a run that could judge nothing. A CI system reads files but not stderr, so the reason is
// also written to the JUnit file and, in that format, to the Markdown output.
int fail_unjudged(const SubjectArguments& arguments, const std::string& why,
                  const std::vector<std::string>& errors, OutputStream& output) {
  complain(why);
  complain_of(last_errors, errors);
  if (!arguments.junit.empty())
    report::write_file(arguments.junit, junit_of_error("verify", why, errors));
  if (arguments.format == "markdown" && arguments.shown.empty()) {
    append(output.text(), markdown_of_error("verify", why, errors));
    output.flush();
  }
  return exit_bad;
}

int judge_subject(const SubjectArguments& arguments, OutputStream& output) {
  if (arguments.saved_cases == "-" && arguments.has_subject())
    throw std::invalid_argument(
        "--save-cases - writes to stdout, as the verdict does; name a file, or leave the subject "
        "out");
  const std::optional<Subject> subject = subject_of(arguments);
  const report::ReferenceFiles files = report::reference_files(arguments.exact);
  std::vector<TestCase> cases = read_cases({files.exact, files.published});
  const Tolerance tolerance = tolerance_of(arguments.tolerance, cases);
  if (!arguments.shown.empty()) return show(subject, arguments, cases, tolerance, output);
  cases = cases_for(std::move(cases), tolerance, arguments.sample);
  if (!arguments.saved_cases.empty())
    save_cases(arguments.saved_cases, asked_by(arguments.ways, cases), output);
  if (!subject) return exit_done;
  if (const std::optional<std::string> unknown = unknown_of(arguments.required, cases))
    throw std::invalid_argument(fmt::format("--require: {} is no quantity of the table", *unknown));
  const nlohmann::json before =
      usable_baseline(arguments.baseline, [&](const nlohmann::json& content) {
        check_comparable(content, tolerance, arguments.sample);
      });
  const std::vector<Mistake> mistakes = read_mistakes(files.mistakes);

  SubjectVerdict verdict;
  {
    Progress progress(cases.size(), {"cases", 1, true});
    Forecast forecast(cases.size(), arguments.sample == 0 ? "; --sample 20 asks fewer" : "");
    Conversation conversation = conversation_with(*subject, cases,
                                                  [&](std::size_t) {
                                                    progress.step();
                                                    forecast.step();
                                                  },
                                                  {arguments.jobs, cases_to_repeat(cases)});
    if (!conversation.never_answered.empty())  // one fault is behind it all: nothing is judged
      return fail_unjudged(
          arguments,
          fmt::format("{} never answered: {}", subject->name, conversation.never_answered),
          conversation.error_lines, output);
    verdict = verdict_on(subject->name, cases, std::move(conversation),
                         {tolerance, arguments.ways, mistakes, arguments.sample});
    verdict.missing = missing_of(arguments.required, verdict.result);
  }
  verdict.baseline = arguments.baseline.file;
  verdict.same_question = same_question(arguments);
  verdict.changes = changes_since(before, arguments.baseline, verdict.result);
  if (std::string newer = before.is_null() ? "" : newer_version_text(before); !newer.empty()) {
    newer[0] = 'T';  // as a sentence begins
    verdict.result.notes.push_back(newer + '.');
  }
  if (verdict.changes)
    for (Diagnosis& one : slight_diagnoses(cases, verdict, mistakes))
      verdict.diagnoses.push_back(std::move(one));
  update_baseline(arguments.baseline, before, verdict);
  append_verdict(output.text(), verdict, arguments.format);
  output.flush();
  if (!arguments.junit.empty()) report::write_file(arguments.junit, subject_junit(verdict));
  for (const QuantityNote& one : verdict.missing) complain(one.text);
  return failures(verdict).empty() ? exit_done : exit_failed;
}

}  // namespace

int verify_subject(SubjectArguments arguments, OutputStream& output) {
  arguments.baseline.renewal = renewal(arguments);
  arguments.baseline.restoration = "git checkout -- " + shell_word(arguments.baseline.file);
  return answered_or_complained([&] {
    try {
      return judge_subject(arguments, output);
    } catch (const std::invalid_argument& error) {
      return fail_unjudged(arguments, error.what(), {}, output);
    }
  });
}

}  // namespace tribo::cli
