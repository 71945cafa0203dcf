// SPDX-License-Identifier: Apache-2.0
// The parts of the schema that the reader needs beyond the public table: look-up by name, and the
// place of a value in the scene.
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tribo/contact_numbers.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::scene_detail {

inline constexpr std::size_t field_capacity = 64;  // of scene_fields(), for sets of their places

// The tables of a scene. `speed` is one of them, as it may be a table.
inline constexpr auto sections = std::to_array<std::string_view>(
    {"bodies", "closures", "friction", "lubricant", "speed", "supply", "surface"});

inline constexpr auto output_names = [] {
  std::array<std::string_view, output_infos.size()> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = output_infos[i].name;
  return names;
}();

using Numbers = detail::SceneNumbers<double>;

// Access to a field in a scene as a number; for a choice, as the place of its word. All are null
// for fields that are no number and no choice, such as id and outputs.
using Store = void (*)(Scene&, double);
struct Access {
  Store store = nullptr;
  std::optional<double> (*load)(const Scene&) = nullptr;
  double Numbers::*number = nullptr;  // null: the field is not itself a number of a contact
};

// The function that puts a value into the scene; for `speed` it replaces all speeds.
Store store_of(std::size_t field);
// The field's value in the scene, given or computed from other fields; nothing where the scene has
// none.
std::optional<double> value_in(const Scene& scene, std::size_t field);
// The number of the contact that is the field's value; null if others depend on the field, too.
double Numbers::*contact_number(std::size_t field, ContactShape shape);

// The place in scene_fields() of a dotted path.
std::optional<std::size_t> find_field(std::string_view path);
// The same for a path known to be there.
std::size_t field_at(std::string_view path);

// Fields by their places in scene_fields(): a stream checks its scenes by these, not by names.
using FieldPlaces = std::bitset<field_capacity>;
struct SetPlaces {
  FieldSet names;
  FieldPlaces fields, optional;
};
struct GroupPlaces {
  FieldGroup names;
  std::vector<SetPlaces> sets;
  FieldPlaces fields, optional;  // of all sets
};
// The groups of scene_field_groups(), by places.
const std::vector<GroupPlaces>& group_places();

// "surface", "bodies" …
bool is_section(std::string_view name);

// "surface" of "surface.summit_radius", empty for "load".
std::string_view section_of(std::string_view path);
// "summit_radius" of "surface.summit_radius".
inline std::string_view last_part(std::string_view path) {
  return path.substr(path.rfind('.') + 1);
}

// The known name nearest to a misspelt one; empty if none is near. `sections` also considers
// the names of sections (for tables), `fields` those of fields.
std::string_view nearest_name(std::string_view path, bool sections, bool fields);
std::string_view nearest_choice(std::string_view word, std::span<const std::string_view> choices);

// "reduced_radius, or radius_x and radius_y …": the sets of a group, from number `first` on.
std::string sets_text(FieldGroup group, std::size_t first = 0);
// "a, b or c"
std::string joined(std::span<const std::string_view> words, std::string_view last_link);
// "a number above 0, in m"
std::string allowed_text(const FieldInfo& field);
// "summit_density, summit_radius, …": the names legal in a section, or on top for "".
std::string names_in(std::string_view section);

}  // namespace tribo::scene_detail
