// SPDX-License-Identifier: Apache-2.0
#include "contenders/textbook_point_film.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "contenders/dense_line_film.hpp"

namespace tribo::benchmarks {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// The offsets (i, j) of the nodes of ehl::PlaneSlopes from the node itself.
constexpr std::array<std::array<int, 2>, 6> stencil{
    {{-2, 0}, {-1, 0}, {0, 0}, {1, 0}, {0, -1}, {0, 1}}};

// Relaxation makes `change_part` of each change that a line's equations give, and lowers H₀ by
// `load_part` times the relative missing load. A line's matrix has `band` diagonals on each side of
// the main one.
constexpr double change_part = 0.4, load_part = 0.05;
constexpr int band = 3;

// The node at (i, j). For j < 0 its mirror image in Y = 0. −1 for an i outside the grid.
Index node_at(const ehl::PlaneGrid& grid, int i, int j) {
  return i < 0 || i >= grid.count_x() ? -1 : grid.node(i, std::abs(j));
}

}  // namespace

TextbookPointFilm::TextbookPointFilm(const ehl::PointContact& contact, const ehl::PlaneGrid& grid)
    : contact_(contact),
      numbers_(ehl::numbers_of(contact)),
      transform_(grid),
      inlet_(contact),
      areas_(grid.size()),
      gap_(grid.size()) {
  now_.grid = grid;
  for (int j = 0; j < grid.count_y(); ++j)
    for (int i = 0; i < grid.count_x(); ++i) {
      const double x = grid.x(i), y = grid.y(j);
      areas_[grid.node(i, j)] = grid.area(j);
      gap_[grid.node(i, j)] = x * x / 2 + y * y / (2 * contact.radius_ratio);
    }
}

void TextbookPointFilm::start_from(const ehl::PointFilm& film) {
  now_.pressure = ehl::pressure_on(now_.grid, film);
  now_.separation = film.separation;
  now_.film = film_of(now_.pressure, now_.separation);
  now_.steps = film.steps;
}

VectorXd TextbookPointFilm::film_of(const VectorXd& pressure, double separation) const {
  VectorXd film = numbers_.deflection * (transform_ * pressure) + gap_;
  film.array() += separation;
  return film;
}

double TextbookPointFilm::missing_load(const VectorXd& pressure, double separation) const {
  return numbers_.load - areas_.dot(pressure) - inlet_.load_outside(now_.grid, separation);
}

// A node is free if a change of its own pressure that balances its equation would leave the
// pressure above 0.
bool TextbookPointFilm::is_free(const ehl::PlaneBalance& balance, Index node) const {
  const double own = numbers_.deflection * ehl::film_of_rectangle(0, 0, now_.grid.dx, now_.grid.dy);
  return now_.pressure[node] > balance.surplus[node] / (balance.diffusion[node] + 1.5 * own);
}

void TextbookPointFilm::fill_kernel() {
  if (kernel_.size() > 0) return;
  const ehl::PlaneGrid& grid = now_.grid;
  const int nx = grid.count_x(), ny = grid.count_y();
  Eigen::MatrixXd by_distance(nx, 2 * ny);
  for (int j = 0; j < 2 * ny; ++j)
    for (int i = 0; i < nx; ++i)
      by_distance(i, j) =
          numbers_.deflection * ehl::film_of_rectangle(i * grid.dx, j * grid.dy, grid.dx, grid.dy);
  kernel_.resize(grid.size(), grid.size());
  for (Index of = 0; of < grid.size(); ++of)
    for (Index at = 0; at < grid.size(); ++at) {
      const Index across = std::abs(at % nx - of % nx), to = at / nx, from = of / nx;
      kernel_(at, of) = by_distance(across, std::abs(to - from)) +
                        (from > 0 ? by_distance(across, to + from) : 0);
    }
  jacobian_.resize(grid.size(), grid.size());
}

double TextbookPointFilm::newton_step() {
  const ehl::PlaneGrid& grid = now_.grid;
  const Index size = grid.size();
  fill_kernel();
  const ehl::PlaneBalance balance =
      ehl::balance_of(contact_, grid, now_.pressure, now_.film, {}, true);
  Eigen::MatrixXd sides = Eigen::MatrixXd::Zero(size, 2);
  for (int j = 0; j < grid.count_y(); ++j)
    for (int i = 0; i < grid.count_x(); ++i) {
      const Index row = grid.node(i, j);
      jacobian_.row(row).setZero();
      if (!grid.is_inside(i, j) || !is_free(balance, row)) {
        const bool is_inlet = !grid.is_inside(i, j) && i + 1 < grid.count_x();
        jacobian_(row, row) = 1;
        sides(row, 0) = (is_inlet ? inlet_.pressure(grid.x(i), grid.y(j), now_.film[row]) : 0) -
                        now_.pressure[row];
        continue;
      }
      const ehl::PlaneSlopes& slopes = balance.slopes[static_cast<std::size_t>(row)];
      sides(row, 0) = -balance.surplus[row];
      for (std::size_t k = 0; k < stencil.size(); ++k) {
        const Index node = node_at(grid, i + stencil[k][0], j + stencil[k][1]);
        if (node < 0) continue;
        jacobian_.row(row) += slopes.by_film[k] * kernel_.row(node);
        jacobian_(row, node) += slopes.by_pressure[k];
        sides(row, 1) += slopes.by_film[k];
      }
    }
  const Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXd>> factored(jacobian_);
  sides = factored.solve(sides).eval();
  const double rise = -(missing_load(now_.pressure, now_.separation) - areas_.dot(sides.col(0))) /
                      areas_.dot(sides.col(1));
  return damped_step(
      now_, sides.col(0) - rise * sides.col(1), rise,
      [&](const VectorXd& pressure, double separation) { return film_of(pressure, separation); });
}

ehl::PointFilm TextbookPointFilm::newton() {
  now_.outcome = ehl::Outcome::not_converged;
  for (int made = 0; made < 40 && now_.outcome != ehl::Outcome::solved; ++made) {
    const double change = newton_step();
    if (!std::isfinite(change)) break;
    if (change < 1e-6) now_.outcome = ehl::Outcome::solved;
  }
  return now_;
}

std::size_t TextbookPointFilm::newton_bytes() const {
  return static_cast<std::size_t>(kernel_.size() + jacobian_.size()) * sizeof(double);
}

double TextbookPointFilm::relax_line(const ehl::PlaneBalance& balance, int j, VectorXd& made) {
  const ehl::PlaneGrid& grid = now_.grid;
  const int count = grid.count_x();
  const auto influence = [&](int across, int along) {
    return numbers_.deflection *
           ehl::film_of_rectangle(across * grid.dx, along * grid.dy, grid.dx, grid.dy);
  };
  // The changes of film and pressure at a distance from a node whose pressure changes by 1. If the
  // change is shared, each of its four neighbours changes by −1/4.
  const auto film_at = [&](int across, int along, bool is_shared) {
    const double own = influence(across, along);
    return !is_shared ? own
                      : own - (influence(across - 1, along) + influence(across + 1, along) +
                               influence(across, along - 1) + influence(across, along + 1)) /
                                  4;
  };
  const auto pressure_at = [](int across, int along, bool is_shared) {
    const int distance = std::abs(across) + std::abs(along);
    return distance == 0 ? 1. : distance == 1 && is_shared ? -0.25 : 0.;
  };
  constexpr int reach = band + 2;
  std::array<std::array<std::array<double, 2 * reach + 1>, 2>, 2> films{};
  for (int shared = 0; shared < 2; ++shared)
    for (int along = 0; along < 2; ++along)
      for (int across = -reach; across <= reach; ++across)
        films[static_cast<std::size_t>(shared)][static_cast<std::size_t>(along)]
             [static_cast<std::size_t>(across + reach)] = film_at(across, along, shared == 1);

  std::vector<char> is_shared(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    is_shared[static_cast<std::size_t>(i)] =
        balance.diffusion[grid.node(i, j)] < 4 * influence(0, 0) ? 1 : 0;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count, 2 * band + 1);
  VectorXd side = VectorXd::Zero(count);
  matrix.col(band).setOnes();
  for (int i = 1; i + 1 < count; ++i) {
    const Index row = grid.node(i, j);
    if (!is_free(balance, row)) {
      side[i] = -now_.pressure[row];
      continue;
    }
    const ehl::PlaneSlopes& slopes = balance.slopes[static_cast<std::size_t>(row)];
    side[i] = -balance.surplus[row];
    matrix.row(i).setZero();
    for (std::size_t s = 0; s < stencil.size(); ++s) {
      const auto [across, along] = stencil[s];
      const Index node = node_at(grid, i + across, j + along);
      if (node < 0) continue;
      side[i] -= slopes.by_pressure[s] * made[node];
      for (int k = std::max(1, i - band); k <= std::min(count - 2, i + band); ++k) {
        const auto shared = static_cast<std::size_t>(is_shared[static_cast<std::size_t>(k)]);
        const int off = i + across - k;
        matrix(i, k - i + band) +=
            slopes.by_pressure[s] * pressure_at(off, along, shared == 1) +
            slopes.by_film[s] *
                films[shared][static_cast<std::size_t>(std::abs(along))]
                     [static_cast<std::size_t>(std::clamp(off, -reach, reach) + reach)];
      }
    }
  }
  for (int i = 0; i < count; ++i)  // elimination in the band
    for (int below = i + 1; below <= std::min(count - 1, i + band); ++below) {
      const double factor = matrix(below, i - below + band) / matrix(i, band);
      if (factor == 0) continue;
      for (int k = i; k <= std::min(count - 1, i + band); ++k)
        matrix(below, k - below + band) -= factor * matrix(i, k - i + band);
      side[below] -= factor * side[i];
    }
  for (int i = count; i-- > 0;) {
    for (int k = i + 1; k <= std::min(count - 1, i + band); ++k)
      side[i] -= matrix(i, k - i + band) * side[k];
    side[i] /= matrix(i, band);
  }
  const auto change = [&](int i, int to, double by) {
    if (!grid.is_inside(i, std::abs(to))) return;
    double& pressure = now_.pressure[node_at(grid, i, to)];
    const double before = pressure;
    pressure = std::fmax(0, pressure + by);
    made[node_at(grid, i, to)] += pressure - before;
  };
  for (int i = 1; i + 1 < count; ++i) {
    const double by = change_part * std::clamp(side[i], -0.5, 0.5);
    change(i, j, by);
    if (is_shared[static_cast<std::size_t>(i)] == 0 || !is_free(balance, grid.node(i, j))) continue;
    change(i - 1, j, -by / 4);
    change(i + 1, j, -by / 4);
    change(i, j + 1, -by / 4);
    if (j > 0) change(i, j - 1, j == 1 ? -by / 2 : -by / 4);
  }
  return side.allFinite() ? 0 : std::numeric_limits<double>::quiet_NaN();
}

ehl::PointFilm TextbookPointFilm::relaxed(int most_sweeps) {
  const ehl::PlaneGrid& grid = now_.grid;
  now_.outcome = ehl::Outcome::not_converged;
  now_.steps = 0;
  while (now_.steps < most_sweeps) {
    ++now_.steps;
    const ehl::PlaneBalance balance =
        ehl::balance_of(contact_, grid, now_.pressure, now_.film, {}, true);
    VectorXd made = VectorXd::Zero(grid.size());
    double fault = 0;
    for (int j = 0; j + 1 < grid.count_y(); ++j) fault += relax_line(balance, j, made);
    for (int j = 0; j < grid.count_y(); ++j)
      for (int i = 0; i + 1 < grid.count_x(); ++i)
        if (!grid.is_inside(i, j))
          now_.pressure[grid.node(i, j)] =
              inlet_.pressure(grid.x(i), grid.y(j), now_.film[grid.node(i, j)]);
    const double missing = missing_load(now_.pressure, now_.separation) / numbers_.load;
    now_.separation -= load_part * missing;
    now_.film = film_of(now_.pressure, now_.separation);
    now_.last_change = areas_.dot(made.cwiseAbs()) / numbers_.load;
    if (!std::isfinite(fault + now_.last_change) || !(now_.film.minCoeff() > 0)) break;
    if (now_.last_change < 1e-6 && std::fabs(missing) < 1e-5) {
      now_.outcome = ehl::Outcome::solved;
      break;
    }
  }
  return now_;
}

}  // namespace tribo::benchmarks
