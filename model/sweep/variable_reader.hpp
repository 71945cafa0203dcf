// SPDX-License-Identifier: Apache-2.0
// How a field varies, from the value that stands in its place in a sweep file.
#pragma once

#include <optional>

#include "scene/entries.hpp"
#include "sweep/plan.hpp"

namespace tribo::sweep {

// Does an entry of a scene's field vary? A table or list does, but not for `outputs`. For `speed`
// the caller has to check, too, that it is a distribution or a printed number.
bool varies(const scene_detail::Entry& entry);

// The variable, without `nominal`'s range checked; nothing where an error was reported.
std::optional<Variable> read_variable(const scene_detail::Entry& entry, const FieldInfo& field,
                                      scene_detail::Problems& problems);

// The value of the field in a scene with one value of the variable.
scene_detail::Value value_for(const Variable& variable, double value);

}  // namespace tribo::sweep
