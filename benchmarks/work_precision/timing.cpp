// SPDX-License-Identifier: Apache-2.0
#include "work_precision/timing.hpp"

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <numeric>
#include <random>

namespace tribo::benchmarks {
namespace {

double seconds_a_call(const Timed& timed, double least) {
  if (timed.own_seconds) {
    timed.run();
    return timed.own_seconds();
  }
  const double start = cpu_seconds();
  long done = 0;
  double passed = 0;
  // The clock is asked after 1, 2, 4, … calls, so that it takes hardly any time.
  for (long calls = 1; passed < least; calls *= 2) {
    for (long i = 0; i < calls; ++i) timed.run();
    done += calls;
    passed = cpu_seconds() - start;
  }
  return passed / static_cast<double>(done);
}

}  // namespace

double cpu_seconds() {
  std::timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::vector<double> median_seconds(const std::vector<Timed>& all, int rounds, double least) {
  std::vector<std::vector<double>> seconds(all.size());
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), 0);
  std::mt19937_64 generator(3);
  for (int round = 0; round < rounds; ++round) {
    std::shuffle(order.begin(), order.end(), generator);
    for (const std::size_t i : order) seconds[i].push_back(seconds_a_call(all[i], least));
  }
  std::vector<double> medians;
  for (std::vector<double>& times : seconds) {
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::nth_element(times.begin(), middle, times.end());
    medians.push_back(*middle);
  }
  return medians;
}

}  // namespace tribo::benchmarks
