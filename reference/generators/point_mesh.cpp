// SPDX-License-Identifier: Apache-2.0
#include "generators/point_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tribo::reference {
namespace {

// The hat function of a node, which stands at the second of three places.
struct Hat {
  std::array<double, 3> place, bend;    // bend: how much its slope rises at each place
  std::array<double, 2> point, weight;  // Gauss' rule of two points with the hat as weight
  double size;                          // the greater distance to a neighbour
};
Hat hat(double before, double here, double after) {
  const double l = here - before, r = after - here;
  Hat hat{{before, here, after}, {1 / l, -1 / l - 1 / r, 1 / r}, {}, {}, std::fmax(l, r)};
  const double m0 = (l + r) / 2, m1 = (r * r - l * l) / 6, m2 = (l * l * l + r * r * r) / 12,
               m3 = (std::pow(r, 4) - std::pow(l, 4)) / 20;
  // With the hat as weight t² + bt + c is orthogonal to 1 and t: its roots are Gauss' points.
  const double det = m1 * m1 - m0 * m2, b = (m0 * m3 - m1 * m2) / det,
               c = (m2 * m2 - m1 * m3) / det, root = std::sqrt(b * b / 4 - c);
  const double t0 = -b / 2 - root, t1 = -b / 2 + root;
  hat.point = {here + t0, here + t1};
  hat.weight[1] = (m1 - t0 * m0) / (t1 - t0);
  hat.weight[0] = m0 - hat.weight[1];
  return hat;
}

// The fourth integral F of 1/r: ∂⁴F/∂x²∂y² = 1/r.
double potential(double x, double y) {
  x = std::fabs(x);
  y = std::fabs(y);
  const double r = std::hypot(x, y);
  double f = -r * r * r / 6;
  if (x > 0 && y > 0) f += x * y / 2 * (x * std::log((y + r) / x) + y * std::log((x + r) / y));
  return f;
}

double film_of(const Hat& u, const Hat& v, double x, double y) {
  const double dx = u.place[1] - x, dy = v.place[1] - y, size = std::fmax(u.size, v.size);
  double film = 0;
  if (dx * dx + dy * dy > 50 * size * size) {
    for (std::size_t k = 0; k < 2; ++k)
      for (std::size_t n = 0; n < 2; ++n)
        film +=
            u.weight[k] * v.weight[n] /
            std::sqrt((u.point[k] - x) * (u.point[k] - x) + (v.point[n] - y) * (v.point[n] - y));
    return film;
  }
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t n = 0; n < 3; ++n)
      film += u.bend[k] * v.bend[n] * potential(u.place[k] - x, v.place[n] - y);
  return film;
}

}  // namespace

Nodes graded(double start, double end, double even, double width, double step) {
  Nodes nodes{0};
  const auto add_side = [&](double last, double sign) {
    const double farther = last > even ? width * std::asinh((last - even) / width) : 0;
    const Index count = std::lround((std::fmin(last, even) + farther) / step);
    const double stretch = farther / (static_cast<double>(count) * step - even);
    for (Index i = 1; i <= count; ++i) {
      const double s = static_cast<double>(i) * step;
      nodes.push_back(sign *
                      (s <= even ? s : even + width * std::sinh(stretch * (s - even) / width)));
    }
  };
  add_side(start, -1);
  std::ranges::reverse(nodes);
  add_side(end, 1);
  return nodes;
}

FilmMatrix film_matrix(const PointMesh& mesh) {
  FilmMatrix k = FilmMatrix::Zero(mesh.size(), mesh.size());
  std::vector<Hat> us, vs, mirrored;
  for (std::size_t i = 1; i + 1 < mesh.x.size(); ++i)
    us.push_back(hat(mesh.x[i - 1], mesh.x[i], mesh.x[i + 1]));
  vs.push_back(hat(-mesh.y[1], 0, mesh.y[1]));
  mirrored.push_back(vs[0]);
  for (std::size_t j = 1; j + 1 < mesh.y.size(); ++j) {
    vs.push_back(hat(mesh.y[j - 1], mesh.y[j], mesh.y[j + 1]));
    mirrored.push_back(hat(-mesh.y[j + 1], -mesh.y[j], -mesh.y[j - 1]));
  }
  for (Index j = 0; j < mesh.ny(); ++j)
    for (Index i = 0; i < mesh.nx(); ++i)
      for (Index n = 0; n + 1 < mesh.ny(); ++n)
        for (Index m = 1; m + 1 < mesh.nx(); ++m) {
          double film = film_of(us[at(m - 1)], vs[at(n)], mesh.x[at(i)], mesh.y[at(j)]);
          if (n > 0) film += film_of(us[at(m - 1)], mirrored[at(n)], mesh.x[at(i)], mesh.y[at(j)]);
          k(mesh.node(i, j), mesh.node(m, n)) = static_cast<float>(film);
        }
  return k;
}

}  // namespace tribo::reference
