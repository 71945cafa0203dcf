// SPDX-License-Identifier: Apache-2.0
// Scenes that the checks use: the paper's surfaces, and random scenes.
#pragma once

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sampling/sampler.hpp"
#include "tribo/scene.hpp"

namespace tribo::verification {

inline constexpr std::array asperity_models{AsperityModel::greenwood_tripp,
                                            AsperityModel::greenwood_williamson};
inline constexpr std::array starvation_closures{
    StarvationClosure::flooded_inlet, StarvationClosure::starved_inlet,
    StarvationClosure::printed_exponents, StarvationClosure::damiens};

// The film laws of lines, or of points, that scenes can name, if load sharing multiplies the film
// by a power of 1 − A. The test analytic.MoesFilm has the other laws.
inline std::vector<FilmFormula> film_formulas(bool of_lines) {
  std::vector<FilmFormula> formulas;
  for (std::size_t i = 0; i < named_film_laws.size(); ++i)
    if (named_film_laws[i].law->is_of_lines == of_lines &&
        named_film_laws[i].law->has_fixed_exponents() &&
        named_film_laws[i].law->sharing_exponent.p != 0)
      formulas.push_back(static_cast<FilmFormula>(i));
  return formulas;
}

// Table 1 of the paper with its misprints mended (model/README.md, section 10).
enum class PaperSurface : int { rough, medium, smooth };
inline constexpr std::array paper_surfaces{PaperSurface::rough, PaperSurface::medium,
                                           PaperSurface::smooth};

inline Scene paper_scene(PaperSurface surface,
                         AsperityModel model = AsperityModel::greenwood_tripp) {
  constexpr std::array<double, 3> density{5e10, 1e11, 2e11};
  constexpr std::array<double, 3> sd{1e-7, 5e-8, 2.5e-8};
  const auto i = static_cast<std::size_t>(surface);
  Scene scene;
  scene.load = 50;
  scene.speeds = {{}, 1e-4, 3, 200, Spacing::log};
  scene.outputs = OutputSet::all();
  scene.surface = {density[i], 1e-5, sd[i], 1.146, 1};
  scene.bodies = {107.9e9, 9.5e-3, 1};
  scene.lubricant = {0.0202, 2e-8, 2.5e6};
  scene.supply = {SupplyKind::inlet_film_ratio, 4};
  scene.friction.boundary_coefficient = 0.13;
  scene.closures.asperity = model;
  return scene;
}

// The paper's medium surface with another density of summits, on a contact of this shape, with this
// film law.
inline Scene scene_of_law(FilmFormula film, ContactShape shape, double density = 1e11) {
  Scene scene = paper_scene(PaperSurface::medium);
  scene.surface.summit_density = density;
  scene.closures.film = film;
  if (shape == ContactShape::circle) return scene;
  scene.bodies = {};
  scene.bodies.effective_modulus = 107.9e9;
  scene.bodies.radius_x = 9.5e-3;
  if (shape == ContactShape::line) scene.bodies.length = 5e-4;
  if (shape == ContactShape::ellipse) scene.bodies.radius_y = 2e-2;
  return scene;
}

// A surface of the paper whose supply, unless it is `flooded`, starves the inlet within the scene's
// speeds.
inline Scene starved_scene(PaperSurface surface, StarvationClosure closure,
                           SupplyKind supply = SupplyKind::inlet_film_ratio,
                           AsperityModel model = AsperityModel::greenwood_tripp) {
  constexpr std::array values{0.0, 2e-7, 4.0, 1e-8};  // flooded, film, film ratio, flow
  Scene scene = paper_scene(surface, model);
  scene.closures.starvation = closure;
  scene.supply = {supply, values[static_cast<std::size_t>(supply)]};
  return scene;
}

// A scene with random numbers and words in all fields. Where fields exclude each other, it has only
// the usual ones (test RandomScenes.DrawEachFieldOfTheTable).
inline Scene random_scene(Sampler& sampler) {
  Scene scene;
  scene.load = sampler.log_uniform(0.1, 1e4);
  scene.speeds.list = {sampler.log_uniform(1e-5, 30)};
  scene.outputs = OutputSet::all();
  scene.surface.summit_height_sd = sampler.log_uniform(5e-9, 1e-6);
  scene.surface.summit_radius = sampler.log_uniform(1e-6, 1e-4);
  scene.surface.summit_density =
      sampler.uniform(0.02, 0.08) / (scene.surface.summit_radius * scene.surface.summit_height_sd);
  scene.surface.summit_plane_offset = sampler.uniform(0, 1.5);
  scene.surface.offset_planes = sampler.pick({0, 1, 2});
  scene.surface.rms_roughness = 1.25 * scene.surface.summit_height_sd;
  scene.bodies.effective_modulus = sampler.log_uniform(1e10, 3e11);
  const ContactShape shape = sampler.pick(
      {ContactShape::circle, ContactShape::circle, ContactShape::ellipse, ContactShape::line});
  const double radius = sampler.log_uniform(1e-3, 0.1);
  (shape == ContactShape::circle ? scene.bodies.reduced_radius : scene.bodies.radius_x) = radius;
  if (shape == ContactShape::circle) scene.bodies.ellipticity = sampler.uniform(0.5, 4);
  if (shape == ContactShape::ellipse) scene.bodies.radius_y = radius * sampler.log_uniform(0.2, 50);
  if (shape == ContactShape::line) scene.bodies.length = radius * sampler.log_uniform(0.05, 5);
  scene.lubricant = {sampler.log_uniform(1e-3, 1), sampler.log_uniform(5e-9, 4e-8),
                     sampler.log_uniform(1e6, 1e7)};
  scene.supply.kind = sampler.pick({SupplyKind::flooded, SupplyKind::inlet_film,
                                    SupplyKind::inlet_film_ratio, SupplyKind::inlet_flow});
  scene.supply.value =
      scene.supply.kind == SupplyKind::inlet_film_ratio ? sampler.log_uniform(1, 50)
      : scene.supply.kind == SupplyKind::inlet_film     ? sampler.log_uniform(1e-8, 1e-5)
                                                        : sampler.log_uniform(1e-10, 1e-6);
  scene.friction.boundary_coefficient = sampler.uniform(0.05, 0.2);
  scene.friction.slide_roll_ratio = sampler.uniform(0.01, 2);
  scene.friction.fluid = sampler.pick({FluidShear::eyring, FluidShear::limiting});
  scene.friction.viscosity =
      sampler.pick({ViscosityLaw::barus, ViscosityLaw::ambient, ViscosityLaw::roelands});
  scene.closures.asperity = sampler.pick(asperity_models);
  scene.closures.starvation = sampler.pick(starvation_closures);
  scene.closures.damiens_exponent = sampler.uniform(1, 5);
  scene.closures.film = sampler.pick(film_formulas(shape == ContactShape::line));
  return scene;
}

// The numbers of a scene with their names, its first speed among them. Condition numbers are sums
// over these inputs.
inline std::vector<std::pair<std::string_view, double*>> numbers_of(Scene& scene) {
  return {{"load", &scene.load},
          {"speed", scene.speeds.list.data()},
          {"summit_density", &scene.surface.summit_density},
          {"summit_radius", &scene.surface.summit_radius},
          {"summit_height_sd", &scene.surface.summit_height_sd},
          {"summit_plane_offset", &scene.surface.summit_plane_offset},
          {"effective_modulus", &scene.bodies.effective_modulus},
          {"radius_x", scene.bodies.shape() == ContactShape::circle ? &scene.bodies.reduced_radius
                                                                    : &scene.bodies.radius_x},
          {"across", scene.bodies.shape() == ContactShape::circle ? &scene.bodies.ellipticity
                     : scene.bodies.shape() == ContactShape::line ? &scene.bodies.length
                                                                  : &scene.bodies.radius_y},
          {"viscosity", &scene.lubricant.viscosity},
          {"pressure_viscosity", &scene.lubricant.pressure_viscosity},
          {"eyring_stress", &*scene.lubricant.eyring_stress},
          {"supply", &scene.supply.value},
          {"boundary_coefficient", &*scene.friction.boundary_coefficient},
          {"slide_roll_ratio", &scene.friction.slide_roll_ratio},
          {"damiens_exponent", &scene.closures.damiens_exponent}};
}

// All numbers and words of a scene. A word is given as its place in its enumeration of scene.hpp.
inline std::vector<std::pair<std::string_view, double>> describe_numbers(Scene scene) {
  std::vector<std::pair<std::string_view, double>> all;
  for (const auto& [name, number] : numbers_of(scene))
    if (number != nullptr) all.emplace_back(name, *number);  // a range of speeds has no number
  all.emplace_back("offset_planes", static_cast<double>(scene.surface.offset_planes));
  all.emplace_back("shape", static_cast<double>(scene.bodies.shape()));
  all.emplace_back("supply_kind", static_cast<double>(scene.supply.kind));
  all.emplace_back("fluid", static_cast<double>(scene.friction.fluid));
  all.emplace_back("viscosity_law", static_cast<double>(scene.friction.viscosity));
  all.emplace_back("asperity", static_cast<double>(scene.closures.asperity));
  all.emplace_back("starvation", static_cast<double>(scene.closures.starvation));
  all.emplace_back("film_law", static_cast<double>(scene.closures.film));
  return all;
}

inline std::string describe_scene(const Scene& scene) {
  std::string text;
  for (const auto& [name, number] : describe_numbers(scene))
    text += fmt::format("\n  {} = {} ({:a})", name, number, number);
  return text;
}

}  // namespace tribo::verification
