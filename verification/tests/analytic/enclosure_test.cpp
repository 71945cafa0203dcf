// SPDX-License-Identifier: Apache-2.0
// The model's own templates in ball arithmetic (support/enclosure.hpp), whose results are the truth
// of contract/contract_test.cpp. They overlap the results of the generator's formulas, which share
// no code with them. The condition numbers agree with differences between enclosures.
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

// The point in balls. Empty if a branch of the model was not certain or a root was not proven.
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

// The scene as an input of the generator of reference/exact.
reference::Inputs inputs_of(Scene scene) {
  reference::Inputs inputs;
  const auto numbers = numbers_of(scene);
  // The numbers have the order of `Inputs`.
  for (std::size_t i = 0; i < reference::Inputs::count; ++i)
    inputs.value[i] = Enclosure(*numbers[i].second);
  inputs.planes = scene.surface.offset_planes;
  inputs.rough = static_cast<reference::Rough>(scene.closures.asperity);
  inputs.inlet = static_cast<reference::Inlet>(scene.closures.starvation);
  inputs.supply_kind = static_cast<reference::Supply>(scene.supply.kind);
  inputs.shear = static_cast<reference::Shear>(scene.friction.fluid);
  inputs.law = static_cast<reference::Viscosity>(scene.friction.viscosity);
  inputs.shape = static_cast<reference::Shape>(scene.bodies.shape());
  inputs.film = static_cast<std::size_t>(scene.closures.film);
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
      const bool is_balanced = truth->regime != Regime::collapsed;
      if (!is_balanced && balance_outputs().contains(output_infos[k].output)) continue;
      // The two overlap: neither is below the other for certain.
      EXPECT_FALSE(enclosures[k] < formulas[k] || enclosures[k] > formulas[k])
          << output_infos[k].name << ": " << enclosures[k].decimal(50) << " or "
          << formulas[k].decimal(50) << describe_scene(scene);
      EXPECT_EQ(is_narrow(formulas[k], 1e-25), true) << output_infos[k].name;
    }
  }
}

TEST(Enclosure, ConditionNumbersAgreeWithDifferences) {
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
    const Conditions closed = conditions_at(scene, scene.speeds.list[0]);
    for (std::size_t k = 0; k < number_count; ++k) {
      if (abs(values[k]).nearest() < 1e-300) continue;  // an asperity share too small for a double
      EXPECT_LE(std::abs(closed[k] / std::max(1.0, sums[k]) - 1), 1e-5)
          << output_infos[k].name << ": " << closed[k] << " or " << sums[k]
          << describe_scene(scene);
    }
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

// A root needs a proof by a change of sign. A double root has no such change and is refused.
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
