// SPDX-License-Identifier: Apache-2.0
// A subject's verdict as a table, JSON, Markdown for a pull request, and JUnit XML.
#pragma once

#include <string>
#include <vector>

#include "conformance/conformance_baseline.hpp"
#include "conformance/diagnosis.hpp"
#include "output.hpp"

namespace tribo::cli {

struct SubjectVerdict {
  conformance::ConformanceResult result;
  std::vector<conformance::Diagnosis> diagnoses;
  std::optional<conformance::BaselineChanges> changes;  // with --baseline
};

void append_subject_table(Text& to, const SubjectVerdict& verdict);
void append_subject_json(Text& to, const SubjectVerdict& verdict);
void append_subject_markdown(Text& to, const SubjectVerdict& verdict);
std::string subject_junit(const SubjectVerdict& verdict);

// "PARTIAL: 9 of 14 quantities held, 5 not offered; none failed."
std::string summary(const conformance::ConformanceResult& result);

}  // namespace tribo::cli
