// SPDX-License-Identifier: Apache-2.0
#include "work_precision/throughput.hpp"

#include <algorithm>
#include <cstddef>
#include <thread>

#include "work_precision/throughput_kernels.hpp"
#include "work_precision/timing.hpp"

namespace tribo::benchmarks {
namespace {

constexpr std::size_t threaded_points = std::size_t{1} << 21;

double gigabytes(double points_per_second, std::size_t bytes) {
  return four_digits(1e-9 * points_per_second * static_cast<double>(bytes));
}

// Wall time of one pass over all points, the least of the rounds.
double threaded_seconds(const KernelRoom& room, unsigned threads, int rounds) {
  double least = 1e300;
  for (int round = 0; round < rounds; ++round) {
    const double start = wall_seconds();
    {
      std::vector<std::jthread> all;
      for (unsigned t = 0; t < threads; ++t) {
        const std::size_t first = threaded_points * t / threads;
        const std::size_t end = threaded_points * (t + 1) / threads;
        all.emplace_back([&room, first, end] { room.run(first, end - first); });
      }
    }
    least = std::min(least, wall_seconds() - start);
  }
  return least;
}

}  // namespace

Rows throughput_by_size(const Effort& effort) {
  const std::vector<ThroughputKernel> kernels = throughput_kernels();
  Rows rows;
  for (std::size_t points = 1; points <= std::size_t{1} << 22; points *= 4) {
    std::vector<KernelRoom> rooms;
    std::vector<Timed> timed;
    for (const ThroughputKernel& kernel : kernels) {
      rooms.push_back(kernel.make(points));
      timed.push_back({[room = rooms.back(), points] { room.run(0, points); }, {}});
    }
    const std::vector<double> seconds =
        median_seconds(timed, effort.rounds, effort.least_seconds / 4);
    const double copied = static_cast<double>(points) / seconds[0];
    for (std::size_t k = 0; k < kernels.size(); ++k) {
      const double rate = static_cast<double>(points) / seconds[k];
      rows.push_back({{"kernel", kernels[k].name},
                      {"points", points},
                      {"ns", four_digits(1e9 / rate)},
                      {"points_per_second", four_digits(rate)},
                      {"bytes", kernels[k].bytes},
                      {"gigabytes_per_second", gigabytes(rate, kernels[k].bytes)},
                      {"share_of_copy", four_digits(gigabytes(rate, kernels[k].bytes) /
                                                    gigabytes(copied, kernels[0].bytes))}});
    }
  }
  return rows;
}

Rows throughput_by_threads(const Effort& effort) {
  Rows rows;
  for (const ThroughputKernel& kernel : throughput_kernels()) {
    const KernelRoom room = kernel.make(threaded_points);
    double alone = 0;
    for (unsigned threads = 1; threads <= std::max(1U, std::thread::hardware_concurrency());
         ++threads) {
      const double seconds = threaded_seconds(room, threads, effort.rounds);
      if (threads == 1) alone = seconds;
      const double rate = static_cast<double>(threaded_points) / seconds;
      rows.push_back({{"kernel", kernel.name},
                      {"threads", threads},
                      {"points_per_second", four_digits(rate)},
                      {"gigabytes_per_second", gigabytes(rate, kernel.bytes)},
                      {"speedup", four_digits(alone / seconds)}});
    }
  }
  return rows;
}

}  // namespace tribo::benchmarks
