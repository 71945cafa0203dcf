// SPDX-License-Identifier: Apache-2.0
// A solver that takes and gives E′ = 2E* wherever the questions have E*, as film formulas are often
// printed: `modulus = "E'"`.
#pragma once

#include <vector>

#include "conformance/conformance_case.hpp"
#include "conformance/conversation.hpp"

namespace tribo::conformance {

// The cases as such a solver is asked them: each effective modulus is twice as large, to the bit.
std::vector<TestCase> asked_in_twice_the_modulus(std::vector<TestCase> cases);

// Halves the moduli that it answered, so that they can be judged as E*.
void halve_moduli(const std::vector<TestCase>& cases, Conversation& conversation);

}  // namespace tribo::conformance
