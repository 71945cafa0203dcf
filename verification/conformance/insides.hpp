// SPDX-License-Identifier: Apache-2.0
// The numbers inside of an operating point that its results are computed from, each of which a
// solver may have wrong alone.
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
    cut_off,   // it may be cut off
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
  // The choice of a scene, one of whose laws alone may have it wrong; empty: there is none.
  std::string_view choice = {};
  std::vector<Other> others = {};
};
const std::vector<Inside>& insides_of_points();

// "x/2 in place of x, in friction" where x is "x in friction".
std::string in_place_of(const std::string& other, const std::string& symbol);

// Another value of the inside, where it is a number.
Mistake mistake_of_inside(std::string name, std::string text, const Inside& inside, Get value);

// A mistake for each number that may stand in place of an inside, mistakes inside of points that
// are no other number, and the real area and the number of summits by the other asperity model.
std::vector<Mistake> mistakes_of_insides();

}  // namespace tribo::conformance
