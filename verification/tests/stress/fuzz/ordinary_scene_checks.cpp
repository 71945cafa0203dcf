// SPDX-License-Identifier: Apache-2.0
// The stream's short cut for ordinary lines, against the reader of any JSON.
#include "protocol/ordinary_scene.hpp"
#include "stress/fuzz/checks.hpp"
#include "stress/fuzz/same_reading.hpp"

namespace tribo::fuzz {

void check_ordinary_scene(std::string_view line) {
  const std::optional<SceneReading> ordinary = protocol::read_ordinary_scene(line, "fuzz");
  if (ordinary)
    require(same(*ordinary, parse_scene_json(line, "fuzz", SceneUse::one_speed)),
            "an ordinary line is read as any other", line);
}

}  // namespace tribo::fuzz
