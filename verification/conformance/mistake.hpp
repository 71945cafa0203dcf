// SPDX-License-Identifier: Apache-2.0
// Known mistakes, and the answers if one or several of them are made. Each is a formula that people
// have written, not a guess at a number. They are listed in reference/mistakes.toml.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "conformance/question.hpp"

namespace tribo::conformance {

// A mistake changes the question, the formula or the results. Mistakes can be made together if no
// two of them touch the same thing. Factors touch nothing.
struct Mistake {
  std::string function;              // whose cases it is about
  std::string name;                  // "hertz-radius-halved"
  std::string text;                  // "R/2 in place of R (a ball on a flat has R)"
  std::string follows = {};          // the name of a mistake elsewhere that this one follows from
  std::vector<std::string> touches;  // inputs, results, numbers of the film's law, or "formula"

  // Each of these may be empty.
  std::function<bool(const Question&)> applies = {};  // without it: everywhere
  std::function<void(Question&)> before = {};         // misreads the question
  // Another formula. Its result is empty if it says nothing of the question.
  std::function<std::optional<Numbers>(const Question&)> instead = {};
  std::function<void(const Question&, Numbers&)> after = {};  // changes the results
  // The numbers of the other formula, if it has some, and this formula with any numbers.
  std::vector<double> numbers = {};
  std::function<std::optional<Numbers>(const catalogue::Arguments&, std::span<const double>)>
      of_numbers = {};

  bool can_stand_beside(const Mistake& other) const;
};

// The results when all of these mistakes are made; empty: they say nothing of this question.
std::optional<Numbers> numbers_with(std::span<const Mistake* const> mistakes,
                                    const Question& question);

// Whether the function is a film law of scenes with fixed exponents a ≠ b of Uᵃ Gᵇ.
bool is_film_of_points(std::string_view function);

// All mistakes of the file, for single functions and for operating points, and those of
// insides.hpp. Throws std::runtime_error with one line: file, entry, what is wrong.
std::vector<Mistake> read_mistakes(const std::string& path);

}  // namespace tribo::conformance
