// SPDX-License-Identifier: Apache-2.0
// The scene that a good text becomes, and the rules that look at more than one field.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "scene/scene_text.hpp"
#include "support/judge.hpp"
#include "support/threshold.hpp"
#include "tribo/film_thickness.hpp"
#include "tribo/hertz_ellipse.hpp"
#include "tribo/spectral_moments.hpp"

namespace tribo::scene_test {
namespace {

SceneText good() { return SceneText::good(); }

TEST(Scene, GetsEveryFieldInItsPlace) {
  SceneText text = good();
  text.set("surface.offset_planes", "2").set("bodies.ellipticity", "1.5");
  text.set("friction.slide_roll_ratio", "0.25").set("friction.fluid", "\"limiting\"");
  text.set("friction.viscosity", "\"roelands\"").set("closures.starvation", "\"damiens\"");
  text.set("closures.asperity", "\"greenwood_williamson\"").set("closures.damiens_exponent", "2.5");
  text.set("closures.film", "\"hamrock_dowson_minimum\"");
  text.set("outputs", R"(["film", "friction"])");
  for (const Format format : formats) {
    const SceneReading reading = read(format, text);
    ASSERT_TRUE(reading.scene) << lines_of(reading.errors);
    const Scene& scene = *reading.scene;
    EXPECT_EQ(scene.id, "rough");
    EXPECT_EQ(reading.id, "rough");
    EXPECT_EQ(scene.load, 50);
    ASSERT_EQ(scene.speeds.size(), 1u);
    EXPECT_EQ(scene.speeds[0], 0.1);
    EXPECT_EQ(scene.surface.summit_density, 5e10);
    EXPECT_EQ(scene.surface.summit_radius, 1e-5);
    EXPECT_EQ(scene.surface.summit_height_sd, 1e-7);
    EXPECT_EQ(scene.surface.summit_plane_offset, 1.146);
    EXPECT_EQ(scene.surface.offset_planes, 2);
    EXPECT_EQ(scene.bodies.effective_modulus, 107.9e9);
    EXPECT_EQ(scene.bodies.reduced_radius, 9.5e-3);
    EXPECT_EQ(scene.bodies.ellipticity, 1.5);
    EXPECT_EQ(scene.lubricant.viscosity, 0.0202);
    EXPECT_EQ(scene.lubricant.pressure_viscosity, 2e-8);
    EXPECT_EQ(scene.lubricant.eyring_stress, 2.5e6);
    EXPECT_EQ(scene.supply.kind, SupplyKind::inlet_film_ratio);
    EXPECT_EQ(scene.supply.value, 4);
    EXPECT_EQ(scene.friction.boundary_coefficient, 0.13);
    EXPECT_EQ(scene.friction.slide_roll_ratio, 0.25);
    EXPECT_EQ(scene.friction.fluid, FluidShear::limiting);
    EXPECT_EQ(scene.friction.viscosity, ViscosityLaw::roelands);
    EXPECT_EQ(scene.closures.asperity, AsperityModel::greenwood_williamson);
    EXPECT_EQ(scene.closures.starvation, StarvationClosure::damiens);
    EXPECT_EQ(scene.closures.film, FilmFormula::hamrock_dowson_minimum);
    EXPECT_EQ(scene.closures.damiens_exponent, 2.5);
    OutputSet outputs;
    outputs.insert(Output::film);
    outputs.insert(Output::friction);
    EXPECT_TRUE(scene.outputs == outputs);
  }
}

TEST(Scene, TakesEveryWordToItsEnumerator) {
  const auto scene_with = [](const char* field, const std::string& word) {
    return read(Format::toml, good().set(field, '"' + word + '"')).scene.value();
  };
  for (const auto& [word, closure] : {std::pair{"flooded_inlet", StarvationClosure::flooded_inlet},
                                      {"starved_inlet", StarvationClosure::starved_inlet},
                                      {"printed_exponents", StarvationClosure::printed_exponents},
                                      {"damiens", StarvationClosure::damiens}})
    EXPECT_EQ(scene_with("closures.starvation", word).closures.starvation, closure);
  for (const auto& [word, law] : {std::pair{"barus", ViscosityLaw::barus},
                                  {"ambient", ViscosityLaw::ambient},
                                  {"roelands", ViscosityLaw::roelands}})
    EXPECT_EQ(scene_with("friction.viscosity", word).friction.viscosity, law);
}

TEST(Scene, DefaultsOfTheTableAreThoseOfTheScene) {
  SceneText text = good();
  text.remove("speed").remove("id").remove("surface.summit_plane_offset");
  text.set("speed.from", "1e-4").set("speed.to", "3");
  SceneText explicit_text = text;
  for (const FieldInfo& field : scene_fields()) {
    if (field.default_text.empty() || field.type == FieldType::text ||
        field.type == FieldType::outputs || field.type == FieldType::limits)
      continue;
    const std::string value(field.default_text);
    explicit_text.set(field.path, field.type == FieldType::choice ? '"' + value + '"' : value);
  }
  const auto values = [](const SceneText& of) {
    const Scene scene = read(Format::toml, of).scene.value();
    return std::tuple(scene.surface.summit_plane_offset, scene.surface.offset_planes,
                      scene.bodies.ellipticity, scene.speeds.count, scene.speeds.spacing,
                      scene.friction.slide_roll_ratio, scene.friction.fluid,
                      scene.friction.viscosity, scene.closures.asperity, scene.closures.starvation,
                      scene.closures.damiens_exponent, scene.closures.film, scene.supply.kind);
  };
  EXPECT_EQ(values(text), values(explicit_text));
}

TEST(Scene, MinusZeroIsZero) {
  for (const Format format : formats)
    for (const char* zero : {"-0", "-0.0"}) {
      const SceneText text = good().set("surface.summit_plane_offset", zero);
      EXPECT_EQ(std::signbit(read(format, text).scene.value().surface.summit_plane_offset), false);
    }
}

TEST(Scene, ReportsEveryProblemAtOnce) {
  SceneText text = good();
  text.set("load", "-1").set("bodies.reduced_radius", "1e400").set("lubricant.viscosity", "true");
  text.set("speed", "[1, 2e999, -3]").remove("surface.summit_radius").set("lod", "3");
  EXPECT_TRUE(refused(text, {{"load", "-1 is not allowed"},
                             {"bodies.reduced_radius", "1e400 is beyond"},
                             {"lubricant.viscosity", "true is a boolean"},
                             {"speed[1]", "2e999 is beyond"},
                             {"speed[2]", "-3 is not allowed"},
                             {"surface.summit_radius", "missing"},
                             {"lod", "did you mean load?"}}));
}

TEST(Scene, KeepsTheIdOfABadScene) {
  for (const Format format : formats) {
    const SceneReading reading = read(format, good().set("load", "0"));
    EXPECT_FALSE(reading.scene);
    EXPECT_EQ(reading.id, "rough");
    EXPECT_FALSE(read(format, good().remove("id")).id);
    EXPECT_FALSE(read(format, good().set("id", "7")).id);
  }
}

TEST(Scene, ProblemReadsAsOneLineWithFileFieldValueAndWhatIsAllowed) {
  const SceneReading reading = read(Format::toml, good().set("surface.summit_radius", "-1"));
  ASSERT_EQ(reading.errors.size(), 1u);
  EXPECT_EQ(reading.errors[0].line(),
            "test: surface.summit_radius: -1 is not allowed; allowed: a number above 0, in m");
}

TEST(Scene, FaultTellsItsRuleTheValueAndWhatIsAllowed) {
  const auto fault = [](std::string_view path, std::string_view value) {
    return read(Format::json, good().set(path, value)).errors.at(0).fault;
  };
  EXPECT_EQ(fault("load", "true").rule, Fault::kind);
  EXPECT_EQ(fault("load", "1e400").rule, Fault::overflow);
  EXPECT_EQ(fault("load", "1e-400").rule, Fault::underflow);
  EXPECT_EQ(fault("surface.offset_planes", "1.5").rule, Fault::wholeness);
  EXPECT_EQ(fault("lod", "1").nearest, "load");
  EXPECT_EQ(fault("bodies.length", "1").rule, Fault::absence);
  EXPECT_EQ(fault("supply.inlet_flow", "1").what, "supply.inlet_film_ratio");
  EXPECT_EQ(fault("friction.fluid", "\"eyrng\"").nearest, "eyring");
  const Fault range = fault("load", "-1");
  EXPECT_EQ(range.rule, Fault::range);
  EXPECT_EQ(range.value, "-1");
  EXPECT_EQ(range.allowed, "a number above 0, in N");
}

TEST(Scene, ValuesInMessagesAreShortAndWithoutControlSigns) {
  SceneText text = good();
  text.set("load", R"("\u001b[31mred\n\u202E)" + std::string(5000, 'x') + '"');
  for (const Format format : formats) {
    const SceneReading reading = read(format, text);
    ASSERT_EQ(reading.errors.size(), 1u);
    const std::string line = reading.errors[0].line();
    EXPECT_LT(line.size(), 300u) << line;
    EXPECT_NE(line.find("\\u001b[31mred\\n\\u202e"), std::string::npos) << line;
    EXPECT_EQ(line.find('\x1b'), std::string::npos) << line;
  }
}

TEST(Scene, ProblemsWithoutEndAreCutOff) {
  SceneText text = good();
  for (int i = 0; i < 500; ++i) text.set("strange_" + std::to_string(i), "1");
  for (const Format format : formats) {
    const SceneReading reading = read(format, text);
    EXPECT_EQ(reading.errors.size(), 51u);
    EXPECT_NE(reading.errors.back().message().find("and more"), std::string::npos);
  }
}

// --- Tables.

TEST(SceneTables, MisspeltOneIsNamedOnceWithTheRightName) {
  SceneText text = good();
  for (const char* field : {"summit_density", "summit_radius", "summit_height_sd"})
    text.rename(std::string("surface.") + field, std::string("surfaces.") + field);
  text.remove("surface.summit_plane_offset");
  EXPECT_TRUE(refused(text, "surfaces", "unknown table; did you mean surface?"));
}

TEST(SceneTables, ScalarInTheirPlaceIsNamedOnce) {
  EXPECT_TRUE(refused(good().remove_section("surface").set("surface", "5"), "surface",
                      "5 is a number; allowed: a table of summit_den"));
}

TEST(SceneTables, EmptyOnesLeaveTheirFieldsMissing) {
  EXPECT_TRUE(
      refused(good().remove_section("bodies").set("bodies", "{}"),
              {{"bodies.effective_modulus", "missing"}, {"bodies.reduced_radius", "missing"}}));
}

TEST(SceneTables, KeyWithADotInItIsNotAPath) {
  const SceneText text = good().remove("load");
  const std::string toml = "\"surface.summit_radius\" = 1\nload = 50\n" + text.toml();
  EXPECT_TRUE(refused(Format::toml, toml, "\"surface.summit_radius\"",
                      "did you mean surface.summit_radius?"));
  std::string json = text.json();
  json.insert(1, "\"surface.summit_radius\": 1, \"load\": 50, ");
  EXPECT_TRUE(refused(Format::json, json, "\"surface.summit_radius\"",
                      "did you mean surface.summit_radius?"));
}

// --- Speeds.

TEST(SceneSpeeds, ListIsTakenInOrder) {
  for (const Format format : formats) {
    const Scene scene = read(format, good().set("speed", "[3, 0.1, 2]")).scene.value();
    ASSERT_EQ(scene.speeds.size(), 3u);
    EXPECT_EQ(scene.speeds[0], 3);
    EXPECT_EQ(scene.speeds[1], 0.1);
    EXPECT_EQ(scene.speeds[2], 2);
  }
}

struct WrongList {
  const char *list, *field, *part;
};

TEST(SceneSpeeds, ElementsOfAListAreJudgedOneByOne) {
  for (const auto& [list, field, part] : {WrongList{"[]", "speed", "the list is empty"},
                                          {"[1, 0]", "speed[1]", "0 is not allowed"},
                                          {"[1, 2, -1]", "speed[2]", "-1 is not allowed"},
                                          {"[\"a\"]", "speed[0]", "\"a\" is a text"},
                                          {"[1, [2, 3], 4]", "speed[1]", "this is a list"},
                                          {"[1, {}]", "speed[1]", "this is a table"},
                                          {"[true]", "speed[0]", "true is a boolean"},
                                          {"[1, 1e400]", "speed[1]", "1e400 is beyond"}})
    EXPECT_TRUE(refused(good().set("speed", list), field, part));
}

TEST(SceneSpeeds, AListPassesTheirRangeByItsLeastAndItsGreatest) {
  EXPECT_EQ(passes(good().set("speed", "[1, 2, 3]"), "speed_range"), false);
  EXPECT_EQ(passes(good().set("speed", "[1, 2e5, 3]"), "speed_range"), true);
  EXPECT_EQ(passes(good().set("speed", "[1, 1e-12, 3]"), "speed_range"), true);
}

SceneText with_range(const char* from, const char* to) {
  SceneText text = good();
  return text.remove("speed").set("speed.from", from).set("speed.to", to);
}

TEST(SceneSpeeds, RangeKeepsItsEndsAndDefaults) {
  for (const Format format : formats) {
    const Scene scene = read(format, with_range("1e-4", "3")).scene.value();
    EXPECT_EQ(scene.speeds.size(), 200u);
    EXPECT_EQ(scene.speeds.spacing, Spacing::log);
    EXPECT_EQ(scene.speeds[0], 1e-4);
    EXPECT_EQ(scene.speeds[199], 3);
    const Scene even =
        read(format, with_range("1", "3").set("speed.count", "5").set("speed.spacing", "\"lin\""))
            .scene.value();
    ASSERT_EQ(even.speeds.size(), 5u);
    EXPECT_EQ(even.speeds[2], 2);
  }
}

TEST(SceneSpeeds, EmptyOrReversedRangeIsRefused) {
  EXPECT_TRUE(refused(with_range("3", "3"), "speed.to", "above speed.from, which is 3"));
  EXPECT_TRUE(refused(with_range("3", "1e-4"), "speed.to", "above speed.from"));
  EXPECT_TRUE(refused(with_range("1", "2").remove("speed.to"), "speed.to", "missing"));
}

TEST(SceneSpeeds, EmptyTableLacksItsEnds) {
  EXPECT_TRUE(
      refused(good().set("speed", "{}"), {{"speed.from", "missing"}, {"speed.to", "missing"}}));
}

TEST(SceneUses, TheFilmOfALineAsksNothingOfTheSurface) {
  const auto use = SceneUse::line_film;
  SceneText line = good().remove("bodies.reduced_radius").set("bodies.radius_x", "0.01");
  line.set("bodies.length", "0.01");
  EXPECT_TRUE(refused(line, "closures.film", "the contact is a line"));
  EXPECT_TRUE(accepted(line, use));
  for (const Format format : formats)
    EXPECT_TRUE(
        has_problem(read(format, line, use).warnings, "supply.inlet_film_ratio", "flooded"));
  for (const char* section : {"surface", "supply", "friction"}) line.remove_section(section);
  EXPECT_TRUE(accepted(line.remove("speed"), use));
  for (const Format format : formats) EXPECT_EQ(read(format, line, use).warnings.size(), 0u);
  EXPECT_TRUE(refused(line.remove("load"), "load", "missing", use));
  EXPECT_TRUE(refused(good(), "bodies.reduced_radius", "line contacts alone", use));
}

TEST(SceneSpeeds, AreRequiredByUse) {
  const SceneText none = good().remove("speed");
  EXPECT_TRUE(accepted(none, SceneUse::onset));
  for (const Format format : formats)
    EXPECT_TRUE(read(format, none, SceneUse::onset).scene.value().speeds.empty());
  EXPECT_TRUE(refused(none, "speed", "missing", SceneUse::speeds));
  EXPECT_TRUE(refused(none, "speed", "missing", SceneUse::one_speed));
  EXPECT_TRUE(accepted(good(), SceneUse::one_speed));
  for (const SceneText& several :
       {good().set("speed", "[1, 2]"), good().set("speed", "[1]"), with_range("1", "2")})
    EXPECT_TRUE(refused(several, "speed", "allowed: one number", SceneUse::one_speed));
  EXPECT_TRUE(refused(good().set("speed", "0"), "speed", "not allowed", SceneUse::onset));
}

// --- Supply.

TEST(SceneSupply, IsFloodedWhereThereIsNone) {
  for (const Format format : formats)
    EXPECT_EQ(read(format, good().remove_section("supply")).scene.value().supply.kind,
              SupplyKind::flooded);
}

TEST(SceneSupply, HasThreeKinds) {
  for (const Format format : formats) {
    const auto kind = [format](const char* field) {
      return read(format, good().remove_section("supply").set(field, "1e-7"))
          .scene.value()
          .supply.kind;
    };
    EXPECT_EQ(kind("supply.inlet_film"), SupplyKind::inlet_film);
    EXPECT_EQ(kind("supply.inlet_film_ratio"), SupplyKind::inlet_film_ratio);
    EXPECT_EQ(kind("supply.inlet_flow"), SupplyKind::inlet_flow);
  }
}

TEST(SceneSupply, TwoKindsAreRefusedAndBothNamed) {
  EXPECT_TRUE(refused(good().set("supply.inlet_flow", "1e-9"), "supply.inlet_flow",
                      "given beside supply.inlet_film_ratio"));
  EXPECT_TRUE(refused(good().set("supply.inlet_film", "1e-9"), "supply.inlet_film_ratio",
                      "given beside supply.inlet_film;"));
}

TEST(SceneSupply, EmptyTableIsRefused) {
  EXPECT_TRUE(refused(good().remove_section("supply").set("supply", "{}"), "supply",
                      "exactly one of inlet_film, inlet_film_ratio, inlet_flow"));
}

// --- Outputs.

TEST(SceneOutputs, WithoutAListAreThoseWithInputs) {
  OutputSet no_friction = OutputSet::all();
  no_friction.erase(Output::friction);
  for (const Format format : formats) {
    EXPECT_EQ(read(format, good()).scene.value().outputs, OutputSet::all());
    for (const char* input : {"lubricant.eyring_stress", "friction.boundary_coefficient"})
      EXPECT_EQ(read(format, good().remove(input)).scene.value().outputs, no_friction);
  }
}

TEST(SceneOutputs, EachNameIsKnown) {
  for (const OutputInfo& output : output_infos)
    for (const Format format : formats) {
      SceneText text = good();
      text.set("surface.rms_roughness", "1e-7");
      text.set("outputs", "[\"" + std::string(output.name) + "\"]");
      OutputSet only;
      only.insert(output.output);
      EXPECT_EQ(read(format, text).scene.value().outputs, only) << output.name;
    }
}

TEST(SceneOutputs, WrongListsAreRefused) {
  for (const auto& [list, field, part] :
       {WrongList{"[]", "outputs", "the list is empty"},
        {R"(["film", "films"])", "outputs[1]", "did you mean film?"},
        {R"(["film", "regime", "film"])", "outputs[2]", "given twice"},
        {"[1]", "outputs[0]", "1 is a number"},
        {R"([["film"]])", "outputs[0]", "this is a list"}})
    EXPECT_TRUE(refused(good().set("outputs", list), field, part));
}

TEST(SceneOutputs, FrictionAskedForNeedsItsInputs) {
  for (const char* input : {"lubricant.eyring_stress", "friction.boundary_coefficient"}) {
    EXPECT_TRUE(refused(good().remove(input).set("outputs", R"(["friction"])"), input,
                        "missing: friction needs it"));
    EXPECT_TRUE(accepted(good().remove(input).set("outputs", R"(["film"])")));
  }
}

// --- Roughness.

TEST(SceneRoughness, IsWhatTheOneWayOfGivingItSays) {
  const auto roughness = [](const SceneText& text) {
    return read(Format::toml, text).scene.value().surface.rms_roughness;
  };
  EXPECT_EQ(roughness(good()), 0);
  EXPECT_EQ(roughness(good().set("surface.rms_roughness", "3e-7")), 3e-7);
  const auto near = [](double value, double expected) {
    return verification::is_within(value / expected, 1, 1e-15);
  };
  EXPECT_TRUE(near(roughness(good().set("surface.rms_roughness", "[3e-7, 4e-7]")), 5e-7));
  const double of_average = 3e-7 * std::sqrt(std::numbers::pi / 2);
  EXPECT_TRUE(near(roughness(good().set("surface.average_roughness", "3e-7")), of_average));
  // With Greenwood and Tripp's model the moments are those of each of two equal faces.
  SceneText profile = good().remove("surface.summit_density").remove("surface.summit_radius");
  profile.remove("surface.summit_height_sd").remove("surface.summit_plane_offset");
  profile.set("surface.m0", "9e-14").set("surface.m2", "4e-3").set("surface.m4", "1e9");
  EXPECT_TRUE(near(roughness(profile), 3e-7 * std::sqrt(2.0)));
  profile.set("closures.asperity", "\"greenwood_williamson\"");
  EXPECT_TRUE(near(roughness(profile), 3e-7));
  EXPECT_TRUE(refused(profile.set("surface.rms_roughness", "1e-7"), "surface.rms_roughness",
                      "given beside surface.m0"));
}

TEST(SceneRoughness, IsGivenInOneWayAndForOneOrTwoFaces) {
  EXPECT_TRUE(
      refused(good().set("surface.rms_roughness", "1e-7").set("surface.average_roughness", "1e-7"),
              "surface.average_roughness", "given beside surface.rms_roughness"));
  for (const auto& [list, field, part] :
       {WrongList{"[1e-7]", "surface.rms_roughness", "this is a list"},
        {"[1e-7, 1e-7, 1e-7]", "surface.rms_roughness", "one of each face"},
        {"[1e-7, 0]", "surface.rms_roughness[1]", "0 is not allowed"},
        {R"(["a", 1e-7])", "surface.rms_roughness[0]", "is a text"}})
    EXPECT_TRUE(refused(good().set("surface.rms_roughness", list), field, part));
}

TEST(SceneRoughness, LambdaRatioAskedForNeedsIt) {
  const SceneText asking = good().set("outputs", R"(["lambda_ratio"])");
  EXPECT_TRUE(refused(asking, "surface.rms_roughness", "missing: lambda_ratio needs it"));
  for (const char* field : {"surface.rms_roughness", "surface.average_roughness"}) {
    SceneText text = asking;
    EXPECT_TRUE(accepted(text.set(field, "1e-7")));
  }
}

// --- Physics.

TEST(SceneRoelands, NeedsAViscosityAboveItsPole) {
  SceneText text = good().set("friction.viscosity", "\"roelands\"");
  for (const char* viscosity : {"6e-5", "6.315e-5", "1e-300"})
    EXPECT_TRUE(refused(text.set("lubricant.viscosity", viscosity), "lubricant.viscosity",
                        "friction.viscosity = \"roelands\""));
  EXPECT_TRUE(accepted(text.set("lubricant.viscosity", "6.3151e-5")));
  // A number that is not legal gives one error, and no second one about Roelands' law.
  for (const char* wrong : {"0", "-1"})
    EXPECT_TRUE(refused(text.set("lubricant.viscosity", wrong), "lubricant.viscosity",
                        "is not allowed; allowed: a number above 0"));
  EXPECT_TRUE(refused(text.remove("lubricant.viscosity"), "lubricant.viscosity", "missing"));
  EXPECT_TRUE(accepted(good().set("lubricant.viscosity", "6e-5")));
}

// --- Shapes of contacts.

SceneText without_shape() { return good().remove("bodies.reduced_radius"); }
SceneText ellipse() {
  return without_shape().set("bodies.radius_x", "9.5e-3").set("bodies.radius_y", "19e-3");
}
SceneText line() {
  return without_shape()
      .set("bodies.radius_x", "9.5e-3")
      .set("bodies.length", "5e-4")
      .set("closures.film", "\"dowson_toyoda_central\"");
}
SceneText faces(const char* first_x, const char* second_x, const char* first_y,
                const char* second_y) {
  return without_shape()
      .set("bodies.first_radius_x", first_x)
      .set("bodies.second_radius_x", second_x)
      .set("bodies.first_radius_y", first_y)
      .set("bodies.second_radius_y", second_y);
}

TEST(SceneShapes, AreTakenInEachWay) {
  for (const Format format : formats) {
    const auto shape = [&](const SceneText& text) {
      return read(format, text).scene.value().bodies.shape();
    };
    EXPECT_EQ(shape(good()), ContactShape::circle);
    EXPECT_EQ(shape(ellipse()), ContactShape::ellipse);
    EXPECT_EQ(shape(line()), ContactShape::line);
    const Scene ball = read(format, faces("5e-3", "22.5e-3", "5e-3", "-5.2e-3")).scene.value();
    EXPECT_EQ(ball.bodies.shape(), ContactShape::ellipse);
    EXPECT_DOUBLE_EQ(ball.bodies.radius_x, 5e-3 * 22.5e-3 / 27.5e-3);
    const Scene flat = read(format, faces("5e-3", "1e30", "7e-3", "1e30")).scene.value();
    EXPECT_EQ(flat.bodies.radius_x, 5e-3);
    EXPECT_EQ(flat.bodies.radius_y, 7e-3);
  }
  EXPECT_EQ(read(Format::toml, faces("5e-3", "inf", "7e-3", "-inf")).scene.value().bodies.radius_y,
            7e-3);
}

TEST(SceneShapes, OfTwoWaysAtOnceAreRefused) {
  EXPECT_TRUE(refused(good().set("bodies.radius_x", "1e-2"), "bodies.radius_x",
                      "given beside bodies.reduced_radius"));
  EXPECT_TRUE(refused(ellipse().set("bodies.length", "1e-2"), "bodies.length",
                      "given beside bodies.radius_x"));
  EXPECT_TRUE(refused(ellipse().set("bodies.ellipticity", "2"), "bodies.ellipticity",
                      "allowed: only beside bodies.reduced_radius"));
  EXPECT_TRUE(refused(good().set("bodies.first_modulus", "2e11"), "bodies.first_modulus",
                      "given beside bodies.effective_modulus"));
  EXPECT_TRUE(refused(good().set("surface.m0", "1e-15"), "surface.m0",
                      "given beside surface.summit_density"));
  EXPECT_TRUE(refused(ellipse().remove("bodies.radius_y"), "bodies.radius_y",
                      "missing beside bodies.radius_x"));
}

TEST(SceneShapes, WithoutAContactAreRefused) {
  EXPECT_TRUE(refused(faces("5e-3", "-4e-3", "5e-3", "5e-3"), "bodies.first_radius_x",
                      "the faces do not meet at a point"));
  EXPECT_TRUE(refused(faces("5e-3", "5e-3", "5e-3", "-5e-3"), "bodies.first_radius_y",
                      "or length in place of both radii, for a line"));
  const SceneText groove = faces("5e-3", "5e-3", "5e-3", "-4e-3");
  EXPECT_TRUE(refused(groove, "bodies.first_radius_y",
                      "the groove's radius must be larger than the ball's"));
  for (const Format format : formats)
    EXPECT_EQ(lines_of(read(format, groove).errors).find("perhaps"), std::string::npos);
  EXPECT_TRUE(refused(faces("5e-3", "5e-3", "3.969", "-4.128e-3"), "bodies.first_radius_y",
                      "; perhaps \"3.969 mm\" was meant"));
  EXPECT_TRUE(refused(faces("5e-3", "\"inf\"", "5e-3", "5e-3"), "bodies.second_radius_x",
                      "write it without the quotes"));
  EXPECT_TRUE(refused(faces("5e-3", "5e-3", "1e308", "1e308"), "bodies.first_radius_y",
                      "the faces do not meet at a point"));
  EXPECT_TRUE(refused(line().set("bodies.length", "0"), "bodies.length", "0 is not allowed"));
}

TEST(SceneShapes, TakeOnlyFilmLawsOfTheirKind) {
  EXPECT_TRUE(
      refused(line().remove("closures.film"), "closures.film", "missing: the contact is a line"));
  for (const bool is_line : {false, true}) {
    std::vector<std::string> fitting, others;
    for (const NamedFilmLaw& named : named_film_laws) {
      const bool fits = named.of(is_line) != nullptr;
      if (named.law->is_solved() && !is_line) continue;  // tested on the ellipse below
      (fits ? fitting : others).emplace_back(named.word);
    }
    const std::string last = fitting.back();
    fitting.pop_back();
    const std::string told =
        fmt::format("{}; allowed: {} or {}",
                    is_line ? "the contact is a line (bodies.length)" : "the contact is no line",
                    fmt::join(fitting, ", "), last);
    for (const std::string& word : others)
      EXPECT_TRUE(refused((is_line ? line() : ellipse()).set("closures.film", '"' + word + '"'),
                          "closures.film", told));
  }
  EXPECT_TRUE(refused(ellipse().set("closures.film", "\"solved\""), "closures.film",
                      "the contact is an ellipse, and films of circles and of lines alone"));
}

TEST(SceneShapes, OfAnyEllipticityAreOrdinaryToASoftLaw) {
  SceneText soft = ellipse().set("bodies.radius_y", "5");
  EXPECT_EQ(passes(soft, "film_law_ellipticity"), true);
  soft.set("closures.film", "\"hamrock_dowson_soft_central\"");
  EXPECT_EQ(passes(soft, "film_law_ellipticity"), false);
}

TEST(SceneShapes, OfAProfileGiveTheSummits) {
  const auto profile = [](const char* m4) {
    SceneText text = good();
    for (const char* field :
         {"summit_density", "summit_radius", "summit_height_sd", "summit_plane_offset"})
      text.remove(std::string("surface.") + field);
    return text.set("surface.m0", "2.5e-15").set("surface.m2", "2e-4").set("surface.m4", m4);
  };
  for (const Format format : formats)
    EXPECT_GT(read(format, profile("3e8")).scene.value().surface.summit_density, 0);
  EXPECT_TRUE(refused(profile("1.4e7"), "surface.m4", "m0 · m4/m2² = 0.875"));
  EXPECT_EQ(passes(profile("2e7"), "gaussian_profile"), true);
  EXPECT_TRUE(
      refused(profile("3e8").remove("surface.m2"), "surface.m2", "missing beside surface.m0"));
}

// Each rule on several fields. The base scene makes the judged quantity equal to the tested number.
TEST(SceneThresholds, ChangeTheVerdictAtTheirLimit) {
  using enum verification::True;
  struct Rule {
    double limit;
    verification::True side;
    SceneText base;
    std::string path;         // of the number
    std::string field, part;  // of an error; without a part, the word of a limit of validity
    double slack = 0;
  };
  // n·1·1 is the roughness, and (D_d/σ_s)·1·1·1 the product of the four.
  SceneText ones = good(), profile = good(), ball = without_shape();
  for (const char* field : {"summit_density", "summit_radius", "summit_height_sd"})
    ones.set(std::string("surface.") + field, "1");
  const SceneText level = SceneText(ones).set("surface.summit_plane_offset", "0");
  profile.remove_section("surface").set("surface.m2", "1").set("surface.m4", "1");
  for (const char* face :
       {"first_radius_x", "second_radius_x", "first_radius_y", "second_radius_y"})
    ball.set(std::string("bodies.") + face, "1");
  // Loads at which a semi-axis is half a radius, or half of a line's length: a³ = 3FR/(4E*) of a
  // circle, a³ ∝ F of an ellipse, b² = 4FR/(πE*L). At k = 8, R_y/R_x = (k²E − K)/(K − E).
  const auto with = [](SceneText text, const char* path, const char* value) {
    return text.set(std::string("bodies.") + path, value);
  };
  const auto line_of = [&](const char* radius, const char* length, const char* modulus) {
    return with(with(with(line(), "radius_x", radius), "length", length), "effective_modulus",
                modulus);
  };
  const SceneText circle = with(with(good(), "reduced_radius", "1"), "effective_modulus", "6");
  const SceneText of_k = with(ellipse(), "radius_x", "1");
  const SceneText oval = with(with(of_k, "radius_y", "2"), "effective_modulus", "1");
  const HertzEllipse<double> unit = hertz_ellipse(1.0, 1.0, 1.0, 2.0);
  const double at_x = std::pow(0.5 / unit.semi_axis_x, 3), at_y = std::pow(1 / unit.semi_axis_y, 3);
  const double K = std::comp_ellint_1(std::sqrt(63) / 8), E = std::comp_ellint_2(std::sqrt(63) / 8);
  const double pi = std::numbers::pi, product = offset_times_roughness;
  const std::string n = "surface.summit_density", offset = "surface.summit_plane_offset";
  const std::string y = "bodies.radius_y";
  const std::string face_x = "bodies.first_radius_x", face_y = "bodies.first_radius_y";
  for (const Rule& one : std::initializer_list<Rule>{
           {1e-3, below, level, n, "summit_roughness", ""},
           {1, above, level, n, "summit_roughness", ""},
           {0.9 * product, below, ones, offset, "summit_offset", ""},
           {1.1 * product, above, ones, offset, "summit_offset", ""},
           {1.5 * (1 - 1e-9), below, profile, "surface.m0", "gaussian_profile", ""},
           {0.8968, up_to, profile, "surface.m0", "surface.m4", "m0 · m4/m2²", 1e-15},
           {1, above, circle, "load", "half_space", "", 1e-14},
           {4 * pi, above, line_of("1", "4", "16"), "load", "half_space", "", 1e-14},
           {std::min(at_x, at_y), above, oval, "load", "half_space", "", 1e-14},
           {pi, above, line_of("4", "1", "64"), "load", "line_length", "", 1e-14},
           {(64 * E - K) / (K - E), above, of_k, y, "film_law_ellipticity", "", 1e-13},
           {1 - 1.5e-9, below, of_k, y, "film_law_ellipticity", "", 1e-12},
           {1e20, from, with(ball, "second_radius_x", "inf"), face_x, face_x, "do not meet"},
           {1e20, from, with(ball, "second_radius_y", "inf"), face_y, face_y, "do not meet"},
           {1, from, with(ball, "second_radius_x", "-1"), face_x, face_x, "do not meet"},
           {1, from, with(ball, "second_radius_y", "-1"), face_y, face_y, "do not meet"},
           {6.315e-5, up_to, good().set("friction.viscosity", "\"roelands\""),
            "lubricant.viscosity", "lubricant.viscosity", "roelands"},
           {3, up_to, good().remove("speed").set("speed.from", "3"), "speed.to", "speed.to",
            "above speed.from"}}) {
    const auto is_told = [&](double number) {
      SceneText text = one.base;
      const SceneReading got = read(Format::toml, text.set(one.path, fmt::format("{}", number)));
      return one.part.empty() ? passes(text, one.field)
                              : has_problem(got.errors, one.field, one.part);
    };
    EXPECT_TRUE(verification::changes_at_its_limit(
        {one.field + one.part, one.limit, one.side, is_told, one.slack}));
  }
}

}  // namespace
}  // namespace tribo::scene_test
