// SPDX-License-Identifier: Apache-2.0
#include "bench_solver.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "conformance/timed_solver.hpp"
#include "options.hpp"
#include "page/project_files.hpp"
#include "progress.hpp"
#include "shell.hpp"

namespace tribo::cli {
namespace {

using namespace conformance;
using Clock = TimedSolver::Clock;

constexpr std::size_t cases_a_function = 32;
constexpr std::size_t starts = 3;  // of each solver: memory and hashes lie elsewhere after each
constexpr std::size_t least_laps = 3;
constexpr double longest_laps = 1;  // s, of a function and a start; the least laps may take longer

std::size_t laps_a_start(bool is_quick) { return is_quick ? least_laps : 5; }

// The name in rows: the command without folders, so that it is the same on other machines.
std::string name_of_solver(const std::string& given, bool is_plugin) {
  const auto without_folder = [](const std::string& word) {
    return word.substr(word.find_last_of('/') + 1);
  };
  if (is_plugin) {
    std::string stem = std::filesystem::path(given).stem().string();
    if (stem.starts_with("lib") && stem.size() > 3) stem.erase(0, 3);
    return stem;
  }
  std::istringstream words(given);
  std::string name;
  for (std::string word; words >> word;) name += (name.empty() ? "" : " ") + without_folder(word);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return (c >= 0 && c < ' ') || c == '\x7F'; }, ' ');
  return name;
}

std::string command_of(const std::string& given, bool is_plugin) {
  return is_plugin ? plugin_host_command(given, "--time") : given;
}

// One solver, its functions and their laps.
struct Measuring {
  std::string given, name, family;
  std::vector<TimedFunction> functions;
  std::vector<std::vector<Lap>> laps;  // of each function

  std::string key(const std::string& function) const {
    return fmt::format("{}/{}/{}", function, family, name);
  }
};

void check_startable(const SolverRun& run) {
  for (const std::string& given : run.solvers)
    check_solver(run.are_plugins ? given : "", run.are_plugins ? "" : given);
}

std::vector<Measuring> measurings(const SolverRun& run, const IsAsked& is_asked) {
  const report::ReferenceFiles files = report::reference_files("");
  const std::vector<TimedFunction> all =
      timed_functions(read_cases({files.exact, files.published}), cases_a_function);
  std::vector<Measuring> made;
  for (const std::string& given : run.solvers) {
    const char* const family = !made.empty() ? base_family : run.are_plugins ? "plugin" : "subject";
    made.push_back({given, name_of_solver(given, run.are_plugins), family, {}, {}});
  }
  for (const TimedFunction& function : all)
    if (std::ranges::any_of(made,
                            [&](const Measuring& one) { return is_asked(one.key(function.name)); }))
      for (Measuring& one : made) one.functions.push_back(function);
  if (!made[0].functions.empty()) return made;
  std::vector<std::string> names;
  for (const TimedFunction& function : all) names.push_back(function.name);
  throw std::invalid_argument(
      fmt::format("--filter: no row function/family/name matches; the functions are {}; the first "
                  "solver's rows are like {}",
                  fmt::join(names, ", "), made[0].key(names[0])));
}

// Calls `work`, and puts the solver's name before the text of a SolverFailed.
template <class Work>
auto named(const Measuring& solver, Work&& work) {
  try {
    return work();
  } catch (const SolverFailed& failure) {
    throw SolverFailed(fmt::format("{}: {}", solver.given, failure.what()), failure.exit_code);
  }
}

// Starts all solvers once and times laps. In each lap the solvers take turns at each function;
// every second lap has the opposite order.
class Start {
 public:
  Start(const SolverRun& run, std::vector<Measuring>& solvers, bool is_first,
        Clock::time_point deadline)
      : run_(run), solvers_(solvers) {
    for (Measuring& solver : solvers_) {
      named(solver, [&] {
        processes_.push_back(std::make_unique<TimedSolver>(
            command_of(solver.given, run.are_plugins), run.are_plugins, deadline));
        for (TimedFunction& function : solver.functions)
          processes_.back()->warm_up(function, is_first);
      });
      if (is_first) {
        std::erase_if(solver.functions,
                      [](const TimedFunction& function) { return function.answered == 0; });
        solver.laps.resize(solver.functions.size());
      }
    }
  }

  void measure(StepLine& progress) {
    std::set<std::string> names;
    for (const Measuring& solver : solvers_)
      for (const TimedFunction& function : solver.functions) names.insert(function.name);
    std::set<std::string> slow;
    for (std::size_t lap = 0; lap < laps_a_start(run_.is_quick); ++lap)
      for (const std::string& name : names) {
        if (lap >= least_laps && slow.contains(name)) continue;
        if (progress.is_due()) progress.show("timing " + name);
        const Clock::time_point begin = Clock::now();
        for (std::size_t i = 0; i < solvers_.size(); ++i)
          measure(lap % 2 == 0 ? i : solvers_.size() - 1 - i, name);
        const std::chrono::duration<double> spent = Clock::now() - begin;
        if (spent.count() * static_cast<double>(lap + 1) > longest_laps) slow.insert(name);
      }
  }

 private:
  void measure(std::size_t place, const std::string& name) {
    Measuring& solver = solvers_[place];
    for (std::size_t i = 0; i < solver.functions.size(); ++i)
      if (solver.functions[i].name == name)
        named(solver,
              [&] { solver.laps[i].push_back(processes_[place]->lap(solver.functions[i])); });
  }

  const SolverRun& run_;
  std::vector<Measuring>& solvers_;
  std::vector<std::unique_ptr<TimedSolver>> processes_;
};

template <class Value>
std::vector<double> all_of(const std::vector<Lap>& laps, Value&& value) {
  std::vector<double> all;
  for (const Lap& lap : laps) all.push_back(value(lap));
  return all;
}

BenchRow row_of(const Measuring& solver, std::size_t place, bool are_plugins) {
  const TimedFunction& function = solver.functions[place];
  const std::vector<Lap>& laps = solver.laps[place];
  const std::vector<double> own = all_of(laps, [](const Lap& lap) { return 1e9 * lap.own; });
  BenchRow row{function.name, solver.family, solver.name, ratio_of(own).median,
               *std::min_element(own.begin(), own.end())};
  row.over_control = ratio_of(all_of(laps, [](const Lap& lap) { return lap.own / lap.control; }));
  row.wall_ns = ratio_of(all_of(laps, [](const Lap& lap) { return 1e9 * lap.wall; })).median;
  row.cases = static_cast<double>(function.answered);
  row.measured = fmt::format("{} over {}", name_of(function.measured),
                             name_of(TimedSolver::control(are_plugins)));
  return row;
}

// The first solver's time over the second's, from laps that were measured beside each other. Empty
// if there is only one solver, or if the second does not have the function.
std::optional<Ratio> over_base(const std::vector<Measuring>& solvers, std::size_t place) {
  if (solvers.size() < 2) return std::nullopt;
  const std::string& name = solvers[0].functions[place].name;
  for (std::size_t i = 0; i < solvers[1].functions.size(); ++i) {
    if (solvers[1].functions[i].name != name) continue;
    std::vector<double> ratios;
    for (std::size_t k = 0; k < solvers[0].laps[place].size(); ++k)
      ratios.push_back(solvers[0].laps[place][k].own / solvers[1].laps[i][k].own);
    return ratio_of(std::move(ratios));
  }
  return std::nullopt;
}

}  // namespace

BenchResults measure_solvers(const SolverRun& run, const IsAsked& is_asked) {
  const Clock::time_point deadline = Clock::now() + milliseconds(run.timeout);
  check_startable(run);
  std::vector<Measuring> solvers = measurings(run, is_asked);
  {
    StepLine progress{std::chrono::seconds(1), std::chrono::milliseconds(200)};
    for (std::size_t start = 0; start < starts; ++start)
      Start(run, solvers, start == 0, deadline).measure(progress);
  }
  BenchResults results;
  results.is_of_solvers = true;
  if (solvers.size() > 1) results.base = solvers[1].given;
  for (const Measuring& solver : solvers)
    for (std::size_t i = 0; i < solver.functions.size(); ++i) {
      BenchRow row = row_of(solver, i, run.are_plugins);
      if (const double ratio = solver.functions[i].new_over_asked; ratio > kept_ratio)
        results.kept.push_back(fmt::format(
            "{}: answers are kept: a new case takes {:.2g} times as long as one that was "
            "asked before, and the time told is that of kept answers",
            row.key(), ratio));
      if (solver.family != base_family) row.over_base = over_base(solvers, i);
      const auto job = std::find_if(results.jobs.begin(), results.jobs.end(),
                                    [&](const BenchJob& known) { return known.title == row.job; });
      if (job == results.jobs.end())
        results.jobs.push_back({row.job, {std::move(row)}});
      else
        job->rows.push_back(std::move(row));
    }
  return results;
}

}  // namespace tribo::cli
