// SPDX-License-Identifier: Apache-2.0
// The certified cases, and all that is said about a solver that answers them.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "conformance/diagnosis.hpp"

namespace tribo::conformance {

inline const std::string reference = TRIBOCHECK_SOURCE_DIR "/reference";

inline const std::vector<TestCase>& all_cases() {
  static const std::vector<TestCase> cases =
      read_cases({reference + "/exact", reference + "/published"});
  return cases;
}
// The cases that are not extreme.
inline const std::vector<TestCase>& usual_cases() {
  static const std::vector<TestCase> cases = cases_for(all_cases(), engineering_tolerance());
  return cases;
}
inline std::vector<TestCase> cases_of(std::string_view function,
                                      std::vector<TestCase> cases = usual_cases()) {
  std::erase_if(cases, [&](const TestCase& one) { return one.function != function; });
  return cases;
}

inline const std::vector<Mistake>& all_mistakes() {
  static const std::vector<Mistake> mistakes = read_mistakes(reference + "/mistakes.toml");
  return mistakes;
}

inline nlohmann::json right_answer(const TestCase& asked) {
  nlohmann::json fields;
  for (const Expected& one : asked.expected)
    fields[one.field] = one.word.empty() ? nlohmann::json(one.high) : nlohmann::json(one.word);
  return fields;
}

// All sentences about a solver. It does not offer what its answer is null for.
inline std::string all_said(const std::function<nlohmann::json(const TestCase&)>& answer,
                            const std::vector<Mistake>& mistakes = all_mistakes()) {
  std::vector<TestCase> cases;
  Conversation conversation;
  for (const TestCase& one : usual_cases())
    if (nlohmann::json fields = answer(one); !fields.is_null()) {
      cases.push_back(one);
      conversation.answers.push_back({Outcome::answered, std::move(fields), {}});
    }
  std::string said;
  for (const Diagnosis& one : diagnose(cases, conversation, engineering_tolerance(), mistakes))
    said += one.text + '\n';
  return said;
}

inline void expect_said(const std::string& said, const std::string& words, bool is_wanted = true) {
  EXPECT_EQ(said.find(words) != std::string::npos, is_wanted) << words << "\nsaid: " << said;
}

}  // namespace tribo::conformance
