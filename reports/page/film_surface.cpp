// SPDX-License-Identifier: Apache-2.0
#include "page/film_surface.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tribo/moes_line.hpp"

namespace tribo::report {
namespace {

using Spline = FilmSurface::Spline;

// From 0 at the first number to 1 at the last.
double place_of(const std::vector<double>& numbers, double number) {
  const double place =
      std::log(number / numbers.front()) / std::log(numbers.back() / numbers.front());
  return std::clamp(place, 0., 1.);
}

Spline spline_through(const std::vector<double>& numbers, const Eigen::RowVectorXd& values) {
  Spline::KnotVectorType places(values.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    places[static_cast<Eigen::Index>(i)] = place_of(numbers, numbers[i]);
  return Eigen::SplineFitting<Spline>::Interpolate(values, 3, places);
}

}  // namespace

FilmSurface::FilmSurface(std::vector<double> load_numbers, std::vector<double> material_numbers,
                         const Eigen::MatrixXd& film)
    : load_numbers_(std::move(load_numbers)), material_numbers_(std::move(material_numbers)) {
  for (std::size_t l = 0; l < material_numbers_.size(); ++l) {
    Eigen::RowVectorXd log_ratio(film.rows());
    for (std::size_t m = 0; m < load_numbers_.size(); ++m) {
      const auto row = static_cast<Eigen::Index>(m), column = static_cast<Eigen::Index>(l);
      log_ratio[row] =
          std::log(film(row, column) / moes_line_number(load_numbers_[m], material_numbers_[l]));
    }
    over_load_.push_back(spline_through(load_numbers_, log_ratio));
  }
}

std::vector<double> FilmSurface::films(double load_number,
                                       const std::vector<double>& material_numbers) const {
  Eigen::RowVectorXd log_ratio(static_cast<Eigen::Index>(material_numbers_.size()));
  for (std::size_t l = 0; l < over_load_.size(); ++l)
    log_ratio[static_cast<Eigen::Index>(l)] =
        over_load_[l](place_of(load_numbers_, load_number))[0];
  const Spline over_material = spline_through(material_numbers_, log_ratio);
  std::vector<double> films;
  for (const double number : material_numbers)
    films.push_back(moes_line_number(load_number, number) *
                    std::exp(over_material(place_of(material_numbers_, number))[0]));
  return films;
}

}  // namespace tribo::report
