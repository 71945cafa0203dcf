// SPDX-License-Identifier: Apache-2.0
// Makes the polynomials of src/hertz_ellipse.cpp, at each build: `ellipse_pieces
// ellipse_pieces.inc`.
//
// Each of the three numbers of EllipseOfCircle is, for α = R_y/R_x ≥ 1 and for α = R_x/R_y ≥ 1, on
// each of four parts of an octave a polynomial in α/2^octave − centre: the interpolant at the
// Chebyshev nodes, computed with 113 bits. Its constant coefficient is held as a sum of two
// doubles. The functions are analytic but for α ≤ 0, so that the interpolant's error falls by a
// factor of 17 or more with each degree. The error is checked here where it is greatest; if it is
// more than a sixteenth of the last place, the program fails. The proof that no number is off by
// more than 1 ulp at any α is verification/tests/analytic/ellipse_pieces_test.cpp.
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <vector>

#include "tribo/hertz_ellipse.hpp"

namespace {

using Real = boost::multiprecision::cpp_bin_float_quad;
constexpr int octaves = 14, parts = 4;  // of α, and of each octave
constexpr int degree = 13;
constexpr double greatest_error = 0x1p-57;  // relative

// axis_cube, axes_ratio and approach.
std::array<Real, 3> ellipse(bool is_exchanged, const Real& ratio) {
  const auto found = is_exchanged ? tribo::ellipse_of_circle<Real>(ratio, Real(1))
                                  : tribo::ellipse_of_circle<Real>(Real(1), ratio);
  return {found.axis_cube, found.axes_ratio, found.approach};
}

// The coefficients of the powers of u of the interpolant at nodes, by Newton's divided differences.
std::vector<Real> interpolant(const std::vector<Real>& nodes, std::vector<Real> values) {
  const std::size_t count = nodes.size();
  for (std::size_t k = 1; k < count; ++k)
    for (std::size_t i = count - 1; i >= k; --i)
      values[i] = (values[i] - values[i - 1]) / (nodes[i] - nodes[i - k]);
  std::vector<Real> powers(count, Real(0));
  for (std::size_t i = count; i-- > 0;) {
    for (std::size_t k = count - 1; k > 0; --k) powers[k] = powers[k - 1] - nodes[i] * powers[k];
    powers[0] = values[i] - nodes[i] * powers[0];
  }
  return powers;
}

Real at(const std::vector<Real>& powers, const Real& u) {
  Real sum = 0;
  for (std::size_t k = powers.size(); k-- > 0;) sum = sum * u + powers[k];
  return sum;
}

void write_piece(std::ostream& to, bool is_exchanged, int octave, int part) {
  const Real scale = ldexp(Real(1), octave);
  const Real centre = Real(1) + Real(2 * part + 1) / (2 * parts), half = Real(1) / (2 * parts);
  const auto of = [&](const Real& u) { return ellipse(is_exchanged, Real((centre + u) * scale)); };
  std::vector<Real> nodes;
  std::array<std::vector<Real>, 3> values;
  for (int i = 0; i <= degree; ++i) {
    nodes.push_back(half * cos(tribo::pi<Real>() * (2 * i + 1) / (2 * degree + 2)));
    const auto here = of(nodes.back());
    for (std::size_t k = 0; k < 3; ++k) values[k].push_back(here[k]);
  }
  std::array<std::vector<Real>, 3> powers;
  for (std::size_t k = 0; k < 3; ++k) powers[k] = interpolant(nodes, values[k]);
  // The error is greatest near the ends and in the middle between two nodes.
  for (int i = 0; i <= 2 * degree + 2; ++i) {
    const Real u = half * cos(tribo::pi<Real>() * i / (2 * degree + 2));
    const auto here = of(u);
    for (std::size_t k = 0; k < 3; ++k)
      if (!(abs(at(powers[k], u) / here[k] - 1) < greatest_error))
        throw std::runtime_error("the degree is too low for the ellipses' polynomials");
  }
  for (const auto& numbers : powers) {
    const double high = static_cast<double>(numbers[0]);
    char text[40];
    to << "{";
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      std::snprintf(text, sizeof text, "%a, ", static_cast<double>(numbers[k]));
      to << text;
      if (k > 0) continue;
      std::snprintf(text, sizeof text, "%a, ", static_cast<double>(numbers[0] - high));
      to << text;
    }
    to << "},\n";
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 2) throw std::runtime_error("usage: ellipse_pieces ellipse_pieces.inc");
    std::ofstream to(argv[1]);
    to << "// Made by model/generators/ellipse_pieces.cpp.\n"
       << "constexpr int octaves = " << octaves << ", parts = " << parts << ", degree = " << degree
       << ";\nconstexpr double pieces[2 * octaves * parts * 3][degree + 2] = {\n";
    for (const bool is_exchanged : {false, true})
      for (int octave = 0; octave < octaves; ++octave)
        for (int part = 0; part < parts; ++part) write_piece(to, is_exchanged, octave, part);
    to << "};\n";
    if (!to.flush()) throw std::runtime_error("cannot write " + std::string(argv[1]));
  } catch (const std::exception& error) {
    std::cerr << "ellipse_pieces: " << error.what() << '\n';
    return 1;
  }
}
