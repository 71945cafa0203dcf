// SPDX-License-Identifier: Apache-2.0
// The root of load sharing (load_sharing.hpp) of one point in double: the method of
// load_sharing_vector-inl.hpp, which explains it, with a branch where a vector takes both ways.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "gaussian_moment_scalar.hpp"
#include "processor.hpp"
#include "sharing_method.hpp"
#include "tribo/load_sharing.hpp"
#include "tribo/sharing_root.hpp"

namespace tribo {
namespace {

using namespace scalar;
using detail::SharingRoot;
using detail::SharingSurface;

struct Asperities {
  double share;   // A
  double hazard;  // −d ln A/dλ
  double slope;   // of the hazard, ≥ 0
};

template <class Arithmetic>
[[gnu::always_inline]] inline Asperities asperities(const SharingSurface& surface, double lambda) {
  const double d = lambda - surface.offset;
  const bool below_zero = d < 0;
  const double x = std::min(below_zero ? -d : d, below_pieces_end);
  const auto [c, t] = piece_at(surface.order, below_zero, x);
  const double square = t * t;
  // E(t²) + t O(t²), and their derivatives in t²
  double even = c[13], odd = c[12], even_slope = 0, odd_slope = 0;
  for (int k = 11; k >= 3; k -= 2) {
    even_slope = Arithmetic::multiply_add(even_slope, square, even);
    odd_slope = Arithmetic::multiply_add(odd_slope, square, odd);
    even = Arithmetic::multiply_add(even, square, c[k]);
    odd = Arithmetic::multiply_add(odd, square, c[k - 1]);
  }
  even_slope = Arithmetic::multiply_add(even_slope, square, even);
  even = Arithmetic::multiply_add(even, square, c[0]);
  const double moment = Arithmetic::multiply_add(odd, t, even);
  const double log_slope =
      Arithmetic::multiply_add(2 * t, Arithmetic::multiply_add(odd_slope, t, even_slope), odd) /
      moment;
  const bool is_root = surface.order == Order::five_halves;
  const double exponent = is_root ? 0.5 : 1;
  const double n = 0.5 * twice(surface.order);
  // h = −d ln F_n/dd and h′ = h² − dh − n
  const double h = below_zero ? log_slope : x - log_slope;
  const double less_d = below_zero ? h + x : -log_slope;
  double share = surface.stiffness * moment;
  if (is_root) share = std::sqrt(share);
  if (!below_zero) share *= std::exp(-0.5 * exponent * (x * x));
  return {share, exponent * h, exponent * std::max(h * less_d - n, 0.0)};
}

// The same at λ₀ < near_zero, without the moments.
Asperities near_zero(const SharingSurface& surface, double flooded) {
  const double fall = flooded * (surface.hazard_at_zero + 0.5 * flooded * surface.slope_at_zero);
  const double share = surface.share_at_zero * (1 - fall * (1 - 0.5 * fall));
  return {share, surface.hazard_at_zero + flooded * surface.slope_at_zero, surface.slope_at_zero};
}

struct Iterate {
  double film_parameter, log_rise;  // λ, y = ln(λ/λ₀)
};

// A little above a floor, where A falls as e^{−hx} and (λ₀/λ)^p hardly changes.
Iterate above_floor(double floor, double hazard, double flooded) {
  const double w = 0.999 * std::exp(-sharing_p * std::log(floor / flooded));
  const double rate = sharing_p / floor * (w / (1 - w)) + hazard;
  const double lambda = floor - std::log1p(-w) / rate;
  return {lambda, std::log(lambda / flooded)};
}

Iterate jump_above_floor(const SharingSurface& surface, const Asperities& at, double flooded) {
  const double log_share = std::log(std::max(at.share, 1.0));
  const double root = std::sqrt(at.hazard * at.hazard + 2 * at.slope * log_share);
  const double log_at_zero =
      std::log(std::max(surface.stiffness * sharing_moment_at_zero(surface.order), 1.0));
  const double limit = surface.offset + std::sqrt(2 * log_at_zero);
  const double distance =
      std::min(2 * log_share / (at.hazard + root), std::max(limit - flooded, 0.0));
  return above_floor(flooded + distance, at.hazard + at.slope * distance, flooded);
}

template <class Arithmetic>
[[gnu::always_inline]] inline SharingRoot root_from(const SharingSurface& surface, double flooded,
                                                    Iterate now) {
  constexpr double p = sharing_p;
  for (int steps = 1; steps <= detail::max_sharing_steps; ++steps) {
    // The first step need not be exact where it is sure not to be the last.
    const bool is_rough = steps == 1 && flooded < surface.near_zero;
    const Asperities at = is_rough ? near_zero(surface, flooded)
                                   : asperities<Arithmetic>(surface, now.film_parameter);
    const double a = at.hazard * now.film_parameter;
    if (a * at.share >= sharing_pole_nearness * (1 - at.share) && now.log_rise == 0) {
      now = jump_above_floor(surface, at, flooded);
      continue;
    }
    const double py = p * now.log_rise;
    const double w = now.log_rise == 0 ? 1 : std::exp(-py);
    const double b = at.slope * now.film_parameter * now.film_parameter + a;
    double g, g1, g2;
    if (at.share > w) {
      const double rest = std::max(1 - w, 0x1p-60);
      const double r = w / rest;
      g = std::log(rest / at.share);
      g1 = p * r + a;
      g2 = b - p * p * (r + r * r);
    } else {
      const double rest = std::max(1 - at.share, 0x1p-60);
      const double r = at.share / rest;
      g = std::log(rest) + py;
      g1 = a * r + p;
      g2 = r * b - a * a * (r + r * r);
    }
    const double inverse = 1 / g1;
    const double newton = -g * inverse;
    const double t = 0.5 * newton * (g2 * inverse);
    const double step = newton * std::clamp(t * t - t + 1, 0.5, 2.0);
    const double bounded = std::clamp(step, sharing_least_step, sharing_greatest_step);
    const double rise = std::max(now.log_rise + bounded, 0.0);
    const bool is_near = rise < sharing_near_rise;
    const double base = is_near ? flooded : now.film_parameter;
    const double shift = is_near ? rise : bounded;  // rise − log_rise, unrounded
    now.log_rise = rise;
    if (std::fabs(shift) < 0x1p-8) {
      const double sum = 0.5 + shift * (1.0 / 6 + shift * (1.0 / 24 + shift * (1.0 / 120)));
      now.film_parameter = base + base * (shift + shift * shift * sum);
    } else {
      now.film_parameter = base * std::exp(shift);
    }
    if (std::fabs(newton) * std::max(p + a, g1) < 0x1p-17 && !is_rough)
      return {std::max(now.film_parameter, surface.floor), steps};
  }
  return {std::numeric_limits<double>::quiet_NaN(), detail::max_sharing_steps};
}

template <class Arithmetic>
[[gnu::always_inline]] inline SharingRoot root(const SharingSurface& surface, double flooded) {
  if (!(surface.stiffness >= sharing_least_stiffness &&
        surface.stiffness <= sharing_greatest_stiffness && surface.offset >= 0 &&
        surface.offset <= sharing_greatest_offset && flooded >= sharing_least_film &&
        flooded <= sharing_greatest_film))
    return {std::numeric_limits<double>::quiet_NaN(), 0};
  if (flooded >= surface.film_from) return {flooded, 0};
  if (flooded <= surface.floor_up_to) return {surface.floor, 0};
  const Iterate start = flooded < surface.floor
                            ? above_floor(surface.floor, surface.hazard, flooded)
                            : Iterate{flooded, 0};
  return root_from<Arithmetic>(surface, flooded, start);
}

[[gnu::target("fma")]] SharingRoot root_fused(const SharingSurface& surface, double flooded) {
  return root<Fused>(surface, flooded);
}
SharingRoot root_unfused(const SharingSurface& surface, double flooded) {
  return root<Unfused>(surface, flooded);
}

constinit auto chosen_root = &root_unfused;
[[maybe_unused]] const bool has_chosen = [] {
  if (detail::has_fma()) chosen_root = &root_fused;
  return true;
}();

}  // namespace

detail::SharingRoot detail::film_parameter(const SharingSurface& surface, double flooded) {
  return chosen_root(surface, flooded);
}

double film_parameter(AsperityModel model, double stiffness, double offset, double flooded) {
  SharingSurface surface{load_order(model), stiffness, offset, 0, 0};
  // sharing_film_from, squared
  surface.film_from = std::numeric_limits<double>::infinity();
  const double distance = flooded - offset;
  const auto exponent =
      static_cast<double>(std::bit_cast<std::int64_t>(stiffness) >> 52) - 1022;  // of K, and 1
  const double limit = detail::free_square + detail::free_square_slope * exponent;
  if (distance > 0 && distance * distance >= limit) surface.film_from = flooded;
  const double lambda = chosen_root(surface, flooded).film_parameter;
  if (lambda == lambda) return lambda;
  return LoadSharing<double>(model, stiffness, offset).film_parameter(flooded);
}

}  // namespace tribo
