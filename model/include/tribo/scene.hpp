// SPDX-License-Identifier: Apache-2.0
// A scene: one contact, its lubricant, its supply of oil and the speeds it is asked at. SI units.
// Field names, units and legal ranges: model/README.md, section 1. The readers (scene_reader.hpp)
// give only scenes whose fields are in range; code that fills a scene by hand must see to this.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tribo/film_laws.hpp"
#include "tribo/outputs.hpp"
#include "tribo/starvation.hpp"

namespace tribo {

enum class AsperityModel : std::uint8_t { greenwood_tripp, greenwood_williamson };
enum class FluidShear : std::uint8_t { eyring, limiting };
enum class ViscosityLaw : std::uint8_t { barus, ambient, roelands };
enum class SupplyKind : std::uint8_t { flooded, inlet_film, inlet_film_ratio, inlet_flow };
enum class Spacing : std::uint8_t { log, lin };

// The words for these in scene files, requests and tables, in the order of the enumerations (those
// of film laws and closures of the inlet: film_laws.hpp, starvation.hpp). A supply is named by its
// field; a scene without a field of supply is flooded.
inline constexpr auto supply_words =
    std::to_array<std::string_view>({"flooded", "inlet_film", "inlet_film_ratio", "inlet_flow"});
inline constexpr auto asperity_model_words =
    std::to_array<std::string_view>({"greenwood_tripp", "greenwood_williamson"});
inline constexpr auto fluid_shear_words = std::to_array<std::string_view>({"eyring", "limiting"});
inline constexpr auto viscosity_law_words =
    std::to_array<std::string_view>({"barus", "ambient", "roelands"});
inline constexpr auto spacing_words = std::to_array<std::string_view>({"log", "lin"});

// The entrainment speeds of a scene, m/s: a list (one number is a list of one), or a range.
struct Speeds {
  std::vector<double> list;  // used when not empty
  double from = 0;
  double to = 0;
  std::size_t count = 0;
  Spacing spacing = Spacing::log;

  std::size_t size() const { return list.empty() ? count : list.size(); }
  bool empty() const { return size() == 0; }
  // The i-th speed; the first and the last of a range are `from` and `to` to the bit.
  double operator[](std::size_t i) const {
    double speed;
    fill(i, std::span(&speed, 1));
    return speed;
  }
  // Fills `speeds` with the speeds in m/s from number `first` on; first + speeds.size() ≤ size().
  // The bits are those of [], and it is far faster.
  void fill(std::size_t first, std::span<double> speeds) const;
};

// Spectral moments of a profile: variances of its heights, slopes and curvatures. 0: not given.
struct SpectralMoments {
  double m0 = 0;  // m²
  double m2 = 0;
  double m4 = 0;  // 1/m²
};

struct Surface {
  double summit_density = 0;         // n, 1/m²; GT: of each face, GW: of the one rough face
  double summit_radius = 0;          // β, m
  double summit_height_sd = 0;       // σ_s, m; GT: of the sum of both faces' summit heights
  double summit_plane_offset = 0;    // D_d/σ_s, mean plane to summit plane
  int offset_planes = 1;             // m: how many faces bring that offset, 0, 1 or 2
  bool gives_offset_planes = false;  // set by readers: the scene gives m
  SpectralMoments moments = {};  // where they are given, the first four numbers follow from them
  // Roughness of both faces together; it is used for Λ alone. Where Ra or the moments are given, Rq
  // follows from them. 0: not given.
  double rms_roughness = 0;      // Rq, m
  double average_roughness = 0;  // Ra, m
  bool has_alike_faces = false;  // the scene gives the roughness of each face, and both are alike

  bool has_moments() const { return moments.m0 > 0; }
  // Without summits the bodies are smooth: the film carries all the load. λ has no σ_s then.
  bool is_smooth() const { return summit_height_sd == 0 && !has_moments(); }
  // Faces whose summits are not known.
  bool has_rq_alone() const { return is_smooth() && (rms_roughness > 0 || average_roughness > 0); }
};

// One of the two bodies. 0: not given.
struct Body {
  double modulus = 0;        // E, Pa
  double poisson_ratio = 0;  // ν
  double radius_x = 0;       // of its face along entrainment, m: > 0 convex, < 0 concave, ∞ flat
  double radius_y = 0;       // of its face across entrainment, m, with the same signs
};

enum class ContactShape : std::uint8_t { circle, ellipse, line };

struct Bodies {
  double effective_modulus = 0;     // E*, Pa: 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂
  double reduced_radius = 0;        // of a circle: R, m; a ball on a flat: the radius of the ball
  double ellipticity = 1;           // of a circle: k, enters the film constant alone
  double radius_x = 0;              // of an ellipse or line: R_x, m
  double radius_y = 0;              // of an ellipse: R_y, m
  double length = 0;                // of a line: L, m
  std::array<Body, 2> bodies = {};  // where they are given, E*, R_x and R_y follow from them

  bool has_bodies() const { return bodies[0].modulus > 0 || bodies[0].radius_x != 0; }
  ContactShape shape() const {
    if (length > 0) return ContactShape::line;
    return radius_x > 0 || bodies[0].radius_x != 0 ? ContactShape::ellipse : ContactShape::circle;
  }
};

// A kinematic viscosity at a temperature. 0: not given.
struct KinematicViscosity {
  double temperature = 0;  // K
  double viscosity = 0;    // ν, m²/s
};

// An oil as its data sheet has it: by two viscosities, or by its grade and index. 0: not given.
struct Oil {
  std::array<KinematicViscosity, 2> viscosities = {};
  double iso_vg = 0;           // ν at 40 °C, mm²/s
  double viscosity_index = 0;  // VI, beside iso_vg
  double density = 0;          // ρ, kg/m³
  double temperature = 0;      // T at which the contact runs, K

  bool is_given() const { return temperature > 0; }
};

enum class ThermalInlet : std::uint8_t { none, gupta };
inline constexpr auto thermal_inlet_words = std::to_array<std::string_view>({"none", "gupta"});

struct Lubricant {
  double viscosity = 0;                 // η₀, Pa·s, at ambient pressure
  double pressure_viscosity = 0;        // α, 1/Pa
  std::optional<double> eyring_stress;  // τ₀, Pa; friction needs it
  Oil oil = {};                         // where it is given, η₀ follows from it
  ThermalInlet thermal = ThermalInlet::none;
  double conductivity = 0;             // k_f, W/(m·K); a heated inlet needs these two
  double temperature_coefficient = 0;  // β = −d ln η/dT, 1/K
};

struct Supply {
  SupplyKind kind = SupplyKind::flooded;
  double value = 0;  // inlet_film: h_oil, m; inlet_film_ratio: h_oil/σ_s; inlet_flow: q, m²/s
};

struct Friction {
  std::optional<double> boundary_coefficient;  // μ_b; friction needs it
  double slide_roll_ratio = 1;                 // S: sliding speed = S·u
  bool gives_slide_roll_ratio = false;         // set by readers: the scene gives S
  FluidShear fluid = FluidShear::eyring;
  ViscosityLaw viscosity = ViscosityLaw::barus;
};

struct Closures {
  AsperityModel asperity = AsperityModel::greenwood_tripp;
  StarvationClosure starvation = StarvationClosure::flooded_inlet;
  bool gives_starvation = false;  // set by readers: the scene gives it
  double damiens_exponent = 3;    // γ of Damiens' closure
  FilmFormula film = FilmFormula::hamrock_dowson_central;
};

struct Scene {
  std::string id;
  double load = 0;    // F, N
  Speeds speeds;      // u, m/s; may be empty where none is needed (onset)
  OutputSet outputs;  // what is asked: as given, or all that the given fields allow
  Surface surface;
  Bodies bodies;
  Lubricant lubricant;
  Supply supply;
  Friction friction;
  Closures closures;
  std::vector<std::string_view> accepted;  // words of limit_words(), validity.hpp: not warned of
};

// The law of a scene's film.
inline const FilmLaw& film_law(const Scene& scene) {
  return film_law(scene.closures.film, scene.bodies.shape() == ContactShape::line);
}

// Are the inputs there that friction alone needs?
inline bool has_friction_inputs(const Scene& scene) {
  return scene.lubricant.eyring_stress.has_value() &&
         scene.friction.boundary_coefficient.has_value();
}

}  // namespace tribo
