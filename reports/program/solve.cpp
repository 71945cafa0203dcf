// SPDX-License-Identifier: Apache-2.0
// tribocheck solve: the outputs at the scene's speeds, by the root find.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "command.hpp"
#include "messages.hpp"
#include "point_writers.hpp"
#include "progress.hpp"
#include "protocol/answers.hpp"
#include "scene_arguments.hpp"
#include "sweep/parallel_points.hpp"

namespace tribo::cli {
namespace {

struct SolveArguments : SceneArguments {
  int threads = 0;
};

// A chunk of speeds is enough for several threads, and keeps memory flat for any number of them.
constexpr std::size_t chunk = std::size_t{1} << 16;

void solve_scene(const Scene& scene, int threads, PointWriter& writer, Progress& progress) {
  const MixedContact<double> contact(scene);
  const OutputSet outputs = protocol::needed_for(scene.outputs);
  writer.begin_scene(scene);
  std::vector<double> speeds;
  OperatingPoints points;
  for (std::size_t first = 0; first < scene.speeds.size(); first += chunk) {
    speeds.resize(std::min(chunk, scene.speeds.size() - first));
    scene.speeds.fill(first, speeds);
    points.resize(speeds.size(), outputs);
    solve_in_parallel(contact, speeds, outputs, points, threads);
    for (std::size_t i = 0; i < points.size(); ++i) {
      writer.add(points[i]);
      progress.step();
    }
  }
}

int solve(const SolveArguments& arguments, OutputStream& output) {
  const LoadedScenes loaded = load_scenes(arguments.paths, SceneUse::speeds);
  if (loaded.scenes.empty()) return exit_bad;
  std::size_t total = 0;
  for (const Scene& scene : loaded.scenes) total += scene.speeds.size();
  Progress progress(total);
  const auto writer = make_point_writer(arguments.format, output, loaded.scenes);
  for (const Scene& scene : loaded.scenes) solve_scene(scene, arguments.threads, *writer, progress);
  writer->finish();
  return loaded.all_good ? exit_done : exit_bad;
}

constexpr const char* footer_start =
    R"(Columns: the speed in m/s, and what the scene's `outputs` ask of these; film_flooded, film and
separation are in m, all other numbers dimensionless.
)";
constexpr const char* footer_end = R"(
CSV and JSON numbers read back to the same double. What is undefined is - in a table, empty in
CSV, and null in JSON, which says why under "undefined". A bad scene is reported, the others are
still solved, and the exit code is 2.

Example:
  tribocheck solve reference/published/rough.toml --format csv > rough.csv
  tribocheck solve reference/published/rough.toml reference/published/smooth.toml)";

std::string footer() {
  std::string text = footer_start;
  for (const OutputInfo& output : output_infos)
    text += fmt::format("  {:<21}{}\n", output.name, output.meaning);
  return text + footer_end;
}

}  // namespace

Command add_solve(CLI::App& program) {
  CLI::App* app = program.add_subcommand("solve", "the outputs of scenes at their speeds");
  app->footer(footer_with_scenes(footer()));
  const auto arguments = std::make_shared<SolveArguments>();
  add_scene_arguments(*app, *arguments);
  app->add_option("--threads", arguments->threads,
                  "threads for scenes of many speeds (default: all the machine has); the results "
                  "are the same bits for any number")
      ->check(CLI::Range(1, 1024));
  return {app, [arguments](OutputStream& output) { return solve(*arguments, output); }};
}

}  // namespace tribo::cli
