// SPDX-License-Identifier: Apache-2.0
// The numbers in which a solver is asked, where these are not the questions' own: E′ = 2E*, or both
// bodies, for E*; both radii for the ellipticity of a film.
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
  // Does it take other arguments, and not only other values of them? A plug-in cannot.
  bool has_other_arguments() const { return modulus == "bodies" || has_radii(); }
};

// The cases as such a solver is asked them. Each number is right to the bit but for the radii,
// which give the ellipticity to some roundings.
std::vector<TestCase> asked_by(const AskedWays& ways, std::vector<TestCase> cases);

// Halves the moduli of a solver that gives E′, so that they can be judged as E*.
void put_back(const AskedWays& ways, const std::vector<TestCase>& cases,
              Conversation& conversation);

}  // namespace tribo::conformance
