// SPDX-License-Identifier: Apache-2.0
// The numbers that sources print, such as C, a, b and c of a film's C Uᵃ Gᵇ Wᶜ, and up to three
// other numbers that a solver has in their place, found from its answers.
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
  std::vector<double> right;  // the printed numbers; 0: the law has no such number
  struct NumberName {
    std::string before, right;  // "U^"; "8/11", empty for a decimal
  };
  std::map<std::size_t, NumberName> names;  // by place; the other numbers are decimals

  // "U^0.67"
  std::string in_words(std::size_t place, double number) const;
};
// Empty: the function's law has no printed numbers.
std::optional<LawOfNumbers> law_of_numbers(const catalogue::Function& function);

// The law with other numbers in place of its own, or with factors of inputs beside them.
struct FittedNumbers {
  std::size_t count;           // of the changes: 1 to 3
  bool is_exchange;            // each has the digits of the right one in another order
  bool is_plausible;           // the numbers have few digits, and the factors are known ones
  std::vector<double> values;  // in place of the right ones
  std::string text;            // "0.231 in place of 0.213, and E*/2 in place of E*"
  std::function<double(const Question&, std::size_t place)> answer;
};
// The fits that give the wrong answers of the part. Pairs, also of a number and a mistake, are
// tried if no plausible single number fits, and three exchanges of digits if no pair fits. If all
// answers are off by one factor, only exchanged digits beside a familiar factor are tried after
// single numbers. The caller checks that the right answers stay right.
std::vector<FittedNumbers> fitted_numbers(const Part& part, const std::vector<Mistake>& mistakes,
                                          bool is_one_factor);

// Two numbers among all that a law by terms has, or one and a factor of an input, that give all
// wrong answers.
std::vector<FittedNumbers> two_of_all_numbers(const Part& part);

// A number that gives some of the wrong answers, and an input that is cut off in the others.
std::vector<FittedNumbers> number_beside_cut(const Part& part);

// Three numbers among all that a law by terms has, or two beside a change of the law.
std::vector<FittedNumbers> three_at_once(const Part& part);

}  // namespace tribo::conformance
