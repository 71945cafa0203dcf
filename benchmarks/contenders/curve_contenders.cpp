// SPDX-License-Identifier: Apache-2.0
// Each timed call prepares the scene again, as users do for a single curve. The root solvers of
// other families have an advantage: they use this project's code for the film formula, starvation
// and friction. SciPy's solver does not take part.

#include "contenders/curve_contender.hpp"
#include "contenders/root_contender.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/stribeck_walk.hpp"

namespace tribo::benchmarks {
namespace {

void store(const OperatingPoint<double>& point, OperatingPoints& points, std::size_t i) {
  points.speed[i] = point.speed;
  points.film[i] = point.film;
  points.asperity_load_share[i] = point.asperity_load_share;
  points.friction[i] = point.friction;
}

void by_root(const RootContender& root, const Scene& scene, std::span<const double> speeds,
             OperatingPoints& points) {
  const MixedContact<double> contact(scene);
  const LoadSharing<double>& sharing = contact.sharing();
  const std::vector<double> stiffness(speeds.size(), sharing.stiffness());
  const std::vector<double> offset(speeds.size(), sharing.offset());
  std::vector<double> flooded(speeds.size());
  for (std::size_t i = 0; i < speeds.size(); ++i)
    flooded[i] = contact.flooded_film_parameter(speeds[i]);
  const RootCases cases{stiffness, offset, flooded};
  std::vector<double> film(speeds.size());
  root.prepare(cases)(cases, film);
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    const double share = sharing.asperity_share(film[i]);
    const FloodedFilm<double> state{speeds[i], {film[i], share, 1 - share, 0}};
    store(contact.complete(state, contact.inlet(state), curve_outputs()), points, i);
  }
}

void one_by_one(const Scene& scene, std::span<const double> speeds, OperatingPoints& points) {
  const MixedContact<double> contact(scene);
  for (std::size_t i = 0; i < speeds.size(); ++i)
    store(contact.solve(speeds[i], curve_outputs()), points, i);
}

void in_batch(const Scene& scene, std::span<const double> speeds, OperatingPoints& points) {
  const MixedContact<double> contact(scene);
  solve(contact, speeds, curve_outputs(), points);
}

void by_curve(const Scene& scene, std::span<const double> speeds, OperatingPoints& points) {
  const MixedContact<double> contact(scene);
  std::size_t i = 0;
  stribeck_curve(contact, speeds.front(), speeds.back(), speeds.size(), curve_outputs(),
                 [&](const OperatingPoint<double>& point) { store(point, points, i++); });
}

}  // namespace

OutputSet curve_outputs() {
  OutputSet outputs;
  for (const Output output : {Output::film, Output::asperity_load_share, Output::friction})
    outputs.insert(output);
  return outputs;
}

std::vector<CurveContender> curve_contenders(Settings settings) {
  std::vector<CurveContender> all;
  for (const RootContender& root : one_surface_root_contenders(settings))
    if (root.family != "tribocheck" && root.family != "SciPy")
      all.push_back({root.family, root.name,
                     [root](const Scene& scene, std::span<const double> speeds,
                            OperatingPoints& points) { by_root(root, scene, speeds, points); },
                     root.is_slow});
  all.push_back({"tribocheck", "point by point", one_by_one, false});
  all.push_back({"tribocheck", "curve", by_curve, false});
  all.push_back({"tribocheck", "batch", in_batch, false});
  return all;
}

}  // namespace tribo::benchmarks
