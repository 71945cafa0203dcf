// SPDX-License-Identifier: Apache-2.0
// Mistakes in single functions, from the entries of reference/mistakes.toml.
#pragma once

#include "conformance/mistake.hpp"
#include "conformance/mistake_file.hpp"

namespace tribo::conformance {

// The mistakes of an entry: one, or with `swapped` one for each pair of words. Throws
// std::runtime_error that says what is wrong with the entry.
std::vector<Mistake> mistakes_of(const catalogue::Function& function, const MistakeEntry& entry);

// "inlet-{given}-for-{asked}" with the two words.
std::string with_words(std::string text, std::string_view given, std::string_view asked);

}  // namespace tribo::conformance
