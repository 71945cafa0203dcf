// SPDX-License-Identifier: Apache-2.0
// Checks of the scene readers on any text. The ranges are copied from model/README.md, section 1: a
// check by the reader's own table would prove nothing.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "protocol/ordinary_scene.hpp"
#include "stress/fuzz/checks.hpp"
#include "tribo/film_thickness.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::fuzz {
namespace {

using Json = nlohmann::ordered_json;
using Parse = SceneReading (*)(std::string_view, std::string_view, SceneUse,
                               std::span<const std::string_view>);

constexpr std::string_view source = "fuzz";

// --- Two readings of a scene, compared in everything.

// All numbers and words, without the flags that say which of them the text gave: a scene that is
// written again gives all of them.
auto values_of(const Scene& scene) {
  const auto& [id, load, speeds, outputs, surface, bodies, lubricant, supply, friction, closures,
               accepted] = scene;
  const auto& [list, from, to, count, spacing] = speeds;
  const auto& [density, radius, height_sd, offset, planes, gives_planes, moments, rms, average,
               has_alike_faces] = surface;
  const auto& [modulus, reduced_radius, ellipticity, radius_x, radius_y, length, both] = bodies;
  const auto of_body = [](const Body& body) {
    return std::tuple(body.modulus, body.poisson_ratio, body.radius_x, body.radius_y);
  };
  const auto& [viscosity, pressure_viscosity, eyring_stress, oil, thermal, conductivity,
               temperature_coefficient] = lubricant;
  const auto& [first, second] = oil.viscosities;
  const auto& [boundary_coefficient, slide_roll_ratio, gives_sliding, fluid, law] = friction;
  const auto& [asperity, starvation, gives_starvation, damiens_exponent, film] = closures;
  return std::tuple_cat(
      std::tuple(id, load, list, from, to, count, spacing, density, radius, height_sd, offset),
      std::tuple(moments.m0, moments.m2, moments.m4, rms, average),
      std::tuple(planes, modulus, reduced_radius, ellipticity, viscosity, pressure_viscosity),
      std::tuple(eyring_stress, supply.kind, supply.value, boundary_coefficient, slide_roll_ratio),
      std::tuple(fluid, law, asperity, starvation, damiens_exponent, film, radius_x, radius_y,
                 length),
      of_body(both[0]), of_body(both[1]),
      std::tuple(oil.iso_vg, oil.viscosity_index, oil.density, oil.temperature, thermal,
                 conductivity, temperature_coefficient),
      std::tuple(first.temperature, first.viscosity, second.temperature, second.viscosity));
}

bool same(const Scene& left, const Scene& right) {
  return values_of(left) == values_of(right) && left.outputs == right.outputs &&
         left.accepted == right.accepted;
}

bool same_lines(const std::vector<InputProblem>& left, const std::vector<InputProblem>& right) {
  return std::equal(
      left.begin(), left.end(), right.begin(), right.end(),
      [](const InputProblem& a, const InputProblem& b) { return a.line() == b.line(); });
}

bool same(const SceneReading& left, const SceneReading& right) {
  return left.id == right.id && same_lines(left.errors, right.errors) &&
         same_lines(left.warnings, right.warnings) &&
         left.scene.has_value() == right.scene.has_value() &&
         (!left.scene || same(*left.scene, *right.scene));
}

// --- Messages.

bool is_one_line(std::string_view text) {
  return std::none_of(text.begin(), text.end(), [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return code < 0x20 || code == 0x7F;
  });
}

bool is_utf8(const std::string& text) {
  try {
    return !Json(text).dump().empty();
  } catch (const Json::exception&) {
    return false;
  }
}

void check_problem(const InputProblem& problem, std::string_view text) {
  const std::string line = problem.line();
  require(problem.source == source, "a problem names its source", line);
  require(!problem.message().empty(), "a problem has a message", line);
  require(is_one_line(line), "a problem is one line", line);
  require(is_utf8(line), "a problem is UTF-8", line);
  require(line.size() < 4000, "a problem is short", line);
  require((problem.row == 0) == (problem.column == 0), "a place has a row and a column", line);
  const auto rows = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
  require(problem.row <= rows, "a place is in the text", line);
  require(problem.column <= text.size() + 1, "a place is in its row", line);
}

// --- Scenes.

bool is_positive(double number) { return std::isfinite(number) && number > 0; }
bool is_not_negative(double number) { return std::isfinite(number) && !std::signbit(number); }

template <class Enum>
bool is_among(Enum value, Enum last) {
  return value <= last;
}

void check_numbers(const Scene& scene) {
  const auto& [id, load, speeds, outputs, surface, bodies, lubricant, supply, friction, closures,
               accepted] = scene;
  require(is_positive(load), "load > 0", id);
  if (!surface.is_smooth()) {
    require(is_positive(surface.summit_density), "summit_density > 0", id);
    require(is_positive(surface.summit_radius), "summit_radius > 0", id);
    require(is_positive(surface.summit_height_sd), "summit_height_sd > 0", id);
  }
  require(is_not_negative(surface.summit_plane_offset), "summit_plane_offset ≥ 0", id);
  require(surface.offset_planes >= 0 && surface.offset_planes <= 2, "offset_planes 0 to 2", id);
  require(is_positive(bodies.effective_modulus), "effective_modulus > 0", id);
  const ContactShape shape = bodies.shape();
  require(is_positive(shape == ContactShape::circle ? bodies.reduced_radius : bodies.radius_x),
          "R or R_x > 0", id);
  require(shape != ContactShape::ellipse || is_positive(bodies.radius_y), "R_y > 0", id);
  require(shape != ContactShape::line || is_positive(bodies.length), "L > 0", id);
  require(film_law(scene).is_of_lines == (shape == ContactShape::line),
          "the film law is of the contact's shape", id);
  require(is_positive(bodies.ellipticity), "ellipticity > 0", id);
  require(is_positive(lubricant.viscosity), "viscosity > 0", id);
  const bool needs_rise = !film_law(scene).takes_constant_viscosity();
  require(needs_rise ? is_positive(lubricant.pressure_viscosity)
                     : is_not_negative(lubricant.pressure_viscosity),
          "pressure_viscosity > 0, or 0 where the law does without", id);
  require(is_positive(lubricant.eyring_stress.value_or(1)), "eyring_stress > 0", id);
  require(is_not_negative(friction.boundary_coefficient.value_or(0)), "boundary_coefficient ≥ 0",
          id);
  require(is_not_negative(friction.slide_roll_ratio), "slide_roll_ratio ≥ 0", id);
  require(is_positive(closures.damiens_exponent), "damiens_exponent > 0", id);
  require(supply.kind == SupplyKind::flooded ? supply.value == 0 : is_positive(supply.value),
          "a supply > 0, or none", id);
}

void check_words(const Scene& scene) {
  require(is_among(scene.friction.fluid, FluidShear::limiting), "fluid is known", scene.id);
  require(is_among(scene.friction.viscosity, ViscosityLaw::roelands), "viscosity is known",
          scene.id);
  require(is_among(scene.closures.asperity, AsperityModel::greenwood_williamson),
          "asperity is known", scene.id);
  require(is_among(scene.closures.starvation, StarvationClosure::damiens), "starvation is known",
          scene.id);
  require(static_cast<std::size_t>(scene.closures.film) < named_film_laws.size(), "film is known",
          scene.id);
  require(is_among(scene.supply.kind, SupplyKind::inlet_flow), "supply is known", scene.id);
  require(is_among(scene.speeds.spacing, Spacing::lin), "spacing is known", scene.id);
}

void check_speeds(const Speeds& speeds, SceneUse use) {
  if (use == SceneUse::one_speed) require(speeds.list.size() == 1, "one speed");
  if (use == SceneUse::speeds) require(!speeds.empty(), "a speed");
  for (const double speed : speeds.list) require(is_positive(speed), "a speed > 0");
  if (!speeds.list.empty() || speeds.empty()) return;
  require(is_positive(speeds.from) && speeds.from < speeds.to && std::isfinite(speeds.to),
          "0 < speed.from < speed.to");
  require(speeds.count >= 2 && speeds.count <= 10'000'000, "speed.count 2 to 10⁷");
  require(speeds[0] == speeds.from && speeds[speeds.count - 1] == speeds.to,
          "a range starts and ends where it says");
  for (std::size_t part = 1; part < 16; ++part) {
    const double speed = speeds[part * (speeds.count - 1) / 16];
    require(speed >= speeds.from * (1 - 1e-12) && speed / (1 + 1e-12) <= speeds.to,
            "a speed within its range", std::to_string(speed));
  }
}

void check_rules(const Scene& scene) {
  require(!scene.outputs.empty(), "an output", scene.id);
  if (scene.surface.is_smooth())
    require(!scene.outputs.contains(Output::film_parameter) &&
                scene.supply.kind != SupplyKind::inlet_film_ratio,
            "smooth bodies have no ratio to their roughness", scene.id);
  if (scene.outputs.contains(Output::friction))
    require(has_friction_inputs(scene), "friction has its inputs", scene.id);
  if (scene.outputs.contains(Output::lambda_ratio))
    require(scene.surface.rms_roughness > 0, "lambda_ratio has its roughness", scene.id);
  if (scene.friction.viscosity == ViscosityLaw::roelands)
    require(scene.lubricant.viscosity > 6.315e-5, "Roelands' viscosity is thick enough", scene.id);
}

// --- A scene written again.

std::string word_of(std::string_view path, int place) {
  for (const FieldInfo& field : scene_fields())
    if (field.path == path) return std::string(field.choices[static_cast<std::size_t>(place)]);
  return {};
}

Json speeds_as_json(const Speeds& speeds) {
  if (!speeds.list.empty()) return speeds.list;
  return {{"from", speeds.from},
          {"to", speeds.to},
          {"count", speeds.count},
          {"spacing", word_of("speed.spacing", static_cast<int>(speeds.spacing))}};
}

// The bodies as they were given, without the numbers that follow from two bodies. JSON has no ∞, so
// 1e308 stands for a flat face.
Json bodies_as_json(const Bodies& bodies) {
  const auto& [first, second] = bodies.bodies;
  Json json;
  if (first.modulus > 0)
    json = {{"first_modulus", first.modulus},
            {"first_poisson_ratio", first.poisson_ratio},
            {"second_modulus", second.modulus},
            {"second_poisson_ratio", second.poisson_ratio}};
  else
    json["effective_modulus"] = bodies.effective_modulus;
  const auto face = [&](const std::string& name, double radius) {
    json[name] = std::isinf(radius) ? std::copysign(1e308, radius) : radius;
  };
  const ContactShape shape = bodies.shape();
  if (first.radius_x != 0) {
    face("first_radius_x", first.radius_x);
    face("second_radius_x", second.radius_x);
  }
  if (first.radius_y != 0) {
    face("first_radius_y", first.radius_y);
    face("second_radius_y", second.radius_y);
  }
  if (shape == ContactShape::circle) {
    json["reduced_radius"] = bodies.reduced_radius;
    json["ellipticity"] = bodies.ellipticity;
    return json;
  }
  if (first.radius_x == 0) json["radius_x"] = bodies.radius_x;
  if (shape == ContactShape::line)
    json["length"] = bodies.length;
  else if (first.radius_y == 0)
    json["radius_y"] = bodies.radius_y;
  return json;
}

// The oil as it was given, without the viscosity that follows from it.
Json oil_as_json(const Lubricant& lubricant) {
  const Oil& oil = lubricant.oil;
  if (!oil.is_given()) return {{"viscosity", lubricant.viscosity}};
  Json json{{"density", oil.density}, {"temperature", oil.temperature}};
  if (oil.iso_vg > 0) {
    json["iso_vg"] = oil.iso_vg;
    json["viscosity_index"] = oil.viscosity_index;
  } else {
    for (const auto& [temperature, viscosity] : oil.viscosities)
      json["kinematic_viscosity"].push_back(Json::array({temperature, viscosity}));
  }
  return json;
}

// Every field of a scene, with defaults. The outputs are those that were asked for or inferred.
Json as_json(const Scene& scene) {
  const auto& [id, load, speeds, outputs, surface, bodies, lubricant, supply, friction, closures,
               accepted] = scene;
  Json json{{"id", id}, {"load", load}, {"outputs", Json::array()}};
  if (speeds.list.size() == 1)
    json["speed"] = speeds.list[0];
  else if (!speeds.empty())
    json["speed"] = speeds_as_json(speeds);
  for (const OutputInfo& output : output_infos)
    if (outputs.contains(output.output)) json["outputs"].push_back(output.name);
  if (surface.has_moments())
    json["surface"] = {{"m0", surface.moments.m0},
                       {"m2", surface.moments.m2},
                       {"m4", surface.moments.m4},
                       {"offset_planes", surface.offset_planes}};
  else if (!surface.is_smooth())
    json["surface"] = {{"summit_density", surface.summit_density},
                       {"summit_radius", surface.summit_radius},
                       {"summit_height_sd", surface.summit_height_sd},
                       {"summit_plane_offset", surface.summit_plane_offset},
                       {"offset_planes", surface.offset_planes}};
  if (surface.average_roughness > 0)
    json["surface"]["average_roughness"] = surface.average_roughness;
  else if (surface.rms_roughness > 0 && !surface.has_moments())
    json["surface"]["rms_roughness"] = surface.rms_roughness;
  json["bodies"] = bodies_as_json(bodies);
  json["lubricant"] = oil_as_json(lubricant);
  json["lubricant"]["pressure_viscosity"] = lubricant.pressure_viscosity;
  if (lubricant.conductivity > 0) {
    json["lubricant"]["thermal"] =
        word_of("lubricant.thermal", static_cast<int>(lubricant.thermal));
    json["lubricant"]["conductivity"] = lubricant.conductivity;
    json["lubricant"]["temperature_coefficient"] = lubricant.temperature_coefficient;
  }
  if (lubricant.eyring_stress) json["lubricant"]["eyring_stress"] = *lubricant.eyring_stress;
  if (supply.kind != SupplyKind::flooded)
    json["supply"][std::string(supply_words[static_cast<std::size_t>(supply.kind)])] = supply.value;
  json["friction"] = {
      {"slide_roll_ratio", friction.slide_roll_ratio},
      {"fluid", word_of("friction.fluid", static_cast<int>(friction.fluid))},
      {"viscosity", word_of("friction.viscosity", static_cast<int>(friction.viscosity))}};
  if (friction.boundary_coefficient)
    json["friction"]["boundary_coefficient"] = *friction.boundary_coefficient;
  json["closures"] = {
      {"asperity", word_of("closures.asperity", static_cast<int>(closures.asperity))},
      {"starvation", word_of("closures.starvation", static_cast<int>(closures.starvation))},
      {"film", word_of("closures.film", static_cast<int>(closures.film))},
      {"damiens_exponent", closures.damiens_exponent}};
  for (const std::string_view word : accepted) json["accept"].push_back(std::string(word));
  return json;
}

// The text as a basic string of TOML, with control signs as \uXXXX.
std::string toml_text(const std::string& text) {
  std::string toml = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20 || code == 0x7F) {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(code));
      toml += escape;
    } else {
      if (c == '"' || c == '\\') toml += '\\';
      toml += c;
    }
  }
  return toml + '"';
}

// Numbers and lists of numbers look alike in JSON and TOML. Tables are written inline.
std::string toml_value(const Json& json) {
  if (json.is_string()) return toml_text(json.get<std::string>());
  if (!json.is_object()) return json.dump();
  std::string table = "{";
  for (const auto& [name, value] : json.items())
    table += (table.size() > 1 ? ", " : " ") + name + " = " + toml_value(value);
  return table + " }";
}

std::string as_toml(const Json& json) {
  std::string toml;
  for (const auto& [name, value] : json.items()) toml += name + " = " + toml_value(value) + '\n';
  return toml;
}

void check_written_again(const Scene& scene) {
  const Json json = as_json(scene);
  for (const auto& [parse, text] : {std::pair{Parse(parse_scene_json), json.dump()},
                                    std::pair{Parse(parse_scene_toml), as_toml(json)}}) {
    const SceneReading again = parse(text, source, SceneUse::onset, {});
    require(again.errors.empty(), "a scene written again is read", text);
    require(same(*again.scene, scene), "a scene written again is the same", text);
  }
}

// --- A reading.

void check_scene(const SceneReading& reading, SceneUse use) {
  const Scene& scene = *reading.scene;
  require(scene.id == reading.id.value_or(""), "the scene has the id of the text", scene.id);
  check_numbers(scene);
  check_words(scene);
  check_speeds(scene.speeds, use);
  check_rules(scene);
}

SceneReading check_reading(Parse parse, std::string_view text, SceneUse use) {
  SceneReading reading = parse(text, source, use, {});
  require(reading.scene.has_value() == reading.errors.empty(), "either a scene or errors");
  require(reading.errors.size() <= 51, "not more errors than anybody reads");
  for (const InputProblem& problem : reading.errors) check_problem(problem, text);
  for (const InputProblem& problem : reading.warnings) check_problem(problem, text);
  if (reading.scene) check_scene(reading, use);
  return reading;
}

void check_read_again(Parse parse, std::string_view text, const SceneReading& reading) {
  const SceneReading again = parse(text, source, SceneUse::onset, {});
  require(same(reading, again), "a second reading gives the same");
}

void check_text(Parse parse, std::string_view text) {
  const SceneReading stream = check_reading(parse, text, SceneUse::one_speed);
  const SceneReading solve = check_reading(parse, text, SceneUse::speeds);
  const SceneReading onset = check_reading(parse, text, SceneUse::onset);
  require(!stream.scene || (solve.scene && same(*stream.scene, *solve.scene)),
          "a scene for stream is one for solve");
  require(!solve.scene || (onset.scene && same(*solve.scene, *onset.scene)),
          "a scene for solve is one for onset");
  check_read_again(parse, text, onset);
  if (onset.scene) check_written_again(*onset.scene);
}

}  // namespace

void check_toml_scene(std::string_view text) { check_text(parse_scene_toml, text); }

void check_json_scene(std::string_view text) {
  check_text(parse_scene_json, text);
  if (parse_scene_json(text, source, SceneUse::onset).scene)
    require(Json::accept(text), "a scene is JSON", text);
}

void check_ordinary_scene(std::string_view line) {
  const std::optional<SceneReading> ordinary = protocol::read_ordinary_scene(line, source);
  if (ordinary)
    require(same(*ordinary, parse_scene_json(line, source, SceneUse::one_speed)),
            "an ordinary line is read as any other", line);
}

}  // namespace tribo::fuzz
