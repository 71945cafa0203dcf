// SPDX-License-Identifier: Apache-2.0
#include "conformance/busy_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "conformance/child_process.hpp"

namespace tribo::conformance {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t cases_in_a_row = 20;  // cases of a function in a row
constexpr std::size_t lines_ahead = 256;    // lines asked and not yet answered
constexpr std::chrono::milliseconds glance{100};
constexpr std::size_t kept_error_lines = 5;
constexpr const char* endless_line = "writes a line that does not end";

// An endless stream of questions: some lines of each function, then the next lines of each.
class QuestionStream {
 public:
  explicit QuestionStream(const std::vector<TestCase>& cases) {
    std::map<std::string, std::size_t> places;
    for (const TestCase& one : cases) {
      const auto [place, is_new] = places.try_emplace(one.function, functions_.size());
      if (is_new) functions_.emplace_back();
      functions_[place->second].push_back(one.line());
    }
    for (const std::vector<std::string>& lines : functions_)
      round_ += std::min(lines.size(), cases_in_a_row);
  }

  std::size_t round() const { return round_; }  // the number of its lines

  const std::string& next() {
    const std::vector<std::string>& lines = functions_[function_];
    const std::string& line = lines[(block_ * cases_in_a_row + in_block_) % lines.size()];
    if (++in_block_ == std::min(lines.size(), cases_in_a_row)) {
      in_block_ = 0;
      if (++function_ == functions_.size()) {
        function_ = 0;
        ++block_;
      }
    }
    return line;
  }

 private:
  std::vector<std::vector<std::string>> functions_;
  std::size_t round_ = 0, function_ = 0, block_ = 0, in_block_ = 0;
};

std::vector<std::string> last_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (!line.empty()) lines.push_back(line);
  if (lines.size() > kept_error_lines)
    lines.erase(lines.begin(), lines.end() - static_cast<std::ptrdiff_t>(kept_error_lines));
  return lines;
}

class Run {
 public:
  Run(const std::vector<std::string>& command, const std::vector<TestCase>& cases,
      const BusySettings& settings)
      : settings_(settings),
        questions_(cases),
        child_(command, ChildProcess::Pipes::all),
        end_(Clock::now() + settings.limit) {}

  BusyRun run() {
    while (goes_on()) step();
    if (goes_well()) finish();
    child_.kill();
    if (!run_.failure.empty()) run_.error_lines = last_lines(child_.last_errors());
    return std::move(run_);
  }

 private:
  bool goes_well() {
    if (settings_.stopped()) run_.was_stopped = true;
    if (run_.failure.empty() && Clock::now() > end_)
      run_.failure = fmt::format("does not end within {} s",
                                 static_cast<double>(settings_.limit.count()) / 1000);
    return !run_.was_stopped && run_.failure.empty();
  }

  bool has_worked() const {
    if (asked_ < questions_.round()) return false;
    if (settings_.answers_at_end_of_input) return true;
    return run_.answers > 0 && Clock::now() - first_answer_ >= settings_.work;
  }

  bool goes_on() {
    if (!goes_well()) return false;
    return !has_worked() || (!settings_.answers_at_end_of_input && run_.answers < asked_);
  }

  void step() {
    while (!has_worked() &&
           (settings_.answers_at_end_of_input || asked_ - run_.answers < lines_ahead)) {
      child_.send(questions_.next());
      ++asked_;
    }
    if (settings_.answers_at_end_of_input) return;
    std::string line;
    const ChildProcess::Event event = child_.next_line(line, glance);
    if (event == ChildProcess::Event::end_of_output) {
      child_.rest_of_output(glance);
      run_.failure = child_.end_text() + " before its input ends";
    } else if (event == ChildProcess::Event::too_long_line) {
      run_.failure = endless_line;
    } else if (event == ChildProcess::Event::line && line.find('{') != line.npos) {
      if (run_.answers++ == 0) first_answer_ = Clock::now();
      run_.answers = std::min(run_.answers, asked_);
    }
  }

  void finish() {
    child_.close_input();
    std::string line;
    while (goes_well()) {
      const ChildProcess::Event event = child_.next_line(line, glance);
      if (event == ChildProcess::Event::line && line.find('{') != line.npos) ++run_.answers;
      if (event == ChildProcess::Event::too_long_line) run_.failure = endless_line;
      if (event == ChildProcess::Event::end_of_output && child_.has_ended()) break;
    }
    if (run_.failure.empty() && !run_.was_stopped && child_.exit_code() != 0)
      run_.failure = child_.end_text();
  }

  const BusySettings& settings_;
  QuestionStream questions_;
  ChildProcess child_;
  Clock::time_point end_, first_answer_;
  std::size_t asked_ = 0;
  BusyRun run_;
};

}  // namespace

BusyRun keep_busy(const std::vector<std::string>& command, const std::vector<TestCase>& cases,
                  const BusySettings& settings) {
  return Run(command, cases, settings).run();
}

}  // namespace tribo::conformance
