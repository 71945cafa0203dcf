// SPDX-License-Identifier: Apache-2.0
// What groups/contacts.py is told of the scenes of reference/scenes, a circle, an ellipse and a
// line, before they are solved.
#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "page/facts.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/onset.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::report {
namespace {

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

Json contacts_facts(const ReportPlaces& places) {
  Json facts;
  for (const std::string_view stem : contact_stems)
    facts[std::string(stem)] = contact_json(places, stem);
  return facts;
}

}  // namespace tribo::report
