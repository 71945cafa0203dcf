// SPDX-License-Identifier: Apache-2.0
#include "sweep/quantile_sketch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "support/judge.hpp"

namespace tribo::verification {
namespace {

using sweep::Bytes;
using sweep::QuantileSketch;
using sweep::Receiver;

using Limits = std::numeric_limits<double>;

std::vector<std::vector<double>> samples() {
  Sampler sampler(1);
  const auto sample = [](std::size_t size, auto draw) {
    std::vector<double> values(size);
    for (double& value : values) value = draw();
    return values;
  };
  return {
      {0},
      {-3.5},
      {Limits::max(), -Limits::max(), Limits::min(), -Limits::min(), Limits::denorm_min(), -0.0, 0},
      {1, 1, 1, 1, 2},
      sample(5000, [&] { return sampler.uniform(0, 1); }),
      sample(5000, [&] { return sampler.uniform(-1, 2); }),
      sample(1500, [&] { return sampler.log_uniform(1e-300, 1e300); }),
      sample(5000,
             [&] {
               return sampler.pick({-1, 1, 0}) * sampler.log_uniform(1e-9, 1e9);
             }),
      sample(5000, [&] { return -1e-6 - 1e-9 * sampler.uniform(0, 1); }),
      sample(1500, [&] { return std::ldexp(1, static_cast<int>(sampler.uniform(-1070, 1023))); }),
  };
}

QuantileSketch sketch_of(const std::vector<double>& values) {
  QuantileSketch sketch;
  sketch.add(values);
  return sketch;
}

Bytes bytes_of(const QuantileSketch& sketch) {
  Bytes bytes;
  sketch.write(bytes);
  return bytes;
}

TEST(QuantileSketch, IsWithinItsErrorOfTheValueOfThatRank) {
  for (std::vector<double> values : samples()) {
    const QuantileSketch sketch = sketch_of(values);
    EXPECT_EQ(sketch.count(), values.size());
    std::sort(values.begin(), values.end());
    for (std::size_t rank = 0; rank < values.size(); rank += 1 + values.size() / 200) {
      const double exact = values[rank];
      const double allowed =
          std::abs(exact) < 2.3e-308 ? 2.3e-308 : QuantileSketch::relative_error * std::abs(exact);
      EXPECT_TRUE(is_within(sketch.value_at_rank(rank), exact, allowed))
          << "rank " << rank << " of " << values.size();
    }
  }
}

TEST(QuantileSketch, BinsHoldWhatLiesBetweenTheirEdges) {
  for (const std::vector<double>& values : samples()) {
    const std::vector<QuantileSketch::Bin> bins = sketch_of(values).bins();
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < bins.size(); ++i) {
      const double low = bins[i].low, high = bins[i].high;
      const auto count = std::count_if(values.begin(), values.end(), [&](double value) {
        // An edge belongs to the bin farther from zero; beyond the last edge there is no bin.
        if (value > 0) return low <= value && (value < high || high == Limits::max());
        return (low < value || low == -Limits::max()) && value <= high;
      });
      EXPECT_EQ(bins[i].count, static_cast<std::uint64_t>(count))
          << describe({{"low", low}, {"high", high}});
      sum += bins[i].count;
      if (i > 0) {
        EXPECT_LE(bins[i - 1].high, bins[i].low);
      }
    }
    EXPECT_EQ(sum, values.size());
  }
}

TEST(QuantileSketch, EdgesGrowAndTheirNumbersAreContinuous) {
  EXPECT_EQ(QuantileSketch::bin_of(Limits::max()), QuantileSketch::greatest_bin);
  EXPECT_EQ(QuantileSketch::bin_of(-Limits::max()), -QuantileSketch::greatest_bin);
  EXPECT_EQ(QuantileSketch::bin_of(Limits::min()), 1);
  for (const double near_zero :
       {0.0, -0.0, Limits::denorm_min(), std::nextafter(Limits::min(), 0)}) {
    EXPECT_EQ(QuantileSketch::bin_of(near_zero), 0);
    EXPECT_EQ(QuantileSketch::bin_of(-near_zero), 0);
  }
  for (std::int32_t bin = 1; bin <= QuantileSketch::greatest_bin; bin += 97) {
    const double low = QuantileSketch::edge(bin), high = QuantileSketch::edge(bin + 1);
    EXPECT_LT(low, high);
    EXPECT_EQ(QuantileSketch::bin_of(low), bin);
    EXPECT_EQ(QuantileSketch::bin_of(std::nextafter(low, 0)), bin - 1);
    EXPECT_EQ(QuantileSketch::edge(-bin), -high);
    EXPECT_EQ(QuantileSketch::bin_of(-low), -bin);
  }
}

TEST(QuantileSketch, MergedInAnyOrderHasTheSameBytes) {
  std::mt19937_64 words(3);
  for (std::vector<double> values : samples()) {
    const Bytes expected = bytes_of(sketch_of(values));
    for (int i = 0; i < 5; ++i) {
      std::shuffle(values.begin(), values.end(), words);
      std::vector<QuantileSketch> parts(1 + words() % 5);
      for (const double value : values) parts[words() % parts.size()].add(std::span(&value, 1));
      QuantileSketch whole;
      for (const QuantileSketch& part : parts) whole.merge(part);
      EXPECT_EQ(bytes_of(whole), expected);
    }
  }
}

TEST(QuantileSketch, IsReadAsItWasWritten) {
  for (const std::vector<double>& values : samples()) {
    const QuantileSketch sketch = sketch_of(values);
    const Bytes bytes = bytes_of(sketch);
    Receiver reader(bytes);
    const QuantileSketch read = QuantileSketch::read(reader);
    EXPECT_EQ(reader.empty(), true);
    EXPECT_EQ(bytes_of(read), bytes);
    EXPECT_EQ(read.count(), sketch.count());
    for (std::uint64_t rank = 0; rank < sketch.count(); rank += 1 + sketch.count() / 7)
      EXPECT_EQ(read.value_at_rank(rank), sketch.value_at_rank(rank));
  }
  const Bytes empty = bytes_of(QuantileSketch());
  Receiver reader(empty);
  EXPECT_EQ(QuantileSketch::read(reader).count(), 0U);
}

TEST(QuantileSketch, TakesTwoOrThreeBytesABin) {
  const QuantileSketch sketch = sketch_of(samples()[4]);
  EXPECT_LE(bytes_of(sketch).size(), 3 * sketch.bins().size() + 10);
}

// sketch: it is written again as the same bytes; refused: std::runtime_error; other: the rest.
enum class Verdict { sketch, refused, other };
Verdict judge(const Bytes& bytes) {
  Receiver reader(bytes);
  try {
    Bytes again = bytes_of(QuantileSketch::read(reader));
    if (again.size() > bytes.size()) return Verdict::other;
    const auto end = bytes.begin() + static_cast<std::ptrdiff_t>(again.size());
    return std::equal(bytes.begin(), end, again.begin()) ? Verdict::sketch : Verdict::other;
  } catch (const std::runtime_error&) {
    return Verdict::refused;
  }
}

TEST(QuantileSketch, OfBytesThatAreNoneIsRefusedOrIsWhatTheySay) {
  std::mt19937_64 words(4);
  for (const std::vector<double>& values : samples()) {
    const Bytes bytes = bytes_of(sketch_of(values));
    for (int i = 0; i < 100; ++i) {
      Bytes damaged = bytes;
      for (std::uint64_t flips = 1 + words() % 3; flips > 0; --flips)
        damaged[words() % damaged.size()] ^= std::byte{1} << (words() % 8);
      EXPECT_NE(judge(damaged), Verdict::other);
    }
  }
  for (int i = 0; i < 2000; ++i) {
    Bytes noise(words() % 60);
    for (std::byte& byte : noise) byte = static_cast<std::byte>(words());
    EXPECT_NE(judge(noise), Verdict::other);
  }
  const auto bytes = [](std::initializer_list<int> list) {
    Bytes made;
    for (const int byte : list) made.push_back(static_cast<std::byte>(byte));
    return made;
  };
  EXPECT_EQ(judge(bytes({1, 1, 0})), Verdict::refused) << "an empty bin";
  EXPECT_EQ(judge(bytes({1, 0, 1})), Verdict::refused) << "a bin below the least";
  EXPECT_EQ(judge(bytes({2, 1, 1, 0, 1})), Verdict::refused) << "a bin twice";
  EXPECT_EQ(judge(bytes({1, 0x81, 0x80, 0x80, 0x02, 1})), Verdict::refused)
      << "beyond the greatest";
  EXPECT_EQ(judge(bytes({1, 0x81, 0x00, 1})), Verdict::refused) << "a number longer than need be";
  EXPECT_EQ(judge(bytes({1, 1, 255, 255, 255, 255, 255, 255, 255, 255, 255, 2})), Verdict::refused)
      << "a number of more than 64 bits";
  EXPECT_EQ(judge(bytes({255, 255, 255, 255, 255, 255, 255, 255, 255, 1})), Verdict::refused)
      << "2^64 - 1 bins";
  EXPECT_EQ(judge(bytes({1, 1, 1})), Verdict::sketch);
}

}  // namespace
}  // namespace tribo::verification
