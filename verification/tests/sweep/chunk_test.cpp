// SPDX-License-Identifier: Apache-2.0
// Chunks are written as bytes and read again, and damaged bytes are refused.
#include "sweep/chunk.hpp"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

#include "sweep/small_sweep.hpp"

namespace tribo::sweep {
namespace {

Chunk with_everything() { return small_chunk(small_plan().scenes[1], 1, 4); }

TEST(Chunk, IsReadAsItWasWritten) {
  const Chunk chunk = with_everything();
  const Chunk read = Chunk::from(chunk.bytes());
  EXPECT_EQ(read.number, 4U);
  ASSERT_EQ(read.values.size(), chunk.values.size());
  for (std::size_t i = 0; i < chunk.values.size(); ++i) {
    EXPECT_EQ(read.values[i].element_size, chunk.values[i].element_size);
    EXPECT_EQ(read.values[i].bytes, chunk.values[i].bytes);
  }
  EXPECT_EQ(read.summaries.size(), chunk.summaries.size());
  EXPECT_EQ(read.sensitivities.size(), chunk.sensitivities.size());
  EXPECT_EQ(read.bytes(), chunk.bytes());
}

std::string error_with(std::span<const std::byte> bytes) {
  return error_of([&] { Chunk::from(bytes); });
}

TEST(Chunk, IsRefusedCutOffAnywhere) {
  const Bytes bytes = with_everything().bytes();
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_NE(error_with(std::span(bytes).first(size)), "none") << size;
}

TEST(Chunk, IsRefusedWithMoreBehindItAndWithWhatNoChunkHas) {
  Bytes longer = with_everything().bytes();
  longer.push_back(std::byte{0});
  EXPECT_EQ(error_with(longer), "a chunk is followed by more bytes");
  Chunk other = with_everything();
  other.values[1].element_size = 4;
  EXPECT_EQ(error_with(other.bytes()), "values of a size that no chunk has");
  other = with_everything();
  ++other.summaries[0][1].moments.count;
  EXPECT_EQ(error_with(other.bytes()), "these bytes are no summary: its counts differ");
  other = with_everything();
  other.sensitivities[3][0][jackknife_blocks] = {};
  EXPECT_EQ(error_with(other.bytes()), "a block of sensitivity that no chunk has");
}

TEST(Chunk, HasNoListThatEndsWithinANumber) {
  for (const std::size_t size : {0, 7, 8, 9, 16}) {
    Bytes bytes;
    put(bytes, std::span<const std::byte>(Bytes(size)));
    const auto list = [&] { return Receiver{bytes}.take<std::vector<double>>(); };
    if (size % sizeof(double) == 0)
      EXPECT_EQ(list().size(), size / sizeof(double));
    else
      EXPECT_EQ(error_of(list), "a list ends within a number");
  }
}

// The checksums of parts find damage. Here damaged bytes may be read if that does no harm.
TEST(Chunk, OfDamagedBytesIsRefusedOrReadWithoutHarm) {
  const Bytes bytes = with_everything().bytes();
  std::mt19937_64 random(17);
  int refused = 0;
  for (int i = 0; i < 5000; ++i) {
    Bytes damaged = bytes;
    const std::size_t first = random() % damaged.size();
    const std::size_t end = std::min(first + 1 + random() % 8, damaged.size());
    for (std::size_t k = first; k < end; ++k) damaged[k] = static_cast<std::byte>(random());
    refused += error_with(damaged) == "none" ? 0 : 1;
  }
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace tribo::sweep
