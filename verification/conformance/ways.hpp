// SPDX-License-Identifier: Apache-2.0
// Other numbers that a solver may be given: E′ = 2E*, or the moduli and Poisson ratios of both
// bodies, in place of E*; both radii in place of the ellipticity in a film law.
#pragma once

#include <string>
#include <vector>

#include "conformance/conformance_case.hpp"
#include "conformance/conversation.hpp"

namespace tribo::conformance {

struct AskedWays {
  std::string modulus = "E*";     // or "E'", or "bodies"
  std::string ellipticity = "k";  // or "radii"

  bool has_twice_the_modulus() const { return modulus == "E'"; }
  bool has_radii() const { return ellipticity == "radii"; }
  // Whether the numbers are other arguments, not only other values of the same arguments. A plug-in
  // cannot be asked with other arguments.
  bool has_other_arguments() const { return modulus == "bodies" || has_radii(); }
};

// The cases as they are sent to the solver. The replaced numbers follow from the new ones to the
// last bit; only the ellipticity follows from the radii with some rounding.
std::vector<TestCase> asked_by(const AskedWays& ways, std::vector<TestCase> cases);

// Halves the moduli of a solver that gives E′, so that they can be judged as E*.
void put_back(const AskedWays& ways, const std::vector<TestCase>& cases,
              Conversation& conversation);

}  // namespace tribo::conformance
