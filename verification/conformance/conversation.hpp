// SPDX-License-Identifier: Apache-2.0
// Asking a subject all cases: one answer or one clear reason for each, whatever it does.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "conformance/conformance_case.hpp"

namespace tribo::conformance {

// A line that a subject wrote; discarded where it is no JSON. JSON has no NaN, Infinity or 1e999,
// but many a library writes them: they become texts, so that only the field that has one is wrong.
nlohmann::json read_answer_line(const std::string& line);

// Where a line stops being JSON, with the text around it.
std::string why_no_json(const std::string& line);

// The value on one line, in ASCII; bytes that are no UTF-8 are replaced.
std::string line_of(const nlohmann::json& value);

// The start of a text, printable, for one line of a message.
std::string start_of(const std::string& text);

// Lines that follow each other and are of one kind become the first of them, and "  and 19 more
// like it: names"; up to three stay as they are.
struct KindLine {
  std::string text, kind, name;  // the name may be empty
};
std::vector<std::string> without_repeats(const std::vector<KindLine>& lines);

// The last line of what a program wrote to stderr, without the name of this program in front.
std::string last_line(std::string errors);

enum class Outcome : std::uint8_t {
  answered,
  skipped,    // {"skip": reason}
  refused,    // {"error": …}
  garbage,    // its answer is no JSON object, or the output is flooded
  missing,    // later cases were answered, this one not
  late,       // no answer within the limit of a case
  died,       // the subject ended, or closed a stream, when it owed this answer
  not_asked,  // it had died too often, or the limit of all cases was reached
};

struct Reply {
  Outcome outcome = Outcome::not_asked;
  nlohmann::json fields{};  // of an answer
  std::string reason{};     // of anything else
  // Where it was asked: "as question 12 of its process, after h0002", or of a plug-in "at place 3
  // of an array of 32". Empty where no answer came.
  std::string place{};
};

// An answer that was read, with its reason where it is none.
Reply reply_of(nlohmann::json answer);
// Answers are kept until all are judged. Of an answer that is longer than this, in bytes, only the
// part that was asked for is kept.
inline constexpr std::size_t longest_kept_answer = 4096;

struct Limits {
  std::chrono::milliseconds one_case{10000};
  std::chrono::milliseconds first_answer{60000};  // of each process: it may have much to load
  std::chrono::milliseconds all_cases{600000};
  // It is a plug-in in our own process: it writes each answer at once, and may tell its place.
  bool flushes = false;
};

// How many are asked at once, and what is asked twice.
struct Manner {
  int processes = 1;               // of the subject
  std::vector<std::size_t> again;  // cases, in rising order
};

// Wall time of the run, CPU time of all of the subject's processes, and for each function the wall
// time from one answer to the next, added up over all processes that are asked at once; in s.
struct Durations {
  double run = 0, cpu = 0;  // s
  std::map<std::string, double> functions;
};

struct Conversation {
  std::vector<Reply> answers;           // in the order of the cases
  std::vector<std::size_t> again;       // the cases that were asked twice
  std::vector<Reply> second_answers;    // to these
  std::vector<std::string> violations;  // of the protocol: the first few, one line each
  std::size_t violation_count = 0;
  std::size_t print_count = 0;  // lines between the answers that are no answers
  std::string first_print;
  int starts = 0;           // of the subject, but for processes beside the first
  std::string last_errors;  // what it wrote to stderr last
  // The last lines of that, where cases have no answer: a whole error message.
  std::vector<std::string> error_lines;
  bool answers_at_end_of_input = false;  // it does not flush its answers
  std::string never_answered;            // why; empty where any case has an answer
  int exit_code_without_answer = -1;     // of a subject that ended and never answered
  bool stays = false;                    // it does not end when its input has ended
  Durations seconds;
};

// Asks all cases. `progress` is called with the number of settled cases. Which process is asked
// which case follows from the cases alone: several processes give the conversation that one process
// gives, but for durations, if each answer depends on its question alone. At the end each process
// is asked those of its cases that are in `again` a second time, in the opposite order; the second
// answers do not count as further cases.
Conversation ask(const std::string& command, const std::vector<TestCase>& cases,
                 const Limits& limits, const std::function<void(std::size_t)>& progress,
                 const Manner& manner = {});

// The cases to ask twice: every 24th of each function and of the paper's scenes, and the first.
std::vector<std::size_t> cases_to_repeat(const std::vector<TestCase>& cases);

}  // namespace tribo::conformance
