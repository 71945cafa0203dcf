// SPDX-License-Identifier: Apache-2.0
// Asks a subject a share of the questions, one process of it at a time. Where a process ends or
// falls silent, another one is started; where that leads nowhere, the questions are given up.
#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "conformance/child_process.hpp"
#include "conformance/conformance_case.hpp"
#include "conformance/conversation.hpp"

namespace tribo::conformance {

using Clock = std::chrono::steady_clock;

inline constexpr std::size_t most_violations = 20;  // so many are told, all are counted
inline constexpr int most_starts = 25;
std::string too_many_starts();  // the reason of cases that are not asked after so many starts

// All questions to a subject, and their replies. A question is a number: below the count of cases
// it asks that case, from there on it asks a case again, and the last one, the greeting, asks a
// case that another process has answered. Askers that run at the same time share only the greeting.
class Questions {
 public:
  Questions(const std::string& subject, const std::vector<TestCase>& all, const Limits& times,
            const std::vector<std::size_t>& repeated, std::function<void()> settled);

  bool is_repeat(std::size_t question) const { return question >= cases.size(); }
  std::size_t greeting() const { return cases.size() + again.size(); }
  std::size_t case_of(std::size_t question) const;
  const TestCase& asked(std::size_t question) const { return cases[case_of(question)]; }
  // Failures in a row are counted within each function; all repeats together are like one function.
  std::string group(std::size_t question) const;
  Reply& reply(std::size_t question);  // not for the greeting: it keeps none
  // Whether the question would ask a case again that cost the process the first time, or that was
  // given up then: such a question is left out.
  bool is_moot(std::size_t question) const;
  // The questions that ask again those of these cases that are to be asked twice, the last first.
  std::vector<std::size_t> repeats_of(const std::vector<std::size_t>& some) const;

  const std::string& command;
  const std::vector<TestCase>& cases;
  const Limits& limits;
  const std::vector<std::size_t>& again;  // cases, in rising order
  const std::function<void()> note_settled;
  const Clock::time_point deadline;
  std::vector<Reply> answers, second_answers;
  std::vector<std::size_t> places;  // of the questions, in the order that one process is asked
  std::size_t greeting_case = 0;
};

// Patience with a subject that ends or falls silent where it owes an answer: after the third time
// in a row within one function, the other questions to this function are given up.
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

// The end of a process, or its silence, where it owed an answer.
struct Breakdown {
  std::string end;     // "exits with code 3"
  std::string errors;  // the end of its stderr
};

// All that an asker reports beside the replies.
struct Account {
  std::vector<Heard> violations;  // the first few
  std::size_t violation_count = 0, print_count = 0;
  std::optional<Heard> first_print;
  std::map<std::size_t, Breakdown> breakdowns;  // by their questions
  std::string final_errors;                     // the end of the last process's stderr
  std::string bad_end;                          // "it exits with code 3 after its last answer"
  bool stays = false, answers_at_end_of_input = false;
  std::string never_answered;
  int exit_code_without_answer = -1;
  std::map<std::string, double> seconds;  // of each function
  double cpu_seconds = 0;
};

// The reason where no answer came in time. The limit is another one before a process has answered.
// `hint`, which ends the text, says what may be wrong with the subject.
std::string late_text(const Limits& limits, bool has_answered, const std::string& hint);

class Asker {
 public:
  // Takes those questions that other askers are to ask out of the list of unsent questions.
  using Share = std::function<void(std::deque<std::size_t>&)>;

  // With `share`, which is called at the first answer, this asker finds out whether the subject
  // ever answers. Without `share` another asker has found that the subject does.
  Asker(Questions& questions, std::deque<std::size_t> to_ask, Share share = {});

  // Asks all questions. `is_greeted`: the greeting is asked first, so that the process is like one
  // that has been asked before, and what it wrote until then is not reported. Returns false where
  // the greeting got no answer: then nothing else was asked.
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
  std::size_t stray_ = 0;                  // since its last answer
  std::size_t prints_ = 0;                 // since its last answer
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
  std::string broken_;    // why the line that was to answer the next case is no answer
  std::string broken_line_;
  std::string first_garbage_;
  std::string last_end_;
};

}  // namespace tribo::conformance
