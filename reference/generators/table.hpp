// SPDX-License-Identifier: Apache-2.0
// The tables of reference/exact: their headers, and their rows one by one, so that any row can be
// made again alone. A row is admitted when its enclosure is narrower than 1e-40 relative and a
// second method's enclosure overlaps it.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "generators/ball.hpp"

namespace tribo::reference {

struct Header {
  std::string quantity, definition, units, domain, first_method, second_method;
  std::string inputs;  // the names of the input columns
};

struct Row {
  std::vector<std::string> words;  // they stand before the numbers
  std::vector<double> numbers;
  Ball value, second;
  Ball condition;
  std::string region;
};

inline std::string hexfloat(double x) { return fmt::format("{:a}", x); }

// The row's text: value to 40 digits, the same as high + low doubles, the condition number to 3
// digits; all are empty where the quantity is undefined.
inline std::string line(const std::string& id, const Row& row) {
  std::string text = id;
  for (const std::string& word : row.words) text += "," + word;
  for (const double number : row.numbers) text += "," + hexfloat(number);
  if (!is_finite(row.value) && !is_finite(row.second)) return text + ",,,,," + row.region;
  const bool is_zero = row.value == 0 && row.second == 0;
  if (!is_zero && (row.value.accurate_bits() < 133 || !overlaps(row.value, row.second)))
    throw std::runtime_error(fmt::format("row {} is not admitted: {} bits, {} {}", id,
                                         row.value.accurate_bits(), row.value.decimal(25),
                                         row.second.decimal(25)));
  const double high = row.value.nearest();  // 0 where the value is below the range of double
  const double low = (row.value - Ball(high)).nearest();
  return text + fmt::format(",{},{},{},{:.3g},{}", row.value.decimal(40), hexfloat(high),
                            hexfloat(low), row.condition.nearest(), row.region);
}

using Balls = std::vector<Ball>;

// The inputs on the way from one row to another: one number after the other is exchanged, and
// numbers that are the same are skipped. Such neighbouring rows reveal a solver that ignores one of
// its inputs.
using Numbers = std::vector<double>;
inline std::vector<Numbers> steps(Numbers from, const Numbers& to) {
  std::vector<Numbers> all{from};
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (from[i] == to[i]) continue;
    from[i] = to[i];
    all.push_back(from);
  }
  return all;
}

// Rows with one input at an end of its reach, and the others as usual. Such rows reveal a solver
// that limits an input, or whose law is fitted to only a part of the reach.
struct Reach {
  std::size_t input;  // its place
  double least, greatest;
};
inline std::vector<Numbers> at_ends(const Numbers& usual, const std::vector<Reach>& reaches) {
  std::vector<Numbers> all;
  for (const Reach& reach : reaches)
    for (const double end : {reach.least, reach.greatest}) {
      all.push_back(usual);
      all.back()[reach.input] = end;
    }
  return all;
}
// Combinations of inputs come this near to the ends of their reach, so that rounding does not carry
// them beyond.
inline constexpr double next_to_end = 0.999;

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

struct Table {
  Header header;
  std::string ids;                                   // the start of its rows' ids
  std::vector<std::function<std::string()>> rows{};  // each makes the text of its row

  void add(std::string id, std::function<Row()> make) {
    rows.emplace_back([id = std::move(id), make = std::move(make)] { return line(id, make()); });
  }
  void add(std::function<Row()> make) {
    add(fmt::format("{}{:04}", ids, rows.size()), std::move(make));
  }
  // Adds a row from a formula that is written in two ways, evaluated at the same inputs, with the
  // condition number of the first by differences.
  void add(std::vector<std::string> words, std::vector<double> numbers, Formula first,
           Formula second, const char* region) {
    add([=] {
      const Balls inputs(numbers.begin(), numbers.end());
      return Row{words, numbers, first(inputs), second(inputs), condition_of(first, inputs),
                 region};
    });
  }
};

// The tables. Each file of generators has one of these functions.
std::vector<Table> two_bodies();
std::vector<Table> gaussian_moments();
std::vector<Table> load_sharing_roots();
std::vector<Table> starvation();
std::vector<Table> hertz_contacts();
std::vector<Table> rough_faces();
std::vector<Table> adhesion();
std::vector<Table> film_formulas();
std::vector<Table> liquids();
std::vector<Table> operating_points();
std::vector<Table> film_laws();

}  // namespace tribo::reference
