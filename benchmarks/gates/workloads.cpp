// SPDX-License-Identifier: Apache-2.0
#include "gates/workloads.hpp"

#include <cmath>

#include "gates/samples.hpp"

namespace tribo::gates {

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
  static const std::vector<double> arguments = [] {
    Samples samples(4);
    return filled(4096, [&] { return samples.uniform(-20, 20); });
  }();
  static std::vector<double> values(arguments.size());
  for (std::size_t i = 0; i < arguments.size(); ++i) values[i] = std::exp(arguments[i]);
}

}  // namespace tribo::gates
