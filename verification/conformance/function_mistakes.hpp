// SPDX-License-Identifier: Apache-2.0
// Mistakes in single functions, from the entries of reference/mistakes.toml.
#pragma once

#include "conformance/mistake.hpp"
#include "conformance/mistake_file.hpp"

namespace tribo::conformance {

// The functions of an entry: the one that it names; of film_laws all film laws that have the
// arguments and exponents that the entry changes. Throws std::runtime_error where there is none.
std::vector<const catalogue::Function*> functions_of(const MistakeEntry& entry);

// The mistakes of an entry: one; with `swapped` one for each pair of words, with the law `another`
// one for each other film law. Throws std::runtime_error that says what is wrong with the entry.
std::vector<Mistake> mistakes_of(const catalogue::Function& function, const MistakeEntry& entry);

// "inlet-{given}-for-{asked}" with the two words.
std::string with_words(std::string text, std::string_view given, std::string_view asked);

}  // namespace tribo::conformance
