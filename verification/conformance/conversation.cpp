// SPDX-License-Identifier: Apache-2.0
#include "conformance/conversation.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <deque>
#include <memory>
#include <unordered_map>

#include "conformance/subject_process.hpp"

namespace tribo::conformance {
namespace {

using nlohmann::json;
using Clock = std::chrono::steady_clock;

constexpr std::size_t window = 32;           // lines asked and not yet answered
constexpr std::size_t most_violations = 20;  // that are told; all are counted
constexpr std::size_t flood = 1000;          // lines too many from one process
constexpr int most_failures = 3;             // in a row without an answer between them
constexpr int most_starts = 25;

// The start of a text, printable, for one line of a message.
std::string shown(const std::string& text) {
  std::string made;
  for (const char c : text.substr(0, 80)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte >= 0x7f)
      made += fmt::format("\\x{:02x}", byte);
    else
      made += c;
  }
  return made + (text.size() > 80 ? "…" : "");
}

class Asker {
 public:
  Asker(const std::string& command, const std::vector<Case>& cases, const Limits& limits,
        const std::function<void(std::size_t)>& progress)
      : command_(command),
        cases_(cases),
        limits_(limits),
        progress_(progress),
        deadline_(Clock::now() + limits.all_cases) {
    result.answers.resize(cases.size());
    for (std::size_t i = 0; i < cases.size(); ++i) {
      index_of_[cases[i].id] = i;
      to_ask_.push_back(i);
    }
  }

  void run() {
    while (!to_ask_.empty() || !asked_.empty()) {
      if (Clock::now() > deadline_) return give_up("the time limit of all cases was reached");
      if (!process_ && !start()) return;
      send();
      step();
    }
    end_process();
  }

  Conversation result;

 private:
  bool start() {
    if (failures_ >= most_failures) {
      give_up(fmt::format("it {} {} times in a row without an answer", last_end_, failures_));
      return false;
    }
    if (result.starts >= most_starts) {
      give_up(fmt::format("it had to be started {} times", result.starts));
      return false;
    }
    process_ = std::make_unique<SubjectProcess>(command_);
    ++result.starts;
    stray_ = 0;
    garbage_ = 0;
    last_progress_ = Clock::now();
    return true;
  }

  void send() {
    while (!to_ask_.empty() && (at_once_ || asked_.size() < window)) {
      process_->send(cases_[to_ask_.front()].line());
      asked_.push_back(to_ask_.front());
      to_ask_.pop_front();
    }
    if (at_once_) process_->close_input();
  }

  void step() {
    std::string line;
    switch (process_->next_line(line, std::chrono::milliseconds(50))) {
      case SubjectProcess::Event::line:
        return hear(line);
      case SubjectProcess::Event::too_long_line:
        return fail(Outcome::garbage, "it wrote a line over 1 MiB", "wrote a line over 1 MiB");
      case SubjectProcess::Event::end_of_output:
        return died();
      case SubjectProcess::Event::nothing:
        break;
    }
    const auto waited = Clock::now() - last_progress_;
    if (process_->refuses_input() && waited > std::chrono::seconds(1))
      return fail(Outcome::died, "it closed its input", "closed its input");
    if (waited > (at_once_ ? limits_.all_cases : limits_.one_case)) late();
  }

  // An output line answers the case whose id it has. Earlier cases that still wait get no answer.
  void hear(const std::string& line) {
    json answer = json::parse(line, nullptr, false);
    if (answer.is_discarded() || !answer.is_object()) return hear_garbage(line);
    const auto id = answer.find("id");
    if (id == answer.end() || !id->is_string())
      return stray("an answer without an id: " + shown(line));
    const auto found = index_of_.find(id->get<std::string>());
    if (found == index_of_.end()) return stray("an id that was not asked: " + shown(line));
    while (!asked_.empty() && asked_.front() != found->second) {
      if (std::find(asked_.begin(), asked_.end(), found->second) == asked_.end())
        return stray(
            fmt::format("{} is answered twice, or out of order", cases_[found->second].id));
      settle(Outcome::missing, {}, "no answer, though later cases have one");
    }
    if (asked_.empty())
      return stray(
          fmt::format("{} is answered twice, or before it was asked", cases_[found->second].id));
    take(std::move(answer));
  }

  void take(json answer) {
    failures_ = 0;
    any_answer_ = true;
    result.exit_code_without_answer = -1;
    const auto reason = [](const json& what) {
      return what.is_string() ? what.get<std::string>()
                              : what.dump(-1, ' ', true, json::error_handler_t::replace);
    };
    if (answer.contains("skip")) return settle(Outcome::skipped, {}, reason(answer["skip"]));
    if (answer.contains("error")) {
      const json& error = answer["error"];
      const bool has_message = error.is_object() && error.contains("message");
      return settle(Outcome::refused, {}, reason(has_message ? error["message"] : error));
    }
    settle(Outcome::answered, std::move(answer), {});
  }

  // A line that is no JSON object. It counts as the answer to the next case if it has the id of
  // that case, or if there are already as many such lines as waiting cases.
  void hear_garbage(const std::string& line) {
    if (line.find_first_not_of(" \t") == std::string::npos) return;
    const bool is_for_next =
        !asked_.empty() && line.find('"' + cases_[asked_.front()].id + '"') != std::string::npos;
    if (!is_for_next) {
      stray("not a line of JSON: " + shown(line));
      if (!process_ || ++garbage_ < asked_.size()) return;
      --garbage_;
    }
    if (!asked_.empty()) settle(Outcome::garbage, {}, "not a JSON object: " + shown(line));
  }

  void stray(const std::string& what) {
    ++result.violation_count;
    if (result.violations.size() < most_violations) result.violations.push_back(what);
    if (++stray_ > flood) fail(Outcome::garbage, "it floods its output", "flooded its output");
  }

  void settle(Outcome outcome, json fields, std::string reason) {
    result.answers[asked_.front()] = {outcome, std::move(fields), std::move(reason)};
    asked_.pop_front();
    last_progress_ = Clock::now();
    progress_(++settled_);
  }

  // The next case is to blame; those asked after it are asked again, of a new process.
  void fail(Outcome outcome, const std::string& reason, const std::string& end) {
    if (!asked_.empty()) settle(outcome, {}, reason);
    ++failures_;
    last_end_ = end;
    end_process();
    to_ask_.insert(to_ask_.begin(), asked_.begin(), asked_.end());
    asked_.clear();
  }

  void died() {
    // The pipe closes a moment before the child is gone.
    for (int i = 0; i < 20 && !process_->has_ended(); ++i) {
      std::string ignored;
      process_->next_line(ignored, std::chrono::milliseconds(5));
      if (!process_->has_ended()) ::usleep(5000);
    }
    const std::string end = process_->has_ended() ? process_->end_text() : "closed its output";
    if (!any_answer_) result.exit_code_without_answer = process_->exit_code();
    if (asked_.empty() && to_ask_.empty()) return;
    fail(Outcome::died, fmt::format("it {}", end), end);
  }

  void late() {
    if (!any_answer_ && !at_once_) {
      // Perhaps it answers when its input ends.
      at_once_ = true;
      result.answers_at_end_of_input = true;
      failures_ = 0;
      end_process();
      to_ask_.insert(to_ask_.begin(), asked_.begin(), asked_.end());
      asked_.clear();
      return;
    }
    fail(Outcome::late,
         fmt::format("no answer within {} s", static_cast<double>(limits_.one_case.count()) / 1000),
         "did not answer");
  }

  void give_up(const std::string& why) {
    if (!asked_.empty()) to_ask_.insert(to_ask_.begin(), asked_.begin(), asked_.end());
    asked_.clear();
    for (const std::size_t i : to_ask_) result.answers[i] = {Outcome::not_asked, {}, why};
    to_ask_.clear();
    end_process();
  }

  void end_process() {
    if (!process_) return;
    process_->kill();
    if (!process_->last_errors().empty()) result.last_errors = process_->last_errors();
    process_.reset();
  }

  const std::string& command_;
  const std::vector<Case>& cases_;
  const Limits& limits_;
  const std::function<void(std::size_t)>& progress_;
  const Clock::time_point deadline_;
  std::unordered_map<std::string, std::size_t> index_of_;
  std::deque<std::size_t> to_ask_, asked_;
  std::unique_ptr<SubjectProcess> process_;
  Clock::time_point last_progress_;
  std::size_t settled_ = 0;
  std::size_t stray_ = 0, garbage_ = 0;  // of this process
  int failures_ = 0;
  bool any_answer_ = false;
  bool at_once_ = false;  // all cases in one go, then the end of input
  std::string last_end_;
};

}  // namespace

Conversation ask(const std::string& command, const std::vector<Case>& cases, const Limits& limits,
                 const std::function<void(std::size_t)>& progress) {
  Asker asker(command, cases, limits, progress);
  asker.run();
  return std::move(asker.result);
}

}  // namespace tribo::conformance
