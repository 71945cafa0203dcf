// SPDX-License-Identifier: Apache-2.0
// tribocheck_gate_kernels measures our kernels for the gates (gate.py). Each mode but --environment
// prints lines of tab-separated columns, of which the first two are workload and instruction set.
#include <fmt/format.h>
#include <gnu/libc-version.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "gates/workloads.hpp"
#include "tribo/batch.hpp"

// Callgrind finds a pass by this name.
extern "C" [[gnu::noinline]] void tribocheck_gate_pass(const std::function<void()>& pass) {
  pass();
  asm volatile("");  // prevents a tail call, in which a jump takes the place of the call
}

namespace tribo::gates {
namespace {

struct Chosen {
  const Workload* workload;
  std::string set;
};

// All workloads, and vector workloads on each instruction set. `only` selects a workload by name.
// `set` selects the instruction set of vector workloads. An empty string selects all.
std::vector<Chosen> chosen(const std::string& only, const std::string& set) {
  std::vector<Chosen> all;
  for (const Workload& workload : workloads()) {
    if (!only.empty() && workload.name != only) continue;
    if (!workload.is_vector) {
      all.push_back({&workload, std::string(arithmetic())});
      continue;
    }
    for (const std::string_view name : instruction_sets())
      if (set.empty() || name == set) all.push_back({&workload, std::string(name)});
  }
  return all;
}

void use(const Chosen& one) {
  use_instruction_set(one.workload->is_vector ? one.set : instruction_sets().front());
}

void print_counters(const std::vector<Chosen>& all) {
  for (const Chosen& one : all) {
    if (!one.workload->count) continue;
    use(one);
    for (const auto& [name, count] : one.workload->count())
      fmt::print("{}\t{}\t{}\t{}\n", one.workload->name, one.set, name, count);
  }
}

// Each workload runs once beforehand, so that the extra work of a first call is not counted.
void run_passes(const std::vector<Chosen>& all, int passes) {
  for (const Chosen& one : all) {
    use(one);
    one.workload->run();
    for (int i = 0; i < passes; ++i) tribocheck_gate_pass(one.workload->run);
    fmt::print("{}\t{}\t{}\n", one.workload->name, one.set, passes);
  }
}

double cpu_seconds() {
  std::timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds_of(const std::function<void()>& pass, int passes) {
  const double start = cpu_seconds();
  for (int i = 0; i < passes; ++i) pass();
  return (cpu_seconds() - start) / passes;
}

// A number of passes that together take at least 3 ms.
int passes_for(const std::function<void()>& pass) {
  constexpr double least = 3e-3;
  int passes = 1;
  while (seconds_of(pass, passes) * passes < least) passes *= 2;
  return passes;
}

// In each repetition, the control kernel is timed before and after each workload.
void print_times(const std::vector<Chosen>& all, int repetitions) {
  const int control_passes = passes_for(run_control);
  std::vector<int> passes;
  for (const Chosen& one : all) {
    use(one);
    passes.push_back(passes_for(one.workload->run));
  }
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    double before = seconds_of(run_control, control_passes);
    for (std::size_t i = 0; i < all.size(); ++i) {
      use(all[i]);
      const double seconds = seconds_of(all[i].workload->run, passes[i]);
      const double after = seconds_of(run_control, control_passes);
      fmt::print("{}\t{}\t{:.6g}\t{:.6g}\t{:.6g}\n", all[i].workload->name, all[i].set, seconds,
                 before, after);
      before = after;
    }
  }
}

// The build of this program, and the machine that it runs on.
void print_environment() {
#ifdef __clang__
  fmt::print("compiler\t{}\n", __VERSION__);
#else
  fmt::print("compiler\tg++ {}\n", __VERSION__);
#endif
  fmt::print("libc\tglibc {}\n", ::gnu_get_libc_version());
  fmt::print("scalar\t{}\n", arithmetic());
  for (const std::string_view set : instruction_sets()) fmt::print("vector\t{}\n", set);
}

}  // namespace
}  // namespace tribo::gates

int main(int count, char** argv) {
  using namespace tribo::gates;
  std::string only, set;
  int passes = 0, repetitions = 0;
  bool counters = false, environment = false;
  CLI::App program(
      "Fixed work of the model's kernels, for gate.py\n\n"
      "Example: tribocheck_gate_kernels --counters --workload root_wide_batch");
  auto* modes = program.add_option_group("mode")->require_option(1);
  modes->add_flag("--counters", counters, "exact counts of the work of one pass");
  modes->add_option("--run", passes, "so many passes, for callgrind")
      ->check(CLI::Range(0, 1000000));
  modes->add_option("--time", repetitions, "CPU seconds of a pass and of one of the control kernel")
      ->check(CLI::Range(1, 100000));
  modes->add_flag("--environment", environment, "compiler, C library and instruction sets");
  program.add_option("--workload", only, "this one alone");
  program.add_option("--set", set, "batches on this instruction set alone");
  try {
    program.parse(count, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : 2;
  }
  if (environment) {
    print_environment();
    return 0;
  }
  const auto all = chosen(only, set);
  if (all.empty()) {
    fmt::print(stderr, "tribocheck_gate_kernels: no workload {} on {}; --counters lists them\n",
               only.empty() ? "at all" : only, set.empty() ? "any instruction set" : set);
    return 2;
  }
  if (counters)
    print_counters(all);
  else if (repetitions > 0)
    print_times(all, repetitions);
  else
    run_passes(all, passes);
  return 0;
}
