// SPDX-License-Identifier: Apache-2.0
#include "tribo/compiled_scene.hpp"

#include <algorithm>
#include <cmath>

#include "operating_points_arrays.hpp"

namespace tribo {
namespace {

constexpr std::size_t most = 256;  // points of a block

std::size_t index_of(Output output) { return static_cast<std::size_t>(output); }

OutputSet with_foundations(OutputSet outputs) {
  if (outputs.contains(Output::regime)) {
    outputs.insert(Output::asperity_load_share);
    outputs.insert(Output::fluid_load_share);
  }
  if (outputs.contains(Output::inlet)) outputs.insert(Output::film_flooded);
  if (outputs.contains(Output::inlet) || outputs.contains(Output::friction))
    outputs.insert(Output::film);
  outputs.erase(Output::regime);
  outputs.erase(Output::inlet);
  return outputs;
}

bool is_near(double value, double threshold) {
  return std::fabs(value - threshold) <= 1e-12 * threshold;
}

}  // namespace

CompiledScene::CompiledScene(const MixedContact<double>& contact, OutputSet outputs, double from,
                             double to)
    : contact_(contact), outputs_(outputs), compiled_(with_foundations(outputs)) {
  OperatingPoints points;
  for_each_number(points, [&](Output output, std::vector<double>& array) {
    if (!compiled_.contains(output)) return;
    OutputSet alone;
    alone.insert(output);
    const auto sample = [&](std::span<const double> speeds, std::span<double> values) {
      points.resize(speeds.size(), alone);
      tribo::solve(contact_, speeds, alone, points);
      std::copy(array.begin(), array.end(), values.begin());
    };
    proxies_[index_of(output)] = ProxyPieces(sample, from, to, error_bound / 2);
  });
}

void CompiledScene::solve(std::span<const double> speeds, OperatingPoints& points,
                          std::size_t first) const {
  for (std::size_t start = 0; start < speeds.size(); start += most)
    solve_block(speeds.subspan(start, std::min(most, speeds.size() - start)), points,
                first + start);
}

void CompiledScene::solve_block(std::span<const double> speeds, OperatingPoints& points,
                                std::size_t first) const {
  std::array<std::array<double, most>, number_count> numbers;
  std::array<bool, most> is_left{};
  const std::size_t count = speeds.size();
  for (std::size_t k = 0; k < number_count; ++k) {
    if (!compiled_.contains(static_cast<Output>(k))) continue;
    if (proxies_[k].values(speeds, std::span(numbers[k]).first(count))) continue;
    for (std::size_t i = 0; i < count; ++i) is_left[i] |= std::isnan(numbers[k][i]);
  }
  const auto at = [&](Output output, std::size_t i) { return numbers[index_of(output)][i]; };

  std::copy(speeds.begin(), speeds.end(),
            points.speed.begin() + static_cast<std::ptrdiff_t>(first));
  for_each_number(points, [&](Output output, std::vector<double>& array) {
    if (outputs_.contains(output))
      std::copy_n(numbers[index_of(output)].begin(), count,
                  array.begin() + static_cast<std::ptrdiff_t>(first));
  });
  if (outputs_.contains(Output::friction))
    for (std::size_t i = 0; i < count; ++i)
      points.friction_undefined[first + i] =
          at(Output::film, i) == 0 && !contact_.sharing().has_floor();
  if (outputs_.contains(Output::regime))
    for (std::size_t i = 0; i < count; ++i) {
      const double asperity = at(Output::asperity_load_share, i);
      const double fluid = at(Output::fluid_load_share, i);
      points.regime[first + i] = regime_of(asperity, fluid);
      is_left[i] |= is_near(asperity, 0.01) || is_near(fluid, 0.01);
    }
  if (outputs_.contains(Output::inlet))
    for (std::size_t i = 0; i < count; ++i) {
      const double film = at(Output::film, i), flooded = at(Output::film_flooded, i);
      points.inlet[first + i] = film == 0                ? Inlet::collapsed
                                : film >= 0.95 * flooded ? Inlet::flooded
                                                         : Inlet::starved;
      is_left[i] |= is_near(film, 0.95 * flooded);
    }
  for (std::size_t i = 0; i < count; ++i)
    if (is_left[i]) tribo::solve(contact_, speeds.subspan(i, 1), outputs_, points, first + i);
}

std::size_t CompiledScene::piece_count() const {
  std::size_t count = 0;
  for (const ProxyPieces& proxy : proxies_) count += proxy.piece_count();
  return count;
}

double CompiledScene::left_out() const {
  double most_left_out = 0;
  for (std::size_t k = 0; k < number_count; ++k)
    if (compiled_.contains(static_cast<Output>(k)))
      most_left_out = std::max(most_left_out, proxies_[k].left_out());
  return most_left_out;
}

}  // namespace tribo
