// SPDX-License-Identifier: Apache-2.0
// The root of load sharing: of many surfaces (wide) and of one, by the point and in batches. A step
// evaluates the moment and its slope once.
#include <algorithm>

#include "gates/samples.hpp"
#include "gates/workloads.hpp"
#include "tribo/batch.hpp"
#include "tribo/load_sharing.hpp"

namespace tribo::gates {
namespace {

constexpr std::size_t count = 1024;
constexpr auto model = AsperityModel::greenwood_tripp;

// K in 1e-6 … 8, δ in 0 … 3, λ₀ in 1e-4 … 128
struct Points {
  std::vector<double> stiffness, offset, flooded;
};

Points points() {
  Samples samples(2);
  return {filled(count, [&] { return samples.binades(-20, 3); }),
          filled(count, [&] { return samples.uniform(0, 3); }),
          filled(count, [&] { return samples.binades(-13, 7); })};
}

const LoadSharing<double>& one_surface() {
  static const LoadSharing<double> sharing(model, 0.3, 1.146);
  return sharing;
}

class RootCounts {
 public:
  void add(const LoadSharing<double>& sharing, double flooded) {
    const SharingRoot<double> root = sharing.root(flooded);
    if (root.iterations > max_sharing_steps)
      ++by_newton_;
    else if (flooded >= sharing.surface().film_from)
      ++at_film_;
    else if (flooded <= sharing.surface().floor_up_to)
      ++at_floor_;
    const auto steps = static_cast<std::uint64_t>(root.iterations);
    steps_ += steps;
    most_steps_ = std::max(most_steps_, steps);
  }
  Counters counters() const {
    return {{"root_steps", steps_},
            {"most_root_steps", most_steps_},
            {"roots_skipped_at_film", at_film_},
            {"roots_skipped_at_floor", at_floor_},
            {"roots_by_newton", by_newton_}};
  }

 private:
  std::uint64_t steps_ = 0, most_steps_ = 0, at_film_ = 0, at_floor_ = 0, by_newton_ = 0;
};

Counters counters(const SharingWork& work) {
  return {{"root_steps", work.steps}, {"roots_by_newton", work.by_newton}};
}

}  // namespace

Workloads root_workloads() {
  const Points at = points();
  std::vector<double> film(count);
  return {
      {"root_wide", false,
       [at, film]() mutable {
         for (std::size_t i = 0; i < count; ++i)
           film[i] = film_parameter(model, at.stiffness[i], at.offset[i], at.flooded[i]);
       },
       [at] {
         RootCounts counts;
         for (std::size_t i = 0; i < count; ++i)
           counts.add({model, at.stiffness[i], at.offset[i]}, at.flooded[i]);
         return counts.counters();
       }},
      {"root_one_surface", false,
       [at, film]() mutable {
         for (std::size_t i = 0; i < count; ++i)
           film[i] = one_surface().film_parameter(at.flooded[i]);
       },
       [at] {
         RootCounts counts;
         for (const double flooded : at.flooded) counts.add(one_surface(), flooded);
         return counts.counters();
       }},
      {"root_wide_batch", true,
       [at, film]() mutable { film_parameter(model, at.stiffness, at.offset, at.flooded, film); },
       [at, film]() mutable {
         return counters(film_parameter(model, at.stiffness, at.offset, at.flooded, film));
       }},
      {"root_one_surface_batch", true,
       [at, film]() mutable { film_parameter(one_surface(), at.flooded, film); },
       [at, film]() mutable { return counters(film_parameter(one_surface(), at.flooded, film)); }}};
}

}  // namespace tribo::gates
