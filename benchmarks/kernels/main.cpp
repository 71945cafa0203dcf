// SPDX-License-Identifier: Apache-2.0
// Runs all contenders in one Google Benchmark program; its benchmarks are named job/family/name.
// `tribocheck bench` runs this program and makes the table.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <memory>
#include <optional>
#include <regex>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cases/jobs.hpp"
#include "conformance/plugin.hpp"
#include "conformance/serve.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::benchmarks {
namespace {

constexpr int exit_plugin_refused = 3;

// Shows a step in one line of stderr, which the next step overwrites. An empty step clears the
// line. Nothing is shown if stderr is not a terminal.
void show_progress(std::string_view step) {
  static const bool is_watched = ::isatty(STDERR_FILENO) != 0;
  if (!is_watched) return;
  const std::string line = fmt::format("\r{}\033[K", step);
  std::fwrite(line.data(), 1, line.size(), stderr);
}

// Values that are the same in all repetitions, found once outside of the timed loop.
class Known {
 public:
  explicit Known(const Measured& measured) {
    if (measured.judge) errors = measured.judge();
    if (measured.evaluations) evaluations = measured.evaluations();
  }
  void count_in(benchmark::State& state) const {
    if (errors && errors->judged > 0) {
      state.counters["judged"] = static_cast<double>(errors->judged);
      state.counters["failures"] = static_cast<double>(errors->failures);
      state.counters["max_ulp"] = errors->max_ulp;
      state.counters["p99_ulp"] = errors->p99_ulp;
      state.counters["mean_ulp"] = errors->mean_ulp;
    }
    if (evaluations) state.counters["evaluations"] = *evaluations;
  }

 private:
  std::optional<Errors> errors;
  std::optional<double> evaluations;
};

class Benchmark {
 public:
  explicit Benchmark(Measured measured) : measured_(std::move(measured)) {}

  void operator()(benchmark::State& state) {
    show_progress(measured_.job + ", " + measured_.family + ", " + measured_.name);
    try {
      if (!known_) known_ = std::make_unique<Known>(measured_);
      for (const auto _ : state) {
        measured_.run();
        if (measured_.own_seconds) state.SetIterationTime(measured_.own_seconds());
      }
      known_->count_in(state);
    } catch (const std::exception& error) {
      state.SkipWithError(error.what());
    }
    state.counters["points"] = static_cast<double>(measured_.points);
  }

 private:
  Measured measured_;
  std::unique_ptr<Known> known_;
};

// The names of all registered contenders, as the library has them: "job/family/name", and
// "job/family/name/manual_time" where another process is timed.
std::vector<std::string>& registered_names() {
  static std::vector<std::string> all;
  return all;
}

void register_benchmark(Measured measured) {
  const std::string name = measured.job + "/" + measured.family + "/" + measured.name;
  const bool elsewhere = static_cast<bool>(measured.own_seconds);
  registered_names().push_back(elsewhere ? name + "/manual_time" : name);
  const auto shared = std::make_shared<Benchmark>(std::move(measured));
  auto* const registered = benchmark::RegisterBenchmark(
      name.c_str(), [shared](benchmark::State& state) { (*shared)(state); });
  if (elsewhere) registered->UseManualTime();
}

// A console reporter without the library's warning that the library is a DEBUG build. Debian builds
// it with assertions, which slow only the library's own work around the timed loop.
class Console : public benchmark::ConsoleReporter {
 public:
  bool ReportContext(const Context& context) override {
    name_field_width_ = context.name_field_width;
    std::cerr
        << "CPU time of one call for `points` points, contenders built with -O3; `evaluations` are "
           "per point\n";
    return true;
  }
};

bool asks_for(std::string_view option, int count, char** arguments) {
  for (int i = 1; i < count; ++i)
    if (option == arguments[i]) return true;
  return false;
}

bool asks_for_another_format(int count, char** arguments) {
  for (int i = 1; i < count; ++i)
    if (std::strstr(arguments[i], "--benchmark_format=") != nullptr) return true;
  return false;
}

// Google Benchmark reads the filter as an extended regular expression, which a leading '-' negates.
bool matches_any(std::string filter, std::span<const std::string> names) {
  if (filter.empty() || filter == "all") return !names.empty();
  const bool is_negative = filter.starts_with('-');
  if (is_negative) filter.erase(0, 1);
  const std::regex expression(filter, std::regex::extended);
  return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
    return std::regex_search(name, expression) != is_negative;
  });
}

// The plug-in of --plugin=LIBRARY. This option is taken out of the arguments.
std::optional<std::string> take_plugin(int& count, char** arguments) {
  constexpr std::string_view option = "--plugin=";
  std::optional<std::string> path;
  int kept = 0;
  for (int i = 0; i < count; ++i)
    if (i > 0 && std::string_view(arguments[i]).starts_with(option))
      path = arguments[i] + option.size();
    else
      arguments[kept++] = arguments[i];
  count = kept;
  return path;
}

void register_all(std::vector<Measured> jobs) {
  for (Measured& measured : jobs) register_benchmark(std::move(measured));
}

// Writes a text in one piece.
void write_whole(int output, const std::string& text) {
  std::FILE* const file = ::fdopen(output, "w");
  if (file == nullptr) return;
  std::fwrite(text.data(), 1, text.size(), file);
  std::fclose(file);
}

// Runs the benchmarks and writes their JSON in one piece, so that the output of a plug-in cannot
// get into it.
void run_as_json(int output) {
  std::ostringstream text;
  benchmark::JSONReporter reporter;
  reporter.SetOutputStream(&text);
  reporter.SetErrorStream(&std::cerr);
  benchmark::RunSpecifiedBenchmarks(&reporter);
  write_whole(output, text.str());
}

// A plug-in can end this process with any exit code. A program that asked for JSON therefore reads
// the reason from the line that this function writes, and does not trust the exit code.
int refuse(int code, const std::string& why, int output) {
  if (output >= 0)
    write_whole(output, why + '\n');
  else
    std::cerr << "tribocheck_bench: " << printable(why, std::string::npos) << '\n';
  return code;
}

// Registers the jobs that the plug-in offers. Throws PluginRefused if the plug-in cannot be loaded
// or offers no job, or if the filter leaves out all of its jobs.
void register_plugin(const std::string& path) {
  const std::size_t before = registered_names().size();
  register_all(plugin_jobs(conformance::load_plugin(path)));
  const std::span<const std::string> names = std::span(registered_names()).subspan(before);
  if (names.empty())
    throw conformance::PluginRefused(path + ": it offers none of the jobs of bench");
  if (!matches_any(benchmark::GetBenchmarkFilter(), names))
    throw conformance::PluginRefused(path + ": the filter leaves it out; its first row is " +
                                     names.front());
}

}  // namespace
}  // namespace tribo::benchmarks

int main(int count, char** arguments) {
  using namespace tribo::benchmarks;
  const std::optional<std::string> plugin = take_plugin(count, arguments);
  const bool is_json = asks_for("--benchmark_format=json", count, arguments);
  const bool is_console = !asks_for_another_format(count, arguments);
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  for (const auto& [job, title] : job_titles()) benchmark::AddCustomContext(job, title);
  register_all(all_jobs(Settings::usual));
  const int output = is_json ? tribo::conformance::take_stdout() : -1;
  try {
    if (plugin) register_plugin(*plugin);
    if (!matches_any(benchmark::GetBenchmarkFilter(), registered_names()))
      return refuse(2, "no contender matches the filter", output);
  } catch (const tribo::conformance::PluginRefused& refusal) {
    return refuse(exit_plugin_refused, std::string("refused: ") + refusal.what(), output);
  } catch (const std::regex_error&) {
    return refuse(2, "the filter is no regular expression", output);
  }
  Console console;
  if (is_json)
    run_as_json(output);
  else
    benchmark::RunSpecifiedBenchmarks(is_console ? &console : nullptr);
  show_progress("");
  benchmark::Shutdown();
  return 0;
}
