// SPDX-License-Identifier: Apache-2.0
#include "conformance/conversation.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <memory>
#include <sstream>
#include <string_view>
#include <unordered_map>

#include "conformance/child_process.hpp"
#include "scene/entries.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::conformance {
namespace {

using nlohmann::json;

// NaN, -inf, 1e999 … outside of texts.
std::string with_quoted_non_numbers(const std::string& line) {
  std::string made;
  for (std::size_t i = 0; i < line.size();) {
    const auto is_of_word = [&](std::size_t k) {
      const char c = line[k];
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+' || c == '-' || c == '.';
    };
    std::size_t end = i + 1;
    if (line[i] == '"') {
      while (end < line.size() && line[end] != '"') end += line[end] == '\\' ? 2 : 1;
      end = std::min(end + 1, line.size());
      made.append(line, i, end - i);
    } else if (is_of_word(i)) {
      while (end < line.size() && is_of_word(end)) ++end;
      const std::string word = line.substr(i, end - i);
      char* rest = nullptr;
      const double number = std::strtod(word.c_str(), &rest);
      const bool is_non_number = *rest == '\0' && !std::isfinite(number);
      made += is_non_number ? '"' + word + '"' : word;
    } else {
      made += line[i];
    }
    i = end;
  }
  return made;
}

using Clock = std::chrono::steady_clock;

constexpr std::size_t window = 32;           // lines asked and not yet answered
constexpr std::size_t most_violations = 20;  // that are told; all are counted
constexpr std::size_t flood = 1000;          // wrong answers from one process
constexpr std::size_t print_flood = 10000;   // lines between two answers
constexpr int most_failures = 3;             // in a row without an answer between them
constexpr int most_silent_failures = 2;      // before any answer
constexpr int most_starts = 25;
constexpr std::size_t most_error_lines = 20;

// Answers are kept until all are judged. Of a longer one only the part that was asked for is kept.
constexpr std::size_t longest_answer = 4096;

std::string shortened(std::string text) {
  return text.size() <= longest_answer ? text : printable(text, longest_answer);
}

// The part of an answer that was asked for, or why it is not there.
json asked_part(const json& answer, const TestCase& asked) {
  json part{{"id", asked.id}};
  const auto keep = [&](const std::string& name) {
    const auto found = answer.find(name);
    if (found == answer.end()) return;
    const std::string text = line_of(*found);
    part[name] = text.size() <= longest_answer ? *found : json(start_of(text));
  };
  for (const Expected& one : asked.expected) keep(one.field);
  for (const char* const name : {"undefined", "skip", "error"}) keep(name);
  return part;
}

class Asker {
 public:
  Asker(const std::string& command, const std::vector<TestCase>& cases, const Limits& limits,
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
      if (Clock::now() > deadline_) {
        if (last_end_.empty())
          last_end_ = fmt::format("gives no answer within {} s", seconds(limits_.all_cases));
        give_up("the time limit of all cases was reached");
      } else if (process_ || start()) {
        send();
        step();
      }
    }
    hear_the_end();
    end_process();
    if (!any_answer_ && !cases_.empty()) result.never_answered = why_never_answered();
    result.error_lines = last_error_lines();
  }

  Conversation result;

 private:
  static double seconds(std::chrono::milliseconds time) {
    return static_cast<double>(time.count()) / 1000;
  }

  std::string why_never_answered() const {
    std::string why =
        first_garbage_.empty() ? "it " + last_end_ : "its first line is " + first_garbage_;
    const auto add = [&](const std::string& what) { why += "; " + what; };
    if (!result.violations.empty()) add(result.violations.front());
    if (result.print_count > 0) add("it writes lines that are no answers: " + result.first_print);
    return why;
  }

  std::vector<std::string> last_error_lines() const {
    std::vector<std::string> lines;
    std::istringstream text(result.last_errors);
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    while (!lines.empty() && lines.back().empty()) lines.pop_back();
    const bool has_failures =
        std::any_of(result.answers.begin(), result.answers.end(), [](const Reply& one) {
          return one.outcome != Outcome::answered && one.outcome != Outcome::skipped;
        });
    const std::size_t kept = std::min(lines.size(), has_failures ? most_error_lines : 1);
    lines.erase(lines.begin(), lines.end() - static_cast<std::ptrdiff_t>(kept));
    return lines;
  }

  // False: no process is started, as some or all of the cases are given up.
  bool start() {
    if (!any_answer_ && failures_ >= most_silent_failures) {
      give_up("it never answers");
      return false;
    }
    if (failures_ >= most_failures) {
      const std::string function = cases_[to_ask_.front()].function;
      give_up(fmt::format("it {} {} times in a row without an answer", last_end_, failures_),
              [&](std::size_t i) { return cases_[i].function == function; });
      failures_ = 0;
      return false;
    }
    if (result.starts >= most_starts) {
      give_up(fmt::format("it had to be started {} times", result.starts));
      return false;
    }
    process_ = std::make_unique<ChildProcess>(std::vector<std::string>{"/bin/sh", "-c", command_},
                                              ChildProcess::Pipes::all);
    ++result.starts;
    stray_ = 0;
    prints_ = 0;
    has_answered_ = false;
    at_once_ = result.answers_at_end_of_input;
    last_progress_ = Clock::now();
    return true;
  }

  void send() {
    while (!to_ask_.empty() && (at_once_ || asked_.size() < window)) {
      process_->send(cases_[to_ask_.front()].line());
      asked_.push_back(to_ask_.front());
      to_ask_.pop_front();
    }
    // One that reads a line ahead answers the last case at the end of its input.
    if (at_once_ || (to_ask_.empty() && has_answered_)) process_->close_input();
  }

  void step() {
    std::string line;
    switch (process_->next_line(line, std::chrono::milliseconds(50))) {
      case ChildProcess::Event::line:
        return hear(line);
      case ChildProcess::Event::too_long_line:
        return fail(Outcome::garbage, "it writes a line over 1 MiB", "writes a line over 1 MiB");
      case ChildProcess::Event::end_of_output:
        return died();
      case ChildProcess::Event::nothing:
        break;
    }
    const auto waited = Clock::now() - last_progress_;
    if (process_->refuses_input() && waited > std::chrono::seconds(1))
      return fail(Outcome::died, "it closes its input", "closes its input");
    note_reading();
    if (waited > limit()) return late();
    // It has read its cases and says nothing: perhaps it answers when its input ends.
    if (!has_answered_ && !at_once_ && !limits_.flushes && waited > limits_.one_case &&
        process_->unread() == 0)
      at_once_ = true;
  }

  std::chrono::milliseconds limit() const {
    // The line for the last case was broken: nothing more has to come.
    if (!broken_.empty() && asked_.size() == 1 && to_ask_.empty())
      return std::min(limits_.one_case, std::chrono::milliseconds(1000));
    if (result.answers_at_end_of_input) return limits_.all_cases;
    return has_answered_ ? limits_.one_case : std::max(limits_.first_answer, limits_.one_case);
  }

  // Where all cases were sent at once, a subject that reads on makes progress.
  void note_reading() {
    const std::size_t unread = process_->unread();
    if (at_once_ && unread < unread_) last_progress_ = Clock::now();
    unread_ = unread;
  }

  // An output line answers the case whose id it has. Earlier cases that still wait get no answer.
  void hear(const std::string& line) {
    json answer = read_answer_line(line);
    if (!answer.is_object()) return hear_garbage(line);
    const auto id = answer.find("id");
    if (id == answer.end() || !(id->is_string() || id->is_number()))
      return stray("an answer without an id: " + start_of(line));
    const auto found = index_of_.find(id->is_string() ? id->get<std::string>() : id->dump());
    if (found == index_of_.end()) return stray("an id that was not asked: " + start_of(line));
    if (is_question(answer, cases_[found->second])) return print(line);
    while (!asked_.empty() && asked_.front() != found->second) {
      if (std::find(asked_.begin(), asked_.end(), found->second) == asked_.end())
        return stray(
            fmt::format("{} is answered twice, or out of order", cases_[found->second].id));
      settle_without_answer(Outcome::missing, "no answer, though later cases have one");
    }
    if (asked_.empty())
      return stray(
          fmt::format("{} is answered twice, or before it was asked", cases_[found->second].id));
    if (!broken_.empty()) note_print(broken_line_);  // it was not the answer
    note_block();
    take(line.size() > longest_answer ? asked_part(answer, cases_[found->second])
                                      : std::move(answer));
  }

  static bool is_question(json answer, const TestCase& asked) {
    answer.erase("id");
    return answer == asked.inputs;
  }

  // Answers that come after the end of the input in blocks that break lines, or all together, were
  // kept in a buffer.
  void note_block() {
    if (has_answered_ || !at_once_) return;
    if (process_->is_within_a_line() || process_->lines_at_hand() + 1 >= asked_.size())
      result.answers_at_end_of_input = true;
  }

  void take(json answer) {
    failures_ = 0;
    prints_ = 0;
    any_answer_ = true;
    has_answered_ = true;
    result.exit_code_without_answer = -1;
    const auto reason = [](const json& what) {
      return shortened(what.is_string() ? what.get<std::string>() : line_of(what));
    };
    if (answer.contains("skip")) return settle(Outcome::skipped, {}, reason(answer["skip"]));
    if (answer.contains("error")) {
      const json& error = answer["error"];
      const bool has_message = error.is_object() && error.contains("message");
      return settle(Outcome::refused, {}, reason(has_message ? error["message"] : error));
    }
    settle(Outcome::answered, std::move(answer), {});
  }

  // A line that is no JSON object. If it names the next case it may be meant as the answer to it:
  // it is, unless the answer comes after it.
  void hear_garbage(const std::string& line) {
    if (line.find_first_not_of(" \t") == std::string::npos) return;
    const auto names = [&](std::size_t place) {
      if (place >= asked_.size()) return false;
      const std::string& id = cases_[asked_[place]].id;
      return line.find('"' + id + '"') != std::string::npos ||
             line.find('\'' + id + '\'') != std::string::npos;
    };
    const bool is_for_next = names(0);
    if (!is_for_next && (broken_.empty() || !names(1))) return print(line);
    if (!is_for_next) settle_without_answer(Outcome::garbage, {});
    if (!broken_.empty()) note_print(broken_line_);
    broken_ = why_no_json(line);
    broken_line_ = line;
    if (first_garbage_.empty()) first_garbage_ = broken_;
  }

  void note_print(const std::string& line) {
    if (result.print_count++ == 0) result.first_print = start_of(line);
  }
  void print(const std::string& line) {
    note_print(line);
    if (++prints_ > print_flood) flooded();
  }

  void note_violation(const std::string& what) {
    ++result.violation_count;
    if (result.violations.size() < most_violations) result.violations.push_back(what);
  }
  void stray(const std::string& what) {
    note_violation(what);
    if (++stray_ > flood) return flooded();
    if (!any_answer_ && stray_ >= asked_.size()) fail(Outcome::garbage, what, "answers no case");
  }

  void flooded() { fail(Outcome::garbage, "it floods its output", "floods its output"); }

  // The case gets no answer; its outcome is garbage if a broken line was meant as the answer.
  void settle_without_answer(Outcome outcome, const std::string& reason) {
    if (broken_.empty()) return settle(outcome, {}, reason);
    settle(Outcome::garbage, {}, broken_);
  }

  void settle(Outcome outcome, json fields, std::string reason) {
    result.answers[asked_.front()] = {outcome, std::move(fields), std::move(reason)};
    asked_.pop_front();
    broken_.clear();
    last_progress_ = Clock::now();
    progress_(++settled_);
  }

  // The next case is to blame; those asked after it are asked again, of a new process.
  void fail(Outcome outcome, const std::string& reason, const std::string& end) {
    const std::string function = asked_.empty() ? "" : cases_[asked_.front()].function;
    if (!asked_.empty()) settle_without_answer(outcome, reason);
    ++failures_;
    last_end_ = end;
    end_process();
    to_ask_.insert(to_ask_.begin(), asked_.begin(), asked_.end());
    asked_.clear();
    if (!any_answer_)  // perhaps another function has answers
      std::stable_partition(to_ask_.begin(), to_ask_.end(),
                            [&](std::size_t i) { return cases_[i].function != function; });
  }

  void died() {
    // The pipe closes a moment before the child is gone.
    for (int i = 0; i < 20 && !process_->has_ended(); ++i) {
      std::string ignored;
      process_->next_line(ignored, std::chrono::milliseconds(5));
      if (!process_->has_ended()) ::usleep(5000);
    }
    const std::string end = process_->has_ended() ? process_->end_text() : "closes its output";
    if (!any_answer_) result.exit_code_without_answer = process_->exit_code();
    if (asked_.empty() && to_ask_.empty()) return;
    fail(Outcome::died, fmt::format("it {}", end), end);
  }

  // All cases are answered: the subject's input ends, and it should end too, with exit code 0. A
  // subject that does not is killed, and the result tells it.
  void hear_the_end() {
    if (!process_) return;
    process_->close_input();
    const Clock::time_point last = std::min(Clock::now() + limits_.one_case, deadline_);
    while (process_ && !process_->has_ended() && Clock::now() < last) {
      std::string line;
      const ChildProcess::Event event = process_->next_line(line, std::chrono::milliseconds(20));
      if (event == ChildProcess::Event::line) hear(line);
      if (event == ChildProcess::Event::too_long_line) return flooded();
      if (event == ChildProcess::Event::end_of_output) ::usleep(2000);
    }
    if (!process_) return;
    result.stays = !process_->has_ended();
    if (!result.stays && process_->exit_code() != 0)
      note_violation(fmt::format("it {} after its last answer", process_->end_text()));
  }

  void late() {
    const std::string limit_text = fmt::format("within {} s", seconds(limit()));
    if (!any_answer_ && process_->unread() > 0)
      failures_ = most_silent_failures;  // it does not read
    fail(Outcome::late, "no answer " + limit_text, "gives no answer " + limit_text);
  }

  void give_up(const std::string& why) {
    give_up(why, [](std::size_t) { return true; });
  }
  template <class Which>
  void give_up(const std::string& why, Which&& which) {
    to_ask_.insert(to_ask_.begin(), asked_.begin(), asked_.end());
    asked_.clear();
    std::erase_if(to_ask_, [&](std::size_t i) {
      if (which(i)) result.answers[i] = {Outcome::not_asked, {}, why};
      return which(i);
    });
    end_process();
  }

  void end_process() {
    if (!process_) return;
    process_->kill();
    if (!process_->last_errors().empty()) result.last_errors = process_->last_errors();
    process_.reset();
  }

  const std::string& command_;
  const std::vector<TestCase>& cases_;
  const Limits& limits_;
  const std::function<void(std::size_t)>& progress_;
  const Clock::time_point deadline_;
  std::unordered_map<std::string, std::size_t> index_of_;
  std::deque<std::size_t> to_ask_, asked_;
  std::unique_ptr<ChildProcess> process_;
  Clock::time_point last_progress_;
  std::size_t settled_ = 0;
  std::size_t stray_ = 0;      // of this process
  std::size_t prints_ = 0;     // since its last answer
  std::size_t unread_ = 0;     // bytes
  bool has_answered_ = false;  // this process
  int failures_ = 0;
  bool any_answer_ = false;
  bool at_once_ = false;  // all cases in one go, then the end of input
  std::string broken_;    // why the line that was to answer the next case is no answer
  std::string broken_line_;
  std::string first_garbage_;
  std::string last_end_;
};

}  // namespace

json read_answer_line(const std::string& line) {
  if (scene_detail::nests_too_deep(line)) return json(json::value_t::discarded);
  const json answer = json::parse(line, nullptr, false);
  return answer.is_discarded() ? json::parse(with_quoted_non_numbers(line), nullptr, false)
                               : answer;
}

std::string why_no_json(const std::string& line) {
  if (scene_detail::nests_too_deep(line))
    return fmt::format("{}: {}", scene_detail::too_deep_text, start_of(line));
  try {
    const json whole = json::parse(line);
    return fmt::format("a JSON {}, no object: {}", whole.type_name(), start_of(line));
  } catch (const json::parse_error& error) {
    constexpr std::size_t around = 40;
    const std::size_t at = std::min(error.byte - std::min<std::size_t>(error.byte, 1), line.size());
    const std::size_t from = at - std::min(at, around);
    const std::string before = (from > 0 ? "…" : "") + printable(line.substr(from, at - from));
    if (at == line.size())
      return fmt::format("no JSON: the line ends too early, after `{}`", before);
    return fmt::format("no JSON at character {}, between `{}` and `{}`", at + 1, before,
                       printable(std::string_view(line).substr(at), around));
  } catch (const json::exception&) {
  }
  return "no JSON object: " + start_of(line);
}

std::string line_of(const json& value) {
  return value.dump(-1, ' ', true, json::error_handler_t::replace);
}

std::string start_of(const std::string& text) { return printable(text, 80); }

Conversation ask(const std::string& command, const std::vector<TestCase>& cases,
                 const Limits& limits, const std::function<void(std::size_t)>& progress) {
  Asker asker(command, cases, limits, progress);
  asker.run();
  return std::move(asker.result);
}

}  // namespace tribo::conformance
