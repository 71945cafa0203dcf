// SPDX-License-Identifier: Apache-2.0
// The flat list of entries that both parsers make of a text, and from which the binder makes a
// scene.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tribo/scene_reader.hpp"

namespace tribo::scene_detail {

enum class ValueKind : std::uint8_t { number, text, boolean, null, date_time, list, table };
enum class NumberFault : std::uint8_t { none, overflow, underflow };

struct Value {
  ValueKind kind = ValueKind::null;
  NumberFault fault = NumberFault::none;
  double number = 0;  // booleans: 0 or 1
  std::string text;   // texts; of numbers with a fault, what was written
};

// The id of a line of JSON: a text, or a number that double holds to the last digit, as a text.
// Nothing where the value is neither.
std::optional<std::string> line_id(const Value& value);
inline constexpr std::string_view allowed_line_ids =
    "a text, or a number below 9007199254740992 in magnitude";

// `path` is "load" or "surface.summit_radius". Tables of a known section have an entry of their own
// and one for each of their fields. The content of lists in lists and of other tables is in
// `inner`, by its keys ("[0]", "[1]" …), from JSON of lists alone: scenes have no such tables,
// sweeps (model/sweep) do.
struct Entry {
  std::string path;
  Value value;
  std::vector<Value> elements;  // of a list
  std::vector<Entry> inner = {};
  // The field of the path (schema.hpp), where whoever made the entry has looked it up already.
  std::optional<std::size_t> field = {};
};

inline constexpr std::size_t max_depth = 16;      // of lists and tables within each other
inline constexpr std::size_t max_entries = 1000;  // far more than there are fields
inline constexpr std::size_t max_problems = 50;   // reported of one scene

// The errors and warnings of one input, whose name must outlive it.
class Problems {
 public:
  Problems(SceneReading& reading, std::string_view source) : reading_(reading), source_(source) {}
  void error(std::string_view field, Fault fault);
  void error_at(std::size_t row, std::size_t column, std::string_view field, Fault fault);
  void warning(std::string_view field, Fault fault);
  bool any() const { return !reading_.errors.empty(); }

 private:
  InputProblem problem(std::string_view field, Fault fault) const;

  SceneReading& reading_;
  std::string_view source_;
};

// A key as a part of a path: quoted where it could be taken for something else, and shortened.
std::string path_part(std::string_view key);

// The message on text over 1 MiB; "" for less.
std::string too_large_text(std::size_t bytes);
extern const std::string_view too_many_fields_text;
extern const std::string_view too_deep_text;

// Are lists and tables of a JSON text nested more than max_depth deep? To be asked before a parser
// makes a tree of the text: trees are copied, printed and destroyed by recursion.
bool nests_too_deep(std::string_view json);

// The entries of a TOML text; nothing, and an error, where the text is not TOML. Text over 1 MiB or
// with more than most_fields fields is refused.
std::optional<std::vector<Entry>> toml_entries(std::string_view text, Problems& problems,
                                               std::size_t most_fields = max_entries);

// The same of a JSON text; nothing, and an error, where the text is no JSON object.
std::optional<std::vector<Entry>> json_entries(std::string_view text, Problems& problems,
                                               std::size_t most_fields = max_entries);

// Puts the names of outputs in place of those that the entries have; none: leaves these.
void put_outputs(std::span<const std::string_view> outputs, std::vector<Entry>& entries);

// Fills reading.scene from the entries, or reading.errors.
void bind_scene(std::span<const Entry> entries, SceneUse use, Problems& problems,
                SceneReading& reading);

}  // namespace tribo::scene_detail
