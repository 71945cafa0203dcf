// SPDX-License-Identifier: Apache-2.0
// F_n, S_n and ln F_n at each of the six orders. Their text fixes their work: no counters.
#include <array>
#include <span>

#include "gates/samples.hpp"
#include "gates/workloads.hpp"
#include "tribo/batch.hpp"
#include "tribo/gaussian_moment.hpp"

namespace tribo::gates {
namespace {

constexpr std::size_t count = 512;  // arguments of each order

std::vector<double> arguments() {
  Samples samples(1);
  return filled(count, [&] { return samples.uniform(-6, 12); });
}

template <class Function>
Workload one_by_one(std::string name, Function function) {
  return {std::move(name),
          false,
          [function, d = arguments(), values = std::vector<double>(count)]() mutable {
            for (int order = 0; order < 6; ++order)
              for (std::size_t i = 0; i < count; ++i)
                values[i] = function(static_cast<Order>(order), d[i]);
          },
          {}};
}

using Batch = void (*)(Order, std::span<const double>, std::span<double>);

Workload in_batch(std::string name, Batch batch) {
  return {std::move(name),
          true,
          [batch, d = arguments(), values = std::vector<double>(count)]() mutable {
            for (int order = 0; order < 6; ++order) batch(static_cast<Order>(order), d, values);
          },
          {}};
}

}  // namespace

Workloads moment_workloads() {
  return {
      one_by_one("moment", [](Order n, double d) { return gaussian_moment(n, d); }),
      one_by_one("scaled_moment", [](Order n, double d) { return scaled_gaussian_moment(n, d); }),
      in_batch("moment_batch", gaussian_moment),
      in_batch("scaled_moment_batch", scaled_gaussian_moment),
      in_batch("log_moment_batch", log_gaussian_moment)};
}

}  // namespace tribo::gates
