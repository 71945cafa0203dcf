// SPDX-License-Identifier: Apache-2.0
// The groups of scenes: what groups/paper.py and groups/contacts.py are told of them before they
// are solved.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "page/facts.hpp"
#include "page/project_files.hpp"
#include "reproduction/claims.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/onset.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::report {
namespace {

Json scene_json(const Case& source) {
  const Scene& scene = source.scene;
  const MixedContact<double> contact(scene);
  const auto span = detail::speed_span(scene.speeds);
  return {
      {"file", source.file},
      {"surface", source.surface},
      {"model", source.short_model()},
      {"load", scene.load},
      {"supply",
       {{"kind", supply_words[static_cast<std::size_t>(scene.supply.kind)]},
        {"value", scene.supply.value}}},
      {"starvation", starvation_closure_words[static_cast<std::size_t>(scene.closures.starvation)]},
      {"speeds", {span.low, span.high}},
      {"share_without_film", contact.sharing().asperity_share(0)},
      {"speed_power", contact.film().speed_power.value}};
}

// An input of a scene: how it is read from there, and the misprint that changes it.
struct InputRow {
  std::string_view field;  // one of scene_fields()
  Json (*value)(const Scene&);
  std::string_view erratum = {};
};

// 0: not given. Values that follow from two bodies or from moments stand in the scene as well.
Json if_given(double value) {
  if (value == 0) return nullptr;
  return std::isinf(value) ? Json(value > 0 ? "inf" : "-inf") : Json(value);
}
// 0 is legal.
Json poisson_ratio(const Scene& scene, std::size_t body) {
  const Body& one = scene.bodies.bodies[body];
  return one.modulus > 0 ? Json(one.poisson_ratio) : Json();
}
Json ellipticity(const Scene& scene) {
  const bool is_circle = scene.bodies.shape() == ContactShape::circle;
  return is_circle ? Json(scene.bodies.ellipticity) : Json();
}

const InputRow input_rows[] = {
    {"surface.summit_density", [](const Scene& s) { return Json(s.surface.summit_density); }},
    {"surface.summit_radius", [](const Scene& s) { return Json(s.surface.summit_radius); }, "E17"},
    {"surface.summit_height_sd", [](const Scene& s) { return Json(s.surface.summit_height_sd); }},
    {"surface.summit_plane_offset",
     [](const Scene& s) { return Json(s.surface.summit_plane_offset); }},
    {"surface.m0", [](const Scene& s) { return if_given(s.surface.moments.m0); }},
    {"surface.m2", [](const Scene& s) { return if_given(s.surface.moments.m2); }},
    {"surface.m4", [](const Scene& s) { return if_given(s.surface.moments.m4); }},
    {"surface.offset_planes", [](const Scene& s) { return Json(s.surface.offset_planes); }, "E9"},
    {"bodies.effective_modulus", [](const Scene& s) { return Json(s.bodies.effective_modulus); },
     "E2"},
    {"bodies.reduced_radius", [](const Scene& s) { return if_given(s.bodies.reduced_radius); },
     "E18"},
    {"bodies.ellipticity", ellipticity},
    {"bodies.radius_x", [](const Scene& s) { return if_given(s.bodies.radius_x); }},
    {"bodies.radius_y", [](const Scene& s) { return if_given(s.bodies.radius_y); }},
    {"bodies.length", [](const Scene& s) { return if_given(s.bodies.length); }},
    {"bodies.first_modulus", [](const Scene& s) { return if_given(s.bodies.bodies[0].modulus); }},
    {"bodies.first_poisson_ratio", [](const Scene& s) { return poisson_ratio(s, 0); }},
    {"bodies.second_modulus", [](const Scene& s) { return if_given(s.bodies.bodies[1].modulus); }},
    {"bodies.second_poisson_ratio", [](const Scene& s) { return poisson_ratio(s, 1); }},
    {"bodies.first_radius_x", [](const Scene& s) { return if_given(s.bodies.bodies[0].radius_x); }},
    {"bodies.second_radius_x",
     [](const Scene& s) { return if_given(s.bodies.bodies[1].radius_x); }},
    {"bodies.first_radius_y", [](const Scene& s) { return if_given(s.bodies.bodies[0].radius_y); }},
    {"bodies.second_radius_y",
     [](const Scene& s) { return if_given(s.bodies.bodies[1].radius_y); }},
    {"lubricant.viscosity", [](const Scene& s) { return Json(s.lubricant.viscosity); }},
    {"lubricant.pressure_viscosity",
     [](const Scene& s) { return Json(s.lubricant.pressure_viscosity); }},
    {"lubricant.eyring_stress", [](const Scene& s) { return number(s.lubricant.eyring_stress); }},
    {"load", [](const Scene& s) { return Json(s.load); }},
    {"speed.from", [](const Scene& s) { return Json(detail::speed_span(s.speeds).low); }},
    {"speed.to", [](const Scene& s) { return Json(detail::speed_span(s.speeds).high); }},
    {"supply.inlet_film",
     [](const Scene& s) {
       return s.supply.kind == SupplyKind::inlet_film ? Json(s.supply.value) : Json();
     }},
    {"supply.inlet_film_ratio",
     [](const Scene& s) {
       return s.supply.kind == SupplyKind::inlet_film_ratio ? Json(s.supply.value) : Json();
     }},
    {"supply.inlet_flow",
     [](const Scene& s) {
       return s.supply.kind == SupplyKind::inlet_flow ? Json(s.supply.value) : Json();
     }},
    {"friction.boundary_coefficient",
     [](const Scene& s) { return number(s.friction.boundary_coefficient); }, "E20"},
    {"friction.slide_roll_ratio", [](const Scene& s) { return Json(s.friction.slide_roll_ratio); }},
    {"friction.fluid",
     [](const Scene& s) {
       return Json(fluid_shear_words[static_cast<std::size_t>(s.friction.fluid)]);
     },
     "E19"},
    {"friction.viscosity",
     [](const Scene& s) {
       return Json(viscosity_law_words[static_cast<std::size_t>(s.friction.viscosity)]);
     },
     "E20"},
    {"closures.asperity",
     [](const Scene& s) {
       return Json(asperity_model_words[static_cast<std::size_t>(s.closures.asperity)]);
     }},
    {"closures.starvation",
     [](const Scene& s) {
       return Json(starvation_closure_words[static_cast<std::size_t>(s.closures.starvation)]);
     },
     "E11"},
    {"closures.film",
     [](const Scene& s) {
       return Json(film_formula_words[static_cast<std::size_t>(s.closures.film)]);
     }},
};

// Those that a scene has a value of.
Json inputs_json(const std::vector<Case>& cases) {
  Json inputs = Json::array();
  for (const InputRow& row : input_rows) {
    const auto fields = scene_fields();
    const auto field = std::find_if(fields.begin(), fields.end(),
                                    [&](const FieldInfo& one) { return one.path == row.field; });
    Json values = Json::object();
    for (const Case& one : cases) {
      Json value = row.value(one.scene);
      if (!value.is_null()) values[one.stem()] = std::move(value);
    }
    if (values.empty()) continue;
    inputs.push_back({{"field", row.field},
                      {"unit", field->unit},
                      {"meaning", field->meaning},
                      {"erratum", row.erratum.empty() ? Json(nullptr) : Json(row.erratum)},
                      {"values", std::move(values)}});
  }
  return inputs;
}

// groups/paper.py takes them as they are.
void check_claims(const ReportPlaces& places) {
  try {
    reproduction::read_claims((places.scenes / "claims.tsv").string());
  } catch (const std::runtime_error& error) {
    throw ReportError(error.what());
  }
}

// The scenes of reference/scenes, for groups/contacts.py: a circle, an ellipse and a line.
constexpr std::array<std::string_view, 3> contact_stems{"ball_on_flat", "bearing_outer_ring",
                                                        "gear_flank"};
// In the order of ContactShape.
constexpr std::array<std::string_view, 3> shape_words{"circle", "ellipse", "line"};
constexpr double told_speed = 1;  // m/s, at which the page tells films

Json contact_json(const ReportPlaces& places, std::string_view stem) {
  const std::filesystem::path path = places.reference / "scenes" / fmt::format("{}.toml", stem);
  const SceneReading reading = read_scene(path.string(), SceneUse::speeds);
  if (!reading.scene) throw std::runtime_error(reading.errors.front().line());
  const std::string shown = places.shown(path);
  const Scene& scene = *reading.scene;
  const auto span = detail::speed_span(scene.speeds);
  if (!has_friction_inputs(scene))
    throw std::runtime_error(shown + " has not all inputs of friction");
  if (!(span.low <= told_speed && told_speed <= span.high))
    throw std::runtime_error(fmt::format("the speeds of {} leave {} m/s out", shown, told_speed));
  const MixedContact<double> contact(scene);
  const HertzContact<double> hertz = contact.hertz();
  const auto numbers = detail::numbers_of<double>(scene);
  const ContactShape shape = scene.bodies.shape();
  const bool is_line = shape == ContactShape::line;
  const auto of_point = [&](double value) { return is_line ? Json(nullptr) : Json(value); };
  return {{"file", shown},
          {"shape", shape_words[static_cast<std::size_t>(shape)]},
          {"load", scene.load},
          {"effective_modulus", numbers.effective_modulus},
          {"radius_x", numbers.radius_x},
          {"radius_y", of_point(shape == ContactShape::circle ? numbers.radius_x : numbers.across)},
          {"length", is_line ? Json(scene.bodies.length) : Json(nullptr)},
          {"semi_axis_x", hertz.semi_axis_x},
          {"semi_axis_y", of_point(hertz.semi_axis_y)},
          {"ellipticity", of_point(hertz.semi_axis_y / hertz.semi_axis_x)},
          {"mean_pressure", hertz.mean_pressure},
          {"peak_pressure", hertz.peak_pressure},
          {"approach", of_point(hertz.approach)},
          {"summit_height_sd", contact.summit_height_sd()},
          {"slide_roll_ratio", scene.friction.slide_roll_ratio},
          {"film_law", film_formula_words[static_cast<std::size_t>(scene.closures.film)]},
          {"speeds", {span.low, span.high}}};
}

}  // namespace

Json paper_facts(const ReportPlaces& places, const std::vector<Case>& cases) {
  check_claims(places);
  Json facts;
  for (const Case& one : cases) facts["scenes"][one.stem()] = scene_json(one);
  facts["inputs"] = inputs_json(cases);
  return facts;
}

Json contacts_facts(const ReportPlaces& places) {
  Json facts;
  for (const std::string_view stem : contact_stems)
    facts[std::string(stem)] = contact_json(places, stem);
  return facts;
}

}  // namespace tribo::report
