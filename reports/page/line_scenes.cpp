// SPDX-License-Identifier: Apache-2.0
#include "page/line_scenes.hpp"

#include <algorithm>
#include <utility>

#include "tribo/onset.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::report {

std::vector<LineScene> line_scenes(const ReportPlaces& places,
                                   const std::filesystem::path& folder) {
  std::vector<LineScene> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::filesystem::path& path = entry.path();
    if (path.extension() != ".toml" || !entry.is_regular_file()) continue;
    SceneReading reading = read_scene(path.string(), SceneUse::speeds);
    if (!reading.scene || reading.scene->bodies.shape() != ContactShape::line) continue;
    const auto span = detail::speed_span(reading.scene->speeds);
    if (!(span.low > 0)) continue;
    found.push_back({path.stem().string(),
                     places.shown(path),
                     std::move(*reading.scene),
                     {span.low, span.high}});
  }
  std::sort(found.begin(), found.end(),
            [](const LineScene& a, const LineScene& b) { return a.name < b.name; });
  return found;
}

}  // namespace tribo::report
