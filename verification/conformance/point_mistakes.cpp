// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "catalogue/ways_to_ask.hpp"
#include "conformance/follow.hpp"
#include "conformance/mistake_entry.hpp"
#include "conformance/variable.hpp"
#include "scene/schema.hpp"
#include "tribo/hertz_ellipse.hpp"
#include "tribo/mixed_contact.hpp"

namespace tribo::conformance {
namespace {

using nlohmann::json;

constexpr std::string_view operating_point = operating_point_functions[0];

// A mistake in operating points that misreads the scene: `change` alters it.
Mistake changed(Mistake mistake, std::vector<std::string> touches,
                std::function<void(Question&)> change) {
  mistake.touches = std::move(touches);
  mistake.before = [change = std::move(change)](Question& question) {
    if (question.scene) change(question);
  };
  return mistake;
}
Mistake changed(const MistakeEntry& entry, std::vector<std::string> touches,
                std::function<void(Question&)> change) {
  return changed(titled(entry, operating_point), std::move(touches), std::move(change));
}

// The mistake `wrong` of a function, made inside operating points. `instead` gives their numbers;
// if it gives none, the mistake says nothing of the question.
Mistake with_formula(const Mistake& wrong,
                     std::function<std::optional<Numbers>(const Question&)> instead) {
  return {.function = std::string(operating_point),
          .name = wrong.name,
          .text = wrong.text,
          .follows = wrong.follows,
          .touches = {"formula"},
          .instead = [instead =
                          std::move(instead)](const Question& question) -> std::optional<Numbers> {
            return question.scene ? instead(question) : std::nullopt;
          }};
}

// --- Changes of fields

// The number or word that a scene's JSON has for the field, or the field's default.
json written_at(const json& inputs, const FieldInfo& field) {
  if (!is_left_out(inputs, field.path)) return inputs.at(pointer_to(field.path));
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
  if (!place || scene_detail::store_of(*place) == nullptr ||
      scene_fields()[*place].type == FieldType::speeds)
    throw std::runtime_error(fmt::format("a scene has no number or word {}", path));
  return {&scene_fields()[*place], scene_detail::store_of(*place)};
}

Mistake with_fields(const MistakeEntry& entry) {
  std::vector<std::pair<Field, NumberChange>> changes;
  std::vector<std::string> touches;
  for (const auto& [path, written] : entry.scene) {
    const Field field = field_at(path);
    NumberChange change = written;
    if (!change.by.empty() || !change.over.empty())
      throw std::runtime_error(path + ": by and over are for results");
    if (change.is) change.value = number_of(*field.info, *change.is);
    changes.emplace_back(field, std::move(change));
    touches.push_back(path);
  }
  return changed(entry, std::move(touches), [changes](Question& question) {
    for (const auto& [field, change] : changes) {
      const json written = written_at(question.asked->inputs, *field.info);
      if (written.is_discarded()) continue;  // neither given nor with a default: of another shape
      field.store(*question.scene, change.of(number_of(*field.info, written)));
    }
  });
}

// The words that a field may have beside any other field. Starvation `solved` is left out: it needs
// the film formula `solved`.
std::vector<std::string_view> words_alone(const Field& field) {
  std::vector<std::string_view> words(field.info->choices.begin(), field.info->choices.end());
  std::erase(words, starvation_words[static_cast<std::size_t>(StarvationClosure::solved)]);
  return words;
}

std::vector<Mistake> swaps_of(const MistakeEntry& entry) {
  std::vector<Mistake> all;
  const Field field = field_at(entry.swapped);
  const std::vector<std::string_view> words = words_alone(field);
  for (const std::string_view asked : words)
    for (const std::string_view given : words)
      if (asked != given)
        all.push_back(
            changed(with_words(entry, given, asked), {entry.swapped}, [=](Question& question) {
              if (written_at(question.asked->inputs, *field.info) == json(asked))
                field.store(*question.scene, number_of(*field.info, json(given)));
            }));
  return all;
}

// One mistake for each word that is taken as the field's default in place of the right one.
std::vector<Mistake> defaults_of(const MistakeEntry& entry) {
  std::vector<Mistake> all;
  const Field field = field_at(entry.left_out);
  for (const std::string_view given : words_alone(field))
    if (given != field.info->default_text)
      all.push_back(
          changed(with_words(entry, given, {}), {entry.left_out}, [=](Question& question) {
            if (is_left_out(question.asked->inputs, entry.left_out))
              field.store(*question.scene, number_of(*field.info, json(given)));
          }));
  return all;
}

// --- Changes of a part alone

double right_film(const Scene& s) {
  return MixedContact<double>(s).flooded_film_parameter(s.speeds[0]) * s.surface.summit_height_sd;
}

}  // namespace

void scale_film(Scene& scene, double factor) {
  const double by = decimal_power(factor, inverse(film_law(scene.closures.film).speed_exponent));
  for (double& speed : scene.speeds.list) speed *= by;
  scene.friction.slide_roll_ratio /= by;
  if (scene.supply.kind == SupplyKind::inlet_flow) scene.supply.value *= by;
}

namespace {

// Changes the bodies in Hertz' contact only: the film formula keeps its result.
void change_contact(Scene& scene, const std::function<void(Bodies&)>& change) {
  const double right = right_film(scene);
  change(scene.bodies);
  scale_film(scene, right / right_film(scene));
}

}  // namespace

// Changes the radii: the area goes as R^{2/3}, and for a line as R^{1/2}.
void scale_area(Scene& scene, double factor) {
  change_contact(scene, [&](Bodies& bodies) {
    const bool is_line = bodies.shape() == ContactShape::line;
    for (double* radius : {&bodies.reduced_radius, &bodies.radius_x, &bodies.radius_y})
      *radius *= std::pow(factor, is_line ? 2 : 1.5);
  });
}

namespace {

// Mistakes in the contact of an ellipse.
void take_circle(Question& question) {
  change_contact(*question.scene, [](Bodies& bodies) {
    bodies.ellipticity = ellipse_of_circle(bodies.radius_x, bodies.radius_y).axes_ratio;
    bodies.reduced_radius = bodies.radius_x;
    bodies.radius_x = bodies.radius_y = 0;
  });
}
void exchange_radii(Question& question) {
  std::swap(question.scene->bodies.radius_x, question.scene->bodies.radius_y);
}
constexpr std::pair<std::string_view, void (*)(Question&)> ellipse_changes[] = {
    {"circle_of_radius_x", take_circle}, {"radii_exchanged", exchange_radii}};

}  // namespace

// At constant nβ, √(σ_s/β) grows by the factor, and the number of summits by its square.
double scale_stiffness(Scene& scene, double factor) {
  scene.surface.summit_density *= factor * factor;
  scene.surface.summit_radius /= factor * factor;
  return 1 / (factor * factor);
}

namespace {

bool is_gt(const Scene& scene) { return scene.closures.asperity == AsperityModel::greenwood_tripp; }

void take_stiffness_of_greenwood_williamson(Question& question) {
  Scene& s = *question.scene;
  if (!is_gt(s)) return;
  const double roughness =
      s.surface.summit_density * s.surface.summit_radius * s.surface.summit_height_sd;
  question.summit_count_times *=
      scale_stiffness(s, 4.0 / 3 / (16 * std::sqrt(2) / 15 * std::numbers::pi * roughness));
}

// Each takes two numbers: one for Greenwood and Tripp, one for Greenwood and Williamson.
constexpr std::pair<std::string_view, double Question::*> summit_numbers[] = {
    {"real_area_times", &Question::real_area_times},
    {"summit_count_times", &Question::summit_count_times}};

// Multiplies the nominal area of a line's rough contact by c L^a, at unchanged pressure.
void scale_rough_line(Question& question, double c, double a) {
  const Bodies& bodies = question.scene->bodies;
  if (bodies.shape() != ContactShape::line) return;
  const double factor = c * std::pow(bodies.length, a);
  question.summit_count_times *= factor * scale_stiffness(*question.scene, factor);
}

// Reads an inlet film ratio, which is h_oil/σ_s, as h_oil over the flooded film.
void take_inlet_of_flooded_film(Question& question) {
  Scene& scene = *question.scene;
  if (scene.supply.kind == SupplyKind::inlet_film_ratio)
    scene.supply.value *= MixedContact<double>(scene).solve(scene.speeds[0]).film_flooded /
                          scene.surface.summit_height_sd;
}

constexpr std::pair<std::string_view, double FrictionReading::*> friction_numbers[] = {
    {"film", &FrictionReading::film},
    {"roelands_pressure", &FrictionReading::roelands_pressure},
    {"roelands_logarithm", &FrictionReading::roelands_logarithm},
    {"limiting_by_minimum", &FrictionReading::limiting_by_minimum},
    {"limiting_by_tangent", &FrictionReading::limiting_by_tangent},
    {"eyring_by_line", &FrictionReading::eyring_by_line}};

// The first result of the wrong function at these arguments; empty if there is no finite one.
std::optional<double> value_with(const Mistake& wrong, const catalogue::Arguments& arguments) {
  const Mistake* const one = &wrong;
  const std::optional<Numbers> numbers =
      numbers_with({&one, 1}, {nullptr, catalogue::function_named(wrong.function), arguments});
  return numbers && std::isfinite((*numbers)[0]) ? std::optional((*numbers)[0]) : std::nullopt;
}

Mistake with_inlet(const Mistake& wrong) {
  return with_formula(wrong, [wrong](const Question& question) -> std::optional<Numbers> {
    const Scene& scene = *question.scene;
    if (scene.supply.kind == SupplyKind::flooded) return std::nullopt;
    const MixedContact<double> contact(scene);
    const FloodedFilm<double> flooded = contact.flooded(scene.speeds[0]);
    InletState<double> inlet = contact.inlet(flooded);
    const InletLaw<double> law = contact.inlet_law();
    const auto y = value_with(
        wrong, {static_cast<double>(law.closure), inlet.flooded_over_inlet, law.exponent});
    if (!y) return std::nullopt;
    inlet.film_ratio = *y;
    inlet.collapsed = *y == 0;
    const LoadShares<double>& shares = flooded.shares;
    if (!contact.sharing().has_floor())
      return numbers_of(contact.complete(flooded, inlet, OutputSet::all()), question);
    // Near a floor complete() for double takes 1 − y from the right law. The template takes any.
    const MixedContact<long double> any = contact.in<long double>();
    const FloodedFilm<long double> same{flooded.speed,
                                        {shares.film_parameter, shares.asperity, shares.fluid, 0}};
    const InletState<long double> starved{*y, inlet.flooded_over_inlet, inlet.collapsed};
    const auto point = any.complete(
        same, starved, any.starved_shares(same, starved, 1 - starved.film_ratio), OutputSet::all());
    return numbers_of(detail::in_double(point), question);
  });
}

// λ by load_sharing, whose exponent is that of hamrock_dowson_central; by `wrong` if not null.
std::optional<double> usual_sharing(const Mistake* wrong, const MixedContact<double>& contact,
                                    const Scene& scene) {
  const Question question = sharing_question(contact, scene);
  if (wrong != nullptr) return value_with(*wrong, question.arguments);
  const double lambda = right_numbers(question)[0];
  return std::isfinite(lambda) ? std::optional(lambda) : std::nullopt;
}
constexpr double usual_exponent = hamrock_dowson_central_law.sharing_power.value;

// A mistake of load_sharing inside operating points whose film law has the same exponent.
Mistake with_sharing(const Mistake& wrong) {
  return with_formula(wrong, [wrong](const Question& question) -> std::optional<Numbers> {
    const MixedContact<double> contact(*question.scene);
    if (contact.film().sharing_power.value != usual_exponent) return std::nullopt;
    const auto lambda = usual_sharing(&wrong, contact, *question.scene);
    if (!lambda) return std::nullopt;
    return shared_point(question, contact, *lambda, usual_exponent);
  });
}

// The mistake to take the usual exponent for film laws that have another one.
Mistake with_usual_sharing(const Mistake& titled) {
  return with_formula(titled, [](const Question& question) -> std::optional<Numbers> {
    const MixedContact<double> contact(*question.scene);
    if (contact.film().sharing_power.value == usual_exponent) return std::nullopt;
    const auto lambda = usual_sharing(nullptr, contact, *question.scene);
    if (!lambda) return std::nullopt;
    return shared_point(question, contact, *lambda, usual_exponent);
  });
}

// The index of the result with this name; the number of results if there is none.
std::size_t result_place(const catalogue::Function& function, std::string_view name) {
  const auto found = std::find_if(function.results.begin(), function.results.end(),
                                  [&](const catalogue::Result& one) { return one.name == name; });
  return static_cast<std::size_t>(found - function.results.begin());
}

// The film of an ellipse whose axes have another ratio, over the right film.
double film_of_ratio(const Scene& scene, double axes_ratio) {
  const auto numbers = detail::numbers_of<double>(scene);
  const FilmLaw& law = film_law(scene.closures.film);
  const auto film = [&](double ellipticity) {
    return film_thickness(law, scene.speeds[0], numbers.viscosity, numbers.pressure_viscosity,
                          numbers.load, numbers.effective_modulus, numbers.radius_x, ellipticity);
  };
  return film(axes_ratio) / film(numbers.ellipticity);
}

}  // namespace

Mistake with_contact(const Mistake& wrong) {
  const catalogue::Function* const function = catalogue::function_named(wrong.function);
  Mistake of_points{.function = std::string(operating_point),
                    .name = wrong.name,
                    .text = wrong.text,
                    .touches = {}};
  return changed(std::move(of_points), {"area"}, [wrong, function](Question& question) {
    Scene& scene = *question.scene;
    const Question inner = contact_question(scene);
    if (inner.function != function) return;
    const Mistake* const one = &wrong;
    const std::optional<Numbers> numbers = numbers_with({&one, 1}, inner);
    if (!numbers) return;
    const Numbers right = right_numbers(inner);
    const std::size_t pressure = result_place(*function, "mean_pressure");
    const std::size_t ratio = result_place(*function, "ellipticity");
    const double area = right[pressure] / (*numbers)[pressure];
    const double film = ratio < function->results.size() && (*numbers)[ratio] != right[ratio]
                            ? film_of_ratio(scene, (*numbers)[ratio])
                            : 1;
    if (area > 0 && std::isfinite(area) && area != 1) scale_area(scene, area);
    if (film > 0 && std::isfinite(film) && film != 1) scale_film(scene, film);
  });
}

Mistake with_film(const std::vector<Mistake>& laws) {
  Mistake of_points{.function = std::string(operating_point),
                    .name = laws.front().name,
                    .text = laws.front().text + ", in the film formula",
                    .follows = laws.front().follows,
                    .touches = {}};
  std::vector<std::string> touches;
  for (const std::string& one : laws.front().touches) touches.push_back("film " + one);
  return changed(std::move(of_points), std::move(touches), [laws](Question& question) {
    Scene& scene = *question.scene;
    const auto law = std::find_if(laws.begin(), laws.end(), [&](const Mistake& one) {
      return one.function == film_formula_words[static_cast<std::size_t>(scene.closures.film)];
    });
    if (law == laws.end()) return;
    if (const auto film = value_with(*law, film_question(scene).arguments))
      scale_film(scene, *film / right_film(scene));
  });
}

Mistake with_film_and_sharing(const Mistake& law) {
  Mistake mistake = with_film({law});
  mistake.instead = [law](const Question& question) -> std::optional<Numbers> {
    const Scene& scene = *question.scene;
    const MixedContact<double> contact(scene);
    const Question film = film_question(scene);
    if (film.function->name != law.function) return right_numbers(question);
    // The exponent of an argument in the film law; 0 for α in laws of soft bodies, which lack it.
    const auto exponent_of = [&](std::string_view name) {
      const std::size_t place = catalogue::place_in(film.function->parameters, name);
      if (place == film.function->parameters.size()) return std::optional(0.0);
      catalogue::Arguments twice = film.arguments;
      twice[place] *= 2;
      const auto before = value_with(law, film.arguments), after = value_with(law, twice);
      return before && after ? std::optional(std::log2(*after / *before)) : std::nullopt;
    };
    const auto of_speed = exponent_of("speed"), of_oil = exponent_of("pressure_viscosity");
    if (!of_speed || !of_oil || !(*of_speed > *of_oil)) return std::nullopt;
    Question sharing = sharing_question(contact, scene);
    sharing.sharing.film_exponent = *of_speed - *of_oil;
    return shared_point(question, contact, right_numbers(sharing)[0],
                        sharing.sharing.film_exponent);
  };
  return mistake;
}

std::vector<Mistake> point_mistakes_of(const MistakeEntry& entry) {
  if (!entry.swapped.empty()) return swaps_of(entry);
  if (!entry.left_out.empty()) return defaults_of(entry);
  if (!entry.area.empty() && entry.area.size() != 2)
    throw std::runtime_error("area: two numbers, of points and of lines");
  if (!entry.area.empty())
    return {changed(entry, {"area"}, [by = entry.area](Question& question) {
      const bool is_line = question.scene->bodies.shape() == ContactShape::line;
      scale_area(*question.scene, by[is_line ? 1 : 0]);
    })};
  for (const auto& [name, change] : ellipse_changes)
    if (entry.formula == name)
      return {changed(entry, {"area", "film"}, [change = change](Question& question) {
        if (question.scene->bodies.shape() == ContactShape::ellipse) change(question);
      })};
  if (!entry.stiffness.empty() && entry.stiffness.size() != 2)
    throw std::runtime_error("stiffness: two numbers, for each asperity model");
  if (!entry.stiffness.empty())
    return {changed(entry, {}, [by = entry.stiffness](Question& question) {
      Scene& scene = *question.scene;
      question.summit_count_times *= scale_stiffness(scene, is_gt(scene) ? by[0] : by[1]);
    })};
  for (const auto& [name, times] : summit_numbers)
    if (entry.formula == name && entry.numbers.size() == 2)
      return {changed(entry, {entry.formula}, [times = times, by = entry.numbers](Question& one) {
        one.*times *= is_gt(*one.scene) ? by[0] : by[1];
      })};
  if (entry.formula == "sharing_of_usual_film")
    return {with_usual_sharing(titled(entry, operating_point))};
  if (entry.formula == "inlet_of_flooded_film")
    return {changed(entry, {"supply"}, take_inlet_of_flooded_film)};
  if (entry.formula == "rough_line" && entry.numbers.size() == 2)
    return {changed(entry, {"area"}, [by = entry.numbers](Question& question) {
      scale_rough_line(question, by[0], by[1]);
    })};
  if (entry.formula == "stiffness_of_greenwood_williamson")
    return {changed(entry, {"stiffness"}, take_stiffness_of_greenwood_williamson)};
  if (!entry.formula.empty())
    throw std::runtime_error(
        fmt::format("no formula {} of {} numbers", entry.formula, entry.numbers.size()));
  if (!entry.friction.empty()) {
    Mistake mistake = titled(entry, operating_point);
    add_reading<FrictionReading>("friction", &Question::friction, friction_numbers, entry.friction,
                                 mistake);
    return {std::move(mistake)};
  }
  return {with_fields(entry)};
}

std::optional<Mistake> for_points(const Mistake& mistake) {
  if (mistake.function == "starvation_ratio") return with_inlet(mistake);
  if (mistake.function == "load_sharing") return with_sharing(mistake);
  return std::nullopt;
}

}  // namespace tribo::conformance
