// SPDX-License-Identifier: Apache-2.0
#include "conformance/timed_solver.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>
#include <system_error>

#include "conformance/conversation.hpp"
#include "conformance/plugin_timing.hpp"

namespace tribo::conformance {
namespace {

using nlohmann::json;

constexpr std::chrono::seconds longest_answer{60};
constexpr double enough = 1e-2;  // s, least time of a lap
constexpr std::size_t most_passes = 1000;
constexpr unsigned microseconds_between_looks = 500;
constexpr int exit_failed = 1, exit_bad = 2;

constexpr std::size_t least_pairs = 5, most_pairs = 15;
constexpr double longest_pass = 2e-2;  // s, for comparing new cases with asked ones

// The inputs of the case, made new: one number is greater by `change` parts in 1e9.
json changed_inputs(const TestCase& one, std::size_t change) {
  json inputs = one.inputs;
  if (change == 0) return inputs;
  std::string name = "load";  // of a scene
  if (one.in_catalogue != nullptr)
    name = one.in_catalogue->parameters[varied_parameter(*one.in_catalogue)].name;
  json& number = inputs[name];
  if (number.is_number()) number = number.get<double>() * (1 + 1e-9 * static_cast<double>(change));
  return inputs;
}

}  // namespace

const char* name_of(Measured measured) {
  if (measured == Measured::reported) return "reported";
  return measured == Measured::process_cpu ? "process" : "calls";
}

std::vector<TimedFunction> timed_functions(const std::vector<TestCase>& cases, std::size_t most) {
  std::vector<TimedFunction> all;
  for (const TestCase& one : cases)
    if (std::none_of(all.begin(), all.end(),
                     [&](const TimedFunction& known) { return known.name == one.function; }))
      all.push_back({one.function, {}});
  for (TimedFunction& function : all) {
    std::vector<const TestCase*> usual, any;
    for (const TestCase& one : cases) {
      if (one.function != function.name) continue;
      any.push_back(&one);
      if (!one.is_extreme) usual.push_back(&one);
    }
    const std::vector<const TestCase*>& chosen = usual.empty() ? any : usual;
    const std::size_t count = std::min(most, chosen.size());
    for (std::size_t i = 0; i < count; ++i)
      function.cases.push_back(*chosen[i * chosen.size() / count]);
  }
  return all;
}

TimedSolver::TimedSolver(const std::string& command, bool is_plugin, Clock::time_point deadline)
    : is_plugin_(is_plugin), deadline_(deadline) {
  try {
    process_ = std::make_unique<ChildProcess>(std::vector<std::string>{"/bin/sh", "-c", command},
                                              ChildProcess::Pipes::all);
  } catch (const std::system_error& error) {
    throw SolverFailed(error.what(), exit_failed);
  }
}

void TimedSolver::fail(const std::string& why, const TimedFunction& function) {
  const int code = process_->exit_code();
  process_->kill();
  const std::string said = last_line(process_->last_errors());
  const bool is_bad =
      !has_answered_ && (code == 126 || code == 127 || (is_plugin_ && code == exit_bad));
  if (is_bad) throw SolverFailed(said.empty() ? "it cannot be started" : said, exit_bad);
  throw SolverFailed(fmt::format("it {} at {}{}", why, function.name,
                                 said.empty() ? "" : "; its last line on stderr: " + said),
                     exit_failed);
}

// The next line that begins with {. Other lines are skipped.
std::string TimedSolver::next_answer(const TimedFunction& function) {
  const Clock::time_point last = std::min(deadline_, Clock::now() + longest_answer);
  std::string line;
  while (true) {
    const auto left = std::chrono::duration_cast<ChildProcess::Time>(last - Clock::now());
    if (left.count() <= 0)
      fail(deadline_ <= last
               ? "is stopped, as --timeout is over,"
               : fmt::format("gives no answer within {} s, or does not flush its answers,",
                             longest_answer.count()),
           function);
    // Waking a reader costs the writer time. So this reader sleeps, and then reads all lines.
    if (process_->lines_at_hand() == 0) ::usleep(microseconds_between_looks);
    switch (process_->next_line(line, std::min(left, ChildProcess::Time(1)))) {
      case ChildProcess::Event::line:
        if (line.starts_with('{')) return line;
        break;
      case ChildProcess::Event::too_long_line:
        fail("writes a line over 1 MiB", function);
      case ChildProcess::Event::end_of_output:
        // The pipe closes a moment before the process is gone.
        for (int i = 0; i < 100 && !process_->has_ended(); ++i) ::usleep(5000);
        fail(process_->has_ended() ? process_->end_text() : "closes its output", function);
      case ChildProcess::Event::nothing:
        break;
    }
  }
}

TimedSolver::Pass TimedSolver::ask(const TimedFunction& function, std::size_t passes,
                                   std::size_t change) {
  std::size_t number = 0;
  for (std::size_t pass = 0; pass < passes; ++pass)
    for (const TestCase& one : function.cases) {
      json request = changed_inputs(one, change);
      request["id"] = std::to_string(number++);
      process_->send(request.dump());
    }
  Pass found;
  for (std::size_t i = 0; i < number; ++i) {
    json answer;
    do answer = read_answer_line(next_answer(function));
    while (!answer.is_object() || !answer.contains("id"));
    has_answered_ = true;
    if (answer["id"] != std::to_string(i) && answer["id"] != i)
      fail("answers in another order than it was asked", function);
    const bool has_answer = !answer.contains("skip") && !answer.contains("error");
    found.has_answer.push_back(has_answer);
    if (!has_answer) continue;
    ++found.answered;
    const auto seconds = answer.find("seconds");
    if (seconds == answer.end() || !seconds->is_number()) continue;
    ++found.reporting;
    found.reported += seconds->get<double>();
  }
  return found;
}

json TimedSolver::ask_plugin(const TimedFunction& function) {
  for (const TestCase& one : function.cases) process_->send(one.line());
  process_->send("");
  json answer = read_answer_line(next_answer(function));
  has_answered_ = true;
  if (!answer.is_object() || answer.contains("error"))
    fail("cannot be timed: " + start_of(answer.dump()), function);
  return answer;
}

double TimedSolver::cpu_seconds_of(const TimedFunction& function, std::size_t change) {
  const double before = cpu_seconds_of_tree(process_->guard_id());
  const Pass pass = ask(function, 1, change);
  const double spent = cpu_seconds_of_tree(process_->guard_id()) - before;
  return function.measured == Measured::reported ? pass.reported : spent;
}

// Asks new cases and the same again in turns, so that a disturbance affects both alike.
void TimedSolver::compare_new_with_asked(TimedFunction& function, double seconds_a_case) {
  TimedFunction some = function;
  const double most = std::max(1.0, longest_pass / std::max(seconds_a_case, 1e-9));
  if (most < static_cast<double>(some.cases.size()))
    some.cases.resize(static_cast<std::size_t>(most));
  const std::size_t pairs = std::clamp(function.passes, least_pairs, most_pairs);
  std::vector<double> ratios;
  for (std::size_t change = 1; change <= pairs; ++change) {
    const double fresh = cpu_seconds_of(some, change), asked = cpu_seconds_of(some, change);
    ratios.push_back(fresh / std::max(asked, 1e-9));
  }
  function.new_over_asked = boost::math::statistics::median(ratios);
}

void TimedSolver::warm_up(TimedFunction& function, bool is_first) {
  if (is_plugin_) {
    if (!is_first) return;
    const json answer = ask_plugin(function);
    function.answered = answer.value("answered", std::size_t{0});
    function.new_over_asked = answer.value("new_over_asked", 0.0);
    return;
  }
  const Pass first = ask(function, 1);
  if (!is_first) return;
  std::vector<TestCase> answered;
  for (std::size_t i = 0; i < function.cases.size(); ++i)
    if (first.has_answer[i]) answered.push_back(std::move(function.cases[i]));
  function.cases = std::move(answered);
  function.answered = first.answered;
  if (function.cases.empty()) return;
  const double before = cpu_seconds_of_tree(process_->guard_id());
  const Pass pass = ask(function, 1);
  const double spent = cpu_seconds_of_tree(process_->guard_id()) - before;
  const bool reports = pass.reporting == pass.answered && pass.reported > 0;
  function.measured = reports ? Measured::reported : Measured::process_cpu;
  const double passes = std::ceil(enough / std::max(spent, 1e-6));
  function.passes =
      static_cast<std::size_t>(std::clamp(passes, 1.0, static_cast<double>(most_passes)));
  compare_new_with_asked(function, spent / static_cast<double>(function.answered));
}

Lap TimedSolver::lap(const TimedFunction& function) {
  if (is_plugin_) {
    const json answer = ask_plugin(function);
    if (answer.value("answered", std::size_t{0}) != function.answered)
      fail("answers another number of cases than before", function);
    return {answer.at("seconds"), answer.at("control"), answer.at("wall")};
  }
  const double control_before = control_seconds(control(false));
  const double cpu_before = cpu_seconds_of_tree(process_->guard_id());
  const Clock::time_point start = Clock::now();
  const Pass pass = ask(function, function.passes);
  const std::chrono::duration<double> wall = Clock::now() - start;
  const double cpu = cpu_seconds_of_tree(process_->guard_id()) - cpu_before;
  const double control_after = control_seconds(control(false));
  if (pass.answered != function.answered * function.passes)
    fail("answers another number of cases than before", function);
  const bool reports = function.measured == Measured::reported;
  if (reports && pass.reporting != pass.answered)
    fail("reports \"seconds\" in some answers, and not in others,", function);
  const auto asked = static_cast<double>(function.cases.size() * function.passes);
  return {(reports ? pass.reported : cpu) / asked, (control_before + control_after) / 2,
          wall.count() / asked};
}

}  // namespace tribo::conformance
