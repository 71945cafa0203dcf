// SPDX-License-Identifier: Apache-2.0
// A chunk that was computed: what a part keeps of it.
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
  // Where the scene keeps points: its variables in their order, then its columns; each with the
  // room of a whole chunk, even where the last one has fewer cases.
  std::vector<PackedValues> values;
  // summaries[c][i]: the summary of value i < width (of each case) of column c.
  std::vector<std::vector<ValueSummary>> summaries;
  // With sensitivity: likewise, in the blocks that the chunk touches.
  std::vector<std::vector<std::map<std::uint32_t, SensitivitySums>>> sensitivities;

  Bytes bytes() const;
  // Throws std::runtime_error if they are not those of a chunk.
  static Chunk from(std::span<const std::byte> bytes);
};

}  // namespace tribo::sweep
