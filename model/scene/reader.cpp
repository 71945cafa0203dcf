// SPDX-License-Identifier: Apache-2.0
// Scenes from files and standard input.
#include "scene/entries.hpp"
#include "scene/input_text.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo {
namespace {

using scene_detail::Problems;
using scene_detail::read_input_text;
using scene_detail::stem_of;

bool is_json(const std::string& path, const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");  // BOM
  return path.ends_with(".json") || (first != std::string::npos && text[first] == '{');
}

}  // namespace

SceneReading read_scene(const std::string& path, SceneUse use) {
  std::string text;
  if (const std::string refusal = read_input_text(path, "a scene", text); !refusal.empty()) {
    SceneReading reading;
    Problems(reading, path.empty() ? "\"\"" : path).error("", {.what = refusal});
    return reading;
  }
  SceneReading reading =
      is_json(path, text) ? parse_scene_json(text, path, use) : parse_scene_toml(text, path, use);
  if (reading.scene && !reading.id && path != "-") reading.scene->id = stem_of(path);
  return reading;
}

}  // namespace tribo
