// SPDX-License-Identifier: Apache-2.0
#include "ehl/film_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "ehl/influence.hpp"

namespace tribo::ehl {
namespace {

constexpr int leaf_size = 64;
constexpr double tolerance = 1e-12;
// Newton's method took as many steps with 1e-6 as with 1e-12, and two to three times as many with
// 1e-4, at (M, L) = (100, 10) and (200, 20).
constexpr double rough_tolerance = 1e-8;

}  // namespace

FilmKernel::FilmKernel(std::span<const double> x) : x_(x.begin(), x.end()) { add_part(0, size()); }

double FilmKernel::entry(int row, int column) const {
  const auto i = static_cast<std::size_t>(row), j = static_cast<std::size_t>(column);
  if (row < 0 || row >= size() || j == 0 || j + 1 == x_.size()) return 0;
  return film_of_hat(x_[i] - x_[j], x_[j] - x_[j - 1], x_[j + 1] - x_[j]);
}

Eigen::MatrixXd FilmKernel::rows(int row, int row_end, int column, int column_end) const {
  return Eigen::MatrixXd::NullaryExpr(
      row_end - row, column_end - column, [&](Eigen::Index i, Eigen::Index j) {
        return entry(row + static_cast<int>(i), column + static_cast<int>(j));
      });
}

// Adaptive cross approximation. Each step takes a row of the residual block and the column where
// this row is greatest. The next row is the one where this column is greatest. Source: M.
// Bebendorf: Approximation of boundary element matrices. Numer. Math. 86 (2000) 565.
ThinProduct FilmKernel::thin_product(int row, int row_end, int column, int column_end) const {
  const int m = row_end - row, n = column_end - column;
  const int most = std::min(m, n);
  std::vector<Eigen::VectorXd> left, right;
  std::vector<char> used(static_cast<std::size_t>(m), 0);
  // The first row is the one where the halves meet: the entries vary most there.
  int pivot = row < column ? m - 1 : 0;
  Eigen::Index rough_rank = 0;
  double square = 0;  // the square of the block's norm, so far
  for (int rank = 0; rank < most; ++rank) {
    used[static_cast<std::size_t>(pivot)] = 1;
    Eigen::VectorXd across =
        rows(row + pivot, row + pivot + 1, column, column_end).transpose().col(0);
    for (std::size_t k = 0; k < left.size(); ++k) across -= left[k][pivot] * right[k];
    Eigen::Index greatest;
    const double scale = across.cwiseAbs().maxCoeff(&greatest);
    if (scale == 0) break;
    across /= across[greatest];
    const int j = column + static_cast<int>(greatest);
    Eigen::VectorXd down = rows(row, row_end, j, j + 1).col(0);
    for (std::size_t k = 0; k < left.size(); ++k) down -= right[k][greatest] * left[k];
    const double size = down.norm() * across.norm();
    for (std::size_t k = 0; k < left.size(); ++k)
      square += 2 * left[k].dot(down) * right[k].dot(across);
    square += size * size;
    double next = -1;
    for (int i = 0; i < m; ++i)
      if (used[static_cast<std::size_t>(i)] == 0 && std::fabs(down[i]) > next) {
        next = std::fabs(down[i]);
        pivot = i;
      }
    left.push_back(std::move(down));
    right.push_back(std::move(across));
    if (size > rough_tolerance * std::sqrt(std::fabs(square))) rough_rank = rank + 1;
    if (size <= tolerance * std::sqrt(std::fabs(square))) break;
  }
  ThinProduct product{Eigen::MatrixXd(m, static_cast<Eigen::Index>(left.size())),
                      Eigen::MatrixXd(n, static_cast<Eigen::Index>(left.size())), rough_rank};
  for (std::size_t k = 0; k < left.size(); ++k) {
    product.left.col(static_cast<Eigen::Index>(k)) = left[k];
    product.right.col(static_cast<Eigen::Index>(k)) = right[k];
  }
  return product;
}

int FilmKernel::add_part(int begin, int end) {
  const auto index = parts_.size();
  parts_.emplace_back();
  parts_.back().begin = begin;
  parts_.back().end = end;
  if (end - begin <= leaf_size) {
    parts_[index].dense = rows(begin - 2, end + 1, begin, end);
    return static_cast<int>(index);
  }
  const int middle = (begin + end) / 2;
  const int first = add_part(begin, middle);
  const int second = add_part(middle, end);
  KernelPart& part = parts_[index];
  part.middle = middle;
  part.first = first;
  part.second = second;
  part.upper = thin_product(begin, middle, middle, end);
  part.lower = thin_product(middle, end, begin, middle);
  const auto three_rows = [&](int before, int after, int column, int column_end) {
    Eigen::MatrixXd three(3, column_end - column);
    three.topRows(2) = rows(before - 2, before, column, column_end);
    three.row(2) = rows(after, after + 1, column, column_end);
    return three;
  };
  part.upper_rows = three_rows(begin, middle, middle, end);
  part.lower_rows = three_rows(middle, end, begin, middle);
  return static_cast<int>(index);
}

void FilmKernel::add_product(int index, const Eigen::VectorXd& pressure,
                             Eigen::VectorXd& film) const {
  const KernelPart& p = part(index);
  if (p.middle == 0) {
    film.segment(p.begin, p.end - p.begin) +=
        p.dense.middleRows(2, p.end - p.begin) * pressure.segment(p.begin, p.end - p.begin);
    return;
  }
  add_product(p.first, pressure, film);
  add_product(p.second, pressure, film);
  const int of_first = p.middle - p.begin, of_second = p.end - p.middle;
  film.segment(p.begin, of_first) +=
      p.upper.left * (p.upper.right.transpose() * pressure.segment(p.middle, of_second));
  film.segment(p.middle, of_second) +=
      p.lower.left * (p.lower.right.transpose() * pressure.segment(p.begin, of_first));
}

Eigen::VectorXd FilmKernel::operator*(const Eigen::VectorXd& pressure) const {
  Eigen::VectorXd film = Eigen::VectorXd::Zero(size());
  add_product(root(), pressure, film);
  return film;
}

std::size_t FilmKernel::bytes() const {
  Eigen::Index numbers = 0;
  for (const KernelPart& p : parts_)
    numbers += p.dense.size() + p.upper.left.size() + p.upper.right.size() + p.lower.left.size() +
               p.lower.right.size() + p.upper_rows.size() + p.lower_rows.size();
  return static_cast<std::size_t>(numbers) * sizeof(double);
}

}  // namespace tribo::ehl
