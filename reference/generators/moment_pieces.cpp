// SPDX-License-Identifier: Apache-2.0
// Makes model/src/gaussian_moment_pieces.inc: the polynomials of F_n in double, with a proven bound
// of their error. A piece's row has 12 numbers: three vectors of four, which the engine transposes.
//
//   S_n(d) = e^{d²/2} F_n(d) for d ≥ 0,  F_n(d) for d < 0,  |d| < 45,
//
// in pieces of |d| + 3 with equal widths in each binade. Each piece has the interpolant at its
// Chebyshev nodes, as a polynomial in t = |d| − centre. The constant coefficient is a sum of two
// doubles.
//
// The interpolant of degree N has an error of at most 4 M ρ^−N/(ρ−1), where M is the greatest |f|
// on the Bernstein ellipse of parameter ρ around the piece. F_n and S_n are entire. With z = x + iy
// their integrals give |S_n(z)| ≤ S_n(x) and |F_n(z)| ≤ e^{y²/2} F_n(x). Both bounds fall with x,
// so that the ellipse's left end and its height bound M. Far below 0 a path down to the real axis
// and then along it gives a better bound: with a standard normal variable X, |F_n(x+iy)| ≤
// |y|^{n+1} e^{(y²−x²)/2}/√2π + (E(|X| + |x| + |y|)⁴)^{n/4}. The error by the rounding of the
// coefficients is added.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <fstream>
#include <iostream>
#include <numbers>
#include <vector>

#include "generators/moments.hpp"

using tribo::reference::Ball;

namespace {

constexpr int pieces_a_binade = 32;    // binades of |d| + 3
constexpr double shift = 3, end = 48;  // range of |d| + 3
constexpr int degree = 10;

constexpr int powers = 128;

struct Piece {
  double centre, half_width;  // in |d|
};

std::vector<Piece> pieces() {
  std::vector<Piece> all;
  for (double binade = 2; binade < end; binade *= 2)
    for (int i = 0; i < pieces_a_binade; ++i) {
      const double width = binade / pieces_a_binade;
      const double low = binade + i * width;
      if (low < shift || low >= end) continue;
      all.push_back({low + width / 2 - shift, width / 2});
    }
  return all;
}

// f at |d| = x on one side of 0.
Ball value(int twice_n, bool below_zero, const Ball& x) {
  if (!below_zero) return tribo::reference::scaled_moment_by_hypergeometric(twice_n, x);
  return tribo::reference::moment_by_hypergeometric(twice_n, -x);
}

struct Polynomial {
  std::vector<double> coefficients;  // c0 high, c0 low, c1, c2, …
  double relative_error;             // proven, over the piece
};

// Coefficients in t of Σ a_k T_k(t/w).
std::vector<Ball> powers_of(const std::vector<Ball>& chebyshev, double half_width) {
  const std::size_t count = chebyshev.size();
  std::vector<Ball> sum(count), before(count), current(count);
  before[0] = 1;
  current[1] = 1;
  sum[0] = chebyshev[0];
  for (std::size_t k = 1; k < count; ++k) {
    for (std::size_t i = 0; i < count; ++i) sum[i] += chebyshev[k] * current[i];
    std::vector<Ball> next(count);
    for (std::size_t i = 0; i < count; ++i)
      next[i] = (i == 0 ? Ball(0) : Ball(2) * current[i - 1]) - before[i];
    before = std::move(current);
    current = std::move(next);
  }
  Ball scale = 1;
  for (Ball& coefficient : sum) {
    coefficient *= scale;
    scale /= Ball(half_width);
  }
  return sum;
}

// A bound of |F_n(−x ± iy)| for x in [near, far] and 0 ≤ y ≤ height.
Ball greatest_below_zero(int twice_n, double near, double far, double height) {
  const Ball y = height;
  const Ball upright =
      exp(y * y / 2) * tribo::reference::moment_by_hypergeometric(twice_n, Ball(-far));
  if (!(near > 0)) return upright;
  const Ball n = tribo::reference::fraction(twice_n, 2);
  const Ball mean = sqrt(Ball(2) / tribo::reference::ball_pi());  // E|X|; E|X|³ is twice that
  const Ball l = Ball(far) + y;
  const Ball fourth =
      l * l * l * l + 4 * mean * l * l * l + 6 * l * l + 4 * (2 * mean) * l + Ball(3);
  const Ball down = pow(y, n + 1) * exp((y * y - Ball(near) * Ball(near)) / 2) /
                    sqrt(2 * tribo::reference::ball_pi());
  const Ball around = down + pow(fourth, n / 4);
  return around < upright ? around : upright;
}

// A bound of |f| on the Bernstein ellipse. Below zero it is the greatest of the bounds on its arcs.
Ball greatest_on_ellipse(int twice_n, bool below_zero, const Piece& piece, double rho) {
  const double reach = piece.half_width * (rho + 1 / rho) / 2;
  const double height = piece.half_width * (rho - 1 / rho) / 2;
  if (!below_zero) {
    const Ball x = Ball(piece.centre - reach);
    return x >= 0 ? value(twice_n, false, x)
                  : exp(x * x / 2) * tribo::reference::moment_by_hypergeometric(twice_n, x);
  }
  constexpr int arcs = 16;
  Ball greatest = 0;
  for (int i = 0; i < arcs; ++i) {
    const double from = std::numbers::pi * i / arcs, to = std::numbers::pi * (i + 1) / arcs;
    // A little wider than the arc, because cosines are rounded.
    const double far = piece.centre + reach * std::cos(from) + 1e-9;
    const double near = piece.centre + reach * std::cos(to) - 1e-9;
    const double top = from < std::numbers::pi / 2 && to > std::numbers::pi / 2
                           ? 1.0
                           : std::max(std::sin(from), std::sin(to));
    const Ball here = greatest_below_zero(twice_n, near, far, height * top + 1e-9);
    if (here > greatest) greatest = here;
  }
  return greatest;
}

// The least proven truncation error over a range of ρ.
double truncation_error(int twice_n, bool below_zero, const Piece& piece, const Ball& least) {
  double best = INFINITY;
  for (double rho = 3; rho < 1000; rho *= 1.2) {
    if (!below_zero && piece.centre - piece.half_width * rho / 2 < -12) break;
    const Ball error = Ball(4) * greatest_on_ellipse(twice_n, below_zero, piece, rho) *
                       pow(Ball(rho), Ball(-degree)) / (Ball(rho) - 1) / least;
    best = std::min(best, error.upper_bound());
  }
  return best;
}

Polynomial fit(int twice_n, bool below_zero, const Piece& piece) {
  constexpr int count = degree + 1;
  std::vector<Ball> values(static_cast<std::size_t>(count));
  std::vector<std::vector<Ball>> cosines(values.size(), std::vector<Ball>(values.size()));
  for (int j = 0; j < count; ++j)
    for (int k = 0; k < count; ++k) {
      Ball angle = tribo::reference::ball_pi() * k * (2 * j + 1) / (2 * count);
      Ball cosine;
      arb_cos(cosine.get(), angle.get(), tribo::reference::ball_precision);
      cosines[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)] = cosine;
    }
  for (std::size_t j = 0; j < values.size(); ++j)
    // The node's midpoint is 2^−300 from the node: far below the errors that are added.
    values[j] = value(twice_n, below_zero,
                      (Ball(piece.centre) + Ball(piece.half_width) * cosines[j][1]).midpoint());
  std::vector<Ball> chebyshev(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    for (std::size_t j = 0; j < values.size(); ++j) chebyshev[k] += values[j] * cosines[j][k];
    chebyshev[k] *= Ball(k == 0 ? 1 : 2) / Ball(count);
  }
  const std::vector<Ball> exact = powers_of(chebyshev, piece.half_width);
  // The least value on the piece: f is monotone.
  const Ball at_low = value(twice_n, below_zero, Ball(piece.centre - piece.half_width));
  const Ball at_high = value(twice_n, below_zero, Ball(piece.centre + piece.half_width));
  const Ball least = at_low < at_high ? at_low : at_high;

  Polynomial result;
  const double high = exact[0].nearest();
  result.coefficients = {high, (exact[0] - Ball(high)).nearest()};
  Ball rounding = abs(exact[0] - Ball(high) - Ball(result.coefficients[1]));
  Ball power = 1;
  for (std::size_t k = 1; k < exact.size(); ++k) {
    power *= Ball(piece.half_width);
    result.coefficients.push_back(exact[k].nearest());
    rounding += abs(exact[k] - Ball(result.coefficients.back())) * power;
  }
  result.relative_error =
      truncation_error(twice_n, below_zero, piece, least) + Ball(rounding / least).upper_bound();
  return result;
}

// The polynomials of all orders on both sides of 0, a piece a row.
std::string table() {
  double worst = 0;
  std::string text;
  for (int twice_n = 0; twice_n <= 5; ++twice_n) {
    text += "{";
    for (const bool below_zero : {false, true}) {
      text += "{\n";
      for (const Piece& piece : pieces()) {
        const Polynomial polynomial = fit(twice_n, below_zero, piece);
        worst = std::max(worst, polynomial.relative_error);
        text += fmt::format("{{{:a}}},\n", fmt::join(polynomial.coefficients, ","));
      }
      text += "},";
    }
    text += "},\n";
    std::cerr << fmt::format("order {}/2, error so far below {:.3g}\n", twice_n, worst);
  }
  return fmt::format(
      "\n// |polynomial − f| ≤ {:.3g} |f|, {:.3f} ulp\n"
      "alignas(32) inline constexpr double pieces[6][2][{}][{}] = {{\n{}}};\n",
      worst, worst * 0x1p52, pieces().size(), degree + 2, text);
}

// 2^{−j/128} as a double, and its relative rounding error, for e^{−d²/2}.
std::string powers_of_two() {
  std::string text =
      fmt::format("\nalignas(16) inline constexpr double powers_of_two[{}][2] = {{\n", powers);
  for (int j = 0; j < powers; ++j) {
    const Ball power = pow(Ball(2), -tribo::reference::fraction(j, powers));
    const double high = power.nearest();
    text += fmt::format("{{{:a},{:a}}},\n", high, ((power - Ball(high)) / Ball(high)).nearest());
  }
  return text + "};\n";
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Makes the polynomials of the double kernels of F_n, with their proven error"};
  app.footer("Example:\n  generate_moment_pieces model/src");
  std::string folder;
  app.add_option("folder", folder, "where to write")->required()->check(CLI::ExistingDirectory);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  const std::string path = folder + "/gaussian_moment_pieces.inc";
  std::ofstream file(path);
  file << "// SPDX-License-Identifier: Apache-2.0\n"
          "// Made by reference/generators/moment_pieces.cpp, which says what these are and why "
          "the\n"
          "// errors are proven. [order][d < 0][piece][c0 high, c0 low, c1, c2, …]\n"
          "// clang-format off\n"
       << table() << powers_of_two();
  if (file.flush()) return 0;
  std::cerr << path << ": cannot be written\n";
  return 2;
}
