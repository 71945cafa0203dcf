// SPDX-License-Identifier: Apache-2.0
// Scenes from files and standard input.
#include "scene/entries.hpp"
#include "scene/input_text.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo {

SceneReading parse_scene(std::string_view text, std::string_view source, SceneUse use,
                         std::span<const std::string_view> outputs) {
  const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");  // BOM
  const bool is_json = first != std::string_view::npos && text[first] == '{';
  return (is_json ? parse_scene_json : parse_scene_toml)(text, source, use, outputs);
}

SceneReading read_scene(const std::string& path, SceneUse use) {
  std::string text;
  if (const std::string refusal = scene_detail::read_input_text(path, "a scene", text);
      !refusal.empty()) {
    SceneReading reading;
    scene_detail::Problems(reading, path.empty() ? "\"\"" : path).error("", {.what = refusal});
    return reading;
  }
  SceneReading reading =
      path.ends_with(".json") ? parse_scene_json(text, path, use) : parse_scene(text, path, use);
  if (reading.scene && !reading.id && path != "-") reading.scene->id = scene_detail::stem_of(path);
  return reading;
}

}  // namespace tribo
