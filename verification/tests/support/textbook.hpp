// SPDX-License-Identifier: Apache-2.0
// The whole model a second time, as a careful reader of the textbooks would write it: formulas in
// full, GSL's quadrature and Brent's method, no shared code with model/. Good to about 1e-9.
#pragma once

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_roots.h>
#include <gsl/gsl_sf_ellint.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "tribo/scene.hpp"

namespace tribo::verification::textbook {

struct Point {
  double film_flooded, film, asperity_share, real_area_ratio, summit_count, friction;
};

inline double brent(const std::function<double(double)>& f, double low, double high) {
  gsl_function function{
      [](double x, void* p) { return (*static_cast<const std::function<double(double)>*>(p))(x); },
      const_cast<std::function<double(double)>*>(&f)};
  gsl_root_fsolver* solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
  gsl_root_fsolver_set(solver, &function, low, high);
  for (int i = 0; i < 300; ++i) {
    gsl_root_fsolver_iterate(solver);
    if (gsl_root_test_interval(gsl_root_fsolver_x_lower(solver), gsl_root_fsolver_x_upper(solver),
                               0, 1e-14) == GSL_SUCCESS)
      break;
  }
  const double root = gsl_root_fsolver_root(solver);
  gsl_root_fsolver_free(solver);
  return root;
}

// GSL: QAGIU for F_p written with pow, Brent for the root.
class LoadSharing {
 public:
  LoadSharing(AsperityModel model, double stiffness, double offset, double exponent)
      : is_tripp_(model == AsperityModel::greenwood_tripp),
        stiffness_(stiffness),
        offset_(offset),
        exponent_(exponent) {
    gsl_set_error_handler_off();
  }

  static double moment(double order, double d) {
    double parameters[] = {order, d}, value = 0, error = 0;
    gsl_function integrand{[](double s, void* p) {
                             const double* n_and_d = static_cast<const double*>(p);
                             return std::pow(s - n_and_d[1], n_and_d[0]) * std::exp(-s * s / 2) /
                                    std::sqrt(2 * M_PI);
                           },
                           parameters};
    gsl_integration_workspace* workspace = gsl_integration_workspace_alloc(2000);
    gsl_integration_qagiu(&integrand, d, 0, 1e-11, 2000, workspace, &value, &error);
    gsl_integration_workspace_free(workspace);
    return value;
  }

  double asperity_share(double lambda) const {
    const double load = stiffness_ * moment(is_tripp_ ? 2.5 : 1.5, lambda - offset_);
    return is_tripp_ ? std::sqrt(load) : load;
  }

  // The root λ of ln λ − ln λ₀ + e ln(1 − A). Where A ≥ 1 the function counts as −∞.
  double solve(double lambda0) const {
    const auto residual = [&](double lambda) {
      const double share = asperity_share(lambda);
      return share >= 1 ? -1e3 : std::log(lambda / lambda0) + exponent_ * std::log1p(-share);
    };
    double high = lambda0 * 2;
    while (residual(high) < 0) high *= 2;
    return brent(residual, lambda0 / 2, high);
  }

 private:
  bool is_tripp_;
  double stiffness_, offset_, exponent_;
};

// h*/h_ff, from the equations for φ, ψ and h* solved together.
inline double starved_over_flooded(const Scene& scene, double flooded, double inlet) {
  const auto fit = [](double psi) { return 2 / M_PI * std::atan(2.7 * psi); };
  switch (scene.closures.starvation) {
    case StarvationClosure::flooded_inlet: {
      // h_oil = h_ff (1 + (4√2/3) φ^{3/2})
      if (inlet <= flooded) return 0;
      return fit(std::pow((inlet / flooded - 1) * 3 / (4 * std::sqrt(2.0)), 2.0 / 3));
    }
    case StarvationClosure::starved_inlet:
      return brent(
          [&](double y) {
            // φ at h* is ψ at h_ff scaled by (h_ff/h*)^{2/3}
            const double phi =
                std::pow((inlet / (y * flooded) - 1) * 3 / (4 * std::sqrt(2.0)), 2.0 / 3);
            return y - fit(phi * std::pow(y, 2.0 / 3));
          },
          1e-12, std::min(1.0, inlet / flooded) * (1 - 1e-15));
    case StarvationClosure::printed_exponents: {
      // Solved for ln y: φ^{3/2} = ψ^{3/2} y^{−9/4}, h_oil = h* (1 + (4√2/3) φ^{3/2}).
      const double log_y = brent(
          [&](double t) {
            const double y = std::exp(t);
            const double psi = std::tan(M_PI * y / 2) / 2.7;
            return std::log(
                       y * (1 + 4 * std::sqrt(2.0) / 3 * std::pow(psi, 1.5) * std::pow(y, -2.25))) -
                   std::log(inlet / flooded);
          },
          -40, -1e-13);
      return std::exp(log_y);
    }
    case StarvationClosure::damiens: {
      const double rho = inlet / flooded;
      return rho / std::pow(1 + std::pow(rho, scene.closures.damiens_exponent),
                            1 / scene.closures.damiens_exponent);
    }
    case StarvationClosure::solved:
      break;  // no closed form
  }
  return 0;
}

// k = a_y/a_x of Hertz' ellipse, from GSL's elliptic integrals of modulus e, e² = 1 − 1/k².
struct Ellipse {
  double k, second_integral;
};
inline Ellipse ellipse(double radius_ratio) {
  const bool is_exchanged = radius_ratio < 1;
  const double alpha = is_exchanged ? 1 / radius_ratio : radius_ratio;
  const auto integrals = [](double k) {
    const double e = std::sqrt(1 - 1 / (k * k));
    return std::pair(gsl_sf_ellint_Kcomp(e, GSL_PREC_DOUBLE),
                     gsl_sf_ellint_Ecomp(e, GSL_PREC_DOUBLE));
  };
  const auto excess = [&](double k) {
    const auto [first, second] = integrals(k);
    return (k * k * second - first) / (first - second) - alpha;
  };
  const double k = alpha == 1 ? 1 : brent(excess, 1 + 1e-7, 2 * alpha);
  return {is_exchanged ? 1 / k : k, k == 1 ? M_PI / 2 : integrals(k).second};
}

// Constant c, exponents of U, G and W, and side leakage 1 − m e^{−nk} of film formulas, in the
// order of FilmFormula; formulas without exponents are left out.
struct FilmFit {
  double c, u, g, w, m, n;
};
inline constexpr FilmFit film_fits[] = {{2.69, 0.67, 0.53, -0.067, 0.61, 0.73},
                                        {3.63, 0.68, 0.49, -0.073, 1, 0.68},
                                        {7.32, 0.64, 0, -0.22, 0.72, 0.28},
                                        {7.43, 0.65, 0, -0.21, 0.85, 0.31},
                                        {2.65, 0.7, 0.54, -0.13, 0, 0},
                                        {3.06, 0.69, 0.56, -0.1, 0, 0},
                                        {1.714, 0.694, 0.568, -0.128, 0, 0},
                                        {2.922, 0.692, 0.47, -0.166, 0, 0},
                                        {1.95, 8.0 / 11, 8.0 / 11, -1.0 / 11, 0, 0},
                                        {},
                                        {},
                                        {}};
static_assert(std::size(film_fits) == named_film_laws.size());

inline Point solve(const Scene& scene, double u) {
  const Surface& s = scene.surface;
  const Bodies& b = scene.bodies;
  const bool tripp = scene.closures.asperity == AsperityModel::greenwood_tripp;
  double radius = b.reduced_radius, k = b.ellipticity, load_length = radius;
  double area = M_PI * std::pow(3 * scene.load * radius / (4 * b.effective_modulus), 2.0 / 3);
  if (b.radius_y > 0) {
    const Ellipse shape = ellipse(b.radius_y / b.radius_x);
    k = shape.k;
    load_length = radius = b.radius_x;
    const double greater = std::max(k, 1 / k);
    const double r = 1 / (1 / b.radius_x + 1 / b.radius_y);
    const double minor = std::cbrt(3 * shape.second_integral * scene.load * r /
                                   (M_PI * greater * b.effective_modulus));
    area = M_PI * minor * minor * greater;
  } else if (b.length > 0) {
    radius = b.radius_x;
    load_length = b.length;
    area = 4 * std::sqrt(scene.load / b.length * radius / (M_PI * b.effective_modulus)) * b.length;
  }
  const double nbs = s.summit_density * s.summit_radius * s.summit_height_sd;
  const double stiffness = tripp ? 16 * std::sqrt(2.0) * M_PI / 15 * nbs * nbs *
                                       std::sqrt(s.summit_height_sd / s.summit_radius) *
                                       b.effective_modulus * area / scene.load
                                 : 4.0 / 3 * s.summit_density * std::sqrt(s.summit_radius) *
                                       std::pow(s.summit_height_sd, 1.5) * b.effective_modulus *
                                       area / scene.load;
  const double offset = s.offset_planes * s.summit_plane_offset;
  const double e2 = 2 * b.effective_modulus;
  const double speed_number = scene.lubricant.viscosity * u / (e2 * radius);
  const double material_number = scene.lubricant.pressure_viscosity * e2;
  const double load_number = scene.load / (e2 * radius * load_length);
  const FilmFit& fit = film_fits[static_cast<std::size_t>(scene.closures.film)];
  const double h0 = radius * fit.c * std::pow(speed_number, fit.u) *
                    std::pow(material_number, fit.g) * std::pow(load_number, fit.w) *
                    (1 - fit.m * std::exp(-fit.n * k));
  const LoadSharing sharing(scene.closures.asperity, stiffness, offset, fit.u - fit.g);
  const double flooded = sharing.solve(h0 / s.summit_height_sd) * s.summit_height_sd;
  double film = flooded;
  if (scene.supply.kind != SupplyKind::flooded) {
    const double inlet = scene.supply.kind == SupplyKind::inlet_film ? scene.supply.value
                         : scene.supply.kind == SupplyKind::inlet_film_ratio
                             ? scene.supply.value * s.summit_height_sd
                             : scene.supply.value / u;
    film = flooded * starved_over_flooded(scene, flooded, inlet);
  }
  const auto share_at = [&](double lambda) { return sharing.asperity_share(lambda); };
  double separation = film / s.summit_height_sd;
  double share = share_at(separation);
  if (share >= 1) {
    separation = brent([&](double x) { return share_at(x) - 1; }, separation, offset + 40);
    share = 1;
  }
  const double d = separation - offset;
  Point point{flooded, film, share, 0, 0, 0};
  point.real_area_ratio =
      tripp ? M_PI * M_PI * nbs * nbs * sharing.moment(2, d) : M_PI * nbs * sharing.moment(1, d);
  point.summit_count = tripp ? 4 * M_PI * nbs * s.summit_density * area * sharing.moment(1, d)
                             : s.summit_density * area * sharing.moment(0, d);
  const double pressure = (1 - share) * scene.load / area;
  const double eta0 = scene.lubricant.viscosity, alpha = scene.lubricant.pressure_viscosity;
  double eta = eta0;
  if (scene.friction.viscosity == ViscosityLaw::barus) eta = eta0 * std::exp(alpha * pressure);
  if (scene.friction.viscosity == ViscosityLaw::roelands) {
    const double scale = std::log(eta0) + 9.67, z = alpha * 0.196e9 / scale;
    eta = eta0 * std::exp(scale * (std::pow(1 + pressure / 0.196e9, z) - 1));
  }
  const double rate = scene.friction.slide_roll_ratio * u / (separation * s.summit_height_sd);
  const double tau0 = *scene.lubricant.eyring_stress;
  const double tau = scene.friction.fluid == FluidShear::eyring
                         ? tau0 * std::asinh(eta * rate / tau0)
                         : tau0 * (1 - std::exp(-eta * rate / tau0));
  point.friction = *scene.friction.boundary_coefficient * share +
                   tau * area * std::max(0.0, 1 - point.real_area_ratio) / scene.load;
  return point;
}

}  // namespace tribo::verification::textbook
