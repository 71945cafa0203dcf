// SPDX-License-Identifier: Apache-2.0
// The group `contacts`: the scenes of reference/scenes, a circle, an ellipse and a line.
#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "page/data_files.hpp"
#include "page/groups.hpp"
#include "page/solved_case.hpp"
#include "tribo/onset.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::report {
namespace {

constexpr std::array<std::string_view, 3> contact_stems{"ball_on_flat", "bearing_outer_ring",
                                                        "gear_flank"};
// In the order of ContactShape.
constexpr std::array<std::string_view, 3> shape_words{"circle", "ellipse", "line"};
constexpr double told_speed = 1;  // m/s, at which the page tells films

struct SolvedContact {
  std::string_view stem;
  std::string file;  // as provenance names it
  std::string text;  // the file's text
  Scene scene;
  MixedContact<double> contact;
  std::vector<Point> curve;
  std::optional<Point> at_least_friction;  // the lowest interior minimum
};

SolvedContact solved_contact(const ReportPlaces& places, std::string_view stem) {
  const std::filesystem::path path = places.reference / "scenes" / fmt::format("{}.toml", stem);
  SceneReading reading = read_scene(path.string(), SceneUse::speeds);
  if (!reading.scene) throw std::runtime_error(reading.errors.front().line());
  const std::string shown = places.shown(path);
  const Scene& scene = *reading.scene;
  const auto span = detail::speed_span(scene.speeds);
  if (!has_friction_inputs(scene))
    throw std::runtime_error(shown + " has not all inputs of friction");
  if (!(span.low <= told_speed && told_speed <= span.high))
    throw std::runtime_error(fmt::format("the speeds of {} leave {} m/s out", shown, told_speed));
  std::ifstream file(path, std::ios::binary);
  const MixedContact<double> contact(scene);
  const Onset<double> least =
      onset(contact, scene, OnsetCriterion::friction_minimum, default_departure);
  return {stem,
          shown,
          {std::istreambuf_iterator<char>(file), {}},
          scene,
          contact,
          closely_spaced_curve(contact, {span.low, span.high}),
          least.exists ? std::optional(contact.solve(least.speed)) : std::nullopt};
}

// NaN becomes null.
Json told_point_json(const Point& point) {
  return {{"speed", point.speed},
          {"film", point.film},
          {"film_parameter", point.film_parameter},
          {"asperity_load_share", point.asperity_load_share},
          {"friction", point.friction}};
}

Json contact_json(const SolvedContact& solved) {
  const HertzContact<double> hertz = solved.contact.hertz();
  const auto numbers = detail::numbers_of<double>(solved.scene);
  const ContactShape shape = solved.scene.bodies.shape();
  const bool is_line = shape == ContactShape::line;
  const auto of_point = [&](double value) { return is_line ? Json(nullptr) : Json(value); };
  return {{"file", solved.file},
          {"shape", shape_words[static_cast<std::size_t>(shape)]},
          {"load", solved.scene.load},
          {"effective_modulus", numbers.effective_modulus},
          {"radius_x", numbers.radius_x},
          {"radius_y", of_point(shape == ContactShape::circle ? numbers.radius_x : numbers.across)},
          {"length", is_line ? Json(solved.scene.bodies.length) : Json(nullptr)},
          {"semi_axis_x", hertz.semi_axis_x},
          {"semi_axis_y", of_point(hertz.semi_axis_y)},
          {"ellipticity", of_point(hertz.semi_axis_y / hertz.semi_axis_x)},
          {"mean_pressure", hertz.mean_pressure},
          {"peak_pressure", hertz.peak_pressure},
          {"approach", of_point(hertz.approach)},
          {"summit_height_sd", solved.contact.summit_height_sd()},
          {"slide_roll_ratio", solved.scene.friction.slide_roll_ratio},
          {"film_law", film_formula_words[static_cast<std::size_t>(solved.scene.closures.film)]},
          {"at_told_speed", told_point_json(solved.contact.solve(told_speed))},
          {"slowest", told_point_json(solved.curve.front())},
          {"fastest", told_point_json(solved.curve.back())},
          {"least_friction",
           solved.at_least_friction ? told_point_json(*solved.at_least_friction) : Json(nullptr)}};
}

}  // namespace

Group contacts_group(const ReportPlaces& places) {
  Group group;
  group.data = {{"told_speed", told_speed}, {"scenes", Json::object()}};
  std::vector<NamedPoint> marks;
  for (const std::string_view stem : contact_stems) {
    const SolvedContact solved = solved_contact(places, stem);
    group.data["scenes"][std::string(stem)] = contact_json(solved);
    group.files.push_back(
        curve_file(fmt::format("data/contact_{}.tsv", stem), solved.file, solved.curve));
    group.files.push_back({fmt::format("data/scenes/{}.toml", stem), solved.text});
    marks.push_back({stem, solved.at_least_friction});
  }
  group.files.push_back(points_file("data/contact_marks.tsv",
                                    "Points to mark: the least friction (friction_minimum)",
                                    "the scenes of the curves contact_*.tsv", marks));
  return group;
}

}  // namespace tribo::report
