// SPDX-License-Identifier: Apache-2.0
// The cases of a sweep and their results, compared with the scene of each case, solved alone.
#include "sweep/cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <utility>

#include "scene/schema.hpp"
#include "scene/units.hpp"
#include "support/judge.hpp"
#include "sweep/case_solver.hpp"
#include "sweep/chunk_solver.hpp"
#include "sweep/plan_reader.hpp"
#include "sweep/small_sweep.hpp"
#include "sweep/variable_reader.hpp"
#include "tribo/mixed_contact.hpp"

namespace tribo::sweep {
namespace {

using verification::is_within;

constexpr const char* start = R"(
id = "s"
[bodies]
effective_modulus = 107.9e9
reduced_radius = 9.5e-3
[supply]
inlet_film_ratio = 4
[friction]
boundary_coefficient = 0.13
[surface]
summit_density = 2e11
summit_radius = 1e-5
summit_plane_offset = 1.146
)";

SceneSweep read(const std::string& text) {
  SweepReading reading = parse_sweep(text, "s.toml");
  for (const InputProblem& error : reading.errors) ADD_FAILURE() << error.line();
  return reading.sweep.value_or(SceneSweep());
}

// A sweep in which roughness and viscosity vary, at two speeds.
SceneSweep drawn(const std::string& settings, const std::string& top = "speed = [0.02, 0.7]\n") {
  return read(top + "load = 50\n" + start + R"(
summit_height_sd = { distribution = "log_uniform", from = 1e-8, to = 1e-7 }
[lubricant]
viscosity = { distribution = "uniform", from = 0.01, to = 0.03 }
pressure_viscosity = 2e-8
eyring_stress = 2.5e6
[sweep]
)" + settings);
}

// A sweep with the same 70 draws for each of these loads.
SceneSweep drawn_for_each_of(const std::string& loads) {
  return read("speed = 1\nload = " + loads + "\n" + start + R"(
summit_height_sd = { distribution = "uniform", from = 1e-8, to = 1e-7 }
[lubricant]
viscosity = 0.02
pressure_viscosity = 2e-8
[sweep]
draws = 70
)");
}

std::vector<double> all_values(const SceneSweep& sweep) {
  std::vector<double> values(sweep.groups * sweep.cases_per_group() * sweep.variables.size());
  CaseGenerator(sweep).groups(0, values);
  return values;
}

TEST(Cases, OfGridsAreAllCombinationsEachOnce) {
  const SceneSweep sweep = read("speed = 1\nload = [10, 20, 30]\n" + std::string(start) + R"(
summit_height_sd = { from = 1e-8, to = 1e-7, count = 5 }
[closures]
asperity = ["greenwood_tripp", "greenwood_williamson"]
[lubricant]
viscosity = 0.02
pressure_viscosity = 2e-8
)");
  ASSERT_EQ(sweep.groups, 30u);
  EXPECT_EQ(sweep.design, Design::factorial);
  const std::vector<double> values = all_values(sweep);
  std::set<std::vector<double>> cases;
  for (std::size_t i = 0; i < 30; ++i)
    cases.insert({values.begin() + static_cast<std::ptrdiff_t>(3 * i),
                  values.begin() + static_cast<std::ptrdiff_t>(3 * i + 3)});
  EXPECT_EQ(cases.size(), 30u);
}

TEST(Cases, OfEachSetOfGridValuesHaveTheSameDraws) {
  const SceneSweep sweep = drawn_for_each_of("[10, 20, 30]");
  const std::vector<double> values = all_values(sweep);
  ASSERT_EQ(values.size(), 2u * 210u);
  for (std::size_t i = 0; i < 70; ++i) {
    EXPECT_EQ(values[2 * i], 10);
    EXPECT_EQ(values[2 * (i + 70)], 20);
    EXPECT_EQ(values[2 * i + 1], values[2 * (i + 70) + 1]);
    EXPECT_EQ(values[2 * i + 1], values[2 * (i + 140) + 1]);
  }
}

TEST(Cases, OfAGroupWithSensitivityDifferFromAInOneVariableThatBHas) {
  const SceneSweep sweep = drawn("sensitivity = true\ndraws = 100\n");
  const std::vector<double> values = all_values(sweep);
  ASSERT_EQ(sweep.cases_per_group(), 4u);
  for (std::size_t g = 0; g < 100; ++g) {
    const double* const row = &values[g * 8];
    EXPECT_NE(row[0], row[2]);
    EXPECT_NE(row[1], row[3]);
    EXPECT_EQ(row[4], row[2]);  // AB_1: the first of B
    EXPECT_EQ(row[5], row[1]);
    EXPECT_EQ(row[6], row[0]);
    EXPECT_EQ(row[7], row[3]);
  }
}

TEST(Cases, AreTheSameInBlocksFromAnywhere) {
  for (const SceneSweep& sweep :
       {drawn_for_each_of("[10, 20, 30, 40, 50, 60, 70, 80]"), drawn("draws = 1000\n"),
        drawn("draws = 1000\ndesign = \"latin_hypercube\"\nseed = 9\n"),
        drawn("draws = 500\ndesign = \"monte_carlo\"\nsensitivity = true\n"),
        drawn("draws = 1000\ncorrelated = [\"lubricant.viscosity\", \"surface.summit_height_sd\"]\n"
              "correlation = [[1, 0.7], [0.7, 1]]\n")}) {
    const std::vector<double> whole = all_values(sweep);
    const std::size_t group = sweep.cases_per_group() * sweep.variables.size();
    CaseGenerator generator(sweep);
    for (const std::size_t first : {499u, 0u, 130u}) {
      const std::size_t count = std::min<std::size_t>(77, sweep.groups - first);
      std::vector<double> part(count * group);
      generator.groups(first, part);
      const auto from = whole.begin() + static_cast<std::ptrdiff_t>(first * group);
      EXPECT_EQ(part, std::vector<double>(from, from + static_cast<std::ptrdiff_t>(part.size())))
          << sweep.groups << " groups of " << sweep.cases_per_group() << ", from " << first;
    }
  }
}

// Few speeds, and a curve. A block of cases has more points than a block of the engine.
TEST(CaseSolver, GivesWhatTheSceneOfTheCaseGivesByItself) {
  for (const std::string speed : {"[0.02, 0.1, 0.7]", "{ from = 1e-3, to = 1, count = 20 }"}) {
    const SceneSweep sweep = drawn("draws = 300\n", "speed = " + speed + '\n');
    const std::size_t speeds = sweep.scene.speeds.size();
    const std::vector<double> values = all_values(sweep);
    std::vector<double> results(300 * sweep.width());
    CaseSolver(sweep).solve(values, results);
    for (std::size_t i = 0; i < 300; ++i) {
      Scene scene = sweep.scene;
      scene.surface.summit_height_sd = values[2 * i];
      scene.lubricant.viscosity = values[2 * i + 1];
      const MixedContact<double> contact(scene);
      for (std::size_t j = 0; j < speeds; ++j) {
        const OperatingPoint<double> point = contact.solve(scene.speeds[j]);
        const std::vector<double> expected{point.film_flooded,
                                           point.film,
                                           point.separation,
                                           point.film_parameter,
                                           point.asperity_load_share,
                                           point.fluid_load_share,
                                           point.real_area_ratio,
                                           point.summit_count,
                                           point.friction,
                                           static_cast<double>(point.regime),
                                           static_cast<double>(point.inlet)};
        ASSERT_EQ(sweep.columns.size(), expected.size());
        for (std::size_t c = 0; c < expected.size(); ++c) {
          const double got = results[i * sweep.width() + c * speeds + j];
          if (std::isnan(expected[c]))
            EXPECT_TRUE(std::isnan(got)) << sweep.columns[c].name;
          else
            EXPECT_EQ(got, expected[c])
                << sweep.columns[c].name << " of case " << i << std::hexfloat << ", sd "
                << values[2 * i] << ", viscosity " << values[2 * i + 1];
        }
      }
    }
  }
}

TEST(Fields, AreReadWhereTheyArePut) {
  for (std::size_t field = 0; field < scene_fields().size(); ++field) {
    const scene_detail::Store store = scene_detail::store_of(field);
    if (store == nullptr) continue;
    SCOPED_TRACE(scene_fields()[field].path);
    Scene scene;
    scene.bodies.bodies[0].modulus = scene.bodies.bodies[1].modulus = 2e11;
    scene.closures.starvation = StarvationClosure::damiens;
    scene.lubricant.oil.iso_vg = 46;
    scene.lubricant.conductivity = 0.14;
    const double value = scene_fields()[field].type == FieldType::number ? 0.25 : 1;
    store(scene, value);
    EXPECT_EQ(scene_detail::value_in(scene, field), value);
  }
}

// A case sets only these numbers of its contact, and leaves the scene as it is.
TEST(Fields, ThatAreNumbersOfTheContactChangeNothingElseOfIt) {
  constexpr std::array shapes{"ball_on_flat", "bearing_outer_ring", "gear_flank", "roller"};
  for (const std::string shape : shapes) {
    const SceneReading reading =
        read_scene(TRIBOCHECK_SOURCE_DIR "/reference/scenes/" + shape + ".toml", SceneUse::speeds);
    ASSERT_TRUE(reading.scene);
    Scene given = *reading.scene;  // numbers that profiles and bodies determine are given here
    given.surface.moments = {};
    given.bodies.bodies = {};
    given.supply = {SupplyKind::inlet_flow, 1e-8};
    given.closures.starvation = StarvationClosure::damiens;
    for (std::size_t field = 0; field < scene_fields().size(); ++field) {
      const auto number = scene_detail::contact_number(field, given.bodies.shape());
      const std::optional<double> value = scene_detail::value_in(given, field);
      if (number == nullptr || !value) continue;
      SCOPED_TRACE(shape + ": " + std::string(scene_fields()[field].path));
      using Bytes = std::array<std::byte, sizeof(scene_detail::Numbers)>;
      Scene scene = given;
      scene_detail::store_of(field)(scene, *value + 1);
      auto numbers = detail::numbers_of<double>(given);
      numbers.*number = *value + 1;
      EXPECT_EQ(std::bit_cast<Bytes>(numbers),
                std::bit_cast<Bytes>(detail::numbers_of<double>(scene)));
      EXPECT_TRUE(detail::words_of(given) == detail::words_of(scene));
    }
  }
}

// Sweeps of each kind that the solver tells apart; each has cases beyond one of its blocks of 256.
std::vector<std::pair<const char*, SceneSweep>> sweeps_of_each_kind() {
  const std::string liquid = "[lubricant]\nviscosity = 0.02\npressure_viscosity = 2e-8\n";
  const std::string speed_drawn = "[speed]\ndistribution = \"log_uniform\"\nfrom = 1e-3\nto = 1\n";
  const std::string sd_drawn =
      "summit_height_sd = { distribution = \"log_uniform\", from = 1e-8, to = 1e-7 }\n";
  return {
      {"few speeds", drawn("draws = 600\n", "speed = [0.02, 0.1, 0.7]\n")},
      {"curves", drawn("draws = 300\n", "speed = { from = 1e-3, to = 1, count = 20 }\n")},
      {"the speed alone", read("load = 50\n" + std::string(start) + "summit_height_sd = 2.5e-8\n" +
                               liquid + "[sweep]\ndraws = 1100\n" + speed_drawn)},
      {"the speed and others", read("load = [10, 20, 30]\n" + std::string(start) + sd_drawn +
                                    liquid + "[sweep]\ndraws = 200\n" + speed_drawn)},
      {"sensitivity", drawn("sensitivity = true\ndraws = 150\n")},
      {"words", read("speed = 0.1\nload = 50\n" + std::string(start) + sd_drawn + liquid +
                     "[closures]\nasperity = [\"greenwood_tripp\", \"greenwood_williamson\"]\n"
                     "starvation = [\"damiens\", \"starved_inlet\", \"flooded_inlet\"]\n"
                     "[sweep]\ndraws = 100\nonset = [\"film_departure\"]\n")},
      {"onsets",
       read("outputs = [\"film\"]\nspeed = { from = 1e-4, to = 3, count = 3 }\nload = 50\n" +
            std::string(start) + "summit_height_sd = 2.5e-8\n" + liquid +
            "[closures]\nstarvation = [\"damiens\", \"flooded_inlet\"]\n"
            "damiens_exponent = { distribution = \"uniform\", from = 2, to = 4 }\n"
            "[sweep]\ndraws = 140\n"
            "onset = [\"film_maximum\", \"film_departure\"]\n")}};
}

// Each case is solved among all, alone, and in another order by a solver that had other cases.
TEST(CaseSolver, GivesEachCaseTheBitsThatItHasByItselfInAnyOrder) {
  for (const auto& [kind, sweep] : sweeps_of_each_kind()) {
    const std::vector<double> values = all_values(sweep);
    const std::size_t count = sweep.variables.size(), width = sweep.width();
    const std::size_t cases = values.size() / count;
    ASSERT_GT(cases, 256u) << kind;
    std::vector<double> together(cases * width), row(width);
    CaseSolver(sweep).solve(values, together);
    std::vector<std::size_t> order(cases);
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), std::mt19937_64(7));
    std::vector<double> shuffled, of_shuffled(cases * width);
    for (const std::size_t i : order)
      shuffled.insert(shuffled.end(), &values[i * count], &values[i * count] + count);
    CaseSolver again(sweep);
    again.solve(shuffled, of_shuffled);
    const auto bits_of_row = [&](const std::vector<double>& from, std::size_t i) {
      return bits_of(std::span(from).subspan(i * width, width));
    };
    for (std::size_t k = 0; k < cases; ++k) {
      const std::size_t i = order[k];
      const auto expected = bits_of_row(together, i);
      EXPECT_EQ(bits_of_row(of_shuffled, k), expected) << kind << ", case " << i;
      const auto alone = std::span(values).subspan(i * count, count);
      again.solve(alone, row);
      EXPECT_EQ(bits_of_row(row, 0), expected) << kind << ", case " << i;
      if (k % 7 != 0) continue;
      CaseSolver(sweep).solve(alone, row);
      EXPECT_EQ(bits_of_row(row, 0), expected) << kind << ", case " << i;
    }
    CaseSolver stopped(sweep, [] { return true; });
    EXPECT_THROW(stopped.solve(values, together), Stopped) << kind;
  }
}

// Compares the kept values of each chunk, its summaries, and the sums of its groups by blocks. The
// borders of chunks and of blocks of cases differ.
TEST(ChunkSolver, KeepsTheValuesOfEachCaseInItsPlace) {
  const auto bytes_of = [](const QuantileSketch& sketch) {
    Bytes bytes;
    sketch.write(bytes);
    return bytes;
  };
  for (const auto& [kind, sweep] : sweeps_of_each_kind()) {
    SweepPlan plan = make_plan({sweep});
    SceneSweep& scene = plan.scenes.front();
    scene.chunk_groups = 111;
    scene.chunks = (scene.groups + 110) / 111;
    const std::vector<double> values = all_values(scene);
    std::vector<double> results(values.size() / scene.variables.size() * scene.width());
    CaseSolver(scene).solve(values, results);
    ChunkSolver solver(plan);
    for (std::uint64_t number = scene.chunks; number-- > 0;) {
      SCOPED_TRACE(kind);
      const Chunk chunk = solver.solve(number), expected = chunk_of(scene, number, values, results);
      ASSERT_EQ(chunk.values.size(), expected.values.size());
      for (std::size_t i = 0; i < chunk.values.size(); ++i)
        EXPECT_EQ(chunk.values[i].bytes, expected.values[i].bytes) << i;
      for (std::size_t c = 0; c < scene.columns.size(); ++c)
        for (std::size_t j = 0; j < scene.columns[c].width; ++j) {
          const ValueSummary &got = chunk.summaries[c][j], &wanted = expected.summaries[c][j];
          EXPECT_EQ(bytes_of(got.sketch), bytes_of(wanted.sketch)) << scene.columns[c].name;
          EXPECT_EQ(got.undefined, wanted.undefined);
          EXPECT_EQ(got.moments.least, wanted.moments.least);
          EXPECT_EQ(got.moments.greatest, wanted.moments.greatest);
          EXPECT_TRUE(is_within(got.moments.mean, wanted.moments.mean,
                                1e-12 * std::abs(wanted.moments.mean)));
          if (!scene.sensitivity) continue;
          const auto &sums = chunk.sensitivities[c][j],
                     &by_definition = expected.sensitivities[c][j];
          ASSERT_EQ(sums.size(), by_definition.size());
          for (const auto& [block, one] : by_definition)
            EXPECT_EQ(sums.at(block).total, one.total) << block;
        }
    }
  }
}

TEST(ChunkSolver, ComesToTheSameBytesInAnyOrder) {
  std::vector<SceneSweep> scenes;
  scenes.push_back(drawn("draws = 2500\nonset = [\"film_maximum\"]\nsensitivity = true\n"));
  scenes.push_back(drawn("draws = 3000\n"));
  scenes.back().scene.id = "t";
  const SweepPlan plan = make_plan(std::move(scenes));
  ASSERT_GT(plan.chunks(), 4u);
  std::vector<Bytes> forward;
  ChunkSolver solver(plan);
  for (std::uint64_t chunk = 0; chunk < plan.chunks(); ++chunk)
    forward.push_back(solver.solve(chunk).bytes());
  ChunkSolver other(plan);
  for (std::uint64_t chunk = plan.chunks(); chunk-- > 0;)
    EXPECT_EQ(other.solve(chunk).bytes(), forward[chunk]) << chunk;
}

TEST(PlanReader, TakesHalfALastDigitFromWhatIsPrinted) {
  const struct {
    const char* text;
    double value, half_digit;
  } printed[] = {{"0.0202", 0.0202, 5e-5}, {"2.0e-8", 2e-8, 5e-10},   {"50", 50, 0.5},
                 {"5e1", 50, 5},           {"107.9e9", 107.9e9, 5e7}, {"1.50", 1.5, 0.005}};
  for (const auto& one : printed) {
    const SceneSweep sweep =
        read("speed = 1\nload = { printed = \"" + std::string(one.text) + "\" }\n" + start + R"(
summit_height_sd = 2.5e-8
[lubricant]
viscosity = 0.02
pressure_viscosity = 2e-8
)");
    ASSERT_EQ(sweep.variables.size(), 1u);
    EXPECT_EQ(sweep.variables[0].nominal, one.value);
    EXPECT_TRUE(is_within(sweep.variables[0].distribution.least(), one.value - one.half_digit,
                          1e-12 * one.value));
    EXPECT_TRUE(is_within(sweep.variables[0].distribution.greatest(), one.value + one.half_digit,
                          1e-12 * one.value));
  }
}

// The variable that a field has with this table of names and texts.
std::optional<Variable> variable_of(const FieldInfo& field,
                                    const std::vector<std::pair<std::string, std::string>>& table) {
  using namespace scene_detail;
  Entry entry{std::string(field.path), {.kind = ValueKind::table, .text = {}}, {}};
  for (const auto& [name, text] : table)
    entry.inner.push_back({name, {.kind = ValueKind::text, .text = text}, {}});
  SceneReading reading;
  Problems problems(reading, "s.toml");
  return read_variable(entry, field, problems);
}

TEST(PlanReader, HalfALastDigitIsOneOfTheUnitThatIsWrittenInEveryField) {
  using namespace scene_detail;
  std::size_t conversions = 0;
  for (const FieldInfo& field : scene_fields()) {
    if (!takes_units(field) || store_of(field_at(field.path)) == nullptr) continue;
    std::string units = ", " + std::string(usual_units(written_unit(field)));
    if (const std::size_t last = units.find(" or "); last != units.npos)
      units.replace(last, 4, ", ");
    if (field.unit == "m/s") units += ", km/h, cm/s";
    for (std::size_t at = 0; at < units.size();) {
      const std::size_t end = std::min(units.find(", ", at + 2), units.size());
      const std::string unit = units.substr(at + 2, end - at - 2);
      at = end;
      const auto in_si = [&](const std::string& number) {
        return std::stod(si_decimal(number + ' ' + unit, written_unit(field)).value());
      };
      const auto variable = variable_of(field, {{"printed", "62.0 " + unit}});
      ASSERT_TRUE(variable) << field.path << ' ' << unit;
      EXPECT_EQ(variable->nominal, in_si("62.0")) << field.path << ' ' << unit;
      const double rounding = 1e-12 * in_si("62.0");
      EXPECT_TRUE(is_within(variable->distribution.least(), in_si("61.95"), rounding)) << unit;
      EXPECT_TRUE(is_within(variable->distribution.greatest(), in_si("62.05"), rounding)) << unit;
      ++conversions;
    }
  }
  EXPECT_GT(conversions, 60U);
}

TEST(PlanReader, ASpreadOfATemperatureMayBeInCelsius) {
  const FieldInfo& field = scene_fields()[scene_detail::field_at("lubricant.temperature")];
  const auto distribution = [&](const char* sd) {
    return variable_of(field, {{"distribution", "normal"}, {"mean", "75 °C"}, {"sd", sd}});
  };
  const auto in_kelvins = distribution("5 K"), in_celsius = distribution("5 °C");
  ASSERT_TRUE(in_kelvins && in_celsius);
  EXPECT_EQ(in_celsius->text, in_kelvins->text);
  EXPECT_EQ(in_celsius->nominal, in_kelvins->nominal);
  EXPECT_FALSE(distribution("5 m"));
}

TEST(PlanReader, ASpreadInPerCentIsThatOfALogarithm) {
  const FieldInfo& load = scene_fields()[scene_detail::field_at("load")];
  const auto log_normal = [&](const char* log_sd) {
    return variable_of(load,
                       {{"distribution", "log_normal"}, {"median", "50 N"}, {"log_sd", log_sd}});
  };
  const auto spread = log_normal("13 %");
  ASSERT_TRUE(spread);
  EXPECT_EQ(spread->text, "log_normal, median 50, log_sd 0.13");
  EXPECT_FALSE(log_normal("13 N"));
}

SweepPlan plan_of(const std::string& text, const std::string& path) {
  std::vector<SceneSweep> scenes;
  scenes.push_back(parse_sweep(text, path).sweep.value());
  return make_plan(std::move(scenes));
}

const std::string two_loads = "speed = 1\nload = [10, 20]\n" + std::string(start) +
                              "summit_height_sd = 1e-8\n[lubricant]\nviscosity = 0.02\n"
                              "pressure_viscosity = 2e-8\n";

TEST(PlanReader, DigestFollowsTheTextAndNotItsFolder) {
  EXPECT_EQ(plan_of(two_loads, "a/s.toml").digest, plan_of(two_loads, "/b/c/s.toml").digest);
  EXPECT_NE(plan_of(two_loads, "s.toml").digest, plan_of(two_loads + "#\n", "s.toml").digest);
}

}  // namespace
}  // namespace tribo::sweep
