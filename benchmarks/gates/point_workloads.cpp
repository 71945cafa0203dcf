// SPDX-License-Identifier: Apache-2.0
// Operating points of the paper's scenes: all outputs, and those that need little, and
// 200 points of a curve.
#include <array>
#include <cmath>

#include "gates/workloads.hpp"
#include "tests/support/scenes.hpp"
#include "tribo/operating_points.hpp"
#include "tribo/stribeck_walk.hpp"

namespace tribo::gates {
namespace {

constexpr std::size_t speeds_a_scene = 200;

std::vector<double> speeds() {
  std::vector<double> all(speeds_a_scene);
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = 1e-4 * std::pow(3e4, static_cast<double>(i) / static_cast<double>(all.size() - 1));
  return all;
}

// The contacts are made outside the timed pass: this work belongs to a scene, not to a point.
std::vector<MixedContact<double>> contacts() {
  std::vector<MixedContact<double>> all;
  for (const auto model : {AsperityModel::greenwood_tripp, AsperityModel::greenwood_williamson})
    for (const auto surface : verification::paper_surfaces)
      all.emplace_back(verification::paper_scene(surface, model));
  return all;
}

OutputSet film_and_regime() {
  OutputSet outputs;
  outputs.insert(Output::film);
  outputs.insert(Output::regime);
  return outputs;
}

Workload points(std::string name, OutputSet outputs) {
  OperatingPoints room;
  room.resize(speeds_a_scene, outputs);
  return {std::move(name), true,
          [all = contacts(), u = speeds(), outputs, room]() mutable {
            for (const auto& contact : all) solve(contact, u, outputs, room);
          },
          [all = contacts(), u = speeds(), outputs, room]() mutable {
            WorkCounts counts;
            for (const auto& contact : all) solve(contact, u, outputs, room, counts);
            Counters counters;
            for (const WorkInfo& info : work_infos)
              counters.emplace_back(info.name, counts[info.work]);
            return counters;
          }};
}

Workload curve() {
  const MixedContact<double> contact(verification::paper_scene(verification::PaperSurface::rough));
  return {"curve",
          false,
          [contact, friction = std::vector<double>(speeds_a_scene)]() mutable {
            std::size_t i = 0;
            stribeck_curve(contact, 1e-4, 3.0, speeds_a_scene, OutputSet::all(),
                           [&](const auto& point) { friction[i++] = point.friction; });
          },
          {}};
}

}  // namespace

Workloads point_workloads() {
  return {points("points_all_outputs", OutputSet::all()),
          points("points_film_and_regime", film_and_regime()), curve()};
}

}  // namespace tribo::gates
