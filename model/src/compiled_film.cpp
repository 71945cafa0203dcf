// SPDX-License-Identifier: Apache-2.0
#include "tribo/compiled_film.hpp"

#include <algorithm>

#include "tribo/batch.hpp"

namespace tribo {
namespace {

ProxyPieces compile(const LoadSharing<double>& sharing, double from, double to) {
  const auto root = [&](std::span<const double> flooded, std::span<double> lambda) {
    film_parameter(sharing, flooded, lambda);
    for (std::size_t i = 0; i < flooded.size(); ++i)
      lambda[i] = detail::polished_film_parameter(sharing.surface(), flooded[i], lambda[i]);
  };
  // Half the bound at the points that are looked at; the error between them is hardly greater.
  return ProxyPieces(root, std::max(from, 1e-280), std::min(to, 1e280),
                     CompiledFilm::error_bound / 2);
}

}  // namespace

CompiledFilm::CompiledFilm(const LoadSharing<double>& sharing, double from, double to)
    : sharing_(sharing), pieces_(compile(sharing, from, to)) {}

void CompiledFilm::film_parameter(std::span<const double> flooded,
                                  std::span<double> film_parameter) const {
  if (pieces_.values(flooded, film_parameter)) return;
  for (std::size_t i = 0; i < flooded.size(); ++i)
    if (film_parameter[i] != film_parameter[i])
      film_parameter[i] = sharing_.film_parameter(flooded[i]);
}

}  // namespace tribo
