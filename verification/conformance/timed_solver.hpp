// SPDX-License-Identifier: Apache-2.0
// The time that a solver needs for cases of one function. The solver is a subject, which answers
// JSON lines, or a plug-in, whose calls are timed in a process of its own (plugin_timing.hpp).
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "conformance/child_process.hpp"
#include "conformance/conformance_case.hpp"
#include "conformance/cpu_time.hpp"

namespace tribo::conformance {

// How the time of a solver is measured.
enum class Measured : std::uint8_t {
  reported,     // "seconds" of each answer
  process_cpu,  // CPU time of the subject's processes, from the first question of a block to its
                // end
  call_cpu,     // CPU time of a plug-in's calls
};
const char* name_of(Measured measured);  // "reported", "process", "calls"

// The cases of one function that are timed, and the state of their measurement.
struct TimedFunction {
  std::string name;
  std::vector<TestCase> cases;  // after the first pass of a subject: only those with an answer
  Measured measured = Measured::call_cpu;
  std::size_t answered = 0;  // cases with an answer; 0: the function is not offered
  std::size_t passes = 1;    // over the cases in a lap, enough for some milliseconds
  // The time of a new case over the time of a case that was asked before; 0: not measured.
  double new_over_asked = 0;
};

// At most `most` cases of each function in the order of the table, spread evenly over those that
// are not extreme, or over all if every case is extreme.
std::vector<TimedFunction> timed_functions(const std::vector<TestCase>& cases, std::size_t most);

// Above this `new_over_asked` the solver is said to keep its answers, as a cache does. Nothing else
// makes a repeated case so much faster than a case that differs from it by a part in 1e9.
inline constexpr double kept_ratio = 2;

struct Lap {
  double own = 0;      // s a case, of the solver
  double control = 0;  // s a unit of the control: mean of before and after
  double wall = 0;     // s a case, by the clock
};

// The reason why a solver cannot be timed, in one line.
struct SolverFailed : std::runtime_error {
  SolverFailed(const std::string& what, int code) : std::runtime_error(what), exit_code(code) {}
  int exit_code;  // of this program: 2 where the solver cannot be started
};

// One process of a solver.
class TimedSolver {
 public:
  using Clock = std::chrono::steady_clock;

  // Starts the command in a shell. No wait lasts beyond `deadline`.
  TimedSolver(const std::string& command, bool is_plugin, Clock::time_point deadline);

  // Asks a subject all cases, which warms it up. With `is_first`, in the first process, this also
  // finds which cases have an answer, how time is measured, and the passes of a lap. A plug-in is
  // asked only with `is_first`.
  void warm_up(TimedFunction& function, bool is_first);
  // Throws SolverFailed, as warm_up() does.
  Lap lap(const TimedFunction& function);
  static Control control(bool is_plugin) {
    return is_plugin ? Control::exponentials : Control::texts;
  }

 private:
  struct Pass {
    std::vector<bool> has_answer;
    std::size_t answered = 0, reporting = 0;
    double reported = 0;
  };
  // `change`: one number of each case is greater by so many parts in 1e9.
  Pass ask(const TimedFunction& function, std::size_t passes, std::size_t change = 0);
  double cpu_seconds_of(const TimedFunction& function, std::size_t change);
  void compare_new_with_asked(TimedFunction& function, double seconds_a_case);
  nlohmann::json ask_plugin(const TimedFunction& function);
  std::string next_answer(const TimedFunction& function);
  [[noreturn]] void fail(const std::string& why, const TimedFunction& function);

  bool is_plugin_;
  Clock::time_point deadline_;
  bool has_answered_ = false;
  std::unique_ptr<ChildProcess> process_;
};

}  // namespace tribo::conformance
