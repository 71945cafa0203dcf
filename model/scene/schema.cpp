// SPDX-License-Identifier: Apache-2.0
// The one table of what a scene may hold. Reader, messages, warnings and the JSON Schema follow it.
//
// The plausible ranges are wide on purpose: they are there to catch a slip of unit (mm for m, GPa
// for Pa) or of a power of ten, not to judge a design.
#include "scene/schema.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "scene/text.hpp"

namespace tribo {
namespace scene_detail {
namespace {

using Words = std::string_view;

template <typename Enum>
Enum enum_at(double place) {
  return static_cast<Enum>(static_cast<int>(place));
}

struct Row {
  FieldInfo info;
  Store store = nullptr;
};

constexpr Row modulus_row(std::string_view path, std::string_view meaning, Store store) {
  return {{.path = path,
           .unit = "Pa",
           .plausible_minimum = 1e3,
           .plausible_maximum = 2e12,
           .meaning = meaning},
          store};
}
constexpr Row ratio_row(std::string_view path, std::string_view meaning, Store store) {
  return {
      {.path = path, .minimum = -1, .maximum = 0.5, .plausible_maximum = 0.5, .meaning = meaning},
      store};
}
constexpr Row face_row(std::string_view path, std::string_view meaning, Store store) {
  return {{.path = path,
           .unit = "m",
           .minimum = -std::numeric_limits<double>::max(),
           .is_radius_of_face = true,
           .plausible_minimum = -1e4,
           .meaning = meaning},
          store};
}

constexpr std::array<Row, field_count> rows{{
    {{.path = "id",
      .type = FieldType::text,
      .default_text = "the file's name without its ending",
      .meaning = "name of the scene in results and messages"}},

    {{.path = "surface.summit_density",
      .unit = "1/m²",
      .plausible_minimum = 1e6,
      .plausible_maximum = 1e16,
      .meaning = "n, summits per area; Greenwood–Tripp: of each face, Greenwood–Williamson: of the "
                 "one rough face"},
     [](Scene& scene, double value) { scene.surface.summit_density = value; }},
    {{.path = "surface.summit_radius",
      .unit = "m",
      .plausible_minimum = 1e-9,
      .plausible_maximum = 1e-2,
      .meaning = "β, radius of curvature of the summits"},
     [](Scene& scene, double value) { scene.surface.summit_radius = value; }},
    {{.path = "surface.summit_height_sd",
      .unit = "m",
      .plausible_minimum = 1e-11,
      .plausible_maximum = 1e-4,
      .meaning = "σ_s, standard deviation of summit heights; Greenwood–Tripp: of the sum of both "
                 "faces', Greenwood–Williamson: of the one rough face"},
     [](Scene& scene, double value) { scene.surface.summit_height_sd = value; }},
    {{.path = "surface.summit_plane_offset",
      .exclusive_minimum = false,
      .default_text = "0",
      .plausible_maximum = 10,
      .meaning = "D_d/σ_s, from the mean plane to the plane of summits"},
     [](Scene& scene, double value) { scene.surface.summit_plane_offset = value; }},
    {{.path = "surface.offset_planes",
      .type = FieldType::integer,
      .exclusive_minimum = false,
      .maximum = 2,
      .default_text = "1",
      .meaning = "m, how many faces bring that offset"},
     [](Scene& scene, double value) { scene.surface.offset_planes = static_cast<int>(value); }},
    {{.path = "surface.m0",
      .unit = "m²",
      .plausible_minimum = 1e-20,
      .plausible_maximum = 1e-9,
      .meaning =
          "m₀, variance of a profile's heights; Greenwood–Tripp: of each of two faces that are "
          "alike, Greenwood–Williamson: of the one rough face"},
     [](Scene& scene, double value) { scene.surface.moments.m0 = value; }},
    {{.path = "surface.m2",
      .plausible_minimum = 1e-10,
      .plausible_maximum = 10,
      .meaning = "m₂, mean square of the profile's slopes"},
     [](Scene& scene, double value) { scene.surface.moments.m2 = value; }},
    {{.path = "surface.m4",
      .unit = "1/m²",
      .plausible_minimum = 1,
      .plausible_maximum = 1e18,
      .meaning = "m₄, mean square of the profile's curvatures"},
     [](Scene& scene, double value) { scene.surface.moments.m4 = value; }},

    {{.path = "bodies.effective_modulus",
      .unit = "Pa",
      .plausible_minimum = 1e3,
      .plausible_maximum = 2e12,
      .meaning = "E*, with 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂; never 2E*"},
     [](Scene& scene, double value) { scene.bodies.effective_modulus = value; }},
    {{.path = "bodies.reduced_radius",
      .unit = "m",
      .plausible_minimum = 1e-6,
      .plausible_maximum = 1,
      .meaning = "R of the circular contact; a ball on a flat: the radius of the ball"},
     [](Scene& scene, double value) { scene.bodies.reduced_radius = value; }},
    {{.path = "bodies.ellipticity",
      .default_text = "1",
      .plausible_minimum = 1,
      .plausible_maximum = 1,
      .meaning = "k; enters the constant of the film formula alone, Hertz stays circular"},
     [](Scene& scene, double value) { scene.bodies.ellipticity = value; }},
    {{.path = "bodies.radius_x",
      .unit = "m",
      .plausible_minimum = 1e-6,
      .plausible_maximum = 10,
      .meaning = "R_x of an ellipse or a line, along the direction of entrainment, 1/R_x = 1/R₁x + "
                 "1/R₂x"},
     [](Scene& scene, double value) { scene.bodies.radius_x = value; }},
    {{.path = "bodies.radius_y",
      .unit = "m",
      .plausible_minimum = 1e-6,
      .plausible_maximum = 1e4,
      .meaning = "R_y of an ellipse, across the direction of entrainment, 1/R_y = 1/R₁y + 1/R₂y"},
     [](Scene& scene, double value) { scene.bodies.radius_y = value; }},
    {{.path = "bodies.length",
      .unit = "m",
      .plausible_minimum = 1e-6,
      .plausible_maximum = 10,
      .meaning = "L of a line; load stays the whole load"},
     [](Scene& scene, double value) { scene.bodies.length = value; }},
    modulus_row("bodies.first_modulus", "E₁, Young's modulus of the first body",
                [](Scene& scene, double value) { scene.bodies.bodies[0].modulus = value; }),
    ratio_row("bodies.first_poisson_ratio", "ν₁",
              [](Scene& scene, double value) { scene.bodies.bodies[0].poisson_ratio = value; }),
    modulus_row("bodies.second_modulus", "E₂, Young's modulus of the second body",
                [](Scene& scene, double value) { scene.bodies.bodies[1].modulus = value; }),
    ratio_row("bodies.second_poisson_ratio", "ν₂",
              [](Scene& scene, double value) { scene.bodies.bodies[1].poisson_ratio = value; }),
    face_row("bodies.first_radius_x",
             "R₁x of the first body's face, along the direction of entrainment: above 0 convex, "
             "below 0 concave, 1e30 (in TOML also inf) flat",
             [](Scene& scene, double value) { scene.bodies.bodies[0].radius_x = value; }),
    face_row("bodies.second_radius_x", "R₂x of the second body's face, likewise",
             [](Scene& scene, double value) { scene.bodies.bodies[1].radius_x = value; }),
    face_row("bodies.first_radius_y", "R₁y of the first body's face, across that direction",
             [](Scene& scene, double value) { scene.bodies.bodies[0].radius_y = value; }),
    face_row("bodies.second_radius_y", "R₂y of the second body's face, likewise",
             [](Scene& scene, double value) { scene.bodies.bodies[1].radius_y = value; }),

    {{.path = "lubricant.viscosity",
      .unit = "Pa·s",
      .required = true,
      .plausible_minimum = 1e-5,
      .plausible_maximum = 1e4,
      .meaning = "η₀, at ambient pressure; above 6.315e-5 with friction.viscosity = \"roelands\""},
     [](Scene& scene, double value) { scene.lubricant.viscosity = value; }},
    {{.path = "lubricant.pressure_viscosity",
      .unit = "1/Pa",
      .required = true,
      .plausible_minimum = 1e-11,
      .plausible_maximum = 1e-6,
      .meaning = "α, pressure–viscosity coefficient"},
     [](Scene& scene, double value) { scene.lubricant.pressure_viscosity = value; }},
    {{.path = "lubricant.eyring_stress",
      .unit = "Pa",
      .needed_by = Output::friction,
      .plausible_minimum = 1e3,
      .plausible_maximum = 1e10,
      .meaning = "τ₀, Eyring's stress"},
     [](Scene& scene, double value) { scene.lubricant.eyring_stress = value; }},

    {{.path = "load",
      .unit = "N",
      .required = true,
      .plausible_minimum = 1e-9,
      .plausible_maximum = 1e6,
      .meaning = "F, normal load"},
     [](Scene& scene, double value) { scene.load = value; }},

    {{.path = "speed",
      .type = FieldType::speeds,
      .unit = "m/s",
      .plausible_minimum = 1e-9,
      .plausible_maximum = 1e3,
      .meaning = "u, mean (entrainment) speed; onset does without"}},
    {{.path = "speed.from",
      .unit = "m/s",
      .required = true,
      .plausible_minimum = 1e-9,
      .plausible_maximum = 1e3,
      .meaning = "the first speed of a range"},
     [](Scene& scene, double value) { scene.speeds.from = value; }},
    {{.path = "speed.to",
      .unit = "m/s",
      .required = true,
      .plausible_minimum = 1e-9,
      .plausible_maximum = 1e3,
      .meaning = "the last speed of a range, above speed.from"},
     [](Scene& scene, double value) { scene.speeds.to = value; }},
    {{.path = "speed.count",
      .type = FieldType::integer,
      .minimum = 2,
      .exclusive_minimum = false,
      .maximum = 10'000'000,
      .default_text = "200",
      .meaning = "how many speeds, with both ends"},
     [](Scene& scene, double value) { scene.speeds.count = static_cast<std::size_t>(value); }},
    {{.path = "speed.spacing",
      .type = FieldType::choice,
      .choices = spacing_words,
      .default_text = "log",
      .meaning = "speeds at even ratios (log) or even differences (lin)"},
     [](Scene& scene, double place) { scene.speeds.spacing = enum_at<Spacing>(place); }},

    {{.path = "supply.inlet_film",
      .unit = "m",
      .plausible_minimum = 1e-11,
      .plausible_maximum = 1e-2,
      .meaning = "h_oil, thickness of the oil before the contact"},
     [](Scene& scene, double value) {
       scene.supply = {SupplyKind::inlet_film, value};
     }},
    {{.path = "supply.inlet_film_ratio",
      .plausible_minimum = 1e-3,
      .plausible_maximum = 1e6,
      .meaning = "h_oil/σ_s"},
     [](Scene& scene, double value) {
       scene.supply = {SupplyKind::inlet_film_ratio, value};
     }},
    {{.path = "supply.inlet_flow",
      .unit = "m²/s",
      .plausible_minimum = 1e-16,
      .plausible_maximum = 1e-2,
      .meaning = "q, flow of oil per width; h_oil = q/u"},
     [](Scene& scene, double value) {
       scene.supply = {SupplyKind::inlet_flow, value};
     }},

    {{.path = "friction.boundary_coefficient",
      .exclusive_minimum = false,
      .needed_by = Output::friction,
      .plausible_maximum = 1,
      .meaning = "μ_b, friction coefficient where summits touch"},
     [](Scene& scene, double value) { scene.friction.boundary_coefficient = value; }},
    {{.path = "friction.slide_roll_ratio",
      .exclusive_minimum = false,
      .default_text = "1",
      .plausible_maximum = 100,
      .meaning = "S, sliding speed over entrainment speed"},
     [](Scene& scene, double value) { scene.friction.slide_roll_ratio = value; }},
    {{.path = "friction.fluid",
      .type = FieldType::choice,
      .choices = fluid_shear_words,
      .default_text = "eyring",
      .meaning = "shear law of the fluid"},
     [](Scene& scene, double place) { scene.friction.fluid = enum_at<FluidShear>(place); }},
    {{.path = "friction.viscosity",
      .type = FieldType::choice,
      .choices = viscosity_law_words,
      .default_text = "barus",
      .meaning = "law of viscosity against pressure"},
     [](Scene& scene, double place) { scene.friction.viscosity = enum_at<ViscosityLaw>(place); }},

    {{.path = "closures.asperity",
      .type = FieldType::choice,
      .choices = asperity_model_words,
      .default_text = "greenwood_tripp",
      .meaning = "model of the rough contact"},
     [](Scene& scene, double place) { scene.closures.asperity = enum_at<AsperityModel>(place); }},
    {{.path = "closures.starvation",
      .type = FieldType::choice,
      .choices = starvation_closure_words,
      .default_text = "flooded_inlet",
      .meaning = "rule for the film behind a starved inlet"},
     [](Scene& scene, double place) {
       scene.closures.starvation = enum_at<StarvationClosure>(place);
     }},
    {{.path = "closures.film",
      .type = FieldType::choice,
      .choices = film_formula_words,
      .default_text = "hamrock_dowson_central",
      .meaning = "law of the flooded film"},
     [](Scene& scene, double place) { scene.closures.film = enum_at<FilmFormula>(place); }},
    {{.path = "closures.damiens_exponent",
      .default_text = "3",
      .plausible_minimum = 1,
      .plausible_maximum = 20,
      .meaning = "γ of Damiens' rule"},
     [](Scene& scene, double value) { scene.closures.damiens_exponent = value; }},

    {{.path = "outputs",
      .type = FieldType::outputs,
      .default_text = "all that the given fields allow",
      .meaning = "what to compute"}},
}};

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

constexpr std::array groups{FieldGroup(summits), FieldGroup(elasticity), FieldGroup(shapes)};

constexpr std::array<FieldInfo, field_count> infos = [] {
  std::array<FieldInfo, field_count> result;
  for (std::size_t i = 0; i < field_count; ++i) result[i] = rows[i].info;
  return result;
}();

// Shorter paths first: most comparisons are of lengths alone, and a stream makes a hundred a line.
constexpr bool is_before(std::string_view left, std::string_view right) {
  if (left.size() != right.size()) return left.size() < right.size();
  return left < right;
}

// Places in the table, in that order.
constexpr std::array<std::size_t, field_count> by_path = [] {
  std::array<std::size_t, field_count> places{};
  for (std::size_t i = 0; i < field_count; ++i) places[i] = i;
  std::sort(places.begin(), places.end(), [](std::size_t left, std::size_t right) {
    return is_before(rows[left].info.path, rows[right].info.path);
  });
  return places;
}();

constexpr std::array<Words, section_count> sections{"bodies", "closures", "friction", "lubricant",
                                                    "speed",  "supply",   "surface"};

// Keeps the nearest name seen so far. A name whose last part fits is near even where it was written
// into the wrong section ("load" under [bodies]); the same section wins between equals.
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
  return text;
}

FieldPlaces places_of(std::span<const std::string_view> paths) {
  FieldPlaces places;
  for (const std::string_view path : paths) places.set(field_at(path));
  return places;
}

std::string output_names() {
  std::string text;
  for (const OutputInfo& output : output_infos) {
    if (!text.empty()) text += ", ";
    text += output.name;
  }
  return text;
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
    text += joined(names, " and ");
  }
  return text;
}

Store store_of(std::size_t field) { return rows[field].store; }

std::optional<std::size_t> find_field(std::string_view path) {
  const auto place = std::lower_bound(
      by_path.begin(), by_path.end(), path,
      [](std::size_t i, std::string_view p) { return is_before(rows[i].info.path, p); });
  if (place == by_path.end() || rows[*place].info.path != path) return std::nullopt;
  return *place;
}

std::size_t field_at(std::string_view path) { return find_field(path).value_or(field_count); }

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

std::string_view nearest_choice(std::string_view word, std::span<const std::string_view> choices) {
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
      return "a list of " + output_names();
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
