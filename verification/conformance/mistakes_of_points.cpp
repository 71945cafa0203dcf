// SPDX-License-Identifier: Apache-2.0
// Mistakes in operating points: the model's own answer to a scene that was misread, or with one
// part of it replaced.
#include <cmath>
#include <numbers>

#include "conformance/mistake.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::conformance {
namespace {

using nlohmann::json;
using Value = std::optional<double>;
using Point = OperatingPoint<double>;

// A scene with its one speed.
std::optional<Scene> scene_of(const json& inputs) {
  return parse_scene_json(inputs.dump(), "case", SceneUse::one_speed).scene;
}

Value field_of(const Point& point, std::string_view field) {
  if (field == "film_flooded") return point.film_flooded;
  if (field == "film") return point.film;
  if (field == "separation") return point.separation;
  if (field == "film_parameter") return point.film_parameter;
  if (field == "asperity_load_share") return point.asperity_load_share;
  if (field == "fluid_load_share") return point.fluid_load_share;
  if (field == "real_area_ratio") return point.real_area_ratio;
  if (field == "summit_count") return point.summit_count;
  if (field == "friction" && !point.friction_undefined) return point.friction;
  return std::nullopt;
}

bool is_of_film_or_share(std::string_view field) {
  return field != "real_area_ratio" && field != "summit_count" && field != "friction";
}

// What comes of a change of the scene. With `only_films` the change stands for one of K alone, and
// says nothing of area, count and friction.
template <class Change>
Mistake changed(std::string name, std::string text, Change&& change, bool only_films = false) {
  return {"operating_point", std::move(name), std::move(text),
          [change, only_films](const json& inputs, std::string_view field) -> Value {
            if (only_films && !is_of_film_or_share(field)) return std::nullopt;
            std::optional<Scene> scene = scene_of(inputs);
            if (!scene) return std::nullopt;
            const double summit_height_sd = scene->surface.summit_height_sd;
            change(*scene);
            const Point point = MixedContact<double>(*scene).solve(scene->speeds[0]);
            const Value value = field_of(point, field);
            // λ is h/σ_s with the σ_s that was given.
            if (value && field == "film_parameter" &&
                scene->surface.summit_height_sd != summit_height_sd)
              return std::nullopt;
            return value;
          }};
}

// The film formula times a factor: by the speed, with the sliding speed and the supply left as they
// are.
void scale_film(Scene& scene, double factor) {
  const double by = std::pow(factor, 1 / 0.67);
  for (double& speed : scene.speeds.list) speed *= by;
  scene.friction.slide_roll_ratio /= by;
  if (scene.supply.kind == SupplyKind::inlet_flow) scene.supply.value *= by;
}

// K times a factor, by the density; area and count are no longer right.
void scale_stiffness(Scene& scene, double factor) {
  const bool is_gt = scene.closures.asperity == AsperityModel::greenwood_tripp;
  scene.surface.summit_density *= is_gt ? std::sqrt(factor) : factor;
}

Mistake film_factor(std::string name, std::string text, double factor) {
  return changed(std::move(name), std::move(text), [factor](Scene& s) { scale_film(s, factor); });
}
Mistake stiffness_factor(std::string name, std::string text, double gt, double gw) {
  return changed(
      std::move(name), std::move(text),
      [=](Scene& s) {
        scale_stiffness(s, s.closures.asperity == AsperityModel::greenwood_tripp ? gt : gw);
      },
      true);
}

std::vector<Mistake> film_mistakes() {
  const double circular = 1 - 0.61 * std::exp(-0.73);
  return {film_factor("film-E*-in-U", "E* in place of 2E* in the film's speed number U",
                      std::pow(2, 0.67)),
          film_factor("film-speed-sum", "the sum of the surface speeds in place of their mean",
                      std::pow(2, 0.67)),
          film_factor("film-E*-in-G", "E* in place of 2E* in the film's material number G",
                      std::pow(2, -0.53)),
          film_factor("film-E*-in-W", "E* in place of 2E* in the film's load number W",
                      std::pow(2, -0.067)),
          film_factor("film-E*", "E* in place of 2E* in the film's U, G and W",
                      std::pow(2, 0.67 - 0.53 - 0.067)),
          film_factor("film-bracket-dropped", "2.69 without 1 − 0.61 e^{−0.73k}, circular contacts",
                      1 / circular),
          film_factor("film-0.6", "0.6 in place of 0.61 in the film's constant, circular contacts",
                      (1 - 0.6 * std::exp(-0.73)) / circular),
          film_factor("film-constant-1.9", "the rounded constant 1.9, circular contacts",
                      1.9 / (2.69 * circular)),
          film_factor("film-radius-halved-in-film", "R/2 in place of R in the film formula alone",
                      std::pow(0.5, 1 - 0.67 + 2 * 0.067))};
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
              [](Scene& s) {
                s.surface.summit_height_sd /= std::sqrt(2);
                s.surface.summit_plane_offset *= std::sqrt(2);
              }),
      changed("sigma-doubled-variance", "σ_s times √2, as if it were one face's",
              [](Scene& s) { s.surface.summit_height_sd *= std::sqrt(2); }),
      changed("summit-radius-in-um", "β in µm in place of m",
              [](Scene& s) { s.surface.summit_radius *= 1e6; }),
      changed("offset-ignored", "no offset of the summit plane, δ = 0",
              [](Scene& s) { s.surface.offset_planes = 0; }),
      changed("offset-doubled", "twice the offset of the summit plane",
              [](Scene& s) { s.surface.summit_plane_offset *= 2; }),
      changed("offset-of-one-plane", "one offset plane, whatever `offset_planes` says",
              [](Scene& s) { s.surface.offset_planes = 1; }),
      changed("offset-of-two-planes", "two offset planes, whatever `offset_planes` says",
              [](Scene& s) { s.surface.offset_planes = 2; }),
      changed("viscosity-in-mPas", "η₀ in mPa·s in place of Pa·s",
              [](Scene& s) { s.lubricant.viscosity *= 1e3; })};
}

std::vector<Mistake> stiffness_mistakes() {
  constexpr double pi = std::numbers::pi;
  return {
      stiffness_factor("stiffness-halved", "8√2/15 in place of 16√2/15 with E*, or E*/2", 0.5, 1),
      stiffness_factor("stiffness-doubled", "E′ = 2E* in the asperities' load", 2, 2),
      stiffness_factor("area-without-pi", "A_nom = a² in place of πa² in the asperities' load",
                       1 / pi, 1 / pi),
      stiffness_factor("asperities-ignored", "a film that no asperities share", 1e-12, 1e-12)};
}

std::vector<Mistake> closure_mistakes() {
  std::vector<Mistake> all{
      changed("gw-for-gt", "Greenwood and Williamson where Greenwood and Tripp is asked for",
              [](Scene& s) { s.closures.asperity = AsperityModel::greenwood_williamson; }),
      changed("gt-for-gw", "Greenwood and Tripp where Greenwood and Williamson is asked for",
              [](Scene& s) { s.closures.asperity = AsperityModel::greenwood_tripp; }),
      changed("never-starved", "a fully flooded inlet, whatever the supply",
              [](Scene& s) { s.supply.kind = SupplyKind::flooded; }),
      changed("inlet-ratio-as-film", "h_oil/σ_s taken for h_oil in µm", [](Scene& s) {
        if (s.supply.kind != SupplyKind::inlet_film_ratio) return;
        s.supply.kind = SupplyKind::inlet_film;
        s.supply.value *= 1e-6;
      })};
  constexpr std::pair<StarvationClosure, const char*> closures[] = {
      {StarvationClosure::flooded_inlet, "flooded_inlet"},
      {StarvationClosure::starved_inlet, "starved_inlet"},
      {StarvationClosure::printed_exponents, "printed_exponents"},
      {StarvationClosure::damiens, "damiens"}};
  for (const auto& [closure, name] : closures)
    all.push_back(changed(std::string("always-") + name,
                          std::string("the closure `") + name + "` whatever is asked for",
                          [closure = closure](Scene& s) { s.closures.starvation = closure; }));
  return all;
}

// What friction is made of, from the point's other outputs.
template <class Wrong>
Mistake friction_from(std::string name, std::string text, Wrong&& wrong) {
  return {"operating_point", std::move(name), std::move(text),
          [wrong](const json& inputs, std::string_view field) -> Value {
            const std::optional<Scene> scene = scene_of(inputs);
            if (!scene) return std::nullopt;
            const MixedContact<double> contact(*scene);
            const Point point = contact.solve(scene->speeds[0]);
            if (field != "friction") return field_of(point, field);
            if (point.friction_undefined) return std::nullopt;
            const double dry = *scene->friction.boundary_coefficient * point.asperity_load_share;
            return wrong(*scene, point, dry);
          }};
}

std::vector<Mistake> friction_mistakes() {
  return {
      changed("viscosity-ambient", "the viscosity at ambient pressure, whatever law is asked for",
              [](Scene& s) { s.friction.viscosity = ViscosityLaw::ambient; }),
      changed("viscosity-barus", "Barus' law, whatever law is asked for",
              [](Scene& s) { s.friction.viscosity = ViscosityLaw::barus; }),
      changed("viscosity-roelands", "Roelands' law, whatever law is asked for",
              [](Scene& s) { s.friction.viscosity = ViscosityLaw::roelands; }),
      changed("shear-limiting", "the limiting shear law, whatever law is asked for",
              [](Scene& s) { s.friction.fluid = FluidShear::limiting; }),
      changed("shear-eyring", "Eyring's shear law, whatever law is asked for",
              [](Scene& s) { s.friction.fluid = FluidShear::eyring; }),
      changed("slide-roll-ignored", "the slide-roll ratio taken as 1",
              [](Scene& s) { s.friction.slide_roll_ratio = 1; }),
      friction_from(
          "friction-share-swapped", "μ_b times the fluid's share in place of the asperities'",
          [](const Scene& s, const Point& p, double dry) -> Value {
            return p.friction - dry + *s.friction.boundary_coefficient * p.fluid_load_share;
          }),
      friction_from("friction-boundary-unshared", "μ_b whole, in place of μ_b A",
                    [](const Scene& s, const Point& p, double dry) -> Value {
                      return p.friction - dry + *s.friction.boundary_coefficient;
                    }),
      friction_from("friction-fluid-missing", "μ_b A alone, without the film's shear",
                    [](const Scene&, const Point&, double dry) -> Value { return dry; }),
      friction_from(
          "friction-boundary-missing", "the film's shear alone, without μ_b A",
          [](const Scene&, const Point& p, double dry) -> Value { return p.friction - dry; }),
      friction_from("friction-area-not-subtracted",
                    "the film sheared over A_nom in place of A_nom − A_r",
                    [](const Scene&, const Point& p, double dry) -> Value {
                      const double fluid_area = 1 - p.real_area_ratio;
                      if (!(fluid_area > 1e-3)) return std::nullopt;
                      return dry + (p.friction - dry) / fluid_area;
                    })};
}

}  // namespace

std::vector<Mistake> point_mistakes() {
  std::vector<Mistake> all;
  for (std::vector<Mistake> part : {film_mistakes(), input_mistakes(), stiffness_mistakes(),
                                    closure_mistakes(), friction_mistakes()})
    for (Mistake& one : part) all.push_back(std::move(one));
  return all;
}

}  // namespace tribo::conformance
