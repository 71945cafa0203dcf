// SPDX-License-Identifier: Apache-2.0
#include "tribo/operating_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "engine.hpp"
#include "operating_points_arrays.hpp"

namespace tribo {
void OperatingPoints::resize(std::size_t count, OutputSet outputs) {
  speed.resize(count);
  for_each_number(*this, [&](Output output, auto& array) {
    array.resize(outputs.contains(output) ? count : 0);
  });
  regime.resize(outputs.contains_any(balance_outputs()) ? count : 0);
  inlet.resize(outputs.contains(Output::inlet) ? count : 0);
}

OperatingPoint<double> OperatingPoints::operator[](std::size_t i) const {
  OperatingPoint<double> point;
  const auto take = [i](auto& member, const auto& array) {
    if (!array.empty()) member = array[i];
  };
  take(point.speed, speed);
  std::array<double*, number_count> numbers{};
  for_each_number(point, [&](Output output, double& number) {
    numbers[static_cast<std::size_t>(output)] = &number;
  });
  for_each_number(*this, [&](Output output, const std::vector<double>& array) {
    take(*numbers[static_cast<std::size_t>(output)], array);
  });
  take(point.regime, regime);
  take(point.inlet, inlet);
  return point;
}

namespace {

void solve_points(const MixedContact<double>& contact, std::span<const double> speeds,
                  OutputSet outputs, OperatingPoints& points, std::size_t first, WorkCounts* work) {
  std::copy(speeds.begin(), speeds.end(),
            points.speed.begin() + static_cast<std::ptrdiff_t>(first));
  using Wide = WiderType<double>;
  std::optional<MixedContact<Wide>> wide;  // for points beyond the engine's range
  std::array<double, sharing_block> lambda;
  for (std::size_t start = 0; start < speeds.size(); start += lambda.size()) {
    const auto block = speeds.subspan(start, std::min(lambda.size(), speeds.size() - start));
    detail::engine().points(contact.words(), &contact.numbers(), nullptr, block.data(), outputs,
                            detail::destination(points, first + start), lambda.data(), block.size(),
                            work);
    for (std::size_t i = 0; i < block.size(); ++i) {
      if (!std::isnan(lambda[i])) continue;
      if (!wide) wide.emplace(contact.in<Wide>());
      const auto point = wide->solve(static_cast<Wide>(block[i]), outputs);
      detail::store(detail::in_double(point), points, first + start + i);
      if (work != nullptr) work->add(Work::root_by_newton);
    }
  }
}

}  // namespace

void solve(const MixedContact<double>& contact, std::span<const double> speeds, OutputSet outputs,
           OperatingPoints& points, std::size_t first) {
  solve_points(contact, speeds, outputs, points, first, nullptr);
}

void solve(const MixedContact<double>& contact, std::span<const double> speeds, OutputSet outputs,
           OperatingPoints& points, WorkCounts& work, std::size_t first) {
  solve_points(contact, speeds, outputs, points, first, &work);
}

}  // namespace tribo
