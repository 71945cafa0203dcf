// SPDX-License-Identifier: Apache-2.0
// Laws with more than one right reading. Their sources print a constant in two ways, a further
// term, a table beside a formula, or a fit for the ellipticity. A solver may follow any reading,
// but the same one in all its answers.
#pragma once

#include <string>
#include <vector>

#include "conformance/conformance.hpp"
#include "conformance/ways.hpp"

namespace tribo::conformance {

// If the answers to a function meet another reading of its law in more cases than the certified
// one, replaces the expected values by those of this reading. Returns a note for each function.
std::vector<std::string> take_readings(std::vector<TestCase>& cases,
                                       const Conversation& conversation, const Tolerance& tolerance,
                                       const AskedWays& ways);

}  // namespace tribo::conformance
