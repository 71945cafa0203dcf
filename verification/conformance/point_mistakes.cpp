// SPDX-License-Identifier: Apache-2.0
#include "conformance/point_mistakes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "conformance/function_mistakes.hpp"
#include "conformance/mistake_formulas.hpp"
#include "scene/schema.hpp"
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

// The point of a scene that `change` alters; it returns a factor that undoes the change in the
// number of summits.
Mistake changed(const std::string& name, const std::string& text,
                std::function<double(Scene&, const json& inputs)> change) {
  return {"operating_point", name, text,
          [change = std::move(change)](const json& inputs, std::string_view field) -> Value {
            std::optional<Scene> scene = scene_of(inputs);
            if (!scene) return std::nullopt;
            const double count = change(*scene, inputs);
            Point point = MixedContact<double>(*scene).solve(scene->speeds[0]);
            point.summit_count *= count;
            return field_of(point, field);
          }};
}

// --- Changes of fields

// The number or word that a scene's JSON has at a dotted path, or the default.
json written_at(const json& inputs, const FieldInfo& field) {
  std::string pointer = "/" + std::string(field.path);
  std::replace(pointer.begin(), pointer.end(), '.', '/');
  const json::json_pointer place(pointer);
  if (inputs.contains(place)) return inputs.at(place);
  return field.choices.empty() ? json::parse(field.default_text, nullptr, false)
                               : json(field.default_text);
}

double number_of(const FieldInfo& field, const json& written) {
  if (field.choices.empty()) return written.get<double>();
  const auto found =
      std::find(field.choices.begin(), field.choices.end(), written.get<std::string>());
  if (found == field.choices.end())
    throw std::runtime_error(fmt::format("{}: {} is not allowed", field.path, written.dump()));
  return static_cast<double>(found - field.choices.begin());
}

// A field of a scene that can be changed.
struct Field {
  const FieldInfo* info;
  scene_detail::Store store;
};
Field field_at(const std::string& path) {
  const std::optional<std::size_t> place = scene_detail::find_field(path);
  if (!place || scene_detail::store_of(*place) == nullptr)
    throw std::runtime_error(fmt::format("a scene has no number or word {}", path));
  return {&scene_fields()[*place], scene_detail::store_of(*place)};
}

Mistake with_fields(const MistakeEntry& entry) {
  struct FieldChange {
    Field field;
    NumberChange change;
    std::optional<double> is;
  };
  std::vector<FieldChange> changes;
  for (const auto& [path, change] : entry.scene) {
    FieldChange one{field_at(path), change, {}};
    if (!change.by.empty() || !change.over.empty())
      throw std::runtime_error(path + ": by and over are for results");
    if (change.is) one.is = number_of(*one.field.info, *change.is);
    changes.push_back(std::move(one));
  }
  return changed(entry.name, entry.text, [changes](Scene& scene, const json& inputs) {
    for (const FieldChange& one : changes)
      one.field.store(scene, one.is ? *one.is
                                    : one.change.of(number_of(
                                          *one.field.info, written_at(inputs, *one.field.info))));
    return 1.0;
  });
}

std::vector<Mistake> swaps_of(const MistakeEntry& entry) {
  std::vector<Mistake> all;
  const Field field = field_at(entry.swapped);
  const auto& words = field.info->choices;
  for (const std::string_view asked : words)
    for (const std::string_view given : words)
      if (asked != given)
        all.push_back(changed(with_words(entry.name, given, asked),
                              with_words(entry.text, given, asked),
                              [=](Scene& scene, const json& inputs) {
                                if (written_at(inputs, *field.info) == json(asked))
                                  field.store(scene, number_of(*field.info, json(given)));
                                return 1.0;
                              }));
  return all;
}

// --- Changes of a part alone

double right_film(const Scene& s) {
  return hamrock_dowson_central(s.speeds[0], s.lubricant.viscosity, s.lubricant.pressure_viscosity,
                                s.load, s.bodies.effective_modulus, s.bodies.reduced_radius,
                                s.bodies.ellipticity);
}

// Multiplies the film formula by a factor: changes the speed, but keeps the sliding speed and the
// supply as they are.
void scale_film(Scene& scene, double factor) {
  const double by = decimal_power(factor, inverse(hamrock_dowson_central_law.speed_exponent));
  for (double& speed : scene.speeds.list) speed *= by;
  scene.friction.slide_roll_ratio /= by;
  if (scene.supply.kind == SupplyKind::inlet_flow) scene.supply.value *= by;
}

// A_nom times a factor, by R, with the film formula left as it is.
void scale_area(Scene& scene, double factor) {
  const double right = right_film(scene);
  scene.bodies.reduced_radius *= std::pow(factor, 1.5);
  scale_film(scene, right / right_film(scene));
}

// K times a factor, the real area left as it is: √(σ_s/β) grows at constant nβ; the number of
// summits grows by the factor's square. Returns what undoes that.
double scale_stiffness(Scene& scene, double factor) {
  scene.surface.summit_density *= factor * factor;
  scene.surface.summit_radius /= factor * factor;
  return 1 / (factor * factor);
}

bool is_gt(const Scene& scene) { return scene.closures.asperity == AsperityModel::greenwood_tripp; }

double stiffness_of_greenwood_williamson(Scene& s, const json&) {
  if (!is_gt(s)) return 1;
  const double roughness =
      s.surface.summit_density * s.surface.summit_radius * s.surface.summit_height_sd;
  return scale_stiffness(s, 4.0 / 3 / (16 * std::sqrt(2) / 15 * std::numbers::pi * roughness));
}

Mistake with_friction(const MistakeEntry& entry, FrictionFormula wrong) {
  return {"operating_point", entry.name, entry.text,
          [wrong](const json& inputs, std::string_view field) -> Value {
            const std::optional<Scene> scene = scene_of(inputs);
            if (!scene) return std::nullopt;
            const Point point = MixedContact<double>(*scene).solve(scene->speeds[0]);
            if (field != "friction" || point.friction_undefined) return field_of(point, field);
            return wrong(*scene, point,
                         *scene->friction.boundary_coefficient * point.asperity_load_share);
          }};
}

Mistake with_film(const FunctionMistake& wrong) {
  return changed(wrong.name, wrong.text + ", in the film formula",
                 [results = wrong.results](Scene& s, const json&) {
                   const catalogue::Arguments arguments{s.speeds[0],
                                                        s.lubricant.viscosity,
                                                        s.lubricant.pressure_viscosity,
                                                        s.load,
                                                        s.bodies.effective_modulus,
                                                        s.bodies.reduced_radius,
                                                        s.bodies.ellipticity};
                   if (const auto film = results(arguments))
                     scale_film(s, (*film)[0] / right_film(s));
                   return 1.0;
                 });
}

Mistake with_inlet(const FunctionMistake& wrong) {
  return {"operating_point", wrong.name, wrong.text,
          [results = wrong.results](const json& inputs, std::string_view field) -> Value {
            const std::optional<Scene> scene = scene_of(inputs);
            if (!scene || scene->supply.kind == SupplyKind::flooded) return std::nullopt;
            const MixedContact<double> contact(*scene);
            const FloodedFilm<double> flooded = contact.flooded(scene->speeds[0]);
            InletState<double> inlet = contact.inlet(flooded);
            const auto other = results({static_cast<double>(contact.closure()),
                                        inlet.flooded_over_inlet, contact.damiens_exponent()});
            if (!other) return std::nullopt;
            inlet.film_ratio = (*other)[0];
            inlet.collapsed = inlet.film_ratio == 0;
            const Point point = contact.complete(flooded, inlet, OutputSet::all());
            // Near a floor complete() takes the shares from the right closure, not from `other`.
            const bool is_of_shares = field != "film" && field != "film_parameter" &&
                                      field != "film_flooded" && field != "separation";
            if (is_of_shares && contact.sharing().has_floor()) return std::nullopt;
            return field_of(point, field);
          }};
}

// For the outputs film and film_flooded alone.
Mistake with_sharing(const FunctionMistake& wrong) {
  return {"operating_point", wrong.name, wrong.text,
          [results = wrong.results](const json& inputs, std::string_view field) -> Value {
            if (field != "film_flooded" && field != "film") return std::nullopt;
            const std::optional<Scene> scene = scene_of(inputs);
            if (!scene) return std::nullopt;
            const MixedContact<double> contact(*scene);
            const double speed = scene->speeds[0];
            const auto lambda =
                results({static_cast<double>(scene->closures.asperity),
                         contact.flooded_film_parameter(speed), contact.sharing().stiffness(),
                         contact.sharing().offset()});
            if (!lambda) return std::nullopt;
            const FloodedFilm<double> flooded{speed, {(*lambda)[0], 0, 1, 0}};
            const double film = (*lambda)[0] * scene->surface.summit_height_sd;
            return field == "film" ? film * contact.inlet(flooded).film_ratio : film;
          }};
}

}  // namespace

std::vector<Mistake> point_mistakes_of(const MistakeEntry& entry) {
  if (!entry.swapped.empty()) return swaps_of(entry);
  if (entry.area)
    return {changed(entry.name, entry.text, [by = *entry.area](Scene& s, const json&) {
      scale_area(s, by);
      return 1.0;
    })};
  if (!entry.stiffness.empty() && entry.stiffness.size() != 2)
    throw std::runtime_error("stiffness: two numbers, for each asperity model");
  if (!entry.stiffness.empty())
    return {changed(entry.name, entry.text, [by = entry.stiffness](Scene& s, const json&) {
      return scale_stiffness(s, is_gt(s) ? by[0] : by[1]);
    })};
  if (entry.formula == "stiffness_of_greenwood_williamson")
    return {changed(entry.name, entry.text, stiffness_of_greenwood_williamson)};
  if (!entry.formula.empty()) {
    const FrictionFormula wrong = find_friction_formula(entry.formula);
    if (wrong == nullptr || !entry.numbers.empty())
      throw std::runtime_error(
          fmt::format("no formula {} of {} numbers", entry.formula, entry.numbers.size()));
    return {with_friction(entry, wrong)};
  }
  return {with_fields(entry)};
}

std::optional<Mistake> for_points(const FunctionMistake& mistake) {
  if (mistake.function->name == "hamrock_dowson_central") return with_film(mistake);
  if (mistake.function->name == "starvation_ratio") return with_inlet(mistake);
  if (mistake.function->name == "load_sharing") return with_sharing(mistake);
  return std::nullopt;
}

}  // namespace tribo::conformance
