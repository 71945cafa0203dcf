// SPDX-License-Identifier: Apache-2.0
// The stream's reader of ordinary lines against the reader of any JSON: on every field, on numbers
// that are hard to round, and on lines spoilt at random.
#include "protocol/ordinary_scene.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <vector>

#include "scene/scene_text.hpp"
#include "scene/spoilt_text.hpp"
#include "stress/fuzz/checks.hpp"

namespace tribo::fuzz {
namespace {

using scene_test::SceneText;

bool is_taken(const std::string& line) {
  return protocol::read_ordinary_scene(line, "").has_value();
}

std::string good_line() { return SceneText::good().json(); }

// Two lines for every field: one that has it, and one that has it twice.
std::vector<std::string> lines_of_every_field() {
  std::vector<std::string> lines;
  for (const FieldInfo& field : scene_fields()) {
    lines.push_back(SceneText::good_with(field).json());
    const std::size_t dot = field.path.find('.');
    if (dot == std::string_view::npos)
      lines.push_back("{\"" + std::string(field.path) + "\": 1, " + lines.back().substr(1));
    else
      lines.push_back("{\"" + std::string(field.path.substr(0, dot)) + "\": {\"" +
                      std::string(field.path.substr(dot + 1)) + "\": 1}, " +
                      lines.back().substr(1));
  }
  return lines;
}

// The reader of ordinary lines leaves lists of pairs to the other reader.
TEST(OrdinaryScene, EveryFieldIsReadAlike) {
  for (const std::string& line : lines_of_every_field()) {
    EXPECT_EQ(is_taken(line), line.find("[[") == std::string::npos) << line;
    EXPECT_EQ(broken_property(check_ordinary_scene, line), "");
  }
}

// Names that differ from those of the line before are looked up anew: another table, a name of the
// same length, and a name that becomes a table.
TEST(OrdinaryScene, NamesAreThoseOfTheirLineAndNotOfTheOneBefore) {
  const std::string rest = good_line().substr(1);
  const std::string pairs[][2] = {
      {R"({"friction": {"fluid": "eyring"}, )", R"({"closures": {"fluid": "eyring"}, )"},
      {R"({"lubricant": {"viscosity": 1}, )", R"({"lubricant": {"viscosita": 1}, )"},
      {R"({"speed": 1, )", R"({"speed": {"from": 1}, )"},
      {R"({"load": 1, )", R"({"loax": 1, )"}};
  for (const auto& [before, after] : pairs)
    for (const std::string& line : {before + rest, after + rest, before + rest})
      EXPECT_EQ(broken_property(check_ordinary_scene, line), "") << line;
}

TEST(OrdinaryScene, ZerosAreToldFromUnderflows) {
  for (const char* zero : {"0.0", "-0.0", "0e0", "0.000e-99", "0E-1"}) {
    const std::string line = SceneText::good().set("surface.summit_plane_offset", zero).json();
    EXPECT_EQ(is_taken(line), true) << line;
    EXPECT_EQ(broken_property(check_ordinary_scene, line), "");
  }
  for (std::size_t zeros = 0; zeros < 400; ++zeros)
    for (const char* end : {"", "e-1", "e-99", "E-99", "e-100", "e-0100", "e-324", "e99"}) {
      const std::string number = "0." + std::string(zeros, '0') + '1' + end;
      const std::string line = SceneText::good().set("surface.summit_plane_offset", number).json();
      EXPECT_EQ(broken_property(check_ordinary_scene, line), "");
    }
}

TEST(OrdinaryScene, WhatSimdjsonReadsOtherwiseIsLeft) {
  for (const char* number : {"1e-400", "0e-400", "1e400", "9223372036854775808",
                             "99999999999999999999", "true", "null", "[[1]]", "{}"}) {
    const std::string line = SceneText::good().set("load", number).json();
    EXPECT_EQ(is_taken(line), false) << line;
    EXPECT_EQ(broken_property(check_ordinary_scene, line), "");
  }
  const std::string line = good_line();
  for (const char* start : {R"("surface.offset_planes": 1, )", R"("laod": 1, )",
                            R"("surfaces": {"offset_planes": 1}, )"}) {
    const std::string longer = '{' + (start + line.substr(1));
    EXPECT_EQ(is_taken(longer), false) << longer;
    EXPECT_EQ(broken_property(check_ordinary_scene, longer), "");
  }
  EXPECT_EQ(is_taken(line + std::string(5000, ' ')), false);
  std::string many = "{\"load\": 1";
  for (int i = 0; i < 80; ++i) many += ", \"load\": 1";
  EXPECT_EQ(is_taken(many + '}'), false);
}

std::string printed(const char* format, double number) {
  char text[400];
  std::snprintf(text, sizeof text, format, number);
  return text;
}

// Any finite double, also a subnormal one, in the forms that programs write.
std::string random_number(std::mt19937_64& random) {
  double number = std::bit_cast<double>(random());
  if (!std::isfinite(number)) number = 0x1p-1060 * static_cast<double>(random() % 9999);
  int exponent = 0;
  switch (random() % 6) {
    case 0:
      return printed("%.17g", number);
    case 1:
      return printed("%.16e", number);
    case 2:
      return printed("%.3g", number);
    case 3:
      return printed("%.40e", number);
    case 4:
      return std::to_string(static_cast<std::int64_t>(random()) >> random() % 64);
    default:
      return printed("%.6f", 1e12 * std::frexp(number, &exponent));
  }
}

// All digits of the number half-way between two doubles, or of one a little above. A parser that
// rounds twice reads it wrongly.
std::string halfway_number(std::mt19937_64& random) {
  const double low = std::ldexp(1 + static_cast<double>(random() >> 12) * 0x1p-52,
                                static_cast<int>(random() % 200) - 100);
  const long double half = (static_cast<long double>(low) + std::nextafter(low, HUGE_VAL)) / 2;
  char text[300];
  std::snprintf(text, sizeof text, "%.240Le", half);
  std::string number = text;
  if (random() % 3 == 0) number.insert(number.find('e'), "1");
  return number;
}

TEST(OrdinaryScene, NumbersAreReadToTheSameBit) {
  std::mt19937_64 random(20240711);
  int taken = 0;
  for (int round = 0; round < 20000; ++round) {
    const std::string line = SceneText::good()
                                 .set("load", random_number(random))
                                 .set("surface.summit_plane_offset", halfway_number(random))
                                 .set("bodies.reduced_radius", halfway_number(random))
                                 .json();
    if (is_taken(line)) ++taken;
    EXPECT_EQ(broken_property(check_ordinary_scene, line), "");
  }
  EXPECT_GT(taken, 19000);
  for (const char* edge :
       {"1.7976931348623157e308", "1.7976931348623158e308", "1.7976931348623159e308",
        "2.2250738585072014e-308", "2.2250738585072011e-308", "4.9406564584124654e-324",
        "2.4703282292062328e-324", "2.4703282292062327e-324", "-0", "9007199254740993",
        "9007199254740992.999999999999999999999999999999", "9223372036854775807", "1E+2", "1e02"})
    EXPECT_EQ(broken_property(check_ordinary_scene, SceneText::good().set("load", edge).json()),
              "");
}

// Halves of surrogate pairs are no JSON, wherever they stand.
TEST(OrdinaryScene, EscapesAreReadAlike) {
  for (unsigned code = 0; code < 0x10000; code += code % 0x800 < 0x100 ? 1 : 0x25)
    for (const char* after : {"", "\\udc00", "\\udfff", "\\ud800", "\\u0041", "x"}) {
      char text[40];
      std::snprintf(text, sizeof text, "\"a\\u%04x%s\"", code, after);
      const std::string line = SceneText::good().set("id", text).json();
      EXPECT_EQ(broken_property(check_ordinary_scene, line), "");
    }
  for (const char* id :
       {R"("\"\\\/\b\f\n\r\t")", R"("\x41")", R"("\")", R"("\'")", R"("\U0041")", R"("\u00g0")"})
    EXPECT_EQ(broken_property(check_ordinary_scene, SceneText::good().set("id", id).json()), "");
  EXPECT_EQ(is_taken(SceneText::good().set("id", R"("\u00e9\ud83d\ude00")").json()), true);
  EXPECT_EQ(is_taken(SceneText::good().set("id", R"("\ud83d")").json()), false);
}

TEST(OrdinaryScene, LinesSpoiltAtRandomAreReadAlike) {
  const std::vector<std::string> lines = lines_of_every_field();
  std::mt19937_64 random(20240712);
  int taken = 0;
  for (int round = 0; round < 30000; ++round) {
    std::string line = lines[random() % lines.size()];
    for (std::size_t change = random() % 4; change > 0; --change) scene_test::spoil(line, random);
    if (is_taken(line)) ++taken;
    EXPECT_EQ(broken_property(check_ordinary_scene, line), "");
  }
  EXPECT_GT(taken, 8000);
}

}  // namespace
}  // namespace tribo::fuzz
