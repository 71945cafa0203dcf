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

  // The mistake that points have if this function is as the subject has it; null where it is not
  // known well enough at this question to the function. `is_shared_alike`: a film law's wrong
  // exponents are in the load sharing, too.
  const Mistake* at_points(const Question& inner, bool is_shared_alike = false) const;
  // How closely at_points() is known, as a part of what it changes.
  double closeness() const { return closeness_; }

 private:
  // The place where a result is wrong in one branch. Empty: it is wrong everywhere, or the place is
  // not known.
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
