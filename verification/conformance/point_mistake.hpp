// SPDX-License-Identifier: Apache-2.0
// Ways to get the operating point that a mistake gives, from the model.
#pragma once

#include <functional>
#include <string>

#include "conformance/mistake.hpp"
#include "conformance/wrong_parts.hpp"
#include "tribo/mixed_contact.hpp"

namespace tribo::conformance {

// The point of a scene that was changed.
Mistake changed(std::string name, std::string text, std::function<void(Scene&)> change);
// Likewise; `change` returns a factor for the number of summits that undoes the change there.
Mistake changed_with_count(std::string name, std::string text,
                           std::function<double(Scene&)> change);

// Mistakes with a wrong film ratio of the inlet, and with a wrong film of load sharing (only for
// the outputs film and film_flooded).
Mistake with_inlet(const WrongInlet& wrong);
Mistake with_sharing(const WrongSharing& wrong);

// With another friction, from the point; `dry` is μ_b A.
using WrongFriction =
    std::function<std::optional<double>(const Scene&, const OperatingPoint<double>&, double dry)>;
Mistake with_friction(std::string name, std::string text, WrongFriction wrong);

std::vector<Mistake> friction_mistakes();

}  // namespace tribo::conformance
