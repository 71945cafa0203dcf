// SPDX-License-Identifier: Apache-2.0
// Wrong answers that are right for another value of one input or for another result, or that do not
// change.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "conformance/mistake.hpp"
#include "conformance/wrong_numbers.hpp"

namespace tribo::conformance {

// A reading with which the right formula gives all wrong answers: "u/2 in place of u". Each input
// is solved for at a wrong answer. Its value is read as a multiple, a number, a sum, another input,
// or a cut, which must give all other answers. Or numbers of the law are others: "0.231 in place of
// 0.213", two of them, one and a factor of an input, or one beside a known mistake.
struct Misread {
  std::string text;
  std::function<double(const Question&, std::size_t place)> answer;  // by the first of `text`
  std::function<void(Question&)> change = {};  // the same as a change of inputs; may be empty
};
// Empty: no reading gives all wrong answers.
std::optional<Misread> misread_input(const Part& part, const std::vector<Mistake>& mistakes);

// Three numbers of a law, or two beside another change of it, that give the wrong answers together.
std::optional<Misread> three_changes(const Part& part);

// "k = 1.03 where it is left out": all wrong answers are to questions that leave this input out,
// and are right with another default. Empty: there is no such input.
std::string other_default(const Part& part);

// "All 9 wrong answers are those of barus_viscosity." The wrong answers are one number, an input,
// one number times an input, another result, or the result of another function of these inputs.
// Empty: they are none of these.
std::string other_value(const Part& part);

// Mistakes in the numbers inside points, solved for at wrong answers: factors and constants that
// are familiar or have few digits, with all laws of a choice or one. Several can be made together.
std::vector<Mistake> solved_insides(const Part& part);

// The answer that a floor or a cap makes of a right one, if all wrong answers are one number and no
// right answer lies beyond it. Empty: it is neither a floor nor a cap.
std::function<double(double right)> floor_or_cap(const Part& part);

// The number rounded to so many digits; it may be subnormal.
double of_digits(double value, int digits);
// The number rounded to the fewest digits, up to six, that are within 1e-6 of it; else itself.
double round_number(double value);
// Whether the number has at most four digits, to a relative 1e-6, as a source may print it.
bool is_of_few_digits(double value);
// A factor that people often lose or gain, and how it may arise, as between units.
struct FamiliarFactor {
  double value;
  const char* name;
  const char* origin = "";
};
// The familiar factor that equals the factor or its inverse so closely. Null: there is none.
const FamiliarFactor* familiar_factor(double factor, double closeness);
// Whether the factor or its inverse is familiar: 2, π, 1000 …, 1 or −1.
bool is_familiar(double factor);
// "2 u", "u/2", "1.23 u": a symbol times a factor, by the name of the factor where people know it.
std::string times_in_words(double factor, const std::string& symbol);

}  // namespace tribo::conformance
