// SPDX-License-Identifier: Apache-2.0
#include "conformance/point_mistakes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "conformance/function_mistakes.hpp"
#include "scene/schema.hpp"
#include "tribo/mixed_contact.hpp"

namespace tribo::conformance {
namespace {

using nlohmann::json;

// A point whose scene `change` alters.
Mistake changed(const std::string& name, const std::string& text, std::vector<std::string> touches,
                std::function<void(Question&)> change) {
  return {.function = "operating_point",
          .name = name,
          .text = text,
          .touches = std::move(touches),
          .applies = {},
          .before =
              [change = std::move(change)](Question& question) {
                if (question.scene) change(question);
              },
          .instead = {},
          .after = {}};
}

// A point of which another formula gives a part; it says nothing where that gives nothing.
Mistake with_formula(const std::string& name, const std::string& text,
                     std::function<std::optional<Numbers>(const Question&)> instead) {
  return {.function = "operating_point",
          .name = name,
          .text = text,
          .touches = {"formula"},
          .applies = {},
          .before = {},
          .instead = [instead =
                          std::move(instead)](const Question& question) -> std::optional<Numbers> {
            return question.scene ? instead(question) : std::nullopt;
          },
          .after = {}};
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
  std::vector<std::string> touches;
  for (const auto& [path, change] : entry.scene) {
    FieldChange one{field_at(path), change, {}};
    if (!change.by.empty() || !change.over.empty())
      throw std::runtime_error(path + ": by and over are for results");
    if (change.is) one.is = number_of(*one.field.info, *change.is);
    changes.push_back(std::move(one));
    touches.push_back(path);
  }
  return changed(entry.name, entry.text, std::move(touches), [changes](Question& question) {
    for (const FieldChange& one : changes)
      one.field.store(
          *question.scene,
          one.is ? *one.is
                 : one.change.of(number_of(*one.field.info,
                                           written_at(question.asked->inputs, *one.field.info))));
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
                              with_words(entry.text, given, asked), {entry.swapped},
                              [=](Question& question) {
                                if (written_at(question.asked->inputs, *field.info) == json(asked))
                                  field.store(*question.scene, number_of(*field.info, json(given)));
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

void take_stiffness_of_greenwood_williamson(Question& question) {
  Scene& s = *question.scene;
  if (!is_gt(s)) return;
  const double roughness =
      s.surface.summit_density * s.surface.summit_radius * s.surface.summit_height_sd;
  question.summit_count_times *=
      scale_stiffness(s, 4.0 / 3 / (16 * std::sqrt(2) / 15 * std::numbers::pi * roughness));
}

constexpr std::pair<std::string_view, double FrictionReading::*> friction_numbers[] = {
    {"asperities", &FrictionReading::asperities},
    {"film_boundary", &FrictionReading::film_boundary},
    {"whole_boundary", &FrictionReading::whole_boundary},
    {"film", &FrictionReading::film},
    {"contact_area", &FrictionReading::contact_area},
    {"roelands_pressure", &FrictionReading::roelands_pressure},
    {"roelands_logarithm", &FrictionReading::roelands_logarithm},
    {"limiting_by_minimum", &FrictionReading::limiting_by_minimum}};

// The function's results with the mistake, for arguments that a point has.
std::optional<double> value_with(const Mistake& wrong, const catalogue::Arguments& arguments) {
  const Mistake* const one = &wrong;
  const std::optional<Numbers> numbers =
      numbers_with({&one, 1}, {nullptr, catalogue::find(wrong.function), arguments});
  return numbers && std::isfinite((*numbers)[0]) ? std::optional((*numbers)[0]) : std::nullopt;
}

Mistake with_film(const Mistake& wrong) {
  std::vector<std::string> touches;
  for (const std::string& one : wrong.touches) touches.push_back("film " + one);
  return changed(wrong.name, wrong.text + ", in the film formula", std::move(touches),
                 [wrong](Question& question) {
                   Scene& s = *question.scene;
                   const auto film = value_with(
                       wrong,
                       {s.speeds[0], s.lubricant.viscosity, s.lubricant.pressure_viscosity, s.load,
                        s.bodies.effective_modulus, s.bodies.reduced_radius, s.bodies.ellipticity});
                   if (film) scale_film(s, *film / right_film(s));
                 });
}

Mistake with_inlet(const Mistake& wrong) {
  return with_formula(
      wrong.name, wrong.text, [wrong](const Question& question) -> std::optional<Numbers> {
        const Scene& scene = *question.scene;
        if (scene.supply.kind == SupplyKind::flooded) return std::nullopt;
        const MixedContact<double> contact(scene);
        const FloodedFilm<double> flooded = contact.flooded(scene.speeds[0]);
        InletState<double> inlet = contact.inlet(flooded);
        const auto ratio =
            value_with(wrong, {static_cast<double>(contact.closure()), inlet.flooded_over_inlet,
                               contact.damiens_exponent()});
        if (!ratio) return std::nullopt;
        inlet.film_ratio = *ratio;
        inlet.collapsed = inlet.film_ratio == 0;
        Numbers numbers = numbers_of(contact.complete(flooded, inlet, OutputSet::all()), question);
        // Near a floor complete() takes the shares from the right closure, not from `wrong`.
        if (contact.sharing().has_floor())
          std::fill(numbers.begin() + static_cast<int>(Output::asperity_load_share), numbers.end(),
                    unsaid);
        return numbers;
      });
}

// Of a starved point, the films alone.
Mistake with_sharing(const Mistake& wrong) {
  return with_formula(
      wrong.name, wrong.text, [wrong](const Question& question) -> std::optional<Numbers> {
        const Scene& scene = *question.scene;
        const MixedContact<double> contact(scene);
        const double speed = scene.speeds[0];
        const auto lambda =
            value_with(wrong, {static_cast<double>(scene.closures.asperity),
                               contact.flooded_film_parameter(speed), contact.sharing().stiffness(),
                               contact.sharing().offset()});
        if (!lambda) return std::nullopt;
        // The film is h₀ (1 − A)^−e, whatever gave A.
        const double fluid = std::pow(contact.flooded_film_parameter(speed) / *lambda,
                                      1 / contact.film().sharing_power.value);
        const FloodedFilm<double> flooded{speed, {*lambda, 1 - fluid, fluid, 0}};
        const InletState<double> inlet = contact.inlet(flooded);
        Numbers numbers = numbers_of(contact.complete(flooded, inlet, OutputSet::all()), question);
        if (scene.supply.kind != SupplyKind::flooded || *lambda < contact.sharing().floor())
          std::fill(numbers.begin() + static_cast<int>(Output::separation), numbers.end(), unsaid);
        return numbers;
      });
}

}  // namespace

std::vector<Mistake> point_mistakes_of(const MistakeEntry& entry) {
  if (!entry.swapped.empty()) return swaps_of(entry);
  if (entry.area)
    return {changed(entry.name, entry.text, {"area"},
                    [by = *entry.area](Question& question) { scale_area(*question.scene, by); })};
  if (!entry.stiffness.empty() && entry.stiffness.size() != 2)
    throw std::runtime_error("stiffness: two numbers, for each asperity model");
  if (!entry.stiffness.empty())
    return {changed(entry.name, entry.text, {}, [by = entry.stiffness](Question& question) {
      Scene& scene = *question.scene;
      question.summit_count_times *= scale_stiffness(scene, is_gt(scene) ? by[0] : by[1]);
    })};
  if (entry.formula == "stiffness_of_greenwood_williamson")
    return {changed(entry.name, entry.text, {"stiffness"}, take_stiffness_of_greenwood_williamson)};
  if (!entry.formula.empty())
    throw std::runtime_error(
        fmt::format("no formula {} of {} numbers", entry.formula, entry.numbers.size()));
  if (!entry.friction.empty()) {
    Mistake mistake = changed(entry.name, entry.text, {}, [](Question&) {});
    add_reading<FrictionReading>("friction", &Question::friction, friction_numbers, entry.friction,
                                 mistake);
    return {std::move(mistake)};
  }
  return {with_fields(entry)};
}

std::optional<Mistake> for_points(const Mistake& mistake) {
  if (mistake.function == "hamrock_dowson_central") return with_film(mistake);
  if (mistake.function == "starvation_ratio") return with_inlet(mistake);
  if (mistake.function == "load_sharing") return with_sharing(mistake);
  return std::nullopt;
}

}  // namespace tribo::conformance
