// SPDX-License-Identifier: Apache-2.0
// Words of operating points that are answered from another limit on.
#pragma once

#include <vector>

#include "conformance/diagnosis.hpp"

namespace tribo::conformance {

// "`boundary` is answered from asperity_load_share = 0.9 on, in place of 0.99": of each word that a
// wrong answer has, or that it should have, where one number of the right point decides on it.
std::vector<Diagnosis> diagnose_words(const std::string& function,
                                      const std::vector<TestCase>& cases,
                                      const Conversation& conversation);

}  // namespace tribo::conformance
