// SPDX-License-Identifier: Apache-2.0
// The numbers that sources print, as C, a, b and c of a film's C Uᵃ Gᵇ Wᶜ, and those that a solver
// has in their place: one or two, found by its answers.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/mistake.hpp"
#include "conformance/wrong_numbers.hpp"

namespace tribo::conformance {

// A function's law as a formula of the numbers that its source prints.
struct LawOfNumbers {
  // The results at these arguments; empty: nothing is said there.
  std::function<std::optional<Numbers>(const catalogue::Arguments&, std::span<const double>)>
      formula;
  std::vector<double> right;  // the printed numbers; those that are 0 are not of the law
  struct NumberName {
    std::string before, right;  // "U^", and how the number is printed where it is no decimal
  };
  std::map<std::size_t, NumberName> names;  // of places; the others are decimals

  // "U^0.67"
  std::string in_words(std::size_t place, double number) const;
};
// Empty: the function's law has no printed numbers.
std::optional<LawOfNumbers> law_of_numbers(const catalogue::Function& function);

// The law with other numbers in place of its own, or with factors of inputs beside them.
struct FittedNumbers {
  std::size_t count;           // of what is changed: 1 to 3
  bool is_exchange;            // each number has the digits of its own in another order
  bool is_plausible;           // the numbers have few digits, and the factors are known ones
  std::vector<double> values;  // in place of the right ones
  std::string text;            // "0.231 in place of 0.213, and E*/2 in place of E*"
  std::function<double(const Question&, std::size_t place)> answer;
};
// Those that give the wrong answers of the part, single numbers first, pairs only where no
// plausible single number does, also of a number beside one of the mistakes, and three with
// exchanged digits only where no pair does; the caller looks whether the right answers stay right.
// Where all wrong answers are off by one factor, only what that can be is sought.
std::vector<FittedNumbers> fitted_numbers(const Part& part, const std::vector<Mistake>& mistakes,
                                          bool is_one_factor);

// Two numbers, or a number and a factor of an input, among all that a law by terms has; where these
// give some wrong answers, all are looked at.
std::vector<FittedNumbers> two_of_all_numbers(const Part& part);

// A number that gives some of the wrong answers, beside an input that is cut off where it does not.
std::vector<FittedNumbers> number_beside_cut(const Part& part);

// Three numbers among all that a law by terms has, or two beside a change of the law.
std::vector<FittedNumbers> three_at_once(const Part& part);

}  // namespace tribo::conformance
