// SPDX-License-Identifier: Apache-2.0
// tribocheck verify: this model, or somebody else's, against the certified tables of
// reference/exact.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "accuracy/accuracy.hpp"
#include "build_info.hpp"
#include "command.hpp"
#include "junit.hpp"
#include "messages.hpp"
#include "page/project_files.hpp"
#include "protocol/answers.hpp"
#include "table.hpp"
#include "verify_subject.hpp"

namespace tribo::cli {
namespace {

using verification::QuantityResult;

const char* verdict(const QuantityResult& result) { return result.passed() ? "held" : "FAILED"; }

// "24"; or "24 or 32 × cond." if the contract allows the greater of both.
std::string allowed(const QuantityResult& result) {
  if (result.allowed_ulp_per_condition == 0) return fmt::format("{}", result.allowed_ulp);
  return fmt::format("{} or {} × cond.", result.allowed_ulp, result.allowed_ulp_per_condition);
}

constexpr const char* no_row = "no table of reference/exact has a row of it";

// "COMPLETE: 24 of 24 quantities held, in 5230 cases."
std::string summary(const std::vector<QuantityResult>& results) {
  std::size_t held = 0, cases = 0;
  std::string failed;
  for (const QuantityResult& one : results) {
    cases += one.cases;
    if (one.passed())
      ++held;
    else
      failed += (failed.empty() ? "" : ", ") + one.quantity +
                (one.cases == 0 ? fmt::format(" ({})", no_row) : "");
  }
  return fmt::format("{}: {} of {} quantities held, in {} cases{}.",
                     failed.empty() ? "COMPLETE" : "FAILED", held, results.size(), cases,
                     failed.empty() ? "" : "; failed: " + failed);
}

void append_table(Text& to, const std::vector<QuantityResult>& results) {
  const std::vector<ColumnHead> heads{
      {"quantity", "", 36},       {"cases", "", 6},
      {"worst_error", "ulp", 11}, {"worst_error/condition", "ulp", 11},
      {"allowed", "ulp", 20},     {"of_bound", "%", 8},
      {"worst_row", "", 9},       {"verdict", "", 7}};
  append_heads(to, heads);
  for (const QuantityResult& r : results)
    append_row(to, heads,
               {r.quantity, std::to_string(r.cases), fmt::format("{:.3g}", r.worst_ulp),
                fmt::format("{:.3g}", r.worst_ulp_per_condition), allowed(r),
                fmt::format("{:.3g}", 100 * r.worst_part_of_bound), r.worst_row, verdict(r)});
  append(to, "\n");
  append_line(to, summary(results));
}

void append_json(Text& to, const std::vector<QuantityResult>& results) {
  append(to, list_start("accuracy/1", "quantities"));
  for (std::size_t i = 0; i < results.size(); ++i) {
    const QuantityResult& r = results[i];
    // JSON has no infinity: the error of a result that is no number is written as null.
    const auto number = [](double x) { return x <= 1e300 ? fmt::format("{}", x) : "null"; };
    if (i > 0) append(to, list_comma);
    append(to, "{\"quantity\": ");
    protocol::append_json_text(to, r.quantity);
    append(to,
           fmt::format(", \"cases\": {}, \"worst_ulp\": {}, \"worst_ulp_per_condition\": {}, "
                       "\"allowed_ulp\": {}, \"allowed_ulp_per_condition\": {}, "
                       "\"worst_part_of_bound\": {}, \"worst_row\": ",
                       r.cases, number(r.worst_ulp), number(r.worst_ulp_per_condition),
                       r.allowed_ulp, r.allowed_ulp_per_condition, number(r.worst_part_of_bound)));
    protocol::append_json_text(to, r.worst_row);
    append(to, fmt::format(", \"passed\": {}}}", r.passed()));
  }
  append(to, list_end);
}

std::string junit_text(const std::vector<QuantityResult>& results) {
  JunitSuite suite{"accuracy"};
  for (const QuantityResult& r : results)
    if (r.passed())
      suite.tests.push_back({r.quantity});
    else
      suite.tests.push_back({r.quantity, JunitTest::End::failure,
                             r.cases == 0 ? no_row
                                          : fmt::format("row {}: {:.3g} times the bound",
                                                        r.worst_row, r.worst_part_of_bound)});
  return junit_xml(suite);
}

int verify(const SubjectArguments& arguments, OutputStream& output) {
  if (arguments.has_subject() || !arguments.shown.empty() || !arguments.saved_cases.empty())
    return verify_subject(arguments, output);
  if (arguments.format == "markdown") {
    complain("--format markdown is for --subject and --plugin");
    return exit_bad;
  }
  return answered_or_complained([&] {
    const std::vector<QuantityResult> results =
        verification::check_accuracy(report::reference_tables(arguments.exact).string());
    if (arguments.format == "json")
      append_json(output.text(), results);
    else
      append_table(output.text(), results);
    if (!arguments.junit.empty()) report::write_file(arguments.junit, junit_text(results));
    output.flush();
    const bool all_held = std::all_of(results.begin(), results.end(),
                                      [](const QuantityResult& r) { return r.passed(); });
    return all_held ? exit_done : exit_failed;
  });
}

// The options that each form of the command would ignore. The forms: our own model is judged; a
// subject is judged; cases are shown by --show, with or without a subject; and cases are saved by
// --save-cases without a subject.
std::vector<Ignored> ignored_by(const SubjectArguments& asked) {
  const bool has_subject = asked.has_subject();
  const bool shows = !asked.shown.empty(), saves = !asked.saved_cases.empty();
  const bool judges_own = !has_subject && !shows && !saves;
  const std::string no_subject = "without --subject or --plugin";
  return {{{"--tolerance", "--modulus", "--ellipticity", "--sample"}, judges_own, no_subject},
          {{"--jobs", "--case-timeout", "--start-timeout", "--timeout", "--require", "--baseline",
            "--update-baseline", "--force"},
           !has_subject,
           no_subject},
          {{"--sample", "--jobs", "--require", "--baseline", "--update-baseline", "--force",
            "--save-cases", "--format", "--junit"},
           shows,
           "beside --show"},
          {{"--format", "--junit"}, !has_subject && saves, no_subject}};
}

constexpr const char* verify_footer =
    R"(Each row of reference/exact holds a value that ball arithmetic encloses. An error may be as large as
the function's contract allows: so many units in the last place, or so many times the condition number.
Exit code 1: a contract was broken.

With --subject or --plugin somebody else's solver is put to the tests: the same values as function-level
cases and operating points, and the paper's scenes. A subject is a program that reads a line of JSON and
writes one (README.md of verification/conformance says how; `tribocheck init subject` writes a start); a
plug-in is a shared library (tribocheck_plugin.h), asked in a process of its own. What it does not offer
it skips; NaN is an error. Exit code 0: all that it offers holds, or with --baseline: nothing is worse than
that file says; 1: something failed, it offers nothing, or it ended badly after its last answer; 2: it cannot
be started, or never answers. It has 60 s for the first answer, as it may have much to load, and 10 s for each
one after it. With --baseline each case that failed then may fail, by no more than four times its error.
Some cases are asked again at the end: answers that change are told, and the worse one is judged.

Each failed quantity is shown with its worst case. --show asks one case again, and prints the line that
asks, what is expected and how far off it may be, and what came. --save-cases writes the lines that ask
all cases, one JSON object a line, to be fed to any program; it needs no subject.

Example:
  tribocheck verify --junit verify.xml
  tribocheck verify --subject 'python3 my_solver.py'
  tribocheck verify --subject 'python3 my_solver.py' --jobs 4
  tribocheck verify --subject 'python3 my_solver.py' --show f0012
  tribocheck verify --save-cases - | python3 my_solver.py
  tribocheck verify --plugin ./libmine.so --tolerance strict --baseline mine.json)";

}  // namespace

Command add_verify(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "verify", "this model, or your own, against certified reference values");
  app->footer(verify_footer);
  const auto arguments = std::make_shared<SubjectArguments>();
  app->add_option("--reference", arguments->exact,
                  "folder of the tables (default: reference/exact)");
  app->add_option("--format", arguments->format, "how to write the results (default: table)")
      ->check(CLI::IsMember({"table", "json", "markdown"}));
  app->add_option("--junit", arguments->junit, "also write a JUnit XML file");
  SubjectArguments& subject = *arguments;
  app->option_defaults()->group("Subjects");
  CLI::Option* const command = app->add_option("--subject", subject.command,
                                               "command line of a program that answers JSON lines");
  app->add_option("--plugin", subject.plugin, "shared library with the plug-in functions")
      ->excludes(command);
  app->add_option("--tolerance", subject.tolerance,
                  "strict (the certified contracts), engineering (1e-6 of the value, times its "
                  "condition; the default), or a file of lines QUANTITY RELATIVE");
  app->add_option("--modulus", subject.ways.modulus,
                  "what it takes for effective_modulus: E* (the default), E' = 2E*, or bodies: "
                  "first_modulus, first_poisson_ratio, second_modulus, second_poisson_ratio")
      ->check(CLI::IsMember({"E*", "E'", "bodies"}));
  app->add_option(
         "--ellipticity", subject.ways.ellipticity,
         "what films take for ellipticity: k (the default), or radii: radius_x and radius_y")
      ->check(CLI::IsMember({"k", "radii"}));
  app->add_option("--sample", subject.sample, "at most so many cases of each function")
      ->check(CLI::PositiveNumber);
  app->add_option(
         "--jobs", subject.jobs,
         "start so many of the subject, 1 to 64, and ask all of them at once; the verdict is "
         "the same (default: 1)")
      ->check(CLI::Range(1, 64));
  app->add_option("--case-timeout", subject.case_timeout, "seconds for one case (default: 10)")
      ->check(CLI::Range(0.01, 1e5));
  app->add_option("--start-timeout", subject.start_timeout,
                  "seconds from a start to the first answer (default: 60; never less than those "
                  "for one case)")
      ->check(CLI::Range(0.01, 1e5));
  app->add_option("--timeout", subject.timeout, "seconds for all of them (default: 600)")
      ->check(CLI::Range(0.01, 1e6));
  app->add_option("--require", subject.required,
                  "a quantity that has to be held whole, or a function: all of its quantities; "
                  "may be repeated");
  app->add_option("--show", subject.shown,
                  "ask this case alone and print all of it; may be repeated");
  app->add_option("--save-cases", subject.saved_cases,
                  "write the lines that ask to this file; -: stdout");
  app->add_option("--baseline", subject.baseline.file,
                  "fail only on what is worse than this file says");
  CLI::Option* const update = app->add_flag("--update-baseline", subject.baseline.update,
                                            "write what is better to the baseline");
  update->needs("--baseline");
  app->add_flag("--force", subject.baseline.force, "with --update-baseline: what is worse, too")
      ->needs(update);
  app->option_defaults()->group("Options");  // of the options added from here on, as by default
  return {app, [arguments](OutputStream& output) { return verify(*arguments, output); },
          [arguments] { return ignored_by(*arguments); }};
}

}  // namespace tribo::cli
