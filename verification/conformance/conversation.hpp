// SPDX-License-Identifier: Apache-2.0
// Asks a subject all cases, and has one answer or one clear reason for each case, whatever the
// subject does.
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

// Parses a line that a subject wrote. The result is discarded if the line is not JSON. JSON has no
// NaN, Infinity or 1e999, but many libraries write them: each is read as a text, so that only the
// field that has it is wrong.
nlohmann::json read_answer_line(const std::string& line);

// Why a line is not a JSON object: where it stops being JSON, with the text around this place, or
// what else it is.
std::string why_no_json(const std::string& line);

// The value on one line, in ASCII. Bytes that are not UTF-8 are replaced.
std::string line_of(const nlohmann::json& value);

// The start of a text with all signs printable, for one line of a message.
std::string start_of(const std::string& text);

// Shortens a list. If more than three lines in a row are of one kind, only the first is kept, and a
// line "  and 19 more like it: names" follows it.
struct KindLine {
  std::string text, kind, name;  // `name` may be empty
};
std::vector<std::string> without_repeats(const std::vector<KindLine>& lines);

// The last line of what a program wrote to stderr, without the name of this program in front.
std::string last_line(std::string errors);

enum class Outcome : std::uint8_t {
  answered,
  skipped,    // {"skip": reason}
  refused,    // {"error": …}
  garbage,    // its answer is not a JSON object, or the subject floods its output
  missing,    // later cases were answered, but not this one
  late,       // no answer within the limit of a case
  died,       // the subject ended, or closed a stream, while it owed this answer
  not_asked,  // the subject had died too often, or the time for all cases was over
};

struct Reply {
  Outcome outcome = Outcome::not_asked;
  nlohmann::json fields{};  // the members of an answer
  std::string reason{};     // why there is no answer
  // Where the subject was asked: "as question 12 of its process, after h0002", or, for a plug-in,
  // "at place 3 of an array of 32". It is empty if no answer came.
  std::string place{};
};

// The reply that a JSON object of the subject is: an answer, a skip or a refusal, with its reason.
Reply reply_of(nlohmann::json answer);
// All answers are kept until they are judged. If the line of an answer is longer than this, in
// bytes, only the members that were asked for are kept.
inline constexpr std::size_t longest_kept_answer = 4096;

struct Limits {
  std::chrono::milliseconds one_case{10000};
  std::chrono::milliseconds first_answer{60000};  // for each process, which may have much to load
  std::chrono::milliseconds all_cases{600000};
  // True for a plug-in. It runs in a process of this program, which writes each answer at once and
  // may tell its place.
  bool flushes = false;
};

// The number of processes that are asked at once, and the cases that are asked twice.
struct Manner {
  int processes = 1;               // number of processes of the subject
  std::vector<std::size_t> again;  // the cases to ask twice, in rising order
};

// Times in s: the wall time of the run, the CPU time of all processes of the subject, and for each
// function the sum of the wall times from one answer to the next in each process.
struct Durations {
  double run = 0, cpu = 0;  // wall time and CPU time
  std::map<std::string, double> functions;
};

struct Conversation {
  std::vector<Reply> answers;           // in the order of the cases
  std::vector<std::size_t> again;       // the cases that were asked twice
  std::vector<Reply> second_answers;    // the answers to these cases when asked again
  std::vector<std::string> violations;  // the first few violations of the protocol, one line each
  std::size_t violation_count = 0;
  std::size_t print_count = 0;  // lines between the answers that are no answers
  std::string first_print;
  // How often one process at a time would have had to be started; 0 if nothing was ever answered.
  int starts = 0;
  std::string last_errors;  // the last part of what it wrote to stderr
  // The last lines of last_errors: a whole error message if a case got no answer, else one line.
  std::vector<std::string> error_lines;
  bool answers_at_end_of_input = false;  // it does not flush its answers
  std::string never_answered;            // the reason; empty if any case has an answer
  int exit_code_without_answer = -1;     // that of a subject that ended and never answered
  bool stays = false;                    // it does not end when its input has ended
  Durations seconds;
};

// Asks all cases. `progress` is called with the number of settled cases. The cases alone decide
// which process is asked which case. If each answer depends only on its question, several processes
// therefore give the same conversation as one, except for durations. At the end each process is
// asked again those of its cases that are in `again`, in the opposite order. These second answers
// do not count as settled cases.
Conversation ask(const std::string& command, const std::vector<TestCase>& cases,
                 const Limits& limits, const std::function<void(std::size_t)>& progress,
                 const Manner& manner = {});

// The cases to ask twice: the first one of each function and of each scene of the paper, and every
// 24th after it.
std::vector<std::size_t> cases_to_repeat(const std::vector<TestCase>& cases);

}  // namespace tribo::conformance
