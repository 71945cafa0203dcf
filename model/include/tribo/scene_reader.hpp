// SPDX-License-Identifier: Apache-2.0
// Reading scenes from TOML or JSON text. One schema (scene_fields) serves both, the error messages,
// and the JSON Schema file reference/scene.schema.json, which a test holds to it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tribo/scene.hpp"

namespace tribo {

// `speeds` is a number, a list of numbers, or a table whose fields are `speed.from` and so on;
// `limits` is a list of words of limit_words(); `viscosities` is a list of two pairs of a
// temperature and a kinematic viscosity.
enum class FieldType : std::uint8_t {
  number,
  integer,
  text,
  choice,
  speeds,
  outputs,
  limits,
  viscosities
};

// One field of the schema. `path` is dotted: "surface.summit_density".
struct FieldInfo {
  std::string_view path;
  FieldType type = FieldType::number;
  std::string_view unit = "";          // empty: dimensionless
  double minimum = 0;                  // numbers: the least value, or the open end
  bool exclusive_minimum = true;       // numbers: is `minimum` itself refused?
  std::optional<double> maximum = {};  // numbers: the greatest value, if there is one
  bool is_radius_of_face = false;      // any number but 0, and ±∞ in TOML: a flat face
  bool takes_per_cent = false;         // a number without a unit, which people also give in %
  bool takes_both_faces = false;       // also takes a list of two, as √(x₁² + x₂²)
  std::span<const std::string_view> choices = {};  // choice: the legal words
  std::string_view default_text = "";              // empty: no default
  bool required = false;                 // always, or in the table `speed` where that is given
  std::optional<Output> needed_by = {};  // the one output that needs the field
  double plausible_minimum = 0;  // a legal number outside of this range is warned of (validity.hpp)
  double plausible_maximum = std::numeric_limits<double>::infinity();
  std::string_view likely_unit = "";  // probably meant for a number outside: "mPa·s", "GPa, MPa"
  std::string_view meaning = "";
};

// Every field that a scene may have, in the order of model/README.md, section 1.
std::span<const FieldInfo> scene_fields();

// Fields that say the same in different ways: a scene gives all fields of one of the sets, and none
// of another one. The first set is the usual one.
struct FieldSet {
  std::span<const std::string_view> fields;    // dotted paths
  std::span<const std::string_view> optional;  // legal only beside `fields`
};
using FieldGroup = std::span<const FieldSet>;
std::span<const FieldGroup> scene_field_groups();

// The rule that an input breaks, or keeps in an unusual way.
struct Fault {
  enum Rule : std::uint8_t {
    other,       // what: the fault in words
    unknown,     // a field or table that is not known; what: "field" or "table"
    once,        // a field that is given twice
    presence,    // a field that is missing; what: why it is needed
    absence,     // a field that another field excludes; what: the other field
    kind,        // a value of the wrong kind; what: its kind, "a text"
    word,        // a word that is not known
    repetition,  // a value that a list has twice
    emptiness,   // a list without elements
    overflow,    // a number too large for double
    underflow,   // a number too small for double
    finiteness,  // ∞ or NaN
    wholeness,   // a fraction where a whole number is wanted
    range,       // a number beyond the limits of its field; what: the setting they hold with
    result,      // a number that makes another one illegal; what: the other one
    together,    // a value that others do not allow; what: why
    reach        // a value of a distribution beyond the limits; what: how to bound it
  };
  Rule rule = other;
  std::string value = {};    // as messages show it; empty: a list or a table, or nothing
  std::string what = {};     // more about the fault, as the comment of its rule says
  std::string allowed = {};  // of an unknown name: the known names
  std::string nearest = {};  // the known name or word that is probably meant
  std::string where = {};    // in which circumstances; stands before all the rest
};

// One thing wrong (or useless) with an input. `line()` is what a person reads. All texts are valid
// UTF-8 on one line: text from the input is shortened, and its control characters are escaped.
struct InputProblem {
  std::string source;  // file name, "-" or "line 12"
  std::string field;   // dotted path; empty when it is the whole input
  Fault fault;
  std::size_t row = 0;          // broken TOML or JSON: where, from 1; else 0
  std::size_t column = 0;       // in characters
  std::string message() const;  // with the value, what is allowed, and the nearest known name
  // "rough.toml: surface.summit_radius: -1 is not allowed: …", "rough.toml:3:7: not TOML: …"
  std::string line() const;
};

// A text from an input as messages show it: control, formatting and invalid characters are written
// as escapes, and a text longer than `most` characters ends in "…".
std::string printable(std::string_view text, std::size_t most = 60);
// The text, with characters that would control a terminal escaped as by printable(), but line ends
// and tabs kept. As JSON it means the same.
std::string without_controls(std::string_view text);

struct SceneReading {
  std::optional<Scene> scene;          // set when `errors` is empty
  std::vector<InputProblem> errors;    // every problem found, not only the first
  std::vector<InputProblem> warnings;  // what is legal but has no effect; see also validity.hpp
  std::optional<std::string> id;       // as the input gives it, even when `errors` is not empty
  bool id_is_number = false;           // the id was a number, as a line of JSON may have it
};

enum class SceneUse : std::uint8_t {
  speeds,     // solve, curve: `speed` is required
  onset,      // `speed` is optional
  one_speed,  // stream: `speed` is one number
  film,       // film: `speed` is optional, α may be 0, and nothing is asked of [surface],
              // [friction] and `outputs`; a supply is warned of, because it is not used
  line_film,  // sweep of solved films: the same, of a line
};

// Whether films are solved, not computed by a law.
constexpr bool is_of_solved_films(SceneUse use) {
  return use == SceneUse::film || use == SceneUse::line_film;
}

inline constexpr std::size_t max_scene_bytes = std::size_t{1} << 20;

// `source` names the input in messages. None of these throws on bad input. `outputs` are names that
// replace the scene's own list; if it is empty, that list is used.
SceneReading parse_scene_toml(std::string_view text, std::string_view source, SceneUse use,
                              std::span<const std::string_view> outputs = {});
SceneReading parse_scene_json(std::string_view text, std::string_view source, SceneUse use,
                              std::span<const std::string_view> outputs = {});
// Text whose first character is `{` is read as JSON, all else as TOML.
SceneReading parse_scene(std::string_view text, std::string_view source, SceneUse use,
                         std::span<const std::string_view> outputs = {});

// Reads a file or pipe of at most 1 MiB; "-" is standard input. `.json` files are read as JSON,
// others as parse_scene() does. A scene without `id` gets the file's stem.
SceneReading read_scene(const std::string& path, SceneUse use);

}  // namespace tribo
