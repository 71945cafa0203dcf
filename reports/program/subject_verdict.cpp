// SPDX-License-Identifier: Apache-2.0
#include "conformance/readings.hpp"
#include "verify_subject.hpp"

namespace tribo::cli {

SubjectVerdict verdict_on(const std::string& subject, std::vector<conformance::TestCase>& cases,
                          conformance::Conversation conversation, const JudgedBy& by) {
  SubjectVerdict verdict;
  const std::vector<std::string> readings =
      take_readings(cases, conversation, by.tolerance, by.ways);
  verdict.result = judge(subject, cases, std::move(conversation), by.tolerance);
  verdict.result.sample = by.sample;
  std::vector<std::string>& notes = verdict.result.notes;
  notes.insert(notes.end(), readings.begin(), readings.end());
  verdict.diagnoses = diagnose(cases, verdict.result.conversation, by.tolerance, by.mistakes);
  return verdict;
}

}  // namespace tribo::cli
