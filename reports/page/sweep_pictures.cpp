// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "page/sweep_tables.hpp"
#include "sweep/output_file.hpp"

namespace tribo::report {
namespace {

using nlohmann::ordered_json;

// A grid of one field alone whose film can be drawn as a map over speed and that field.
bool is_map(const sweep::SceneResult& scene) {
  const sweep::ColumnResult* const film = scene.column("film");
  return scene.design == "factorial" && scene.has_points && scene.inputs.size() == 1 &&
         scene.inputs.front().words.empty() && film != nullptr && film->values.size() >= 3 &&
         film->values.size() == scene.speeds.size();
}

// The field of each case, and its film at each speed.
ordered_json map_json(const sweep::SceneResult& scene, const sweep::ResultFile& result) {
  const auto field = result.input(scene.id, scene.inputs.front().path);
  const auto films = result.column(scene.id, "film");
  const std::size_t speeds = scene.speeds.size();
  if (films.size() != field.size() * speeds)
    throw std::runtime_error(result.path() + " has a torn film");
  ordered_json rows = ordered_json::array();
  for (auto first = films.begin(); first != films.end();
       first += static_cast<std::ptrdiff_t>(speeds))
    rows.push_back(std::vector(first, first + static_cast<std::ptrdiff_t>(speeds)));
  return {{"field", field}, {"film", std::move(rows)}};
}

}  // namespace

Rendering draw_sweep_pictures(const sweep::SweepResult& result, const sweep::ResultFile& source,
                              const std::string& folder) {
  try {
    make_folder(folder);
    ordered_json json = sweep_json(result);
    for (std::size_t i = 0; i < result.scenes.size(); ++i)
      if (is_map(result.scenes[i])) json["scenes"][i]["map"] = map_json(result.scenes[i], source);
    const sweep::PartFile file(std::filesystem::path(folder) / "result.json");  // goes again
    file.write(json.dump(-1, ' ', false, ordered_json::error_handler_t::replace));
    return run_script(usual_places(), "sweep_pictures.py", {file.path(), folder});
  } catch (const std::runtime_error& error) {
    return {{}, {error.what()}};
  }
}

}  // namespace tribo::report
