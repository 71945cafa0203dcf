// SPDX-License-Identifier: Apache-2.0
#include "sweep/correlation.hpp"

#define EIGEN_MPL2_ONLY
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "scene/text.hpp"
#include "tribo/elementary.hpp"

namespace tribo::sweep {
namespace {

// Coefficients in ascending order.
template <std::size_t size>
double value_at(const std::array<double, size>& polynomial, double x) {
  double value = polynomial[size - 1];
  for (std::size_t i = size - 1; i-- > 0;) value = value * x + polynomial[i];
  return value;
}

// Wichura's PPND16, Algorithm AS 241 (Appl. Stat. 37 (1988) 477): seven of eight values of u need
// no logarithm. With Boost.Math's erfc_inv, drawing took twice as long, and was most of the time
// that a sweep adds to its scenes. The terms 2.75, 1.125 r and 1.375 r are taken out of Wichura's
// ratios of polynomials, so that the rounding of the polynomials counts little. This function is
// for the middle, |u − ½| ≤ 0.425.
double normal_of_middle(double from_middle) {
  constexpr std::array near_above{0.637132872796366608,   16.780008462381871507,
                                  81.826679703392194875,  -1102.3452934086044212,
                                  -12415.980397813267177, -40830.942523246253324,
                                  -45574.410189647214248, -11863.78108811522737};
  constexpr std::array near_below{1.0,
                                  42.313330701600911252,
                                  687.1870074920579083,
                                  5394.1960214247511077,
                                  21213.794301586595867,
                                  39307.89580009271061,
                                  28729.085735721942674,
                                  5226.495278852854561};
  const double r = 0.180625 - from_middle * from_middle;
  return from_middle * (2.75 + value_at(near_above, r) / value_at(near_below, r));
}

// This function is for the upper tail; r = √(−ln P(Z > z)).
double normal_of_tail(double r) {
  constexpr std::array far_above{
      -0.37656288925031642266,  -0.19040708179142058347,   0.44216394716236580198,
      0.52033418783324526627,   0.2278828430246667432,     0.047806151882025904902,
      0.0046396762499015081468, 0.00015850008836623614126, -1.1820938305999689486e-9};
  constexpr std::array far_below{1.0,
                                 2.0531916266377588219,
                                 1.6763848301838038494,
                                 0.68976733498510000455,
                                 0.14810397642748007459,
                                 0.015198666563616457197,
                                 0.0005475938084995344946,
                                 1.0507500716444168432e-9};
  constexpr std::array farthest_above{
      -0.2170953564988962228,   -0.035061508907615201719, 0.01866432455913675997,
      0.0060138766851451818178, 0.0006688424750304365145, 0.000033781507734043947964,
      7.5138948782906735827e-7, 5.5755591064086677629e-9, -2.8108617671611672053e-15};
  constexpr std::array farthest_below{1.0,
                                      0.59983220655588793769,
                                      0.13692988092273580531,
                                      0.014875361290850614852,
                                      0.0007868691311456132591,
                                      0.000018463183175100546818,
                                      1.4215117583164458887e-7,
                                      2.0442631033899397856e-15};
  return r <= 5 ? 1.125 * r + value_at(far_above, r - 1.6) / value_at(far_below, r - 1.6)
                : 1.375 * r + value_at(farthest_above, r - 5) / value_at(farthest_below, r - 5);
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
    root.fault =
        "not positive definite: its least eigenvalue is " +
        scene_detail::rounded_text(std::abs(least_eigenvalue) <= rounding ? 0 : least_eigenvalue);
    return root;
  }
  const Eigen::MatrixXd lower = cholesky.matrixL();
  root.rows.resize(matrix.size());
  for (std::size_t i = 0; i < matrix.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j)
      root.rows[i].push_back(lower(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
  return root;
}

void standard_normals(std::span<double> units) {
  constexpr std::size_t block = 256;
  std::array<double, block> tails;
  std::array<std::uint16_t, block> places;
  for (; !units.empty(); units = units.subspan(std::min(block, units.size()))) {
    const std::span some = units.first(std::min(block, units.size()));
    std::size_t count = 0;
    for (std::size_t i = 0; i < some.size(); ++i) {
      const double from_middle = some[i] - 0.5;
      if (std::abs(from_middle) <= 0.425) {
        some[i] = normal_of_middle(from_middle);
        continue;
      }
      tails[count] = from_middle < 0 ? some[i] : 1 - some[i];
      places[count++] = static_cast<std::uint16_t>(i);
      some[i] = from_middle;
    }
    const std::span of_tails(tails.data(), count);
    logarithm(of_tails, of_tails);
    for (std::size_t k = 0; k < count; ++k) {
      const double r = std::sqrt(-tails[k]);
      const double z =
          std::isfinite(r) ? normal_of_tail(r) : std::numeric_limits<double>::infinity();
      some[places[k]] = std::copysign(z, some[places[k]]);
    }
  }
}

void correlate(const std::vector<std::vector<double>>& root, std::span<double> normals) {
  for (std::size_t i = root.size(); i-- > 0;) {
    double sum = 0;
    for (std::size_t j = 0; j <= i; ++j) sum += root[i][j] * normals[j];
    normals[i] = sum;
  }
}

}  // namespace tribo::sweep
