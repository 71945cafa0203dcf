// SPDX-License-Identifier: Apache-2.0
// A chunk that was computed, as a part keeps it.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "sweep/bytes.hpp"
#include "sweep/packed_values.hpp"
#include "sweep/sensitivity.hpp"
#include "sweep/summary.hpp"

namespace tribo::sweep {

struct Chunk {
  std::uint64_t number = 0;  // in the plan
  // Where the scene keeps points: the values of the variables in their order, then of the columns.
  // Each has the size of a whole chunk, even in the last chunk, which may have fewer cases.
  std::vector<PackedValues> values;
  // summaries[c][i]: the summary of value i < width (of each case) of column c.
  std::vector<std::vector<ValueSummary>> summaries;
  // sensitivities[c][i], with sensitivity: the sums of value i in each block the chunk touches.
  std::vector<std::vector<std::map<std::uint32_t, SensitivitySums>>> sensitivities;

  Bytes bytes() const;
  // Throws std::runtime_error if the bytes are not those of a chunk.
  static Chunk from(std::span<const std::byte> bytes);
};

}  // namespace tribo::sweep
