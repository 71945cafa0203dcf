// SPDX-License-Identifier: Apache-2.0
// tribocheck verify --subject: somebody else's solver put to the tests, and its verdict as a table,
// JSON (reference/schemas/verify-subject.schema.json), Markdown for a pull request, and JUnit XML.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "conformance/conformance.hpp"
#include "conformance/conformance_baseline.hpp"
#include "conformance/diagnosis.hpp"
#include "conformance/ways.hpp"
#include "messages.hpp"

namespace tribo::cli {

// All options of `tribocheck verify`. Where there is no subject, and no cases are shown or saved,
// most of the options must have the default values below.
struct SubjectArguments {
  std::string command;  // value of --subject
  std::string plugin;   // value of --plugin
  std::string exact;    // empty: reference/exact of the project
  std::string tolerance = "engineering";
  conformance::AskedWays ways;  // the numbers that the subject takes
  std::string format = "table";
  std::string junit;  // empty: none
  conformance::BaselineUse baseline;
  std::vector<std::string> required;  // quantities that have to be held
  std::size_t sample = 0;             // cases of each function at most; 0: all
  double case_timeout = 10, start_timeout = 60, timeout = 600;  // s
  int jobs = 1;                    // processes of the subject that are asked at once
  std::vector<std::string> shown;  // the cases to show; empty: all cases are judged
  std::string saved_cases;         // the file of --save-cases; empty: none, "-": stdout

  bool has_subject() const { return !command.empty() || !plugin.empty(); }
};

// Exit code 0: all that is offered holds; 1: something failed, or nothing is offered; 2: bad input,
// or a subject that never answers. Without a subject the cases are shown or saved, and nothing is
// judged.
int verify_subject(SubjectArguments arguments, OutputStream& output);

struct SubjectVerdict {
  conformance::ConformanceResult result;
  std::vector<conformance::Diagnosis> diagnoses;
  std::vector<conformance::QuantityNote> missing;  // named by --require, not held
  std::string baseline;                            // the file of --baseline
  std::string same_question;  // the start of a command line that asks this subject again
  std::optional<conformance::BaselineChanges> changes;  // changes against that file
};

// The rules by which a subject is judged.
struct JudgedBy {
  conformance::Tolerance tolerance;
  conformance::AskedWays ways;
  std::vector<conformance::Mistake> mistakes;  // that are known
  std::size_t sample = 0;                      // as cases_for() has it
};
// The verdict on the answers to these cases, with the diagnoses of what failed. Where the answers
// follow another reading of a law, the expected numbers in `cases` are changed to that reading.
SubjectVerdict verdict_on(const std::string& subject, std::vector<conformance::TestCase>& cases,
                          conformance::Conversation conversation, const JudgedBy& by);

// The reasons for exit code 1, which all formats report: all that is worse than the baseline (or,
// if there is none, all that failed, or that nothing is offered), and all required quantities that
// are missing.
std::vector<conformance::QuantityNote> failures(const SubjectVerdict& verdict);

// format: "table", "json" or "markdown".
void append_verdict(Text& to, const SubjectVerdict& verdict, const std::string& format);
std::string subject_junit(const SubjectVerdict& verdict);

// One case of --show: the line that asks, what is expected, the answer, and how far off it is.
// append_request() writes the line and what is expected, if there is no subject.
void append_request(Text& to, const conformance::TestCase& asked,
                    const conformance::Tolerance& tolerance);
void append_shown_case(Text& to, const conformance::TestCase& asked,
                       const conformance::ConformanceResult& result);

}  // namespace tribo::cli
