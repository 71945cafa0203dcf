// SPDX-License-Identifier: Apache-2.0
// A number with a unit is, to the bit, the number in SI with the same digits and the point moved.
// The powers of ten of the units are written here a second time.
#include "scene/units.hpp"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "sampling/sampler.hpp"
#include "scene/scene_text.hpp"

namespace tribo::scene_test {
namespace {

using scene_detail::in_si;
using scene_detail::Measure;
using scene_detail::NumberFault;
using scene_detail::si_decimal;
using scene_detail::Value;
using scene_detail::ValueKind;
using verification::Sampler;

struct Unit {
  std::string written, si;
  int power;
};
// For each unit of SI the units that are written in its place, with their powers of ten.
std::vector<Unit> all_units() {
  std::vector<Unit> all;
  for (const auto& [si, units] : std::initializer_list<std::pair<const char*, std::string>>{
           {"m", "nm: -9; um: -6; µm: -6; μm: -6; mm: -3; cm: -2; m: 0; pm: -12; km: 3"},
           {"m²", "nm²: -18; um^2: -12; mm2: -6"},
           {"1/m²", "1/mm2: 6; 1/mm^2: 6; mm^-2: 6; mm⁻²: 6; 1/µm²: 12; 1/m²: 0; 1 / cm²: 4"},
           {"N", "mN: -3; N: 0; kN: 3; MN: 6"},
           {"Pa", "Pa: 0; kPa: 3; MPa: 6; GPa: 9; N/mm²: 6; N/mm^2: 6"},
           {"1/Pa", "1/Pa: 0; 1/MPa: -6; 1/GPa: -9; GPa^-1: -9; GPa⁻¹: -9; mm²/N: -6"},
           {"Pa·s",
            "Pa s: 0; mPa s: -3; mPa·s: -3; mPa.s: -3; mPa*s: -3; mPas: -3; "
            "mPa\u00A0s: -3; cP: -3; P: -1"},
           {"m/s", "m/s: 0; mm/s: -3; µm/s: -6; m s^-1: 0"},
           {"m²/s", "m²/s: 0; mm²/s: -6; mm^2/s: -6; cSt: -6; St: -4"},
           {"K", "K: 0; mK: -3"},
           {"1/K", "1/K: 0; K^-1: 0"},
           {"kg/m³",
            "kg/m³: 0; kg/m^3: 0; g/cm³: 3; g/ml: 3; g/mL: 3; kg/dm³: 3; kg/l: 3; kg/L: 3"},
           {"W/(m·K)", "W/(m K): 0; mW/(m·K): -3; W/mK: 0; W/(mK): 0; W/m·K: 0; W/m/K: 0"},
           {"m/s", "cm/s: -2"}})
    for (std::size_t at = 0; at < units.size();) {
      const std::size_t colon = units.find(": ", at), end = units.find("; ", colon);
      all.push_back({units.substr(at, colon - at), si, std::atoi(&units[colon + 2])});
      at = end == std::string::npos ? end : end + 2;
    }
  return all;
}
const std::vector<Unit> units = all_units();

// 1 to 17 digits.
std::string random_digits(Sampler& sampler) {
  std::string digits;
  const int count = sampler.pick({1, 2, 3, 4, 6, 9, 12, 15, 17});
  for (int i = 0; i < count; ++i)
    digits += static_cast<char>('0' + static_cast<int>(sampler.uniform(0, 10)));
  return digits;
}

// The digits with a point before the digit `place`, and zeros where there are no digits.
std::string with_point(const std::string& digits, int place) {
  const int count = static_cast<int>(digits.size());
  if (place <= 0) return "0." + std::string(static_cast<std::size_t>(-place), '0') + digits;
  if (place >= count) return digits + std::string(static_cast<std::size_t>(place - count), '0');
  return digits.substr(0, static_cast<std::size_t>(place)) + '.' +
         digits.substr(static_cast<std::size_t>(place));
}

Value text_of(const std::string& text) { return {.kind = ValueKind::text, .text = text}; }

TEST(Units, KeepTheDigitsAndSoTheBits) {
  Sampler sampler(71);
  for (const Unit& unit : units)
    for (int i = 0; i < 200; ++i) {
      const std::string digits = random_digits(sampler);
      const int place = static_cast<int>(sampler.uniform(-3, 20));
      const std::string sign = sampler.pick({"", "-", "+"});
      const std::string exponent = sampler.pick({"", "e7", "E-12", "e+05"});
      const int moved = exponent.empty() ? 0 : std::atoi(exponent.c_str() + 1);
      // Without a blank "12" and "1/mm2" would become another number.
      const bool is_clear = exponent.empty() && unit.written[0] != '1';
      const std::string blank = is_clear ? sampler.pick({"", " ", "  "}) : " ";
      const std::string text = sign + with_point(digits, place) + exponent + blank + unit.written;
      const Value value = in_si(text_of(text), unit.si);
      ASSERT_EQ(value.kind, ValueKind::number) << text;
      EXPECT_EQ(value.fault, NumberFault::none) << text;
      const std::string plain = sign + with_point(digits, place + moved + unit.power);
      EXPECT_EQ(value.number, std::strtod(plain.c_str(), nullptr)) << text << ' ' << plain;
    }
}

TEST(Units, CelsiusIsTheExactDecimalSum) {
  Sampler sampler(72);
  for (int i = 0; i < 2000; ++i) {
    const int decimals = sampler.pick({0, 1, 2, 3, 5});
    const auto scale = static_cast<std::int64_t>(std::pow(10, decimals));
    const auto celsius =
        static_cast<std::int64_t>(sampler.uniform(-270, 1000) * static_cast<double>(scale));
    const std::int64_t kelvins = celsius * 100 + 27315 * scale;  // in 10^−decimals−2 K
    const std::string degrees =
        (celsius < 0 ? "-" : "") +
        with_point(std::to_string(std::abs(celsius)),
                   static_cast<int>(std::to_string(std::abs(celsius)).size()) - decimals);
    const std::string wanted = with_point(
        std::to_string(kelvins), static_cast<int>(std::to_string(kelvins).size()) - decimals - 2);
    for (const char* unit : {" °C", "℃", " degC", " C"}) {
      const Value value = in_si(text_of(degrees + unit), "K");
      ASSERT_EQ(value.kind, ValueKind::number) << degrees << unit;
      EXPECT_EQ(value.number, std::strtod(wanted.c_str(), nullptr)) << degrees << ' ' << wanted;
    }
  }
}

TEST(Units, DistancesOfTemperaturesAreTheSameInCelsiusAndInKelvin) {
  for (const char* unit : {" °C", "℃", " degC", " C", " K"})
    EXPECT_EQ(si_decimal(std::string("5.0") + unit, "K", Measure::distance), "5.0e0") << unit;
  EXPECT_NE(si_decimal("5.0 °C", "K"), "5.0e0");
  EXPECT_EQ(si_decimal("5.0 °F", "K", Measure::distance), std::nullopt);
}

TEST(Units, HalfALastDigitIsOneOfTheNumberAsItIsWritten) {
  const struct {
    const char *text, *half;
  } written[] = {{"0.0202", "0.00005"},
                 {"50", "0.5"},
                 {"5.", "0.5"},
                 {"-4.128 mm", "0.0005 mm"},
                 {"2.0e-8 m", "0.05e-8 m"},
                 {"75 °C", "0.5 °C"},
                 {"6.2 km/h", "0.05 km/h"},
                 {"1/2", "0.5/2"}};
  for (const auto& one : written) {
    const auto half = scene_detail::half_last_digit(one.text);
    ASSERT_TRUE(half) << one.text;
    EXPECT_EQ(std::strtod(half->c_str(), nullptr), std::strtod(one.half, nullptr)) << *half;
    EXPECT_EQ(half->substr(half->find('5') + 1),
              std::string_view(one.half).substr(std::string_view(one.half).find('5') + 1));
  }
  for (const char* text : {"", "inf", "fifty", ".", "mm"})
    EXPECT_EQ(scene_detail::half_last_digit(text), std::nullopt) << text;
}

TEST(Units, EachFitsItsOwnFieldsAlone) {
  for (const Unit& unit : units)
    for (const Unit& other : units) {
      const bool fits = unit.si == other.si;
      EXPECT_EQ(si_decimal("2 " + unit.written, other.si).has_value(), fits)
          << unit.written << " for " << other.si;
    }
  for (const char* text :
       {"", "m", "2", " m", "2e m", "2 mm m", "2 Mm²", "2 m2", "2,5 m", "2..5 m", "2-3 m", "--2 m",
        "1e+-3 m", "0x10 m", "inf m", "nan m", "2 m\n", "2 °C"})
    EXPECT_EQ(si_decimal(text, "m"), std::nullopt) << text;
}

TEST(Units, NumbersBeyondDoubleAreToldAsSuch) {
  for (const char* text : {"1e400 mm", "-1e309 m", "1e99999999999 nm", "1e308 km"})
    EXPECT_EQ(in_si(text_of(text), "m").fault, NumberFault::overflow) << text;
  for (const char* text : {"1e-400 km", "1e-322 mm", "1e-99999999999 m"})
    EXPECT_EQ(in_si(text_of(text), "m").fault, NumberFault::underflow) << text;
  EXPECT_EQ(in_si(text_of("1e400 °C"), "K").fault, NumberFault::overflow);
  EXPECT_EQ(in_si(text_of("0e-400 km"), "m").number, 0);
}

TEST(Units, EveryFieldWithAUnitTakesThoseThatItsMessageNames) {
  for (const FieldInfo& field : scene_fields()) {
    if (!scene_detail::takes_units(field)) continue;
    const std::string_view written = scene_detail::written_unit(field);
    const std::string usual(scene_detail::usual_units(written));
    ASSERT_FALSE(usual.empty()) << field.path;
    const SceneText base = SceneText::good_with(field);
    std::size_t start = 0;
    while (start < usual.size()) {
      std::size_t end = std::min(usual.find(", ", start), usual.find(" or ", start));
      end = std::min(end, usual.size());
      const std::string unit = usual.substr(start, end - start);
      start = usual.compare(end, 2, ", ") == 0 ? end + 2 : end + 4;
      const auto number = si_decimal("3 " + unit, written);
      ASSERT_TRUE(number) << field.path << ' ' << unit;
      SceneText with_unit = base, in_si_units = base;
      with_unit.set(field.path, "\"3 " + unit + '"');
      in_si_units.set(field.path, *number);
      for (const Format format : formats) {
        const SceneReading left = read(format, with_unit), right = read(format, in_si_units);
        EXPECT_EQ(lines_of(left.errors), lines_of(right.errors)) << field.path;
        EXPECT_EQ(lines_of(left.warnings), lines_of(right.warnings)) << field.path;
      }
    }
    EXPECT_TRUE(refused(SceneText(base).set(field.path, "\"3 parsec\""), field.path,
                        "\"3 parsec\" is not in a unit that fits; allowed: "));
    EXPECT_TRUE(refused(SceneText(base).set(field.path, "\"3 parsec\""), field.path,
                        "or a text in " + usual));
  }
}

TEST(Units, MayStandInListsAndRangesOfSpeeds) {
  for (const Format format : formats) {
    SceneText text = SceneText::good();
    const auto list = read(format, text.set("speed", "[\"20.2 mm/s\", 0.1, \"3 m/s\"]"));
    ASSERT_TRUE(list.scene) << lines_of(list.errors);
    EXPECT_EQ(list.scene->speeds.list, (std::vector<double>{0.0202, 0.1, 3}));
    text.remove("speed").set("speed.from", "\"0.1 mm/s\"").set("speed.to", "\"3 m/s\"");
    const auto range = read(format, text);
    ASSERT_TRUE(range.scene) << lines_of(range.errors);
    EXPECT_EQ(range.scene->speeds.from, 1e-4);
    EXPECT_EQ(range.scene->speeds.to, 3);
  }
  EXPECT_TRUE(refused(SceneText::good().set("speed", "[\"1 m/s\", \"2 m\"]"), "speed[1]",
                      "\"2 m\" is not in a unit that fits"));
}

TEST(Units, AnotherQuantityIsNamed) {
  EXPECT_TRUE(refused(SceneText::good().set("lubricant.viscosity", "\"20.4 cSt\""),
                      "lubricant.viscosity", "write it as kinematic_viscosity, with density"));
  for (const char* turns : {"3000 rpm", "3000 1/min", "3000 min^-1"})
    EXPECT_TRUE(refused(SceneText::good().set("speed", '"' + std::string(turns) + '"'), "speed",
                        "is a speed of rotation, and speed is the mean speed of the two surfaces"));
  EXPECT_TRUE(refused(SceneText::good().set("load", "[20, 50]"), "load",
                      "a sweep takes lists: tribocheck sweep"));
  const SceneText faces = SceneText::good().set("surface.rms_roughness", "[[1e-8, 2e-8], [1e-9]]");
  EXPECT_TRUE(refused(faces, "surface.rms_roughness", "a list of two faces takes no lists"));
  for (const Format format : formats)
    EXPECT_EQ(lines_of(read(format, faces).errors).find("tribocheck sweep"), std::string::npos);
}

TEST(Units, ANumberWithItsSpreadIsSentToASweep) {
  for (const char* spread : {"30 ± 5 nm", "30 +- 5 nm", "30±5 nm"})
    EXPECT_TRUE(
        refused(SceneText::good().set("surface.summit_radius", '"' + std::string(spread) + '"'),
                "surface.summit_radius",
                "is a number with its spread, which a sweep takes as { distribution"));
  const SceneText wrong = SceneText::good().set("surface.summit_radius", "\"30 bm\"");
  EXPECT_TRUE(refused(wrong, "surface.summit_radius", "\"30 bm\" is not in a unit that fits"));
  for (const Format format : formats)
    EXPECT_EQ(lines_of(read(format, wrong).errors).find("with its spread"), std::string::npos);
}

TEST(Units, PerCentFitsCoefficientsAndRatiosOfSpeedsAlone) {
  SceneText text = SceneText::good();
  text.set("friction.boundary_coefficient", "\"13 %\"");
  text.set("friction.slide_roll_ratio", "\"40%\"");
  for (const Format format : formats) {
    const SceneReading scene = read(format, text);
    ASSERT_TRUE(scene.scene) << lines_of(scene.errors);
    EXPECT_EQ(scene.scene->friction.boundary_coefficient, 0.13);
    EXPECT_EQ(scene.scene->friction.slide_roll_ratio, 0.4);
  }
  EXPECT_TRUE(refused(SceneText::good().set("friction.boundary_coefficient", "\"0.13 Pa\""),
                      "friction.boundary_coefficient",
                      "\"0.13 Pa\" is not in a unit that fits; allowed: "));
  EXPECT_TRUE(refused(SceneText::good().set("load", "\"40 %\""), "load",
                      "\"40 %\" is not in a unit that fits"));
}

TEST(Units, NumbersWithoutAUnitHaveNone) {
  EXPECT_TRUE(refused(SceneText::good().set("surface.summit_plane_offset", "\"40 %\""),
                      "surface.summit_plane_offset",
                      "\"40 %\" is a text, and this number has no unit"));
  EXPECT_TRUE(refused(SceneText::good().set("surface.offset_planes", "\"1 m\""),
                      "surface.offset_planes", "is a text, and this number has no unit"));
}

}  // namespace
}  // namespace tribo::scene_test
