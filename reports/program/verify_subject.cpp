// SPDX-License-Identifier: Apache-2.0
#include "verify_subject.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "bad_input.hpp"
#include "conformance_writers.hpp"
#include "exit_code.hpp"
#include "messages.hpp"
#include "page/project_files.hpp"
#include "page/write_file.hpp"
#include "progress.hpp"
#include "shell.hpp"

namespace tribo::cli {
namespace {

using namespace conformance;

bool has_subject(const SubjectArguments& arguments) {
  return !arguments.command.empty() || !arguments.plugin.empty();
}

const std::string& subject_of(const SubjectArguments& arguments) {
  return arguments.plugin.empty() ? arguments.command : arguments.plugin;
}

// A plug-in is asked through a process of its own, so that it cannot take the run with it.
std::string command_of(const SubjectArguments& arguments) {
  if (arguments.plugin.empty()) return arguments.command;
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  return "exec " + shell_word(self) + " plugin-host " + shell_word(arguments.plugin);
}

// Checked before the start: a program that does not exist is bad input, not a solver that fails.
void check_startable(const SubjectArguments& arguments) {
  if (!arguments.plugin.empty() && !std::filesystem::exists(arguments.plugin))
    throw std::invalid_argument(fmt::format(
        "--plugin: there is no file {}; correct the path, or build it first", arguments.plugin));
  if (!arguments.plugin.empty()) return;
  if (const std::optional<std::string> why_not = why_not_startable(arguments.command))
    throw std::invalid_argument("--subject: " + *why_not);
}

// Checked after the run: only the shell (exit codes 126 and 127) or the process that loads the
// plug-in (2) can tell that the subject did not start.
void check_started(const SubjectArguments& arguments, const Conversation& conversation) {
  const int code = conversation.exit_code_without_answer;
  const bool of_plugin = !arguments.plugin.empty() && code == exit_bad;
  if (code != 126 && code != 127 && !of_plugin) return;
  std::string why = conversation.last_errors;
  while (why.ends_with('\n')) why.pop_back();
  why.erase(0, why.rfind('\n') + 1);
  const std::string own_prefix = "tribocheck: ";
  if (of_plugin && why.starts_with(own_prefix)) why.erase(0, own_prefix.size());
  throw std::invalid_argument(
      fmt::format("{}: {}", of_plugin ? "--plugin" : "--subject: it cannot be started", why));
}

void complain_of_errors(const Conversation& conversation) {
  const std::vector<std::string> lines = last_error_lines(conversation);
  if (!lines.empty()) complain("the last it wrote to stderr:");
  for (const std::string& line : lines) complain_more(line);
}

// A subject of which no case has an answer is not judged: what is wrong is one thing.
int complain_of_silence(const std::string& subject, const Conversation& conversation) {
  complain(fmt::format("{} never answered: {}", subject, conversation.never_answered));
  complain_of_errors(conversation);
  return exit_bad;
}

// The paper's scenes are in their usual place, or else beside the folder of --reference, as in a
// copy of reference/.
CaseSources sources_of(const SubjectArguments& arguments) {
  const report::ReportPlaces places = report::usual_places();
  const std::filesystem::path exact = report::reference_tables(arguments.exact);
  if (std::filesystem::is_directory(places.scenes)) return {exact.string(), places.scenes.string()};
  return {exact.string(), (exact / "../published").lexically_normal().string()};
}

// mistakes.toml is in its usual place, or else beside the folder of --reference.
std::string mistakes_of(const SubjectArguments& arguments) {
  const std::filesystem::path usual = report::usual_places().reference / "mistakes.toml";
  if (std::filesystem::is_regular_file(usual)) return usual.string();
  const std::filesystem::path exact = report::reference_tables(arguments.exact);
  return (exact / "../mistakes.toml").lexically_normal().string();
}

Tolerance tolerance_of(const std::string& text, const std::vector<Case>& cases) {
  if (text == "strict") return strict_tolerance();
  if (text == "engineering") return engineering_tolerance();
  return read_tolerance(text, cases);
}

// A function stands for each of its quantities.
bool stands_for(const std::string& wanted, const std::string& quantity) {
  return quantity == wanted || quantity.starts_with(wanted + ".");
}

void check_required(const SubjectArguments& arguments, const std::vector<Case>& cases) {
  for (const std::string& wanted : arguments.required) {
    const auto is_wanted = [&](const Case& asked) {
      return std::any_of(asked.expected.begin(), asked.expected.end(), [&](const Expected& one) {
        return stands_for(wanted, quantity_name(asked, one));
      });
    };
    if (std::none_of(cases.begin(), cases.end(), is_wanted))
      throw std::invalid_argument(fmt::format("--require: {} is no quantity of the table", wanted));
  }
}

// The quantities that were asked for by name and are not held.
std::vector<Finding> missing_of(const SubjectArguments& arguments,
                                const ConformanceResult& result) {
  std::vector<Finding> missing;
  for (const QuantityVerdict& one : result.quantities) {
    const bool wanted =
        std::any_of(arguments.required.begin(), arguments.required.end(),
                    [&](const std::string& name) { return stands_for(name, one.quantity); });
    if (!wanted || one.status == Status::held) continue;
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

// The line that makes the baseline anew.
std::string renewal(const SubjectArguments& arguments) {
  std::string line = "tribocheck verify ";
  const auto add = [&](const char* option, const std::string& value) {
    line += fmt::format("{} {} ", option, shell_word(value));
  };
  add(arguments.plugin.empty() ? "--subject" : "--plugin", subject_of(arguments));
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
// written. A file that cannot be compared with is refused, or with --force taken for none.
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
  for (const Finding& one : verdict.changes->better) complain("baseline improved: " + one.text);
  for (const Finding& one : verdict.changes->worse)
    complain((arguments.force ? "baseline lowered: " : "baseline kept: ") + one.text);
  if (arguments.force) verdict.changes = compare(verdict.result, after);
}

Limits limits_of(const SubjectArguments& arguments) {
  const auto milliseconds = [](double seconds) {
    return std::chrono::milliseconds(static_cast<long long>(1000 * seconds));
  };
  return {milliseconds(arguments.case_timeout), milliseconds(arguments.start_timeout),
          milliseconds(arguments.timeout), !arguments.plugin.empty()};
}

// The cases that --show names.
std::vector<Case> shown_of(const SubjectArguments& arguments, const std::vector<Case>& all) {
  std::vector<Case> cases;
  for (const std::string& id : arguments.shown) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Case& one) { return one.id == id; });
    if (found == all.end())
      throw std::invalid_argument(
          fmt::format("--show: no case is called {}; --save-cases - lists all", id));
    cases.push_back(*found);
  }
  return cases;
}

// Each case is asked and judged alone, as a quantity's verdict is one on all of its cases.
int show(const SubjectArguments& arguments, const std::vector<Case>& cases,
         const Tolerance& tolerance, OutputStream& output) {
  bool any_failed = false;
  for (const Case& one : cases) {
    const std::vector<Case> alone{one};
    if (!has_subject(arguments)) {
      append_request(output.text(), one, tolerance);
      continue;
    }
    const Conversation conversation =
        ask(command_of(arguments), alone, limits_of(arguments), [](std::size_t) {});
    check_started(arguments, conversation);
    const ConformanceResult result = judge(subject_of(arguments), alone, conversation, tolerance);
    any_failed |= result.overall == Overall::failed;
    append_shown_case(output.text(), one, conversation.answers.front(),
                      worst_examples(result, alone, conversation, tolerance, true));
    for (const std::string& violation : result.violations)
      append(output.text(), "  the protocol was broken: " + violation + "\n");
    complain_of_errors(conversation);
  }
  output.flush();
  return any_failed ? exit_failed : exit_done;
}

// False: nothing is left to do.
bool save_cases(const SubjectArguments& arguments, const std::vector<Case>& cases,
                OutputStream& output) {
  if (arguments.saved_cases.empty()) return true;
  std::string lines;
  for (const Case& one : cases) lines += one.line() + "\n";
  if (arguments.saved_cases != "-") {
    report::write_file(arguments.saved_cases, lines);
  } else {
    append(output.text(), lines);
    output.flush();
  }
  return has_subject(arguments);
}

int verify(const SubjectArguments& arguments, OutputStream& output) {
  if (arguments.saved_cases == "-" && has_subject(arguments))
    throw std::invalid_argument(
        "--save-cases - writes to stdout, as the verdict does; name a file, or leave the subject "
        "out");
  check_startable(arguments);
  std::vector<Case> cases = read_cases(sources_of(arguments));
  const Tolerance tolerance = tolerance_of(arguments.tolerance, cases);
  if (!arguments.shown.empty())
    return show(arguments, shown_of(arguments, cases), tolerance, output);
  cases = cases_for(std::move(cases), tolerance);
  if (arguments.sample > 0) cases = sampled(std::move(cases), arguments.sample);
  if (!save_cases(arguments, cases, output)) return exit_done;
  check_required(arguments, cases);
  const nlohmann::json before = usable_baseline(arguments, tolerance);

  const std::vector<Mistake> mistakes = read_mistakes(mistakes_of(arguments));
  SubjectVerdict verdict;
  {
    Progress progress(cases.size(), {"cases", 1, true});
    const Conversation conversation = ask(command_of(arguments), cases, limits_of(arguments),
                                          [&](std::size_t) { progress.step(); });
    check_started(arguments, conversation);
    if (!conversation.never_answered.empty())
      return complain_of_silence(subject_of(arguments), conversation);
    verdict.result = judge(subject_of(arguments), cases, conversation, tolerance);
    verdict.result.sample = arguments.sample;
    verdict.diagnoses = diagnose(cases, conversation, tolerance, mistakes);
    verdict.examples = worst_examples(verdict.result, cases, conversation, tolerance);
    verdict.notes = notes_on(cases, conversation);
    verdict.last_errors = last_error_lines(conversation);
  }
  verdict.missing = missing_of(arguments, verdict.result);
  verdict.baseline = arguments.baseline;
  use_baseline(arguments, before, verdict);
  write(output.text(), verdict, arguments.format);
  output.flush();
  if (!arguments.junit.empty()) report::write_file(arguments.junit, subject_junit(verdict));
  for (const Finding& one : verdict.missing) complain(one.text);
  return failures(verdict).empty() ? exit_done : exit_failed;
}

}  // namespace

int verify_subject(const SubjectArguments& arguments, OutputStream& output) {
  return answered_or_complained([&] { return verify(arguments, output); });
}

}  // namespace tribo::cli
