// SPDX-License-Identifier: Apache-2.0
// A sweep: scenes in which some fields vary, and the results that are asked of each of their cases.
// plan_reader.hpp makes it from files. The results depend on the plan and the arithmetic (with or
// without FMA) alone. They have the same bits for any number of threads, machines and restarts.
//
//   case    one set of values of the varied fields
//   point   one case at one speed; one case alone where only onsets are asked
//   group   one case; with sensitivity, the k + 2 cases of sensitivity.hpp
//   chunk   a number of cases in a row, which a thread computes as a whole
//   part    chunks of some seconds of work: what a process claims, writes and resumes as a whole
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "sweep/distribution.hpp"
#include "tribo/scene.hpp"

namespace tribo {
enum class OnsetCriterion : std::uint8_t;  // onset.hpp
}

namespace tribo::sweep {

enum class Design : std::uint8_t { factorial, sobol, latin_hypercube, monte_carlo };

inline constexpr auto design_names =
    std::to_array<std::string_view>({"factorial", "sobol", "latin_hypercube", "monte_carlo"});
constexpr std::string_view name(Design design) {
  return design_names[static_cast<std::size_t>(design)];
}

// A field that varies: over a grid, or drawn from a distribution.
struct Variable {
  std::string path;                         // "lubricant.viscosity"
  std::string unit;                         // empty: dimensionless
  std::string meaning;                      // of the field
  std::string text;                         // how it varies: "uniform from 0.02015 to 0.02025"
  void (*store)(Scene&, double) = nullptr;  // puts a value into a scene
  double nominal = 0;                       // in SceneSweep::scene: median, or middle entry of grid
  std::vector<double> grid;                 // its values; empty where it is drawn
  std::vector<std::string> words;  // of a grid of words: all words of the field; `grid` has
                                   // places in this list
  Distribution distribution;       // where there is no grid

  bool is_drawn() const { return grid.empty(); }
};

// One result of a case: an output, or a number of an onset.
struct Column {
  std::string name;  // "film", "onset.film_maximum.speed"
  std::string unit;
  std::vector<std::string> words;  // of an output of words: values are places in this list
  std::size_t width = 1;           // values a case: one, or one for each speed of the scene
  std::string meaning = {};
};

// The sweep of one scene file.
struct SceneSweep {
  std::string file;  // without its folder
  std::string text;  // the whole of it
  Scene scene;       // with nominal values

  std::vector<Variable> variables;  // grids first, each kind in the schema's order
  Design design = Design::sobol;    // of the drawn variables
  std::uint64_t draws = 1;          // for each set of grid values; of each matrix with sensitivity
  std::uint64_t seed = 1;
  // Rows of the lower triangular L. The correlation matrix of the drawn variables, in their order,
  // is L·Lᵀ. Empty: they are independent.
  std::vector<std::vector<double>> correlation_root;
  bool sensitivity = false;  // Sobol indices: see sensitivity.hpp for the cases that this adds
  bool keep_points = true;   // in the result; if not, it has summaries alone

  OutputSet outputs;                     // of operating points; empty: none
  std::vector<OnsetCriterion> criteria;  // of onsets; empty: none
  double departure = 0;                  // ε of film_departure
  bool solves_film = false;              // of lines: the film of the Reynolds equation
  std::vector<Column> columns;           // the results of a case, in their order

  std::uint64_t grid_cells = 1;  // sets of grid values
  std::uint64_t groups = 1;      // grid_cells · draws
  std::uint64_t chunk_groups = 1;
  std::uint64_t chunks = 1;

  bool asks_at_speeds() const { return !outputs.empty() || solves_film; }  // not for onsets alone
  std::size_t drawn() const;  // variables that are drawn; they are the last ones
  std::size_t cases_kept_per_group() const { return sensitivity ? 2 : 1; }
  std::size_t cases_per_group() const { return sensitivity ? 2 + drawn() : 1; }
  std::uint64_t cases() const { return groups * cases_kept_per_group(); }  // in the result
  std::uint64_t chunk_cases() const { return chunk_groups * cases_kept_per_group(); }
  // Values of one case, over all columns.
  std::size_t width() const;
  // Points that are computed, with those for sensitivity.
  std::uint64_t points() const;
};

// The version of the numbers in chunks. It is raised only when a bit of an answer, or the meaning
// of a chunk's bytes, changes. With an equal version a newer program takes older parts and results.
// After a rise, `make numbers` writes the answers of the new version
// (reports/tests/kept_numbers.py).
inline constexpr std::uint64_t numbers_version = 8;

struct SweepPlan {
  std::vector<SceneSweep> scenes;
  std::string version;  // of tribocheck
  std::string digest;   // of numbers_version, files' texts and layout, 32 hexadecimal digits

  std::uint64_t chunks() const;
  std::uint64_t points() const;
};

// The place of a chunk of the whole plan: its scene, and its groups of cases.
struct ChunkPlace {
  std::size_t scene = 0;
  std::uint64_t first_group = 0;  // within the scene
  std::uint64_t groups = 0;
};
ChunkPlace place_of(const SweepPlan& plan, std::uint64_t chunk);

// May a film come from the tables of solved films, so that points beyond them have none?
bool may_lack_film(const SceneSweep& sweep);

// The work was stopped early, as asked.
struct Stopped : std::runtime_error {
  Stopped() : std::runtime_error("stopped") {}
};

// --- The layout, from a sweep's settings: its columns, and how its cases are cut into chunks.

// The outcome of a film that was to be solved: the words of the column `outcome`.
enum class SolvedOutcome : std::uint8_t { solved, tolerance_missed, not_solved };
inline constexpr auto solved_outcome_words =
    std::to_array<std::string_view>({"solved", "tolerance_missed", "not_solved"});

// The columns of a solved film, in their order; `solved_film.` stands before their names.
struct SolvedColumn {
  std::string_view name, unit, meaning;
  bool is_of_words = false;  // solved_outcome_words
};
inline constexpr auto solved_columns = std::to_array<SolvedColumn>({
    {"load_number", "", "M = W(2U)^(-1/2)"},
    {"material_number", "", "L = G(2U)^(1/4)"},
    {"central", "m", "film in the middle of the contact, solved; undefined where that failed"},
    {"central_error", "m", "what the solved central film may be off by"},
    {"minimum", "m", "least film, solved; undefined where that failed"},
    {"minimum_error", "m", "what the solved least film may be off by"},
    {"outcome", "",
     "whether the film was solved to the tolerance of 1e-4, to a larger error, or not at all; "
     "`tribocheck film` says why of one contact",
     true},
});

// Fills columns, grid_cells, groups, chunk_groups and chunks.
void lay_out(SceneSweep& sweep);

}  // namespace tribo::sweep
