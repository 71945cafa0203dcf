// SPDX-License-Identifier: Apache-2.0
// Finds words of operating points, such as `boundary`, for which a subject has a wrong limit.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "conformance/diagnosis.hpp"

namespace tribo::conformance {

// Looks at each word of the wrong answers, and at the words that would be right there. A diagnosis
// is made if one number of the right point tells where the subject answers the word: "The word
// `boundary` is answered from asperity_load_share = 0.9 on; it is right from … = 0.99 on." Points
// with a wrong number are left out, because words follow from numbers.
std::vector<Diagnosis> diagnose_words(const std::string& function,
                                      const std::vector<TestCase>& cases,
                                      const Conversation& conversation,
                                      const std::set<const TestCase*>& with_wrong_numbers);

}  // namespace tribo::conformance
