// SPDX-License-Identifier: Apache-2.0
#include "scene_arguments.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>

#include "messages.hpp"
#include "page/project_files.hpp"

namespace tribo::cli {
namespace {

constexpr std::string_view published = "reference/published";

// Where a scene of this name is installed, if the path itself leads to nothing.
std::string installed_hint(const std::string& path) {
  std::error_code ignored;
  if (path == "-" || std::filesystem::exists(path, ignored)) return {};
  try {
    const report::ReportPlaces places = report::find_places({});
    for (const auto& folder : {places.reference / "scenes", places.scenes}) {
      const auto scene = folder / std::filesystem::path(path).filename();
      if (std::filesystem::is_regular_file(scene, ignored)) return "; there is " + scene.string();
    }
  } catch (const report::ReportError&) {
    // Nothing is installed.
  }
  return {};
}

void load_scene(const std::string& path, SceneUse use, const Prepare& prepare,
                LoadedScenes& loaded) {
  SceneReading reading = read_scene(path, use);
  for (const InputProblem& error : reading.errors) complain(error.line() + installed_hint(path));
  for (const InputProblem& warning : reading.warnings) complain("warning: " + warning.line());
  loaded.is_noted = loaded.is_noted || !reading.warnings.empty();
  if (!reading.scene) {
    loaded.all_good = false;
    return;
  }
  if (path == "-" && !reading.id) reading.scene->id = "stdin";
  if (const std::string fault = prepare ? prepare(*reading.scene) : ""; !fault.empty()) {
    complain(reading.scene->id + ": " + fault);
    loaded.all_good = false;
    return;
  }
  loaded.warnings.add(path, reading.scene->id, passed_limits(*reading.scene, use));
  loaded.scenes.push_back(std::move(*reading.scene));
}

// The path of a folder that examples name: that path if it exists, else the project's folder.
std::string found(std::string_view usual) {
  std::error_code ignored;
  if (std::filesystem::is_directory(usual, ignored)) return std::string(usual);
  try {
    const report::ReportPlaces places = report::find_places({});
    return usual == published ? places.scenes : places.reference / "scenes";
  } catch (const report::ReportError&) {
    return std::string(usual);  // there are no scenes
  }
}

void replace_all(std::string& text, std::string_view usual, const std::string& folder) {
  for (std::size_t at = text.find(usual); at != std::string::npos;
       at = text.find(usual, at + folder.size()))
    text.replace(at, usual.size(), folder);
}

}  // namespace

void add_scene_arguments(CLI::App& app, SceneArguments& arguments) {
  app.add_option("SCENE", arguments.paths, "scene files, TOML or JSON; - is stdin")
      ->required()
      ->check([](const std::string& path) {
        return path.empty() ? std::string("the name of a scene file is empty") : std::string();
      });
  app.add_option("--format", arguments.format, "how to write the results (default: table)")
      ->check(CLI::IsMember({"table", "csv", "json"}));
  add_strict_option(app, arguments.is_strict);
}

void add_strict_option(CLI::App& app, bool& is_strict) {
  app.add_flag(
      "--strict", is_strict,
      "exit code 1 where a scene goes beyond a limit of the model that it does not accept; the "
      "results are written all the same");
}

int LoadedScenes::exit_code(const SceneArguments& arguments) const {
  if (!all_good) return exit_bad;
  return arguments.is_strict && (warnings.any() || is_noted) ? exit_failed : exit_done;
}

LoadedScenes load_scenes(const std::vector<std::string>& paths, SceneUse use,
                         const Prepare& prepare, bool results_explain) {
  LoadedScenes loaded;
  if (std::count(paths.begin(), paths.end(), "-") > 1) {
    complain("- (stdin) is given more than once; it can be read once");
    loaded.all_good = false;
    return loaded;
  }
  for (const std::string& path : paths) load_scene(path, use, prepare, loaded);
  if (results_explain)
    loaded.warnings.tell("the results explain them");
  else
    loaded.warnings.tell(is_of_solved_films(use)  ? "section 14 of model/README.md explains them"
                         : use == SceneUse::onset ? "`tribocheck contact` explains them"
                                                  : "`tribocheck solve --explain` explains them");
  return loaded;
}

std::function<std::string()> footer_with_scenes(std::string text) {
  return [text = std::move(text)] {
    std::string footer = text;
    for (const std::string_view usual : {published, std::string_view("reference/scenes")})
      replace_all(footer, usual, found(usual));
    return footer;
  };
}

}  // namespace tribo::cli
