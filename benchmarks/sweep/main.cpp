// SPDX-License-Identifier: Apache-2.0
// Prints the time per point of sweeps and its ratio to the time of preparation and kernels alone.
// Times are medians of interleaved repetitions. Takes Google Benchmark's options.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "contenders.hpp"
#include "workloads.hpp"

namespace {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

class Table : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }

  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      const std::string& name = run.run_name.function_name;
      if (run.error_occurred) {
        std::fputs(fmt::format("{}: {}\n", name, run.error_message).c_str(), stderr);
        has_failed_ = true;
        continue;
      }
      if (!rows_.contains(name)) names_.push_back(name);
      Row& row = rows_[name];
      row.is_on_threads = run.counters.contains(std::string(tribo::benchmarks::threads_counter));
      const double time = row.is_on_threads ? run.GetAdjustedRealTime() : run.GetAdjustedCPUTime();
      row.ns.push_back(time / run.counters.at("points").value);
    }
  }

  bool has_failed() const { return has_failed_; }

  void Finalize() override {
    std::string text;
    for (const auto& workload : tribo::benchmarks::workloads()) {
      const auto alone = rows_.find(workload.name + '/' + std::string(tribo::benchmarks::alone));
      text += fmt::format("\n{}: {}\n{:34}{:>12}{:>10}{:>10}\n", workload.name, workload.what, "",
                          "ns a point", "/ alone", "least ns");
      for (const std::string& name : names_) {
        if (!name.starts_with(workload.name + '/')) continue;
        const Row& row = rows_.at(name);
        const double ns = median(row.ns);
        text += fmt::format(
            "{:34}{:12.2f}{:>10}{:10.2f}{}\n", name.substr(workload.name.size() + 1), ns,
            alone == rows_.end() ? "" : fmt::format("{:.2f}", ns / median(alone->second.ns)),
            *std::min_element(row.ns.begin(), row.ns.end()),
            row.is_on_threads ? "  by the clock" : "");
      }
    }
    std::fputs(text.c_str(), stdout);
  }

 private:
  struct Row {
    bool is_on_threads = false;
    std::vector<double> ns;
  };
  std::vector<std::string> names_;
  std::map<std::string, Row> rows_;
  bool has_failed_ = false;
};

}  // namespace

int main(int count, char** arguments) {
  // The user's options come after these options, so they win.
  std::vector<std::string> options{arguments[0], "--benchmark_repetitions=9",
                                   "--benchmark_enable_random_interleaving=true",
                                   "--benchmark_min_time=0.05"};
  options.insert(options.end(), arguments + 1, arguments + count);
  std::vector<char*> all;
  for (std::string& option : options) all.push_back(option.data());
  int all_count = static_cast<int>(all.size());
  all.push_back(nullptr);
  benchmark::Initialize(&all_count, all.data());
  if (benchmark::ReportUnrecognizedArguments(all_count, all.data())) return 2;
  const bool is_table = std::none_of(arguments + 1, arguments + count, [](const char* option) {
    return std::strstr(option, "--benchmark_format=") != nullptr;
  });
  tribo::benchmarks::register_sweeps();
  Table table;
  benchmark::RunSpecifiedBenchmarks(is_table ? &table : nullptr);
  benchmark::Shutdown();
  return table.has_failed() ? 1 : 0;
}
