// SPDX-License-Identifier: Apache-2.0
#include "generators/point_elements.hpp"

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "generators/point_mesh.hpp"

namespace tribo::reference {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;
constexpr double even = 1.25, stretched = 0.35;  // of graded(), over the semi-axes
constexpr double rounding = 1e-5;                // of the penalty's corner at 0, in P(1 + gap²)
constexpr double most_change = 0.1;              // of P at a node, in a step

// Weights of the values at a node and both neighbours, at distances l and r, in the node's slope.
// They are of second order.
std::array<double, 3> slope_weights(double l, double r) {
  return {-r / (l * (l + r)), (r - l) / (l * r), l / (r * (l + r))};
}

struct State {
  VectorXd pressure;
  double separation;
};

class Equations {
 public:
  Equations(const ehl::PointContact& contact, const PointMesh& mesh, const ElementOptions& options)
      : contact_(contact),
        numbers_(ehl::numbers_of(contact)),
        mesh_(mesh),
        options_(options),
        deflection_(film_matrix(mesh)) {
    const Index count = mesh.size();
    std::vector<Eigen::Triplet<double>> near, gx, gy;
    const auto add = [](auto& list, Index row, Index column, double value) {
      list.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
    };
    gap_ = area_ = VectorXd::Zero(count);
    for (Index j = 0; j < mesh.ny(); ++j)
      for (Index i = 0; i < mesh.nx(); ++i) {
        const Index node = mesh.node(i, j);
        const double x = mesh.x[at(i)], y = mesh.y[at(j)];
        gap_[node] = x * x / 2 + y * y / (2 * contact.radius_ratio);
        if (mesh.is_end(i, j)) continue;
        const double l = x - mesh.x[at(i - 1)], r = mesh.x[at(i + 1)] - x,
                     b = j == 0 ? 0 : y - mesh.y[at(j - 1)], t = mesh.y[at(j + 1)] - y;
        area_[node] = (l + r) * (b + t) / 4;
        const auto wx = slope_weights(l, r);
        for (Index k = 0; k < 3; ++k) add(gx, node, node + k - 1, wx[at(k)]);
        if (j > 0) {
          const auto wy = slope_weights(b, t);
          for (Index k = 0; k < 3; ++k) add(gy, node, node + (k - 1) * mesh.nx(), wy[at(k)]);
        }
        for (Index n = std::max<Index>(0, j - 1); n <= j + 1; ++n)
          for (Index m = i - 1; m <= i + 1; ++m)
            add(near, node, mesh.node(m, n),
                numbers_.deflection * static_cast<double>(deflection_(node, mesh.node(m, n))));
      }
    near_.resize(count, count);
    near_.setFromTriplets(near.begin(), near.end());
    slope_x_.resize(count, count);
    slope_x_.setFromTriplets(gx.begin(), gx.end());
    slope_y_.resize(count, count);
    slope_y_.setFromTriplets(gy.begin(), gy.end());
  }

  VectorXd lift(const VectorXd& pressure) const {
    const Eigen::VectorXf p = pressure.cast<float>();
    return numbers_.deflection * (deflection_ * p).cast<double>();
  }
  VectorXd film(const State& s) const { return (gap_ + lift(s.pressure)).array() + s.separation; }
  double load_of(const VectorXd& p) const { return 2 * area_.dot(p); }

  bool solve(State& state, double tolerance, int& steps);
  void set_exponent(double exponent) { contact_.fluid.exponent = exponent; }

 private:
  struct Linear {
    VectorXd residual;
    Sparse by_pressure, by_film;
  };
  Linear linear_at(const State& state, const VectorXd& film) const;
  VectorXd gmres(const Linear& linear, const VectorXd& side, double tolerance) const;

  ehl::PointContact contact_;
  ehl::PointNumbers numbers_;
  const PointMesh& mesh_;
  ElementOptions options_;
  FilmMatrix deflection_;
  VectorXd gap_, area_, log_conductance_;
  Sparse near_, slope_x_, slope_y_;
};

Equations::Linear Equations::linear_at(const State& state, const VectorXd& film) const {
  const Index count = mesh_.size(), nx = mesh_.nx();
  const auto& fluid = contact_.fluid;
  VectorXd conductance(count), thick(count);  // thick: d ln η̄/dP
  for (Index n = 0; n < count; ++n) {
    const double p = std::fmax(state.pressure[n], 0), h = film[n];
    conductance[n] = h * h * h * std::exp(-fluid.log_viscosity(p)) / numbers_.wedge;
    thick[n] = state.pressure[n] > 0 ? fluid.log_viscosity_slope(p) : 0;
  }
  const VectorXd px = slope_x_ * state.pressure, py = slope_y_ * state.pressure;
  std::vector<Eigen::Triplet<double>> by_p, by_h, transport, along, across;
  VectorXd residual = VectorXd::Zero(count);
  const double g = 0.5 / std::sqrt(3.);
  for (Index j = 0; j + 1 < mesh_.ny(); ++j)
    for (Index i = 0; i + 1 < nx; ++i) {
      const double hx = mesh_.x[at(i + 1)] - mesh_.x[at(i)],
                   hy = mesh_.y[at(j + 1)] - mesh_.y[at(j)];
      const std::array<Index, 4> nodes{mesh_.node(i, j), mesh_.node(i + 1, j), mesh_.node(i, j + 1),
                                       mesh_.node(i + 1, j + 1)};
      double mean = 0;
      for (const Index n : nodes) mean += log_conductance_[n] / 4;
      const double peclet = numbers_.deflection * hx * hx / std::exp(mean);
      const double tau = hx / 2 * (peclet < 1e-3 ? peclet / 3 : 1 / std::tanh(peclet) - 1 / peclet);
      for (const double s : {0.5 - g, 0.5 + g})
        for (const double t : {0.5 - g, 0.5 + g}) {
          const double weight = hx * hy / 4;
          const std::array<double, 4> value{(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t},
              of_x{-(1 - t) / hx, (1 - t) / hx, -t / hx, t / hx},
              of_y{-(1 - s) / hy, -s / hy, (1 - s) / hy, s / hy};
          double p = 0, h = 0, dx = 0, dy = 0;
          for (std::size_t k = 0; k < 4; ++k) {
            p += value[k] * state.pressure[nodes[k]];
            h += value[k] * film[nodes[k]];
            dx += of_x[k] * state.pressure[nodes[k]];
            dy += of_y[k] * state.pressure[nodes[k]];
          }
          const double flow =
              h * h * h * std::exp(-fluid.log_viscosity(std::fmax(p, 0))) / numbers_.wedge;
          const double thicker = p > 0 ? fluid.log_viscosity_slope(p) : 0;
          for (std::size_t a = 0; a < 4; ++a) {
            const Index row = nodes[a];
            const double driven = weight * flow * (dx * of_x[a] + dy * of_y[a]);
            residual[row] += driven;
            for (std::size_t b = 0; b < 4; ++b) {
              const int r = static_cast<int>(row), c = static_cast<int>(nodes[b]);
              by_p.emplace_back(r, c,
                                weight * flow * (of_x[b] * of_x[a] + of_y[b] * of_y[a]) -
                                    driven * thicker * value[b]);
              by_h.emplace_back(r, c, 3 * driven / h * value[b]);
              transport.emplace_back(r, c, weight * of_x[a] * (tau * of_x[b] - value[b]));
              along.emplace_back(r, c, -weight * tau * of_x[a] * of_x[b]);
              across.emplace_back(r, c, -weight * tau * of_x[a] * of_y[b]);
            }
          }
        }
    }
  Sparse identity(count, count);
  identity.setIdentity();
  const auto sparse = [&](const auto& list) {
    Sparse m(count, count);
    m.setFromTriplets(list.begin(), list.end());
    return m;
  };
  const Sparse c = sparse(transport), sx = sparse(along), sy = sparse(across);
  const VectorXd qx = conductance.cwiseProduct(px), qy = conductance.cwiseProduct(py);
  residual += c * film + sx * qx + sy * qy;
  Linear linear{residual, sparse(by_p), sparse(by_h)};
  const Sparse of_qx = conductance.asDiagonal() * slope_x_,
               of_qy = conductance.asDiagonal() * slope_y_;
  const auto scaled = [&](const Sparse& m, const VectorXd& d) {
    return Sparse(m * d.asDiagonal());
  };
  linear.by_pressure += Sparse(sx * of_qx) + Sparse(sy * of_qy);
  linear.by_pressure -= scaled(sx, thick.cwiseProduct(qx)) + scaled(sy, thick.cwiseProduct(qy));
  linear.by_film +=
      c + scaled(sx, 3 * qx.cwiseQuotient(film)) + scaled(sy, 3 * qy.cwiseQuotient(film));
  // The penalty and the ends. Without `keep`, rows of far gaps would be greater by orders.
  VectorXd keep(count), own = VectorXd::Zero(count);
  for (Index j = 0; j < mesh_.ny(); ++j)
    for (Index i = 0; i < nx; ++i) {
      const Index n = mesh_.node(i, j);
      keep[n] = 1 / (1 + film[n] * film[n] * film[n] / numbers_.wedge);
      if (mesh_.is_end(i, j)) {
        keep[n] = 0;
        own[n] = 1;
        linear.residual[n] = state.pressure[n];
      } else {
        const double p = state.pressure[n],
                     size = std::hypot(p, rounding / (1 + gap_[n] * gap_[n]));
        own[n] = options_.penalty * area_[n] * (1 - p / size) / 2;
        linear.residual[n] =
            keep[n] * linear.residual[n] + options_.penalty * area_[n] * (p - size) / 2;
      }
    }
  linear.by_pressure =
      Sparse(keep.asDiagonal() * linear.by_pressure) + Sparse(identity * own.asDiagonal());
  linear.by_film = Sparse(keep.asDiagonal() * linear.by_film);
  return linear;
}

// The step of all pressures and of the separation, by GMRES without restarts.
VectorXd Equations::gmres(const Linear& linear, const VectorXd& side, double tolerance) const {
  const Index count = mesh_.size();
  Eigen::SparseLU<Sparse> lu;
  lu.compute(Sparse(linear.by_pressure + Sparse(linear.by_film * near_)));
  const VectorXd column = linear.by_film * VectorXd::Ones(count), lifted = lu.solve(column);
  const auto condition = [&](const VectorXd& v) {
    VectorXd out(count + 1);
    out.head(count) = lu.solve(v.head(count));
    out[count] = (load_of(out.head(count)) - v[count]) / load_of(lifted);
    out.head(count) -= out[count] * lifted;
    return out;
  };
  const auto product = [&](const VectorXd& v) {
    VectorXd out(count + 1);
    const VectorXd p = v.head(count);
    out << linear.by_pressure * p + linear.by_film * lift(p) + column * v[count], load_of(p);
    return out;
  };
  constexpr Index most = 80;
  std::vector<VectorXd> basis;
  Eigen::MatrixXd h = Eigen::MatrixXd::Zero(most + 1, most);
  const VectorXd start = condition(side);
  const double size = start.norm();
  basis.push_back(start / size);
  VectorXd weights;
  Index k = 0;
  double left = 1;
  while (k < most && left > tolerance) {
    VectorXd next = condition(product(basis[at(k)]));
    for (int again = 0; again < 2; ++again)
      for (Index m = 0; m <= k; ++m) {
        const double part = basis[at(m)].dot(next);
        h(m, k) += part;
        next -= part * basis[at(m)];
      }
    h(k + 1, k) = next.norm();
    basis.push_back(next / h(k + 1, k));
    ++k;
    VectorXd first = VectorXd::Zero(k + 1);
    first[0] = size;
    weights = h.topLeftCorner(k + 1, k).householderQr().solve(first);
    left = (h.topLeftCorner(k + 1, k) * weights - first).norm() / size;
  }
  VectorXd sum = VectorXd::Zero(count + 1);
  for (Index m = 0; m < k; ++m) sum += weights[m] * basis[at(m)];
  return sum;
}

bool Equations::solve(State& state, double tolerance, int& steps) {
  const Index count = mesh_.size();
  // The upwinding is that of the start, so that the equations stay the same in all steps.
  const VectorXd first = film(state);
  log_conductance_ = VectorXd::Zero(count);
  for (Index n = 0; n < count; ++n)
    log_conductance_[n] = 3 * std::log(first[n]) - std::log(numbers_.wedge) -
                          contact_.fluid.log_viscosity(std::fmax(state.pressure[n], 0));
  for (int step = 0; step < 80; ++step) {
    ++steps;
    const VectorXd film_now = film(state);
    const Linear linear = linear_at(state, film_now);
    VectorXd side(count + 1);
    side << -linear.residual, numbers_.load - load_of(state.pressure);
    const VectorXd change = gmres(linear, side, 1e-4);
    if (!change.allFinite()) return false;
    const double most = change.head(count).cwiseAbs().maxCoeff(), least = film_now.minCoeff();
    // The change is limited at each node by itself, because only a few nodes at the spike need it.
    double part = 1;
    State next;
    for (;; part /= 2) {
      next = {
          state.pressure + (part * change.head(count)).cwiseMax(-most_change).cwiseMin(most_change),
          state.separation + part * change[count]};
      if (film(next).minCoeff() > 0.4 * least) break;
      if (!(part > 1e-3)) return false;
    }
    const double moved = (film(next) - film_now).cwiseQuotient(film_now).cwiseAbs().maxCoeff();
    state = next;
    if (part == 1 && most < most_change && moved < tolerance) return true;
  }
  return false;
}

}  // namespace

ElementFilm solve_point_film_by_elements(const ehl::PointContact& contact,
                                         const ElementOptions& options) {
  ElementFilm result;
  const ehl::PointNumbers numbers = ehl::numbers_of(contact);
  const double k = numbers.ellipticity;
  PointMesh before;
  State state;
  std::vector<std::array<double, 2>> found;
  std::vector<double> squares;  // of the elements' sides
  for (const auto& [finer, reach] : {std::pair(1., options.reach / 2), std::pair(1., options.reach),
                                     std::pair(1.5, options.reach), std::pair(2., options.reach)}) {
    const double step = 1 / std::round(options.cells * finer);
    PointMesh mesh{graded(reach, reach, even, stretched, step),
                   graded(0, reach, even, stretched, step)};
    for (double& y : mesh.y) y *= k;
    Equations equations(contact, mesh, options);
    State next{VectorXd::Zero(mesh.size()), 0};
    for (Index j = 0; j + 1 < mesh.ny(); ++j)
      for (Index i = 1; i + 1 < mesh.nx(); ++i) {
        const double x = mesh.x[at(i)], y = mesh.y[at(j)];
        double& p = next.pressure[mesh.node(i, j)];
        // Without a pressure at the start, far nodes would not leave the penalty's corner.
        const double far = 0.01 / (1 + std::pow(x * x + y * y, 1.5));
        if (found.empty()) {
          p = std::sqrt(std::fmax(0, 1 - x * x - y * y / (k * k))) + far;
          continue;
        }
        if (x < before.x.front() || x > before.x.back() || y > before.y.back()) {
          p = far;
          continue;
        }
        const Index m = std::clamp<Index>(
                        std::upper_bound(before.x.begin(), before.x.end(), x) - before.x.begin(), 1,
                        before.nx() - 1),
                    n = std::clamp<Index>(
                        std::upper_bound(before.y.begin(), before.y.end(), y) - before.y.begin(), 1,
                        before.ny() - 1);
        const auto part = [](double low, double here, double high) {
          return std::clamp((here - low) / (high - low), 0., 1.);
        };
        const double s = part(before.x[at(m - 1)], x, before.x[at(m)]),
                     t = part(before.y[at(n - 1)], y, before.y[at(n)]);
        const auto of = [&](Index a, Index b) { return state.pressure[before.node(a, b)]; };
        p = (1 - t) * ((1 - s) * of(m - 1, n - 1) + s * of(m, n - 1)) +
            t * ((1 - s) * of(m - 1, n) + s * of(m, n));
      }
    const Index middle = std::find(mesh.x.begin(), mesh.x.end(), 0.) - mesh.x.begin();
    if (found.empty()) {
      const double m = contact.load_number;
      const double guess = 3 * std::pow(m, -2. / 15);
      next.separation = guess / numbers.film_number - equations.lift(next.pressure)[middle];
    } else {
      next.separation = state.separation;
    }
    if (found.empty())
      for (double part = std::fmin(1, 3 / contact.fluid.exponent); part < 1; part += 0.15) {
        equations.set_exponent(part * contact.fluid.exponent);
        equations.solve(next, 1e-2, result.steps);
      }
    equations.set_exponent(contact.fluid.exponent);
    if (!equations.solve(next, 1e-5, result.steps)) {
      result.reason = "Newton's method did not converge.";
      return result;
    }
    state = next;
    before = mesh;
    const VectorXd film = equations.film(state);
    // The least film by parabolas along X and Y through the node of the least film.
    Index least = 0;
    film.minCoeff(&least);
    const Index i = least % mesh.nx(), j = least / mesh.nx();
    double minimum = film[least];
    const auto lower = [&](double l, double r, double a, double c) {  // a, c: f − f(0)
      const double bend = (c / r + a / l) / (l + r) * 2, slope = (c * l / r - a * r / l) / (l + r);
      return slope * slope / (2 * bend);
    };
    minimum -= lower(mesh.x[at(i)] - mesh.x[at(i - 1)], mesh.x[at(i + 1)] - mesh.x[at(i)],
                     film[least - 1] - film[least], film[least + 1] - film[least]);
    if (j > 0)
      minimum -=
          lower(mesh.y[at(j)] - mesh.y[at(j - 1)], mesh.y[at(j + 1)] - mesh.y[at(j)],
                film[least - mesh.nx()] - film[least], film[least + mesh.nx()] - film[least]);
    found.push_back({film[middle], minimum});
    squares.push_back(step * step);
    result.nodes = static_cast<int>(mesh.size());
  }
  const auto number = [&](std::size_t which, double share) {
    const auto richardson = [&](std::size_t n) {
      const double part = squares[n + 1] / (squares[n] - squares[n + 1]);
      return found[n + 1][which] + part * (found[n + 1][which] - found[n][which]);
    };
    const double farther = found[1][which] - found[0][which];
    // The order of convergence is not observed, because there are too few meshes: it is taken as 2.
    return ehl::Estimate{.value = richardson(2) + farther,
                         .error = 2 * std::fabs(richardson(2) - richardson(1)) +
                                  share * std::fabs(richardson(2) - found[3][which]) +
                                  std::fabs(farther) / 4};
  };
  result.central = number(0, 0.125);
  result.minimum = number(1, 0.5);  // the least film converges less regularly
  result.is_solved = true;
  return result;
}

}  // namespace tribo::reference
