// SPDX-License-Identifier: Apache-2.0
// The cases of a sweep and their results: each held to the scene it stands for, solved by itself.
#include "sweep/cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

#include "support/judge.hpp"
#include "sweep/case_solver.hpp"
#include "sweep/chunk_solver.hpp"
#include "sweep/plan_reader.hpp"
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

// Film, roughness and viscosity vary; two speeds.
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
  const SceneSweep sweep = read("speed = 1\nload = [10, 20, 30]\n" + std::string(start) + R"(
summit_height_sd = { distribution = "uniform", from = 1e-8, to = 1e-7 }
[lubricant]
viscosity = 0.02
pressure_viscosity = 2e-8
[sweep]
draws = 70
)");
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
  for (const char* const settings :
       {"draws = 1000\n", "draws = 1000\ndesign = \"latin_hypercube\"\nseed = 9\n",
        "draws = 500\ndesign = \"monte_carlo\"\nsensitivity = true\n",
        "draws = 1000\ncorrelated = [\"lubricant.viscosity\", \"surface.summit_height_sd\"]\n"
        "correlation = [[1, 0.7], [0.7, 1]]\n"}) {
    const SceneSweep sweep = drawn(settings);
    const std::vector<double> whole = all_values(sweep);
    const std::size_t group = sweep.cases_per_group() * sweep.variables.size();
    CaseGenerator generator(sweep);
    for (const std::size_t first : {499u, 0u, 130u}) {
      const std::size_t count = std::min<std::size_t>(77, sweep.groups - first);
      std::vector<double> part(count * group);
      generator.groups(first, part);
      const auto from = whole.begin() + static_cast<std::ptrdiff_t>(first * group);
      EXPECT_EQ(part, std::vector<double>(from, from + static_cast<std::ptrdiff_t>(part.size())))
          << settings << first;
    }
  }
}

TEST(CaseSolver, GivesWhatTheSceneOfTheCaseGivesByItself) {
  // Three speeds: the points of the cases in hand are more than one block of the engine's.
  const SceneSweep sweep = drawn("draws = 300\n", "speed = [0.02, 0.1, 0.7]\n");
  const std::vector<double> values = all_values(sweep);
  std::vector<double> results(300 * sweep.width());
  CaseSolver(sweep).solve(values, results);
  for (std::size_t i = 0; i < 300; ++i) {
    Scene scene = sweep.scene;
    scene.surface.summit_height_sd = values[2 * i];
    scene.lubricant.viscosity = values[2 * i + 1];
    const MixedContact<double> contact(scene);
    for (std::size_t j = 0; j < 3; ++j) {
      const OperatingPoint<double> point = contact.solve(scene.speeds[j]);
      const double* const row = &results[i * sweep.width() + j];
      const double expected[] = {point.film_flooded,
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
      ASSERT_EQ(sweep.columns.size(), std::size(expected));
      for (std::size_t c = 0; c < std::size(expected); ++c) {
        const double got = row[3 * c];
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

TEST(CaseSolver, OfManySpeedsAndOfFewAgree) {
  const SceneSweep many = drawn("draws = 20\n", "speed = { from = 1e-3, to = 1, count = 40 }\n");
  const SceneSweep few = drawn("draws = 20\n", "speed = [1e-3, 1]\n");
  std::vector<double> of_many(20 * many.width()), of_few(20 * few.width());
  CaseSolver(many).solve(all_values(many), of_many);
  CaseSolver(few).solve(all_values(few), of_few);
  for (std::size_t i = 0; i < 20; ++i)
    for (std::size_t c = 0; c < many.columns.size(); ++c)
      for (const bool last : {false, true}) {
        const double left = of_many[i * many.width() + 40 * c + (last ? 39 : 0)];
        const double right = of_few[i * few.width() + 2 * c + (last ? 1 : 0)];
        if (std::isnan(left) && std::isnan(right)) continue;
        EXPECT_EQ(left, right) << many.columns[c].name;
      }
}

std::uint64_t bits(double number) { return std::bit_cast<std::uint64_t>(number); }

TEST(CaseSolver, OfCasesThatDifferInSpeedAloneGivesTheBitsOfEachByItself) {
  const SceneSweep sweep = read("load = 50\n" + std::string(start) + R"(
summit_height_sd = 2.5e-8
[lubricant]
viscosity = 0.02
pressure_viscosity = 2e-8
[sweep]
draws = 200
[speed]
distribution = "log_uniform"
from = 1e-3
to = 1
)");
  const std::vector<double> values = all_values(sweep);
  std::vector<double> together(200 * sweep.width()), alone(sweep.width());
  CaseSolver(sweep).solve(values, together);
  for (std::size_t i = 0; i < 200; ++i) {
    CaseSolver(sweep).solve(std::span(values).subspan(i, 1), alone);
    for (std::size_t c = 0; c < alone.size(); ++c)
      EXPECT_EQ(bits(together[i * alone.size() + c]), bits(alone[c]))
          << sweep.columns[c].name << ' ' << i;
  }
}

// Neighbours in a group share all fields but one or two.
TEST(CaseSolver, OfAGroupWithSensitivityGivesTheBitsOfEachByItself) {
  const SceneSweep sweep = drawn("sensitivity = true\ndraws = 100\n");
  const std::vector<double> values = all_values(sweep);
  const std::size_t width = sweep.width(), cases = values.size() / 2;
  std::vector<double> together(cases * width), alone(width);
  CaseSolver(sweep).solve(values, together);
  for (std::size_t i = 0; i < cases; ++i) {
    CaseSolver(sweep).solve(std::span(values).subspan(2 * i, 2), alone);
    for (std::size_t c = 0; c < width; ++c) {
      EXPECT_EQ(bits(together[i * width + c]), bits(alone[c])) << i << ' ' << c;
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

TEST(ChunkSolver, SumsUpEveryCaseOnce) {
  std::vector<SceneSweep> scenes;
  scenes.push_back(drawn("draws = 5000\n"));
  const SweepPlan plan = make_plan(std::move(scenes));
  const SceneSweep& sweep = plan.scenes.front();
  std::vector<double> results(5000 * sweep.width());
  CaseSolver(sweep).solve(all_values(sweep), results);
  ChunkSolver solver(plan);
  for (std::size_t c = 0, at = 0; c < sweep.columns.size(); at += sweep.columns[c++].width)
    for (std::size_t j = 0; j < sweep.columns[c].width; ++j) {
      ValueSummary merged, expected;
      for (std::uint64_t chunk = 0; chunk < plan.chunks(); ++chunk)
        merged.merge(solver.solve(chunk).summaries[c][j]);
      std::vector<double> values;
      for (std::size_t i = 0; i < 5000; ++i) values.push_back(results[i * sweep.width() + at + j]);
      expected.add(values);
      EXPECT_EQ(merged.moments.count, expected.moments.count);
      EXPECT_EQ(merged.undefined, expected.undefined);
      EXPECT_EQ(merged.moments.least, expected.moments.least);
      EXPECT_EQ(merged.moments.greatest, expected.moments.greatest);
      EXPECT_TRUE(is_within(merged.moments.mean, expected.moments.mean,
                            1e-12 * std::abs(expected.moments.mean)));
    }
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

TEST(PlanReader, DigestFollowsTheTextAndNotItsFolder) {
  const auto digest_of = [](const std::string& text, const std::string& path) {
    std::vector<SceneSweep> scenes;
    scenes.push_back(parse_sweep(text, path).sweep.value());
    return make_plan(std::move(scenes)).digest;
  };
  const std::string text = "speed = 1\nload = [10, 20]\n" + std::string(start) +
                           "summit_height_sd = 1e-8\n[lubricant]\nviscosity = 0.02\n"
                           "pressure_viscosity = 2e-8\n";
  EXPECT_EQ(digest_of(text, "a/s.toml"), digest_of(text, "/b/c/s.toml"));
  EXPECT_NE(digest_of(text, "s.toml"), digest_of(text + "#\n", "s.toml"));
}

}  // namespace
}  // namespace tribo::sweep
