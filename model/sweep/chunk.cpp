// SPDX-License-Identifier: Apache-2.0
#include "sweep/chunk.hpp"

#include <stdexcept>

namespace tribo::sweep {
Bytes Chunk::bytes() const {
  Bytes bytes;
  Sender{bytes}(number, values, summaries, sensitivities);
  return bytes;
}

Chunk Chunk::from(std::span<const std::byte> bytes) {
  Receiver from(bytes);
  Chunk chunk;
  from(chunk.number, chunk.values, chunk.summaries, chunk.sensitivities);
  for (const PackedValues& packed : chunk.values)
    if (packed.element_size != 1 && packed.element_size != 8)
      throw std::runtime_error("values of a size that no chunk has");
  for (const auto& column : chunk.summaries)
    for (const ValueSummary& summary : column)
      if (summary.sketch.count() != summary.moments.count)
        throw std::runtime_error("these bytes are no summary: its counts differ");
  for (const auto& column : chunk.sensitivities)
    for (const auto& blocks : column)
      if (!blocks.empty() && blocks.rbegin()->first >= jackknife_blocks)
        throw std::runtime_error("a block of sensitivity that no chunk has");
  if (!from.empty()) throw std::runtime_error("a chunk is followed by more bytes");
  return chunk;
}

}  // namespace tribo::sweep
