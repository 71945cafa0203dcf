// SPDX-License-Identifier: Apache-2.0
#include "scene/units.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "scene/fault_text.hpp"

namespace tribo::scene_detail {
namespace {

constexpr std::size_t longest = 100;      // bytes of a number with its unit
constexpr int largest_power = 1'000'000;  // of ten; double ends long before

struct Prefix {
  std::string_view sign;
  int power;  // of ten
};
constexpr auto prefixes = std::to_array<Prefix>({{"", 0},
                                                 {"G", 9},
                                                 {"M", 6},
                                                 {"k", 3},
                                                 {"d", -1},
                                                 {"c", -2},
                                                 {"m", -3},
                                                 {"u", -6},
                                                 {"n", -9},
                                                 {"p", -12}});

// A unit that fields in the unit `si` take. * stands for a prefix, which counts `times` times.
struct Spelling {
  std::string_view si, written;
  int times;
  int power = 0;  // of ten, without a prefix
};
constexpr auto spellings = std::to_array<Spelling>({{"m", "*m", 1},
                                                    {"m²", "*m2", 2},
                                                    {"1/m²", "1/*m2", -2},
                                                    {"1/m²", "*m-2", -2},
                                                    {"N", "*N", 1},
                                                    {"Pa", "*Pa", 1},
                                                    {"Pa", "N/mm2", 0, 6},
                                                    {"1/Pa", "1/*Pa", -1},
                                                    {"1/Pa", "/*Pa", -1},
                                                    {"1/Pa", "*Pa-1", -1},
                                                    {"1/Pa", "mm2/N", 0, -6},
                                                    {"Pa·s", "*Pa.s", 1},
                                                    {"Pa·s", "*Pas", 1},
                                                    {"Pa·s", "*P", 1, -1},
                                                    {"m/s", "*m/s", 1},
                                                    {"m/s", "km/h", 0},
                                                    {"m/s", "*m.s-1", 1},
                                                    {"m²/s", "*m2/s", 2},
                                                    {"m²/s", "*m2.s-1", 2},
                                                    {"m²/s", "*St", 1, -4},
                                                    {"K", "*K", 1},
                                                    {"K", "°C", 0},
                                                    {"K", "C", 0},
                                                    {"1/K", "1/*K", -1},
                                                    {"1/K", "*K-1", -1},
                                                    {"kg/m³", "kg/m3", 0},
                                                    {"kg/m³", "g/cm3", 0, 3},
                                                    {"kg/m³", "g/ml", 0, 3},
                                                    {"kg/m³", "g/mL", 0, 3},
                                                    {"kg/m³", "kg/dm3", 0, 3},
                                                    {"kg/m³", "kg/l", 0, 3},
                                                    {"kg/m³", "kg/L", 0, 3},
                                                    {"W/(m·K)", "*W/(m.K)", 1},
                                                    {"W/(m·K)", "*W/(mK)", 1},
                                                    {"W/(m·K)", "*W/m.K", 1},
                                                    {"W/(m·K)", "*W/mK", 1},
                                                    {"W/(m·K)", "*W/m/K", 1},
                                                    {"%", "%", 0, -2}});

// Units that engineers use, for messages.
struct Usual {
  std::string_view si, written;
};
constexpr auto usual = std::to_array<Usual>({{"m", "nm, µm, mm or m"},
                                             {"m²", "nm², µm², mm² or m²"},
                                             {"1/m²", "1/µm², 1/mm² or 1/m²"},
                                             {"N", "mN, N or kN"},
                                             {"Pa", "Pa, MPa, GPa or N/mm²"},
                                             {"1/Pa", "1/Pa, 1/MPa, 1/GPa or mm²/N"},
                                             {"Pa·s", "mPa s, cP or Pa s"},
                                             {"m/s", "mm/s, m/s or km/h"},
                                             {"m²/s", "mm²/s, cSt or m²/s"},
                                             {"K", "°C or K"},
                                             {"1/K", "1/K"},
                                             {"kg/m³", "kg/m³ or g/cm³"},
                                             {"W/(m·K)", "W/(m K) or mW/(m K)"},
                                             {"%", "%"}});

// Signs that stand for others in a unit.
struct Alias {
  std::string_view sign, plain;
};
constexpr auto aliases = std::to_array<Alias>({{"µ", "u"},
                                               {"μ", "u"},
                                               {"²", "2"},
                                               {"³", "3"},
                                               {"¹", "1"},
                                               {"⁻", "-"},
                                               {"−", "-"},
                                               {"^", ""},
                                               {"·", "."},
                                               {"⋅", "."},
                                               {"*", "."},
                                               {" ", "."},
                                               {"\u00A0", "."},
                                               {"\u202F", "."},
                                               {"degC", "°C"},
                                               {"℃", "°C"}});

// The unit in the signs of the table of spellings, without dots that separate nothing.
std::string plain_unit(std::string_view text) {
  std::string unit;
  while (!text.empty()) {
    const auto alias = std::find_if(aliases.begin(), aliases.end(), [text](const Alias& one) {
      return text.starts_with(one.sign);
    });
    const bool is_alias = alias != aliases.end();
    const std::string_view sign = is_alias ? alias->plain : text.substr(0, 1);
    text.remove_prefix(is_alias ? alias->sign.size() : 1);
    const bool follows_separator =
        unit.empty() || unit.back() == '.' || unit.back() == '/' || unit.back() == '(';
    if (sign == "." && follows_separator) continue;
    if ((sign == "/" || sign == ")") && unit.ends_with('.')) unit.pop_back();
    unit += sign;
  }
  if (unit.ends_with('.')) unit.pop_back();
  return unit;
}

// The number and the unit of a text. `mantissa` is empty if the text does not begin with a number.
struct Parts {
  std::string_view mantissa, unit;
  int exponent = 0;
};
Parts parts_of(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  if (text.starts_with('+')) text.remove_prefix(1);
  const std::string_view digits = text.substr(text.starts_with('-') ? 1 : 0, 2);
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const bool is_number =
      !digits.empty() &&
      (is_digit(digits[0]) || (digits.size() == 2 && digits[0] == '.' && is_digit(digits[1])));
  if (!is_number || text.size() > longest) return {};
  std::size_t end = text.find_first_not_of("0123456789.-");
  end = std::min({end, text.find('.', text.find('.') + 1), text.find('-', 1), text.size()});
  Parts parts{text.substr(0, end), text.substr(end)};
  if (parts.unit.starts_with('e') || parts.unit.starts_with('E')) {
    std::string_view power = parts.unit.substr(1);
    if (power.starts_with('+') && !power.starts_with("+-")) power.remove_prefix(1);
    const auto [stop, error] =
        std::from_chars(power.data(), power.data() + power.size(), parts.exponent);
    if (stop != power.data())
      parts.unit = power.substr(static_cast<std::size_t>(stop - power.data()));
    if (error == std::errc::result_out_of_range)
      parts.exponent = power.starts_with('-') ? -largest_power : largest_power;
    parts.exponent = std::clamp(parts.exponent, -largest_power, largest_power);
  }
  return parts;
}

// The power of ten of `unit` over `si`; nothing where it does not fit.
std::optional<int> power_of(std::string_view unit, std::string_view si) {
  for (const Spelling& spelling : spellings) {
    if (spelling.si != si) continue;
    const std::size_t place = spelling.written.find('*');
    if (place == std::string_view::npos) {
      if (unit == spelling.written) return spelling.power;
      continue;
    }
    const std::string_view before = spelling.written.substr(0, place);
    const std::string_view after = spelling.written.substr(place + 1);
    for (const Prefix& prefix : prefixes)
      if (unit.size() == before.size() + prefix.sign.size() + after.size() &&
          unit.starts_with(before) && unit.ends_with(after) &&
          unit.substr(before.size(), prefix.sign.size()) == prefix.sign)
        return spelling.power + spelling.times * prefix.power;
  }
  return std::nullopt;
}

// A decimal in °C as a decimal in K. The sum in long double is off by less than half a unit of its
// last written digit. So the digits are those of the exact sum if they are at most 18.
std::string kelvins(const Parts& celsius) {
  constexpr long double zero_celsius = 273.15L;
  const std::string written =
      std::string(celsius.mantissa) + 'e' + std::to_string(celsius.exponent);
  const std::size_t point = celsius.mantissa.find('.');
  const auto decimals =
      point == std::string_view::npos ? 0 : static_cast<int>(celsius.mantissa.size() - point) - 1;
  const int places = std::clamp(decimals - std::clamp(celsius.exponent, -100, 100), 2, 15);
  std::array<char, 5200> text{};
  std::snprintf(text.data(), text.size(), "%.*Lf", places,
                std::strtold(written.c_str(), nullptr) + zero_celsius);
  return text.data();
}

// A decimal in km/h as a decimal in m/s, with more digits than double has.
std::string meters_per_second(const Parts& kilometers_per_hour) {
  const std::string written = std::string(kilometers_per_hour.mantissa) + 'e' +
                              std::to_string(kilometers_per_hour.exponent);
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.20Le", std::strtold(written.c_str(), nullptr) / 3.6L);
  return text.data();
}

// The advice on a number with the unit of another quantity, which people give in place of the
// field's. Empty: the unit is not known here.
std::string_view other_quantity(std::string_view text, std::string_view unit) {
  if (unit == "Pa·s" && si_decimal(text, "m²/s"))
    return "a kinematic viscosity: write it as kinematic_viscosity, with density";
  const std::string written = plain_unit(parts_of(text).unit);
  for (const std::string_view turns : {"rpm", "1/min", "min-1", "r/min", "U/min"})
    if (unit == "m/s" && written == turns)
      return "a speed of rotation, and speed is the mean speed of the two surfaces: in a bearing "
             "with one ring at rest π n d_m (1 − (D/d_m)²)/2, n in turns a second, D the ball's "
             "and d_m the pitch diameter";
  return {};
}

}  // namespace

std::optional<std::string> si_decimal(std::string_view text, std::string_view unit,
                                      Measure measure) {
  const Parts parts = parts_of(text);
  if (parts.mantissa.empty() || parts.unit.empty()) return std::nullopt;
  const std::string written = plain_unit(parts.unit);
  if (unit == "m/s" && written == "km/h") return meters_per_second(parts);
  const auto power = power_of(written, unit);
  if (!power) return std::nullopt;
  const bool is_celsius = unit == "K" && written.ends_with('C');
  if (is_celsius && measure == Measure::value) return kelvins(parts);
  return std::string(parts.mantissa) + 'e' + std::to_string(parts.exponent + *power);
}

std::optional<std::string> half_last_digit(std::string_view text) {
  const std::string_view mantissa = parts_of(text).mantissa;
  if (mantissa.empty()) return std::nullopt;
  std::string half;  // the same number with each digit 0, and a 5 behind the last
  for (const char c : mantissa)
    if (c != '-') half += c == '.' ? '.' : '0';
  if (half.find('.') == std::string::npos) half += '.';
  return half + '5' + std::string(mantissa.data() + mantissa.size(), text.data() + text.size());
}

Value in_si(const Value& value, std::string_view unit, Measure measure) {
  if (value.kind != ValueKind::text) return value;
  const auto decimal = si_decimal(value.text, unit, measure);
  if (!decimal) return value;
  Value number{.kind = ValueKind::number, .text = {}};
  const char* const begin = decimal->data();
  const char* const end = begin + decimal->size();
  if (std::from_chars(begin, end, number.number).ec != std::errc::result_out_of_range)
    return number;
  // A temperature is written without an exponent, and only a large one is out of range.
  const std::size_t place = std::min(decimal->find('e'), decimal->size());
  double mantissa = 1;
  std::from_chars(begin, begin + place, mantissa);
  const bool has_exponent = place < decimal->size();
  const double exponent = has_exponent ? std::strtod(begin + place + 1, nullptr) : 1;
  const bool is_large = std::log10(std::abs(mantissa)) + exponent > 0;
  number.fault = is_large ? NumberFault::overflow : NumberFault::underflow;
  number.text = value.text;
  return number;
}

bool is_number(std::string_view text) { return !parts_of(text).mantissa.empty(); }

std::string_view usual_units(std::string_view unit) {
  const auto found =
      std::find_if(usual.begin(), usual.end(), [unit](const Usual& one) { return one.si == unit; });
  return found == usual.end() ? std::string_view() : found->written;
}

Fault no_number(const Value& value, std::string_view unit, std::string allowed) {
  Fault fault = wrong_kind(value, std::move(allowed));
  if (value.kind == ValueKind::text && (value.text == "inf" || value.text == "-inf"))
    fault.what = "a text: write it without the quotes";
  if (value.kind != ValueKind::text || !is_number(value.text)) return fault;
  if (value.text.find("±") != std::string::npos || value.text.find("+-") != std::string::npos) {
    fault.what =
        "a number with its spread, which a sweep takes as { distribution = \"normal\", mean = …, "
        "sd = … }";
    return fault;
  }
  const std::string_view units = usual_units(unit), other = other_quantity(value.text, unit);
  if (units.empty()) {
    fault.what = "a text, and this number has no unit";
  } else {
    fault.what = other.empty() ? "not in a unit that fits" : other;
    fault.allowed += ", or a text in " + std::string(units);
  }
  if (parts_of(value.text).unit.starts_with(',')) fault.allowed += ", with a decimal point";
  return fault;
}

std::string_view written_unit(const FieldInfo& field) {
  return field.takes_per_cent ? "%" : field.unit;
}

bool takes_units(const FieldInfo& field) {
  const bool is_number = field.type == FieldType::number || field.type == FieldType::speeds;
  return is_number && !written_unit(field).empty();
}

std::optional<Entry> in_si(const Entry& entry, const FieldInfo& field) {
  const auto is_text = [](const Value& value) { return value.kind == ValueKind::text; };
  if (!takes_units(field) || (!is_text(entry.value) &&
                              std::none_of(entry.elements.begin(), entry.elements.end(), is_text)))
    return std::nullopt;
  Entry result = entry;
  const std::string_view unit = written_unit(field);
  result.value = in_si(entry.value, unit);
  for (Value& element : result.elements) element = in_si(element, unit);
  return result;
}

}  // namespace tribo::scene_detail
