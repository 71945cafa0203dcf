// SPDX-License-Identifier: Apache-2.0
// All contenders in one Google Benchmark program: job/family/name. `tribocheck bench` runs it and
// makes the table.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstring>
#include <iostream>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "kernels/progress.hpp"
#include "kernels/registered.hpp"

namespace {

// Debian builds Google Benchmark with its assertions, and it then calls itself DEBUG. Only its own
// bookkeeping around the timed loop is slower for it: what is timed here is built as Release.
class Console : public benchmark::ConsoleReporter {
 public:
  bool ReportContext(const Context& context) override {
    name_field_width_ = context.name_field_width;
    std::cerr << "CPU time of contenders built with -O3; counters are a point's\n";
    return true;
  }
};

bool asks_for_another_format(int count, char** arguments) {
  for (int i = 1; i < count; ++i)
    if (std::strstr(arguments[i], "--benchmark_format=") != nullptr) return true;
  return false;
}

// Google Benchmark takes the filter as an extended regular expression, and a leading - as "not".
bool matches_any(std::string filter) {
  const bool is_negative = filter.starts_with('-');
  if (is_negative) filter.erase(0, 1);
  if (filter.empty() || filter == "all") return true;
  const std::regex expression(filter, std::regex::extended);
  const std::vector<std::string>& names = tribo::benchmarks::registered_names();
  return std::any_of(names.begin(), names.end(), [&](const std::string& name) {
    return std::regex_search(name, expression) != is_negative;
  });
}

}  // namespace

int main(int count, char** arguments) {
  const bool is_console = !asks_for_another_format(count, arguments);
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  using namespace tribo::benchmarks;
  for (const auto& [job, title] : job_titles()) benchmark::AddCustomContext(job, title);
  for (Measured& measured : all_jobs(Settings::usual)) register_benchmark(std::move(measured));
  if (!matches_any(benchmark::GetBenchmarkFilter())) {
    if (is_console) std::cerr << "tribocheck_bench: no contender matches the filter\n";
    return 2;
  }
  Console console;
  benchmark::RunSpecifiedBenchmarks(is_console ? &console : nullptr);
  show_progress("");
  benchmark::Shutdown();
  return 0;
}
