// SPDX-License-Identifier: Apache-2.0
// The groups of scenes: what groups/paper.py and groups/contacts.py are told of them before they
// are solved.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "page/facts.hpp"
#include "page/project_files.hpp"
#include "reproduction/claims.hpp"
#include "scene/schema.hpp"
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

// The misprints that change an input of a scene.
constexpr std::pair<std::string_view, std::string_view> errata_of_inputs[] = {
    {"surface.summit_radius", "E17"},
    {"surface.offset_planes", "E9"},
    {"bodies.effective_modulus", "E2"},
    {"bodies.reduced_radius", "E18"},
    {"friction.boundary_coefficient", "E20"},
    {"friction.fluid", "E19"},
    {"friction.viscosity", "E20"},
    {"closures.starvation", "E11"},
};

// An input of a scene, null where it has none. Of all its speeds there are the least and the
// greatest.
Json input_json(const Scene& scene, std::size_t place) {
  const FieldInfo& field = scene_fields()[place];
  if (field.type == FieldType::speeds || field.path == "speed.count" ||
      field.path == "speed.spacing")
    return nullptr;
  if (field.path == "speed.from") return detail::speed_span(scene.speeds).low;
  if (field.path == "speed.to") return detail::speed_span(scene.speeds).high;
  const std::optional<double> value = scene_detail::value_in(scene, place);
  if (!value) return nullptr;
  if (field.type == FieldType::choice) return field.choices[static_cast<std::size_t>(*value)];
  if (field.type == FieldType::integer) return static_cast<int>(*value);
  return std::isinf(*value) ? Json(*value > 0 ? "inf" : "-inf") : Json(*value);
}

Json erratum_of(std::string_view path) {
  for (const auto& [field, erratum] : errata_of_inputs)
    if (field == path) return erratum;
  return nullptr;
}

// Those that a scene has a value of.
Json inputs_json(const std::vector<Case>& cases) {
  Json inputs = Json::array();
  for (std::size_t place = 0; place < scene_fields().size(); ++place) {
    const FieldInfo& field = scene_fields()[place];
    Json values = Json::object();
    for (const Case& one : cases) {
      Json value = input_json(one.scene, place);
      if (!value.is_null()) values[one.stem()] = std::move(value);
    }
    if (values.empty()) continue;
    inputs.push_back({{"field", field.path},
                      {"unit", field.unit},
                      {"meaning", field.meaning},
                      {"erratum", erratum_of(field.path)},
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
