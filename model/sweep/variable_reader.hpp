// SPDX-License-Identifier: Apache-2.0
// Reads how a field varies from the value that a sweep file has for it.
#pragma once

#include <optional>

#include "scene/entries.hpp"
#include "sweep/plan.hpp"

namespace tribo::sweep {

// Does the entry of a scene's field vary? Tables and lists do, but not `outputs`, nor a list that
// has one number for each face. For `speed` the caller has to check, too, that it is drawn.
bool varies(const scene_detail::Entry& entry);

// The variable, whose values may be out of the field's range; nullopt: an error was reported.
std::optional<Variable> read_variable(const scene_detail::Entry& entry, const FieldInfo& field,
                                      scene_detail::Problems& problems);

// The value of the field in a scene where the variable has the value `value`.
scene_detail::Value value_for(const Variable& variable, double value);

}  // namespace tribo::sweep
