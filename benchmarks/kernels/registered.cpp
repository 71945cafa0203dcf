// SPDX-License-Identifier: Apache-2.0
#include "kernels/registered.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <memory>
#include <optional>
#include <utility>

namespace tribo::benchmarks {
namespace {

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

std::vector<std::string>& names() {
  static std::vector<std::string> all;
  return all;
}

}  // namespace

void show_progress(std::string_view step) {
  static const bool is_watched = ::isatty(STDERR_FILENO) != 0;
  if (!is_watched) return;
  const std::string line = fmt::format("\r{}\033[K", step);
  std::fwrite(line.data(), 1, line.size(), stderr);
}

const std::vector<std::string>& registered_names() { return names(); }

void register_benchmark(Measured measured) {
  const std::string name = measured.job + "/" + measured.family + "/" + measured.name;
  names().push_back(name);
  const bool elsewhere = static_cast<bool>(measured.own_seconds);
  const auto shared = std::make_shared<Benchmark>(std::move(measured));
  auto* const registered = benchmark::RegisterBenchmark(
      name.c_str(), [shared](benchmark::State& state) { (*shared)(state); });
  if (elsewhere) registered->UseManualTime();
}

}  // namespace tribo::benchmarks
