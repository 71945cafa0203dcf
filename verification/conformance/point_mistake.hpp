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
// Likewise; `change` gives the factor that takes the change out of the number of summits.
Mistake changed_with_count(std::string name, std::string text,
                           std::function<double(Scene&)> change);

// With another film behind the inlet, and another film where the load is shared (films alone).
Mistake with_inlet(const WrongInlet& wrong);
Mistake with_sharing(const WrongSharing& wrong);

// With another friction, from the point; `dry` is μ_b A.
using WrongFriction =
    std::function<std::optional<double>(const Scene&, const OperatingPoint<double>&, double dry)>;
Mistake with_friction(std::string name, std::string text, WrongFriction wrong);

std::vector<Mistake> friction_mistakes();

}  // namespace tribo::conformance
