// SPDX-License-Identifier: Apache-2.0
#include "sweep/chunk.hpp"

#include <stdexcept>

namespace tribo::sweep {
namespace {

void put_count(Bytes& to, std::size_t count) { put(to, static_cast<std::uint64_t>(count)); }

// Reserves no memory by the count, which may be false: elements are added as they are read.
template <class Take>
auto take_list(ByteReader& from, Take&& take) {
  std::vector<decltype(take(from))> list;
  const auto count = from.take<std::uint64_t>();
  for (std::uint64_t i = 0; i < count; ++i) list.push_back(take(from));
  return list;
}

PackedValues take_packed(ByteReader& from) {
  PackedValues packed;
  packed.element_size = from.take<std::uint32_t>();
  if (packed.element_size != 1 && packed.element_size != 8)
    throw std::runtime_error("values of a size that no chunk has");
  const std::span<const std::byte> bytes = from.take_bytes();
  packed.bytes.assign(bytes.begin(), bytes.end());
  return packed;
}

std::map<std::uint32_t, SensitivitySums> take_blocks(ByteReader& from) {
  std::map<std::uint32_t, SensitivitySums> blocks;
  const auto count = from.take<std::uint64_t>();
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto block = from.take<std::uint32_t>();
    const bool ascends = blocks.empty() || blocks.rbegin()->first < block;
    if (!ascends || block >= jackknife_blocks)
      throw std::runtime_error("blocks of sensitivity out of order");
    blocks.emplace_hint(blocks.end(), block, SensitivitySums::read(from));
  }
  return blocks;
}

}  // namespace

Bytes Chunk::bytes() const {
  Bytes to;
  put(to, number);
  put_count(to, values.size());
  for (const PackedValues& packed : values) {
    put(to, packed.element_size);
    put(to, std::span<const std::byte>(packed.bytes));
  }
  put_count(to, summaries.size());
  for (const auto& column : summaries) {
    put_count(to, column.size());
    for (const ValueSummary& summary : column) summary.write(to);
  }
  put_count(to, sensitivities.size());
  for (const auto& column : sensitivities) {
    put_count(to, column.size());
    for (const auto& blocks : column) {
      put_count(to, blocks.size());
      for (const auto& [block, sums] : blocks) {
        put(to, block);
        sums.write(to);
      }
    }
  }
  return to;
}

Chunk Chunk::from(std::span<const std::byte> bytes) {
  ByteReader from(bytes);
  Chunk chunk;
  chunk.number = from.take<std::uint64_t>();
  chunk.values = take_list(from, take_packed);
  chunk.summaries =
      take_list(from, [](ByteReader& in) { return take_list(in, ValueSummary::read); });
  chunk.sensitivities = take_list(from, [](ByteReader& in) { return take_list(in, take_blocks); });
  if (!from.empty()) throw std::runtime_error("a chunk is followed by more bytes");
  return chunk;
}

}  // namespace tribo::sweep
