// SPDX-License-Identifier: Apache-2.0
#include "generators/log_element.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace tribo::reference {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The nodes are −1, the other roots of P_{p−1} + P_p, and 1; p is the degree.
VectorXd radau_nodes(int degree) {
  const auto f = [&](double z) { return legendre(degree - 1, z) + legendre(degree, z); };
  VectorXd nodes(degree + 1);
  nodes[0] = -1;
  nodes[degree] = 1;
  constexpr int intervals = 1000;
  const auto place = [&](int i) { return -1 + 2 * (i + 0.5) / intervals; };
  Index found = 1;
  for (int i = 0; i + 1 < intervals && found < degree; ++i) {
    double low = place(i), high = place(i + 1);
    if (f(low) * f(high) > 0) continue;
    for (int k = 0; k < 60; ++k) {
      const double middle = (low + high) / 2;
      (f(low) * f(middle) <= 0 ? high : low) = middle;
    }
    nodes[found++] = (low + high) / 2;
  }
  return nodes;
}

// ∫ P_n(t) ln|z − t| dt for n = 0 … degree. For n > 0, (P_{n+1} − P_{n−1})/(2n + 1) is an integral
// of P_n and is 0 at both ends, so that integration by parts gives
// 2[Q_{n+1}(z) − Q_{n−1}(z)]/(2n + 1). At z = ±1 the infinite logarithms in Q cancel, and the code
// has 0 in place of them.
LogElement::Weights near_potentials(int degree, double z) {
  const double to_right = std::fabs(1 - z), to_left = std::fabs(1 + z);
  const double log_right = to_right > 0 ? std::log(to_right) : 0;
  const double log_left = to_left > 0 ? std::log(to_left) : 0;
  std::array<double, LogElement::most_nodes + 1> q{};
  q[0] = (log_left - log_right) / 2;
  q[1] = z * q[0] - 1;
  LogElement::Weights result(degree + 1);
  result[0] = (1 - z) * log_right + (1 + z) * log_left - 2;
  for (int n = 1; n <= degree; ++n) {
    const auto k = static_cast<std::size_t>(n);
    q[k + 1] = ((2 * n + 1) * z * q[k] - n * q[k - 1]) / (n + 1);
    result[n] = 2 * (q[k + 1] - q[k - 1]) / (2 * n + 1);
  }
  return result;
}

}  // namespace

double legendre(int n, double z) {
  double before = 1, here = z;
  if (n == 0) return 1;
  for (int k = 1; k < n; ++k) {
    const double next = ((2 * k + 1) * z * here - k * before) / (k + 1);
    before = here;
    here = next;
  }
  return here;
}

LogElement::LogElement(int degree) : nodes_(radau_nodes(degree)), slopes_(degree + 1, degree + 1) {
  const int count = degree + 1;
  MatrixXd values(count, count), slopes = MatrixXd::Zero(count, count);  // P_n, P_n' at the nodes
  for (int k = 0; k < count; ++k)
    for (int n = 0; n < count; ++n) {
      values(k, n) = legendre(n, nodes_[k]);
      if (n > 0)
        slopes(k, n) = (n > 1 ? slopes(k, n - 2) : 0) + (2 * n - 1) * legendre(n - 1, nodes_[k]);
    }
  to_legendre_ = values.inverse();
  slopes_ = slopes * to_legendre_;
  medium_ = gauss<12>();
  far_ = gauss<8>();
}

// The points are the eigenvalues of the matrix of Legendre's recurrence (Golub and Welsch).
template <int count>
LogElement::Gauss<count> LogElement::gauss() const {
  using Square = Eigen::Matrix<double, count, count>;
  Square recurrence = Square::Zero();
  for (int i = 1; i < count; ++i)
    recurrence(i, i - 1) = recurrence(i - 1, i) = i / std::sqrt(4.0 * i * i - 1);
  const Eigen::SelfAdjointEigenSolver<Square> solver(recurrence);
  Gauss<count> rule{solver.eigenvalues(), {}};
  rule.weights.resize(nodes_.size(), count);
  for (int q = 0; q < count; ++q) {
    const double first = solver.eigenvectors()(0, q);
    VectorXd polynomials(nodes_.size());
    for (int n = 0; n <= degree(); ++n) polynomials[n] = legendre(n, rule.points[q]);
    rule.weights.col(q) = 2 * first * first * (to_legendre_.transpose() * polynomials);
  }
  return rule;
}

LogElement::Weights LogElement::log_weights(double z) const {
  if (std::fabs(z) > 10) return far_weights(far_, z);
  if (std::fabs(z) > 2.5) return far_weights(medium_, z);
  return to_legendre_.transpose() * near_potentials(degree(), z);
}

}  // namespace tribo::reference
