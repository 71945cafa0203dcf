// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "conformance/wrong_parts.hpp"

namespace tribo::conformance {
namespace {

using Value = std::optional<double>;

// λ of ln λ − ln λ₀ + p ln(1 − (K F_n(λ − δ))^q) = 0, by bisection from where A < 1.
double shared_film(const SharingInputs& s, Order order, double q, double p) {
  const auto share = [&](double lambda) {
    return std::pow(s.stiffness * gaussian_moment(order, lambda - s.offset), q);
  };
  double floor = 0;
  if (share(0) >= 1) {
    double low = 0, high = std::max(s.offset, 0.0) + 50;
    for (int i = 0; i < 200; ++i) (share((low + high) / 2) >= 1 ? low : high) = (low + high) / 2;
    floor = high;
  }
  double low = floor, high = std::max(s.film, floor) + std::max(s.offset, 0.0) + 60;
  const auto is_below = [&](double lambda) {
    const double a = share(lambda);
    return a >= 1 || std::log(lambda / s.film) + p * std::log1p(-a) < 0;
  };
  for (int i = 0; i < 300; ++i) {
    const double middle = low > 0 && high > 4 * low ? std::sqrt(low * high) : (low + high) / 2;
    (is_below(middle) ? low : high) = middle;
  }
  return (low + high) / 2;
}

double film_exponent() { return 0.67 - 0.53; }
Order order_of(const SharingInputs& s) {
  return s.is_gt ? Order::five_halves : Order::three_halves;
}
double exponent_of(const SharingInputs& s) { return s.is_gt ? 0.5 : 1.0; }
Value usual(const SharingInputs& s) {
  return shared_film(s, order_of(s), exponent_of(s), film_exponent());
}

}  // namespace

std::vector<WrongSharing> wrong_sharings() {
  return {
      {"sharing-none", "λ = λ₀, no load sharing",
       [](const SharingInputs& s) -> Value { return s.film; }},
      {"sharing-q-1", "A = K F with Greenwood and Tripp, q = 1 in place of 1/2",
       [](const SharingInputs& s) -> Value {
         if (!s.is_gt) return std::nullopt;
         return shared_film(s, order_of(s), 1, film_exponent());
       }},
      {"sharing-q-1/2", "A = √(K F) with Greenwood and Williamson, q = 1/2 in place of 1",
       [](const SharingInputs& s) -> Value {
         if (s.is_gt) return std::nullopt;
         return shared_film(s, order_of(s), 0.5, film_exponent());
       }},
      {"sharing-exponent-0.67", "the film's exponent 0.67 in place of 0.67 − 0.53 = 0.14",
       [](const SharingInputs& s) -> Value {
         return shared_film(s, order_of(s), exponent_of(s), 0.67);
       }},
      {"sharing-offset-ignored", "F at λ in place of λ − δ",
       [](SharingInputs s) -> Value {
         s.offset = 0;
         return usual(s);
       }},
      {"sharing-offset-doubled", "F at λ − 2δ in place of λ − δ",
       [](SharingInputs s) -> Value {
         s.offset *= 2;
         return usual(s);
       }},
      {"sharing-offset-added", "F at λ + δ in place of λ − δ",
       [](SharingInputs s) -> Value {
         s.offset = -s.offset;
         return usual(s);
       }},
      {"sharing-stiffness-halved", "K/2: 8√2/15 in place of 16√2/15",
       [](SharingInputs s) -> Value {
         s.stiffness /= 2;
         return usual(s);
       }},
      {"sharing-stiffness-doubled", "2K: E′ = 2E* in the asperities' load",
       [](SharingInputs s) -> Value {
         s.stiffness *= 2;
         return usual(s);
       }},
      {"sharing-order-3/2", "F_3/2 in place of F_5/2 with Greenwood and Tripp",
       [](const SharingInputs& s) -> Value {
         if (!s.is_gt) return std::nullopt;
         return shared_film(s, Order::three_halves, 0.5, film_exponent());
       }},
      {"sharing-gw-for-gt", "Greenwood and Williamson's F_3/2 and q = 1 for Greenwood and Tripp",
       [](const SharingInputs& s) -> Value {
         if (!s.is_gt) return std::nullopt;
         return shared_film(s, Order::three_halves, 1, film_exponent());
       }},
      {"sharing-gt-for-gw", "Greenwood and Tripp's F_5/2 and q = 1/2 for Greenwood and Williamson",
       [](const SharingInputs& s) -> Value {
         if (s.is_gt) return std::nullopt;
         return shared_film(s, Order::five_halves, 0.5, film_exponent());
       }}};
}

}  // namespace tribo::conformance
