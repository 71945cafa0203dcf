// SPDX-License-Identifier: Apache-2.0
#include "tribo/proxy_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "gaussian_moment_scalar.hpp"
#include "processor.hpp"

namespace tribo {
namespace {

constexpr std::size_t nodes = 11;
constexpr std::size_t checks = 12;  // between the nodes, and at the ends
constexpr std::size_t samples = nodes + checks;

// Where a piece is sampled, in units of half its width from its centre; and what makes values at
// the nodes into coefficients of powers of that. In long double: the coefficients cancel by a
// factor 10³.
struct Layout {
  std::array<double, samples> places{};
  std::array<std::array<long double, nodes>, nodes> powers{};
};

Layout find_layout() {
  Layout layout;
  const auto cosine = [](std::size_t k, long double j) {
    return std::cos(static_cast<long double>(k) * std::numbers::pi_v<long double> * j / nodes);
  };
  for (std::size_t j = 0; j < nodes; ++j)
    layout.places[j] = static_cast<double>(cosine(1, static_cast<long double>(j) + 0.5L));
  for (std::size_t j = 0; j < checks; ++j)
    layout.places[nodes + j] = static_cast<double>(cosine(1, static_cast<long double>(j)));
  // Σ_k a_k T_k with a_k = (2 − [k = 0])/n Σ_j f_j T_k(x_j); T_k = 2x T_{k−1} − T_{k−2}
  std::array<std::array<long double, nodes>, nodes> chebyshev{};
  chebyshev[0][0] = chebyshev[1][1] = 1;
  for (std::size_t k = 2; k < nodes; ++k)
    for (std::size_t i = 0; i < nodes; ++i)
      chebyshev[k][i] = (i > 0 ? 2 * chebyshev[k - 1][i - 1] : 0) - chebyshev[k - 2][i];
  for (std::size_t k = 0; k < nodes; ++k)
    for (std::size_t j = 0; j < nodes; ++j)
      for (std::size_t i = 0; i < nodes; ++i)
        layout.powers[i][j] += (k == 0 ? 1.0L : 2.0L) / nodes *
                               cosine(k, static_cast<long double>(j) + 0.5L) * chebyshev[k][i];
  return layout;
}

const Layout& layout() {
  static const Layout found = find_layout();
  return found;
}

}  // namespace

// The interpolant through the first samples.
ProxyPieces::Piece ProxyPieces::fit(const Interval& interval, const double* sampled) {
  Piece piece{};
  piece.centre = (interval.low + interval.high) / 2;
  const long double inverse = 2 / static_cast<long double>(interval.high - interval.low);
  long double scale = 1;
  for (std::size_t k = 0; k < nodes; ++k, scale *= inverse) {
    long double sum = 0;
    for (std::size_t j = 0; j < nodes; ++j) sum += layout().powers[k][j] * sampled[j];
    piece.coefficients[k] = static_cast<double>(sum * scale);
  }
  return piece;
}

// Does the interpolant agree with the other samples?
bool ProxyPieces::holds(const Piece& piece, const double* places, const double* sampled,
                        double tolerance) {
  for (std::size_t j = nodes; j < samples; ++j)
    if (!(std::fabs(value_in(piece, places[j]) - sampled[j]) <= tolerance * std::fabs(sampled[j])))
      return false;
  return true;
}

void ProxyPieces::sample(const Function& function, const std::vector<Interval>& intervals,
                         std::vector<double>& places, std::vector<double>& values) {
  places.resize(intervals.size() * samples);
  values.resize(places.size());
  for (std::size_t i = 0; i < intervals.size(); ++i) {
    const double centre = (intervals[i].low + intervals[i].high) / 2;
    const double half = (intervals[i].high - intervals[i].low) / 2;
    for (std::size_t j = 0; j < samples; ++j)
      places[i * samples + j] = centre + half * layout().places[j];
  }
  function(places, values);
  evaluations_ += places.size();
}

ProxyPieces::ProxyPieces(const Function& function, double from, double to, double tolerance) {
  if (!(from > 0 && from <= to)) return;
  const auto cell_of = [](double x) { return std::bit_cast<std::uint64_t>(x) >> kept_bits; };
  const auto start_of = [](std::uint64_t cell) { return std::bit_cast<double>(cell << kept_bits); };
  constexpr std::uint64_t binade = std::uint64_t{1} << halvings;
  first_cell_ = cell_of(from) / binade * binade;
  const std::uint64_t end = cell_of(to) / binade * binade + binade;
  piece_of_cell_.assign(end - first_cell_, 0);
  pieces_.resize(1);
  pieces_[0].centre = std::numeric_limits<double>::quiet_NaN();

  std::vector<Interval> open;
  for (std::uint64_t cell = first_cell_; cell < end; cell += binade)
    open.push_back({cell - first_cell_, binade, start_of(cell), start_of(cell + binade)});
  std::vector<double> places, values;
  while (!open.empty()) {
    sample(function, open, places, values);
    std::vector<Interval> halves;
    for (std::size_t i = 0; i < open.size(); ++i) {
      const Interval& whole = open[i];
      const Piece piece = fit(whole, &values[i * samples]);
      if (holds(piece, &places[i * samples], &values[i * samples], tolerance)) {
        std::fill_n(piece_of_cell_.begin() + static_cast<std::ptrdiff_t>(whole.first), whole.count,
                    static_cast<std::uint32_t>(pieces_.size()));
        pieces_.push_back(piece);
      } else if (whole.count > 1) {
        const std::size_t half = whole.count / 2;
        const double middle = (whole.low + whole.high) / 2;
        halves.push_back({whole.first, half, whole.low, middle});
        halves.push_back({whole.first + half, half, middle, whole.high});
      }
    }
    open = std::move(halves);
  }
}

double ProxyPieces::left_out() const {
  if (piece_of_cell_.empty()) return 1;
  const auto count = std::count(piece_of_cell_.begin(), piece_of_cell_.end(), 0U);
  return static_cast<double>(count) / static_cast<double>(piece_of_cell_.size());
}

template <class Arithmetic>
[[gnu::always_inline]] inline bool ProxyPieces::fill(std::span<const double> x,
                                                     std::span<double> result) const {
  bool all = true;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::uint64_t cell = (std::bit_cast<std::uint64_t>(x[i]) >> kept_bits) - first_cell_;
    const std::uint32_t piece = cell < piece_of_cell_.size() ? piece_of_cell_[cell] : 0;
    result[i] = value_in<Arithmetic>(pieces_[piece], x[i]);
    all &= result[i] == result[i];
  }
  return all;
}

[[gnu::target("fma")]] bool ProxyPieces::fill_fused(std::span<const double> x,
                                                    std::span<double> result) const {
  return fill<scalar::Fused>(x, result);
}

bool ProxyPieces::values(std::span<const double> x, std::span<double> result) const {
  if (pieces_.empty()) {
    std::fill(result.begin(), result.end(), std::numeric_limits<double>::quiet_NaN());
    return x.empty();
  }
  if (detail::has_fma()) return fill_fused(x, result);
  return fill<scalar::Unfused>(x, result);
}

}  // namespace tribo
