// SPDX-License-Identifier: Apache-2.0
// The arguments `SCENE… --format F --strict` that the commands share, the reading of these scenes,
// and the folders of the scenes that examples in the help name.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "tribo/scene_reader.hpp"
#include "validity_writers.hpp"

namespace tribo::cli {

struct SceneArguments {
  std::vector<std::string> paths;
  std::string format = "table";  // or csv, json
  bool is_strict = false;
};

void add_scene_arguments(CLI::App& app, SceneArguments& arguments);

struct LoadedScenes {
  std::vector<Scene> scenes;  // the good ones, in their order
  bool all_good = true;
  Warnings warnings;      // of the good ones
  bool is_noted = false;  // a warning said that a part of a scene has no effect

  // The exit code of a command that has written its results: exit_bad where a scene is not good;
  // exit_failed where --strict is given and there was a warning, or a scene has a part without
  // effect; else exit_done.
  int exit_code(const SceneArguments& arguments) const;
};

// Puts a command's options into a scene. Returns why the scene cannot be taken; empty if it can.
using Prepare = std::function<std::string(Scene&)>;

// Reads every scene, and reports every error on stderr, and in one line the limits that the scenes
// pass. That line ends with the place where the limits are explained: the results of the command if
// `results_explain`, else a command or a section.
LoadedScenes load_scenes(const std::vector<std::string>& paths, SceneUse use,
                         const Prepare& prepare = {}, bool results_explain = false);
// Adds --strict.
void add_strict_option(CLI::App& app, bool& is_strict);

// The footer of a help text. Where the current folder has no reference/published, or no
// reference/scenes, the full path of the project's or the installed folder replaces it.
std::function<std::string()> footer_with_scenes(std::string text);

}  // namespace tribo::cli
