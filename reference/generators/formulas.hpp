// SPDX-License-Identifier: Apache-2.0
// Rows of formulas: two texts of a formula at the same inputs, and the condition by differences.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "generators/load_sharing_root.hpp"
#include "generators/quantities.hpp"

namespace tribo::reference {

using Balls = std::vector<Ball>;
using Formula = std::function<Ball(const Balls& inputs)>;

// The sum of |d ln value/d ln input| by steps of 2^-100, at least 1.
inline Ball condition_of(const Formula& formula, const Balls& inputs) {
  const Ball step = pow(Ball(2), Ball(-100)), value = formula(inputs);
  Ball sum = 0;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    Balls moved = inputs;
    moved[i] = (inputs[i] * (1 + step)).midpoint();
    sum += abs(formula(moved) / value - 1) / step;
  }
  return sum < 1 ? Ball(1) : sum.midpoint();
}

// Words stand before the numbers.
inline Row formula_row(const std::string& id, std::vector<std::string> words,
                       const std::vector<double>& numbers, const Formula& first,
                       const Formula& second, const char* region) {
  const Balls inputs(numbers.begin(), numbers.end());
  for (const double number : numbers) words.push_back(hexfloat(number));
  return {id, std::move(words), first(inputs), second(inputs), condition_of(first, inputs), region};
}

// The number x > 0 with x^q = power: by bisection on whole powers.
inline Ball root_of_power(const Ball& power, int q) {
  return bisect(
      [&](const Ball& x) {
        const Ball excess = pow(x, Ball(q)) - power;
        return excess < 0 ? -1 : excess > 0 ? 1 : 0;
      },
      pow(Ball(2), Ball(-2000)), pow(Ball(2), Ball(2000)));
}

}  // namespace tribo::reference
