// SPDX-License-Identifier: Apache-2.0
// Laws whose sources print a constant in two ways, or with a further term, or as a table, or a fit
// for an ellipticity: a solver may follow either, in all its answers.
#pragma once

#include <string>
#include <vector>

#include "conformance/conformance.hpp"
#include "conformance/ways.hpp"

namespace tribo::conformance {

// Where the answers to a function meet another reading of its law in more cases than the certified
// one, puts that reading in the place of what is expected. Returns a note on each.
std::vector<std::string> take_readings(std::vector<TestCase>& cases,
                                       const Conversation& conversation, const Tolerance& tolerance,
                                       const AskedWays& ways);

}  // namespace tribo::conformance
