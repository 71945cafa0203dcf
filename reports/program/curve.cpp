// SPDX-License-Identifier: Apache-2.0
// tribocheck curve: the Stribeck curve over the range of a scene's speeds, even in their logarithm.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "messages.hpp"
#include "point_writers.hpp"
#include "progress.hpp"
#include "protocol/answers.hpp"
#include "scene_arguments.hpp"
#include "tribo/stribeck_walk.hpp"

namespace tribo::cli {
namespace {

struct Span {
  double from, to;
};

Span span_of(const Speeds& speeds) {
  if (speeds.list.empty()) return {speeds.from, speeds.to};
  const auto [least, greatest] = std::minmax_element(speeds.list.begin(), speeds.list.end());
  return {*least, *greatest};
}

// Says why a scene has no curve; empty if it has one.
std::string fault_of(const Scene& scene) {
  const Span span = span_of(scene.speeds);
  if (span.from < span.to) return {};
  return fmt::format(
      "speed: {} alone is no curve; allowed: a range, or a list of at least two different speeds",
      span.from);
}

void draw_scene(const Scene& scene, PointWriter& writer, Progress& progress) {
  const MixedContact<double> contact(scene);
  const Span span = span_of(scene.speeds);
  writer.begin_scene(scene);
  stribeck_curve(contact, span.from, span.to, scene.speeds.size(),
                 protocol::needed_for(scene.outputs), [&](const OperatingPoint<double>& point) {
                   writer.add(point);
                   progress.step();
                 });
}

int curve(const SceneArguments& arguments, OutputStream& output) {
  const LoadedScenes loaded = load_scenes(arguments.paths, SceneUse::speeds, fault_of);
  if (loaded.scenes.empty()) return exit_bad;
  std::size_t total = 0;
  for (const Scene& scene : loaded.scenes) total += scene.speeds.size();
  Progress progress(total);
  PointWriter writer(arguments.format, output, loaded.scenes);
  for (const Scene& scene : loaded.scenes) draw_scene(scene, writer, progress);
  writer.finish({{"warnings", loaded.warnings.json()}});
  return loaded.exit_code(arguments);
}

constexpr const char* curve_footer =
    R"(The curve spans the scene's range of speeds with as many points as it has, spaced evenly in the
logarithm of speed, also where the scene gives a list or a range spaced otherwise. Columns and
formats are those of `tribocheck solve`.

Example:
  tribocheck curve reference/published/rough.toml --format csv > curve.csv)";

}  // namespace

Command add_curve(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("curve", "the Stribeck curve over a scene's range of speeds");
  app->footer(footer_with_scenes(curve_footer));
  const auto arguments = std::make_shared<SceneArguments>();
  add_scene_arguments(*app, *arguments);
  return {app, [arguments](OutputStream& output) { return curve(*arguments, output); }};
}

}  // namespace tribo::cli
