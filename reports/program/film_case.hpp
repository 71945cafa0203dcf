// SPDX-License-Identifier: Apache-2.0
// The solved film of a scene at one speed, in SI units, beside each formula's film; and such films
// as a table, CSV or JSON.
#pragma once

#include <cmath>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "messages.hpp"
#include "tribo/scene.hpp"

namespace tribo::cli {

struct FilmSettings {
  std::string viscosity;                   // barus or roelands; empty: the scene's own
  std::string density = "incompressible";  // or dowson_higginson
  // The relative error that the three films may have. 0 stands for 1e-4 for a line, and 1e-3 for a
  // circle or an ellipse, whose least film may be off by three times as much.
  double tolerance = 0;
  bool with_fields = false;  // keep the fields of a circle or an ellipse
  bool is_flooded = false;   // take the inlet as flooded, whatever supply the scene has
};

constexpr bool is_film_tolerance(double tolerance) {
  return tolerance >= 1e-6 && tolerance <= 1e-2;
}
inline constexpr std::string_view film_tolerance_allowed = "a number from 1e-6 to 1e-2";

// A number and its absolute error; both NaN where there is no number.
struct Measured {
  double value, error;
};

struct FormulaFilm {
  std::string_view name;        // a law's name as in scenes, or a reading's own
  std::string_view stands_for;  // central_film, minimum_film or film_at_greatest_pressure
  std::string_view fitted_to;   // the liquid, as ehl::name(FitLiquid) has it
  double film;                  // m
  // The formula's film over the solved film that it stands for, minus 1. `deviation`: the solved
  // film is of the liquid that the formula was fitted to; NaN if that is not known or not solved.
  // `this_liquid_deviation`: it is of this contact's liquid.
  double deviation, this_liquid_deviation;
};

// The starved film over the flooded film, as a closure of scenes gives it from the solved flooded
// film.
struct ClosureRatio {
  std::string_view closure;  // as closures.starvation has it
  double film_ratio;
  double deviation;  // film_ratio over the solved ratio, minus 1
};

struct ProfilePoint {
  double x;         // m, along the direction of entrainment from the middle of the contact
  double pressure;  // Pa
  double film;      // m
};

// The nodes with y ≥ 0 of the finest grid of a circle or an ellipse; the other half is symmetric.
// Pressure and film at x[i] and y[j] stand at j·x.size() + i.
struct FilmFields {
  std::vector<double> x, y;      // m
  std::vector<double> pressure;  // Pa
  std::vector<double> film;      // m
};

struct FilmCase {
  std::string id;
  std::string_view viscosity, density;              // laws of this contact's liquid
  double speed;                                     // m/s
  double load_number, material_number;              // M and L
  double half_width, peak_pressure;                 // Hertz': b or a_x, m; Pa
  double ellipticity;                               // Hertz': a_y/a_x; NaN of a line
  double tolerance;                                 // relative error that is aimed at
  Measured central, minimum, at_greatest_pressure;  // m
  double inlet_film;         // h_oil, m; NaN, as the next three, for a flooded contact
  Measured flooded_central;  // the central film with a flooded inlet, m
  Measured film_ratio;       // central film over flooded central film
  double damiens_exponent;   // γ with which Damiens' closure gives film_ratio; NaN: none does
  Measured friction;         // of the oil over the load
  Measured spike_pressure, spike_place;  // Pa, m
  std::string no_spike;                  // why the spike lacks its pressure, or both numbers
  std::string no_friction;               // why friction lacks its number
  bool is_solved = false;
  // Why it is not solved, or which error was reached in place of the tolerance; else empty.
  std::string reason;
  // `cells` and `cells_across`: cells of the finest grid along x and along y; a line has 0 along y.
  // `steps`: all steps of Newton's method.
  int grids = 0, cells = 0, cells_across = 0, steps = 0;
  std::vector<FormulaFilm> formulas;   // of flooded contacts, beside flooded films
  std::vector<ClosureRatio> closures;  // of a starved contact
  std::vector<ProfilePoint> profile;   // nodes of the finest grid along the middle, y = 0
  FilmFields fields;                   // empty unless they are asked for

  bool is_line() const { return std::isnan(ellipticity); }
  bool is_starved() const { return !std::isnan(inlet_film); }
};

// Names of all formulas: those of lines, then those of circles and ellipses. A FilmCase has those
// of its contact, in this order.
std::vector<std::string_view> film_formula_names();

// Grids, time and memory that a contact will take, from the fewest grids that give an error to the
// most that are tried.
struct FilmNeeds {
  std::string_view viscosity, density;  // laws of the liquid
  double tolerance, load_number, material_number;
  std::string reason;  // why it is refused before it is solved; else empty
  struct Grids {
    int count;       // each halves the cells of the one before
    double nodes;    // of the finest
    double seconds;  // of one core, roughly
    double memory;   // bytes, at most at any time
  } least, most;
};
FilmNeeds needs_of_film(const Scene& scene, double speed, const FilmSettings& settings);

// All numbers and words of a contact and of the settings on which its FilmCase depends. Cases with
// the same key are the same, except for their fields.
std::string key_of_film(const Scene& scene, double speed, const FilmSettings& settings);

// Whether a scene that was read with SceneUse::film is a line contact.
bool is_of_line(const Scene& scene);

// Called before every step of Newton's method; the work stops where it returns false.
using FilmWatch = std::function<bool(int cells, int step)>;

// Solves a scene that was read with SceneUse::film.
FilmCase solve_film(const Scene& scene, double speed, const FilmSettings& settings,
                    const FilmWatch& watch);

// Writes films in a format: "table", "csv" or "json". With profiles, CSV has the rows of the
// profiles in place of the rows of the films.
class FilmWriter {
 public:
  FilmWriter(std::string_view format, bool with_profile, Text& text);

  std::string text_of(const FilmCase& film) const;
  void add(std::string_view film);  // as text_of() has it
  void finish(const nlohmann::ordered_json& warnings);

 private:
  std::string_view format_;
  bool with_profile_;
  Text& text_;
  std::string_view before_;  // text before the next film
};

// One film as the JSON has it, with its profile and its fields, for its picture.
nlohmann::ordered_json film_picture_json(const FilmCase& film);

}  // namespace tribo::cli
