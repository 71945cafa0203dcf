// SPDX-License-Identifier: Apache-2.0
// A polynomial f of degree p on an element from −1 to 1, given by its values at p + 1 nodes: the p
// left Radau points, the first of which is −1, and 1. All results are weights of these values,
// among them those of ∫ f(t) ln|z − t| dt.
#pragma once

#include <Eigen/Dense>

namespace tribo::reference {

// P_n(z) of Legendre.
double legendre(int n, double z);

class LogElement {
 public:
  static constexpr int most_nodes = 6;
  // One weight for each node.
  using Weights = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, most_nodes, 1>;

  explicit LogElement(int degree);  // 1 to 5

  int degree() const { return static_cast<int>(nodes_.size()) - 1; }
  const Eigen::VectorXd& nodes() const { return nodes_; }
  // Row k: weights of the values in the slope at node k.
  const Eigen::MatrixXd& slopes() const { return slopes_; }
  // Row n: weights of the values in the coefficient of P_n.
  const Eigen::MatrixXd& to_legendre() const { return to_legendre_; }
  // Weights of the values in the integral of f.
  Weights integral() const { return 2 * to_legendre_.row(0).transpose(); }

  // Weights of the values in ∫ f(t) ln|z − t| dt, to 2e-12. Near the element Legendre's functions
  // of the second kind give them exactly but for rounding; from |z| = 2.5 on Gauss's rule takes 12
  // points, from |z| = 10 on 8 points.
  Weights log_weights(double z) const;

 private:
  Eigen::VectorXd nodes_;
  Eigen::MatrixXd slopes_, to_legendre_;
  // `weights` has a row for the value at each node and a column for each of Gauss's points.
  template <int count>
  struct Gauss {
    Eigen::Array<double, count, 1> points;
    Eigen::Matrix<double, Eigen::Dynamic, count, Eigen::ColMajor, most_nodes, count> weights;
  };
  template <int count>
  Gauss<count> gauss() const;
  template <int count>
  static Weights far_weights(const Gauss<count>& gauss, double z) {
    return gauss.weights * (z - gauss.points).abs().log().matrix();
  }

  Gauss<12> medium_;
  Gauss<8> far_;
};

}  // namespace tribo::reference
