// SPDX-License-Identifier: Apache-2.0
// tribocheck verify --subject: somebody else's solver put to the tests, and its verdict as a table,
// JSON, Markdown for a pull request, and JUnit XML.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "conformance/conformance.hpp"
#include "conformance/conformance_baseline.hpp"
#include "conformance/diagnosis.hpp"
#include "messages.hpp"

namespace tribo::cli {

struct SubjectArguments {
  std::string command;  // value of --subject
  std::string plugin;   // value of --plugin
  std::string exact;    // empty: reference/exact of the project
  std::string tolerance = "engineering";
  std::string format = "table";
  std::string junit;     // empty: none
  std::string baseline;  // empty: none
  bool update_baseline = false, force = false;
  std::vector<std::string> required;  // quantities that have to be held
  std::size_t sample = 0;             // cases of each function at most; 0: all
  double case_timeout = 10, start_timeout = 60, timeout = 600;  // s
  std::vector<std::string> shown;  // the cases to show; empty: all cases are judged
  std::string saved_cases;         // the file of --save-cases; empty: none, "-": stdout
};

// Exit code 0: all that is offered holds; 1: something failed, or nothing is offered; 2: bad input,
// or a subject that never answers. Without a subject the cases are shown or saved, and nothing is
// judged.
int verify_subject(const SubjectArguments& arguments, OutputStream& output);

struct SubjectVerdict {
  conformance::ConformanceResult result;
  std::vector<conformance::Diagnosis> diagnoses;
  std::vector<conformance::Example> examples;           // the worst of each failed quantity
  std::vector<std::string> notes;                       // remarks on the answers
  std::vector<std::string> last_errors;                 // lines of stderr
  std::string baseline;                                 // the file of --baseline
  std::optional<conformance::BaselineChanges> changes;  // changes against that file
  std::vector<conformance::QuantityNote> missing;       // named by --require, not held
};

// The reasons for exit code 1. With a baseline: all that is worse than the baseline. Without one:
// all that failed, or that nothing is offered. In both cases also all required quantities that are
// missing. All formats report the same reasons.
std::vector<conformance::QuantityNote> failures(const SubjectVerdict& verdict);

void append_subject_table(Text& to, const SubjectVerdict& verdict);
void append_subject_json(Text& to, const SubjectVerdict& verdict);
void append_subject_markdown(Text& to, const SubjectVerdict& verdict);
std::string subject_junit(const SubjectVerdict& verdict);

// One case of --show: the line that asks, what is expected, the answer, and how far off it is.
// append_request() alone is for a case that no subject is asked.
void append_request(Text& to, const conformance::TestCase& asked,
                    const conformance::Tolerance& tolerance);
void append_shown_case(Text& to, const conformance::TestCase& asked,
                       const conformance::Reply& answer,
                       const std::vector<conformance::Example>& examples);

// "PARTIAL: 9 of 14 quantities held, 5 not offered (tolerance: engineering)."
std::string summary(const SubjectVerdict& verdict);

}  // namespace tribo::cli
