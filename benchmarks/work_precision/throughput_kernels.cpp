// SPDX-License-Identifier: Apache-2.0
#include "work_precision/throughput_kernels.hpp"

#include <algorithm>
#include <span>

#include "cases/curve_cases.hpp"
#include "cases/moment_cases.hpp"
#include "cases/root_cases.hpp"
#include "tribo/batch.hpp"
#include "tribo/mixed_contact.hpp"

namespace tribo::benchmarks {
namespace {

constexpr AsperityModel model = AsperityModel::greenwood_tripp;

struct Pair {
  std::vector<double> in, out;
  std::span<const double> read(std::size_t first, std::size_t count) const {
    return std::span(in).subspan(first, count);
  }
  std::span<double> write(std::size_t first, std::size_t count) {
    return std::span(out).subspan(first, count);
  }
};

// work(in, out) on one array in and one out.
template <class Work>
std::function<KernelRoom(std::size_t)> one_to_one(std::vector<double> (*arguments)(std::size_t),
                                                  Work work) {
  return [=](std::size_t points) -> KernelRoom {
    const auto arrays = std::make_shared<Pair>();
    arrays->in = arguments(points);
    arrays->out.resize(points);
    Pair* const pair = arrays.get();
    return {[=](std::size_t first, std::size_t count) {
              work(pair->read(first, count), pair->write(first, count));
            },
            arrays};
  };
}

std::vector<double> flooded_films(std::size_t count) {
  return random_root_cases(RootJob::one_surface, count).flooded;
}

KernelRoom varying_roots(std::size_t points) {
  struct Arrays {
    StoredRootCases cases;
    std::vector<double> film;
  };
  const auto arrays =
      std::make_shared<Arrays>(Arrays{random_root_cases(RootJob::wide, points), {}});
  arrays->film.resize(points);
  Arrays* const all = arrays.get();
  return {[=](std::size_t first, std::size_t count) {
            const RootCases part = all->cases.view(first, count);
            film_parameter(model, part.stiffness, part.offset, part.flooded,
                           std::span(all->film).subspan(first, count));
          },
          arrays};
}

KernelRoom operating_points(std::size_t points) {
  struct Arrays {
    MixedContact<double> contact{curve_scene()};
    std::vector<double> speeds;
    OperatingPoints points;
  };
  const auto arrays = std::make_shared<Arrays>();
  arrays->speeds = curve_speeds(std::max<std::size_t>(points, 2));
  arrays->points.resize(points, curve_outputs());
  Arrays* const all = arrays.get();
  return {[=](std::size_t first, std::size_t count) {
            solve(all->contact, std::span<const double>(all->speeds).subspan(first, count),
                  curve_outputs(), all->points, first);
          },
          arrays};
}

}  // namespace

std::vector<ThroughputKernel> throughput_kernels() {
  const LoadSharing<double> surface(model, 0.3, 1.146);
  return {
      {"copy", 16,
       one_to_one(moment_arguments,
                  [](std::span<const double> in, std::span<double> out) {
                    std::copy(in.begin(), in.end(), out.begin());
                  })},
      {"F_5/2", 16,
       one_to_one(moment_arguments,
                  [](std::span<const double> in, std::span<double> out) {
                    gaussian_moment(Order::five_halves, in, out);
                  })},
      {"film, one surface", 16,
       one_to_one(flooded_films,
                  [surface](std::span<const double> in, std::span<double> out) {
                    film_parameter(surface, in, out);
                  })},
      {"film, all inputs vary", 32, varying_roots},
      // Speed in; speed, film, share and friction out.
      {"operating points", 40, operating_points},
  };
}

}  // namespace tribo::benchmarks
