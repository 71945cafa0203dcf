// SPDX-License-Identifier: Apache-2.0
#include "verify_subject.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <stdexcept>

#include "messages.hpp"
#include "page/project_files.hpp"
#include "progress.hpp"
#include "shell.hpp"

namespace tribo::cli {
namespace {

using namespace conformance;

// The solver that is asked, and the way to start it.
struct Subject {
  std::string name;    // as it was given
  const char* option;  // the option that gave it
  std::string command;
  Limits limits;

  bool is_plugin() const { return limits.flushes; }
};

// Checked before the start: a program that does not exist is bad input, not a solver that fails.
void check_startable(const SubjectArguments& given) {
  if (given.plugin.empty()) {
    if (const std::optional<std::string> why_not = why_not_startable(given.command))
      throw std::invalid_argument("--subject: " + *why_not);
  } else if (!std::filesystem::exists(given.plugin)) {
    throw std::invalid_argument(fmt::format(
        "--plugin: there is no file {}; correct the path, or build it first", given.plugin));
  }
}

// Empty where neither --subject nor --plugin is given. A plug-in is asked through a process of its
// own, so that it cannot take the run with it.
std::optional<Subject> subject_of(const SubjectArguments& given) {
  if (given.command.empty() && given.plugin.empty()) return std::nullopt;
  check_startable(given);
  const auto milliseconds = [](double seconds) {
    return std::chrono::milliseconds(static_cast<long long>(1000 * seconds));
  };
  const bool is_plugin = !given.plugin.empty();
  const Limits limits{milliseconds(given.case_timeout), milliseconds(given.start_timeout),
                      milliseconds(given.timeout), is_plugin};
  if (!is_plugin) return Subject{given.command, "--subject", given.command, limits};
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  return Subject{given.plugin, "--plugin",
                 "exec " + shell_word(self) + " plugin-host " + shell_word(given.plugin), limits};
}

// Checked after the run: only the shell (exit codes 126 and 127) or the process that loads the
// plug-in (2) can tell that the subject did not start.
void check_started(const Subject& subject, const Conversation& conversation) {
  const int code = conversation.exit_code_without_answer;
  const bool of_plugin = subject.is_plugin() && code == exit_bad;
  if (code != 126 && code != 127 && !of_plugin) return;
  std::string why = conversation.last_errors;
  while (why.ends_with('\n')) why.pop_back();
  why.erase(0, why.rfind('\n') + 1);
  const std::string own_prefix = "tribocheck: ";
  if (of_plugin && why.starts_with(own_prefix)) why.erase(0, own_prefix.size());
  throw std::invalid_argument(
      fmt::format("{}: {}", of_plugin ? "--plugin" : "--subject: it cannot be started", why));
}

Conversation conversation_with(const Subject& subject, const std::vector<TestCase>& cases,
                               const std::function<void(std::size_t)>& progress) {
  Conversation conversation = ask(subject.command, cases, subject.limits, progress);
  check_started(subject, conversation);
  return conversation;
}

void complain_of_errors(const std::vector<std::string>& lines) {
  if (!lines.empty()) complain("the last it wrote to stderr:");
  for (const std::string& line : lines) complain_more(line);
}

// Files of reference/: in their usual place, or else beside the folder of --reference, as in a copy
// of reference/.
struct ReferenceFiles {
  CaseSources cases;
  std::string mistakes;
};
ReferenceFiles reference_files(const std::string& given) {
  const report::ReportPlaces usual = report::usual_places();
  const std::filesystem::path exact = report::reference_tables(given);
  const auto found = [&](const std::filesystem::path& place, const char* name) {
    return (std::filesystem::exists(place) ? place : (exact / ".." / name).lexically_normal())
        .string();
  };
  return {{exact.string(), found(usual.scenes, "published")},
          found(usual.reference / "mistakes.toml", "mistakes.toml")};
}

Tolerance tolerance_of(const std::string& text, const std::vector<TestCase>& cases) {
  if (text == "strict") return strict_tolerance();
  if (text == "engineering") return engineering_tolerance();
  return read_tolerance(text, cases);
}

// A function stands for each of its quantities.
bool stands_for(const std::string& wanted, const std::string& quantity) {
  return quantity == wanted || quantity.starts_with(wanted + ".");
}

void check_required(const std::vector<std::string>& required, const std::vector<TestCase>& cases) {
  std::set<std::string> quantities;
  for (const TestCase& asked : cases)
    for (const Expected& one : asked.expected) quantities.insert(quantity_name(asked, one));
  for (const std::string& wanted : required)
    if (std::none_of(quantities.begin(), quantities.end(),
                     [&](const std::string& one) { return stands_for(wanted, one); }))
      throw std::invalid_argument(fmt::format("--require: {} is no quantity of the table", wanted));
}

// The quantities that were asked for by name and are not held.
std::vector<QuantityNote> missing_of(const std::vector<std::string>& required,
                                     const ConformanceResult& result) {
  std::vector<QuantityNote> missing;
  for (const QuantityVerdict& one : result.quantities) {
    const bool wanted = std::any_of(required.begin(), required.end(), [&](const std::string& name) {
      return stands_for(name, one.quantity);
    });
    if (wanted && one.status != Verdict::held)
      missing.push_back(
          {one.quantity, fmt::format("required, but {}: {}", name(one.status), one.quantity)});
  }
  return missing;
}

void write(Text& to, const SubjectVerdict& verdict, const std::string& format) {
  if (format == "json")
    append_subject_json(to, verdict);
  else if (format == "markdown")
    append_subject_markdown(to, verdict);
  else
    append_subject_table(to, verdict);
}

// The command line that makes the baseline anew.
std::string renewal(const SubjectArguments& arguments) {
  std::string line = "tribocheck verify ";
  const auto add = [&](const char* option, const std::string& value) {
    line += fmt::format("{} {} ", option, shell_word(value));
  };
  add(arguments.plugin.empty() ? "--subject" : "--plugin",
      arguments.plugin.empty() ? arguments.command : arguments.plugin);
  if (!arguments.exact.empty()) add("--reference", arguments.exact);
  if (arguments.tolerance != "engineering") add("--tolerance", arguments.tolerance);
  if (arguments.sample > 0) add("--sample", std::to_string(arguments.sample));
  add("--baseline", arguments.baseline);
  return line + "--update-baseline --force";
}

std::runtime_error no_baseline(const SubjectArguments& arguments, const std::exception& error) {
  return std::runtime_error(fmt::format("{}: {}; this makes it anew: {}", arguments.baseline,
                                        error.what(), renewal(arguments)));
}

// The content of the file of --baseline, read before anybody is asked; null where it is to be
// written. A file that cannot be compared with is refused; with --force it counts as absent.
nlohmann::json usable_baseline(const SubjectArguments& arguments, const Tolerance& tolerance) {
  if (arguments.baseline.empty()) return nullptr;
  nlohmann::json before;
  try {
    before = read_conformance_baseline(arguments.baseline);
    if (!before.is_null()) check_comparable(before, tolerance, arguments.sample);
  } catch (const std::runtime_error& error) {
    if (arguments.force) return nullptr;
    throw no_baseline(arguments, error);
  }
  if (before.is_null() && !arguments.update_baseline)
    throw std::runtime_error(fmt::format(
        "{}: there is no such baseline; --update-baseline writes it", arguments.baseline));
  return before;
}

// Compares with the baseline, and writes it anew where that was asked for.
void use_baseline(const SubjectArguments& arguments, const nlohmann::json& before,
                  SubjectVerdict& verdict) {
  if (arguments.baseline.empty()) return;
  try {
    if (!before.is_null()) verdict.changes = compare(verdict.result, before);
  } catch (const std::exception& error) {
    if (!arguments.force) throw no_baseline(arguments, error);
  }
  if (!arguments.update_baseline) return;
  const nlohmann::json after =
      baseline_of(verdict.result, arguments.force ? nlohmann::json(nullptr) : before);
  report::write_file(arguments.baseline,
                     after.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  if (!verdict.changes) return complain("baseline written: " + arguments.baseline);
  for (const QuantityNote& one : verdict.changes->better)
    complain("baseline improved: " + one.text);
  for (const QuantityNote& one : verdict.changes->worse)
    complain((arguments.force ? "baseline lowered: " : "baseline kept: ") + one.text);
  if (arguments.force) verdict.changes = compare(verdict.result, after);
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

// Each case is asked and judged alone: a quantity's verdict is about all of its cases.
int show(const std::optional<Subject>& subject, const std::vector<TestCase>& cases,
         const Tolerance& tolerance, OutputStream& output) {
  bool any_failed = false;
  for (const TestCase& one : cases) {
    if (!subject) {
      append_request(output.text(), one, tolerance);
      continue;
    }
    const std::vector<TestCase> alone{one};
    const Conversation conversation = conversation_with(*subject, alone, [](std::size_t) {});
    const ConformanceResult result = judge(subject->name, alone, conversation, tolerance);
    any_failed |= result.overall == Overall::failed;
    append_shown_case(output.text(), one, conversation.answers.front(),
                      worst_examples(result, alone, conversation, tolerance, true));
    for (const std::string& violation : result.violations)
      append(output.text(), "  the protocol was broken: " + violation + "\n");
    complain_of_errors(last_error_lines(conversation));
  }
  output.flush();
  return any_failed ? exit_failed : exit_done;
}

void save_cases(const std::string& path, const std::vector<TestCase>& cases, OutputStream& output) {
  std::string lines;
  for (const TestCase& one : cases) lines += one.line() + "\n";
  if (path != "-") return report::write_file(path, lines);
  append(output.text(), lines);
  output.flush();
}

// A subject that answered no case is not judged: it has one fault, which is told.
int complain_of_silence(const std::string& subject, const Conversation& conversation) {
  complain(fmt::format("{} never answered: {}", subject, conversation.never_answered));
  complain_of_errors(last_error_lines(conversation));
  return exit_bad;
}

int verify(const SubjectArguments& arguments, OutputStream& output) {
  if (arguments.saved_cases == "-" && !(arguments.command.empty() && arguments.plugin.empty()))
    throw std::invalid_argument(
        "--save-cases - writes to stdout, as the verdict does; name a file, or leave the subject "
        "out");
  const std::optional<Subject> subject = subject_of(arguments);
  const ReferenceFiles files = reference_files(arguments.exact);
  std::vector<TestCase> cases = read_cases(files.cases);
  const Tolerance tolerance = tolerance_of(arguments.tolerance, cases);
  if (!arguments.shown.empty())
    return show(subject, shown_of(arguments.shown, cases), tolerance, output);
  cases = cases_for(std::move(cases), tolerance);
  if (arguments.sample > 0) cases = sampled(std::move(cases), arguments.sample);
  if (!arguments.saved_cases.empty()) save_cases(arguments.saved_cases, cases, output);
  if (!subject) return exit_done;
  check_required(arguments.required, cases);
  const nlohmann::json before = usable_baseline(arguments, tolerance);

  const std::vector<Mistake> mistakes = read_mistakes(files.mistakes);
  SubjectVerdict verdict;
  {
    Progress progress(cases.size(), {"cases", 1, true});
    const Conversation conversation =
        conversation_with(*subject, cases, [&](std::size_t) { progress.step(); });
    if (!conversation.never_answered.empty())
      return complain_of_silence(subject->name, conversation);
    verdict.result = judge(subject->name, cases, conversation, tolerance);
    verdict.result.sample = arguments.sample;
    verdict.diagnoses = diagnose(cases, conversation, tolerance, mistakes);
    verdict.examples = worst_examples(verdict.result, cases, conversation, tolerance);
    verdict.notes = notes_on(cases, conversation);
    verdict.last_errors = last_error_lines(conversation);
  }
  verdict.missing = missing_of(arguments.required, verdict.result);
  verdict.baseline = arguments.baseline;
  use_baseline(arguments, before, verdict);
  write(output.text(), verdict, arguments.format);
  output.flush();
  if (!arguments.junit.empty()) report::write_file(arguments.junit, subject_junit(verdict));
  for (const QuantityNote& one : verdict.missing) complain(one.text);
  return failures(verdict).empty() ? exit_done : exit_failed;
}

}  // namespace

int verify_subject(const SubjectArguments& arguments, OutputStream& output) {
  return answered_or_complained([&] { return verify(arguments, output); });
}

}  // namespace tribo::cli
