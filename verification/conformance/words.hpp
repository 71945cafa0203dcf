// SPDX-License-Identifier: Apache-2.0
// Words of operating points that are answered from another limit on.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "conformance/diagnosis.hpp"

namespace tribo::conformance {

// "`boundary` is answered from asperity_load_share = 0.9 on, in place of 0.99": of each word that a
// wrong answer has, or that it should have, where one number of the right point decides on it.
// Words follow from numbers: points with a wrong number are left out.
std::vector<Diagnosis> diagnose_words(const std::string& function,
                                      const std::vector<TestCase>& cases,
                                      const Conversation& conversation,
                                      const std::set<const TestCase*>& with_wrong_numbers);

}  // namespace tribo::conformance
