// SPDX-License-Identifier: Apache-2.0
// The batches whose throughput is measured, and the copy that they are held against.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tribo::benchmarks {

// The arrays of so many points, and work on a part of them.
struct KernelRoom {
  std::function<void(std::size_t first, std::size_t count)> run;
  std::shared_ptr<void> arrays;
};

struct ThroughputKernel {
  std::string name;
  std::size_t bytes;  // read and written for a point
  std::function<KernelRoom(std::size_t points)> make;
};

// The copy of doubles comes first.
std::vector<ThroughputKernel> throughput_kernels();

}  // namespace tribo::benchmarks
