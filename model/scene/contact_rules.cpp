// SPDX-License-Identifier: Apache-2.0
#include "scene/contact_rules.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "scene/schema.hpp"
#include "scene/text.hpp"
#include "tribo/film_thickness.hpp"
#include "tribo/friction.hpp"
#include "tribo/hertz_contact.hpp"
#include "tribo/oil.hpp"
#include "tribo/onset.hpp"

namespace tribo::scene_detail {
namespace {

std::string_view film_word(const Scene& scene) {
  return film_formula_words[static_cast<std::size_t>(scene.closures.film)];
}

void check_pair(const std::string& direction, double first, double second, Problems& problems) {
  const double radius = relative_radius(first, second);
  if (radius > 0 && radius < 1e20) return;  // two flat faces have 1e30 or ∞
  const std::string one = "first_radius_" + direction, other = "second_radius_" + direction;
  std::string allowed = "1/" + one + " + 1/" + other + " above 0";
  if (direction == "y") allowed += ", or length in place of both radii, for a line";
  if (std::min(first, second) < 0 && std::max(first, second) > 0)
    allowed += "; the groove's radius must be larger than the ball's";
  constexpr double slip = 100;  // above this ratio one radius has a wrong unit
  const double convex = std::max(first, second), groove = -std::min(first, second);
  if (groove > 0 && convex > slip * groove)
    allowed += "; perhaps \"" + number_text(convex) + " mm\" was meant";
  problems.error("bodies." + one, {Fault::together, number_text(first),
                                   " beside " + other + ", which is " + number_text(second) +
                                       ": the faces do not meet at a point",
                                   allowed});
}

// Refuses two faces that meet neither at a point nor along a line.
void check_faces(const Scene& scene, Problems& problems) {
  const auto& [first, second] = scene.bodies.bodies;
  if (first.radius_x != 0) check_pair("x", first.radius_x, second.radius_x, problems);
  if (first.radius_y != 0) check_pair("y", first.radius_y, second.radius_y, problems);
}

void check_line(const Bodies& bodies, Problems& problems) {
  const ContactShape shape = bodies.shape();
  if (shape == ContactShape::line) return;
  const bool is_circle = shape == ContactShape::circle;
  const std::string_view radius = is_circle                        ? "reduced_radius"
                                  : bodies.bodies[0].radius_y != 0 ? "first_radius_y"
                                                                   : "radius_y";
  problems.error("bodies." + std::string(radius),
                 {Fault::other, "",
                  std::string("this is the contact of ") + (is_circle ? "a circle" : "an ellipse") +
                      ", and a sweep solves films of line contacts alone",
                  "radius_x and length, or first_radius_x, second_radius_x and length"});
}

// Refuses a law of points for a line, a law of lines for any other contact, and solved films for an
// ellipse.
void check_film(const Scene& scene, bool is_given, Problems& problems) {
  const ContactShape shape = scene.bodies.shape();
  const bool is_line = shape == ContactShape::line;
  const auto takes = [&](const NamedFilmLaw& named) {
    const FilmLaw* const law = named.of(is_line);
    return law != nullptr && !(law->is_solved() && shape == ContactShape::ellipse);
  };
  const NamedFilmLaw& own = named_film_laws[static_cast<std::size_t>(scene.closures.film)];
  if (takes(own)) return;
  std::vector<std::string_view> fitting;
  for (const NamedFilmLaw& named : named_film_laws)
    if (takes(named)) fitting.push_back(named.word);
  const std::string contact = own.of(is_line) != nullptr
                                  ? "the contact is an ellipse, and films of circles and of lines "
                                    "alone are solved as a table"
                              : is_line ? "the contact is a line (bodies.length)"
                                        : "the contact is no line";
  problems.error(
      "closures.film",
      {is_given ? Fault::together : Fault::presence, '"' + std::string(film_word(scene)) + '"',
       ": " + contact,
       joined(fitting, " or ") + (is_line ? "; `tribocheck film` tells how far off each is" : "")});
}

// Refuses closures.starvation = "solved" unless the contact is a circle and closures.film is
// "solved".
void check_inlet(const Scene& scene, Problems& problems) {
  if (scene.closures.starvation != StarvationClosure::solved) return;
  if (scene.bodies.shape() != ContactShape::circle)
    problems.error("closures.starvation",
                   {Fault::together, "\"solved\"",
                    ": the contact is no circle, and starved films of circles alone are a table",
                    "reduced_radius, or another law of the inlet"});
  else if (scene.closures.film != FilmFormula::solved)
    problems.error("closures.starvation",
                   {Fault::together, "\"solved\"",
                    " with closures.film = \"" + std::string(film_word(scene)) +
                        "\": starved films were solved beside flooded ones",
                    "closures.film = \"solved\", or another law of the inlet"});
}

// Refuses a constant viscosity for a law that then has no film or no minimum film. Refuses an
// ellipticity other than 1 for a law that takes radii.
void check_rise(const Scene& scene, Problems& problems) {
  const FilmLaw& law = film_law(scene);
  if (!law.has_fixed_exponents() && scene.bodies.shape() == ContactShape::circle &&
      scene.bodies.ellipticity != 1)
    problems.error(
        "bodies.ellipticity",
        {Fault::together, number_text(scene.bodies.ellipticity),
         " with closures.film = \"" + std::string(film_word(scene)) + "\", which takes radii",
         law.is_solved()
             ? "1"
             : "1, or radius_x and radius_y in place of reduced_radius and ellipticity"});
  if (scene.lubricant.pressure_viscosity > 0 || law.takes_constant_viscosity()) return;
  std::vector<std::string_view> fitting;
  for (const NamedFilmLaw& named : named_film_laws) {
    const FilmLaw* const other = named.of(law.is_of_lines);
    const bool fits = other != nullptr && other->takes_constant_viscosity() &&
                      !(other->is_solved() && scene.bodies.shape() == ContactShape::ellipse);
    if (fits) fitting.push_back(named.word);
  }
  problems.error("lubricant.pressure_viscosity",
                 {Fault::together, "0",
                  " with closures.film = \"" + std::string(film_word(scene)) +
                      (law.has_fixed_exponents() ? "\", whose film would be 0"
                                                 : "\", whose minimum_film would be 0"),
                  "a number above 0, in 1/Pa, or closures.film = " + joined(fitting, " or ")});
}

void check_profile(const Scene& scene, Problems& problems) {
  if (!scene.surface.has_moments()) return;
  const auto& [m0, m2, m4] = scene.surface.moments;
  const Summits<double> summits = summits_from_spectral_moments(m0, m2, m4);
  if (!(summits.bandwidth > 0))
    problems.error(
        "surface.m4",
        {Fault::together, number_text(m4), ": m0 · m4/m2² = " + rounded_text(m0 / m2 * (m4 / m2)),
         "a number that makes it above " + number_text(ratio<double>(bandwidth_without_summits)) +
             ", and " + number_text(least_isotropic_bandwidth) +
             " or more of an isotropic Gaussian face"});
}

// Refuses a temperature at which no oil is a liquid: probably °C was meant.
void check_temperature(double temperature, std::string_view field, Problems& problems) {
  constexpr double coldest = 150;
  if (!(temperature > 0 && temperature < coldest)) return;
  problems.error(field, {Fault::other, "",
                         number_text(temperature) + " K is " +
                             rounded_text(std::round(temperature - 273.15)) + " °C",
                         "\"" + number_text(temperature) + " °C\", or a number from " +
                             number_text(coldest) + " on, in K"});
}

// Refuses an oil whose two viscosities give no line of D341.
void check_oil(const Oil& oil, Problems& problems) {
  if (!oil.is_given()) return;
  check_temperature(oil.temperature, "lubricant.temperature", problems);
  const double colder = std::min(oil.viscosities[0].temperature, oil.viscosities[1].temperature);
  check_temperature(colder, "lubricant.kinematic_viscosity", problems);
  if (problems.any()) return;
  const auto [first, second] = viscosities_of(oil);
  if (oil.iso_vg > 0) {
    if (second.viscosity == 0)
      problems.error("lubricant.viscosity_index",
                     {Fault::together, number_text(oil.viscosity_index),
                      " of ISO VG " + number_text(oil.iso_vg) +
                          ": at 100 °C it would have less than 2 or more than 1000 mm²/s, for "
                          "which there is no index",
                      "another index, or kinematic_viscosity at two temperatures"});
    return;
  }
  const bool falls =
      (second.temperature > first.temperature) == (second.viscosity < first.viscosity) &&
      second.temperature != first.temperature;
  const auto is_thick = [](double viscosity) { return 1e6 * viscosity + 0.7 > 1; };
  if (!falls || !is_thick(first.viscosity) || !is_thick(second.viscosity))
    problems.error("lubricant.kinematic_viscosity",
                   {Fault::together, "", ": from these two follows no viscosity by ASTM D341",
                    "two temperatures in K, and above 3e-7 m²/s, the less the warmer"});
}

// Refuses an oil too thin for Roelands' law, and a heated inlet beyond Gupta's factor.
void check_liquid(const Scene& scene, const Numbers& numbers, Problems& problems) {
  const Lubricant& lubricant = scene.lubricant;
  if (lubricant.oil.is_given() && scene.friction.viscosity == ViscosityLaw::roelands &&
      !(numbers.viscosity > least_roelands_viscosity))
    problems.error("lubricant.temperature",
                   {Fault::result, "",
                    "the viscosity that follows is " + rounded_text(numbers.viscosity) +
                        " Pa·s, too little for friction.viscosity = \"roelands\"",
                    "a number that makes it above " + number_text(least_roelands_viscosity)});
  const double speed = detail::speed_span(scene.speeds).high;
  if (lubricant.thermal == ThermalInlet::none || speed == 0) return;
  const HertzContact<double> hertz = hertz_contact(scene.bodies.shape(), numbers);
  const double factor = gupta_thermal_reduction(
      hertz.peak_pressure, numbers.effective_modulus, numbers.slide_roll_ratio,
      numbers.temperature_coefficient, numbers.viscosity, speed, numbers.conductivity);
  if (!(factor > 0))
    problems.error(
        "lubricant.thermal",
        {Fault::together, "\"gupta\"",
         " at " + number_text(speed) + " m/s: 13.2 (p₀/E′) L^0.42 of its law is 1 or more",
         "a speed, pressure and viscosity that make it less, or none"});
}

// Refuses radii so far apart that the axes are beyond double.
void check_ellipse(const Scene& scene, const Numbers& numbers, Problems& problems) {
  if (scene.bodies.shape() != ContactShape::ellipse) return;
  const double cube = numbers.ellipse.axis_cube, ratio = numbers.ellipse.axes_ratio;
  if (cube > 0 && std::isfinite(cube) && ratio > 0 && std::isfinite(ratio)) return;
  problems.error(
      "bodies.radius_y",
      {Fault::together, rounded_text(numbers.across),
       " beside R_x = " + rounded_text(numbers.radius_x) + " m",
       "a ratio of the two that double can hold, or length in place of R_y, for a line"});
}

// Refuses legal bodies, moments and oils from which a number follows that overflows or underflows.
void check_derived(const Scene& scene, const Numbers& numbers, Problems& problems) {
  const auto check = [&](bool is_derived, std::string_view field, std::string_view what,
                         double number) {
    if (is_derived && !std::isnormal(number))
      problems.error(field, {Fault::result, "",
                             std::string(what) + " that follows is " + rounded_text(number) +
                                 ", which double precision cannot hold",
                             "a number that makes it 2.3e-308 to 1.7e+308"});
  };
  const bool has_moments = scene.surface.has_moments();
  check(has_moments, "surface.m4", "the summit density", numbers.summit_density);
  check(has_moments, "surface.m4", "the summit radius", numbers.summit_radius);
  check(has_moments, "surface.m0", "the standard deviation of the summits' heights",
        numbers.summit_height_sd);
  const auto& [first, second] = scene.bodies.bodies;
  check(scene.lubricant.oil.is_given(), "lubricant.temperature", "the viscosity",
        numbers.viscosity);
  check(first.modulus > 0, "bodies.first_modulus", "the effective modulus",
        numbers.effective_modulus);
  check(first.radius_x != 0, "bodies.first_radius_x", "the reduced radius R_x", numbers.radius_x);
  check(first.radius_y != 0, "bodies.first_radius_y", "the reduced radius R_y", numbers.across);
}

}  // namespace

std::optional<Numbers> check_contact(const Scene& scene, SceneUse use, bool film_is_given,
                                     Problems& problems) {
  check_faces(scene, problems);
  if (use == SceneUse::line_film) check_line(scene.bodies, problems);
  if (!is_of_solved_films(use)) {
    check_film(scene, film_is_given, problems);
    check_inlet(scene, problems);
    if (!problems.any()) check_rise(scene, problems);
  }
  check_profile(scene, problems);
  check_oil(scene.lubricant.oil, problems);
  if (problems.any()) return std::nullopt;
  const auto numbers = detail::numbers_of<double>(scene);
  check_ellipse(scene, numbers, problems);
  check_derived(scene, numbers, problems);
  if (!problems.any()) check_liquid(scene, numbers, problems);
  if (problems.any()) return std::nullopt;
  return numbers;
}

}  // namespace tribo::scene_detail
