// SPDX-License-Identifier: Apache-2.0
// Chunks as bytes: a written chunk is read again, and damaged bytes are refused.
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

bool is_refused(std::span<const std::byte> bytes) {
  try {
    Chunk::from(bytes);
  } catch (const std::runtime_error&) {
    return true;
  }
  return false;
}

TEST(Chunk, IsRefusedCutOffAnywhere) {
  const Bytes bytes = with_everything().bytes();
  std::size_t refused = 0;
  for (std::size_t size = 0; size < bytes.size(); ++size)
    refused += is_refused(std::span(bytes).first(size)) ? 1 : 0;
  EXPECT_EQ(refused, bytes.size());
}

TEST(Chunk, IsRefusedWithMoreBehindIt) {
  Bytes bytes = with_everything().bytes();
  bytes.push_back(std::byte{0});
  EXPECT_EQ(is_refused(bytes), true);
}

TEST(Chunk, HasNoListThatEndsWithinANumber) {
  for (const std::size_t size : {0, 7, 8, 9, 16}) {
    Bytes bytes;
    put(bytes, std::span<const std::byte>(Bytes(size)));
    std::vector<double> list;
    if (size % sizeof(double) == 0) {
      Receiver{bytes}(list);
      EXPECT_EQ(list.size(), size / sizeof(double));
    } else {
      EXPECT_THROW(Receiver{bytes}(list), std::runtime_error) << size;
    }
  }
}

// Checksums of parts find damage. Here damaged bytes must only do no harm.
TEST(Chunk, OfDamagedBytesIsRefusedOrReadWithoutHarm) {
  const Bytes bytes = with_everything().bytes();
  std::mt19937_64 random(17);
  int refused = 0;
  for (int i = 0; i < 5000; ++i) {
    Bytes damaged = bytes;
    const std::size_t first = random() % damaged.size();
    for (std::size_t k = first; k < std::min(first + random() % 9, damaged.size()); ++k)
      damaged[k] = static_cast<std::byte>(random());
    refused += is_refused(damaged) ? 1 : 0;
  }
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace tribo::sweep
