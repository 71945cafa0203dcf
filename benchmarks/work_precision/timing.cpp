// SPDX-License-Identifier: Apache-2.0
#include "work_precision/timing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <numeric>
#include <random>

namespace tribo::benchmarks {
namespace {

double seconds_of(clockid_t clock) {
  std::timespec now{};
  ::clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds_a_call(const Timed& timed, double least) {
  if (timed.own_seconds) {
    timed.run();
    return timed.own_seconds();
  }
  const double start = cpu_seconds();
  long done = 0;
  double passed = 0;
  // The clock is asked after 1, 2, 4, … calls, so that it costs nothing.
  for (long calls = 1; passed < least; calls *= 2) {
    for (long i = 0; i < calls; ++i) timed.run();
    done += calls;
    passed = cpu_seconds() - start;
  }
  return passed / static_cast<double>(done);
}

}  // namespace

double cpu_seconds() { return seconds_of(CLOCK_PROCESS_CPUTIME_ID); }
double wall_seconds() { return seconds_of(CLOCK_MONOTONIC); }

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

double part_within(const std::vector<std::vector<double>>& times, std::size_t contender,
                   double times_the_least) {
  const std::vector<double>& own = times[contender];
  std::size_t within = 0;
  for (std::size_t c = 0; c < own.size(); ++c) {
    double least = own[c];
    for (const std::vector<double>& others : times) least = std::min(least, others[c]);
    within += std::isfinite(own[c]) && own[c] <= times_the_least * least ? 1 : 0;
  }
  return static_cast<double>(within) / static_cast<double>(own.size());
}

}  // namespace tribo::benchmarks
