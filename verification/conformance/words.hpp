// SPDX-License-Identifier: Apache-2.0
// Words of operating points, such as `boundary`, that a subject answers from a wrong limit on.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "conformance/diagnosis.hpp"

namespace tribo::conformance {

// "The word `boundary` is answered from asperity_load_share = 0.9 on; it is right from … = 0.99
// on.", for each word that a wrong answer has or should have, if one number of the right point
// decides on the word. Points with a wrong number are left out, because words follow from numbers.
std::vector<Diagnosis> diagnose_words(const std::string& function,
                                      const std::vector<TestCase>& cases,
                                      const Conversation& conversation,
                                      const std::set<const TestCase*>& with_wrong_numbers);

}  // namespace tribo::conformance
