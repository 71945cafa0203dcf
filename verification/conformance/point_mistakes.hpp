// SPDX-License-Identifier: Apache-2.0
// Mistakes in operating points: the model's own answer to a scene that was misread, or with one
// part of it gone wrong.
#pragma once

#include "conformance/mistake.hpp"
#include "conformance/mistake_file.hpp"

namespace tribo::conformance {

// The mistakes of an entry for operating_point: one, or with `swapped` one for each pair of words.
// Throws std::runtime_error that says what is wrong with the entry.
std::vector<Mistake> point_mistakes_of(const MistakeEntry& entry);

// The same mistake in the inlet or the load sharing of an operating point; empty for other
// functions.
std::optional<Mistake> for_points(const Mistake& mistake);

// A mistake that several film laws have, in the film of an operating point by any of them.
Mistake with_film(const std::vector<Mistake>& laws);

}  // namespace tribo::conformance
