// SPDX-License-Identifier: Apache-2.0
// A faster reader than the model's JSON reader, for the ordinary lines of a stream.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "scene/entries.hpp"

namespace tribo::protocol {

// The result of parse_scene_json() for one speed, to the last bit and word, in a third of the time.
// Empty if the two may differ: the line is no JSON, a name is unknown, a number may be outside its
// type, a list or table is in a wrong place, or the line holds far more than a scene.
std::optional<SceneReading> read_ordinary_scene(std::string_view line, std::string_view source);

// The members of an object without lists and objects, as json_entries() gives them, in a third of
// the time; valid until this thread's next call. Empty if they may differ.
std::optional<std::span<const scene_detail::Entry>> ordinary_members(std::string_view line);

}  // namespace tribo::protocol
