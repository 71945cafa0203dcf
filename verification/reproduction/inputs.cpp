// SPDX-License-Identifier: Apache-2.0
#include "reproduction/inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "accuracy/reference_table.hpp"
#include "tribo/film_thickness.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::reproduction {
namespace {

constexpr PerContact<std::string_view> stems{"rough", "medium", "smooth", "smooth_gw"};

Scene read_one(const std::string& path, AsperityModel model) {
  SceneReading reading = read_scene(path, SceneUse::speeds);
  if (!reading.scene) throw std::runtime_error(reading.errors.front().line());
  const Scene& scene = *reading.scene;
  const auto need = [&](bool held, std::string_view what) {
    if (!held) throw std::runtime_error(fmt::format("{}: the ledger needs {} here", path, what));
  };
  need(scene.closures.asperity == model, model == AsperityModel::greenwood_tripp
                                             ? "closures.asperity = greenwood_tripp"
                                             : "closures.asperity = greenwood_williamson");
  // Readings compute the paper's contact by formulas of their own, and change these inputs.
  need(scene.bodies.shape() == ContactShape::circle && !scene.bodies.has_bodies() &&
           scene.closures.film == FilmFormula::hamrock_dowson_central,
       "bodies.reduced_radius, bodies.effective_modulus and closures.film = "
       "hamrock_dowson_central");
  need(!scene.surface.has_moments(), "surface.summit_density, summit_radius and summit_height_sd");
  need(has_friction_inputs(scene), "lubricant.eyring_stress and friction.boundary_coefficient");
  need(scene.supply.kind == SupplyKind::inlet_film_ratio, "supply.inlet_film_ratio");
  need(scene.speeds.list.empty() && scene.speeds.from < scene.speeds.to, "a range of speeds");
  return *std::move(reading.scene);
}

// An input's name and its place in a scene. Factors of the film formula have no place there.
struct FieldInfo {
  std::string_view name;
  double* (*place)(Scene&);
};
double* no_place(Scene&) { return nullptr; }
// In the order of Field.
constexpr auto fields = std::to_array<FieldInfo>({
    {"summit_density", [](Scene& scene) { return &scene.surface.summit_density; }},
    {"summit_radius", [](Scene& scene) { return &scene.surface.summit_radius; }},
    {"summit_height_sd", [](Scene& scene) { return &scene.surface.summit_height_sd; }},
    {"summit_plane_offset", [](Scene& scene) { return &scene.surface.summit_plane_offset; }},
    {"effective_modulus", [](Scene& scene) { return &scene.bodies.effective_modulus; }},
    {"reduced_radius", [](Scene& scene) { return &scene.bodies.reduced_radius; }},
    {"viscosity", [](Scene& scene) { return &scene.lubricant.viscosity; }},
    {"pressure_viscosity", [](Scene& scene) { return &scene.lubricant.pressure_viscosity; }},
    {"eyring_stress", [](Scene& scene) { return &*scene.lubricant.eyring_stress; }},
    {"load", [](Scene& scene) { return &scene.load; }},
    {"inlet_film_ratio", [](Scene& scene) { return &scene.supply.value; }},
    {"boundary_coefficient", [](Scene& scene) { return &*scene.friction.boundary_coefficient; }},
    {"film_constant", no_place},
    {"speed", no_place},
});
const FieldInfo& info(Field field) { return fields[static_cast<std::size_t>(field)]; }

}  // namespace

double PaperScenes::film_scale() const {
  return film_constant_scale *
         decimal_power(speed_scale, hamrock_dowson_central_law.speed_exponent);
}

std::string_view name(Field field) { return info(field).name; }

PaperScenes read_paper_scenes(const std::string& folder) {
  PaperScenes scenes;
  for (std::size_t i = 0; i < contact_count; ++i)
    scenes.scene[i] = read_one(fmt::format("{}/{}.toml", folder, stems[i]),
                               i == static_cast<std::size_t>(ContactName::smooth_gw)
                                   ? AsperityModel::greenwood_williamson
                                   : AsperityModel::greenwood_tripp);
  const Speeds& first = scenes.scene[0].speeds;
  for (const Scene& scene : scenes.scene)
    if (scene.speeds.from != first.from || scene.speeds.to != first.to)
      throw std::runtime_error(
          fmt::format("{}: the scenes must have one and the same range of speeds", folder));
  return scenes;
}

bool Input::is_of(std::size_t contact) const {
  return surface == "all" || stems[contact].starts_with(surface);
}

std::vector<Input> read_inputs(const std::string& path) {
  std::vector<Input> inputs;
  verification::each_published_row(path, [&](const auto& row) {
    const auto found = std::find_if(fields.begin(), fields.end(), [&](const FieldInfo& one) {
      return one.name == row.text("field");
    });
    if (found == fields.end())
      throw std::runtime_error(fmt::format("{} is no input", row.text("field")));
    inputs.push_back({static_cast<Field>(found - fields.begin()), row.text("surface"),
                      row.number("value"), row.number("last_digit"), row.number("low"),
                      row.number("high"), row.text("unit"), row.text("reason")});
  });
  return inputs;
}

void scale(PaperScenes& scenes, std::size_t contact, Field field, double factor) {
  if (double* const value = info(field).place(scenes.scene[contact])) *value *= factor;
}

void scale_all(PaperScenes& scenes, Field field, double factor) {
  if (field == Field::film_constant) scenes.film_constant_scale *= factor;
  if (field == Field::speed) scenes.speed_scale *= factor;
  for (std::size_t i = 0; i < contact_count; ++i) scale(scenes, i, field, factor);
}

}  // namespace tribo::reproduction
