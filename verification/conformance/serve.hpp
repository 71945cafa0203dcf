// SPDX-License-Identifier: Apache-2.0
// Makes a C++ solver answer tribocheck: offer its functions, link tribocheck::conformance_serve.
//
//   int main() {
//     tribo::conformance::Solver solver;
//     solver.offer("gaussian_moment", [](double order, double argument) {
//       return my_moment(order, argument);
//     });
//     return tribo::conformance::serve(solver);
//   }
//
//   tribocheck verify --subject ./my_solver
//
// All numbers are in SI units. `tribocheck functions NAME` lists the arguments of a function in
// their order. Formulas, symbols and ranges: model/README.md. All cases are in range.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "catalogue/catalogue.hpp"
#include "tribo/mixed_contact.hpp"

namespace tribo::conformance {

// The meaning of a result that is not finite. not_offered: the solver does not offer this result;
// all results are not_offered before the call. Infinity: the result is undefined at this point. Any
// other NaN is an error; only if the regime is collapsed, it means that a number which depends on
// the balance of the load is undefined. A function with only one result always offers it.
inline constexpr double not_offered = std::bit_cast<double>(std::uint64_t{0x7FF8'6E6F'7468'6572});
inline bool is_not_offered(double number) {
  return std::bit_cast<std::uint64_t>(number) == std::bit_cast<std::uint64_t>(not_offered);
}
inline constexpr double undefined_here = std::numeric_limits<double>::infinity();

// A result that is a word.
template <class Word>
struct WordResult {
  enum class Kind : std::uint8_t { absent, undefined, word };
  WordResult() = default;
  WordResult(Word given) : kind(Kind::word), word(given) {}
  Kind kind = Kind::absent;  // not offered
  Word word{};
};

// Meaning and units: tribo/outputs.hpp.
struct PointResult {
  PointResult() { numbers.fill(not_offered); }
  double& operator[](Output output) { return numbers[static_cast<std::size_t>(output)]; }

  std::array<double, number_count> numbers;  // in the order of Output
  WordResult<Regime> regime;
  WordResult<Inlet> inlet;
};

// How a case ended, and the reason that takes the place of a result.
enum class Status : std::uint8_t { done, skipped, undefined, failed };
struct NoResult {
  Status status;
  std::string reason;
};
inline NoResult skip(std::string reason) { return {Status::skipped, std::move(reason)}; }
inline NoResult undefined(std::string reason) { return {Status::undefined, std::move(reason)}; }
inline NoResult failed(std::string reason) { return {Status::failed, std::move(reason)}; }

template <class Result>
struct Answer {
  Answer() = default;
  Answer(Result given) : result(std::move(given)), status(Status::done) {}
  Answer(NoResult none) : status(none.status), reason(std::move(none.reason)) {}
  Result result{};
  Status status = Status::failed;
  std::string reason = "no answer was given";
  std::size_t place = 0, of = 0;  // place in an array of `of` cases, from 1; 0: not known
};

// Answers several cases; both spans have the same size, at least 1.
template <class Asked, class Result>
using Batch = std::function<void(std::span<const Asked>, std::span<Answer<Result>>)>;

// The arguments of a function are in the order of `tribocheck functions NAME`. A word is given by
// its place in the list of words. The results fill the first places.
using FunctionBatch = Batch<catalogue::Arguments, catalogue::Results>;

// One argument, for a parameter that is a number or one of the enumerations in tribo/scene.hpp.
class Argument {
 public:
  explicit Argument(double value) : value_(value) {}
  operator double() const { return value_; }
  template <class Word>
  requires std::is_enum_v<Word>
  operator Word() const { return static_cast<Word>(static_cast<int>(value_)); }

 private:
  double value_;
};

// Makes a function of several cases from a function of one case, which returns a result, a NoResult
// or an Answer. If it throws, the case failed with the message as the reason.
template <class Function>
auto each(Function function) {
  return [function = std::move(function)](auto cases, auto answers) {
    for (std::size_t i = 0; i < cases.size(); ++i) try {
        answers[i] = function(cases[i]);
      } catch (const std::exception& error) {
        answers[i] = failed(error.what());
      }
  };
}

// The questions that a solver answers; other questions are skipped.
class Solver {
 public:
  // Offers the function of this name. `function` takes its arguments one by one, in the order of
  // `tribocheck functions NAME`, and returns a number, all results in an array, or an Answer or
  // NoResult in place of these. Throws std::invalid_argument if the catalogue has no such function,
  // or one with another number of arguments.
  template <class Function>
  void offer(std::string_view name, Function function) {
    offer_of(name, std::move(function), std::index_sequence<>());
  }
  void offer_batch(std::string_view name, FunctionBatch batch);

  // Empty where the function is not offered.
  const FunctionBatch& batch(const catalogue::Function& function) const;

  Batch<Scene, PointResult> operating_point;  // of a scene with one speed

 private:
  static Answer<catalogue::Results> answer_of(double value) { return catalogue::Results{value}; }
  static Answer<catalogue::Results> answer_of(NoResult none) { return none; }
  static Answer<catalogue::Results> answer_of(Answer<catalogue::Results> answer) { return answer; }
  static Answer<catalogue::Results> answer_of(const Answer<double>& answer) {
    if (answer.status == Status::done) return catalogue::Results{answer.result};
    return NoResult{answer.status, answer.reason};
  }
  template <std::size_t count>
  static Answer<catalogue::Results> answer_of(const std::array<double, count>& values) {
    static_assert(count <= catalogue::most_results);
    catalogue::Results results;
    results.fill(not_offered);
    std::copy(values.begin(), values.end(), results.begin());
    return results;
  }

  // Finds by recursion how many arguments `function` takes.
  template <class Function, std::size_t... places>
  void offer_of(std::string_view name, Function function, std::index_sequence<places...>) {
    if constexpr (std::invocable<Function, decltype((void)places, std::declval<Argument>())...>) {
      check_arguments(name, sizeof...(places));
      offer_batch(name, each([function = std::move(function)](const catalogue::Arguments& a) {
                    return answer_of(function(Argument(a[places])...));
                  }));
    } else {
      static_assert(sizeof...(places) < catalogue::most_parameters,
                    "a function takes numbers, or the enumerations of tribo/scene.hpp");
      offer_of(name, std::move(function), std::make_index_sequence<sizeof...(places) + 1>());
    }
  }
  static void check_arguments(std::string_view name, std::size_t count);

  std::map<const catalogue::Function*, FunctionBatch> functions_;
};

// Answers JSON lines from stdin on stdout until the input ends: the protocol of `tribocheck verify
// --subject`. From then on, text that the solver prints to stdout goes to stderr. Returns an exit
// code: 0, or 1 if input or output failed, after a line on stderr.
int serve(const Solver& solver);

// The same, but writes the answers to the descriptor `answers`, for callers that have used
// take_stdout() before. With `tells_places` an answer has its place in the array that was passed to
// the solver: "place": "place 3 of an array of 32".
int serve(const Solver& solver, int answers, bool tells_places = false);

// Returns a copy of stdout, or −1 if there is no stdout. From then on, output to stdout goes to
// stderr, or nowhere if stderr is closed.
int take_stdout();

}  // namespace tribo::conformance
