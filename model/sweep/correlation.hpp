// SPDX-License-Identifier: Apache-2.0
// Correlated draws by a Gaussian copula: each unit number becomes a standard normal, the normals
// are mixed, and each variable takes the quantile that belongs to its mixed normal. The matrix is
// thus the correlation of normal variables themselves, and of the logarithms of log-normal ones.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace tribo::sweep {

// The rows of the lower triangle L with L·Lᵀ = the matrix. The matrix is given by its rows, and is
// symmetric with ones on its diagonal. If there is no L, `fault` says why ("not positive definite:
// its least eigenvalue is -0.2").
struct CorrelationRoot {
  std::vector<std::vector<double>> rows;
  std::string fault;  // empty if there is none
};
CorrelationRoot correlation_root(const std::vector<std::vector<double>>& matrix);

// Turns each u, 0 ≤ u ≤ 1, into the z of a standard normal for which P(Z < z) = u. At the ends z is
// infinite. The error is at most 4 ulp, also near u = ½, where z is small.
void standard_normals(std::span<double> units);

// Mixes independent normals in place, by the rows of CorrelationRoot.
void correlate(const std::vector<std::vector<double>>& root, std::span<double> normals);

}  // namespace tribo::sweep
