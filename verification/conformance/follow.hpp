// SPDX-License-Identifier: Apache-2.0
// The questions to single functions that a question is computed from, and what becomes of a point
// where one of these functions is wrong.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "conformance/mistake.hpp"
#include "conformance/place.hpp"
#include "conformance/wrong_numbers.hpp"

namespace tribo::conformance {

// The questions to functions that the answer is computed from: of a point its contact, film, load
// sharing, moments and inlet, as its words choose them; of load_sharing its moment.
std::vector<Question> inner_questions(const Question& question);

// The question to Hertz' function of the scene's shape.
Question contact_question(const Scene& scene);

// A function that a subject gets wrong.
class WrongFunction {
 public:
  // `named`: mistakes that were named as the cause.
  WrongFunction(std::string name, std::vector<AnsweredCase> cases,
                const std::vector<Mistake>& named);

  const std::string& name() const { return name_; }
  bool is_wrong_at(const Question& inner) const;

  // Points in which this function is as the subject has it; null: it is not known well enough at
  // this question to it. Of a film law its exponents may be in the load sharing, too.
  const Mistake* at_points(const Question& inner, bool is_shared_alike = false) const;
  // How closely at_points() is known, as a part of what it changes.
  double closeness() const { return closeness_; }

 private:
  // One branch, with the place where it is wrong. Empty: wrong everywhere, or nobody knows where.
  struct Branch {
    std::optional<WrongPlace> place;
  };

  void find_slip(const std::vector<AnsweredCase>& cases, const std::vector<Mistake>& named);

  std::string name_;
  std::map<std::string, std::vector<Branch>> branches_;  // the wrong ones, one for each result
  std::optional<Mistake> slip_, at_points_, with_sharing_;
  double closeness_ = 0;
};

}  // namespace tribo::conformance
