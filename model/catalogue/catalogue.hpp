// SPDX-License-Identifier: Apache-2.0
// The catalogue of functions: each function of the model by its name, with its parameters and
// results, the bound on its error, and its source. The catalogue determines the lines of
// `tribocheck stream`, `tribocheck functions`, the model's own check against certified values, the
// cases that other solvers are asked, the functions that solvers can register, and the files of
// `tribocheck init`.
//
// A function is added by its header in include/tribo, one entry in the file of its family
// (families.hpp), and one function of reference/generators that makes its certified values,
// reference/exact/<name>.csv, in columns named as the parameters.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "tribo/contract.hpp"

namespace tribo {
struct FilmLaw;
}

namespace tribo::catalogue {

// Which numbers are legal; half_order: 0, 1/2 … 5/2; poisson_ratio: above −1, at most 1/2.
enum class Range : std::uint8_t {
  above_zero,
  not_below_zero,
  not_zero,
  any,
  half_order,
  poisson_ratio
};
constexpr bool is_in_range(double number, Range range) {
  switch (range) {
    case Range::above_zero:
      return number > 0;
    case Range::not_below_zero:
      return number >= 0;
    case Range::not_zero:
      return number < 0 || number > 0;
    case Range::poisson_ratio:
      return number > -1 && number <= 0.5;
    case Range::half_order:
      return number >= 0 && number <= 2.5 && 2 * number == static_cast<int>(2 * number);
    case Range::any:
      break;
  }
  return true;
}

struct Parameter {
  std::string_view name;  // "reduced_radius"
  std::string_view meaning;
  std::string_view unit = "";       // SI; empty: dimensionless
  Range range = Range::above_zero;  // of numbers
  // The range of a number in contacts on earth, generously. A number outside it is not refused.
  double least = 0, greatest = 0;
  // If not empty, the argument is one of these words, in the order of their enumeration.
  std::span<const std::string_view> words = {};
  std::optional<double> default_value = {};
};
// The place of a word among the words of a parameter, which stands for the word in Arguments. Empty
// if the parameter has no such word.
std::optional<double> place_of(std::string_view word, const Parameter& parameter);
// "a number above 0", or the words
std::string allowed_text(const Parameter& parameter);
// The same with the unit: "a number above 0, in Pa".
std::string allowed_with_unit(const Parameter& parameter);
// The default as text: a number, or the word without quotes. The parameter has to have a default.
std::string default_text(const Parameter& parameter);

struct Result {
  std::string_view name;  // "value" where it is the only one
  std::string_view meaning;
  std::string_view unit = "";
};

inline constexpr std::size_t most_parameters = 10, most_results = 6;
using Arguments = std::array<double, most_parameters>;
using Results = std::array<double, most_results>;

// A number that several arguments make together, such as the exponent αp, and a generous range of
// it in contacts on earth. Certified cases reach both ends of the range; a program may refuse
// numbers beyond it.
struct Combination {
  std::string_view name;  // "load_number"
  std::string_view meaning;
  std::string_view unit = "";
  double least = 0, greatest = 0;
  double (*value)(const Arguments& arguments);
  std::string_view parameter;  // the number is monotonic in this argument
};

// One argument of many points: numbers[i] is that of point i. If `is_same`, all points have
// numbers[0]; numbers[i] may still be read.
struct Column {
  const double* numbers = nullptr;
  bool is_same = false;
};

// Why arguments are refused although each of them alone is legal.
struct Refusal {
  std::string_view parameter;  // its name
  std::string_view reason;     // a sentence
};

struct Function {
  std::string_view name;  // "hamrock_dowson_central"
  std::string_view meaning;
  std::string_view equation;
  std::string_view source;  // who, when, where, which equation; what is mended in it
  std::span<const Parameter> parameters;
  std::span<const Result> results;
  // Computes the results. The arguments are in the order of the parameters, and each is legal; a
  // word is given by its place. Results are NaN for arguments that refusal() refuses.
  void (*value)(const Arguments& arguments, Results& results);
  Contract contract;
  Arguments example;  // legal, for a line that shows how to ask
  // Null: no arguments are refused if each of them is legal.
  std::optional<Refusal> (*refusal)(const Arguments& arguments) = nullptr;
  const FilmLaw* film_law = nullptr;  // the row of a film law; else null
  std::span<const Combination> combinations = {};
  // As value(), with the same bits, for the columns (columns.hpp) of many points. All arguments are
  // legal, and no result is NaN. Null: nothing is faster than value() at each point. A function
  // with refusal() has no values().
  void (*values)(std::size_t count, const Column* argument, double* const* result) = nullptr;
};
// Whether a contact on earth can have these arguments: each number and each combination of them is
// in its range.
bool is_physical(const Function& function, const Arguments& arguments);

// The film by `law` at the arguments of `function`, which has a film law of its own.
double film_by(const FilmLaw& law, const Function& function, const Arguments& arguments);

std::span<const Function> functions();
const Function* function_named(std::string_view name);  // null where there is no such function

}  // namespace tribo::catalogue
