// SPDX-License-Identifier: Apache-2.0
// Asks a subject a share of the questions, with one process of it at a time. If a process ends or
// falls silent, another one is started. After too many failures the questions are given up.
#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "conformance/child_process.hpp"
#include "conformance/conformance_case.hpp"
#include "conformance/conversation.hpp"

namespace tribo::conformance {

using Clock = std::chrono::steady_clock;

inline constexpr std::size_t most_violations = 20;  // only so many are reported; all are counted
inline constexpr int most_starts = 25;
std::string too_many_starts();  // why cases are not asked after most_starts starts

// All questions to a subject, and their replies. A question is an index: of n cases and m repeats,
// those below n ask the cases, the next m ask cases again, and n + m is the greeting. It asks a
// case that another process has answered. Askers that run at once share only the greeting.
class Questions {
 public:
  Questions(const std::string& subject, const std::vector<TestCase>& all, const Limits& times,
            const std::vector<std::size_t>& repeated, std::function<void()> settled);

  bool is_repeat(std::size_t question) const { return question >= cases.size(); }
  std::size_t greeting() const { return cases.size() + again.size(); }
  std::size_t case_of(std::size_t question) const;
  const TestCase& asked(std::size_t question) const { return cases[case_of(question)]; }
  // The function that is asked, or "" for a repeat. Failures in a row are counted within one group.
  std::string group(std::size_t question) const;
  Reply& reply(std::size_t question);  // not for the greeting: it keeps none
  // Whether the question asks a case again at which the process ended or was late the first time,
  // or that was given up then. Such a question is not asked.
  bool is_moot(std::size_t question) const;
  // The questions that ask cases of `some` again, the last case first.
  std::vector<std::size_t> repeats_of(const std::vector<std::size_t>& some) const;

  const std::string& command;
  const std::vector<TestCase>& cases;
  const Limits& limits;
  const std::vector<std::size_t>& again;  // cases, in rising order
  const std::function<void()> note_settled;
  const Clock::time_point deadline;
  std::vector<Reply> answers, second_answers;
  std::vector<std::size_t> places;  // rank of each question in the order of one process
  std::size_t greeting_case = 0;
};

// Counts how often in a row the subject ends or falls silent while it owes an answer. After the
// third time within one function, the other questions to this function are given up.
class Patience {
 public:
  void note_answer() { in_a_row_ = 0; }
  void note_failure(const Questions& questions, std::size_t question, const std::string& end);
  bool is_over() const { return in_a_row_ >= most; }
  const std::string& group() const { return group_; }
  std::string reason() const;

 private:
  static constexpr int most = 3;

  int in_a_row_ = 0;
  std::size_t place_ = 0;
  std::string group_, end_;
};

// A note on the subject's output, and the place of the question that was to be answered next.
struct Heard {
  std::size_t place = 0;
  std::string text;
};

// How a process failed while it owed an answer.
struct Breakdown {
  std::string end;     // "exits with code 3"
  std::string errors;  // the end of its stderr
};

// All that an asker reports beside the replies.
struct Account {
  std::vector<Heard> violations;  // the first few
  std::size_t violation_count = 0, print_count = 0;
  std::optional<Heard> first_print;
  std::map<std::size_t, Breakdown> breakdowns;  // by question
  std::string final_errors;                     // the end of the last process's stderr
  std::string bad_end;                          // "it exits with code 3 after its last answer"
  bool stays = false, answers_at_end_of_input = false;
  std::string never_answered;
  int exit_code_without_answer = -1;
  std::map<std::string, double> seconds;  // wall time of each function
  double cpu_seconds = 0;
};

// The reason of a case without an answer in time. A process has another limit for its first answer.
// `hint` is the end of the text: it says what may be wrong with the subject.
std::string late_text(const Limits& limits, bool has_answered, const std::string& hint);

class Asker {
 public:
  // Removes from the list of unsent questions those that other askers are to ask.
  using Share = std::function<void(std::deque<std::size_t>&)>;

  // With `share`, this asker finds out whether the subject ever answers; it calls `share` at the
  // first answer. Without `share`, another asker has had an answer before.
  Asker(Questions& questions, std::deque<std::size_t> to_ask, Share share = {});

  // Asks all questions. `is_greeted`: asks the greeting first, so that the process is no fresh one
  // when it gets the others. The account leaves out what it wrote until then. Returns false if the
  // greeting got no answer; then nothing else was asked.
  bool run(bool is_greeted);

  Account account;

 private:
  bool any_to_send();
  std::string why_never_answered() const;
  bool start();
  void send();
  void step();
  std::chrono::milliseconds limit() const;
  void note_reading();
  void hear(const std::string& line);
  void note_block();
  void take(nlohmann::json answer);
  std::string place_of(nlohmann::json& answer) const;
  void note_first_answer(std::size_t question);
  void hear_garbage(const std::string& line);
  void note_print(const std::string& line);
  void print(const std::string& line);
  void note_violation(std::size_t place, const std::string& what);
  void stray(std::size_t place, const std::string& what);
  void flooded();
  std::size_t next_place() const;
  void settle_without_answer(Outcome outcome, const std::string& reason);
  void settle(Outcome outcome, nlohmann::json fields, std::string reason);
  void fail(Outcome outcome, const std::string& reason, const std::string& end);
  void died();
  void hear_the_end();
  void late();
  void give_up(const std::string& why);
  template <class Which>
  void give_up(const std::string& why, Which&& which);
  void end_process();

  Questions& questions_;
  const Share share_;
  std::unordered_map<std::string, std::size_t> index_of_;  // of the cases, by their ids
  std::deque<std::size_t> to_ask_, asked_;
  std::unique_ptr<ChildProcess> process_;
  Clock::time_point last_progress_;
  Patience patience_;
  std::size_t settled_ = 0;
  std::size_t stray_ = 0;                  // wrong ids since its last answer
  std::size_t prints_ = 0;                 // other lines since its last answer
  std::size_t unread_ = 0;                 // bytes
  bool has_answered_ = false;              // this process
  std::optional<std::size_t> last_heard_;  // the case that this process answered last
  std::size_t heard_ = 0;                  // answers of this process
  bool is_greeted_ = false;
  bool is_refused_ = false;  // the greeting has no answer
  int starts_ = 0;
  int silent_failures_ = 0;  // before any answer
  bool any_answer_;
  bool at_once_ = false;  // all cases in one go, then the end of input
  std::string broken_;    // why a line that names the next case is no JSON object; or empty
  std::string broken_line_;
  std::string first_garbage_;
  std::string last_end_;
};

}  // namespace tribo::conformance
