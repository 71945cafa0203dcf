// SPDX-License-Identifier: Apache-2.0
// Load sharing of one surface, compiled: λ(λ₀) as polynomials in pieces (proxy_pieces.hpp), for
// when thousands of points of one surface are asked.
#pragma once

#include <span>

#include "tribo/load_sharing.hpp"
#include "tribo/proxy_pieces.hpp"

namespace tribo {

// λ(λ₀) of one surface for λ₀ in [from, to], 0 < from < to. Building it takes some thousand roots.
// Outside the range, and where a piece does not hold its bound (next to a critical stiffness, where
// the root itself has fewer digits), λ comes from the root.
class CompiledFilm {
 public:
  // Relative to the root, beside that root's own error (load_sharing_contract).
  static constexpr double error_bound = 1e-14;

  CompiledFilm(const LoadSharing<double>& sharing, double from, double to);

  double film_parameter(double flooded_film_parameter) const {
    const double lambda = pieces_.value(flooded_film_parameter);
    return lambda == lambda ? lambda : sharing_.film_parameter(flooded_film_parameter);
  }
  // The result must not overlap the argument.
  void film_parameter(std::span<const double> flooded_film_parameter,
                      std::span<double> film_parameter) const;

  const ProxyPieces& pieces() const { return pieces_; }

 private:
  LoadSharing<double> sharing_;
  ProxyPieces pieces_;
};

}  // namespace tribo
