// SPDX-License-Identifier: Apache-2.0
// Numbers as people write them, "20.2 mPa s", in place of SI numbers. All units but °C and km/h are
// powers of ten of the SI unit. So a number keeps its digits, and gives the same double as in SI.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/entries.hpp"

namespace tribo::scene_detail {

// A distance, such as a standard deviation, has no origin: 5 °C is 5 K.
enum class Measure : std::uint8_t { value, distance };

// The decimal number in the SI unit, "20.2e-3" for "20.2 mPa s" in Pa·s; nothing where the text is
// not a number with a unit that fits. `unit` is that of a field, or "%" of a number without one.
std::optional<std::string> si_decimal(std::string_view text, std::string_view unit,
                                      Measure measure = Measure::value);

// The number in place of a text that si_decimal() takes; any other value as it is.
Value in_si(const Value& value, std::string_view unit, Measure measure = Measure::value);

// "0.05 km/h" for "6.2 km/h": half a unit of the last written digit, in the same unit. The result
// is a Measure::distance. Nothing where the text does not begin with a number.
std::optional<std::string> half_last_digit(std::string_view text);

// Does a text begin with a number?
bool is_number(std::string_view text);

// "nm, µm, mm or m", for messages; empty where the field takes no unit.
std::string_view usual_units(std::string_view unit);

// The fault of a value that is no number of the field.
Fault no_number(const Value& value, std::string_view unit, std::string allowed);

// The unit of a field for si_decimal(): its own, or "%" if the field takes per cent.
std::string_view written_unit(const FieldInfo& field);
// May the field be given as a text with a unit?
bool takes_units(const FieldInfo& field);
// A copy of a field's entry with numbers in place of texts with units, in its lists too; nothing
// where there is no text.
std::optional<Entry> in_si(const Entry& entry, const FieldInfo& field);

}  // namespace tribo::scene_detail
