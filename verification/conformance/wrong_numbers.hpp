// SPDX-License-Identifier: Apache-2.0
// The numbers that a subject answered for one function, each beside what is expected: where the
// wrong ones lie, and how they are off.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "conformance/conformance.hpp"
#include "conformance/question.hpp"

namespace tribo::conformance {

struct AnsweredNumber {
  const Expected* expected;
  std::size_t place;  // in Numbers
  double got;
  double allowed;  // absolute error
  bool is_wrong;
  bool is_explained = false;  // by a mistake that was named

  bool is_left() const { return is_wrong && !is_explained; }  // to be told
  double error() const { return (got - expected->high) - expected->low; }
};

struct AnsweredCase {
  Question question;
  // The case's branch of the function, because one branch may be wrong alone: "order 1.5",
  // "greenwood_tripp". Empty: the function has no branches.
  std::string branch;
  std::vector<AnsweredNumber> numbers;
};

// The answered cases of a function, without fields that are no finite number.
std::vector<AnsweredCase> answered_cases(const std::string& function,
                                         const std::vector<TestCase>& cases,
                                         const Conversation& conversation,
                                         const Tolerance& tolerance);

// Numbers as a product of powers of a function's inputs, by least squares on logarithms.
struct PowerLaw {
  std::vector<double> exponents;  // of each parameter; 0 for those that were held fixed
  double constant = 0;            // with its sign
  double residual = 0;            // the greatest error of the logarithm
  std::string held = {};          // "k = 1" where the fit is of those cases alone
};

// The value that is fitted for a number: the answer, the expected value, a mistake's value, or a
// ratio.
using NumberOf = std::function<double(const AnsweredCase&, const AnsweredNumber&)>;

// Fits the result at `place`, over the cases of one branch (empty: all). An input that does
// not enter as a power, such as the ellipticity in the film's constant, is held at the value that
// most cases have. Empty: there are too few cases, or the numbers are no product of powers, to
// `closeness` of the logarithm.
std::optional<PowerLaw> fit_power_law(const std::vector<AnsweredCase>& cases,
                                      const std::string& branch, std::size_t place,
                                      const NumberOf& number_of, double closeness);

// "F^+0.49 E*^-0.33", of the exponents that are not 0; the symbol is the first word of the
// parameter's meaning. Exponents are decimals, or fractions such as 1/3.
std::string powers_in_words(const catalogue::Function& function,
                            const std::vector<double>& exponents);
std::string power_in_words(const catalogue::Parameter& parameter, double exponent);
// "F" of "F, of both bodies"
std::string symbol_of(const catalogue::Parameter& parameter);

// "right for −21 ≤ d ≤ 5.1, wrong beyond" for the result at `place` of one branch (empty: all);
// empty if wrong and right answers are not apart in any input. A border stands between the last
// right case and the first wrong one; 2 in 100 cases may lie on the wrong side of it.
std::string where_wrong(const std::vector<AnsweredCase>& cases, const std::string& branch,
                        std::size_t place);

// How the errors run along an input: as those of an integral that ends too early, of digits that
// cancel (noise that grows), or of a quadrature (smooth, without a constant ratio). Empty: as none
// of these.
std::string manner_of_errors(const std::vector<AnsweredCase>& cases, const std::string& branch,
                             std::size_t place);

// Whether every answer has at most nine digits, or is a number of single precision.
bool is_single_precision(const std::vector<AnsweredCase>& cases);

}  // namespace tribo::conformance
