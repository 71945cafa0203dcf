// SPDX-License-Identifier: Apache-2.0
#include "tribo/batch.hpp"

#include <array>
#include <cstddef>

namespace tribo {

void gaussian_moment(Order n, std::span<const double> d, std::span<double> moments) {
  for (std::size_t i = 0; i < d.size(); ++i) moments[i] = gaussian_moment(n, d[i]);
}
void scaled_gaussian_moment(Order n, std::span<const double> d, std::span<double> moments) {
  for (std::size_t i = 0; i < d.size(); ++i) moments[i] = scaled_gaussian_moment(n, d[i]);
}
void log_gaussian_moment(Order n, std::span<const double> d, std::span<double> logarithms) {
  for (std::size_t i = 0; i < d.size(); ++i) logarithms[i] = log_gaussian_moment(n, d[i]);
}
void film_parameter(AsperityModel model, std::span<const double> stiffness,
                    std::span<const double> offset, std::span<const double> flooded_film_parameter,
                    std::span<double> film_parameter) {
  for (std::size_t i = 0; i < stiffness.size(); ++i)
    film_parameter[i] = LoadSharing<double>(model, stiffness[i], offset[i])
                            .solve(flooded_film_parameter[i])
                            .film_parameter;
}
void film_parameter(const LoadSharing<double>& sharing,
                    std::span<const double> flooded_film_parameter,
                    std::span<double> film_parameter) {
  for (std::size_t i = 0; i < flooded_film_parameter.size(); ++i)
    film_parameter[i] = sharing.solve(flooded_film_parameter[i]).film_parameter;
}

std::string_view instruction_set() { return "SCALAR"; }
std::span<const std::string_view> instruction_sets() {
  static constexpr std::array<std::string_view, 1> names{"SCALAR"};
  return names;
}
bool use_instruction_set(std::string_view name) { return name == "SCALAR"; }

}  // namespace tribo
