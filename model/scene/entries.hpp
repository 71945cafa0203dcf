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
  std::string text;   // of a text; of a number with a fault, as it was written
};

// The id of a line of JSON, as a text. The value has to be a text, or a number below 2^53 in
// magnitude; else the result is std::nullopt.
std::optional<std::string> line_id(const Value& value);
inline constexpr std::string_view allowed_line_ids =
    "a text, or a number below 9007199254740992 in magnitude";

// `path` is "load" or "surface.summit_radius". A section that is a table has an entry, and each of
// its fields has one. `inner` has the lists in a list, by the keys "[0]", "[1]" …, and the content
// of other tables, by their keys. From JSON it has lists only, because only sweeps (model/sweep)
// have such tables.
struct Entry {
  std::string path;
  Value value;
  std::vector<Value> elements;  // of a list
  std::vector<Entry> inner = {};
  // The place of the field of `path` (schema.hpp), if it is already looked up.
  std::optional<std::size_t> field = {};
};

inline constexpr std::size_t max_depth = 16;      // of lists and tables within each other
inline constexpr std::size_t max_entries = 1000;  // far more than there are fields
inline constexpr std::size_t max_problems = 50;   // reported of one scene

// Collects the errors and warnings of one input. `source`, its name, must outlive this object.
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

// A key as a part of a path. A key that is long or not bare is quoted, and a long one shortened.
std::string path_part(std::string_view key);

// The message on text over 1 MiB; "" for less.
std::string too_large_text(std::size_t bytes);
extern const std::string_view too_many_fields_text;
extern const std::string_view too_deep_text;

// Are lists and tables of a JSON text nested more than max_depth deep? Ask this before a parser
// makes a tree of the text, because trees are copied, printed and destroyed by recursion.
bool nests_too_deep(std::string_view json);

// The entries of a TOML text; nothing, and an error, where the text is not TOML. Text over 1 MiB or
// with more than most_fields fields is refused.
std::optional<std::vector<Entry>> toml_entries(std::string_view text, Problems& problems,
                                               std::size_t most_fields = max_entries);

// The same for a JSON text; nothing, and an error, where the text is no JSON object.
std::optional<std::vector<Entry>> json_entries(std::string_view text, Problems& problems,
                                               std::size_t most_fields = max_entries);

// Replaces the outputs in `entries` by these names. Without names nothing changes.
void put_outputs(std::span<const std::string_view> outputs, std::vector<Entry>& entries);

// Fills reading.scene from the entries, or reading.errors.
void bind_scene(std::span<const Entry> entries, SceneUse use, Problems& problems,
                SceneReading& reading);

}  // namespace tribo::scene_detail
