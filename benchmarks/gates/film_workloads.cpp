// SPDX-License-Identifier: Apache-2.0
// A compiled film: built for three surfaces without and with a floor, and asked.
#include <array>

#include "gates/samples.hpp"
#include "gates/workloads.hpp"
#include "tribo/compiled_film.hpp"

namespace tribo::gates {
namespace {

constexpr double from = 1e-3, to = 100;

std::array<LoadSharing<double>, 3> surfaces() {
  constexpr auto model = AsperityModel::greenwood_tripp;
  return {LoadSharing<double>(model, 0.01, 1.146), LoadSharing<double>(model, 0.3, 1.146),
          LoadSharing<double>(model, 3, 0)};
}

Counters build_counters() {
  std::uint64_t evaluations = 0, pieces = 0;
  for (const LoadSharing<double>& surface : surfaces()) {
    const CompiledFilm film(surface, from, to);
    evaluations += film.pieces().evaluations();
    pieces += film.pieces().piece_count();
  }
  return {{"roots", evaluations}, {"pieces", pieces}};
}

}  // namespace

Workloads film_workloads() {
  Samples samples(3);
  const auto flooded = filled(4096, [&] { return samples.binades(-9, 6); });
  return {{"film_build", true,
           [all = surfaces()] {
             for (const LoadSharing<double>& surface : all) CompiledFilm(surface, from, to);
           },
           build_counters, true},
          {"film_compiled",
           false,
           [film = CompiledFilm(surfaces()[1], from, to), flooded,
            values = std::vector<double>(flooded.size())]() mutable {
             film.film_parameter(flooded, values);
           },
           {},
           true}};
}

}  // namespace tribo::gates
