// SPDX-License-Identifier: Apache-2.0
// Workloads of three kinds: moments, roots of load sharing, and operating points with curves.
#include "gates/workloads.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "tests/support/scenes.hpp"
#include "tribo/batch.hpp"
#include "tribo/gaussian_moment.hpp"
#include "tribo/load_sharing.hpp"
#include "tribo/operating_points.hpp"
#include "tribo/stribeck_walk.hpp"

namespace tribo::gates {
namespace {

// Seeded points. They have the same bits everywhere, because std::ldexp is exact here.
class Samples {
 public:
  explicit Samples(std::uint64_t seed) : generator_(seed) {}

  double uniform(double low, double high) { return low + (high - low) * unit(); }
  // A number in [2^low, 2^high); each binade is equally likely.
  double binades(int low, int high) {
    const int exponent = low + static_cast<int>(generator_() % static_cast<unsigned>(high - low));
    return std::ldexp(1 + unit(), exponent);
  }

 private:
  double unit() { return static_cast<double>(generator_() >> 11) * 0x1p-53; }
  std::mt19937_64 generator_;
};

template <class Function>
std::vector<double> filled(std::size_t count, Function&& next) {
  std::vector<double> values(count);
  for (double& value : values) value = next();
  return values;
}

// --- F_n, S_n and ln F_n at all six orders. They have no counters, because their work is constant.

constexpr std::size_t arguments_of_an_order = 512;

std::vector<double> arguments() {
  Samples samples(1);
  return filled(arguments_of_an_order, [&] { return samples.uniform(-6, 12); });
}

template <class Function>
Workload one_by_one(std::string name, Function function) {
  return {
      std::move(name),
      false,
      [function, d = arguments(), values = std::vector<double>(arguments_of_an_order)]() mutable {
        for (int order = 0; order < 6; ++order)
          for (std::size_t i = 0; i < arguments_of_an_order; ++i)
            values[i] = function(static_cast<Order>(order), d[i]);
      },
      {}};
}

using Batch = void (*)(Order, std::span<const double>, std::span<double>);

Workload in_batch(std::string name, Batch batch) {
  return {std::move(name),
          true,
          [batch, d = arguments(), values = std::vector<double>(arguments_of_an_order)]() mutable {
            for (int order = 0; order < 6; ++order) batch(static_cast<Order>(order), d, values);
          },
          {}};
}

Workloads moment_workloads() {
  return {
      one_by_one("moment", [](Order n, double d) { return gaussian_moment(n, d); }),
      one_by_one("scaled_moment", [](Order n, double d) { return scaled_gaussian_moment(n, d); }),
      in_batch("moment_batch", gaussian_moment),
      in_batch("scaled_moment_batch", scaled_gaussian_moment),
      in_batch("log_moment_batch", log_gaussian_moment)};
}

// --- The root of load sharing for many surfaces (wide) and for one, point by point and in batches.
// Each counted step evaluates the moment and its slope once.

constexpr std::size_t roots = 1024;
constexpr auto asperities = AsperityModel::greenwood_tripp;

// K in 1e-6 … 8, δ in 0 … 3, λ₀ in 1e-4 … 128
struct RootPoints {
  std::vector<double> stiffness, offset, flooded;
};

RootPoints root_points() {
  Samples samples(2);
  return {filled(roots, [&] { return samples.binades(-20, 3); }),
          filled(roots, [&] { return samples.uniform(0, 3); }),
          filled(roots, [&] { return samples.binades(-13, 7); })};
}

const LoadSharing<double>& one_surface() {
  static const LoadSharing<double> sharing(asperities, 0.3, 1.146);
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

Workloads root_workloads() {
  const RootPoints at = root_points();
  std::vector<double> film(roots);
  return {
      {"root_wide", false,
       [at, film]() mutable {
         for (std::size_t i = 0; i < roots; ++i)
           film[i] = film_parameter(asperities, at.stiffness[i], at.offset[i], at.flooded[i]);
       },
       [at] {
         RootCounts counts;
         for (std::size_t i = 0; i < roots; ++i)
           counts.add({asperities, at.stiffness[i], at.offset[i]}, at.flooded[i]);
         return counts.counters();
       }},
      {"root_one_surface", false,
       [at, film]() mutable {
         for (std::size_t i = 0; i < roots; ++i)
           film[i] = one_surface().film_parameter(at.flooded[i]);
       },
       [at] {
         RootCounts counts;
         for (const double flooded : at.flooded) counts.add(one_surface(), flooded);
         return counts.counters();
       }},
      {"root_wide_batch", true,
       [at, film]() mutable {
         film_parameter(asperities, at.stiffness, at.offset, at.flooded, film);
       },
       [at, film]() mutable {
         return counters(film_parameter(asperities, at.stiffness, at.offset, at.flooded, film));
       }},
      {"root_one_surface_batch", true,
       [at, film]() mutable { film_parameter(one_surface(), at.flooded, film); },
       [at, film]() mutable { return counters(film_parameter(one_surface(), at.flooded, film)); }}};
}

// --- Operating points of the paper's scenes, with all outputs or only those that need little work;
// and 200 points of a curve.

constexpr std::size_t speeds_a_scene = 200;

// Log-spaced from `least` to 3 m/s.
std::vector<double> speeds(double least) {
  std::vector<double> all(speeds_a_scene);
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] =
        least * std::pow(3 / least, static_cast<double>(i) / static_cast<double>(all.size() - 1));
  return all;
}

// The contacts are made outside the timed pass, as this work belongs to a scene, not to a point.
std::vector<MixedContact<double>> contacts(FilmFormula film) {
  std::vector<MixedContact<double>> all;
  for (const auto model : {AsperityModel::greenwood_tripp, AsperityModel::greenwood_williamson})
    for (const auto surface : verification::paper_surfaces) {
      Scene scene = verification::paper_scene(surface, model);
      scene.closures.film = film;
      all.emplace_back(scene);
    }
  return all;
}

OutputSet film_and_regime() {
  OutputSet outputs;
  outputs.insert(Output::film);
  outputs.insert(Output::regime);
  return outputs;
}

Workload points_of(std::string name, OutputSet outputs, double least_speed = 1e-4,
                   FilmFormula film = FilmFormula::hamrock_dowson_central) {
  OperatingPoints room;
  room.resize(speeds_a_scene, outputs);
  return {std::move(name), true,
          [all = contacts(film), u = speeds(least_speed), outputs, room]() mutable {
            for (const auto& contact : all) solve(contact, u, outputs, room);
          },
          [all = contacts(film), u = speeds(least_speed), outputs, room]() mutable {
            WorkCounts counts;
            for (const auto& contact : all) solve(contact, u, outputs, room, counts);
            Counters all_counts;
            for (const WorkInfo& info : work_infos)
              all_counts.emplace_back(info.name, counts[info.work]);
            return all_counts;
          }};
}

Workload curve() {
  const MixedContact<double> contact(verification::paper_scene(verification::PaperSurface::rough));
  return {"curve",
          false,
          [contact, friction = std::vector<double>(speeds_a_scene)]() mutable {
            std::size_t i = 0;
            stribeck_curve(contact, 1e-4, 3.0, speeds_a_scene, OutputSet::all(),
                           [&](const auto& point) { friction[i++] = point.friction; });
          },
          {}};
}

Workloads point_workloads() {
  return {points_of("points_all_outputs", OutputSet::all()),
          points_of("points_film_and_regime", film_and_regime()), curve(),
          // These speeds are in the table of solved films.
          points_of("points_hamrock_dowson", OutputSet::all(), 0.1),
          points_of("points_solved_film", OutputSet::all(), 0.1, FilmFormula::solved),
          points_of("points_nijenbanning_venner_moes", OutputSet::all(), 0.1,
                    FilmFormula::nijenbanning_venner_moes)};
}

}  // namespace

const Workloads& workloads() {
  static const Workloads all = [] {
    Workloads together;
    for (Workloads part : {moment_workloads(), root_workloads(), point_workloads()})
      for (Workload& workload : part) together.push_back(std::move(workload));
    return together;
  }();
  return all;
}

void run_control() {
  static const std::vector<double> x = [] {
    Samples samples(4);
    return filled(4096, [&] { return samples.uniform(-20, 20); });
  }();
  static std::vector<double> values(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) values[i] = std::exp(x[i]);
}

}  // namespace tribo::gates
