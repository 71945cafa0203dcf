// SPDX-License-Identifier: Apache-2.0
// HDF5's own filters read packed arrays and give back the same bits.
#include "sweep/packed_values.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include "sweep/hdf5_handles.hpp"
#include "sweep/small_sweep.hpp"

namespace tribo::sweep {
namespace {

using hdf5::checked;
using hdf5::Handle;

// Writes chunks of `chunk` values as they are packed, and has HDF5 read the first `length` values.
template <class T>
std::vector<T> through_hdf5(const std::vector<PackedValues>& chunks, hsize_t chunk, hsize_t length,
                            hid_t type) {
  const TemporaryFolder folder;
  const hsize_t most = std::max(chunk, length);
  const Handle file(
      H5Fcreate(folder.file("values.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  const Handle space(H5Screate_simple(1, &length, &most));
  const Handle creation(H5Pcreate(H5P_DATASET_CREATE));
  checked(H5Pset_chunk(creation, 1, &chunk));
  checked(H5Pset_shuffle(creation));
  checked(H5Pset_deflate(creation, 1));
  const Handle dataset(H5Dcreate2(file, "values", type, space, H5P_DEFAULT, creation, H5P_DEFAULT));
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    const hsize_t first = i * chunk;
    checked(H5Dwrite_chunk(dataset, H5P_DEFAULT, 0, &first, chunks[i].bytes.size(),
                           chunks[i].bytes.data()));
  }
  std::vector<T> values(length);
  checked(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
  return values;
}

std::vector<double> back(const std::vector<double>& values) {
  return through_hdf5<double>({pack(std::span(values))}, values.size(), values.size(),
                              H5T_NATIVE_DOUBLE);
}

using Random = std::mt19937_64;
double unit(Random& random) { return (static_cast<double>(random() >> 12) + 0.5) * 0x1p-52; }

struct Kind {
  const char* name;
  std::function<double(Random&, std::size_t)> value;
};
const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{
      {"any bits", [](Random& random, std::size_t) { return std::bit_cast<double>(random()); }},
      {"uniform", [](Random& random, std::size_t) { return unit(random); }},
      {"narrow",
       [](Random& random, std::size_t) { return 0.02 * std::exp(0.05 * (unit(random) - 0.5)); }},
      {"constant", [](Random&, std::size_t) { return 0.0202; }},
      {"sorted", [](Random&, std::size_t i) { return 1e-3 + static_cast<double>(i); }},
      {"repeating", [](Random&, std::size_t i) { return std::sin(static_cast<double>(i % 60)); }},
      {"runs", [](Random&, std::size_t i) { return std::sin(static_cast<double>(i / 300)); }},
      {"half undefined", [](Random& random, std::size_t) {
         const double value = unit(random);
         return value < 0.5 ? std::numeric_limits<double>::quiet_NaN() : value;
       }}};
  return all;
}

TEST(PackedValues, HDF5ReadsTheSameBits) {
  Random random(20240601);
  for (const Kind& kind : kinds())
    // Sizes near eight (where planes begin), near the sample, and near a stored block.
    for (const std::size_t size : {1, 2, 7, 8, 9, 100, 4095, 4097, 65535, 65536, 150001}) {
      std::vector<double> values;
      for (std::size_t i = 0; i < size; ++i) values.push_back(kind.value(random, i));
      EXPECT_EQ(bits_of(back(values)), bits_of(values)) << kind.name << ", " << size;
    }
}

TEST(PackedValues, HDF5ReadsTheBitsOfUnusualNumbers) {
  using Limits = std::numeric_limits<double>;
  const std::vector<double> unusual{0.0,
                                    -0.0,
                                    Limits::denorm_min(),
                                    -Limits::denorm_min(),
                                    Limits::min() / 3,
                                    Limits::quiet_NaN(),
                                    Limits::infinity(),
                                    -Limits::infinity(),
                                    Limits::max(),
                                    Limits::lowest(),
                                    1.0};
  EXPECT_EQ(bits_of(back(unusual)), bits_of(unusual));
  Random random(7);
  std::vector<double> many;
  for (int i = 0; i < 20000; ++i) many.push_back(unusual[random() % unusual.size()]);
  EXPECT_EQ(bits_of(back(many)), bits_of(many));
}

TEST(PackedValues, HDF5ReadsTheSameWords) {
  Random random(3);
  for (const std::size_t size : {1, 9, 5000, 70000})
    for (const std::uint64_t words : {1, 3, 256}) {
      std::vector<std::uint8_t> places;
      for (std::size_t i = 0; i < size; ++i)
        places.push_back(static_cast<std::uint8_t>(random() % words));
      const PackedValues packed = pack(std::span<const std::uint8_t>(places));
      EXPECT_EQ(packed.element_size, 1U);
      EXPECT_EQ(through_hdf5<std::uint8_t>({packed}, size, size, H5T_NATIVE_UINT8), places);
    }
}

TEST(PackedValues, OfALastChunkHDF5ReadsWhatTheDatasetHas) {
  Random random(11);
  for (const std::size_t length : {1, 1999, 2000, 2001, 4700}) {
    const std::size_t chunk = 2000;
    std::vector<double> values;
    for (std::size_t i = 0; i < length; ++i) values.push_back(unit(random));
    std::vector<PackedValues> chunks;
    std::vector<double> padded = values;
    padded.resize((length + chunk - 1) / chunk * chunk);
    for (std::size_t first = 0; first < length; first += chunk)
      chunks.push_back(pack(std::span<const double>(padded).subspan(first, chunk)));
    EXPECT_EQ(bits_of(through_hdf5<double>(chunks, chunk, length, H5T_NATIVE_DOUBLE)),
              bits_of(values));
  }
}

TEST(PackedValues, ComeToTheSameBytesWhateverWasPackedBefore) {
  Random random(5);
  std::vector<std::vector<double>> arrays;
  std::vector<Bytes> first;
  for (const Kind& kind : kinds()) {
    auto& values = arrays.emplace_back();
    for (std::size_t i = 0; i < 10000; ++i) values.push_back(kind.value(random, i));
    first.push_back(pack(std::span<const double>(values)).bytes);
  }
  for (std::size_t i = arrays.size(); i-- > 0;)
    EXPECT_EQ(pack(std::span<const double>(arrays[i])).bytes, first[i]) << kinds()[i].name;
}

TEST(PackedValues, TakeLittleMoreThanTheirInformation) {
  Random random(13);
  const auto part = [&](std::size_t kind) {
    std::vector<double> values;
    for (std::size_t i = 0; i < 65536; ++i) values.push_back(kinds()[kind].value(random, i));
    const double size = static_cast<double>(pack(std::span<const double>(values)).bytes.size());
    return size / (8 * 65536);
  };
  EXPECT_LT(part(0), 1.001);  // any bits
  EXPECT_LT(part(1), 0.86);   // uniform: 52 bits, and 2 of the exponent
  EXPECT_LT(part(2), 0.83);   // narrow: some 52 bits
  EXPECT_LT(part(3), 0.006);  // constant
  EXPECT_LT(part(5), 0.009);  // repeating
}

}  // namespace
}  // namespace tribo::sweep
