// SPDX-License-Identifier: Apache-2.0
// The numbers inside an operating point from which its results are computed. A solver may have any
// one of them wrong.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/mistake.hpp"
#include "tribo/outputs.hpp"

namespace tribo::conformance {

using Get = std::function<double(const Question&)>;  // NaN: this question has none

struct Inside {
  enum class Kind {
    cut_off,   // the number may be cut off
    factor,    // it may be cut off, or multiplied by a number
    constant,  // a printed number, which may be another one
    replaced,  // other numbers of the point may stand in its place, and nothing else is sought
  };
  // A number of the point that may stand in its place, and the name of this mistake.
  struct Other {
    std::string name, symbol;
    Get get;
  };

  std::string symbol;  // "the gap in friction"
  Kind kind;
  Output place;  // the result that is computed from it first
  Get get;
  std::function<void(Question&, double)> set;
  // A choice of the scene: the number may be wrong with one of its laws alone. Empty: no choice.
  std::string_view choice = {};
  std::vector<Other> others = {};
};
const std::vector<Inside>& insides_of_points();

// The film h₀ of the scene's film formula, before the load is shared.
double smooth_film(const Question& asked);

// "x/2 in place of x, in friction" where x is "x in friction".
std::string in_place_of(const std::string& other, const std::string& symbol);

// Puts `value` in place of the inside, where both are finite.
Mistake mistake_of_inside(std::string name, std::string text, const Inside& inside, Get value);

// The mistakes inside points: other numbers in place of insides, mistakes that are not one other
// number, and the real area and the number of summits by another asperity model.
std::vector<Mistake> mistakes_of_insides();

}  // namespace tribo::conformance
