// SPDX-License-Identifier: Apache-2.0
// Correlated draws by a Gaussian copula: each unit number becomes a standard normal, the normals
// are mixed, and each variable takes the quantile that belongs to its mixed normal. The matrix is
// thus the correlation of normal variables themselves, and of the logarithms of log-normal ones.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tribo::sweep {

// The rows of the lower triangle L with L·Lᵀ = the matrix, which is given by its rows and is
// symmetric with ones on its diagonal; or why there is none ("not positive definite: its least
// eigenvalue is -0.2").
struct CorrelationRoot {
  std::vector<std::vector<double>> rows;
  std::string fault;  // empty: none
};
CorrelationRoot correlation_root(const std::vector<std::vector<double>>& matrix);

// Turns each u into the z of a standard normal with P(Z < z) = u, 0 ≤ u ≤ 1; infinite at the ends.
// Error: 4 ulp, around u = ½ too.
void standard_normals(std::span<double> units);

// Mixes independent normals in place.
void correlate(const std::vector<std::vector<double>>& root, std::span<double> normals);

}  // namespace tribo::sweep
