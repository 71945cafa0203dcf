// SPDX-License-Identifier: Apache-2.0
// Where, over the inputs of a function, the wrong answers lie.
#pragma once

#include <string>
#include <vector>

#include "conformance/answered.hpp"

namespace tribo::conformance {

// "right for −21 ≤ d ≤ 5.1, wrong beyond" for the result at `place` of one branch (empty: all);
// empty if wrong and right answers are not apart in any input. A border stands between the last
// right case and the first wrong one; 2 in 100 cases may lie on the wrong side of it.
std::string where_wrong(const std::vector<AnsweredCase>& cases, const std::string& branch,
                        std::size_t place);

// The manner of the errors along an input: as of an integral that ends too early, of digits that
// cancel (noise that grows), or of a quadrature (smooth, without a constant ratio). Empty: no such
// manner.
std::string manner_of_errors(const std::vector<AnsweredCase>& cases, const std::string& branch,
                             std::size_t place);

// Whether every answer has at most nine digits, or is a number of single precision.
bool is_single_precision(const std::vector<AnsweredCase>& cases);

}  // namespace tribo::conformance
