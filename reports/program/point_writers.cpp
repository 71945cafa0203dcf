// SPDX-License-Identifier: Apache-2.0
#include "point_writers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "sweep/parallel_points.hpp"

namespace tribo::cli {
namespace {

// The columns that any of the scenes asks for.
std::vector<Column> columns_of(std::span<const Scene> scenes) {
  std::vector<Column> columns{{"speed", "m/s"}};
  for (const OutputInfo& info : output_infos)
    if (std::any_of(scenes.begin(), scenes.end(),
                    [&info](const Scene& scene) { return scene.outputs.contains(info.output); }))
      columns.push_back({info.name, info.unit,
                         info.words.empty() ? number_width : width_of_words(info.words),
                         !info.words.empty()});
  return columns;
}

// Why a scene that does not name its outputs has no friction. The text is empty if the scene has
// friction, or names its outputs.
std::string_view why_without_friction(const Scene& scene) {
  OutputSet outputs = scene.outputs;
  if (outputs.contains(Output::friction)) return {};
  outputs.insert(Output::friction);
  outputs.insert(Output::film_parameter);  // smooth bodies have none
  if (outputs != OutputSet::all()) return {};
  if (scene.lubricant.eyring_stress)
    return "not computed, as friction.boundary_coefficient is not given";
  return scene.friction.boundary_coefficient
             ? "not computed, as lubricant.eyring_stress is not given"
             : "not computed, as lubricant.eyring_stress and friction.boundary_coefficient are not "
               "given";
}

}  // namespace

PointWriter::PointWriter(std::string_view format, OutputStream& output,
                         const std::vector<Scene>& scenes)
    : rows_(format, output, columns_of(scenes), {"solve/1", "points"}) {}

void PointWriter::begin_scene(const Scene& scene, const MixedContact<double>& contact) {
  scene_ = &scene;
  smooth_.reset();
  if (protocol::needs_smooth_contact(scene)) smooth_.emplace(contact);
  const std::size_t count = scene.speeds.size();
  const std::vector<Column> columns = columns_of({&scene, 1});
  cells_.assign(columns.size(), {});
  rows_.begin(scene.id, fmt::format("{}: {} speed{}", scene.id, count, count == 1 ? "" : "s"),
              columns);
  if (const std::string_view why = why_without_friction(scene); !why.empty())
    rows_.note("friction", why);
}

void PointWriter::add(const OperatingPoint<double>& point) {
  cells_[0].undefined = std::isfinite(point.speed) ? std::string_view() : protocol::beyond_double;
  cells_[0].number = point.speed;
  std::size_t column = 0;  // the cells are made in place, because copying each takes long
  for (const OutputInfo& info : output_infos)
    if (scene_->outputs.contains(info.output))
      new (&cells_[++column]) protocol::OutputValue(
          protocol::value_of(point, smooth_ ? &*smooth_ : nullptr, info.output));
  rows_.add(cells_);
}

void write_points(const Scene& scene, int threads, PointWriter& writer, Progress& progress) {
  const MixedContact<double> contact(scene);
  const OutputSet outputs = protocol::needed_for(scene);
  writer.begin_scene(scene, contact);
  OperatingPoints points;
  in_chunks(scene, [&](const std::vector<double>& speeds) {
    points.resize(speeds.size(), outputs);
    solve_in_parallel(contact, speeds, outputs, points, threads);
    for (std::size_t i = 0; i < points.size(); ++i) {
      writer.add(points[i]);
      progress.step();
    }
  });
}

}  // namespace tribo::cli
