// SPDX-License-Identifier: Apache-2.0
// The questions to single functions from which the answer to a question is computed, and the
// mistake in operating points if one of these functions is wrong.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "conformance/mistake.hpp"
#include "conformance/place.hpp"
#include "conformance/wrong_numbers.hpp"

namespace tribo::conformance {

// The questions to functions from which the answer is computed. A point has its contact, film, load
// sharing, moments and inlet, as its scene chooses them; load_sharing has its moment.
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
  std::size_t wrong_answers() const { return wrong_answers_; }

  // The mistake in points that are computed with the subject's version of this function. Null: this
  // version is not known well enough at `inner`. `is_shared_alike`: the wrong exponents of a film
  // law are in the load sharing, too.
  const Mistake* at_points(const Question& inner, bool is_shared_alike = false) const;
  // The error of at_points(), relative to the change that it makes.
  double closeness() const { return closeness_; }

 private:
  // The place where a result is wrong in one branch. Empty: it is wrong everywhere, or the place is
  // not known.
  struct Branch {
    std::optional<WrongPlace> place;
  };

  void find_slip(const std::vector<AnsweredCase>& cases, const std::vector<Mistake>& named);

  std::string name_;
  std::size_t wrong_answers_ = 0;
  std::map<std::string, std::vector<Branch>> branches_;  // by name; one for each wrong result
  std::optional<Mistake> slip_, at_points_, with_sharing_;
  double closeness_ = 0;
};

}  // namespace tribo::conformance
