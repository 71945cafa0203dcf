// SPDX-License-Identifier: Apache-2.0
#include "ehl/point_film.hpp"

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
#include "ehl/plane_factors.hpp"
#include "ehl/plane_kernel.hpp"
#include "ehl/point_reynolds.hpp"

namespace tribo::ehl {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

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

// The unknown of a node, and its equation. held: the pressure is that of the far inlet, or 0.
// pressure: it follows from the balance. missing: in a gap that is filled in part, the liquid that
// is missing there follows from the balance.
enum class Unknown : char { held, pressure, missing };

// The linear equations of a step, for the changes of all unknowns and, last, of H₀: matrix and
// preconditioner of GMRES.
class PointEquations {
 public:
  PointEquations(const PointProblemParts& parts, std::vector<PlaneSlopes> slopes,
                 std::vector<Unknown> unknowns, std::shared_ptr<PlaneFactors> factors)
      : parts_(parts),
        slopes_(std::move(slopes)),
        unknowns_(std::move(unknowns)),
        factors_(std::move(factors)),
        by_separation_(VectorXd::Zero(parts.grid.size())) {
    is_factored_ = factor();
    if (!is_factored_) return;
    by_separation_solved_ = factors_->solve(by_separation_);
    load_by_separation_ = -parts_.areas.dot(pressure_of(by_separation_solved_));
  }

  Unknown unknown(Index node) const { return unknowns_[static_cast<std::size_t>(node)]; }
  bool is_held(Index node) const { return unknown(node) == Unknown::held; }
  // The pressures in a solution, and the missing liquid in it; both are 0 at the other nodes.
  VectorXd pressure_of(const VectorXd& solution) const {
    return part_of(solution, [](Unknown unknown) { return unknown != Unknown::missing; });
  }
  VectorXd missing_of(const VectorXd& solution) const {
    return part_of(solution, [](Unknown unknown) { return unknown == Unknown::missing; });
  }

  VectorXd operator*(const VectorXd& change) const {
    const Index last = parts_.grid.size();
    VectorXd result = residual_change({pressure_of(change), change[last], missing_of(change)});
    for (Index row = 0; row < last; ++row)
      if (is_held(row)) result[row] = change[row];
    return result;
  }

  // A change adds these to the balances (0 where the pressure is held) and, last, to the load.
  VectorXd residual_change(const FilmChange& change) const {
    const PlaneGrid& grid = parts_.grid;
    const Index last = grid.size();
    VectorXd film = parts_.numbers.deflection * (parts_.kernel * change.pressure);
    film.array() += change.separation;
    VectorXd result = VectorXd::Zero(last + 1);
    for (Index row = 0; row < last; ++row) {
      if (is_held(row)) continue;
      const PlaneSlopes& slopes = slopes_[static_cast<std::size_t>(row)];
      const auto nodes = stencil(grid, row);
      for (std::size_t k = 0; k < nodes.size(); ++k)
        if (nodes[k] >= 0)
          result[row] += slopes.by_film[k] * film[nodes[k]] +
                         slopes.by_pressure[k] * change.pressure[nodes[k]];
      if (!parts_.contact.is_starved()) continue;
      for (const std::size_t k : {before, itself})
        if (nodes[k] >= 0) result[row] += by_missing(k) * change.missing[nodes[k]];
    }
    result[last] = parts_.areas.dot(change.pressure);
    return result;
  }

  // The preconditioner. Not finite where the matrix could not be factored.
  VectorXd solve(const VectorXd& side) const {
    const Index last = parts_.grid.size();
    if (!is_factored_)
      return VectorXd::Constant(last + 1, std::numeric_limits<double>::quiet_NaN());
    const VectorXd nodes = factors_->solve(side.head(last));
    VectorXd result(last + 1);
    result[last] = (side[last] - parts_.areas.dot(pressure_of(nodes))) / load_by_separation_;
    result.head(last) = nodes - result[last] * by_separation_solved_;
    return result;
  }

 private:
  template <class Kind>
  VectorXd part_of(const VectorXd& solution, const Kind& is_in) const {
    VectorXd part = solution.head(parts_.grid.size());
    for (Index node = 0; node < part.size(); ++node)
      if (!is_in(unknown(node))) part[node] = 0;
    return part;
  }

  // Places in PlaneSlopes. Liquid missing at a node is missing in the flow out of it; liquid
  // missing at the node before is missing in the flow into it.
  static constexpr std::size_t before = 1, itself = 2;
  static double by_missing(std::size_t k) { return k == before ? 1 : -1; }

  // The nodes of PlaneSlopes around a node; −1: there is none.
  static std::array<Index, 6> stencil(const PlaneGrid& grid, Index row) {
    const Index across = grid.count_x();
    const Index i = row % across;
    return {i < 2 ? -1 : row - 2,
            i < 1 ? -1 : row - 1,
            row,
            row + 1,
            row < across ? row + across : row - across,
            row + across};
  }

  // Returns false where the matrix could not be factored.
  bool factor() {
    const PlaneGrid& grid = parts_.grid;
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(6 * slopes_.size());
    for (int j = 0; j < grid.count_y(); ++j)
      for (int i = 0; i < grid.count_x(); ++i) {
        const Index row = grid.node(i, j);
        const auto place = static_cast<int>(row);
        if (!grid.is_inside(i, j) && is_held(row)) {
          entries.emplace_back(place, place, 1);
          continue;
        }
        const PlaneSlopes& slopes = slopes_[static_cast<std::size_t>(row)];
        const auto nodes = stencil(grid, row);
        for (std::size_t k = 0; k < nodes.size(); ++k) {
          if (nodes[k] < 0) continue;
          const double own = parts_.numbers.deflection *
                             parts_.kernel.own(static_cast<int>(nodes[k] / grid.count_x()));
          double value = slopes.by_pressure[k] + slopes.by_film[k] * own;
          if (unknown(nodes[k]) == Unknown::missing)
            value = k == before || k == itself ? by_missing(k) : 0;
          if (is_held(row)) value = nodes[k] == row ? 1 : 0;
          entries.emplace_back(place, static_cast<int>(nodes[k]), value);
          if (!is_held(row)) by_separation_[row] += slopes.by_film[k];
        }
      }
    return factors_->factor(std::move(entries));
  }

  const PointProblemParts& parts_;
  std::vector<PlaneSlopes> slopes_;
  std::vector<Unknown> unknowns_;
  std::shared_ptr<PlaneFactors> factors_;
  bool is_factored_ = false;
  VectorXd by_separation_, by_separation_solved_;
  double load_by_separation_ = 0;  // the load that 1 of H₀ adds, by the preconditioner
};

// Solves the equations by GMRES from the preconditioner's own solution, until the preconditioned
// residual is gmres_residual times the first one. Source: Y. Saad, M. H. Schultz: GMRES. SIAM J.
// Sci. Stat. Comput. 7 (1986) 856.
VectorXd solved_by_gmres(const PointEquations& equations, const VectorXd& side) {
  VectorXd solution = equations.solve(side);
  VectorXd residual = equations.solve(side - equations * solution);
  const double size = residual.norm();
  if (!(size > 0)) return solution;
  std::vector<VectorXd> basis{residual / size};
  // The Hessenberg matrix by columns, rotated so that only its upper triangle is left; its right
  // side is `turned`.
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
  // The meniscus of a starved contact moves by one layer of nodes a step. Until it rests, the
  // changes that are asked for need not become smaller.
  bool must_lead_nearer() const { return !parts_.contact.is_starved(); }
  double size_of(const FilmChange& change) const {
    const double separation = separation_weight() * change.separation;
    return std::sqrt(parts_.areas.dot(change.pressure.cwiseAbs2()) + separation * separation);
  }

  double size_asked(const Linear& linear, const FilmState& at, const FilmChange&) const {
    return size_of(change_asked(linear, at, linear.balance, 0, false));
  }

  FilmState state_of(VectorXd pressure, double separation) const {
    FilmState state = film_at(std::move(pressure), separation);
    if (!parts_.contact.is_starved()) return state;
    set_missing(state, VectorXd::Zero(parts_.grid.size()));
    return state;
  }

  FilmState state_after(const FilmState& state, double part, const FilmChange& change) const {
    VectorXd pressure = state.pressure + part * change.pressure;
    if (parts_.contact.is_starved()) empty_behind_suction(pressure);
    FilmState next = film_at(pressure.cwiseMax(0), state.separation + part * change.separation);
    if (parts_.contact.is_starved())
      set_missing(next, (state.missing + part * change.missing).cwiseMax(0));
    return next;
  }

  // Where the rate is above 0, liquid is stored in the film that a step in time adds: ∂(ρ̄H)/∂T.
  Linear linear_at(const FilmState& at, double rate) const {
    const PlaneGrid& grid = parts_.grid;
    PlaneBalance balance = balance_of(parts_.contact, grid, at.pressure, at.film, at.missing, true);
    std::vector<Unknown> unknowns(static_cast<std::size_t>(grid.size()), Unknown::held);
    const bool is_starved = parts_.contact.is_starved();
    for (int j = 0; j + 1 < grid.count_y(); ++j)
      for (int i = is_starved ? 0 : 1; i + 1 < grid.count_x(); ++i) {
        const Index node = grid.node(i, j);
        const auto place = static_cast<std::size_t>(node);
        const bool is_end = i == 0;
        if (!is_end && is_free(at, balance, node, rate))
          unknowns[place] = Unknown::pressure;
        else if (is_starved)
          unknowns[place] = Unknown::missing;
        if (unknowns[place] != Unknown::pressure) continue;
        const double stored = rate * grid.dx, pressure = at.pressure[node];
        balance.slopes[place].by_film[2] += stored * parts_.contact.fluid.density(pressure);
        balance.slopes[place].by_pressure[2] +=
            stored * parts_.contact.fluid.density_slope(pressure) * at.film[node];
      }
    std::vector<PlaneSlopes> slopes = std::move(balance.slopes);
    return {std::move(balance), {parts_, std::move(slopes), std::move(unknowns), factors_}};
  }

  FilmChange change_for(const Linear& linear, const FilmState& at, double rate) const {
    return change_asked(linear, at, linear.balance, rate, true);
  }

  FilmChange change_left(const Linear& linear, const FilmState& at) const {
    const PlaneBalance balance =
        balance_of(parts_.contact, parts_.grid, at.pressure, at.film, at.missing, false);
    return change_asked(linear, at, balance, 0, false);
  }

 private:
  // Sets the state's missing liquid: `missing` where P > 0; elsewhere what leaves no surplus there.
  void set_missing(FilmState& state, VectorXd missing) const {
    const VectorXd nothing = VectorXd::Zero(missing.size());
    state.missing = missing_in(
        parts_.grid, state.pressure,
        balance_of(parts_.contact, parts_.grid, state.pressure, state.film, nothing, false),
        std::move(missing));
  }

  // Where a step finds suction, the gap is no longer full. The nodes right behind are emptied too,
  // as long as their pressure is below the suction: a step alone empties only the next few.
  void empty_behind_suction(VectorXd& pressure) const {
    for (int j = 0; j < parts_.grid.count_y(); ++j) {
      double suction = 0;
      for (int i = 0; i < parts_.grid.count_x(); ++i) {
        double& here = pressure[parts_.grid.node(i, j)];
        suction = here < suction ? std::fmax(suction, -here) : 0;
        if (suction > 0) here = 0;
      }
    }
  }

  // The state of a full gap: its `missing` stays empty.
  FilmState film_at(VectorXd pressure, double separation) const {
    FilmState state{std::move(pressure), {}, separation};
    state.film = parts_.numbers.deflection * (parts_.kernel * state.pressure) + parts_.gap;
    state.film.array() += separation;
    return state;
  }

  // The change that removes a state's residual, by GMRES or by its preconditioner alone.
  FilmChange change_asked(const Linear& linear, const FilmState& at, const PlaneBalance& balance,
                          double rate, bool is_exact) const {
    const PointEquations& equations = linear.equations;
    VectorXd side = side_of(linear, at, balance, rate);
    FilmChange change{VectorXd::Zero(parts_.grid.size()), 0, {}};
    if (parts_.contact.is_starved()) {
      // Nodes whose unknown is missing liquid lose their pressure; the others get a full gap.
      change.missing = change.pressure;
      for (Index node = 0; node < parts_.grid.size(); ++node)
        if (equations.unknown(node) == Unknown::missing)
          change.pressure[node] = -at.pressure[node];
        else
          change.missing[node] = -at.missing[node];
      if (change.pressure.any() || change.missing.any()) side -= equations.residual_change(change);
    }
    const VectorXd solution = is_exact ? solved_by_gmres(equations, side) : equations.solve(side);
    change.pressure += equations.pressure_of(solution);
    change.separation = solution[parts_.grid.size()];
    if (parts_.contact.is_starved()) change.missing += equations.missing_of(solution);
    return change;
  }

  // How much the pressure at a node changes the balance there: it drives liquid, and it lifts the
  // film.
  double own_part(const PlaneBalance& balance, Index node, double rate) const {
    return balance.diffusion[node] + (1.5 + rate * parts_.grid.dx) * own_film_;
  }

  // A node is free if a Newton step of this node alone would leave pressure there.
  bool is_free(const FilmState& at, const PlaneBalance& balance, Index node, double rate) const {
    double surplus = balance.surplus[node];
    if (parts_.contact.is_starved()) surplus += at.missing[node];
    return at.pressure[node] > surplus / own_part(balance, node, rate);
  }

  // Minus the residual of each equation at a state. At the grid's ends the residual is that of the
  // far inlet's pressure, of 0 at dry ends, or of the balance where liquid is missing. Inside it is
  // the pressure where the film has broken, else the balance. The last is that of the load.
  VectorXd side_of(const Linear& linear, const FilmState& at, const PlaneBalance& balance,
                   double rate) const {
    const PlaneGrid& grid = parts_.grid;
    VectorXd side(grid.size() + 1);
    for (int j = 0; j < grid.count_y(); ++j)
      for (int i = 0; i < grid.count_x(); ++i) {
        const Index node = grid.node(i, j);
        if (linear.equations.unknown(node) == Unknown::missing && i == 0) {
          side[node] = -balance.surplus[node];
          continue;
        }
        if (!grid.is_inside(i, j)) {
          const bool is_dry = i + 1 == grid.count_x() || parts_.contact.is_starved();
          side[node] = (is_dry ? 0 : parts_.inlet.pressure(grid.x(i), grid.y(j), at.film[node])) -
                       at.pressure[node];
          continue;
        }
        const double own = own_part(balance, node, rate);
        const Unknown unknown = linear.equations.unknown(node);
        const bool is_row_of_balance = unknown != Unknown::held;
        if (unknown == Unknown::missing || is_free(at, balance, node, rate))
          side[node] = -balance.surplus[node] / (is_row_of_balance ? 1 : own);
        else
          side[node] = -at.pressure[node] * (is_row_of_balance ? own : 1);
      }
    side[grid.size()] = parts_.numbers.load - parts_.areas.dot(at.pressure);
    if (!parts_.contact.is_starved())
      side[grid.size()] -= parts_.inlet.load_outside(grid, at.separation);
    return side;
  }

  PointProblemParts parts_;
  double own_film_;  // of a node by 1 of its own pressure
  double reach_;
  std::shared_ptr<PlaneFactors> factors_ = std::make_shared<PlaneFactors>(parts_.grid);
};

PointFilm film_of(const FilmNewton<PointProblem>& newton, const PlaneGrid& grid, int steps_before) {
  return {.outcome = newton.outcome(),
          .grid = grid,
          .pressure = newton.state().pressure,
          .film = newton.state().film,
          .missing = newton.state().missing,
          .separation = newton.state().separation,
          .steps = steps_before + newton.steps(),
          .last_change = newton.last_change()};
}

}  // namespace

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

namespace {

PointFilm solve_flooded_from_nothing(const PointContact& contact, const PlaneGrid& grid,
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

// Newton's method may not lead from dry contact to the film of a liquid that pressure thickens
// strongly. Here it goes through liquids that pressure thickens more and more. Each starts from the
// film of the liquid before.
PointFilm solve_by_weaker_liquids(const PointContact& contact, const PlaneGrid& grid,
                                  const Watch& watch) {
  constexpr int liquids = 5;
  PointFilm film;
  for (int k = 1; k <= liquids; ++k) {
    PointContact weaker = contact;
    const double share = 0.5 + 0.5 * k / liquids;
    weaker.material_number *= share;
    weaker.fluid.exponent *= share;
    film = k == 1 ? solve_flooded_from_nothing(weaker, grid, watch)
                  : solve_on(weaker, grid, film, watch);
    if (film.outcome != Outcome::solved) break;
  }
  return film;
}

}  // namespace

PointFilm solve_from_nothing(const PointContact& contact, const PlaneGrid& grid,
                             const Watch& watch) {
  PointContact fuller = contact;
  fuller.inlet_film = std::numeric_limits<double>::infinity();
  PointFilm film = solve_flooded_from_nothing(fuller, grid, watch);
  if (film.outcome == Outcome::not_converged && contact.fluid.exponent > 0)
    film = solve_by_weaker_liquids(fuller, grid, watch);
  if (!contact.is_starved() || film.outcome != Outcome::solved) return film;
  // Where this layer cannot be solved at once, the way to it leads over 2, 4 or 8 thicker layers.
  PointFilm starved;
  for (const int layers : {0, 2, 4, 8}) {
    starved = film;
    for (int k = layers; k >= 0 && starved.outcome == Outcome::solved; --k) {
      fuller.inlet_film = contact.inlet_film * std::pow(2, k / 2.);
      starved = solve_on(fuller, grid, starved, watch);
    }
    if (starved.outcome != Outcome::not_converged) return starved;
    film.steps = starved.steps;
  }
  return starved;
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
