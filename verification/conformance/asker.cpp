// SPDX-License-Identifier: Apache-2.0
#include "conformance/asker.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "tribo/scene_reader.hpp"

namespace tribo::conformance {
namespace {

using nlohmann::json;

constexpr std::size_t window = 32;          // lines asked and not yet answered
constexpr std::size_t flood = 1000;         // wrong answers between two right ones
constexpr std::size_t print_flood = 10000;  // lines between two answers
constexpr int most_silent_failures = 2;     // before any answer

// A subject that prints answers may seem silent, because they wait in the buffer of its output.
constexpr const char* may_not_flush =
    "; if it prints answers, it may not flush its output after each line";
constexpr const char* half_a_line =
    "; half a line has come: it does not flush its output after each line";

// The members that were asked for, or that say why they are missing; long ones are cut.
json asked_part(const json& answer, const TestCase& asked) {
  json part{{"id", asked.id}};
  const auto keep = [&](const std::string& name) {
    const auto found = answer.find(name);
    if (found == answer.end()) return;
    const std::string text = line_of(*found);
    part[name] = text.size() <= longest_kept_answer ? *found : json(start_of(text));
  };
  for (const Expected& one : asked.expected) keep(one.field);
  for (const char* const name : {"undefined", "skip", "error", "place"}) keep(name);
  return part;
}

bool is_question(json answer, const TestCase& asked) {
  answer.erase("id");
  return answer == asked.inputs;
}

double seconds(std::chrono::milliseconds time) { return static_cast<double>(time.count()) / 1000; }

std::string within(std::chrono::milliseconds time) {
  return fmt::format("within {} s", seconds(time));
}

// A process may have much to load before its first answer.
std::chrono::milliseconds usual_limit(const Limits& limits, bool has_answered) {
  return has_answered ? limits.one_case : std::max(limits.first_answer, limits.one_case);
}

}  // namespace

std::string too_many_starts() { return fmt::format("it had to be started {} times", most_starts); }

std::string late_text(const Limits& limits, bool has_answered, const std::string& hint) {
  return "no answer " + within(usual_limit(limits, has_answered)) + hint;
}

Questions::Questions(const std::string& subject, const std::vector<TestCase>& all,
                     const Limits& times, const std::vector<std::size_t>& repeated,
                     std::function<void()> settled)
    : command(subject),
      cases(all),
      limits(times),
      again(repeated),
      note_settled(std::move(settled)),
      deadline(Clock::now() + times.all_cases),
      answers(all.size()),
      second_answers(repeated.size()) {
  for (std::size_t i = 0; i < cases.size(); ++i) places.push_back(i);
  for (std::size_t i = 0; i < again.size(); ++i)
    places.push_back(cases.size() + again.size() - 1 - i);
}

std::size_t Questions::case_of(std::size_t question) const {
  if (!is_repeat(question)) return question;
  return question == greeting() ? greeting_case : again[question - cases.size()];
}

std::string Questions::group(std::size_t question) const {
  return is_repeat(question) ? "" : cases[question].function;
}

Reply& Questions::reply(std::size_t question) {
  return is_repeat(question) ? second_answers[question - cases.size()] : answers[question];
}

bool Questions::is_moot(std::size_t question) const {
  if (!is_repeat(question) || question == greeting()) return false;
  const Reply& first = answers[case_of(question)];
  return first.outcome == Outcome::died || first.outcome == Outcome::late ||
         (first.outcome == Outcome::not_asked && !first.reason.empty());
}

std::vector<std::size_t> Questions::repeats_of(const std::vector<std::size_t>& some) const {
  std::vector<std::size_t> made;
  for (std::size_t i = again.size(); i-- > 0;)
    if (std::find(some.begin(), some.end(), again[i]) != some.end())
      made.push_back(cases.size() + i);
  return made;
}

void Patience::note_failure(const Questions& questions, std::size_t question,
                            const std::string& end) {
  const std::size_t place = questions.places[question];
  const std::string group = questions.group(question);
  const bool goes_on = in_a_row_ > 0 && place == place_ + 1 && group == group_;
  in_a_row_ = goes_on ? in_a_row_ + 1 : 1;
  place_ = place;
  group_ = group;
  end_ = end;
}

// A hint may follow a semicolon in `end_`. It stays the last part of the reason.
std::string Patience::reason() const {
  const std::size_t hint = std::min(end_.find(';'), end_.size());
  return fmt::format("it {} {} times in a row without an answer{}", end_.substr(0, hint), in_a_row_,
                     end_.substr(hint));
}

Asker::Asker(Questions& questions, std::deque<std::size_t> to_ask, Share share)
    : questions_(questions),
      share_(std::move(share)),
      to_ask_(std::move(to_ask)),
      any_answer_(share_ == nullptr) {
  for (std::size_t i = 0; i < questions.cases.size(); ++i) index_of_[questions.cases[i].id] = i;
}

bool Asker::run(bool is_greeted) {
  is_greeted_ = is_greeted;
  if (is_greeted) to_ask_.push_front(questions_.greeting());
  while (any_to_send() || !asked_.empty()) {
    if (Clock::now() > questions_.deadline) {
      if (last_end_.empty())
        last_end_ = "gives no answer " + within(questions_.limits.all_cases) +
                    (questions_.limits.flushes ? "" : may_not_flush);
      give_up("the time limit of all cases was reached");
    } else if (process_ || start()) {
      send();
      step();
    }
  }
  if (is_refused_) return false;
  hear_the_end();
  end_process();
  if (!any_answer_ && !questions_.cases.empty()) account.never_answered = why_never_answered();
  return true;
}

bool Asker::any_to_send() {
  while (!to_ask_.empty() && questions_.is_moot(to_ask_.front())) to_ask_.pop_front();
  return !to_ask_.empty();
}

std::string Asker::why_never_answered() const {
  std::string why =
      first_garbage_.empty() ? "it " + last_end_ : "its first line is " + first_garbage_;
  const auto add = [&](const std::string& what) { why += "; " + what; };
  if (!account.violations.empty()) add(account.violations.front().text);
  if (account.first_print) add("it writes lines that are no answers: " + account.first_print->text);
  return why;
}

// Starts a process. Returns false if it gave up some or all questions instead.
bool Asker::start() {
  if (!any_answer_ && silent_failures_ >= most_silent_failures) {
    give_up("it never answers");
    return false;
  }
  if (patience_.is_over()) {
    give_up(patience_.reason(),
            [&](std::size_t i) { return questions_.group(i) == patience_.group(); });
    patience_.note_answer();
    return false;
  }
  if (starts_ >= most_starts) {
    give_up(too_many_starts());
    return false;
  }
  process_ = std::make_unique<ChildProcess>(
      std::vector<std::string>{"/bin/sh", "-c", questions_.command}, ChildProcess::Pipes::all);
  ++starts_;
  stray_ = 0;
  prints_ = 0;
  has_answered_ = false;
  last_heard_.reset();
  heard_ = 0;
  at_once_ = account.answers_at_end_of_input;
  last_progress_ = Clock::now();
  return true;
}

void Asker::send() {
  while (any_to_send() && (at_once_ || asked_.size() < window)) {
    process_->send(questions_.asked(to_ask_.front()).line());
    asked_.push_back(to_ask_.front());
    to_ask_.pop_front();
  }
  // A subject that reads a line ahead answers the last case only when its input ends.
  if (at_once_ || (to_ask_.empty() && has_answered_)) process_->close_input();
}

void Asker::step() {
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
  // The subject has read its cases and is silent: perhaps it answers only when its input ends.
  const Limits& limits = questions_.limits;
  if (!has_answered_ && !at_once_ && !limits.flushes && waited > limits.one_case &&
      process_->unread() == 0)
    at_once_ = true;
}

std::chrono::milliseconds Asker::limit() const {
  const Limits& limits = questions_.limits;
  // The last case has a broken answer already. A good one may still come, but need not.
  if (!broken_.empty() && asked_.size() == 1 && to_ask_.empty())
    return std::min(limits.one_case, std::chrono::milliseconds(1000));
  if (account.answers_at_end_of_input) return limits.all_cases;
  return usual_limit(limits, has_answered_);
}

// If all cases were sent at once, it counts as progress that the subject reads them.
void Asker::note_reading() {
  const std::size_t unread = process_->unread();
  if (at_once_ && unread < unread_) last_progress_ = Clock::now();
  unread_ = unread;
}

// An output line answers the case whose id it has. Earlier cases without an answer are missing.
void Asker::hear(const std::string& line) {
  json answer = read_answer_line(line);
  if (!answer.is_object()) return hear_garbage(line);
  const auto id = answer.find("id");
  if (id == answer.end() || !(id->is_string() || id->is_number()))
    return stray(next_place(), "an answer without an id: " + start_of(line));
  const auto found = index_of_.find(id->is_string() ? id->get<std::string>() : id->dump());
  if (found == index_of_.end())
    return stray(next_place(), "an id that was not asked: " + start_of(line));
  const TestCase& asked = questions_.cases[found->second];
  if (is_question(answer, asked)) return print(line);
  if (is_greeted_ && found->second == questions_.greeting_case && has_answered_) return;
  const auto is_meant = [&](std::size_t i) { return questions_.case_of(i) == found->second; };
  while (!asked_.empty() && !is_meant(asked_.front())) {
    // The case that was answered last may also be among the questions that ask again.
    if (found->second == last_heard_ || std::none_of(asked_.begin(), asked_.end(), is_meant))
      return stray(questions_.places[found->second],
                   fmt::format("{} is answered twice, or out of order", asked.id));
    settle_without_answer(Outcome::missing, "no answer, though later cases have one");
  }
  if (asked_.empty())
    return stray(questions_.places[found->second],
                 fmt::format("{} is answered twice, or before it was asked", asked.id));
  if (!broken_.empty()) note_print(broken_line_);  // it was not the answer
  note_block();
  take(line.size() > longest_kept_answer ? asked_part(answer, asked) : std::move(answer));
}

// Notes if the subject kept its answers in a buffer until its input ended: they then come all
// together, or in blocks that end within a line.
void Asker::note_block() {
  if (has_answered_ || !at_once_) return;
  if (process_->is_within_a_line() || process_->lines_at_hand() + 1 >= asked_.size())
    account.answers_at_end_of_input = true;
}

// Where the answer was given (Reply::place). The process of a plug-in says it in the member `place`
// of the answer. This member is removed.
std::string Asker::place_of(json& answer) const {
  const auto told = answer.find("place");
  if (questions_.limits.flushes && told != answer.end() && told->is_string()) {
    const std::string place = told->get<std::string>();
    answer.erase(told);
    return "at " + place;
  }
  return fmt::format("as question {} of its process{}", heard_,
                     last_heard_ ? ", after " + questions_.cases[*last_heard_].id : "");
}

void Asker::take(json answer) {
  const std::size_t question = asked_.front();
  ++heard_;
  std::string place = place_of(answer);
  patience_.note_answer();
  prints_ = 0;
  stray_ = 0;
  last_heard_ = questions_.case_of(question);
  account.exit_code_without_answer = -1;
  Reply reply = reply_of(std::move(answer));
  settle(reply.outcome, std::move(reply.fields), std::move(reply.reason));
  if (question != questions_.greeting()) questions_.reply(question).place = std::move(place);
  has_answered_ = true;
  if (!any_answer_) note_first_answer(question);
}

// Fixes the order in which one process would be asked, and shares the questions out.
void Asker::note_first_answer(std::size_t question) {
  any_answer_ = true;
  questions_.greeting_case = questions_.case_of(question);
  std::size_t place = settled_;
  for (const std::deque<std::size_t>* const part : {&asked_, &to_ask_})
    for (const std::size_t i : *part)
      if (!questions_.is_repeat(i)) questions_.places[i] = place++;
  share_(to_ask_);
}

// Hears a line that is no JSON object. If the line names the next case, it counts as a broken
// answer to that case, unless a good answer to the case still comes.
void Asker::hear_garbage(const std::string& line) {
  if (line.find_first_not_of(" \t") == std::string::npos) return;
  const auto names = [&](std::size_t place) {
    if (place >= asked_.size()) return false;
    const std::string& id = questions_.asked(asked_[place]).id;
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

std::size_t Asker::next_place() const {
  const bool is_known = !asked_.empty() && asked_.front() != questions_.greeting();
  return is_known ? questions_.places[asked_.front()] : questions_.greeting();
}

void Asker::note_print(const std::string& line) {
  if (account.print_count++ == 0) account.first_print = {next_place(), start_of(line)};
}

void Asker::print(const std::string& line) {
  note_print(line);
  if (++prints_ > print_flood) flooded();
}

void Asker::note_violation(std::size_t place, const std::string& what) {
  ++account.violation_count;
  if (account.violations.size() < most_violations) account.violations.push_back({place, what});
}

void Asker::stray(std::size_t place, const std::string& what) {
  note_violation(place, what);
  if (++stray_ > flood) return flooded();
  if (!any_answer_ && stray_ >= asked_.size()) fail(Outcome::garbage, what, "answers no case");
}

void Asker::flooded() { fail(Outcome::garbage, "it floods its output", "floods its output"); }

// The next case gets no answer. Its outcome is garbage if a broken line was meant as its answer.
void Asker::settle_without_answer(Outcome outcome, const std::string& reason) {
  if (broken_.empty()) return settle(outcome, {}, reason);
  settle(Outcome::garbage, {}, broken_);
}

void Asker::settle(Outcome outcome, json fields, std::string reason) {
  const std::size_t question = asked_.front();
  asked_.pop_front();
  broken_.clear();
  const Clock::time_point now = Clock::now();
  const std::chrono::duration<double> taken = now - std::exchange(last_progress_, now);
  if (question == questions_.greeting()) {
    account = Account{};
    return;
  }
  questions_.reply(question) = {outcome, std::move(fields), std::move(reason)};
  if (questions_.is_repeat(question)) return;
  // The time until a process gives its first answer contains its start, and is not counted.
  if (has_answered_ || outcome != Outcome::answered)
    account.seconds[questions_.group(question)] += taken.count();
  ++settled_;
  questions_.note_settled();
}

// Ends the process and blames the next case. A new process is asked the cases sent after it.
void Asker::fail(Outcome outcome, const std::string& reason, const std::string& end) {
  const bool any_asked = !asked_.empty();
  const std::size_t question = any_asked ? asked_.front() : questions_.greeting();
  is_refused_ = any_asked && question == questions_.greeting();
  if (any_asked && !is_refused_) {
    settle_without_answer(outcome, reason);
    patience_.note_failure(questions_, question, end);
  }
  silent_failures_ += any_answer_ ? 0 : 1;
  last_end_ = end;
  end_process();
  if (is_refused_) return give_up("");
  if (any_asked) account.breakdowns[question] = {end, std::exchange(account.final_errors, {})};
  to_ask_.insert(to_ask_.begin(), asked_.begin(), asked_.end());
  asked_.clear();
  if (!any_answer_ && any_asked)  // perhaps another function has answers
    std::stable_partition(
        to_ask_.begin(),
        std::find_if(to_ask_.begin(), to_ask_.end(),
                     [&](std::size_t i) { return questions_.is_repeat(i); }),
        [&](std::size_t i) { return questions_.group(i) != questions_.group(question); });
}

void Asker::died() {
  // The pipe closes a moment before the child is gone.
  for (int i = 0; i < 20 && !process_->has_ended(); ++i) {
    std::string ignored;
    process_->next_line(ignored, std::chrono::milliseconds(5));
    if (!process_->has_ended()) ::usleep(5000);
  }
  const std::string end = process_->has_ended() ? process_->end_text() : "closes its output";
  if (!any_answer_) account.exit_code_without_answer = process_->exit_code();
  if (asked_.empty() && to_ask_.empty()) return;
  fail(Outcome::died, fmt::format("it {}", end), end);
}

// Closes the input after the last answer. The subject should then end with exit code 0. Any other
// end is noted in the account, and so is a subject that stays; run() then kills it.
void Asker::hear_the_end() {
  if (!process_) return;
  process_->close_input();
  const Clock::time_point last =
      std::min(Clock::now() + questions_.limits.one_case, questions_.deadline);
  while (process_ && Clock::now() < last) {
    std::string line;
    const ChildProcess::Event event = process_->next_line(line, std::chrono::milliseconds(20));
    if (event == ChildProcess::Event::line) hear(line);
    if (event == ChildProcess::Event::too_long_line) return flooded();
    if (event != ChildProcess::Event::end_of_output) continue;
    if (process_->has_ended()) break;  // its last lines are heard, too
    ::usleep(2000);
  }
  if (!process_) return;
  account.stays = !process_->has_ended();
  if (!account.stays && process_->exit_code() != 0)
    account.bad_end = fmt::format("it {} after its last answer", process_->end_text());
}

void Asker::late() {
  const bool has_unread = process_->unread() > 0;
  if (!any_answer_ && has_unread) silent_failures_ = most_silent_failures;
  std::string hint;
  if (process_->is_within_a_line())
    hint = half_a_line;
  else if (!has_answered_ && (at_once_ || !has_unread) && !questions_.limits.flushes)
    hint = may_not_flush;
  const std::string limit_text = within(limit()) + hint;
  fail(Outcome::late, "no answer " + limit_text, "gives no answer " + limit_text);
}

void Asker::give_up(const std::string& why) {
  give_up(why, [](std::size_t) { return true; });
}

template <class Which>
void Asker::give_up(const std::string& why, Which&& which) {
  to_ask_.insert(to_ask_.begin(), asked_.begin(), asked_.end());
  asked_.clear();
  std::erase_if(to_ask_, [&](std::size_t i) {
    if (which(i) && !is_refused_ && i != questions_.greeting())
      questions_.reply(i) = {Outcome::not_asked, {}, why};
    return which(i);
  });
  end_process();
}

void Asker::end_process() {
  if (!process_) return;
  process_->kill();
  account.final_errors = process_->last_errors();
  account.cpu_seconds += process_->cpu_seconds();
  process_.reset();
}

}  // namespace tribo::conformance
