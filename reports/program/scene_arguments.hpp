// SPDX-License-Identifier: Apache-2.0
// The arguments `SCENE… --format F` that solve, curve and onset share, reading those scenes, and
// the scenes that the examples of the help name.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "tribo/scene_reader.hpp"

namespace tribo::cli {

struct SceneArguments {
  std::vector<std::string> paths;
  std::string format = "table";  // or csv, json
};

void add_scene_arguments(CLI::App& app, SceneArguments& arguments);

struct LoadedScenes {
  std::vector<Scene> scenes;  // the good ones, in their order
  bool all_good = true;
};

// Reads every scene and reports every error and warning on stderr.
LoadedScenes load_scenes(const std::vector<std::string>& paths, SceneUse use);

// The footer of a help text. Where the current folder has no reference/published, or no
// reference/scenes, the full path of the project's or the installed folder replaces it.
std::function<std::string()> footer_with_scenes(std::string text);

}  // namespace tribo::cli
