// SPDX-License-Identifier: Apache-2.0
// Rules on several fields of a contact: on the faces, the film law, the profile and the ellipse.
#pragma once

#include <optional>

#include "scene/entries.hpp"
#include "tribo/contact_numbers.hpp"

namespace tribo::scene_detail {

// The numbers of the contact; std::nullopt if there are errors, which are in `problems`.
std::optional<detail::SceneNumbers<double>> check_contact(const Scene& scene, SceneUse use,
                                                          bool film_is_given, Problems& problems);

}  // namespace tribo::scene_detail
