// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <filesystem>
#include <numeric>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "page/sweep_tables.hpp"
#include "sweep/output_file.hpp"

namespace tribo::report {
namespace {

using nlohmann::ordered_json;

// Columns that are drawn over the fields of a grid.
constexpr auto drawn_films =
    std::to_array<std::string_view>({"film", "solved_film.central", "solved_film.minimum"});

// Whether the scene is a grid over one or two number fields, with all its cases kept.
bool is_grid(const sweep::SceneResult& scene) {
  const auto is_number = [](const sweep::InputResult& input) { return input.words.empty(); };
  return scene.design == "factorial" && scene.has_points && !scene.speeds.empty() &&
         (scene.inputs.size() == 1 || scene.inputs.size() == 2) &&
         std::ranges::all_of(scene.inputs, is_number);
}

// The places of the speeds that are drawn. One field is drawn at all speeds. Two fields need a map
// for each speed, so that at most three are drawn: the first, the middle and the last one.
std::vector<std::size_t> drawn_speeds(const sweep::SceneResult& scene) {
  const std::size_t count = scene.speeds.size();
  if (scene.inputs.size() == 2 && count > 3) return {0, count / 2, count - 1};
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

// The fields of each case, and its films at the speeds that are drawn. Null without a film.
ordered_json grid_json(const sweep::SceneResult& scene, const sweep::ResultFile& result) {
  const std::vector<std::size_t> places = drawn_speeds(scene);
  ordered_json fields = ordered_json::array(), speeds = ordered_json::array();
  ordered_json films = ordered_json::object();
  for (const sweep::InputResult& input : scene.inputs)
    fields.push_back(result.input(scene.id, input.path));
  for (const std::size_t place : places) speeds.push_back(scene.speeds[place]);
  for (const std::string_view name : drawn_films) {
    const sweep::ColumnResult* const column = scene.column(name);
    if (column == nullptr || column->values.size() != scene.speeds.size()) continue;
    const auto values = result.column(scene.id, std::string(name));
    if (values.size() != scene.cases * scene.speeds.size())
      throw std::runtime_error(result.path() + " does not have a value of " + std::string(name) +
                               " for each case and speed");
    ordered_json rows = ordered_json::array();
    for (std::size_t first = 0; first < values.size(); first += scene.speeds.size()) {
      ordered_json row = ordered_json::array();
      for (const std::size_t place : places) row.push_back(values[first + place]);
      rows.push_back(std::move(row));
    }
    films[std::string(name)] = std::move(rows);
  }
  if (films.empty()) return nullptr;
  return {
      {"fields", std::move(fields)}, {"speeds", std::move(speeds)}, {"films", std::move(films)}};
}

}  // namespace

Rendering draw_sweep_pictures(const sweep::SweepResult& result,
                              const std::vector<SweepCells>& cells, const sweep::ResultFile& source,
                              const std::string& folder) {
  try {
    make_folder(folder);
    ordered_json json = sweep_json(result, cells);
    for (std::size_t i = 0; i < result.scenes.size(); ++i) {
      json["scenes"][i]["sets"] = cells[i].count;
      if (is_grid(result.scenes[i]))
        json["scenes"][i]["grid"] = grid_json(result.scenes[i], source);
    }
    const sweep::PartFile file(std::filesystem::path(folder) / "result.json");  // is removed again
    file.write(json.dump(-1, ' ', false, ordered_json::error_handler_t::replace));
    return run_script(usual_places(), "sweep_pictures.py", {file.path(), folder});
  } catch (const std::runtime_error& error) {
    return {{}, {error.what()}};
  }
}

}  // namespace tribo::report
