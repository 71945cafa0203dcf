// SPDX-License-Identifier: Apache-2.0
// tribocheck bench: measures times and true errors of all contenders of a job in one run. The
// contenders are in a separate program, tribocheck_bench, which links GSL.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <memory>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "bench_rows.hpp"
#include "bench_solver.hpp"
#include "command.hpp"
#include "conformance/child_process.hpp"
#include "conformance/conformance_baseline.hpp"
#include "conformance/conversation.hpp"
#include "conformance/timed_solver.hpp"
#include "junit.hpp"
#include "messages.hpp"
#include "options.hpp"
#include "page/project_files.hpp"
#include "shell.hpp"

namespace tribo::cli {
namespace {

namespace fs = std::filesystem;

struct BenchArguments {
  bool quick = false;
  std::string filter;
  double timeout = 1800;  // s
  std::string format = "table";
  std::string junit;                  // empty: none
  std::vector<std::string> plugins;   // none, one, or two side by side
  std::vector<std::string> subjects;  // the same; none where there is a plug-in
  bool alone = false;                 // the plug-in without contenders
  conformance::BaselineUse baseline;

  bool times_solvers() const { return alone || plugins.size() > 1 || !subjects.empty(); }
  bool has_plugin() const { return !plugins.empty(); }
};

// The length is limited because the code that reads a regular expression recurses at each bracket.
constexpr std::size_t longest_filter = 1000;

bool is_expression(std::string filter) {
  if (filter.starts_with('-')) filter.erase(0, 1);  // Google Benchmark takes it as "not"
  try {
    const std::regex tried(filter, std::regex::extended);
    return true;
  } catch (const std::regex_error&) {
    return false;
  }
}

constexpr const char* control_row = "moment_5_2/control/std::exp";

// Does Google Benchmark run this row? It takes a leading - as "not".
bool is_run(std::string filter, const std::string& row) {
  if (filter.empty() || filter == "all") return true;
  const bool is_negative = filter.starts_with('-');
  if (is_negative) filter.erase(0, 1);
  return std::regex_search(row, std::regex(filter, std::regex::extended)) != is_negative;
}

// With a baseline the control runs, too, because all times are divided by its time.
std::string filter_of(const BenchArguments& arguments) {
  if (arguments.baseline.file.empty() || is_run(arguments.filter, control_row))
    return arguments.filter;
  return fmt::format("({})|^{}$", arguments.filter, control_row);
}

std::vector<std::string> command_line(const fs::path& program, const BenchArguments& arguments) {
  std::vector<std::string> command{
      program.string(), "--benchmark_format=json", "--benchmark_enable_random_interleaving=true",
      fmt::format("--benchmark_repetitions={}", arguments.quick ? 3 : 9),
      fmt::format("--benchmark_min_time={}", arguments.quick ? 0.02 : 0.2)};
  if (!arguments.filter.empty()) command.push_back("--benchmark_filter=" + filter_of(arguments));
  if (arguments.has_plugin()) command.push_back("--plugin=" + arguments.plugins[0]);
  return command;
}

// The message on a run without results.
std::string failure_text(const conformance::ChildEnd& end, const BenchArguments& arguments) {
  const std::string with_plugin =
      arguments.has_plugin() ? fmt::format(", with the plug-in {} loaded", arguments.plugins[0])
                             : "";
  if (end.is_late)
    return fmt::format(
        "tribocheck_bench was stopped, as it had not ended within {} s{}; allowed: a "
        "longer --timeout, or fewer rows by --filter",
        arguments.timeout, with_plugin);
  if (end.signal != 0)
    return fmt::format("tribocheck_bench ended by signal {} ({}){}", end.signal,
                       ::strsignal(end.signal), with_plugin);
  return fmt::format("tribocheck_bench ended without results, with exit code {}{}{}", end.exit_code,
                     with_plugin, arguments.has_plugin() ? "; a plug-in must not call exit()" : "");
}

// "; the jobs are moment_5_2, …; the families are GSL, …", as the contenders' names have them.
std::string contenders_text(const fs::path& program) {
  const conformance::ChildEnd end =
      conformance::run_child({program.string(), "--benchmark_list_tests=true"});
  std::vector<std::string> jobs, families;
  const auto add = [](std::vector<std::string>& names, std::string name) {
    if (std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(std::move(name));
  };
  std::istringstream lines(end.text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first = line.find('/'), second = line.find('/', first + 1);
    if (second == std::string::npos) continue;
    add(jobs, line.substr(0, first));
    add(families, line.substr(first + 1, second - first - 1));
  }
  if (jobs.empty()) return {};
  return fmt::format("; the jobs are {}; the families are {}", fmt::join(jobs, ", "),
                     fmt::join(families, ", "));
}

// Why nothing was measured, in one line.
struct Unmeasured {
  int exit_code;
  std::string why;
};
using Measurement = std::variant<BenchResults, Unmeasured>;

Measurement measure_contenders(const BenchArguments& arguments) {
  const fs::path program = helper_program("tribocheck_bench");
  if (program.empty())
    return Unmeasured{
        exit_bad,
        fmt::format("tribocheck_bench is not built; `make bench` builds it{}",
                    arguments.has_plugin() ? "; --alone times the plug-in without it" : "")};
  const std::chrono::milliseconds limit = milliseconds(arguments.timeout);
  const conformance::ChildEnd end = conformance::run_child(command_line(program, arguments), limit);
  if (end.start_error != 0)
    return Unmeasured{exit_failed, program.string() + " cannot be started: " +
                                       std::generic_category().message(end.start_error)};
  // The text that tribocheck_bench printed, not its exit code, tells why it ran nothing: a plug-in
  // may end it with any code.
  if (end.text == "no contender matches the filter\n")
    return Unmeasured{exit_bad, "--filter: no contender's job/family/name matches \"" +
                                    arguments.filter + "\"" + contenders_text(program)};
  if (constexpr std::string_view refused = "refused: "; end.text.starts_with(refused))
    return Unmeasured{exit_bad, "--plugin: " + end.text.substr(refused.size(), end.text.find('\n') -
                                                                                   refused.size())};
  if (!end.succeeded()) return Unmeasured{exit_failed, failure_text(end, arguments)};
  try {
    return read_bench_results(end.text);
  } catch (const std::exception&) {  // no output, or half of it
    return Unmeasured{exit_failed, failure_text(end, arguments)};
  }
}

// Times the solvers. `chosen` are the functions to time, as far as the filter takes them; empty:
// all that the filter takes.
Measurement measure_solvers(const BenchArguments& arguments, const std::set<std::string>& chosen) {
  const SolverRun run{arguments.plugins.empty() ? arguments.subjects : arguments.plugins,
                      arguments.has_plugin(), arguments.quick, arguments.timeout};
  const IsAsked is_asked = [&](const std::string& key) {
    return is_run(arguments.filter, key) &&
           (chosen.empty() || chosen.contains(key.substr(0, key.find('/'))));
  };
  try {
    BenchResults results = measure_solvers(run, is_asked);
    if (!results.jobs.empty()) return results;
    return Unmeasured{exit_failed, run.solvers[0] +
                                       ": it offers no function that is asked for, so that "
                                       "nothing is timed"};
  } catch (const conformance::SolverFailed& failure) {
    return Unmeasured{failure.exit_code, (run.are_plugins ? "--plugin: " : "--subject: ") +
                                             std::string(failure.what())};
  }
}

Measurement measure(const BenchArguments& arguments, const std::set<std::string>& chosen = {}) {
  return arguments.times_solvers() ? measure_solvers(arguments, chosen)
                                   : measure_contenders(arguments);
}

// The content of the file of --baseline, read before anything is measured.
nlohmann::json baseline_before(const BenchArguments& arguments) {
  conformance::BaselineUse use = arguments.baseline;
  std::string options;
  for (const std::string& one : arguments.subjects) options += " --subject " + shell_word(one);
  for (const std::string& one : arguments.plugins) options += " --plugin " + shell_word(one);
  if (arguments.alone) options += " --alone";
  if (!arguments.filter.empty()) options += " --filter " + shell_word(arguments.filter);
  use.renewal = fmt::format("tribocheck bench{}{} --baseline {} --update-baseline --force",
                            arguments.quick ? " --quick" : "", options, shell_word(use.file));
  use.restoration = "git checkout -- " + shell_word(use.file);
  return conformance::usable_baseline(use, check_bench_baseline);
}

// The changes from the baseline, which may be null, and from the second solver.
BenchChanges changes_of(const BenchResults& results, const nlohmann::json& before,
                        const IsAsked& asked) {
  BenchChanges changes;
  if (!before.is_null()) changes = compare(results, before, asked);
  if (!results.base.empty()) compare_with_base(results, changes);
  if (results.is_of_solvers && changes.timed == 0)
    changes.worse.push_back({"", "no time was compared"});
  return changes;
}

// Measures again, and moves the rows that are not slower again from `slower` to `told`.
void confirm_slower(const BenchArguments& arguments, const nlohmann::json& before,
                    const IsAsked& asked, BenchChanges& changes) {
  if (changes.slower.empty()) return;
  std::set<std::string> functions;
  for (const RowNote& note : changes.slower)
    functions.insert(note.key.substr(0, note.key.find('/')));
  complain("slower; measuring once more");
  const Measurement again = measure(arguments, functions);
  if (const auto* const failed = std::get_if<Unmeasured>(&again)) return complain(failed->why);
  const BenchResults* const second = std::get_if<BenchResults>(&again);
  const std::vector<RowNote> slow = changes_of(*second, before, asked).slower;
  std::vector<RowNote> kept;
  for (RowNote& note : changes.slower) {
    const bool is_slow_again = std::any_of(
        slow.begin(), slow.end(), [&](const RowNote& other) { return other.key == note.key; });
    if (is_slow_again)
      kept.push_back(std::move(note));
    else
      changes.told.push_back({note.key, note.text + "; a second run was not so slow"});
  }
  changes.slower = std::move(kept);
}

// Writes what has changed to stderr.
void tell(const BenchReport& report) {
  const BenchChanges& changes = *report.changes;
  const std::string than = report.baseline.empty() ? "the second solver" : "the baseline";
  for (const std::string& line : changes.remarks) complain(line);
  for (const RowNote& note : changes.told) complain("a little slower, not red: " + note.line());
  for (const std::vector<RowNote>* notes : {&changes.worse, &changes.gone}) {
    std::vector<conformance::KindLine> lines;
    for (const RowNote& note : *notes)
      lines.push_back({fmt::format("worse than {}: {}", than, note.line()), note.text, note.key});
    for (const std::string& line : conformance::without_repeats(lines)) complain(line);
  }
  for (const RowNote& note : changes.slower)
    complain(fmt::format("slower than {}: {}", than, note.line()));
  complain(report.verdict());
}

void update_baseline(const BenchArguments& arguments, const BenchResults& results,
                     nlohmann::json before, const IsAsked& asked) {
  const std::string& file = arguments.baseline.file;
  if (before.is_null() || arguments.baseline.force) {
    write_bench_baseline(file, new_bench_baseline(results, before, asked));
    return complain((before.is_null() ? "baseline written: " : "baseline written anew: ") + file);
  }
  const nlohmann::json old = before;
  for (const std::string& line : improve(before, results)) complain(line);
  const bool is_current = old.at("schema").is_string();  // up to schema 2 it was a number
  if (is_current && before == old) return complain("baseline unchanged: " + file);
  write_bench_baseline(file, before);
}

void write_results(const BenchArguments& arguments, const BenchReport& report,
                   OutputStream& output) {
  append_bench(output.text(), report, arguments.format);
  output.flush();
  if (!arguments.junit.empty()) report::write_file(arguments.junit, bench_junit(report));
}

// Ends a run without results. A CI system reads files but not stderr, so the reason is also written
// to the JUnit file and, in that format, to the Markdown output.
int fail_unmeasured(const BenchArguments& arguments, const Unmeasured& failed,
                    OutputStream& output) {
  complain(failed.why);
  if (!arguments.junit.empty())
    report::write_file(arguments.junit, junit_of_error("bench", failed.why, {}));
  if (arguments.format == "markdown") {
    append(output.text(), markdown_of_error("bench", failed.why, {}));
    output.flush();
  }
  return failed.exit_code;
}

int bench_with(const BenchArguments& arguments, const nlohmann::json& before,
               OutputStream& output) {
  Measurement measured = measure(arguments);
  if (const auto* const failed = std::get_if<Unmeasured>(&measured))
    return fail_unmeasured(arguments, *failed, output);
  BenchReport report{std::move(std::get<BenchResults>(measured))};
  for (const std::string& line : report.results.left_out) complain("left out: " + line);
  for (const std::string& line : report.results.kept) complain(line);
  const IsAsked asked = [&](const std::string& key) {
    return key == control_row || is_run(arguments.filter, key);
  };
  if (!before.is_null()) report.baseline = arguments.baseline.file;
  if (!before.is_null() || !report.results.base.empty()) {
    report.changes = changes_of(report.results, before, asked);
    confirm_slower(arguments, before, asked, *report.changes);
  }
  write_results(arguments, report, output);
  if (report.changes) tell(report);
  if (arguments.baseline.update) update_baseline(arguments, report.results, before, asked);
  const bool is_forced = !before.is_null() && arguments.baseline.force;
  return !report.changes || report.changes->holds() || is_forced ? exit_done : exit_failed;
}

// The fault of the options; empty where there is none.
std::string option_fault(const BenchArguments& arguments) {
  for (const auto& [option, solvers] :
       {std::pair("--plugin", &arguments.plugins), std::pair("--subject", &arguments.subjects)})
    if (solvers->size() > 2)
      return fmt::format("{}: {} are given; allowed: one, or two to be compared", option,
                         solvers->size());
  if (arguments.filter.size() > longest_filter)
    return fmt::format("--filter: longer than {} signs", longest_filter);
  if (!is_expression(arguments.filter))
    return "--filter: \"" + arguments.filter + "\" is no extended regular expression";
  if (!arguments.times_solvers() && !arguments.baseline.file.empty() &&
      arguments.filter.starts_with('-') && !is_run(arguments.filter, control_row))
    return fmt::format(
        "--filter: \"{}\" leaves out {}, which --baseline needs; allowed: a filter "
        "that leaves it in",
        arguments.filter, control_row);
  return {};
}

int bench(const BenchArguments& arguments, OutputStream& output) {
  if (const std::string fault = option_fault(arguments); !fault.empty())
    return fail(exit_bad, fault);
  try {
    return bench_with(arguments, baseline_before(arguments), output);
  } catch (const nlohmann::json::exception& error) {
    return fail_unmeasured(arguments,
                           {exit_bad, fmt::format("{}: it is no baseline of `tribocheck bench`: {}",
                                                  arguments.baseline.file, error.what())},
                           output);
  } catch (const std::invalid_argument& error) {
    return fail_unmeasured(arguments, {exit_bad, error.what()}, output);
  }
}

std::vector<Ignored> ignored_by(const BenchArguments& arguments) {
  return {{{"--alone"}, !arguments.has_plugin(), "without --plugin"},
          {{"--alone"}, arguments.plugins.size() > 1, "beside a second --plugin"}};
}

constexpr const char* bench_footer =
    R"(Jobs: moment_5_2, moment_2, root_wide, root_one_surface, curve_200, points_1e6, hertz_ellipse. Every
contender of a job is written as its users write it and runs in the same process, repetitions interleaved.
Columns: ns, CPU time a point, the median; ratio, to the fastest of tribocheck's in the same job; max ulp,
the greatest true error in units in the last place, against certified values, of curve_200 and points_1e6
against the model in long double; evaluations, of the integrand, of the moment or of a pair of elliptic
integrals a point; failures, cases with no number or off by more than 1e-6 of it times its condition, as
`verify` judges. The published fits of moments are judged where they claim to hold. A plug-in, a shared
library made for tribocheck_plugin.h, takes part in the jobs that it offers, as family "plugin"; cases that
it does not offer are not judged. It has half an hour in all (--timeout), so that one that hangs is stopped.

With --baseline counts are held exactly, errors to 4 times what they were, and times, over those of the control
(std::exp), to a tenth more where their intervals do not meet, twice; the control is run whatever the filter
says. A row that is gone is worse, unless the filter leaves it out. The last line on stderr is the verdict; exit
code 1: something is worse, or nothing could be compared.
Takes some five minutes, with --quick less than one.

With --subject, with --plugin twice, or with --alone, solvers alone are timed, here without contenders: up to 32
cases of each function, those that have an answer, again and again after each of three starts, the functions and the
solvers in turns, and beside each lap a control. A row is function/family/name. Its time is CPU time: of a plug-in's
calls; of a subject what its answers tell ("seconds": CPU seconds for the answer), or else of all its processes;
the column `measured` says which, and over which control. Wall time is shown, and never gated. Times start after
the first answers. The interval is one of ranks (95 %). With --baseline a solver is slower where the whole interval is
above 1.12 times what it was over the control, twice; of two solvers, where the first is so over the second, on any
machine. From 5 % on it is told. Exit code 1: slower, or nothing could be compared. Takes a second a function.

Example:
  tribocheck bench --quick --filter 'root_wide/(GSL|tribocheck)/'
  tribocheck bench --plugin ./libsolver.so --filter '/(plugin|tribocheck)/'
  tribocheck bench --plugin ./libsolver.so --filter '/plugin/' --baseline speed.json --update-baseline
  tribocheck bench --plugin ./libsolver.so --filter '/plugin/' --baseline speed.json
  tribocheck bench --plugin ./libsolver.so --plugin ./libbefore.so --junit speed.xml
  tribocheck bench --subject 'python3 my_solver.py' --filter '^hertz_point/')";

}  // namespace

Command add_bench(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("bench", "speed and true error of this model, beside what people use");
  app->footer(bench_footer);
  const auto arguments = std::make_shared<BenchArguments>();
  app->add_flag("--quick", arguments->quick, "fewer and shorter repetitions");
  app->add_option("--filter", arguments->filter,
                  "run only contenders whose job/family/name matches this regular expression");
  CLI::Option* const plugin =
      app->add_option("--plugin", arguments->plugins,
                      "a shared library with a solver of yours; given twice: the first beside the "
                      "second")
          ->allow_extra_args(false);
  app->add_option("--subject", arguments->subjects,
                  "command line of a program that answers JSON lines; given twice: the first "
                  "beside the second")
      ->allow_extra_args(false)
      ->excludes(plugin);
  app->add_flag("--alone", arguments->alone,
                "time one plug-in without the contenders; needs no tribocheck_bench");
  app->add_option("--timeout", arguments->timeout,
                  "seconds for each run of all contenders (default: 1800)")
      ->check(CLI::Range(0.01, 1e6));
  app->add_option("--format", arguments->format, "how to write the results (default: table)")
      ->check(CLI::IsMember({"table", "json", "tsv", "markdown"}));
  app->add_option("--junit", arguments->junit, "also write a JUnit XML file");
  app->add_option("--baseline", arguments->baseline.file,
                  "fail on more work, more error, and more time than this file says");
  CLI::Option* const update = app->add_flag("--update-baseline", arguments->baseline.update,
                                            "write what is better to the baseline");
  update->needs("--baseline");
  app->add_flag("--force", arguments->baseline.force, "with --update-baseline: what is worse, too")
      ->needs(update);
  return {app, [arguments](OutputStream& output) { return bench(*arguments, output); },
          [arguments] { return ignored_by(*arguments); }};
}

}  // namespace tribo::cli
