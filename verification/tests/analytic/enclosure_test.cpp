// SPDX-License-Identifier: Apache-2.0
// Whole operating points with the model's own text run in ball arithmetic (support/enclosure.hpp):
// the double is within its contract of the enclosure, the enclosure overlaps that of the
// generator's formulas, and the closed condition numbers agree with differences between enclosures.
#include "support/enclosure.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "generators/operating_point.hpp"
#include "support/case_count.hpp"
#include "support/condition.hpp"
#include "support/scenes.hpp"
#include "tribo/mixed_contact.hpp"

namespace tribo::verification {
namespace {

constexpr double least_radius = 1e-30;  // relative, of every output
constexpr double certain_part = 0.95;   // of the scenes, at least

std::string describe_scene(const Scene& scene) {
  std::string text;
  for (const auto& [name, number] : describe_numbers(scene))
    text += fmt::format("\n  {} = {} ({:a})", name, number, number);
  return text;
}

testing::AssertionResult is_within_contract(double got, const Enclosure& truth,
                                            const Contract& contract, double condition,
                                            std::string_view output) {
  const double bound = std::max(contract.ulp, contract.ulp_per_condition * condition);
  const double error = error_in_ulp(got, truth);
  record_part_of_bound(error / bound);
  if (is_narrow(truth, least_radius) && error <= bound) return testing::AssertionSuccess();
  return testing::AssertionFailure() << fmt::format(
             "\n  {}: expected {} ({:a}), enclosed to {} bits\n  got      {} ({:a})"
             "\n  error {:.3g} ulp; condition {:.3g}; bound {:.3g}; missed by a factor {:.3g}",
             output, truth.decimal(40), truth.nearest(), truth.accurate_bits(), got, got, error,
             condition, bound, error / bound);
}

// Empty where a branch of the text was not certain, or a root not proven.
std::optional<OperatingPoint<Enclosure>> enclose(const Scene& scene) {
  reference::undecided_comparisons = 0;
  try {
    const OperatingPoint<Enclosure> point =
        MixedContact<Enclosure>(scene).solve(Enclosure(scene.speeds.list[0]));
    if (reference::undecided_comparisons == 0) return point;
    fmt::print("undecided: {} comparisons{}\n", reference::undecided_comparisons,
               describe_scene(scene));
  } catch (const std::runtime_error& error) {
    fmt::print("undecided: {}{}\n", error.what(), describe_scene(scene));
  }
  return std::nullopt;
}

Conditions conditions_of(const Scene& scene) {
  const MixedContact<long double> contact(scene);
  const FloodedFilm<long double> film =
      contact.flooded(static_cast<long double>(scene.speeds.list[0]));
  const InletState<long double> inlet = contact.inlet(film);
  return operating_point_conditions(scene, contact, film, inlet,
                                    contact.complete(film, inlet, OutputSet::all()));
}

void expect_doubles_within_contract(const Scene& scene, const OperatingPoint<Enclosure>& truth) {
  const OperatingPoint<double> got = MixedContact<double>(scene).solve(scene.speeds.list[0]);
  const auto values = numbers_of(got);
  const auto enclosures = numbers_of(truth);
  const Conditions conditions = conditions_of(scene);
  EXPECT_EQ(got.friction_undefined, truth.friction_undefined) << describe_scene(scene);
  EXPECT_EQ(got.regime, truth.regime) << describe_scene(scene);
  EXPECT_EQ(got.inlet, truth.inlet) << describe_scene(scene);
  for (std::size_t i = 0; i < number_count; ++i)
    EXPECT_TRUE(is_within_contract(values[i], enclosures[i], operating_point_contract,
                                   conditions[i], output_infos[i].name))
        << describe_scene(scene);
}

TEST(Enclosure, DoublesAreWithinTheirContractOnRandomScenes) {
  Sampler sampler(1906);
  constexpr int scenes = 400;
  int certain = 0;
  for (int i = 0; i < scenes; ++i) {
    const Scene scene = random_scene(sampler);
    const auto truth = enclose(scene);
    if (!truth) continue;
    ++certain;
    expect_doubles_within_contract(scene, *truth);
  }
  RecordProperty("certain", certain);
  EXPECT_GE(certain, certain_part * scenes);
}

TEST(Enclosure, DoublesAreWithinTheirContractOnThePapersScenes) {
  int scenes = 0, certain = 0;
  for (const PaperSurface surface : paper_surfaces)
    for (const auto model : {AsperityModel::greenwood_tripp, AsperityModel::greenwood_williamson})
      for (const auto closure : {StarvationClosure::flooded_inlet, StarvationClosure::starved_inlet,
                                 StarvationClosure::printed_exponents, StarvationClosure::damiens})
        for (const double speed : {1e-4, 1e-3, 0.01, 0.1, 0.5, 3.0}) {
          Scene scene = paper_scene(surface, model);
          scene.closures.starvation = closure;
          scene.speeds.list = {speed};
          ++scenes;
          const auto truth = enclose(scene);
          if (!truth) continue;
          ++certain;
          expect_doubles_within_contract(scene, *truth);
        }
  EXPECT_GE(certain, certain_part * scenes);
}

// The scene as the generator of reference/exact has it.
reference::Inputs inputs_of(Scene scene) {
  reference::Inputs inputs;
  const auto numbers = numbers_of(scene);
  // Its order, which is that of `Inputs`.
  for (std::size_t i = 0; i < reference::Inputs::count; ++i)
    inputs.value[i] = Enclosure(*numbers[i].second);
  inputs.planes = scene.surface.offset_planes;
  inputs.rough = static_cast<reference::Rough>(scene.closures.asperity);
  inputs.inlet = static_cast<reference::Inlet>(scene.closures.starvation);
  inputs.supply_kind = static_cast<reference::Supply>(scene.supply.kind);
  inputs.shear = static_cast<reference::Shear>(scene.friction.fluid);
  inputs.law = static_cast<reference::Viscosity>(scene.friction.viscosity);
  return inputs;
}

TEST(Enclosure, TheModelsTextOverlapsTheGeneratorsFormulas) {
  Sampler sampler(1907);
  for (int i = 0; i < 100; ++i) {
    const Scene scene = random_scene(sampler);
    const auto truth = enclose(scene);
    if (!truth) continue;
    const reference::Outputs formulas = reference::solve(inputs_of(scene), reference::first_way);
    const auto enclosures = numbers_of(*truth);
    for (std::size_t k = 0; k < number_count; ++k) {
      if (k + 1 == number_count && truth->friction_undefined) continue;
      // Neither excludes the other: none is below the other for certain.
      EXPECT_FALSE(enclosures[k] < formulas[k] || enclosures[k] > formulas[k])
          << output_infos[k].name << ": " << enclosures[k].decimal(50) << " or "
          << formulas[k].decimal(50) << describe_scene(scene);
      EXPECT_EQ(is_narrow(formulas[k], 1e-25), true) << output_infos[k].name;
    }
  }
}

TEST(Enclosure, ClosedConditionNumbersAgreeWithDifferences) {
  Sampler sampler(1908);
  for (int i = 0; i < 40; ++i) {
    Scene scene = random_scene(sampler);
    const auto base = enclose(scene);
    if (!base) continue;
    const auto values = numbers_of(*base);
    Conditions sums{};
    for (const auto& [name, number] : numbers_of(scene)) {
      const double before = *number;
      *number = before * (1 + 0x1p-30);
      const auto moved = enclose(scene);
      const Enclosure step = Enclosure(*number) / before - 1;
      *number = before;
      ASSERT_EQ(moved.has_value(), true);
      const auto there = numbers_of(*moved);
      for (std::size_t k = 0; k < number_count; ++k)
        if (!(values[k] == 0)) sums[k] += abs((there[k] / values[k] - 1) / step).nearest();
    }
    const Conditions closed = conditions_of(scene);
    for (std::size_t k = 0; k < number_count; ++k)
      EXPECT_LE(std::abs(closed[k] / std::max(1.0, sums[k]) - 1), 1e-5)
          << output_infos[k].name << ": " << closed[k] << " or " << sums[k]
          << describe_scene(scene);
  }
}

TEST(Enclosure, UndecidedComparisonsAreCounted) {
  const Enclosure third = Enclosure(1) / 3;
  reference::undecided_comparisons = 0;
  EXPECT_EQ(third < 1, true);
  EXPECT_EQ(third > 1, false);
  EXPECT_EQ(reference::undecided_comparisons, 0U);
  EXPECT_EQ(third < Enclosure(1) / 3, false);
  EXPECT_EQ(third >= Enclosure(1) / 3, false);
  EXPECT_EQ(third == Enclosure(1) / 3, false);
  EXPECT_EQ(reference::undecided_comparisons, 3U);
}

// Without a proof by signs there is no root: a double root has none.
TEST(Enclosure, ARootWithoutAChangeOfSignIsRefused) {
  EXPECT_THROW(proven_zero([](const Enclosure& x) { return x * x; }, Enclosure(0), Enclosure(1)),
               std::runtime_error);
  const Enclosure root =
      proven_zero([](const Enclosure& x) { return x * x - 2; }, sqrt(Enclosure(2)), Enclosure(1));
  EXPECT_EQ(overlaps(root, sqrt(Enclosure(2))), true);
  EXPECT_EQ(is_narrow(root, 1e-80), true);
}

}  // namespace
}  // namespace tribo::verification
