// SPDX-License-Identifier: Apache-2.0
// Mistakes in operating points: the model's own answer to a scene that was misread, or with one
// part of it gone wrong.
#include <cmath>
#include <numbers>
#include <utility>

#include "conformance/mistake.hpp"
#include "conformance/point_mistake.hpp"
#include "conformance/wrong_parts.hpp"

namespace tribo::conformance {
namespace {

using Value = std::optional<double>;

FilmInputs film_inputs(const Scene& s) {
  return {s.speeds[0],
          s.lubricant.viscosity,
          s.lubricant.pressure_viscosity,
          s.load,
          s.bodies.effective_modulus,
          s.bodies.reduced_radius,
          s.bodies.ellipticity};
}

// Multiplies the film formula by a factor: changes the speed, but keeps the sliding speed and the
// supply as they are.
void scale_film(Scene& scene, double factor) {
  const double by = std::pow(factor, 1 / 0.67);
  for (double& speed : scene.speeds.list) speed *= by;
  scene.friction.slide_roll_ratio /= by;
  if (scene.supply.kind == SupplyKind::inlet_flow) scene.supply.value *= by;
}

// K times a factor, the real area left as it is: √(σ_s/β) grows at constant nβ; the number of
// summits grows by the factor's square.
void scale_stiffness(Scene& scene, double factor) {
  scene.surface.summit_density *= factor * factor;
  scene.surface.summit_radius /= factor * factor;
}

// A_nom times a factor, by R, with the film formula left as it is.
void scale_area(Scene& scene, double factor) {
  const double right = right_film(film_inputs(scene));
  scene.bodies.reduced_radius *= std::pow(factor, 1.5);
  scale_film(scene, right / right_film(film_inputs(scene)));
}

std::vector<Mistake> film_mistakes() {
  std::vector<Mistake> all;
  for (const WrongFilm& wrong : wrong_films())
    all.push_back(
        changed(wrong.name, wrong.text + ", in the film formula", [film = wrong.film](Scene& s) {
          scale_film(s, film(film_inputs(s)) / right_film(film_inputs(s)));
        }));
  return all;
}

std::vector<Mistake> area_mistakes() {
  const auto factor = [](const char* name, const char* text, double by) {
    return changed(name, text, [by](Scene& s) { scale_area(s, by); });
  };
  return {
      factor("area-without-pi", "A_nom = a² in place of πa²", 1 / std::numbers::pi),
      factor("area-radius-halved", "R/2 in place of R in the Hertz contact",
             std::pow(0.5, 2.0 / 3)),
      factor("area-2E*", "2E* in place of E* in the Hertz contact", std::pow(0.5, 2.0 / 3)),
      factor("area-E*-halved", "E*/2 in place of E* in the Hertz contact", std::pow(2.0, 2.0 / 3)),
      factor("area-R-in-mm", "R in mm in place of m in the Hertz contact", 100)};
}

Mistake stiffness(const char* name, const char* text, double gt, double gw) {
  return changed_with_count(name, text, [=](Scene& s) {
    const double factor = s.closures.asperity == AsperityModel::greenwood_tripp ? gt : gw;
    scale_stiffness(s, factor);
    return 1 / (factor * factor);
  });
}

std::vector<Mistake> stiffness_mistakes() {
  return {
      stiffness("stiffness-halved", "8√2/15 in place of 16√2/15 with E*", 0.5, 1),
      stiffness("stiffness-both-halved", "E*/2 in place of E* in the asperities' load", 0.5, 0.5),
      stiffness("stiffness-doubled", "E′ = 2E* in the asperities' load", 2, 2),
      stiffness("stiffness-sigma-in-um", "σ_s in µm in place of m in the asperities' load", 1e15,
                1e9),
      stiffness("stiffness-beta-in-um", "β in µm in place of m in the asperities' load", 1e9, 1e3),
      changed_with_count(
          "stiffness-gw-for-gt",
          "Greenwood and Williamson's prefactor in Greenwood and Tripp's load", [](Scene& s) {
            if (s.closures.asperity != AsperityModel::greenwood_tripp) return 1.0;
            const double roughness =
                s.surface.summit_density * s.surface.summit_radius * s.surface.summit_height_sd;
            const double factor = 4.0 / 3 / (16 * std::sqrt(2) / 15 * std::numbers::pi * roughness);
            scale_stiffness(s, factor);
            return 1 / (factor * factor);
          })};
}

std::vector<Mistake> input_mistakes() {
  return {
      changed("radius-halved",
              "R/2 in place of R throughout (a ball on a flat has the ball's radius)",
              [](Scene& s) { s.bodies.reduced_radius /= 2; }),
      changed("radius-in-mm", "R in mm in place of m",
              [](Scene& s) { s.bodies.reduced_radius *= 1e3; }),
      changed("2E*", "2E* in place of E* throughout",
              [](Scene& s) { s.bodies.effective_modulus *= 2; }),
      changed("E*-halved", "E*/2 in place of E* throughout",
              [](Scene& s) { s.bodies.effective_modulus /= 2; }),
      changed("sigma-of-one-face", "σ_s of one face, smaller by √2, in place of that of the sum",
              [](Scene& s) { s.surface.summit_height_sd /= std::sqrt(2); }),
      changed("sigma-times-root-2", "σ_s times √2, as if one face's had been given",
              [](Scene& s) { s.surface.summit_height_sd *= std::sqrt(2); }),
      changed("sigma-in-um", "σ_s in µm in place of m",
              [](Scene& s) { s.surface.summit_height_sd *= 1e6; }),
      changed("summit-radius-in-um", "β in µm in place of m",
              [](Scene& s) { s.surface.summit_radius *= 1e6; }),
      changed("offset-ignored", "no offset of the summit plane, δ = 0",
              [](Scene& s) { s.surface.offset_planes = 0; }),
      changed("offset-added", "the offset of the summit plane with the other sign, F at λ + δ",
              [](Scene& s) { s.surface.summit_plane_offset *= -1; }),
      changed("offset-doubled", "twice the offset of the summit plane",
              [](Scene& s) { s.surface.summit_plane_offset *= 2; }),
      changed("offset-of-one-plane", "one offset plane, whatever `offset_planes` says",
              [](Scene& s) { s.surface.offset_planes = 1; }),
      changed("offset-of-two-planes", "two offset planes, whatever `offset_planes` says",
              [](Scene& s) { s.surface.offset_planes = 2; }),
      changed("viscosity-in-mPas", "η₀ in mPa·s in place of Pa·s",
              [](Scene& s) { s.lubricant.viscosity *= 1e3; }),
      changed("gw-for-gt", "Greenwood and Williamson where Greenwood and Tripp is asked for",
              [](Scene& s) { s.closures.asperity = AsperityModel::greenwood_williamson; }),
      changed("gt-for-gw", "Greenwood and Tripp where Greenwood and Williamson is asked for",
              [](Scene& s) { s.closures.asperity = AsperityModel::greenwood_tripp; })};
}

std::vector<Mistake> inlet_mistakes() {
  std::vector<Mistake> all;
  for (const WrongInlet& wrong : wrong_inlets()) all.push_back(with_inlet(wrong));
  return all;
}

std::vector<Mistake> sharing_mistakes() {
  std::vector<Mistake> all;
  for (const WrongSharing& wrong : wrong_sharings()) all.push_back(with_sharing(wrong));
  return all;
}

}  // namespace

std::vector<Mistake> point_mistakes() {
  std::vector<Mistake> all;
  for (std::vector<Mistake> part :
       {film_mistakes(), area_mistakes(), stiffness_mistakes(), input_mistakes(), inlet_mistakes(),
        sharing_mistakes(), friction_mistakes()})
    for (Mistake& one : part) all.push_back(std::move(one));
  return all;
}

}  // namespace tribo::conformance
