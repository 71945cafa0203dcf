// SPDX-License-Identifier: Apache-2.0
#include "tribo/validity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "scene/schema.hpp"
#include "scene/text.hpp"
#include "scene/units.hpp"
#include "tribo/contact_regime.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/onset.hpp"
#include "tribo/smooth_contact.hpp"
#include "tribo/thermal_reduction.hpp"

namespace tribo {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr double not_assumed = std::numeric_limits<double>::quiet_NaN();

// The hardness of rolling bearing steel of 60 HRC, some 700 HV, in Pa.
constexpr double steel_hardness = 7e9;
// E/(1 − ν²) of steel is 209 GPa or more; cast iron, bronze, titanium and all softer have less.
constexpr double least_steel_modulus = 190e9;
// √(kρc) of steel in J/(m² K √s): k = 46 W/(m K), ρ = 7800 kg/m³, c = 470 J/(kg K).
constexpr double steel_thermal_contact = 13e3;
// k_f of mineral oil in W/(m K).
constexpr double oil_conductivity = 0.14;
// β of an oil in 1/K, by common practice.
constexpr double oil_temperature_coefficient = 0.04;
// σ_s/Rq of an isotropic Gaussian face with m₀m₄/m₂² = 1.5. It rises to 1 as m₀m₄/m₂² grows.
constexpr double least_height_ratio = 0.63414;
// A face with a radius of this many m or more counts as flat.
constexpr double flat_radius = 1e3;
// In bearings the radius of a groove is 1.03 to 1.1 times that of its ball. A ratio of 2.06 to 2.2
// means that the diameter of the groove was given.
constexpr double greatest_groove_ratio = 1.2, greatest_diameter_ratio = 2.2;
// A computed ratio may be below its bound by this factor, because of rounding.
constexpr double but_for_rounding = 1 - 1e-9;
// Below this viscosity in mm²/s ASTM D341 has more terms than the line that is used here.
constexpr double least_d341_viscosity = 2;
// Where summits carry less of the load than this, their pressure does not matter.
constexpr double least_share = 0.01;
// Below this λ the load share of the summits is near to A(0).
constexpr double film_parameter_near_none = 0.5;

// A scene with the numbers that limits are computed from.
struct State {
  const Scene& scene;
  SceneUse use;
  ContactShape shape;
  detail::SceneNumbers<double> numbers;
  HertzContact<double> hertz;
  detail::SpeedSpan speeds;
  // The operating points that are judged: at the slowest and the fastest speed, and, where the
  // inlet starves the film, at some speeds in between. Empty without a speed or a film law.
  std::vector<OperatingPoint<double>> points = {};
  // The least Λ above 0 at these points, if Rq is all that is known of the faces.
  double lambda_ratio = not_assumed;
  // A(0), if λ at one of these points is below film_parameter_near_none.
  double share_without_film = not_assumed;
  // For the closure flooded_inlet, whose film collapses at r = 1: the greatest r = h_ff/h_oil at
  // these points, and the greatest ratio of the film by damiens to that by flooded_inlet at r below
  // 1.
  double flooded_over_inlet = not_assumed, film_by_damiens = not_assumed;

  void add(const MixedContact<double>& contact, OperatingPoint<double> point) {
    if (!has_summits() && numbers.rms_roughness > 0) {
      const SmoothContact smooth(contact);
      const double ratio = smooth.value(Output::lambda_ratio, point.speed, point.film);
      if (ratio > 0 && !(lambda_ratio <= ratio)) lambda_ratio = ratio;
      // Where the faces touch, the friction of the oil alone is not that of the contact.
      if (smooth.has_unknown_summits(point.speed, point.film)) point.friction = not_assumed;
    }
    if (contact.supply() != SupplyKind::flooded && point.film_flooded > 0 &&
        scene.closures.starvation == StarvationClosure::flooded_inlet) {
      const double inlet_film =
          contact.inlet_film_parameter(point.speed) * contact.summit_height_sd();
      const double r = point.film_flooded / inlet_film;
      if (!(flooded_over_inlet >= r)) flooded_over_inlet = r;
      const InletLaw<double> damiens{StarvationClosure::damiens, scene.closures.damiens_exponent};
      const double factor = damiens.film_ratio(r) / contact.inlet_law().film_ratio(r);
      if (r < 1 && !(film_by_damiens >= factor)) film_by_damiens = factor;
    }
    const double lambda = point.film_parameter;
    if (has_summits() && lambda > 0 && lambda < film_parameter_near_none)
      share_without_film = contact.sharing().asperity_share(0);
    points.push_back(point);
  }

  bool has_summits() const { return !scene.surface.is_smooth(); }
  bool solves_film() const { return is_of_solved_films(use); }
  bool follows(ViscosityLaw law) const {
    // A solved film takes Barus' law in place of `ambient`, which is meant for friction alone.
    const bool takes_barus = solves_film() && scene.friction.viscosity == ViscosityLaw::ambient;
    const ViscosityLaw own = takes_barus ? ViscosityLaw::barus : scene.friction.viscosity;
    return own == law && (solves_film() || scene.outputs.contains(Output::friction));
  }
};

// The least value above 0 that a number takes over the points. A film of 0 is left out: it has
// collapsed, and the outputs say so.
double least_of_points(const State& state, double OperatingPoint<double>::*number) {
  double least = not_assumed;
  for (const OperatingPoint<double>& point : state.points)
    if (point.*number > 0 && !(least <= point.*number)) least = point.*number;
  return least;
}

// The greatest value of a number over the points at which friction makes heat, and the point where
// it is taken.
struct Hottest {
  double value = not_assumed;
  OperatingPoint<double> point = {};
};
template <class Number>
Hottest hottest(const State& state, const Number& number) {
  Hottest found;
  if (!(state.numbers.slide_roll_ratio > 0)) return found;
  for (const OperatingPoint<double>& point : state.points) {
    const double value = point.friction > 0 ? number(point) : not_assumed;
    if (value > 0 && !(found.value >= value)) found = {value, point};
  }
  return found;
}

// How much hotter the middle of the film is than the faces, τSuh/(8k_f), if the oil is sheared
// alike in all its thickness and the heat leaves through the faces. τA_H is the part of friction
// that comes from the oil (model/README.md, section 8).
double heat_of_film(const State& state) {
  const double given = state.scene.lubricant.conductivity;
  const double conductivity = given > 0 ? given : oil_conductivity;
  return hottest(state,
                 [&](const OperatingPoint<double>& point) {
                   const auto& n = state.numbers;
                   const double solid = n.boundary_coefficient * point.asperity_load_share;
                   const double area = state.hertz.nominal_area * (1 - point.real_area_ratio);
                   const double stress = n.load * (point.friction - solid) / area;
                   const double film = std::max(point.film, 0.0);
                   return stress * n.slide_roll_ratio * point.speed * film / (8 * conductivity);
                 })
      .value;
}

// The heat of friction, μFSu in W.
Hottest heat_of_contact(const State& state) {
  return hottest(state, [&state](const OperatingPoint<double>& point) {
    return point.friction * state.numbers.load * state.numbers.slide_roll_ratio * point.speed;
  });
}

// Tells by how much friction would heat bodies of steel: Blok's 1.11 q √(2b)/(√(kρc)(√u₁ + √u₂)) of
// a band. Its heat is spread as Hertz' pressure is; q is the mean, π/4 of the greatest.
std::string advice_on_flash(const State& state) {
  const Hottest heat = heat_of_contact(state);
  const double slip = state.numbers.slide_roll_ratio, speed = heat.point.speed;
  const double greatest = heat.point.friction * state.hertz.peak_pressure * slip * speed;
  const double speeds =
      std::sqrt(speed) * (std::sqrt(1 + slip / 2) + std::sqrt(std::abs(1 - slip / 2)));
  const double flash = 1.11 * std::numbers::pi / 4 * greatest *
                       std::sqrt(2 * state.hertz.semi_axis_x) / (steel_thermal_contact * speeds);
  return "the contact makes this heat at " + scene_detail::rounded_text(speed) +
         " m/s with S = " + scene_detail::rounded_text(slip) +
         ", and a scene has no conductivity of the bodies: faces of steel would be hotter by "
         "some " +
         scene_detail::rounded_text(flash) + " K; friction and film leave that out";
}

// The plane modulus E/(1 − ν²) of the softer body; its upper bound 2E* if only E* is known.
double softer_modulus(const State& state) {
  double softer = 2 * state.numbers.effective_modulus;
  for (const Body& body : state.scene.bodies.bodies)
    if (body.modulus > 0)
      softer = std::min(softer, body.modulus / (1 - body.poisson_ratio * body.poisson_ratio));
  return softer;
}

std::string advice_on_softer(const State& state) {
  const double modulus = softer_modulus(state);
  const bool is_soft = modulus < 1e9;
  return "the bound is one of bearing steel, and a body is softer: its E/(1 − ν²) is " +
         std::string(state.scene.bodies.bodies[0].modulus > 0 ? "" : "at most ") +
         scene_detail::rounded_text(modulus / (is_soft ? 1e6 : 1e9)) + (is_soft ? " MPa" : " GPa") +
         ", that of steel " + scene_detail::number_text(least_steel_modulus / 1e9) +
         " GPa or more; what it bears is not known, as a scene has no yield stress";
}

// The greatest mean pressure on the summits: their load over their real area. In load sharing, A of
// Greenwood and Tripp's model is the square root of the summits' load over F (model/README.md,
// section 6).
double summit_pressure(const State& state) {
  double greatest = not_assumed;
  for (const OperatingPoint<double>& point : state.points) {
    const double share = point.asperity_load_share;
    if (!(share >= least_share) || !(point.real_area_ratio > 0)) continue;
    const bool is_of_both = state.scene.closures.asperity == AsperityModel::greenwood_tripp;
    const double pressure =
        state.hertz.mean_pressure * (is_of_both ? share * share : share) / point.real_area_ratio;
    if (!(greatest >= pressure)) greatest = pressure;
  }
  return greatest;
}

double roelands_index(const State& state) {
  const double alpha = state.numbers.pressure_viscosity;
  if (alpha == 0 || !state.follows(ViscosityLaw::roelands)) return not_assumed;
  return alpha * roelands_pressure<double>() /
         (std::log(state.numbers.viscosity) + roelands_log_viscosity<double>());
}

// The smaller of the two bodies' radii in a direction, without their signs; the radius of the gap
// where the scene does not give the bodies'.
double smaller_radius(const Scene& scene, double Body::*radius, double of_gap) {
  const auto& [first, second] = scene.bodies.bodies;
  if (first.*radius == 0) return of_gap;
  return std::min(std::abs(first.*radius), std::abs(second.*radius));
}

// The greatest ratio of a semi-axis of the contact to the smaller radius of the bodies in its
// direction.
double slope_at_edge(const State& state) {
  const double along = state.hertz.semi_axis_x /
                       smaller_radius(state.scene, &Body::radius_x, state.numbers.radius_x);
  if (state.shape != ContactShape::ellipse) return along;
  return std::max(along, state.hertz.semi_axis_y /
                             smaller_radius(state.scene, &Body::radius_y, state.numbers.across));
}

// The contact's regime where its film differs most from that of the law's regime, at the slowest or
// the fastest speed, and the ratio of the two films; 1 where both regimes are the law's.
struct RegimeOfFilm {
  LubricationRegime regime;
  double factor;
};
RegimeOfFilm regime_of_film(const State& state) {
  const LubricationRegime own = regime_of(film_law(state.scene));
  RegimeOfFilm furthest{own, 1};
  const std::array ends{state.speeds.low, state.speeds.high};
  for (const double speed : std::span(ends).first(ends[0] == ends[1] ? 1 : 2)) {
    const auto numbers = similarity_of(state.shape, state.numbers, speed);
    const LubricationRegime regime = regime_of(state.shape, state.numbers, numbers);
    const double factor = factor_between(regime, own, state.shape, state.numbers, numbers);
    if (factor > furthest.factor) furthest = {regime, factor};
  }
  return furthest;
}

// The larger radius across the motion over the smaller one, for two convex faces (are_convex), or
// for a convex and a concave one. NaN for other pairs, and where a face is flat.
double radius_ratio(const State& state, bool are_convex) {
  const auto& [first, second] = state.scene.bodies.bodies;
  const double one = std::abs(first.radius_y), other = std::abs(second.radius_y);
  const bool is_asked = (std::min(first.radius_y, second.radius_y) > 0) == are_convex;
  if (!is_asked || one == 0 || std::max(one, other) >= flat_radius) return not_assumed;
  return std::max(one, other) / std::min(one, other);
}

// The radius ratio of two convex faces, if a groove's radius or diameter has this ratio to the
// ball's radius: perhaps one face was meant to be concave. Else NaN.
double convex_groove(const State& state) {
  const double ratio = radius_ratio(state, true);
  const bool is_near = ratio <= greatest_groove_ratio;
  return is_near || (ratio > 2 && ratio <= greatest_diameter_ratio) ? ratio : not_assumed;
}

// The radius ratio of a ball in its groove; NaN for a groove that is far wider.
double concave_groove(const State& state) {
  const double ratio = radius_ratio(state, false);
  return ratio <= greatest_diameter_ratio ? ratio : not_assumed;
}

// The fastest speed at which there is a film that can be heated. A solved film exists at every
// speed.
double fastest_with_film(const State& state) {
  if (state.solves_film()) return state.speeds.high;
  double fastest = not_assumed;
  for (const OperatingPoint<double>& point : state.points)
    if (point.film > 0 && !(fastest >= point.speed)) fastest = point.speed;
  return fastest;
}

std::string advice_on_heating(const State& state) {
  const double speed = fastest_with_film(state);
  const double given = state.scene.lubricant.conductivity;
  const double factor = gupta_thermal_reduction(
      state.hertz.peak_pressure, state.numbers.effective_modulus, 0.0, oil_temperature_coefficient,
      state.numbers.viscosity, speed, given > 0 ? given : oil_conductivity);
  const std::string part =
      factor > 0 ? "by some " + scene_detail::number_text(std::round(100 * (1 - factor))) + " %"
                 : "by more than Gupta's factor can tell";
  return "at " + scene_detail::rounded_text(speed) + " m/s heat makes the film thinner " + part +
         " with β = " + scene_detail::number_text(oil_temperature_coefficient) + "/K" +
         (given > 0 ? ""
                    : " and k_f = " + scene_detail::number_text(oil_conductivity) +
                          " W/(m K) of mineral oil (water has 0.6)") +
         " and no sliding, and by more with sliding; " +
         (state.solves_film() ? "the solved film leaves heat out"
                              : "lubricant.thermal = \"gupta\" computes it");
}

std::string advice_on_viscosity(const State&) {
  return "friction.viscosity = \"roelands\" rises less, and is used up to higher pressures";
}

std::string advice_on_law(const State& state) {
  constexpr std::array of_points{
      std::string_view("the contact is isoviscous_rigid: take nijenbanning_venner_moes"),
      std::string_view("the contact is piezoviscous_rigid: take nijenbanning_venner_moes"),
      std::string_view("the contact is isoviscous_elastic: take hamrock_dowson_soft_central"),
      std::string_view("the contact is piezoviscous_elastic: take hamrock_dowson_central")};
  constexpr std::array of_lines{
      std::string_view("the contact is isoviscous_rigid: take moes_line"),
      std::string_view("the contact is piezoviscous_rigid: take moes_line"),
      std::string_view("the contact is isoviscous_elastic: take moes_line"), std::string_view()};
  const auto regime = static_cast<std::size_t>(regime_of_film(state).regime);
  return std::string(state.shape == ContactShape::line ? of_lines[regime] : of_points[regime]);
}

// A(0) if `planes` faces bring the offset of the summits. Judged only for Greenwood and Tripp's
// model, where both faces are rough alike and the scene does not give the number of faces.
double share_of_planes(const State& state, int planes) {
  const Surface& surface = state.scene.surface;
  const bool are_alike = surface.has_moments() || surface.has_alike_faces;
  const AsperityModel model = state.scene.closures.asperity;
  const auto& n = state.numbers;
  if (surface.gives_offset_planes || !are_alike || !(n.summit_plane_offset > 0) ||
      model != AsperityModel::greenwood_tripp || state.solves_film())
    return not_assumed;
  const AsperityContact<double> contact = asperity_contact(
      model, n.summit_density, n.summit_radius, n.summit_height_sd, planes * n.summit_plane_offset,
      n.effective_modulus, state.hertz.nominal_area, n.load);
  return LoadSharing<double>(model, contact.stiffness, contact.offset).asperity_share(0);
}

// S over μ_b a/R, Carter's creep, from which a dry contact slides everywhere. NaN where summits
// carry too little of the load for their friction to matter.
double sliding_of_summits(const State& state) {
  const auto& n = state.numbers;
  const bool is_asked = state.scene.outputs.contains(Output::friction) && !state.solves_film();
  const auto touches = [](const OperatingPoint<double>& point) {
    return point.asperity_load_share >= least_share && point.friction >= 0;
  };
  if (!is_asked || !(n.boundary_coefficient > 0) ||
      std::none_of(state.points.begin(), state.points.end(), touches))
    return not_assumed;
  return n.slide_roll_ratio * n.radius_x / (n.boundary_coefficient * state.hertz.semi_axis_x);
}

// The factor of a film law that depends on k: 1 − m e^{−nk}.
double part_of_ellipticity(const FilmLaw& law, double k) {
  return 1 - ratio<double>(law.side_leakage) * std::exp(-ratio<double>(law.side_decay) * k);
}

// The advice where the film law was not fitted to the contact's ellipticity.
std::string advice_on_ellipticity(const State& state) {
  const FilmLaw& law = film_law(state.scene);
  const double k = state.hertz.semi_axis_y / state.hertz.semi_axis_x;
  if (k > law.greatest_ellipticity) {
    const double change =
        part_of_ellipticity(law, k) / part_of_ellipticity(law, law.greatest_ellipticity) - 1;
    return "from k = " + scene_detail::number_text(law.greatest_ellipticity) +
           " to this k the film of this law grows by " + scene_detail::rounded_text(100 * change) +
           " % only: accept this of a ball in its groove; a roller is a line: give bodies.length "
           "in place of the radii across the motion, and closures.film = "
           "\"dowson_toyoda_central\"";
  }
  if (least_fitted_ellipticity(law) == 0)
    return "no text tells to which ellipticities the law was fitted; a roller is a line, which "
           "`tribocheck film` solves";
  return "the contact is longer along the motion than across it, and scenes have no law that was "
         "fitted to that: the film is no more than an estimate; `tribocheck film` solves it";
}

double summit_roughness(const State& state) {
  const auto& n = state.numbers;
  return n.summit_density * n.summit_radius * n.summit_height_sd;
}

struct Row {
  std::string_view word, assumption, unit;
  double least, greatest;
  std::string_view source;
  // NaN: the scene does not make this assumption.
  double (*value)(const State&);
  std::string_view touches = "everything";  // of a solved film "pressure", not "friction"
  // The meaning of a limit that is passed, and the advice.
  std::string (*advice)(const State&) = nullptr;
  bool is_of_film_law = false;  // the bounds are those of k of the scene's film law
  bool is_of_steel = false;     // for softer bodies no bounds are known
};

constexpr Row rows[] = {
    {"hertz_pressure",
     "The bodies stay elastic under the peak pressure of Hertz, as bearing steel does.", "Pa", 0,
     4e9,
     "ISO 76: 4 GPa of rollers, 4.2 GPa of balls, leave dents of some 1e-4 of the diameter; other "
     "steel yields at less",
     [](const State& state) { return state.hertz.peak_pressure; }, "everything", nullptr, false,
     true},
    {"half_space", "The contact is far smaller than the radii: a/R is small.", "", 0, 0.5,
     "Johnson, Contact Mechanics (1985), chapter 4: Hertz takes each body for a half-space; the "
     "bound is common practice",
     slope_at_edge},
    {"groove", "Two convex faces that are nearly alike are no ball in its groove.", "", 0, 1,
     "common practice: a groove's radius is 1.03 to 1.1 times that of its ball", convex_groove,
     "everything",
     [](const State& state) {
       return "this is the larger radius across the motion over the smaller one, and both are "
              "convex: the radius of a groove is below 0" +
              std::string(convex_groove(state) > 2 ? ", and half its diameter" : "") +
              "; if they are convex indeed, accept this";
     }},
    {"groove_radius", "A groove is little wider than its ball: the ratio of their radii is near 1.",
     "", 0, greatest_groove_ratio,
     "common practice: a groove's radius is 1.03 to 1.1 times that of its ball", concave_groove,
     "everything",
     [](const State& state) {
       return std::string("this is the groove's radius across the motion over that of the ball") +
              (concave_groove(state) > 2
                   ? ": perhaps the groove's diameter was taken for its radius"
                   : "; if the groove is as wide as that, accept this");
     }},
    {"circular_hertz", "The contact is a circle; k enters the film law alone.", "", 1, 1,
     "Hertz (1882): such bodies touch on a circle; give radius_x and radius_y for an ellipse",
     [](const State& state) {
       return state.shape == ContactShape::circle ? state.numbers.ellipticity : not_assumed;
     },
     "shares, friction"},
    {"line_length", "A line is longer than it is wide: 2b/L is below 1.", "", 0, 1,
     "Johnson, Contact Mechanics (1985), chapter 4: a line is a plane problem; the bound is common "
     "practice",
     [](const State& state) {
       const bool is_line = state.shape == ContactShape::line;
       return is_line ? state.hertz.semi_axis_x / state.hertz.semi_axis_y : not_assumed;
     }},
    {"film_law_ellipticity", "The film law is used at an ellipticity k that it was fitted to.", "",
     0, unbounded, "the law's own paper, which `tribocheck functions` names",
     [](const State& state) {
       // A solved film has no law.
       const bool is_asked = state.shape == ContactShape::ellipse && !state.solves_film();
       return is_asked ? state.hertz.semi_axis_y / state.hertz.semi_axis_x : not_assumed;
     },
     "film", advice_on_ellipticity, true},
    {"film_law_regime", "The film law is one of the contact's regime: their films are alike.", "",
     0, greatest_factor_of_regimes,
     "the maps of regimes: Hamrock (1991) of points, Moes (1992) of lines; next to a border both "
     "films are alike, and formulas scatter by as much",
     [](const State& state) {
       // A law without fixed exponents covers all regimes.
       if (state.solves_film() || !(state.speeds.low > 0) ||
           !film_law(state.scene).has_fixed_exponents())
         return not_assumed;
       return regime_of_film(state).factor;
     },
     "film", advice_on_law},
    {"alpha_p0", "The oil is a liquid up to the peak pressure: α p₀ is no more than 30.", "", 0, 30,
     "e^30 = 1e13: with η₀ = 0.1 Pa·s the viscosity α gives is that of a glass, 1e12 Pa·s by "
     "common practice",
     [](const State& state) {
       const bool is_used = state.follows(ViscosityLaw::barus);
       return is_used ? state.numbers.pressure_viscosity * state.hertz.peak_pressure : not_assumed;
     },
     "friction", advice_on_viscosity},
    {"barus", "The viscosity rises by Barus' law up to the pressure in the film.", "Pa", 0, 1e9,
     "common practice: at 1 GPa Roelands' law (1966) has an oil of 20 mPa·s and α = 20/GPa 400 "
     "times thinner",
     [](const State& state) {
       if (!(state.numbers.pressure_viscosity > 0) || !state.follows(ViscosityLaw::barus))
         return not_assumed;
       return state.solves_film() ? state.hertz.peak_pressure : state.hertz.mean_pressure;
     },
     "friction", advice_on_viscosity},
    {"roelands_index", "Roelands' exponent z, from α and η₀, is one of an oil.", "", 0.2, 1.2,
     "common practice: mineral oils have z near 0.6, synthetic liquids 0.4 to 1", roelands_index,
     "friction"},
    {"elastic_summits",
     "The summits stay elastic under their mean pressure, as bearing steel does.", "Pa", 0,
     0.4 * steel_hardness,
     "Tabor (1951): a sphere of yield stress Y begins to flow at a mean pressure of 1.1 Y, 0.4 of "
     "its hardness, which is 7 GPa of bearing steel",
     summit_pressure, "shares, friction", nullptr, false, true},
    {"summit_roughness", "nβσ_s of the summits is one of a ground or polished face.", "", 1e-3, 1,
     "common practice: 0.03 to 0.05 is quoted of Greenwood and Tripp (1970)",
     [](const State& state) {
       return state.has_summits() && !state.solves_film() ? summit_roughness(state) : not_assumed;
     },
     "shares, friction"},
    {"summit_capacity", "The summits can carry the whole load: A(0) is 1 or more.", "", 1,
     unbounded,
     "Greenwood and Tripp (1970); Gelinck and Schipper (2000): A(0) is their share without a film",
     [](const State& state) { return state.share_without_film; }, "shares, friction",
     [](const State&) {
       return std::string(
           "at low speed friction comes out below the boundary coefficient, as the summits carry "
           "no more than this part of the load even with no film");
     }},
    {"default_planes", "One face alone brings the offset of the summits, or both bring as much.",
     "", 0, 1.2,
     "Greenwood and Tripp (1970): A(0) with offset_planes = 2, of two faces that are rough alike, "
     "over that with 1, the default; the bound is this project's",
     [](const State& state) { return share_of_planes(state, 2) / share_of_planes(state, 1); },
     "shares, friction",
     [](const State& state) {
       return "surface.offset_planes is not given, and 1 is taken: with 2, as both faces are rough "
              "alike, A(0) would be " +
              scene_detail::rounded_text(share_of_planes(state, 2)) + " in place of " +
              scene_detail::rounded_text(share_of_planes(state, 1)) +
              ", and the summits would carry more at each film; give it";
     }},
    {"rough_as_smooth", "Faces without summits do not touch: Λ is 3 or more.", "",
     least_full_film_lambda_ratio, unbounded, "common practice: a full film from Λ = 3 on",
     [](const State& state) { return state.lambda_ratio; }, "shares, friction",
     [](const State&) {
       return std::string(
           "this is Λ: the faces touch, and Rq alone does not say what the summits carry: shares, "
           "friction and regime are undefined there; give summits or spectral moments");
     }},
    {"gaussian_profile", "The face is isotropic and Gaussian: m₀m₄/m₂² is 1.5 or more.", "",
     least_isotropic_bandwidth* but_for_rounding, unbounded,
     "Longuet-Higgins (1957), by Cauchy and Schwarz: m₀, 2m₂ and 8m₄/3 are moments of one spectrum",
     [](const State& state) {
       const auto& [m0, m2, m4] = state.scene.surface.moments;
       return m0 > 0 && !state.solves_film() ? m0 / m2 * (m4 / m2) : not_assumed;
     },
     "shares, friction"},
    {"summit_heights", "The heights of the summits vary a little less than the faces: σ_s/Rq.", "",
     0.9 * least_height_ratio, 1.1,
     "McCool (1987), after Nayak (1971): √(1 − 0.8968/α), which is 0.634 to 1 of an isotropic "
     "Gaussian "
     "face; 10 % of room",
     [](const State& state) {
       const bool are_given = state.has_summits() && !state.scene.surface.has_moments() &&
                              state.numbers.rms_roughness > 0;
       return are_given && !state.solves_film()
                  ? state.numbers.summit_height_sd / state.numbers.rms_roughness
                  : not_assumed;
     },
     "shares, friction",
     [](const State&) {
       return std::string(
           "surface.summit_height_sd and the roughness contradict each other; both are of the two "
           "faces together, √(x₁² + x₂²)");
     }},
    {"summit_offset", "(D_d/σ_s) nβσ_s is that of an isotropic Gaussian face.", "",
     0.9 * offset_times_roughness, 1.1 * offset_times_roughness,
     "McCool (1987), after Nayak (1971): 1/(4π√3) whatever the moments; give m0, m2 and m4",
     [](const State& state) {
       const double product = state.numbers.summit_plane_offset * summit_roughness(state);
       const bool is_given = product > 0 && !state.scene.surface.has_moments();
       return is_given && !state.solves_film() ? product : not_assumed;
     },
     "shares, friction"},
    {"film_below_molecule", "The film is thick enough to be a liquid, not a few molecules.", "m",
     1e-9, unbounded,
     "Christenson and others, J. Chem. Phys. 87 (1987) 1834: alkanes lie in layers of the width of "
     "their chain, 0.4 nm to 0.5 nm; two of them",
     [](const State& state) { return least_of_points(state, &OperatingPoint<double>::film); },
     "film"},
    {"smooth_film_law", "The film law, which is one of smooth faces, holds at λ = h/σ_s.", "", 0.5,
     unbounded,
     "common practice: flow factors of isotropic rough faces are quoted of Patir and Cheng (1978) "
     "from h/σ = 0.5 on",
     [](const State& state) {
       const bool is_rough = state.has_summits();
       return is_rough ? least_of_points(state, &OperatingPoint<double>::film_parameter)
                       : not_assumed;
     },
     "film"},
    {"inlet_heating", "Shear does not heat the oil in the inlet: η₀u²/k_f is a few kelvin.", "K", 0,
     10,
     "common practice: with β = 0.04/K these 10 K make L = βη₀u²/k_f of Gupta and others (1992) "
     "0.4; mineral oil has 0.14 W/(m K)",
     [](const State& state) {
       const double speed = fastest_with_film(state);
       const bool is_heated = state.scene.lubricant.thermal != ThermalInlet::none;
       if (!(speed > 0) || (is_heated && !state.solves_film())) return not_assumed;
       const double given = state.scene.lubricant.conductivity;
       return state.numbers.viscosity * speed * speed / (given > 0 ? given : oil_conductivity);
     },
     "film", advice_on_heating},
    {"thermal_reduction", "Gupta's factor is far from its 0: 13.2 (p₀/E′) L^0.42 is small.", "", 0,
     0.5,
     "Gupta and others (1992): at 1 the factor, a fit, is 0, and no film is left; half of that is "
     "this project's bound",
     [](const State& state) {
       const bool is_heated = state.scene.lubricant.thermal == ThermalInlet::gupta;
       if (!is_heated || state.solves_film() || !(state.speeds.high > 0)) return not_assumed;
       const auto& n = state.numbers;
       const double heating = n.temperature_coefficient * n.viscosity * state.speeds.high *
                              state.speeds.high / n.conductivity;
       return 13.2 * state.hertz.peak_pressure / (2 * n.effective_modulus) *
              std::pow(heating, 0.42);
     },
     "film",
     [](const State&) {
       return std::string("at 1 and above the film is undefined; ask for lower speeds");
     }},
    {"film_heating", "Sliding does not heat the oil in the contact: τSuh/(8k_f) is a few kelvin.",
     "K", 0, 10,
     "steady conduction: oil that is sheared alike in all its thickness is hotter by this in its "
     "middle than at the faces; A. W. Crook, The lubrication of rollers III, Phil. Trans. R. Soc. "
     "A 254 (1961) 237, is about such temperatures (its text was not at hand); the bound is that "
     "of inlet_heating",
     heat_of_film, "friction",
     [](const State& state) {
       return std::string("friction comes out too high, as hot oil is thinner") +
              (state.scene.lubricant.conductivity > 0
                   ? ""
                   : "; k_f is that of mineral oil, as lubricant.conductivity is not given");
     }},
    {"flash_temperature", "The faces stay as cold as the oil: sliding does not heat them.", "W", 0,
     unbounded,
     "H. Blok, Theoretical study of temperature rise at surfaces of actual contact under oiliness "
     "lubricating conditions, Proc. Inst. Mech. Eng. Gen. Disc. Lubr. 2 (1937) 222: a band, which "
     "needs √(kρc) of both bodies; its 1.11 is of heat spread as by Hertz (T. A. Stolarski, "
     "Tribology in Machine Design, page 76)",
     [](const State& state) { return heat_of_contact(state).value; }, "friction", advice_on_flash},
    {"default_sliding", "The sliding, which the scene leaves to the default, is that of a machine.",
     "", 0, 0.5,
     "common practice: S is 0.01 to 0.05 in rolling bearings, 0 to 0.5 in gears; the default is "
     "the published model's",
     [](const State& state) {
       const bool is_used = state.scene.outputs.contains(Output::friction) &&
                            state.scene.lubricant.thermal == ThermalInlet::none;
       const bool is_left = !state.scene.friction.gives_slide_roll_ratio;
       return is_used && is_left && !state.solves_film() ? state.numbers.slide_roll_ratio
                                                         : not_assumed;
     },
     "friction",
     [](const State&) {
       return std::string(
           "the scene has no friction.slide_roll_ratio, S: 1 is taken, as much sliding as rolling, "
           "with more friction than in a bearing; give S, and be it 1");
     }},
    {"boundary_sliding",
     "The summits slide: S is above the creep μ_b a/R, at which a dry contact does.", "", 1,
     unbounded,
     "Johnson, Contact Mechanics (1985), chapter 8: Carter's creep of a dry band; this is S over "
     "it",
     sliding_of_summits, "friction",
     [](const State&) {
       return std::string(
           "friction still has μ_b A, as if the summits slid: in pure rolling they hardly do, and "
           "it comes out too high");
     }},
    {"opposite_motion", "Both faces move in the same direction: S is 2 or less.", "", 0, 2,
     "at S = 2 one face stands; beyond it films have dimples: Kaneta and others, J. Tribol. 118 "
     "(1996) 886, Guo and others, J. Tribol. 123 (2001) 816",
     [](const State& state) {
       const bool is_heated = state.scene.lubricant.thermal != ThermalInlet::none;
       const bool is_used = is_heated || state.scene.outputs.contains(Output::friction);
       return is_used && !state.solves_film() ? state.numbers.slide_roll_ratio : not_assumed;
     },
     "film",
     [](const State&) {
       return std::string(
           "this is S, sliding over the mean speed, and no percentage; if the faces move in "
           "opposite directions indeed, no law of films here is fitted to that");
     }},
    {"inlet_supply", "The oil before the contact is enough for a film: h_ff/h_oil is below 1.", "",
     0, 1, "Crook (1958); Wolveridge and others (1971): the film of flooded_inlet collapses at 1",
     [](const State& state) { return state.flooded_over_inlet; }, "everything",
     [](const State& state) {
       return "the film has collapsed: closures.starvation is flooded_inlet, " +
              std::string(state.scene.closures.gives_starvation ? "" : "the default, ") +
              "which is of an inlet with nearly enough oil; starved_inlet and damiens leave a film";
     }},
    {"default_inlet",
     "The law of the inlet, which the scene leaves to the default, matters little.", "", 0,
     greatest_factor_of_regimes,
     "Damiens and others (2004): the film by damiens over that by flooded_inlet; formulas of "
     "films scatter by as much",
     [](const State& state) {
       return state.scene.closures.gives_starvation ? not_assumed : state.film_by_damiens;
     },
     "film",
     [](const State&) {
       return std::string(
           "the scene gives a supply and no closures.starvation: flooded_inlet is taken, and by "
           "damiens the film would be thicker by this factor; give the law");
     }},
    {"oil_viscosity", "The oil's viscosity is one of the line of ASTM D341.", "mm²/s",
     least_d341_viscosity, unbounded,
     "ASTM D341: below 2 mm²/s its line in log log (ν + 0.7) has more terms, which are left out",
     [](const State& state) {
       const Oil& oil = state.scene.lubricant.oil;
       if (!oil.is_given()) return not_assumed;
       double least = 1e6 * state.numbers.viscosity / oil.density;
       for (const KinematicViscosity& one : oil.viscosities)
         if (one.viscosity > 0) least = std::min(least, 1e6 * one.viscosity);
       return least;
     },
     "everything",
     [](const State&) {
       return std::string("give lubricant.viscosity as it is measured at this temperature");
     }},
};

// --- The ranges of fields.

// The word of a field's range; empty where its numbers have none. Fields of the table `speed`
// share the word of `speed`.
std::string word_of(const FieldInfo& field) {
  const bool is_number = field.type == FieldType::number || field.type == FieldType::speeds;
  const bool has_range = field.plausible_minimum != 0 || field.plausible_maximum < unbounded;
  if (!is_number || !has_range || field.path.starts_with("speed.")) return {};
  return std::string(scene_detail::last_part(field.path)) + "_range";
}

// For each field the word of its range.
const std::vector<std::string>& range_words() {
  static const std::vector<std::string> words = [] {
    std::vector<std::string> made;
    for (const FieldInfo& field : scene_fields()) made.push_back(word_of(field));
    return made;
  }();
  return words;
}

// The unit that was probably meant; empty where the value would not be in range with it either.
std::string_view likely_unit(const FieldInfo& field, double value) {
  for (std::string_view units = field.likely_unit; !units.empty();) {
    const std::string_view unit = units.substr(0, units.find(", "));
    units.remove_prefix(std::min(unit.size() + 2, units.size()));
    const auto decimal = scene_detail::si_decimal(
        scene_detail::number_text(value) + ' ' + std::string(unit), field.unit);
    const double meant = decimal ? std::strtod(decimal->c_str(), nullptr) : unbounded;
    if (meant >= field.plausible_minimum && meant <= field.plausible_maximum) return unit;
  }
  return {};
}

// Does the number of a field follow from other numbers of the scene?
bool follows_from_others(const Scene& scene, std::string_view path) {
  const Body& body = scene.bodies.bodies[0];
  if (path == "bodies.effective_modulus") return body.modulus > 0;
  if (path == "bodies.radius_x") return body.radius_x != 0;
  if (path == "bodies.radius_y") return body.radius_y != 0;
  if (path == "lubricant.viscosity") return scene.lubricant.oil.is_given();
  if (path == "surface.rms_roughness")
    return scene.surface.average_roughness > 0 || scene.surface.has_moments();
  return path.starts_with("surface.summit_") && scene.surface.has_moments();
}

bool accepts(const Scene& scene, std::string_view word) {
  return std::find(scene.accepted.begin(), scene.accepted.end(), word) != scene.accepted.end();
}

// The outputs that limits on points are computed from.
OutputSet validity_outputs(const Scene& scene) {
  OutputSet outputs;
  for (const Output output : {Output::film_flooded, Output::film, Output::film_parameter,
                              Output::asperity_load_share, Output::real_area_ratio})
    outputs.insert(output);
  if (scene.outputs.contains(Output::friction)) outputs.insert(Output::friction);
  return outputs;
}

// Adds the points that are judged. A film that starves becomes thinner again at high speed.
// Therefore the last speed that has a film is judged too, and the 1st, 3rd, 7th … speed before it:
// the steps are small next to the collapse, where the film changes fastest.
void add_points(State& state) {
  const MixedContact<double> contact(state.scene);
  const auto film_at = [&](double speed) {
    state.add(contact, contact.solve(speed, validity_outputs(state.scene)));
    return state.points.back().film;
  };
  const bool has_film = film_at(state.speeds.low) > 0;
  if (!(state.speeds.high > state.speeds.low)) return;
  const bool has_last_film = film_at(state.speeds.high) > 0;
  if (!has_film || contact.supply() == SupplyKind::flooded) return;
  std::vector<double> list = state.scene.speeds.list;
  std::sort(list.begin(), list.end());
  const auto speed = [&](std::size_t i) { return list.empty() ? state.scene.speeds[i] : list[i]; };
  const std::size_t fastest = state.scene.speeds.size() - 1;
  std::size_t last = has_last_film ? fastest : 0, beyond = fastest;
  while (!has_last_film && beyond - last > 1) {
    const std::size_t middle = last + (beyond - last) / 2;
    (film_at(speed(middle)) > 0 ? last : beyond) = middle;
  }
  for (std::size_t before = has_last_film ? 1 : 0; before <= last; before = 2 * before + 1)
    film_at(speed(last - before));
}

State state_of(const Scene& scene, SceneUse use) {
  const auto numbers = detail::numbers_of<double>(scene);
  const ContactShape shape = scene.bodies.shape();
  State state{
      scene, use, shape, numbers, hertz_contact(shape, numbers), detail::speed_span(scene.speeds)};
  if (!state.solves_film() && state.speeds.low > 0) add_points(state);
  return state;
}

// Takes the range of a field if the value is outside of it.
template <class Take>
void take_range(const Scene& scene, const FieldInfo& field, std::string_view word, double value,
                const Take& take) {
  if (value >= field.plausible_minimum && value <= field.plausible_maximum) [[likely]]
    return;
  if (field.is_radius_of_face && value >= flat_radius) return;
  const bool follows = follows_from_others(scene, field.path);
  take(Validity{.word = word,
                .assumption = field.meaning,
                .value = value,
                .least = field.plausible_minimum,
                .greatest = field.plausible_maximum,
                .unit = field.unit,
                .field = field.path,
                .likely_unit = follows ? std::string_view() : likely_unit(field, value),
                .value_follows = follows,
                .is_accepted = accepts(scene, word)});
}

// The ranges of fields that the scene leaves.
std::vector<Validity> ranges_left(const Scene& scene) {
  std::vector<Validity> left;
  const auto take = [&left](const Validity& one) { left.push_back(one); };
  const auto fields = scene_fields();
  const std::vector<std::string>& words = range_words();
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::string& word = words[i];
    if (word.empty()) continue;
    if (fields[i].type != FieldType::speeds) {
      const std::optional<double> value = scene_detail::value_in(scene, i);
      if (value && *value != 0) take_range(scene, fields[i], word, *value, take);
      continue;
    }
    const auto [low, high] = detail::speed_span(scene.speeds);
    if (low > 0) take_range(scene, fields[i], word, low, take);
    if (high > low) take_range(scene, fields[i], word, high, take);
  }
  return left;
}

// Is a number outside of its range, and would another unit bring it inside? Then no advice is given
// on what follows from the number.
bool has_likely_slip(const std::vector<Validity>& ranges) {
  return std::any_of(ranges.begin(), ranges.end(), [](const Validity& one) {
    return !one.likely_unit.empty() && !one.is_accepted;
  });
}

// Which limits are taken: all assumptions, or those that are passed and not accepted.
enum class Which : std::uint8_t { all, not_passed };

template <class Take>
void take_assumptions(const State& state, Which which, bool has_slip, const Take& take) {
  for (const Row& row : rows) {
    const double value = row.value(state);
    if (std::isnan(value)) continue;
    double least = row.least, greatest = row.greatest;
    if (row.is_of_film_law) {
      const FilmLaw& law = film_law(state.scene);
      least = least_fitted_ellipticity(law);
      greatest = law.greatest_ellipticity;
      // Any law of points was fitted to circles.
      if (least == 0 && value >= but_for_rounding && value <= 1 / but_for_rounding)
        least = but_for_rounding, greatest = 1 / but_for_rounding;
    }
    auto advice = row.advice;
    if (row.is_of_steel && softer_modulus(state) < least_steel_modulus) {
      least = 0;
      greatest = unbounded;
      advice = advice_on_softer;
    }
    const bool is_known = least != 0 || greatest < unbounded;
    const bool holds = value >= least && value <= greatest;
    const bool is_accepted = accepts(state.scene, row.word);
    if (which == Which::not_passed && (holds || is_accepted)) continue;
    const bool is_advised = advice != nullptr && !(is_known && holds) && !has_slip;
    take(Validity{
        .word = row.word,
        .assumption = row.assumption,
        .value = value,
        .least = least,
        .greatest = greatest,
        .unit = row.unit,
        .source = row.source,
        .touches = state.solves_film() && row.touches == "friction" ? "pressure" : row.touches,
        .advice = is_advised ? advice(state) : std::string(),
        .is_accepted = is_accepted});
  }
}

std::vector<Validity> passed_in(const State& state) {
  std::vector<Validity> passed;
  const auto take = [&passed](const Validity& one) {
    if (one.is_passed()) passed.push_back(one);
  };
  const std::vector<Validity> ranges = ranges_left(state.scene);
  take_assumptions(state, Which::not_passed, has_likely_slip(ranges), take);
  std::for_each(ranges.begin(), ranges.end(), take);
  return passed;
}

}  // namespace

double Validity::limit() const {
  return value < least || !(greatest < unbounded) ? least : greatest;
}

double least_fitted_ellipticity(const FilmLaw& law) {
  return law.least_ellipticity * but_for_rounding;
}

std::span<const std::string_view> limit_words() {
  static const std::vector<std::string_view> words = [] {
    std::vector<std::string_view> made;
    for (const Row& row : rows) made.push_back(row.word);
    for (const std::string& word : range_words())
      if (!word.empty()) made.push_back(word);
    return made;
  }();
  return words;
}

std::span<const std::string_view> assumption_words() {
  return limit_words().first(std::size(rows));
}

std::vector<Validity> validity_of(const Scene& scene, SceneUse use) {
  std::vector<Validity> all;
  const auto take = [&all](const Validity& one) { all.push_back(one); };
  const std::vector<Validity> ranges = ranges_left(scene);
  take_assumptions(state_of(scene, use), Which::all, has_likely_slip(ranges), take);
  std::for_each(ranges.begin(), ranges.end(), take);
  return all;
}

std::vector<Validity> passed_limits(const Scene& scene, SceneUse use) {
  return passed_in(state_of(scene, use));
}

std::vector<Validity> passed_limits(const Scene& scene, const MixedContact<double>& contact,
                                    const OperatingPoint<double>& point) {
  State state{
      scene,           SceneUse::one_speed,       scene.bodies.shape(), contact.scene_numbers(),
      contact.hertz(), {point.speed, point.speed}};
  state.add(contact, point);
  return passed_in(state);
}

}  // namespace tribo
