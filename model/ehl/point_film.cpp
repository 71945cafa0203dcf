// SPDX-License-Identifier: Apache-2.0
#include "ehl/point_film.hpp"

#include <Eigen/SparseLU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "ehl/far_inlet.hpp"
#include "ehl/film_newton.hpp"
#include "ehl/grid.hpp"
#include "ehl/plane_kernel.hpp"
#include "ehl/point_reynolds.hpp"

namespace tribo::ehl {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Factors = Eigen::SparseLU<Eigen::SparseMatrix<double>>;

constexpr NewtonLimits limits{.steps = 40, .change = 1e-6};
constexpr double gmres_residual = 1e-3;  // relative: the next step removes what is left
constexpr int most_gmres_steps = 80;

// Parts that all steps on a grid share.
struct PointProblemParts {
  PointContact contact;
  PointNumbers numbers = numbers_of(contact);
  PlaneGrid grid;
  PlaneKernel kernel{grid};
  FarInlet inlet{contact};
  VectorXd areas, gap;  // of the nodes; the gap of the bodies before they flatten
};

// The linear equations of a step, for the changes of all pressures and, last, of H₀: matrix and
// preconditioner of GMRES.
class PointEquations {
 public:
  PointEquations(const PointProblemParts& parts, std::vector<PlaneSlopes> slopes,
                 std::vector<char> is_free, std::shared_ptr<Factors> factors)
      : parts_(parts),
        slopes_(std::move(slopes)),
        is_free_(std::move(is_free)),
        factors_(std::move(factors)),
        by_separation_(VectorXd::Zero(parts.grid.size())) {
    is_factored_ = factor();
    if (!is_factored_) return;
    by_separation_solved_ = factors_->solve(by_separation_);
    load_by_separation_ = -parts_.areas.dot(by_separation_solved_);
  }

  bool is_free(Index node) const { return is_free_[static_cast<std::size_t>(node)] != 0; }

  VectorXd operator*(const VectorXd& change) const {
    const PlaneGrid& grid = parts_.grid;
    const Index last = grid.size();
    VectorXd film = parts_.numbers.deflection * (parts_.kernel * change.head(last));
    film.array() += change[last];
    VectorXd result(last + 1);
    for (Index row = 0; row < last; ++row) {
      result[row] = is_free(row) ? 0 : change[row];
      if (!is_free(row)) continue;
      const PlaneSlopes& slopes = slopes_[static_cast<std::size_t>(row)];
      const auto nodes = stencil(grid, row);
      for (std::size_t k = 0; k < nodes.size(); ++k)
        if (nodes[k] >= 0)
          result[row] +=
              slopes.by_film[k] * film[nodes[k]] + slopes.by_pressure[k] * change[nodes[k]];
    }
    result[last] = parts_.areas.dot(change.head(last));
    return result;
  }

  // The preconditioner. Not finite where the matrix could not be factored.
  VectorXd solve(const VectorXd& side) const {
    const Index last = parts_.grid.size();
    if (!is_factored_)
      return VectorXd::Constant(last + 1, std::numeric_limits<double>::quiet_NaN());
    const VectorXd pressure = factors_->solve(side.head(last));
    VectorXd result(last + 1);
    result[last] = (side[last] - parts_.areas.dot(pressure)) / load_by_separation_;
    result.head(last) = pressure - result[last] * by_separation_solved_;
    return result;
  }

 private:
  // The nodes of PlaneSlopes around a node; −1: there is none.
  static std::array<Index, 6> stencil(const PlaneGrid& grid, Index row) {
    const Index across = grid.count_x();
    const Index i = row % across;
    return {i < 2 ? -1 : row - 2, row - 1, row, row + 1, row < across ? row + across : row - across,
            row + across};
  }

  // The matrix has the same places in all steps on a grid, so that they are ordered once. Returns
  // false where it could not be factored.
  bool factor() {
    const PlaneGrid& grid = parts_.grid;
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(6 * slopes_.size());
    for (int j = 0; j < grid.count_y(); ++j)
      for (int i = 0; i < grid.count_x(); ++i) {
        const Index row = grid.node(i, j);
        const auto place = static_cast<int>(row);
        if (!grid.is_inside(i, j)) {
          entries.emplace_back(place, place, 1);
          continue;
        }
        const PlaneSlopes& slopes = slopes_[static_cast<std::size_t>(row)];
        const auto nodes = stencil(grid, row);
        for (std::size_t k = 0; k < nodes.size(); ++k) {
          if (nodes[k] < 0) continue;
          const double own = parts_.numbers.deflection *
                             parts_.kernel.own(static_cast<int>(nodes[k] / grid.count_x()));
          const double value = slopes.by_pressure[k] + slopes.by_film[k] * own;
          const double held = nodes[k] == row ? 1 : 0;
          entries.emplace_back(place, static_cast<int>(nodes[k]), is_free(row) ? value : held);
          if (is_free(row)) by_separation_[row] += slopes.by_film[k];
        }
      }
    Eigen::SparseMatrix<double> matrix(grid.size(), grid.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    if (Eigen::Map<const VectorXd>(matrix.valuePtr(), matrix.nonZeros()).allFinite() == false)
      return false;
    if (factors_->rows() == 0) factors_->analyzePattern(matrix);
    factors_->factorize(matrix);
    return factors_->info() == Eigen::Success;
  }

  const PointProblemParts& parts_;
  std::vector<PlaneSlopes> slopes_;
  std::vector<char> is_free_;
  std::shared_ptr<Factors> factors_;
  bool is_factored_ = false;
  VectorXd by_separation_, by_separation_solved_;
  double load_by_separation_ = 0;  // the load that 1 of H₀ adds, by the preconditioner
};

// The solution of the equations to a relative residual, both seen through the preconditioner, from
// its own solution on. Source: Y. Saad, M. H. Schultz: GMRES. SIAM J. Sci. Stat. Comput. 7 (1986)
// 856.
VectorXd solved_by_gmres(const PointEquations& equations, const VectorXd& side) {
  VectorXd solution = equations.solve(side);
  VectorXd residual = equations.solve(side - equations * solution);
  const double size = residual.norm();
  if (!(size > 0)) return solution;
  std::vector<VectorXd> basis{residual / size};
  // Column by column, turned so that only the upper triangle is left; the right side in `turned`.
  std::vector<VectorXd> columns;
  std::vector<Eigen::JacobiRotation<double>> turns;
  std::vector<double> turned{size};
  while (std::fabs(turned.back()) > gmres_residual * size &&
         static_cast<int>(columns.size()) < most_gmres_steps) {
    const std::size_t k = columns.size();
    VectorXd next = equations.solve(equations * basis[k]);
    VectorXd column(static_cast<Index>(k) + 2);
    for (std::size_t i = 0; i <= k; ++i) {
      column[static_cast<Index>(i)] = basis[i].dot(next);
      next -= column[static_cast<Index>(i)] * basis[i];
    }
    const auto last = static_cast<Index>(k);
    column[last + 1] = next.norm();
    if (!std::isfinite(column[last + 1])) break;
    basis.emplace_back(next / column[last + 1]);
    for (Index i = 0; i < last; ++i)
      column.applyOnTheLeft(i, i + 1, turns[static_cast<std::size_t>(i)].adjoint());
    Eigen::JacobiRotation<double>& turn = turns.emplace_back();
    turn.makeGivens(column[last], column[last + 1]);
    column.applyOnTheLeft(last, last + 1, turn.adjoint());
    Eigen::Vector2d rest(turned[k], 0);
    rest.applyOnTheLeft(0, 1, turn.adjoint());
    turned[k] = rest[0];
    turned.push_back(rest[1]);
    columns.push_back(std::move(column));
  }
  for (std::size_t k = columns.size(); k-- > 0;) {
    const double share = turned[k] / columns[k][static_cast<Index>(k)];
    for (std::size_t i = 0; i < k; ++i) turned[i] -= share * columns[k][static_cast<Index>(i)];
    solution += share * basis[k];
  }
  return solution;
}

// FilmNewton's problem.
class PointProblem {
 public:
  struct Linear {
    PlaneBalance balance;
    PointEquations equations;
  };

  PointProblem(const PointContact& contact, const PlaneGrid& grid)
      : parts_{.contact = contact, .grid = grid, .areas = {}, .gap = {}},
        own_film_(parts_.numbers.deflection * film_of_rectangle(0, 0, grid.dx, grid.dy)),
        reach_(reach_of(contact)) {
    parts_.areas = parts_.gap = VectorXd(grid.size());
    for (int j = 0; j < grid.count_y(); ++j)
      for (int i = 0; i < grid.count_x(); ++i) {
        const double x = grid.x(i), y = grid.y(j);
        parts_.areas[grid.node(i, j)] = grid.area(j);
        parts_.gap[grid.node(i, j)] = x * x / 2 + y * y / (2 * contact.radius_ratio);
      }
  }

  int cells() const { return parts_.grid.count_x() - 1; }
  double reach() const { return reach_; }
  double pressure() const { return 1 / (reach_ * reach_); }
  double pressure_in_time() const { return pressure(); }
  double separation_weight() const { return pressure() * pressure(); }
  double size_of(const FilmChange& change) const {
    const double separation = separation_weight() * change.separation;
    return std::sqrt(parts_.areas.dot(change.pressure.cwiseAbs2()) + separation * separation);
  }

  double size_asked(const Linear& linear, const FilmState& at, const FilmChange&) const {
    return size_of(change_of(linear.equations.solve(side_of(linear, at, linear.balance, 0))));
  }

  FilmState state_of(VectorXd pressure, double separation) const {
    FilmState state{std::move(pressure), {}, separation};
    state.film = parts_.numbers.deflection * (parts_.kernel * state.pressure) + parts_.gap;
    state.film.array() += separation;
    return state;
  }

  // Where the rate is above 0, liquid is stored in the film that a step in time adds: ∂(ρ̄H)/∂T.
  Linear linear_at(const FilmState& at, double rate) const {
    const PlaneGrid& grid = parts_.grid;
    PlaneBalance balance = balance_of(parts_.contact, grid, at.pressure, at.film, true);
    std::vector<char> free(static_cast<std::size_t>(grid.size()), 0);
    for (int j = 0; j < grid.count_y(); ++j)
      for (int i = 0; i < grid.count_x(); ++i) {
        const Index node = grid.node(i, j);
        const auto place = static_cast<std::size_t>(node);
        if (!grid.is_inside(i, j) || !is_free(at, balance, node, own_part(balance, node, rate)))
          continue;
        free[place] = 1;
        const double stored = rate * grid.dx, pressure = at.pressure[node];
        balance.slopes[place].by_film[2] += stored * parts_.contact.fluid.density(pressure);
        balance.slopes[place].by_pressure[2] +=
            stored * parts_.contact.fluid.density_slope(pressure) * at.film[node];
      }
    std::vector<PlaneSlopes> slopes = std::move(balance.slopes);
    return {std::move(balance), {parts_, std::move(slopes), std::move(free), factors_}};
  }

  FilmChange change_for(const Linear& linear, const FilmState& at, double rate) const {
    const VectorXd side = side_of(linear, at, linear.balance, rate);
    return change_of(solved_by_gmres(linear.equations, side));
  }

  FilmChange change_left(const Linear& linear, const FilmState& at) const {
    const PlaneBalance balance =
        balance_of(parts_.contact, parts_.grid, at.pressure, at.film, false);
    return change_of(linear.equations.solve(side_of(linear, at, balance, 0)));
  }

 private:
  FilmChange change_of(const VectorXd& solution) const {
    return {solution.head(parts_.grid.size()), solution[parts_.grid.size()]};
  }

  // How much the pressure at a node changes the balance there: it drives liquid, and it lifts the
  // film.
  double own_part(const PlaneBalance& balance, Index node, double rate) const {
    return balance.diffusion[node] + (1.5 + rate * parts_.grid.dx) * own_film_;
  }

  // A node is free if a Newton step of this node alone would leave pressure there.
  static bool is_free(const FilmState& at, const PlaneBalance& balance, Index node, double own) {
    return at.pressure[node] > balance.surplus[node] / own;
  }

  // The residual of each equation at a state: at the grid's ends the pressure of the far inlet,
  // where the film has broken the pressure 0, else the balance; last the load.
  VectorXd side_of(const Linear& linear, const FilmState& at, const PlaneBalance& balance,
                   double rate) const {
    const PlaneGrid& grid = parts_.grid;
    VectorXd side(grid.size() + 1);
    for (int j = 0; j < grid.count_y(); ++j)
      for (int i = 0; i < grid.count_x(); ++i) {
        const Index node = grid.node(i, j);
        if (!grid.is_inside(i, j)) {
          const bool is_outlet = i + 1 == grid.count_x();
          side[node] =
              (is_outlet ? 0 : parts_.inlet.pressure(grid.x(i), grid.y(j), at.film[node])) -
              at.pressure[node];
          continue;
        }
        const double own = own_part(balance, node, rate);
        const bool is_row_of_balance = linear.equations.is_free(node);
        if (is_free(at, balance, node, own))
          side[node] = -balance.surplus[node] / (is_row_of_balance ? 1 : own);
        else
          side[node] = -at.pressure[node] * (is_row_of_balance ? own : 1);
      }
    side[grid.size()] = parts_.numbers.load - parts_.inlet.load_outside(grid, at.separation) -
                        parts_.areas.dot(at.pressure);
    return side;
  }

  PointProblemParts parts_;
  double own_film_;  // of a node by 1 of its own pressure
  double reach_;
  std::shared_ptr<Factors> factors_ = std::make_shared<Factors>();
};

PointFilm film_of(const FilmNewton<PointProblem>& newton, const PlaneGrid& grid, int steps_before) {
  return {.outcome = newton.outcome(),
          .grid = grid,
          .pressure = newton.state().pressure,
          .film = newton.state().film,
          .separation = newton.state().separation,
          .steps = steps_before + newton.steps(),
          .last_change = newton.last_change()};
}

// The pressure of a film at the nodes of another grid, by cubics along X and then along Y.
VectorXd pressure_on(const PlaneGrid& grid, const PointFilm& film) {
  const PlaneGrid& from = film.grid;
  const auto places = [](int count, auto place) {
    Numbers all(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) all[static_cast<std::size_t>(i)] = place(i);
    return all;
  };
  const auto within = [](Numbers to, const Numbers& of) {
    for (double& one : to) one = std::clamp(one, of.front(), of.back());
    return to;
  };
  const Numbers from_x = places(from.count_x(), [&](int i) { return from.x(i); }),
                from_y = places(from.count_y(), [&](int j) { return from.y(j); }),
                to_x = within(places(grid.count_x(), [&](int i) { return grid.x(i); }), from_x),
                to_y = within(places(grid.count_y(), [&](int j) { return grid.y(j); }), from_y);
  Eigen::MatrixXd rows(grid.count_x(), from.count_y());
  for (int j = 0; j < from.count_y(); ++j) {
    const Numbers row =
        interpolated(from_x, {film.pressure.data() + from.node(0, j), from_x.size()}, to_x);
    rows.col(j) = Eigen::Map<const VectorXd>(row.data(), grid.count_x());
  }
  VectorXd pressure(grid.size());
  Numbers column(from_y.size());
  for (int i = 0; i < grid.count_x(); ++i) {
    for (int j = 0; j < from.count_y(); ++j) column[static_cast<std::size_t>(j)] = rows(i, j);
    const Numbers values = interpolated(from_y, column, to_y);
    for (int j = 0; j < grid.count_y(); ++j)
      pressure[grid.node(i, j)] = std::fmax(0, values[static_cast<std::size_t>(j)]);
  }
  return pressure;
}

}  // namespace

double expected_film(const PointContact& contact) {
  // The circle's limits, rounded: rigid (solved), elastic, and elastic in a liquid that pressure
  // thickens, by G. Nijenbanning, C. H. Venner, H. Moes: Wear 176 (1994) 217. Only a start.
  const double m = contact.load_number, l = contact.material_number;
  const double rigid = 45 / (m * m), elastic = 3.2 * std::pow(m, -2. / 15),
               thickened = 1.25 * std::pow(m, -1. / 12) * std::pow(l, 0.75);
  return std::max({std::fmin(rigid, elastic), thickened}) / numbers_of(contact).film_number;
}

double reach_of(const PointContact& contact) {
  return std::fmax(1, std::sqrt(2 * expected_film(contact)));
}

PointFilm solve_from_nothing(const PointContact& contact, const PlaneGrid& grid,
                             const Watch& watch) {
  const PointProblem problem(contact, grid);
  const double k = numbers_of(contact).ellipticity, reach = reach_of(contact);
  VectorXd guess(grid.size());
  for (int j = 0; j < grid.count_y(); ++j)
    for (int i = 0; i < grid.count_x(); ++i) {
      const double x = grid.x(i) / reach, y = grid.y(j) / (k * reach);
      guess[grid.node(i, j)] = std::sqrt(std::fmax(0, 1 - x * x - y * y)) / (reach * reach);
    }
  FilmNewton<PointProblem> newton(problem, guess, 0);
  newton.lift_to(expected_film(contact));
  newton.settle(limits, watch);
  return film_of(newton, grid, 0);
}

PointFilm solve_on(const PointContact& contact, const PlaneGrid& grid, const PointFilm& film,
                   const Watch& watch) {
  const PointProblem problem(contact, grid);
  FilmNewton<PointProblem> newton(problem, pressure_on(grid, film), film.separation);
  // Between the nodes of a coarse grid the pressure may lift the film too little.
  const double least = film.film.minCoeff() / 2;
  if (newton.state().film.minCoeff() < least) newton.lift_to(least);
  newton.converge_or_settle(limits, watch);
  return film_of(newton, grid, film.steps);
}

}  // namespace tribo::ehl
