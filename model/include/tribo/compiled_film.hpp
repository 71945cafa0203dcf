// SPDX-License-Identifier: Apache-2.0
// Load sharing of one surface, compiled: λ(λ₀) as polynomials in pieces, for when many points of
// one surface are asked.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tribo/load_sharing.hpp"

namespace tribo {

// λ(λ₀) of one surface for λ₀ in [from, to]. Building it solves some hundred to some thousand
// points; beyond the range, and where a piece misses the bound, λ comes from the root.
class CompiledFilm {
 public:
  // Relative error against the root that it was built from, beside that root's own.
  static constexpr double error_bound = 1e-14;

  CompiledFilm(const LoadSharing<double>& sharing, double from, double to);

  double film_parameter(double flooded_film_parameter) const;
  void film_parameter(std::span<const double> flooded_film_parameter,
                      std::span<double> film_parameter) const;

 private:
  LoadSharing<double> sharing_;
};

}  // namespace tribo
