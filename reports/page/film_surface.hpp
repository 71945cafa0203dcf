// SPDX-License-Identifier: Apache-2.0
// A film number over the numbers of load and of material, smooth between solved ones: cubic
// splines in log M and log L of log(film over Moes' formula), which varies less than the film.
#pragma once

#include <Eigen/Dense>
#include <unsupported/Eigen/Splines>
#include <vector>

namespace tribo::report {

class FilmSurface {
 public:
  using Spline = Eigen::Spline<double, 1, 3>;

  // film(row of load_numbers, column of material_numbers) > 0; both lists rise, with four or more
  // numbers, material_numbers > 0.
  FilmSurface(std::vector<double> load_numbers, std::vector<double> material_numbers,
              const Eigen::MatrixXd& film);

  // The film at one load number and several material numbers, within the lists.
  std::vector<double> films(double load_number, const std::vector<double>& material_numbers) const;

 private:
  std::vector<double> load_numbers_, material_numbers_;
  std::vector<Spline> over_load_;  // the ratio's logarithm, a spline for each material number
};

}  // namespace tribo::report
