// SPDX-License-Identifier: Apache-2.0
// The one table of what a scene may hold. Reader, messages, warnings and the JSON Schema follow it.
//
// The plausible ranges are wide on purpose: they are there to catch a slip of unit (mm for m, GPa
// for Pa) or of a power of ten, not to judge a design. No contact of a watch's jewel, of a joint,
// or of a bearing of 3 m leaves them.
#include "scene/schema.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>
#include <vector>

#include "scene/text.hpp"
#include "tribo/validity.hpp"

namespace tribo {
namespace scene_detail {
namespace {

using Words = std::string_view;

template <class T>
void put(T& to, double value) {
  if constexpr (std::is_enum_v<T>)
    to = static_cast<T>(static_cast<int>(value));
  else
    to = static_cast<T>(value);
}
void put(std::optional<double>& to, double value) { to = value; }

template <class T>
std::optional<double> number_in(T from) {
  return static_cast<double>(from);
}
std::optional<double> number_in(std::optional<double> from) { return from; }

// Access to a nested member of the scene, by a chain of pointers to members.
template <auto... members>
constexpr Access at{[](Scene& scene, double value) { put((scene.*....*members), value); },
                    [](const Scene& scene) { return number_in((scene.*....*members)); }};

// The same, where the member is also a number of the contact.
template <double Numbers::*number, auto... members>
constexpr Access at_number{at<members...>.store, at<members...>.load, number};

// The same for a member of a table. Storing also notes that the scene gives the number.
template <double Numbers::*number, auto section, auto member, auto gives_member>
constexpr Access at_own{[](Scene& scene, double value) {
                          put(scene.*section.*member, value);
                          scene.*section.*gives_member = true;
                        },
                        at<section, member>.load, number};

template <std::size_t body, double Body::*member>
constexpr Access at_body{
    [](Scene& scene, double value) { scene.bodies.bodies[body].*member = value; },
    [](const Scene& scene) {
      const Body& one = scene.bodies.bodies[body];
      const bool is_given = member != &Body::poisson_ratio || one.modulus > 0;
      return is_given ? std::optional(one.*member) : std::nullopt;
    }};

template <SupplyKind kind>
constexpr Access at_supply{[](Scene& scene, double value) {
                             scene.supply = {kind, value};
                           },
                           [](const Scene& scene) {
                             const bool is_given = scene.supply.kind == kind;
                             return is_given ? std::optional(scene.supply.value) : std::nullopt;
                           },
                           &Numbers::supply};

// k, which only the scene of a circle has.
constexpr Access at_ellipticity{
    at<&Scene::bodies, &Bodies::ellipticity>.store,
    [](const Scene& scene) {
      const bool is_circle = scene.bodies.shape() == ContactShape::circle;
      return is_circle ? std::optional(scene.bodies.ellipticity) : std::nullopt;
    },
    &Numbers::ellipticity};

// γ, which only Damiens' rule has.
constexpr Access at_damiens_exponent{
    at<&Scene::closures, &Closures::damiens_exponent>.store,
    [](const Scene& scene) {
      const bool is_used = scene.closures.starvation == StarvationClosure::damiens;
      return is_used ? std::optional(scene.closures.damiens_exponent) : std::nullopt;
    },
    &Numbers::damiens_exponent};

// VI, which only an oil of a grade has.
constexpr Access at_viscosity_index{
    at<&Scene::lubricant, &Lubricant::oil, &Oil::viscosity_index>.store, [](const Scene& scene) {
      const Oil& oil = scene.lubricant.oil;
      return oil.iso_vg > 0 ? std::optional(oil.viscosity_index) : std::nullopt;
    }};

// The law of a heated inlet, which only an oil with a conductivity has.
constexpr Access at_thermal{at<&Scene::lubricant, &Lubricant::thermal>.store,
                            [](const Scene& scene) {
                              const Lubricant& oil = scene.lubricant;
                              return oil.conductivity > 0 ? number_in(oil.thermal) : std::nullopt;
                            }};

// One speed in place of all others.
constexpr Access at_speed{[](Scene& scene, double value) { scene.speeds.list.assign(1, value); },
                          [](const Scene& scene) {
                            const std::vector<double>& list = scene.speeds.list;
                            return list.size() == 1 ? std::optional(list.front()) : std::nullopt;
                          }};

struct Row {
  FieldInfo info;
  Access access = {};
};

// The usual range of a number. A number outside of it is legal, but passes the limit
// "<field>_range" (validity.hpp). likely_unit: units that were perhaps meant then; the first unit
// that brings the number into the range is named.
struct Usual {
  double least, greatest;
  std::string_view likely_unit = "";
};
constexpr Row number_row(std::string_view path, std::string_view unit, Usual usual,
                         std::string_view meaning, Access access) {
  return {{.path = path,
           .unit = unit,
           .plausible_minimum = usual.least,
           .plausible_maximum = usual.greatest,
           .likely_unit = usual.likely_unit,
           .meaning = meaning},
          access};
}
constexpr Row required_row(std::string_view path, std::string_view unit, Usual usual,
                           std::string_view meaning, Access access) {
  Row row = number_row(path, unit, usual, meaning, access);
  row.info.required = true;
  return row;
}
// The first word is the default.
constexpr Row choice_row(std::string_view path, std::span<const std::string_view> words,
                         std::string_view meaning, Access access) {
  return {{.path = path,
           .type = FieldType::choice,
           .choices = words,
           .default_text = words.front(),
           .meaning = meaning},
          access};
}
constexpr Row ratio_row(std::string_view path, std::string_view meaning, Access access) {
  return {
      {.path = path, .minimum = -1, .maximum = 0.5, .plausible_maximum = 0.5, .meaning = meaning},
      access};
}
// A number of both faces together, or one of each.
constexpr Row roughness_row(std::string_view path, std::string_view meaning, Access access) {
  Row row = number_row(path, "m", {1e-10, 1e-4}, meaning, access);
  row.info.takes_both_faces = true;
  return row;
}
// Soft rubber has the least modulus. Numbers that are meant in N/mm² lie below the range.
constexpr Usual modulus{5e5, 2e12, "GPa, MPa"};
// The faces of crowned rollers are nearly flat across the motion.
constexpr Usual along{-5, 5, "mm"}, across{-1e4, std::numeric_limits<double>::infinity()};
constexpr Row face_row(std::string_view path, Usual usual, std::string_view meaning,
                       Access access) {
  return {{.path = path,
           .unit = "m",
           .minimum = -std::numeric_limits<double>::max(),
           .is_radius_of_face = true,
           .plausible_minimum = usual.least,
           .plausible_maximum = usual.greatest,
           .likely_unit = usual.likely_unit,
           .meaning = meaning},
          access};
}

constexpr auto rows = std::to_array<Row>({
    {{.path = "id",
      .type = FieldType::text,
      .default_text = "the file's name without its ending",
      .meaning = "name of the scene in results and messages"}},

    number_row("surface.summit_density", "1/m²", {1e6, 1e16, "1/mm²"},
               "n, summits per area; Greenwood–Tripp: of each face, Greenwood–Williamson: of the "
               "one rough face",
               at_number<&Numbers::summit_density, &Scene::surface, &Surface::summit_density>),
    number_row("surface.summit_radius", "m", {1e-9, 1e-2, "µm"},
               "β, radius of curvature of the summits",
               at_number<&Numbers::summit_radius, &Scene::surface, &Surface::summit_radius>),
    number_row("surface.summit_height_sd", "m", {1e-11, 1e-4, "nm"},
               "σ_s, standard deviation of summit heights; Greenwood–Tripp: of the sum of both "
               "faces', Greenwood–Williamson: of the one rough face",
               at_number<&Numbers::summit_height_sd, &Scene::surface, &Surface::summit_height_sd>),
    {{.path = "surface.summit_plane_offset",
      .exclusive_minimum = false,
      .default_text = "0",
      .plausible_maximum = 10,
      .meaning = "D_d/σ_s, from the mean plane to the plane of summits"},
     at_number<&Numbers::summit_plane_offset, &Scene::surface, &Surface::summit_plane_offset>},
    {{.path = "surface.offset_planes",
      .type = FieldType::integer,
      .exclusive_minimum = false,
      .maximum = 2,
      .default_text = "1",
      .meaning = "m, how many faces bring that offset"},
     at_own<&Numbers::offset_planes, &Scene::surface, &Surface::offset_planes,
            &Surface::gives_offset_planes>},
    number_row(
        "surface.m0", "m²", {1e-20, 1e-9, "µm²"},
        "m₀, variance of a profile's heights; Greenwood–Tripp: of each of two faces that are "
        "alike, Greenwood–Williamson: of the one rough face",
        at<&Scene::surface, &Surface::moments, &SpectralMoments::m0>),
    number_row("surface.m2", "", {1e-10, 10}, "m₂, mean square of the profile's slopes",
               at<&Scene::surface, &Surface::moments, &SpectralMoments::m2>),
    number_row("surface.m4", "1/m²", {1, 1e18, "1/mm²"},
               "m₄, mean square of the profile's curvatures",
               at<&Scene::surface, &Surface::moments, &SpectralMoments::m4>),
    roughness_row(
        "surface.rms_roughness",
        "Rq, root-mean-square roughness of both faces together, or [Rq₁, Rq₂] of each; "
        "for lambda_ratio, and compared with summit_height_sd; follows from average_roughness or "
        "m0 too",
        at_number<&Numbers::rms_roughness, &Scene::surface, &Surface::rms_roughness>),
    roughness_row("surface.average_roughness",
                  "Ra, of both faces together, or [Ra₁, Ra₂] of each, in place of Rq: Rq = √(π/2) "
                  "Ra of Gaussian heights",
                  at<&Scene::surface, &Surface::average_roughness>),

    number_row("bodies.effective_modulus", "Pa", modulus,
               "E*, with 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂; never 2E*",
               at_number<&Numbers::effective_modulus, &Scene::bodies, &Bodies::effective_modulus>),
    number_row("bodies.reduced_radius", "m", {1e-6, 5, "mm"},
               "R of the circular contact; a ball on a flat: the radius of the ball",
               at_number<&Numbers::radius_x, &Scene::bodies, &Bodies::reduced_radius>),
    {{.path = "bodies.ellipticity",
      .default_text = "1",
      .meaning = "k; enters the constant of the film formula alone, Hertz stays circular"},
     at_ellipticity},
    number_row("bodies.radius_x", "m", {1e-6, 5, "mm"},
               "R_x of an ellipse or a line, along the direction of entrainment, 1/R_x = 1/R₁x + "
               "1/R₂x",
               at_number<&Numbers::radius_x, &Scene::bodies, &Bodies::radius_x>),
    number_row("bodies.radius_y", "m", {1e-6, 1e4, "mm"},
               "R_y of an ellipse, across the direction of entrainment, 1/R_y = 1/R₁y + 1/R₂y",
               at<&Scene::bodies, &Bodies::radius_y>),
    number_row("bodies.length", "m", {1e-6, 5, "mm"}, "L of a line; load stays the whole load",
               at_number<&Numbers::across, &Scene::bodies, &Bodies::length>),
    number_row("bodies.first_modulus", "Pa", modulus, "E₁, Young's modulus of the first body",
               at_body<0, &Body::modulus>),
    ratio_row("bodies.first_poisson_ratio", "ν₁", at_body<0, &Body::poisson_ratio>),
    number_row("bodies.second_modulus", "Pa", modulus, "E₂, Young's modulus of the second body",
               at_body<1, &Body::modulus>),
    ratio_row("bodies.second_poisson_ratio", "ν₂", at_body<1, &Body::poisson_ratio>),
    face_row("bodies.first_radius_x", along,
             "R₁x of the first body's face, along the direction of entrainment: above 0 convex, "
             "below 0 concave, 1e30 (in TOML also inf) flat",
             at_body<0, &Body::radius_x>),
    face_row("bodies.second_radius_x", along, "R₂x of the second body's face, likewise",
             at_body<1, &Body::radius_x>),
    face_row("bodies.first_radius_y", across, "R₁y of the first body's face, across that direction",
             at_body<0, &Body::radius_y>),
    face_row("bodies.second_radius_y", across, "R₂y of the second body's face, likewise",
             at_body<1, &Body::radius_y>),

    number_row("lubricant.viscosity", "Pa·s", {1e-5, 10, "mPa·s"},
               "η₀, at ambient pressure; above 6.315e-5 with friction.viscosity = \"roelands\"",
               at_number<&Numbers::viscosity, &Scene::lubricant, &Lubricant::viscosity>),
    {{.path = "lubricant.kinematic_viscosity",
      .type = FieldType::viscosities,
      .meaning = "[[T₁, ν₁], [T₂, ν₂]] in K and m²/s, from which η₀ follows by ASTM D341"}},
    number_row("lubricant.iso_vg", "", {0, 5000},
               "ISO VG grade, ν at 40 °C in mm²/s, in place of the two viscosities",
               at<&Scene::lubricant, &Lubricant::oil, &Oil::iso_vg>),
    {{.path = "lubricant.viscosity_index",
      .exclusive_minimum = false,
      .maximum = 400,
      .plausible_maximum = 200,
      .meaning = "VI, from which ν at 100 °C follows by ASTM D2270"},
     at_viscosity_index},
    number_row("lubricant.density", "kg/m³", {500, 2000, "g/cm³"}, "ρ, with which η₀ = ρν",
               at<&Scene::lubricant, &Lubricant::oil, &Oil::density>),
    number_row("lubricant.temperature", "K", {200, 500}, "T at which the contact runs",
               at<&Scene::lubricant, &Lubricant::oil, &Oil::temperature>),
    {{.path = "lubricant.pressure_viscosity",
      .unit = "1/Pa",
      .exclusive_minimum = false,
      .required = true,
      .plausible_minimum = 1e-11,
      .plausible_maximum = 1e-6,
      .likely_unit = "1/GPa",
      .meaning = "α, pressure–viscosity coefficient"},
     at_number<&Numbers::pressure_viscosity, &Scene::lubricant, &Lubricant::pressure_viscosity>},
    {{.path = "lubricant.eyring_stress",
      .unit = "Pa",
      .needed_by = Output::friction,
      .plausible_minimum = 1e3,
      .plausible_maximum = 1e10,
      .likely_unit = "MPa",
      .meaning = "τ₀, Eyring's stress"},
     at_number<&Numbers::eyring_stress, &Scene::lubricant, &Lubricant::eyring_stress>},

    {{.path = "lubricant.thermal",
      .type = FieldType::choice,
      .choices = thermal_inlet_words,
      .meaning = "law of the inlet that shear heats; absent: none"},
     at_thermal},
    number_row("lubricant.conductivity", "W/(m·K)", {0.05, 1, "mW/(m·K)"},
               "k_f, thermal conductivity of the liquid in a heated inlet",
               at_number<&Numbers::conductivity, &Scene::lubricant, &Lubricant::conductivity>),
    number_row("lubricant.temperature_coefficient", "1/K", {1e-3, 0.2},
               "β = −d ln η/dT of the liquid in a heated inlet",
               at_number<&Numbers::temperature_coefficient, &Scene::lubricant,
                         &Lubricant::temperature_coefficient>),

    required_row("load", "N", {1e-9, 1e7, "mN"}, "F, normal load",
                 at_number<&Numbers::load, &Scene::load>),

    {{.path = "speed",
      .type = FieldType::speeds,
      .unit = "m/s",
      .plausible_minimum = 1e-9,
      .plausible_maximum = 500,
      .likely_unit = "mm/s",
      .meaning = "u, mean (entrainment) speed; onset does without"},
     at_speed},
    required_row("speed.from", "m/s", {1e-9, 500, "mm/s"}, "the first speed of a range",
                 at<&Scene::speeds, &Speeds::from>),
    required_row("speed.to", "m/s", {1e-9, 500, "mm/s"},
                 "the last speed of a range, above speed.from", at<&Scene::speeds, &Speeds::to>),
    {{.path = "speed.count",
      .type = FieldType::integer,
      .minimum = 2,
      .exclusive_minimum = false,
      .maximum = 10'000'000,
      .default_text = "200",
      .meaning = "how many speeds, with both ends"},
     at<&Scene::speeds, &Speeds::count>},
    choice_row("speed.spacing", spacing_words,
               "speeds at even ratios (log) or even differences (lin)",
               at<&Scene::speeds, &Speeds::spacing>),

    number_row("supply.inlet_film", "m", {1e-11, 1e-2, "µm"},
               "h_oil, thickness of the oil before the contact", at_supply<SupplyKind::inlet_film>),
    number_row("supply.inlet_film_ratio", "", {1e-3, 1e6}, "h_oil/σ_s",
               at_supply<SupplyKind::inlet_film_ratio>),
    number_row("supply.inlet_flow", "m²/s", {1e-16, 1e-2, "mm²/s"},
               "q, flow of oil per width; h_oil = q/u", at_supply<SupplyKind::inlet_flow>),

    {{.path = "friction.boundary_coefficient",
      .exclusive_minimum = false,
      .takes_per_cent = true,
      .needed_by = Output::friction,
      .plausible_maximum = 1,
      .meaning = "μ_b, friction coefficient where summits touch"},
     at_number<&Numbers::boundary_coefficient, &Scene::friction, &Friction::boundary_coefficient>},
    {{.path = "friction.slide_roll_ratio",
      .exclusive_minimum = false,
      .takes_per_cent = true,
      .default_text = "1",
      .plausible_maximum = 100,
      .meaning =
          "S, sliding speed over entrainment speed; usual in a rolling bearing 0.01 to 0.05, "
          "in gears 0 to 0.5, on a rig with ball on disc 0.5"},
     at_own<&Numbers::slide_roll_ratio, &Scene::friction, &Friction::slide_roll_ratio,
            &Friction::gives_slide_roll_ratio>},
    choice_row("friction.fluid", fluid_shear_words, "shear law of the fluid",
               at<&Scene::friction, &Friction::fluid>),
    choice_row("friction.viscosity", viscosity_law_words, "law of viscosity against pressure",
               at<&Scene::friction, &Friction::viscosity>),

    choice_row("closures.asperity", asperity_model_words, "model of the rough contact",
               at<&Scene::closures, &Closures::asperity>),
    choice_row(
        "closures.starvation", starvation_words, "rule for the film behind a starved inlet",
        at_own<nullptr, &Scene::closures, &Closures::starvation, &Closures::gives_starvation>),
    choice_row("closures.film", film_formula_words, "law of the flooded film",
               at<&Scene::closures, &Closures::film>),
    {{.path = "closures.damiens_exponent",
      .default_text = "3",
      .plausible_minimum = 1,
      .plausible_maximum = 20,
      .meaning = "γ of Damiens' rule"},
     at_damiens_exponent},

    {{.path = "outputs",
      .type = FieldType::outputs,
      .default_text = "all that the given fields allow",
      .meaning = "what to compute"}},
    {{.path = "accept",
      .type = FieldType::limits,
      .default_text = "none",
      .meaning =
          "limits of the model's validity that are accepted where this scene goes beyond them"}},
});
static_assert(rows.size() <= field_capacity);

constexpr std::array by_modulus{Words("bodies.effective_modulus")};
constexpr std::array by_materials{
    Words("bodies.first_modulus"), Words("bodies.first_poisson_ratio"),
    Words("bodies.second_modulus"), Words("bodies.second_poisson_ratio")};
constexpr std::array elasticity{FieldSet{by_modulus, {}}, FieldSet{by_materials, {}}};

constexpr std::array of_circle{Words("bodies.reduced_radius")};
constexpr std::array beside_circle{Words("bodies.ellipticity")};
constexpr std::array of_ellipse{Words("bodies.radius_x"), Words("bodies.radius_y")};
constexpr std::array of_line{Words("bodies.radius_x"), Words("bodies.length")};
constexpr std::array of_faces{Words("bodies.first_radius_x"), Words("bodies.second_radius_x"),
                              Words("bodies.first_radius_y"), Words("bodies.second_radius_y")};
constexpr std::array of_faces_of_line{Words("bodies.first_radius_x"),
                                      Words("bodies.second_radius_x"), Words("bodies.length")};
constexpr std::array shapes{FieldSet{of_circle, beside_circle}, FieldSet{of_ellipse, {}},
                            FieldSet{of_line, {}}, FieldSet{of_faces, {}},
                            FieldSet{of_faces_of_line, {}}};

constexpr std::array of_summits{Words("surface.summit_density"), Words("surface.summit_radius"),
                                Words("surface.summit_height_sd")};
constexpr std::array beside_summits{Words("surface.summit_plane_offset")};
constexpr std::array of_profile{Words("surface.m0"), Words("surface.m2"), Words("surface.m4")};
constexpr std::array summits{FieldSet{of_summits, beside_summits}, FieldSet{of_profile, {}}};

constexpr std::array by_viscosity{Words("lubricant.viscosity")};
constexpr std::array by_kinematic{Words("lubricant.kinematic_viscosity"),
                                  Words("lubricant.density"), Words("lubricant.temperature")};
constexpr std::array by_grade{Words("lubricant.iso_vg"), Words("lubricant.viscosity_index"),
                              Words("lubricant.density"), Words("lubricant.temperature")};
constexpr std::array oils{FieldSet{by_viscosity, {}}, FieldSet{by_kinematic, {}},
                          FieldSet{by_grade, {}}};

constexpr std::array of_heated_inlet{Words("lubricant.thermal"), Words("lubricant.conductivity"),
                                     Words("lubricant.temperature_coefficient")};
constexpr std::array inlets{FieldSet{{}, {}}, FieldSet{of_heated_inlet, {}}};

constexpr std::array groups{FieldGroup(summits), FieldGroup(elasticity), FieldGroup(shapes),
                            FieldGroup(oils), FieldGroup(inlets)};

constexpr auto infos = [] {
  std::array<FieldInfo, rows.size()> result;
  for (std::size_t i = 0; i < rows.size(); ++i) result[i] = rows[i].info;
  return result;
}();

// Shorter paths first: then most comparisons are of lengths, and a stream makes 100 of them a line.
constexpr bool is_before(std::string_view left, std::string_view right) {
  if (left.size() != right.size()) return left.size() < right.size();
  return left < right;
}

// Places of the rows in the table, in that order.
constexpr auto by_path = [] {
  std::array<std::size_t, rows.size()> places{};
  for (std::size_t i = 0; i < rows.size(); ++i) places[i] = i;
  std::sort(places.begin(), places.end(), [](std::size_t left, std::size_t right) {
    return is_before(rows[left].info.path, rows[right].info.path);
  });
  return places;
}();

// Keeps the nearest name seen so far. A name whose last part fits is near even in the wrong section
// ("load" under [bodies]). Between equals the same section wins.
class Nearest {
 public:
  explicit Nearest(std::string_view path) : path_(path) {
    while (!path_.empty() && path_.front() == '"') path_.remove_prefix(1);
    while (!path_.empty() && path_.back() == '"') path_.remove_suffix(1);
    const std::size_t length = last_part(path_).size();
    limit_ = length < 4 ? 1 : std::max<std::size_t>(2, length / 3);
    best_ = 2 * limit_ + 2;
  }

  void consider(std::string_view candidate) {
    const std::size_t whole = edit_distance(path_, candidate);
    const std::size_t part = edit_distance(last_part(path_), last_part(candidate));
    const std::size_t elsewhere = section_of(path_) == section_of(candidate) ? 0 : 1;
    offer(candidate, whole, 2 * whole);
    offer(candidate, part, 2 * part + elsewhere);
  }

  std::string_view name() const { return name_; }

 private:
  void offer(std::string_view candidate, std::size_t distance, std::size_t score) {
    if (distance > limit_ || score >= best_) return;
    best_ = score;
    name_ = candidate;
  }

  std::string_view path_;
  std::size_t limit_ = 0;
  std::size_t best_ = 0;
  std::string_view name_;
};

std::string allowed_number(const FieldInfo& field) {
  if (field.is_radius_of_face) return "a number other than 0, in m; inf or 1e30 is a flat face";
  std::string text = field.type == FieldType::integer ? "a whole number" : "a number";
  if (field.maximum && field.exclusive_minimum) {
    text += " above " + number_text(field.minimum) + " and at most " + number_text(*field.maximum);
  } else if (field.maximum) {
    text += " from " + number_text(field.minimum) + " to " + number_text(*field.maximum);
  } else {
    text += field.exclusive_minimum ? " above " : " not below ";
    text += number_text(field.minimum);
  }
  if (!field.unit.empty()) text += ", in " + std::string(field.unit);
  if (field.takes_both_faces) text += "; or a list of two such numbers, one of each face";
  return text;
}

FieldPlaces places_of(std::span<const std::string_view> paths) {
  FieldPlaces places;
  for (const std::string_view path : paths) places.set(field_at(path));
  return places;
}

}  // namespace

std::string joined(std::span<const std::string_view> words, std::string_view last_link) {
  std::string result;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) result += i + 1 == words.size() ? last_link : std::string_view(", ");
    result += words[i];
  }
  return result;
}

std::string sets_text(FieldGroup group, std::size_t first) {
  std::string text;
  for (std::size_t i = first; i < group.size(); ++i) {
    if (i > first) text += ", or ";
    std::vector<std::string_view> names;
    for (const std::string_view path : group[i].fields) names.push_back(last_part(path));
    text += names.empty() ? "none of them" : joined(names, " and ");
  }
  return text;
}

Store store_of(std::size_t field) { return rows[field].access.store; }

std::optional<double> value_in(const Scene& scene, std::size_t field) {
  const auto& [info, access] = rows[field];
  if (access.load == nullptr) return std::nullopt;
  const std::optional<double> value = access.load(scene);
  if (value != 0.0) return value;
  // In a scene 0 means "not given" for a field that cannot be 0.
  const bool may_be_zero =
      info.type == FieldType::choice || info.minimum < 0 || !info.exclusive_minimum;
  return !may_be_zero || info.is_radius_of_face ? std::nullopt : value;
}

double Numbers::*contact_number(std::size_t field, ContactShape shape) {
  double Numbers::*const number = rows[field].access.number;
  return shape == ContactShape::ellipse && number == &Numbers::radius_x ? nullptr : number;
}

std::optional<std::size_t> find_field(std::string_view path) {
  const auto place = std::lower_bound(
      by_path.begin(), by_path.end(), path,
      [](std::size_t i, std::string_view p) { return is_before(rows[i].info.path, p); });
  if (place == by_path.end() || rows[*place].info.path != path) return std::nullopt;
  return *place;
}

std::size_t field_at(std::string_view path) { return find_field(path).value_or(rows.size()); }

const std::vector<GroupPlaces>& group_places() {
  static const std::vector<GroupPlaces> all = [] {
    std::vector<GroupPlaces> result;
    for (const FieldGroup group : groups) {
      GroupPlaces& places = result.emplace_back(GroupPlaces{group, {}, {}, {}});
      for (const FieldSet& set : group) {
        places.sets.push_back({set, places_of(set.fields), places_of(set.optional)});
        places.fields |= places.sets.back().fields;
        places.optional |= places.sets.back().optional;
      }
    }
    return result;
  }();
  return all;
}

bool is_section(std::string_view name) {
  return std::find(sections.begin(), sections.end(), name) != sections.end();
}

std::string_view section_of(std::string_view path) {
  if (path.starts_with('"')) return {};  // a quoted key may hold dots
  const std::size_t dot = path.find('.');
  return dot == std::string_view::npos ? std::string_view() : path.substr(0, dot);
}

std::string_view nearest_name(std::string_view path, bool with_sections, bool with_fields) {
  Nearest nearest(path);
  if (with_sections)
    for (const std::string_view name : sections) nearest.consider(name);
  if (with_fields)
    for (const FieldInfo& field : infos) nearest.consider(field.path);
  return nearest.name();
}

// Symbols that people write in place of an output's name.
struct Symbol {
  std::string_view sign, name;
};
constexpr auto symbols = std::to_array<Symbol>({{"Λ", "lambda_ratio"},
                                                {"λ", "film_parameter"},
                                                {"μ", "friction"},
                                                {"µ", "friction"},
                                                {"mu", "friction"},
                                                {"h", "film"},
                                                {"h_min", "minimum_film"},
                                                {"A", "asperity_load_share"}});

std::string_view nearest_choice(std::string_view word, std::span<const std::string_view> choices) {
  for (const Symbol& symbol : symbols)
    if (symbol.sign == word &&
        std::find(choices.begin(), choices.end(), symbol.name) != choices.end())
      return symbol.name;
  Nearest nearest(word);
  for (const std::string_view choice : choices) nearest.consider(choice);
  return nearest.name();
}

std::string allowed_text(const FieldInfo& field) {
  switch (field.type) {
    case FieldType::number:
    case FieldType::integer:
      return allowed_number(field);
    case FieldType::text:
      return "a text";
    case FieldType::choice:
      return joined(field.choices, " or ");
    case FieldType::speeds:
      return allowed_number(field) +
             ", a list of such numbers, or a table of from, to, count and "
             "spacing";
    case FieldType::outputs:
      return "a list of " + joined(output_names, ", ");
    case FieldType::limits:
      return "a list of " + joined(assumption_words(), ", ") +
             ", and of fields with their range, as viscosity_range";
    case FieldType::viscosities:
      return "two pairs, [[T1, nu1], [T2, nu2]], of a temperature in K and a kinematic viscosity "
             "in m²/s";
  }
  return {};
}

std::string names_in(std::string_view section) {
  std::string text;
  const auto add = [&text](std::string_view name) {
    if (!text.empty()) text += ", ";
    text += name;
  };
  for (const FieldInfo& field : infos)
    if (section_of(field.path) == section) add(last_part(field.path));
  if (!section.empty()) return text;
  for (const std::string_view name : sections)
    if (name != "speed") add(name);  // already there as a field
  return text;
}

}  // namespace scene_detail

std::span<const FieldGroup> scene_field_groups() { return scene_detail::groups; }
std::span<const FieldInfo> scene_fields() { return scene_detail::infos; }

}  // namespace tribo
