// SPDX-License-Identifier: Apache-2.0
#include "conformance/point_mistake.hpp"

#include <utility>

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

}  // namespace

Mistake changed_with_count(std::string name, std::string text,
                           std::function<double(Scene&)> change) {
  return {"operating_point", std::move(name), std::move(text),
          [change = std::move(change)](const json& inputs, std::string_view field) -> Value {
            std::optional<Scene> scene = scene_of(inputs);
            if (!scene) return std::nullopt;
            const double count = change(*scene);
            Point point = MixedContact<double>(*scene).solve(scene->speeds[0]);
            point.summit_count *= count;
            return field_of(point, field);
          }};
}

Mistake changed(std::string name, std::string text, std::function<void(Scene&)> change) {
  return changed_with_count(std::move(name), std::move(text),
                            [change = std::move(change)](Scene& s) {
                              change(s);
                              return 1.0;
                            });
}

Mistake with_inlet(const WrongInlet& wrong) {
  return {"operating_point", wrong.name, wrong.text,
          [ratio = wrong.ratio](const json& inputs, std::string_view field) -> Value {
            const std::optional<Scene> scene = scene_of(inputs);
            if (!scene || scene->supply.kind == SupplyKind::flooded) return std::nullopt;
            const MixedContact<double> contact(*scene);
            const FloodedFilm<double> flooded = contact.flooded(scene->speeds[0]);
            InletState<double> inlet = contact.inlet(flooded);
            const Value other =
                ratio(contact.closure(), inlet.flooded_over_inlet, contact.damiens_exponent());
            if (!other) return std::nullopt;
            inlet.film_ratio = *other;
            inlet.collapsed = *other == 0;
            const Point point = contact.complete(flooded, inlet, OutputSet::all());
            // Near a floor complete() takes the shares from the right closure, not from `other`.
            const bool is_of_shares = field != "film" && field != "film_parameter" &&
                                      field != "film_flooded" && field != "separation";
            if (is_of_shares && contact.sharing().has_floor()) return std::nullopt;
            return field_of(point, field);
          }};
}

Mistake with_sharing(const WrongSharing& wrong) {
  return {"operating_point", wrong.name, wrong.text,
          [film = wrong.film_parameter](const json& inputs, std::string_view field) -> Value {
            if (field != "film_flooded" && field != "film") return std::nullopt;
            const std::optional<Scene> scene = scene_of(inputs);
            if (!scene) return std::nullopt;
            const MixedContact<double> contact(*scene);
            const double speed = scene->speeds[0];
            const Value lambda = film({scene->closures.asperity == AsperityModel::greenwood_tripp,
                                       contact.flooded_film_parameter(speed),
                                       contact.sharing().stiffness(), contact.sharing().offset()});
            if (!lambda) return std::nullopt;
            const FloodedFilm<double> flooded{speed, {*lambda, 0, 1, 0}};
            if (field == "film_flooded") return *lambda * scene->surface.summit_height_sd;
            return *lambda * contact.inlet(flooded).film_ratio * scene->surface.summit_height_sd;
          }};
}

Mistake with_friction(std::string name, std::string text, WrongFriction wrong) {
  return {"operating_point", std::move(name), std::move(text),
          [wrong = std::move(wrong)](const json& inputs, std::string_view field) -> Value {
            const std::optional<Scene> scene = scene_of(inputs);
            if (!scene) return std::nullopt;
            const Point point = MixedContact<double>(*scene).solve(scene->speeds[0]);
            if (field != "friction" || point.friction_undefined) return field_of(point, field);
            return wrong(*scene, point,
                         *scene->friction.boundary_coefficient * point.asperity_load_share);
          }};
}

}  // namespace tribo::conformance
