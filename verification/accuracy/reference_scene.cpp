// SPDX-License-Identifier: Apache-2.0
#include "accuracy/reference_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "scene/schema.hpp"

namespace tribo::verification {
namespace {

// The column of a field; "" if the row has none. The column has the name of the field, except for
// radii, ellipticity, length, the number of a supply and the viscosity law.
std::string_view column_of(const ReferenceRow& row, std::string_view path) {
  const std::string& shape = row.text("shape");
  if (path == (shape == "circle" ? "bodies.reduced_radius" : "bodies.radius_x")) return "radius_x";
  if (path == (shape == "circle"    ? "bodies.ellipticity"
               : shape == "ellipse" ? "bodies.radius_y"
                                    : "bodies.length"))
    return "across";
  if (path == "supply." + row.text("supply_kind")) return "supply";
  if (path == "friction.viscosity") return "viscosity_law";
  const std::string_view name = scene_detail::last_part(path);
  return path == "id" || path == "bodies.radius_x" || !row.has(name) ? "" : name;
}

}  // namespace

double place_of(std::string_view word, std::span<const std::string_view> words) {
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) throw std::runtime_error(fmt::format("unknown word {}", word));
  return static_cast<double>(found - words.begin());
}

void for_each_field(const ReferenceRow& row, const std::function<void(std::size_t, double)>& take) {
  for (std::size_t place = 0; place < scene_fields().size(); ++place) {
    const FieldInfo& field = scene_fields()[place];
    const std::string_view column = column_of(row, field.path);
    if (column.empty()) continue;
    take(place, field.type == FieldType::choice ? place_of(row.text(column), field.choices)
                                                : row.number(column));
  }
}

}  // namespace tribo::verification
