// SPDX-License-Identifier: Apache-2.0
// Compiled scenes against the model in long double: no output is off by more than the pieces' bound
// beside the contract of an operating point, and the words are those of solve().
#include "tribo/compiled_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "support/contracts.hpp"
#include "support/long_double.hpp"
#include "support/scenes.hpp"

namespace tribo::verification {
namespace {

constexpr double slowest = 1e-4, fastest = 3;

struct Both {
  OperatingPoints compiled, solved;
};

Both both(const MixedContact<double>& contact, const CompiledScene& compiled,
          const std::vector<double>& speeds) {
  Both points;
  points.compiled.resize(speeds.size(), compiled.outputs());
  points.solved.resize(speeds.size(), compiled.outputs());
  compiled.solve(speeds, points.compiled);
  solve(contact, speeds, compiled.outputs(), points.solved);
  return points;
}

std::vector<Scene> scenes() {
  std::vector<Scene> all;
  for (const auto model : {AsperityModel::greenwood_tripp, AsperityModel::greenwood_williamson})
    for (const PaperSurface surface : paper_surfaces)
      for (const Supply& supply :
           {Supply{SupplyKind::inlet_film_ratio, 4}, Supply{SupplyKind::inlet_flow, 1e-8},
            Supply{SupplyKind::flooded, 0}}) {
        Scene scene = paper_scene(surface, model);
        scene.supply = supply;
        all.push_back(scene);
      }
  return all;
}

OutputSet film_outputs() {
  OutputSet outputs;
  for (const Output output : {Output::film_flooded, Output::film, Output::separation})
    outputs.insert(output);
  return outputs;
}

// The greatest r < 1 and the least r ≥ 1 within the range, if the film collapses in it.
void add_collapse(const MixedContact<double>& contact, std::vector<double>& speeds) {
  const auto has_collapsed = [&](double speed) {
    return contact.inlet(contact.flooded(speed)).collapsed;
  };
  double low = slowest, high = fastest;
  if (has_collapsed(low) || !has_collapsed(high)) return;
  while (std::nextafter(low, high) < high) {
    const double middle = low + (high - low) / 2;
    (has_collapsed(middle) ? high : low) = middle;
    speeds.push_back(middle);
  }
}

TEST(CompiledScene, IsWithinItsBoundOfTheModelInLongDouble) {
  Sampler sampler(191);
  for (const Scene& scene : scenes()) {
    const MixedContact<double> contact(scene);
    const CompiledScene compiled(contact, OutputSet::all(), slowest, fastest);
    // Where the condition is large the model's own last digits are more than a piece may be off:
    // the share of the film next to a floor, that of the asperities on thick films.
    EXPECT_LE(compiled.left_out(), 0.5);
    EXPECT_LE(CompiledScene(contact, film_outputs(), slowest, fastest).left_out(), 0.01);
    std::vector<double> speeds;
    for (int i = 0; i < 300; ++i) speeds.push_back(sampler.log_uniform(slowest, fastest));
    add_collapse(contact, speeds);
    const Both points = both(contact, compiled, speeds);
    const MixedContact<long double> exact(scene);
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      const auto film = exact.flooded(static_cast<long double>(speeds[i]));
      const auto inlet = exact.inlet(film);
      const auto truth = exact.complete(film, inlet, OutputSet::all());
      // At the very speed of the collapse a double may be on the other side.
      auto expected = numbers_of(truth);
      if (points.solved.inlet[i] != truth.inlet) {
        const auto solved = numbers_of(points.solved[i]);
        std::copy(solved.begin(), solved.end(), expected.begin());
      }
      const auto got = numbers_of(points.compiled[i]);
      const Conditions conditions = operating_point_conditions(scene, exact, film, inlet, truth);
      for (std::size_t k = 0; k < number_count; ++k) {
        const double own = std::max(operating_point_contract.ulp,
                                    operating_point_contract.ulp_per_condition * conditions[k]);
        constexpr double of_the_pieces = CompiledScene::error_bound * 0x1p53;
        EXPECT_TRUE(is_within_ulp(got[k], expected[k], of_the_pieces + own, {{"speed", speeds[i]}}))
            << output_infos[k].name;
      }
      EXPECT_EQ(points.compiled.regime[i], points.solved.regime[i]) << speeds[i];
      EXPECT_EQ(points.compiled.inlet[i], points.solved.inlet[i]) << speeds[i];
      EXPECT_EQ(points.compiled.friction_undefined[i], points.solved.friction_undefined[i])
          << speeds[i];
    }
  }
}

TEST(CompiledScene, LeavesToTheModelWhatIsOutsideItsRange) {
  const MixedContact<double> contact(
      paper_scene(paper_surfaces[0], AsperityModel::greenwood_tripp));
  const CompiledScene compiled(contact, OutputSet::all(), 0.01, 0.1);
  const std::vector<double> speeds{1e-9, 1e-4, 0.007, 0.13, 3, 1e5};
  const Both points = both(contact, compiled, speeds);
  for (std::size_t i = 0; i < speeds.size(); ++i)
    EXPECT_EQ(numbers_of(points.compiled[i]), numbers_of(points.solved[i])) << speeds[i];
}

TEST(CompiledScene, LeavesAllToTheModelWhereItsRangeIsReversedOrNoRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const MixedContact<double> contact(
      paper_scene(paper_surfaces[0], AsperityModel::greenwood_tripp));
  const std::vector<double> speeds{1e-4, 0.007, 0.13, 3};
  for (const auto& [from, to] :
       {std::pair{fastest, slowest}, {nan, fastest}, {slowest, nan}, {-fastest, -slowest}}) {
    const CompiledScene compiled(contact, OutputSet::all(), from, to);
    EXPECT_EQ(compiled.piece_count(), 0u) << describe({{"from", from}, {"to", to}});
    const Both points = both(contact, compiled, speeds);
    for (std::size_t i = 0; i < speeds.size(); ++i)
      EXPECT_EQ(numbers_of(points.compiled[i]), numbers_of(points.solved[i])) << speeds[i];
  }
}

TEST(CompiledScene, FillsWhatWasAskedAndNothingElse) {
  const MixedContact<double> contact(
      paper_scene(paper_surfaces[0], AsperityModel::greenwood_tripp));
  for (const OutputInfo& info : output_infos) {
    OutputSet asked;
    asked.insert(info.output);
    const CompiledScene compiled(contact, asked, slowest, fastest);
    const std::vector<double> speeds{0.001, 0.02, 0.3, 2.5};
    const Both points = both(contact, compiled, speeds);
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      const auto got = numbers_of(points.compiled[i]), expected = numbers_of(points.solved[i]);
      for (std::size_t k = 0; k < number_count; ++k)
        EXPECT_TRUE(is_within(got[k], expected[k], 2e-14 * std::fabs(expected[k]))) << info.name;
      EXPECT_EQ(points.compiled[i].regime, points.solved[i].regime) << info.name;
      EXPECT_EQ(points.compiled[i].inlet, points.solved[i].inlet) << info.name;
    }
  }
}

}  // namespace
}  // namespace tribo::verification
