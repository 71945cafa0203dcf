// SPDX-License-Identifier: Apache-2.0
// tribocheck bench: every contender of a job in one run, times beside true errors. The contenders
// live in a program of their own, tribocheck_bench, which links GSL.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <variant>
#include <vector>

#include "bench_baseline.hpp"
#include "bench_rows.hpp"
#include "command.hpp"
#include "conformance/conformance_baseline.hpp"
#include "exit_code.hpp"
#include "messages.hpp"
#include "page/child_process.hpp"
#include "page/write_file.hpp"
#include "page/report_error.hpp"

namespace tribo::cli {
namespace {

namespace fs = std::filesystem;

struct BenchArguments {
  bool quick = false;
  std::string filter;
  std::string format = "table";
  std::string plugin;    // empty: none
  std::string baseline;  // empty: none
  bool update_baseline = false, force = false;
};

// Beside this program, as in the build tree, or where an installation puts helpers; empty: nowhere.
fs::path bench_program() {
  std::error_code ignored;
  const fs::path here = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  for (const fs::path& path :
       {here / "tribocheck_bench", here.parent_path() / "libexec/tribocheck/tribocheck_bench"})
    if (fs::is_regular_file(path, ignored)) return path;
  return {};
}

bool is_expression(std::string filter) {
  if (filter.starts_with('-')) filter.erase(0, 1);  // "not", to Google Benchmark
  try {
    const std::regex tried(filter, std::regex::extended);
    return true;
  } catch (const std::regex_error&) {
    return false;
  }
}

std::vector<std::string> command_line(const fs::path& program, const BenchArguments& arguments) {
  std::vector<std::string> command{
      program.string(), "--benchmark_format=json", "--benchmark_enable_random_interleaving=true",
      fmt::format("--benchmark_repetitions={}", arguments.quick ? 3 : 9),
      fmt::format("--benchmark_min_time={}", arguments.quick ? 0.02 : 0.2)};
  if (!arguments.filter.empty()) command.push_back("--benchmark_filter=" + arguments.filter);
  if (!arguments.plugin.empty()) command.push_back("--plugin=" + arguments.plugin);
  return command;
}

void append_results(Text& to, const BenchResults& results, const std::string& format) {
  if (format == "json")
    append_bench_json(to, results);
  else if (format == "tsv")
    append_bench_tsv(to, results);
  else
    append_bench_table(to, results);
}

int fail(int code, const std::string& line) {
  complain(line);
  return code;
}

std::string failure_text(const report::ChildEnd& end, const BenchArguments& arguments) {
  std::string text = end.signal() != 0 ? fmt::format("tribocheck_bench ended by signal {} ({})",
                                                     end.signal(), ::strsignal(end.signal()))
                                       : "tribocheck_bench failed";
  if (arguments.plugin.empty()) return text;
  return fmt::format("{} with the plug-in {} loaded", text, arguments.plugin);
}

// "; the jobs are moment_5_2, …; the families are GSL, …", as the contenders' names have them.
std::string contenders_text(const fs::path& program) {
  const report::ChildEnd end =
      report::run_child({program.string(), "--benchmark_list_tests=true"}, report::Heard::output);
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

// Runs the contenders. If that fails, the reason is printed and an exit code is returned.
std::variant<BenchResults, int> measure(const BenchArguments& arguments) {
  const fs::path program = bench_program();
  if (program.empty())
    return fail(exit_bad, "tribocheck_bench is not built; `make bench` builds it");
  const report::ChildEnd end =
      report::run_child(command_line(program, arguments), report::Heard::output);
  if (end.start_error != 0)
    return fail(exit_failed, program.string() + " cannot be started: " +
                                 std::generic_category().message(end.start_error));
  if (end.exited_with(2))
    return fail(exit_bad, "--filter: no contender's job/family/name matches \"" + arguments.filter +
                              "\"" + contenders_text(program));
  if (!arguments.plugin.empty() && end.exited_with(3)) return exit_bad;  // it has said why
  if (!end.succeeded()) return fail(exit_failed, failure_text(end, arguments));
  return read_bench_results(end.text);
}

// A time counts as slower when a second run says so too.
int hold_to_baseline(const BenchArguments& arguments, const BenchResults& results) {
  const nlohmann::json before = conformance::read_conformance_baseline(arguments.baseline);
  if (before.is_null() && !arguments.update_baseline)
    return fail(exit_bad,
                arguments.baseline + ": there is no such baseline; --update-baseline writes it");
  BenchChanges changes;
  if (!before.is_null()) {
    changes = compare(results, before);
    if (!changes.slower.empty()) {
      complain("slower than the baseline; measuring once more");
      const auto again = measure(arguments);
      if (const BenchResults* second = std::get_if<BenchResults>(&again)) {
        const std::vector<std::string> slow = compare(*second, before).slower;
        std::erase_if(changes.slower, [&](const std::string& line) {
          const std::string key = line.substr(0, line.find(": "));
          return std::none_of(slow.begin(), slow.end(), [&](const std::string& other) {
            return other.starts_with(key + ": ");
          });
        });
      }
    }
  }
  for (const std::string& line : changes.remarks) complain(line);
  for (const std::string& line : changes.worse) complain("worse than the baseline: " + line);
  for (const std::string& line : changes.slower) complain("slower than the baseline: " + line);
  if (arguments.update_baseline) {
    const nlohmann::json kept = arguments.force ? nlohmann::json(nullptr) : before;
    report::write_file(arguments.baseline, bench_baseline(results, kept).dump(1) + "\n");
    for (const std::string& line : changes.better) complain("baseline improved: " + line);
    if (arguments.force) return exit_done;
  }
  return changes.worse.empty() && changes.slower.empty() ? exit_done : exit_failed;
}

int bench(const BenchArguments& arguments, OutputStream& output) {
  if (!is_expression(arguments.filter))
    return fail(exit_bad,
                "--filter: \"" + arguments.filter + "\" is no extended regular expression");
  const auto measured = measure(arguments);
  if (const int* code = std::get_if<int>(&measured)) return *code;
  const BenchResults& results = std::get<BenchResults>(measured);
  for (const std::string& line : results.left_out) complain("left out: " + line);
  append_results(output.text(), results, arguments.format);
  output.flush();
  if (arguments.baseline.empty()) return exit_done;
  try {
    return hold_to_baseline(arguments, results);
  } catch (const nlohmann::json::exception& error) {
    return fail(exit_bad, fmt::format("{}: no baseline of `tribocheck bench`: {}",
                                      arguments.baseline, error.what()));
  } catch (const OutputFailed&) {
    throw;  // a baseline that cannot be written is not bad input
  } catch (const std::runtime_error& error) {
    return fail(exit_bad, error.what());
  }
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
it does not offer are not judged. With --baseline counts are held exactly, errors to 4 times what they were,
and times, over the control's of the run, to a tenth more where their intervals do not meet, twice; exit
code 1 where that fails.
Takes some five minutes, with --quick less than one.

Example:
  tribocheck bench --quick --filter 'root_wide/(GSL|tribocheck)/'
  tribocheck bench --plugin ./libsolver.so --filter '/(plugin|tribocheck)/')";

}  // namespace

Command add_bench(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("bench", "speed and true error of this model, beside what people use");
  app->footer(bench_footer);
  const auto arguments = std::make_shared<BenchArguments>();
  app->add_flag("--quick", arguments->quick, "fewer and shorter repetitions");
  app->add_option("--filter", arguments->filter,
                  "run only contenders whose job/family/name matches this regular expression");
  app->add_option("--plugin", arguments->plugin, "a shared library with a solver of yours");
  app->add_option("--format", arguments->format, "how to write the results (default: table)")
      ->check(CLI::IsMember({"table", "json", "tsv"}));
  app->add_option("--baseline", arguments->baseline,
                  "fail on more work, more error, and more time than this file says");
  CLI::Option* const update = app->add_flag("--update-baseline", arguments->update_baseline,
                                            "write what is better to the baseline");
  update->needs("--baseline");
  app->add_flag("--force", arguments->force, "with --update-baseline: what is worse, too")
      ->needs(update);
  return {app, [arguments](OutputStream& output) { return bench(*arguments, output); }};
}

}  // namespace tribo::cli
