// SPDX-License-Identifier: Apache-2.0
#include "tribo/operating_points.hpp"

#include <algorithm>
#include <array>

#include "operating_points_arrays.hpp"
#include "tribo/batch.hpp"

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

void store(const OperatingPoint<double>& point, OperatingPoints& points, std::size_t i) {
  const auto put = [i](auto& array, auto value) {
    if (!array.empty()) array[i] = value;
  };
  points.speed[i] = point.speed;
  put(points.film_flooded, point.film_flooded);
  put(points.film, point.film);
  put(points.separation, point.separation);
  put(points.film_parameter, point.film_parameter);
  put(points.asperity_load_share, point.asperity_load_share);
  put(points.fluid_load_share, point.fluid_load_share);
  put(points.real_area_ratio, point.real_area_ratio);
  put(points.summit_count, point.summit_count);
  put(points.friction, point.friction);
  put(points.regime, point.regime);
  put(points.inlet, point.inlet);
  put(points.friction_undefined, static_cast<std::uint8_t>(point.friction_undefined));
}

void count_roots(const LoadSharing<double>& sharing, std::span<const double> flooded,
                 const SharingWork& work, WorkCounts& counts) {
  counts.add(Work::root_step, work.steps);
  counts.add(Work::root_by_newton, work.by_newton);
  for (const double film0 : flooded)
    if (film0 >= sharing.surface().film_from)
      counts.add(Work::root_is_film);
    else if (film0 <= sharing.surface().floor_up_to)
      counts.add(Work::root_is_floor);
}

struct Rooted {
  double speed, flooded_film_parameter, film_parameter;
};

template <class Counter>
OperatingPoint<double> point_of(const MixedContact<double>& contact, const Rooted& root,
                                OutputSet outputs, Counter& work) {
  const FloodedFilm<double> film =
      contact.flooded(root.speed, root.flooded_film_parameter, {root.film_parameter, 0}, outputs);
  const InletState<double> inlet =
      contact.needs_inlet(outputs) ? contact.inlet(film, work) : InletState<double>{1, 0, false};
  return contact.complete(film, inlet, outputs, work);
}

template <class Counter>
void solve_points(const MixedContact<double>& contact, std::span<const double> speeds,
                  OutputSet outputs, OperatingPoints& points, std::size_t first, Counter& work) {
  constexpr std::size_t most = 512;
  std::array<double, most> flooded, lambda;
  for (std::size_t start = 0; start < speeds.size(); start += most) {
    const std::span<const double> block =
        speeds.subspan(start, std::min(most, speeds.size() - start));
    for (std::size_t i = 0; i < block.size(); ++i)
      flooded[i] = contact.flooded_film_parameter(block[i]);
    const auto film0 = std::span(flooded).first(block.size());
    const SharingWork roots =
        film_parameter(contact.sharing(), film0, std::span(lambda).first(block.size()));
    if constexpr (Counter::counts) count_roots(contact.sharing(), film0, roots, work);
    for (std::size_t i = 0; i < block.size(); ++i)
      store(point_of(contact, {block[i], flooded[i], lambda[i]}, outputs, work), points,
            first + start + i);
  }
}

}  // namespace

OperatingPoint<double> solve_one(const MixedContact<double>& contact, double speed,
                                 OutputSet outputs) {
  const double film0 = contact.flooded_film_parameter(speed);
  double lambda = 0;
  film_parameter(contact.sharing(), std::span(&film0, 1), std::span(&lambda, 1));
  const NoWork none;
  return point_of(contact, {speed, film0, lambda}, outputs, none);
}

void solve(const MixedContact<double>& contact, std::span<const double> speeds, OutputSet outputs,
           OperatingPoints& points, std::size_t first) {
  const NoWork none;
  solve_points(contact, speeds, outputs, points, first, none);
}

void solve(const MixedContact<double>& contact, std::span<const double> speeds, OutputSet outputs,
           OperatingPoints& points, WorkCounts& work, std::size_t first) {
  solve_points(contact, speeds, outputs, points, first, work);
}

}  // namespace tribo
