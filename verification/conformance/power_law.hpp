// SPDX-License-Identifier: Apache-2.0
// Numbers as products of powers of a function's inputs: exponents and constant by least squares on
// logarithms.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "conformance/answered.hpp"

namespace tribo::conformance {

struct PowerLaw {
  std::vector<double> exponents;  // of each parameter; 0 for those that were held fixed
  double constant = 0;            // with its sign
  double residual = 0;            // the greatest, of the logarithm
  std::string held = {};          // "k = 1" where the fit is of those cases alone
};

// The value that is fitted for a number: the answer, the expected value, a mistake's value, or a
// ratio.
using NumberOf = std::function<double(const AnsweredCase&, const AnsweredNumber&)>;

// Fits the result at `place`, over the cases of one branch (empty: all). An input that is in the
// numbers not as a power, such as the ellipticity in the film's constant, is held at the value that
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

}  // namespace tribo::conformance
