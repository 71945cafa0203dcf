// SPDX-License-Identifier: Apache-2.0
#include "ehl/plane_kernel.hpp"

#include <cmath>
#include <unsupported/Eigen/FFT>

namespace tribo::ehl {
namespace {

using Complex = std::complex<double>;

// The least multiple of 4 from `least` on without prime factors above 5. With a multiple of 4 a
// real transform takes a complex one of half the length.
int smooth_length(int least) {
  for (int length = (least + 3) / 4 * 4;; length += 4) {
    int rest = length;
    for (const int prime : {2, 3, 5})
      while (rest % prime == 0) rest /= prime;
    if (rest == 1) return length;
  }
}

// ∬ 1/r over the rectangle between the origin and (x, y), with the sign of xy.
double corner(double x, double y) {
  if (x == 0 || y == 0) return 0;
  return x * std::asinh(y / std::fabs(x)) + y * std::asinh(x / std::fabs(y));
}

// The place of the j-th number of the i-th line.
std::size_t place(int i, int length, int j = 0) {
  return static_cast<std::size_t>(i) * static_cast<std::size_t>(length) +
         static_cast<std::size_t>(j);
}

}  // namespace

double film_of_rectangle(double x, double y, double dx, double dy) {
  const double left = x - dx / 2, right = x + dx / 2, below = y - dy / 2, above = y + dy / 2;
  return corner(right, above) - corner(left, above) - corner(right, below) + corner(left, below);
}

PlaneKernel::PlaneKernel(const PlaneGrid& grid)
    : grid_(grid),
      length_x_(smooth_length(2 * grid.count_x() - 1)),
      length_y_(smooth_length(4 * grid.count_y() - 3)) {
  const int nx = grid.count_x(), ny = grid.count_y(), half_x = length_x_ / 2 + 1,
            half_y = length_y_ / 2 + 1;
  // The kernel's transform along X, then along Y. Its sequences are even.
  Eigen::FFT<double> fft;
  std::vector<double> line(static_cast<std::size_t>(length_x_));
  std::vector<Complex> wave;
  std::vector<double> rows(place(half_x, half_y));
  for (int j = 0; j < half_y; ++j) {
    std::fill(line.begin(), line.end(), 0.);
    if (j <= 2 * (ny - 1))
      for (int i = 0; i < nx; ++i) {
        const double film = film_of_rectangle(i * grid.dx, j * grid.dy, grid.dx, grid.dy);
        line[static_cast<std::size_t>(i)] = film;
        if (i > 0) line[place(1, length_x_ - i)] = film;
      }
    fft.fwd(wave, line);
    for (int i = 0; i < half_x; ++i)
      rows[place(i, half_y, j)] = wave[static_cast<std::size_t>(i)].real();
  }
  spectrum_.resize(rows.size());
  std::vector<double> column(static_cast<std::size_t>(length_y_));
  for (int i = 0; i < half_x; ++i) {
    for (int j = 0; j < half_y; ++j) {
      const double value = rows[place(i, half_y, j)];
      column[static_cast<std::size_t>(j)] = value;
      if (j > 0) column[place(1, length_y_ - j)] = value;
    }
    fft.fwd(wave, column);
    for (int j = 0; j < half_y; ++j)
      spectrum_[place(i, half_y, j)] = wave[static_cast<std::size_t>(j)].real();
  }
  for (int j = 0; j < ny; ++j)
    own_.push_back(film_of_rectangle(0, 0, grid.dx, grid.dy) +
                   (j > 0 ? film_of_rectangle(0, 2 * j * grid.dy, grid.dx, grid.dy) : 0));
}

Eigen::VectorXd PlaneKernel::operator*(const Eigen::VectorXd& pressure) const {
  const int nx = grid_.count_x(), ny = grid_.count_y(), half_x = length_x_ / 2 + 1,
            half_y = length_y_ / 2 + 1;
  thread_local Eigen::FFT<double> fft;
  std::vector<double> line(static_cast<std::size_t>(length_x_), 0.);
  std::vector<Complex> wave(static_cast<std::size_t>(half_x));
  // The transform along X of each row of nodes, stored column by column.
  std::vector<Complex> rows(place(half_x, ny));
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) line[static_cast<std::size_t>(i)] = pressure[grid_.node(i, j)];
    fft.fwd(wave.data(), line.data(), length_x_);
    for (int i = 0; i < half_x; ++i) rows[place(i, ny, j)] = wave[static_cast<std::size_t>(i)];
  }
  std::vector<Complex> column(static_cast<std::size_t>(length_y_)),
      turned(static_cast<std::size_t>(length_y_));
  for (int i = 0; i < half_x; ++i) {
    Complex* row = &rows[place(i, ny)];
    std::fill(column.begin(), column.end(), Complex{});
    for (int j = 0; j < ny; ++j) {
      column[static_cast<std::size_t>(j)] = row[j];
      if (j > 0) column[place(1, length_y_ - j)] = row[j];
    }
    fft.fwd(turned.data(), column.data(), length_y_);
    const double* kernel = &spectrum_[place(i, half_y)];
    for (int j = 0; j < half_y; ++j) turned[static_cast<std::size_t>(j)] *= kernel[j];
    for (int j = half_y; j < length_y_; ++j)
      turned[static_cast<std::size_t>(j)] = turned[place(1, length_y_ - j)];
    fft.inv(column.data(), turned.data(), length_y_);
    for (int j = 0; j < ny; ++j) row[j] = column[static_cast<std::size_t>(j)];
  }
  Eigen::VectorXd film(pressure.size());
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < half_x; ++i) wave[static_cast<std::size_t>(i)] = rows[place(i, ny, j)];
    fft.inv(line.data(), wave.data(), length_x_);
    for (int i = 0; i < nx; ++i) film[grid_.node(i, j)] = line[static_cast<std::size_t>(i)];
    std::fill(line.begin() + nx, line.end(), 0.);
  }
  return film;
}

}  // namespace tribo::ehl
