// SPDX-License-Identifier: Apache-2.0
#include "sweep/design.hpp"

#include <Random123/philox.h>

#include <algorithm>
#include <array>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

namespace tribo::sweep {
namespace {

// The purposes of random words; no two purposes share a word.
enum class Stream : std::uint32_t { monte_carlo, sobol_shift, permutation, place_in_cell };

class RandomWords {
 public:
  explicit RandomWords(std::uint64_t seed)
      : key_{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}} {}

  std::pair<std::uint64_t, std::uint64_t> two(Stream stream, std::uint64_t number,
                                              std::size_t row) const {
    const r123::Philox4x32::ctr_type words = r123::Philox4x32()(
        {{static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(number >> 32),
          static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(stream)}},
        key_);
    return {words[0] | std::uint64_t{words[1]} << 32, words[2] | std::uint64_t{words[3]} << 32};
  }

  // Makes a word for each dimension of a point, two dimensions at a time.
  template <class Use>
  void each_dimension(Stream stream, std::uint64_t point, std::size_t dimensions, Use use) const {
    for (std::size_t d = 0; d < dimensions; d += 2) {
      const auto [even, odd] = two(stream, point, d / 2);
      use(d, even);
      if (d + 1 < dimensions) use(d + 1, odd);
    }
  }

 private:
  r123::Philox4x32::key_type key_;
};

// The place of a point in a rectangle of columns × rows ≥ N, counted row by row.
struct Square {
  std::uint64_t column, row;
};

// A permutation of 0 … N − 1 for each dimension, by a Feistel network (Black and Rogaway, Ciphers
// with arbitrary finite domains, CT-RSA 2002). Its halves are the column and the row of a number in
// a rectangle of hardly more than N places. So hardly any number has to go through the network
// twice to come out below N.
class CellPermutations {
 public:
  CellPermutations(const RandomWords& words, std::size_t dimensions, std::uint64_t points)
      : points_(points), keys_(dimensions) {
    columns_ = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(points)));
    columns_ = std::max<std::uint64_t>(columns_, 1);
    rows_ = (points + columns_ - 1) / columns_;
    for (std::size_t d = 0; d < dimensions; ++d)
      for (std::size_t round = 0; round < rounds; round += 2)
        std::tie(keys_[d][round], keys_[d][round + 1]) = words.two(Stream::permutation, round, d);
  }

  Square square_of(std::uint64_t point) const { return {point % columns_, point / columns_}; }
  void advance(Square& square) const {
    if (++square.column < columns_) return;
    square.column = 0;
    ++square.row;
  }

  std::uint64_t cell(std::size_t dimension, Square at) const {
    const std::array<std::uint64_t, rounds>& keys = keys_[dimension];
    for (;;) {
      for (std::size_t round = 0; round < rounds; round += 2) {
        at.column = moved(at.column, at.row, keys[round], columns_);
        at.row = moved(at.row, at.column, keys[round + 1], rows_);
      }
      const std::uint64_t cell = at.row * columns_ + at.column;
      if (cell < points_) return cell;
    }
  }

 private:
  static constexpr std::size_t rounds = 6;

  // `half` plus a hash of the other half and the key, modulo `size` < 2³².
  static std::uint64_t moved(std::uint64_t half, std::uint64_t other, std::uint64_t key,
                             std::uint64_t size) {
    std::uint64_t hash = (other ^ key) * 0x9E3779B97F4A7C15;
    hash = (hash ^ hash >> 32) * 0xD6E8FEB86659FD93;
    const std::uint64_t sum = half + ((hash >> 32) * size >> 32);
    return sum < size ? sum : sum - size;
  }

  std::uint64_t points_, columns_, rows_;
  std::vector<std::array<std::uint64_t, rounds>> keys_;
};

constexpr std::uint64_t most_cells = std::uint64_t{1} << 48;

}  // namespace

struct UnitPoints::State {
  Design design;
  std::size_t dimensions;
  std::uint64_t all;
  RandomWords words;
  std::optional<CellPermutations> permutations;
  std::optional<boost::random::sobol> sobol;
  std::uint64_t sobol_next = 0;  // the point that the engine gives next; 0: none yet
  std::vector<std::uint64_t> shift;

  void monte_carlo(std::uint64_t first, std::size_t count, double* to) const {
    for (std::size_t i = 0; i < count; ++i, to += dimensions)
      words.each_dimension(Stream::monte_carlo, first + i, dimensions,
                           [&](std::size_t d, std::uint64_t word) { to[d] = unit_number(word); });
  }

  void latin_hypercube(std::uint64_t first, std::size_t count, double* to) const {
    const double width = 1 / static_cast<double>(all);
    // The product, the sum and unit_number()'s grid are off by no more than 2⁻⁵¹ together.
    const double margin = static_cast<double>(all) * 0x1p-50;
    Square square = permutations->square_of(first);
    for (std::size_t i = 0; i < count; ++i, to += dimensions) {
      words.each_dimension(
          Stream::place_in_cell, first + i, dimensions, [&](std::size_t d, std::uint64_t word) {
            const double place = std::clamp(unit_number(word), margin, 1 - margin);
            const auto cell = static_cast<double>(permutations->cell(d, square));
            const double coordinate = cell * width + place * width;
            to[d] = unit_number(static_cast<std::uint64_t>(coordinate * 0x1p52) << 12);
          });
      permutations->advance(square);
    }
  }

  void sobol_sequence(std::uint64_t first, std::size_t count, double* to) {
    const std::uint64_t end = first + count;
    if (first == 0 && count > 0) {
      for (std::size_t d = 0; d < dimensions; ++d) to[d] = unit_number(shift[d]);
      ++first;
      to += dimensions;
    }
    if (first >= end) return;
    if (sobol_next != first) sobol->seed(first - 1);
    for (; first < end; ++first, to += dimensions)
      for (std::size_t d = 0; d < dimensions; ++d) to[d] = unit_number((*sobol)() ^ shift[d]);
    sobol_next = end;
  }
};

UnitPoints::UnitPoints(Design design, std::size_t dimensions, std::uint64_t points,
                       std::uint64_t seed)
    : state_(std::make_unique<State>(
          State{design, dimensions, points, RandomWords(seed), {}, {}, 0, {}})) {
  if (design == Design::factorial) throw std::invalid_argument("a factorial design draws nothing");
  if (dimensions == 0) return;
  if (design == Design::latin_hypercube) {
    if (points > most_cells)
      throw std::invalid_argument("a Latin hypercube has at most 2^48 points");
    state_->permutations.emplace(state_->words, dimensions, points);
  }
  if (design == Design::sobol) {
    state_->sobol.emplace(dimensions);
    state_->shift.resize(dimensions);
    state_->words.each_dimension(
        Stream::sobol_shift, 0, dimensions,
        [&](std::size_t d, std::uint64_t word) { state_->shift[d] = word; });
  }
}
UnitPoints::~UnitPoints() = default;

void UnitPoints::points(std::uint64_t first, std::span<double> coordinates) {
  if (state_->dimensions == 0) return;
  const std::size_t count = coordinates.size() / state_->dimensions;
  if (first > state_->all || count > state_->all - first)
    throw std::out_of_range("the design has no such point");
  switch (state_->design) {
    case Design::latin_hypercube:
      return state_->latin_hypercube(first, count, coordinates.data());
    case Design::sobol:
      return state_->sobol_sequence(first, count, coordinates.data());
    default:
      return state_->monte_carlo(first, count, coordinates.data());
  }
}

}  // namespace tribo::sweep
