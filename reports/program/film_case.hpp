// SPDX-License-Identifier: Apache-2.0
// One line contact of a scene at one speed, solved, in SI units, beside each formula's film; and
// such films as a table, CSV or JSON.
#pragma once

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
  double tolerance = 1e-4;                 // relative, of the three films
};

// A number and its absolute error; both NaN where there is no number.
struct Measured {
  double value, error;
};

struct FormulaFilm {
  std::string_view name;        // as in the catalogue of functions
  std::string_view stands_for;  // central_film, minimum_film or film_at_greatest_pressure
  std::string_view fitted_to;   // the liquid, as ehl::name(FitLiquid) has it
  double film;                  // m
  // The difference of the formula's film from the solved film that it stands for, over the solved
  // film: `deviation` with the liquid that the formula was fitted to (NaN where that is not known),
  // `this_liquid_deviation` with this contact's liquid.
  double deviation, this_liquid_deviation;
};

struct ProfilePoint {
  double x;         // m, along the direction of entrainment from the middle of the contact
  double pressure;  // Pa
  double film;      // m
};

struct FilmCase {
  std::string id;
  std::string_view viscosity, density;              // laws of this contact's liquid
  double speed;                                     // m/s
  double load_number, material_number;              // M and L
  double half_width, peak_pressure;                 // Hertz': m, Pa
  Measured central, minimum, at_greatest_pressure;  // m
  Measured spike_pressure, spike_place;             // Pa, m
  std::string no_spike;  // why the spike lacks its pressure, or both numbers
  bool is_solved = false;
  // Why it is not solved, or which error was reached in place of the tolerance; else empty.
  std::string reason;
  int grids = 0, cells = 0, steps = 0;  // cells of the finest grid; steps of Newton's method in all
  std::vector<FormulaFilm> formulas;
  std::vector<ProfilePoint> profile;  // nodes of the finest grid
};

// Names of the formulas, in the order of FilmCase::formulas.
std::vector<std::string_view> film_formula_names();

// Called before every step of Newton's method; the work stops where it returns false.
using FilmWatch = std::function<bool(int cells, int step)>;

// Solves a scene that was read as a line (SceneUse::line_film).
FilmCase solve_film(const Scene& scene, double speed, const FilmSettings& settings,
                    const FilmWatch& watch);

// format: "table", "csv" or "json". In CSV rows of profiles take the place of rows of films.
class FilmWriter {
 public:
  FilmWriter(std::string_view format, const FilmSettings& settings, bool with_profile, Text& text);

  void add(const FilmCase& film);
  void finish(const nlohmann::ordered_json& warnings);

 private:
  std::string_view format_;
  const FilmSettings& settings_;
  bool with_profile_;
  Text& text_;
  std::string_view before_;  // the next film
};

// One film as the JSON has it.
nlohmann::ordered_json film_json(const FilmCase& film, const FilmSettings& settings,
                                 bool with_profile);

}  // namespace tribo::cli
