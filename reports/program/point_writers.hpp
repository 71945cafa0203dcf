// SPDX-License-Identifier: Apache-2.0
// Operating points of scenes as rows: the speed, and the outputs that each scene asks for.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "progress.hpp"
#include "table.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/scene.hpp"
#include "tribo/smooth_contact.hpp"

namespace tribo::cli {

class PointWriter {
 public:
  // format: "table", "csv" or "json". `scenes` are all that will be written.
  PointWriter(std::string_view format, OutputStream& output, const std::vector<Scene>& scenes);

  // Called once before the points of each scene; `scene` must live until the next call.
  void begin_scene(const Scene& scene, const MixedContact<double>& contact);
  void add(const OperatingPoint<double>& point);
  // `members` stand in the JSON document after its points.
  void finish(const nlohmann::ordered_json& members) { rows_.finish(members); }

 private:
  RowWriter rows_;
  const Scene* scene_ = nullptr;
  std::optional<SmoothContact> smooth_;  // where the scene needs it
  std::vector<protocol::OutputValue> cells_;
};

// Calls solve(speeds) with one chunk of a scene's speeds after the other. A chunk is enough for
// several threads, and memory does not grow with the number of speeds.
template <class Solve>
void in_chunks(const Scene& scene, const Solve& solve) {
  constexpr std::size_t chunk = std::size_t{1} << 16;
  std::vector<double> speeds;
  for (std::size_t first = 0; first < scene.speeds.size(); first += chunk) {
    speeds.resize(std::min(chunk, scene.speeds.size() - first));
    scene.speeds.fill(first, speeds);
    solve(speeds);
  }
}

// Writes the points of a scene at its speeds, on `threads` threads as solve_in_parallel() has it.
void write_points(const Scene& scene, int threads, PointWriter& writer, Progress& progress);

}  // namespace tribo::cli
