// SPDX-License-Identifier: Apache-2.0
#include "tribo/operating_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine.hpp"
#include "operating_points_arrays.hpp"

namespace tribo {
void OperatingPoints::resize(std::size_t count, OutputSet outputs) {
  speed.resize(count);
  for_each_number(*this, [&](Output output, auto& array) {
    array.resize(outputs.contains(output) ? count : 0);
  });
  regime.resize(outputs.contains(Output::regime) ? count : 0);
  inlet.resize(outputs.contains(Output::inlet) ? count : 0);
  friction_undefined.resize(outputs.contains(Output::friction) ? count : 0);
}

OperatingPoint<double> OperatingPoints::operator[](std::size_t i) const {
  const auto at = [i](const auto& array) {
    return array.empty() ? typename std::decay_t<decltype(array)>::value_type{} : array[i];
  };
  return {speed[i],
          at(film_flooded),
          at(film),
          at(separation),
          at(film_parameter),
          at(asperity_load_share),
          at(fluid_load_share),
          at(real_area_ratio),
          at(summit_count),
          at(friction),
          regime.empty() ? Regime::mixed : regime[i],
          at(inlet),
          at(friction_undefined) != 0};
}

namespace {

void solve_points(const MixedContact<double>& contact, std::span<const double> speeds,
                  OutputSet outputs, OperatingPoints& points, std::size_t first, WorkCounts* work) {
  std::copy(speeds.begin(), speeds.end(),
            points.speed.begin() + static_cast<std::ptrdiff_t>(first));
  std::array<double, detail::engine_block> lambda;
  for (std::size_t start = 0; start < speeds.size(); start += lambda.size()) {
    const auto block = speeds.subspan(start, std::min(lambda.size(), speeds.size() - start));
    detail::engine_points(contact.words(), &contact.numbers(), nullptr, block, outputs,
                          detail::destination(points, first + start), lambda.data(), work);
    for (std::size_t i = 0; i < block.size(); ++i)
      if (std::isnan(lambda[i])) {
        detail::store(contact.solve(block[i], outputs), points, first + start + i);
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
