// SPDX-License-Identifier: Apache-2.0
#include "sweep/correlation.hpp"

#define EIGEN_MPL2_ONLY
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <array>
#include <boost/math/special_functions/erf.hpp>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

namespace tribo::sweep {
namespace {

std::string three_digits(double value) {
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                       std::chars_format::general, 3)
                             .ptr};
}

}  // namespace

CorrelationRoot correlation_root(const std::vector<std::vector<double>>& matrix) {
  const auto size = static_cast<Eigen::Index>(matrix.size());
  Eigen::MatrixXd dense(size, size);
  for (std::size_t i = 0; i < matrix.size(); ++i)
    for (std::size_t j = 0; j < matrix.size(); ++j)
      dense(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = matrix[i][j];

  CorrelationRoot root;
  if (size == 0) return root;
  const double least_eigenvalue =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense, Eigen::EigenvaluesOnly)
          .eigenvalues()
          .minCoeff();
  const double rounding = static_cast<double>(size) * std::numeric_limits<double>::epsilon();
  const Eigen::LLT<Eigen::MatrixXd> cholesky(dense);
  if (!(least_eigenvalue > rounding) || cholesky.info() != Eigen::Success) {
    root.fault = "not positive definite: its least eigenvalue is " +
                 three_digits(std::abs(least_eigenvalue) <= rounding ? 0 : least_eigenvalue);
    return root;
  }
  const Eigen::MatrixXd lower = cholesky.matrixL();
  root.rows.resize(matrix.size());
  for (std::size_t i = 0; i < matrix.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j)
      root.rows[i].push_back(lower(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
  return root;
}

double standard_normal(double u) {
  // Boost would compute in long double, three times as long for digits that are rounded away.
  using NoPromotion = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
  return -std::numbers::sqrt2 * boost::math::erfc_inv(2 * u, NoPromotion());
}

void correlate(const std::vector<std::vector<double>>& root, std::span<double> normals) {
  for (std::size_t i = root.size(); i-- > 0;) {
    double sum = 0;
    for (std::size_t j = 0; j <= i; ++j) sum += root[i][j] * normals[j];
    normals[i] = sum;
  }
}

}  // namespace tribo::sweep
