// SPDX-License-Identifier: Apache-2.0
// A subject's verdict as a table, JSON, Markdown for a pull request, and JUnit XML.
#pragma once

#include <string>
#include <vector>

#include "conformance/conformance.hpp"
#include "conformance/conformance_baseline.hpp"
#include "conformance/diagnosis.hpp"
#include "output.hpp"

namespace tribo::cli {

struct SubjectVerdict {
  conformance::ConformanceResult result;
  std::vector<conformance::Diagnosis> diagnoses;
  std::vector<conformance::Example> examples;           // the worst of each failed quantity
  std::vector<std::string> notes;                       // on the answers
  std::vector<std::string> last_errors;                 // lines of stderr
  std::string baseline;                                 // the file of --baseline
  std::optional<conformance::BaselineChanges> changes;  // changes against that file
  std::vector<conformance::QuantityNote> missing;       // named by --require, not held
};

// The reasons for exit code 1. With a baseline: all that is worse than the baseline. Without one:
// all that failed, or that nothing is offered. In both cases also all that is missing. All formats
// report the same reasons.
std::vector<conformance::QuantityNote> failures(const SubjectVerdict& verdict);

void append_subject_table(Text& to, const SubjectVerdict& verdict);
void append_subject_json(Text& to, const SubjectVerdict& verdict);
void append_subject_markdown(Text& to, const SubjectVerdict& verdict);
std::string subject_junit(const SubjectVerdict& verdict);

// One case of --show: the line that asks, what is expected, the answer, and how far off it is. The
// first is for a case that nobody is asked.
void append_request(Text& to, const conformance::TestCase& asked,
                    const conformance::Tolerance& tolerance);
void append_shown_case(Text& to, const conformance::TestCase& asked,
                       const conformance::Reply& answer,
                       const std::vector<conformance::Example>& examples);

// "PARTIAL: 9 of 14 quantities held, 5 not offered (tolerance: engineering)."
std::string summary(const SubjectVerdict& verdict);

}  // namespace tribo::cli
