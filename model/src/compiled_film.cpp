// SPDX-License-Identifier: Apache-2.0
#include "tribo/compiled_film.hpp"

namespace tribo {

CompiledFilm::CompiledFilm(const LoadSharing<double>& sharing, double, double)
    : sharing_(sharing) {}

double CompiledFilm::film_parameter(double flooded_film_parameter) const {
  return sharing_.solve(flooded_film_parameter).film_parameter;
}
void CompiledFilm::film_parameter(std::span<const double> flooded_film_parameter,
                                  std::span<double> film_parameter) const {
  for (std::size_t i = 0; i < film_parameter.size(); ++i)
    film_parameter[i] = this->film_parameter(flooded_film_parameter[i]);
}

}  // namespace tribo
