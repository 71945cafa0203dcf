// SPDX-License-Identifier: Apache-2.0
// Answers that are right, but of something else: of another value of one input, of another result,
// or of nothing that changes.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "conformance/mistake.hpp"
#include "conformance/wrong_numbers.hpp"

namespace tribo::conformance {

// "u/2 in place of u": with this the right formula gives all wrong answers. It is solved for each
// input where an answer is wrong; what comes is a multiple of the input, a number, a sum, another
// input, or cut off, and has to give all other answers. "0.231 in place of 0.213": a number of the
// law likewise, or two of them, or one and a factor of an input, or one beside a known mistake.
// Empty: nothing of this does.
struct Misread {
  std::string text;
  std::function<double(const Question&, std::size_t place)> answer;  // with what is told first
  std::function<void(Question&)> change = {};  // the same of the question; empty: it is no such
};
std::optional<Misread> misread_input(const Part& part, const std::vector<Mistake>& mistakes);

// Three numbers of a law, or two beside another change of it, that give the wrong answers together.
std::optional<Misread> three_changes(const Part& part);

// "k = 1.03 where it is left out": the wrong answers are those to questions that leave this out,
// and are right with another default. Empty: no input is so.
std::string other_default(const Part& part);

// "All of these answers are 1e-09.", "… are the right semi_axis_y." or "… of barus_viscosity."
// Empty: they are neither one number, nor one number times an input, nor an input, nor another
// result, nor that of another function of these inputs.
std::string other_value(const Part& part);

// Mistakes of the numbers inside of points that wrong answers are solved for, several of which may
// be made together: factors that people know, printed constants, of all laws of a choice or of one.
std::vector<Mistake> solved_insides(const Part& part);

// The number that all wrong answers are, and that is more than all right ones where it is a floor,
// or less where it is a cap: the answer for a right one. Empty: they are none.
std::function<double(double right)> floor_or_cap(const Part& part);

// The number with so many digits; also one that is too small for all of a double's own digits.
double of_digits(double value, int digits);
// A number as people write it, with few digits, where that is within 1e-6 of it; else the number.
double round_number(double value);
// Whether four digits are the number, to 1e-6 of it, as those that a source prints.
bool is_of_few_digits(double value);
// A factor that people lose or gain, with the units between which it is, where it is of units.
struct FamiliarFactor {
  double value;
  const char* name;
  const char* origin = "";
};
// The one that this factor, or one over it, is so closely; null: it is none.
const FamiliarFactor* familiar_factor(double factor, double closeness);
// Whether people know the factor, or one over it: 2, π, 1000 …; 1 and −1 are among them.
bool is_familiar(double factor);
// "2 u", "u/2", "1.23 u": a symbol times a factor, by the name of the factor where people know it.
std::string times_in_words(double factor, const std::string& symbol);

}  // namespace tribo::conformance
