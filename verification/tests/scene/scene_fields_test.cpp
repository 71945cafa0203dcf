// SPDX-License-Identifier: Apache-2.0
// Every field of the schema, spoilt in every way, in TOML and in JSON. The legal values follow from
// the field's row in the table alone, so that a new row is tested without a change here.
#include <algorithm>
#include <cmath>
#include <optional>

#include "scene/scene_text.hpp"
#include "scene/schema.hpp"
#include "support/scenes.hpp"
#include "support/threshold.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/smooth_contact.hpp"

namespace tribo::scene_test {
namespace {

using verification::changes_at_its_limit;
using verification::True;

std::vector<FieldInfo> number_fields() {
  std::vector<FieldInfo> numbers;
  for (const FieldInfo& field : scene_fields())
    if (field.type == FieldType::number || field.type == FieldType::integer ||
        field.type == FieldType::speeds)
      numbers.push_back(field);
  return numbers;
}

bool is_legal(const FieldInfo& field, double value) {
  if (field.is_radius_of_face) return value != 0;
  if (field.exclusive_minimum ? value <= field.minimum : value < field.minimum) return false;
  return !field.maximum || value <= *field.maximum;
}

std::string decimal(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

// Numbers of an oil that are legal one by one may together give no viscosity, or heat the inlet
// more than its law takes.
bool is_of_an_oil(const FieldInfo& field) {
  return field.path == "lubricant.iso_vg" || field.path == "lubricant.viscosity_index" ||
         field.path.starts_with("lubricant.temperature") || field.path == "lubricant.density" ||
         field.path == "lubricant.conductivity";
}

void expect_judged(const FieldInfo& field, const std::string& value, bool legal,
                   const char* part = "not allowed") {
  SceneText text = SceneText::good_with(field).set(field.path, value);
  // Film laws of soft bodies do not need the rise of the viscosity.
  if (field.path == "lubricant.pressure_viscosity")
    text.set("closures.film", "\"hamrock_dowson_soft_central\"");
  // Moments that are legal one by one may together belong to no face. Double may be unable to
  // hold the ratio of legal radii, or the E* of moduli next to 0.
  const bool is_least_modulus =
      (field.path == "bodies.first_modulus" || field.path == "bodies.second_modulus") &&
      std::strtod(value.c_str(), nullptr) < std::numeric_limits<double>::min();
  if (!legal) {
    EXPECT_TRUE(refused(text, field.path, part));
  } else if (is_of_an_oil(field) || field.path.starts_with("surface.m") ||
             field.path.ends_with("radius_x") || field.path.ends_with("radius_y") ||
             is_least_modulus) {
    for (const Format format : formats)
      EXPECT_FALSE(has_problem(read(format, text).errors, field.path, "allowed: a number above"));
  } else {
    EXPECT_TRUE(accepted(text));
  }
}

TEST(SceneFields, GoodValueOfEachIsAccepted) {
  for (const FieldInfo& field : scene_fields()) EXPECT_TRUE(accepted(SceneText::good_with(field)));
}

bool is_of_a_set(std::string_view path) {
  for (const FieldGroup group : scene_field_groups())
    for (const FieldSet& set : group)
      if (std::find(set.fields.begin(), set.fields.end(), path) != set.fields.end()) return true;
  return false;
}

TEST(SceneFields, MissingOneIsAnErrorOnlyIfRequired) {
  for (const FieldInfo& field : scene_fields()) {
    const SceneText text = SceneText::good_with(field).remove(field.path);
    if (is_of_a_set(field.path))
      for (const Format format : formats)
        EXPECT_NE(read(format, text).errors.at(0).message().find("missing"), std::string::npos)
            << field.path;
    else if (field.required || field.type == FieldType::speeds)
      EXPECT_TRUE(refused(text, field.path, "missing"));
    else
      EXPECT_TRUE(accepted(text));
  }
}

TEST(SceneFields, MisspeltOneIsNamedWithTheRightName) {
  for (const FieldInfo& field : scene_fields()) {
    const std::string misspelt(field.path.substr(0, field.path.size() - 1));
    std::string meant(field.path);
    // The field with this end is as near, and comes first in the table.
    if (meant.ends_with("_y")) meant.back() = 'x';
    if (meant == "surface.m2" || meant == "surface.m4") meant.back() = '0';
    EXPECT_TRUE(refused(SceneText::good_with(field).rename(field.path, misspelt), misspelt,
                        "did you mean " + meant + "?"));
  }
}

TEST(SceneFields, OneInAWrongTableIsNamedWithTheRightPlace) {
  for (const FieldInfo& field : scene_fields()) {
    if (field.path.find('.') == std::string_view::npos || field.path.starts_with("speed."))
      continue;
    if (field.path == "friction.viscosity") continue;  // lubricant.viscosity is as near
    const std::string name(field.path.substr(field.path.find('.') + 1));
    EXPECT_TRUE(refused(SceneText::good_with(field).rename(field.path, name), name,
                        "did you mean " + std::string(field.path) + "?"));
  }
}

TEST(SceneFields, WrongTypeIsNamed) {
  struct Case {
    const char* toml;
    const char* json;
    const char* part;
    std::vector<FieldType> right_for;
  };
  using enum FieldType;
  const Case cases[] = {
      {"true", "true", "true is a boolean", {}},
      {"\"abc\"", "\"abc\"", "\"abc\" is", {text}},
      {"12", "12", "12 is a number", {number, integer, speeds}},
      {"[\"abc\"]", "[\"abc\"]", "this is a list", {speeds, outputs, limits, viscosities}},
      {"{}", "{}", "this is a table", {speeds}},
      {"{ a = 1 }", "{\"a\": {\"b\": [1]}}", "this is a table", {speeds}},
      {"1979-05-27", "null", "this is ", {}},
  };
  for (const FieldInfo& field : scene_fields()) {
    for (const Case& wrong : cases) {
      if (std::find(wrong.right_for.begin(), wrong.right_for.end(), field.type) !=
          wrong.right_for.end())
        continue;
      SceneText text = SceneText::good_with(field);
      EXPECT_TRUE(
          refused(Format::toml, text.set(field.path, wrong.toml).toml(), field.path, wrong.part));
      EXPECT_TRUE(
          refused(Format::json, text.set(field.path, wrong.json).json(), field.path, wrong.part));
    }
  }
}

TEST(SceneFields, ZeroIsLegalExactlyWhereTheTableSaysSo) {
  for (const FieldInfo& field : number_fields()) {
    for (const char* zero : {"0", "0.0", "-0.0", "-0", "0e5"})
      expect_judged(field, zero, is_legal(field, 0));
  }
  EXPECT_TRUE(refused(SceneText::good().set("lubricant.pressure_viscosity", "0"),
                      "lubricant.pressure_viscosity", "whose film would be 0"));
}

TEST(SceneFields, NegativeNumbersAreRefused) {
  for (const FieldInfo& field : number_fields()) {
    if (is_legal(field, -0.1)) continue;
    for (const char* value : {"-1", "-4.94e-324", "-1.5e300"}) {
      const bool whole = field.type != FieldType::integer || std::string(value) == "-1";
      expect_judged(field, value, false, whole ? "not allowed" : "");
    }
  }
}

// The range in the words of messages, without its unit.
std::string range_of(const FieldInfo& field) {
  const auto short_text = [](double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%g", value);
    std::string told = text;
    if (const auto at = told.find("e+0"); at != std::string::npos) told.erase(at + 2, 1);
    return told;
  };
  const std::string least = short_text(field.minimum);
  if (field.maximum)
    return (field.exclusive_minimum ? "above " + least + " and at most "
                                    : "from " + least + " to ") +
           short_text(*field.maximum);
  return (field.exclusive_minimum ? "above " : "not below ") + least;
}

TEST(SceneFields, ANumberOutsideIsRefusedWithTheRange) {
  for (const FieldInfo& field : number_fields()) {
    if (field.is_radius_of_face) continue;
    const std::string kind = field.type == FieldType::integer ? "a whole number " : "a number ";
    const std::string told = "allowed: " + kind + range_of(field);
    expect_judged(field, decimal(field.minimum - 1), false, told.c_str());
    if (field.maximum) expect_judged(field, decimal(*field.maximum + 1), false, told.c_str());
  }
}

TEST(SceneFields, EndsOfTheRangeAreJudgedToTheLastBit) {
  for (const FieldInfo& field : number_fields()) {
    const bool is_whole = field.type == FieldType::integer;
    const double least = is_whole ? field.minimum : std::nextafter(field.minimum, 1);
    const double greatest = field.maximum.value_or(std::numeric_limits<double>::max());
    // speed.to has to be above speed.from.
    if (field.path != "speed.to") expect_judged(field, decimal(least), true);
    if (field.path != "speed.from") expect_judged(field, decimal(greatest), true);
    if (field.maximum && !is_whole)
      expect_judged(field, decimal(std::nextafter(greatest, 2 * greatest)), false);
  }
}

TEST(SceneFields, NumbersBeyondDoubleAreRefusedWithTheFieldAndTheValue) {
  for (const FieldInfo& field : number_fields()) {
    const char* wide[] = {"1e400", "-1e400", "1e309", "123456789e99999999999999999999"};
    for (const char* value : wide)
      expect_judged(field, value, false, (std::string(value) + " is beyond").c_str());
    for (const char* value : {"1e-400", "-1e-400", "0.1e-400"})
      expect_judged(field, value, false, (std::string(value) + " underflows").c_str());
  }
}

TEST(SceneFields, NanAndInfinityAreRefused) {
  for (const FieldInfo& field : number_fields()) {
    const auto hold = [&](Format format, std::initializer_list<const char*> values) {
      for (const char* value : values)
        EXPECT_TRUE(refused(format,
                            SceneText::good_with(field).set(field.path, value).written(format),
                            field.path, "must be finite"));
    };
    hold(Format::toml, {"nan", "-nan"});
    if (field.is_radius_of_face) continue;  // ∞ is a flat face
    hold(Format::toml, {"inf", "+inf", "-inf"});
    hold(Format::json, {"NaN", "nan", "Infinity", "-Infinity", "inf", "-inf"});
  }
}

TEST(SceneFields, WholeNumbersMayBeWrittenAsFloatsButNotWithAFraction) {
  for (const FieldInfo& field : scene_fields()) {
    if (field.type != FieldType::integer) continue;
    expect_judged(field, "2.0", true);
    expect_judged(field, "2e0", true);
    expect_judged(field, "1.5", false, "1.5 is not whole");
  }
}

TEST(SceneFields, NumbersMayBeWrittenAsIntegersOfAnyLength) {
  for (const FieldInfo& field : scene_fields()) {
    if (field.type != FieldType::number || field.path == "speed.from" || field.maximum) continue;
    for (const char* value :
         {"12", "9007199254740993", "9223372036854775808", "123456789012345678901234567890"})
      expect_judged(field, value, true);
  }
}

TEST(SceneFields, UnknownChoiceIsRefusedWithTheNearest) {
  for (const FieldInfo& field : scene_fields()) {
    if (field.type != FieldType::choice) continue;
    for (const std::string_view choice : field.choices) {
      const std::string value = '"' + std::string(choice) + "x\"";
      expect_judged(field, value, false, ("did you mean " + std::string(choice) + "?").c_str());
    }
    expect_judged(field, "\"\"", false, "is not known; allowed: ");
  }
}

TEST(SceneFields, EachGivenTwiceIsRefused) {
  for (const FieldInfo& field : scene_fields()) {
    const SceneText text = SceneText::good_with(field);
    const std::string value = SceneText::good_value(field);
    const std::string again = std::string(field.path) + " = " + value + "\n";
    EXPECT_TRUE(refused(Format::toml, text.toml() + again, field.path, "given twice"));
    std::string json = text.json();
    const std::string name(field.path.substr(field.path.rfind('.') + 1));
    const std::string pair = '"' + name + "\": " + value;
    // The pair is looked for in its own table: friction.viscosity is not lubricant.viscosity.
    const std::string section(field.path.substr(0, field.path.size() - name.size()));
    const std::size_t table =
        section.empty() ? 0 : json.find('"' + section.substr(0, section.size() - 1) + "\": {");
    json.insert(json.find(pair, table), pair + ", ");
    EXPECT_TRUE(refused(Format::json, json, field.path, "given twice"));
  }
}

// Each end of each plausible range is tested; for speeds also with the number in a list.
TEST(SceneFields, ImplausibleNumbersPassALimitFromTheFirstBeyondTheRangeOn) {
  for (const FieldInfo& field : number_fields()) {
    const std::string name(
        field.path.starts_with("speed.") ? "speed" : field.path.substr(field.path.rfind('.') + 1));
    const double least = field.plausible_minimum, greatest = field.plausible_maximum;
    if (field.type == FieldType::integer || (least == 0 && std::isinf(greatest))) continue;
    for (const bool in_list : {false, true}) {
      if (in_list && field.type != FieldType::speeds) continue;
      const auto is_warned = [&](double value) {
        SceneText text = SceneText::good_with(field);
        text.set(field.path, in_list ? "[1, " + decimal(value) + "]" : decimal(value));
        if (name == "damiens_exponent") text.set("closures.starvation", "\"damiens\"");
        for (const auto& [moment, wide] : {std::pair("m0", "1e10"), {"m2", "1e-3"}, {"m4", "1e30"}})
          if (name.size() == 2 && name != moment) text.set("surface." + std::string(moment), wide);
        return passes(text, name + "_range");
      };
      if (least == 0 && field.minimum < 0) {
        EXPECT_FALSE(is_warned(0)) << name;
        EXPECT_TRUE(is_warned(-std::numeric_limits<double>::min())) << name;
      } else if (least > field.minimum && field.path != "speed.to") {
        EXPECT_TRUE(changes_at_its_limit({name, least, True::below, is_warned}));
      }
      if (std::isfinite(greatest) && greatest != field.maximum && field.path != "speed.from") {
        EXPECT_TRUE(changes_at_its_limit({name, greatest, True::above, is_warned}));
      }
    }
  }
}

TEST(SceneFields, PlausibleRangesLieWithinTheLegalOnes) {
  for (const FieldInfo& field : scene_fields()) {
    if (field.type == FieldType::integer) continue;
    EXPECT_LE(field.minimum, field.plausible_minimum) << field.path;
    EXPECT_LE(field.plausible_minimum, field.plausible_maximum) << field.path;
    // The ends are rough: a power of ten, twice a power of ten, or half of one.
    for (const double end : {field.plausible_minimum, field.plausible_maximum}) {
      if (end == 0 || std::isinf(end)) continue;
      const auto is_power_of_ten = [](double number) {
        const double power = std::log10(std::abs(number));
        return std::abs(power - std::round(power)) < 1e-12;
      };
      EXPECT_TRUE(is_power_of_ten(end) || is_power_of_ten(2 * end) || is_power_of_ten(end / 2))
          << field.path << ' ' << end;
    }
    EXPECT_FALSE(field.meaning.empty()) << field.path;
  }
}

// Tests that compare two texts of a formula at random scenes do not see a field that these never
// change. Sets that take the place of others are left out: a scene has one set of a group.
TEST(RandomScenes, DrawEachFieldOfTheTable) {
  const auto takes_the_place_of_others = [](std::string_view path) {
    for (const FieldGroup& group : scene_field_groups())
      for (const FieldSet& set : group.subspan(1))
        if (std::find(set.fields.begin(), set.fields.end(), path) != set.fields.end()) return true;
    return false;
  };
  for (const FieldInfo& field : number_fields()) {
    if (field.path.starts_with("speed") || takes_the_place_of_others(field.path)) continue;
    if (field.path == "surface.average_roughness") continue;  // in place of rms_roughness
    const std::size_t place = scene_detail::field_at(field.path);
    verification::Sampler sampler(12);
    std::optional<double> first;
    bool varies = false, moves = false;
    for (int i = 0; i < 500 && !(varies && moves); ++i) {
      const Scene scene = verification::random_scene(sampler);
      const std::optional<double> value = scene_detail::value_in(scene, place);
      if (!value) continue;
      varies = varies || *value != first.value_or(*value);
      first = value;
      Scene moved = scene;
      scene_detail::store_of(place)(moved, *value == 0 ? 1 : *value * 2);
      const double speed = scene.speeds.list.front();
      const MixedContact<double> before(scene), after(moved);
      moves = moves || numbers_of(before.solve(speed)) != numbers_of(after.solve(speed)) ||
              SmoothContact(before).value(Output::lambda_ratio, speed, 1) !=
                  SmoothContact(after).value(Output::lambda_ratio, speed, 1);
    }
    EXPECT_EQ(varies, true) << field.path << " is the same in 500 random scenes: draw it in "
                            << "verification/tests/support/scenes.hpp";
    EXPECT_EQ(moves, true) << field.path << " moves no output of 500 random scenes";
  }
}

}  // namespace
}  // namespace tribo::scene_test
