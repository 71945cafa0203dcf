// SPDX-License-Identifier: Apache-2.0
// model_stress compares the model in double with its templates in long double at many random
// points, and the worst points again with ball arithmetic. Exit code 1: a contract is broken.
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <thread>

#include "stress/tally.hpp"

namespace tribo::verification {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

struct Arguments {
  std::uint64_t points = 100000;
  std::uint64_t seed = 1;
  std::uint64_t first = 0;
  unsigned threads = 1;
  std::size_t worst = 1000;
  std::string out;
  std::string commit = "unknown";
};

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void run_threads(unsigned threads, const std::function<void(unsigned)>& work) {
  std::vector<std::thread> running;
  for (unsigned t = 1; t < threads; ++t)
    running.emplace_back([&work, t] {
      work(t);
      flint_cleanup();  // memory that Arb keeps for each thread
    });
  work(0);
  for (std::thread& thread : running) thread.join();
}

Tally tally_all(const Arguments& arguments, std::size_t suspects_a_row) {
  constexpr std::uint64_t chunk = 2000;
  std::vector<Tally> tallies(arguments.threads, Tally(suspects_a_row));
  std::atomic<std::uint64_t> next{0};
  const bool at_terminal = isatty(STDERR_FILENO) != 0;
  const auto start = Clock::now();
  run_threads(arguments.threads, [&](unsigned thread) {
    auto shown = start;
    while (true) {
      const std::uint64_t begin = next.fetch_add(chunk);
      if (begin >= arguments.points) break;
      const std::uint64_t end = std::min(begin + chunk, arguments.points);
      for (std::uint64_t i = arguments.first + begin; i < arguments.first + end; ++i)
        tallies[thread].add(i, evaluate(point_at(arguments.seed, i)));
      if (!at_terminal || thread != 0 || seconds_since(shown) < 0.5) continue;
      shown = Clock::now();
      const double part = static_cast<double>(end) / static_cast<double>(arguments.points);
      fmt::print(stderr, "\r{:5.1f} %, {:.0f} s to go   ", 100 * part,
                 seconds_since(start) * (1 - part) / part);
    }
  });
  if (at_terminal) fmt::print(stderr, "\r{:30}\r", "");
  for (unsigned t = 1; t < arguments.threads; ++t) tallies[0].merge(tallies[t]);
  return tallies[0];
}

std::vector<ProofTally> prove_all(const Arguments& arguments, const Tally& tally) {
  std::vector<std::vector<ProofTally>> proofs(arguments.threads);
  run_threads(arguments.threads, [&](unsigned thread) {
    proofs[thread] = prove(tally, arguments.seed, thread, arguments.threads);
  });
  for (unsigned t = 1; t < arguments.threads; ++t) merge(proofs[0], proofs[t]);
  return proofs[0];
}

bool has_held(const RowTally& row, const ProofTally& proof) {
  return row.cases > 0 && row.beyond_contract == 0 && row.not_a_number == 0 &&
         proof.beyond_contract == 0 &&
         proof.long_double_ulp_per_condition.value <= long_double_ulp_per_condition;
}

void print_table(const Tally& tally, const std::vector<ProofTally>& proofs) {
  fmt::print("{:38}{:>10}{:>11}{:>10}{:>13}{:>8}{:>6}   {:>6}{:>10}{:>9}{:>11}\n", "", "cases",
             "worst ulp", "/cond.", "contract", "beyond", "NaN", "again", "worst ulp", "/cond.",
             "long double");
  for (std::size_t i = 0; i < stress_rows; ++i) {
    const RowTally& row = tally.rows()[i];
    const ProofTally& proof = proofs[i];
    const Contract& contract = rows()[i].contract;
    fmt::print(
        "{:38}{:>10}{:>11.4g}{:>10.3g}{:>13}{:>8}{:>6}   {:>6}{:>10.4g}{:>9.3g}{:>11.3g}{}\n",
        rows()[i].name, row.cases, row.ulp.value, row.ulp_per_condition.value,
        contract.ulp_per_condition == 0
            ? fmt::format("{}", contract.ulp)
            : fmt::format("{} | {}c", contract.ulp, contract.ulp_per_condition),
        row.beyond_contract, row.not_a_number, proof.cases - proof.undecided, proof.ulp.value,
        proof.ulp_per_condition.value, proof.long_double_ulp_per_condition.value,
        has_held(row, proof) ? "" : "  BROKEN");
  }
}

Json as_json(const Arguments& arguments, const Worst& worst) {
  if (worst.index == no_point) return nullptr;
  Json inputs;
  for (const auto& [name, number] : inputs_of(point_at(arguments.seed, worst.index)))
    inputs[name] = Json::array({number, fmt::format("{:a}", number)});
  return {{"index", worst.index}, {"inputs", inputs}};
}

// JSON has no infinity: null stands for it.
Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

#ifdef __clang__
constexpr const char* compiler = "clang++ " __clang_version__;
#else
constexpr const char* compiler = "g++ " __VERSION__;
#endif

std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

Json as_json(const Arguments& arguments, const Tally& tally, const std::vector<ProofTally>& proofs,
             double seconds) {
  Json table = Json::array();
  for (std::size_t i = 0; i < stress_rows; ++i) {
    const RowTally& row = tally.rows()[i];
    const ProofTally& proof = proofs[i];
    Json entry{{"output", rows()[i].name},
               {"cases", row.cases},
               {"worst_ulp", number(row.ulp.value)},
               {"worst_ulp_at", as_json(arguments, row.ulp)},
               {"worst_ulp_per_condition", number(row.ulp_per_condition.value)},
               {"worst_ulp_per_condition_at", as_json(arguments, row.ulp_per_condition)},
               {"worst_part_of_bound", number(row.part_of_bound.value)},
               {"contract",
                {{"ulp", rows()[i].contract.ulp},
                 {"ulp_per_condition", rows()[i].contract.ulp_per_condition}}},
               {"beyond_contract", row.beyond_contract},
               {"not_a_number", row.not_a_number},
               {"in_balls",
                {{"cases", proof.cases},
                 {"undecided", proof.undecided},
                 {"worst_ulp", number(proof.ulp.value)},
                 {"worst_ulp_per_condition", number(proof.ulp_per_condition.value)},
                 {"beyond_contract", proof.beyond_contract},
                 {"worst_long_double_ulp_per_condition",
                  number(proof.long_double_ulp_per_condition.value)}}},
               {"held", has_held(row, proof)}};
    if (row.broken.index != no_point) entry["first_broken_at"] = as_json(arguments, row.broken);
    table.push_back(entry);
  }
  const std::time_t now = std::time(nullptr);
  return {{"what",
           "the model in double against its own text in long double; the worst points again "
           "in ball arithmetic"},
          {"commit", arguments.commit},
          {"date", fmt::format("{:%Y-%m-%d}", fmt::gmtime(now))},
          {"seconds", std::round(10 * seconds) / 10},
          {"environment", {{"compiler", compiler}, {"cpu", cpu_model()}}},
          {"points", arguments.points},
          {"seed", arguments.seed},
          {"threads", arguments.threads},
          {"outputs", table}};
}

// Prints everything about one point, for example one that breaks a contract.
void show(const Arguments& arguments) {
  const Point point = point_at(arguments.seed, arguments.first);
  for (const auto& [name, value] : inputs_of(point))
    fmt::print("{} = {} ({:a})\n", name, value, value);
  const Evaluation evaluation = evaluate(point);
  std::vector<Enclosure> truths;
  try {
    truths = enclose(point).numbers;
  } catch (const std::runtime_error& error) {
    fmt::print("no enclosure: {}\n", error.what());
  }
  for (std::size_t i = 0; i < evaluation.numbers.size(); ++i) {
    const Measured& at = evaluation.numbers[i];
    fmt::print("{:38} got {} ({:a}), long double {}, enclosed {}; condition {:.4g}",
               rows()[at.row].name, at.got, at.got, at.expected,
               truths.empty() ? "not" : truths[i].decimal(25), evaluation.condition(i));
    if (!truths.empty())
      fmt::print("; {:.4g} ulp, the long double {:.4g} of its own", error_in_ulp(at.got, truths[i]),
                 error_in_ulp(at.expected, truths[i]));
    fmt::print("\n");
  }
  if (evaluation.states_differ) fmt::print("states differ\n");
}

int stress(const Arguments& arguments) {
  const auto start = Clock::now();
  // Each row gets the same number of suspects.
  const std::size_t suspects = (arguments.worst + stress_rows - 1) / stress_rows;
  const Tally tally = tally_all(arguments, arguments.worst == 0 ? 0 : suspects);
  const std::vector<ProofTally> proofs = prove_all(arguments, tally);
  const double seconds = seconds_since(start);
  print_table(tally, proofs);
  bool held = true;
  std::uint64_t cases_held = 0;
  double greatest_part = 0;
  for (std::size_t i = 0; i < stress_rows; ++i) {
    const RowTally& row = tally.rows()[i];
    held = has_held(row, proofs[i]) && held;
    cases_held += row.cases - row.beyond_contract - row.not_a_number;
    greatest_part = std::max(greatest_part, row.part_of_bound.value);
    if (row.broken.index != no_point)
      fmt::print("{}: first broken at --first {} --points 0\n", rows()[i].name, row.broken.index);
  }
  fmt::print("{} points, seed {}, {:.1f} s on {} threads: {}\n", arguments.points, arguments.seed,
             seconds, arguments.threads, held ? "all contracts held" : "A CONTRACT IS BROKEN");
  fmt::print("Ran {} cases, the nearest at {:.3g} of its bound\n", cases_held, greatest_part);
  if (!arguments.out.empty()) {
    std::ofstream file(arguments.out);
    file << as_json(arguments, tally, proofs, seconds).dump(1) << '\n';
    if (!file.flush()) {
      fmt::print(stderr, "{}: cannot be written\n", arguments.out);
      return 2;
    }
  }
  return held ? 0 : 1;
}

}  // namespace
}  // namespace tribo::verification

int main(int argc, char** argv) {
  using namespace tribo::verification;
  CLI::App app("The model in double against its own text in long double, at random points.");
  Arguments arguments;
  app.add_option("--points", arguments.points, "how many; 0: show the one point --first")
      ->capture_default_str();
  app.add_option("--seed", arguments.seed, "of the points")->capture_default_str();
  app.add_option("--first", arguments.first, "index of the first point")->capture_default_str();
  app.add_option("--threads", arguments.threads, "they do not change the result")
      ->capture_default_str()
      ->check(CLI::Range(1U, 1024U));
  app.add_option("--worst", arguments.worst, "points that are repeated in ball arithmetic")
      ->capture_default_str();
  app.add_option("--out", arguments.out, "also write the table as JSON");
  app.add_option("--commit", arguments.commit, "for the JSON")->envname("TRIBOCHECK_COMMIT");
  app.footer(
      "Exit code 1: a contract is broken, or a number is missing.\n\n"
      "Example:\n  model_stress --points 1000000 --threads 2 --out stress.json");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (arguments.points == 0) {
    show(arguments);
    return 0;
  }
  return stress(arguments);
}
