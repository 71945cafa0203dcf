// SPDX-License-Identifier: Apache-2.0
// How the film depends on the speed at the ends of the ranges, where one term is far greater than
// the others. The comment above each limit proves a bound on the distance to the limit, and in most
// cases also a lower bound, so that no window is loose. Slopes come from automatic differentiation
// in 50 digits, and the tests allow for nothing but the rounding of these digits.
#include <gtest/gtest.h>

#include "support/autodiff.hpp"
#include "support/judge.hpp"
#include "support/scenes.hpp"
#include "tribo/onset.hpp"

namespace tribo::verification {
namespace {

using enum StarvationClosure;

// The accuracy of a slope in 50 digits. Some are lost in 1 − A, and in s + σ·d ln r/d ln u, where σ
// is d ln y/d ln r.
const Reference digits("1e-45");

// Is low ≤ got ≤ high, up to rounding?
testing::AssertionResult is_between(const Reference& low, const Reference& got,
                                    const Reference& high, std::initializer_list<Input> inputs) {
  const Reference rounding = digits * (1 + abs(low) + abs(high));
  const Reference part = abs(got - (low + high) / 2) / ((high - low) / 2 + rounding);
  record_part_of_bound(static_cast<double>(part));
  if (part <= 1) return testing::AssertionSuccess();
  return testing::AssertionFailure()
         << describe(inputs) << "\n  " << got.str(12) << " is not between " << low.str(12)
         << " and " << high.str(12);
}

const Reference film_exponent("0.67");
const Reference sharing_exponent_of_film("0.14");

// Two-sided bounds on A and on −d ln A/dλ, for d = λ − δ > 0 and the order p of F_p in the load.
//   F_p(d) = φ(d) ∫ t^p e^{−td−t²/2} dt lies between φ(d)Γ(p+1)d^{−p−1}(1 − (p+1)(p+2)/(2d²)) and
//   φ(d)Γ(p+1)d^{−p−1}, because 1 − t²/2 ≤ e^{−t²/2} ≤ 1. It is also below F_p(0)e^{−d²/2}, because
//   e^{−td} ≤ 1. −F_p′/F_p is d + F_{p+1}/F_p. This quotient is the mean of t with the weight
//   t^p e^{−td−t²/2}; it is positive, and below the mean without e^{−t²/2}, which is (p+1)/d.
struct ShareBounds {
  Reference share_low, share_high, hazard_low, hazard_high;
};
bool is_tripp(AsperityModel model) { return model == AsperityModel::greenwood_tripp; }
Reference order_of(AsperityModel model) { return is_tripp(model) ? 2.5 : 1.5; }
Reference root_of(AsperityModel model) { return is_tripp(model) ? 0.5 : 1; }
ShareBounds share_bounds(AsperityModel model, const Reference& stiffness, const Reference& d) {
  const Reference p = order_of(model), q = root_of(model);
  const Reference root_pi = sqrt(pi<Reference>());
  const Reference gamma = is_tripp(model) ? 15 * root_pi / 8 : 3 * root_pi / 4;  // Γ(p+1)
  // F_p(0) = 2^{p/2−1} Γ((p+1)/2)/√π, with Γ(7/4) and Γ(5/4)
  const Reference at_zero = pow(Reference(2), p / 2 - 1) * tgamma(Reference((p + 1) / 2)) / root_pi;
  const Reference decay = exp(-d * d / 2);
  const Reference leading = decay / sqrt(2 * pi<Reference>()) * gamma * pow(d, -p - 1);
  const Reference correction = 1 - (p + 1) * (p + 2) / (2 * d * d);
  const Reference high = std::min(leading, Reference(at_zero * decay));
  const Reference low = correction > 0 ? Reference(leading * correction) : Reference(0);
  return {pow(Reference(stiffness * low), q), pow(Reference(stiffness * high), q), q * d,
          q * (d + (p + 1) / d)};
}

// 0.67 − s = 0.67 m/(1 + m), where s = d ln h/d ln u = 0.67/(1 + m) and m = 0.14 λ|A′|/(1 − A).
struct SlopeDeficit {
  Reference low, high;
};
SlopeDeficit flooded_slope_deficit(AsperityModel model, const Reference& stiffness,
                                   const Reference& offset, const Reference& lambda) {
  const ShareBounds b = share_bounds(model, stiffness, lambda - offset);
  const Reference m_low = sharing_exponent_of_film * lambda * b.share_low * b.hazard_low;
  const Reference m_high =
      sharing_exponent_of_film * lambda * b.share_high * b.hazard_high / (1 - b.share_high);
  return {film_exponent * m_low / (1 + m_high), film_exponent * m_high};
}

TEST(Asymptotics, FloodedFilmTendsToTheSlope067AsTheAsperitiesLetGo) {
  for (const auto model : asperity_models)
    for (const PaperSurface surface : paper_surfaces) {
      Scene scene = paper_scene(surface, model);
      scene.supply = {};
      const MixedContact<Reference> contact(scene);
      const LoadSharing<Reference>& sharing = contact.sharing();
      for (const double above : {2.5, 4.0, 6.0, 10.0}) {
        const Reference lambda = sharing.offset() + above;
        const Reference u = contact.speed_at(
            sharing.flooded_film_parameter(lambda, Reference(1 - sharing.asperity_share(lambda))));
        const SlopeDeficit bounds =
            flooded_slope_deficit(model, sharing.stiffness(), sharing.offset(), lambda);
        EXPECT_TRUE(is_between(bounds.low, film_exponent - film_log_slope(scene, u), bounds.high,
                               {{"d", above}}));
        // The quotient of the two bounds is 1 − O(1/d²).
        if (above > 5) {
          EXPECT_LT(bounds.high, 2 * bounds.low) << describe({{"d", above}});
        }
      }
    }
}

// At the floor A is 1. With w = 1 − A = (λ₀/λ)^{1/0.14} ≤ (λ₀/λ_b)^{1/0.14} the slope is
//   s = 0.67 w/(w + 0.14 λ|A′|) ≤ 0.67 w/(0.14 (1−w) λ_b H),
// where H is the least −d ln A/dλ = q p F_{p−1}/F_p, which grows with d. F_p/F_{p−1} is the mean of
// t with the weight t^{p−1}e^{−(t+d)²/2}. From d = 0 to d < 0 this mean grows by at most |d|,
// because the variance of t is below 1 (Brascamp and Lieb).
TEST(Asymptotics, FilmOnTheFloorTendsToTheSlope0) {
  Scene scene = paper_scene(PaperSurface::rough, AsperityModel::greenwood_williamson);
  scene.supply = {};
  scene.surface.offset_planes = 2;
  for (const auto model : asperity_models) {
    scene.closures.asperity = model;
    const MixedContact<Reference> contact(scene);
    const LoadSharing<Reference>& sharing = contact.sharing();
    ASSERT_TRUE(sharing.has_floor());
    const Reference p = order_of(model), q = root_of(model);
    // F_p(0)/F_{p−1}(0) = √2 Γ((p+1)/2)/Γ(p/2)
    const Reference mean =
        sqrt(Reference(2)) * tgamma(Reference((p + 1) / 2)) / tgamma(Reference(p / 2));
    const Reference d = sharing.floor() - sharing.offset();
    const Reference hazard = q * p / (mean + (d < 0 ? Reference(-d) : Reference(0)));
    for (const double part : {0.5, 0.1, 0.01, 1e-3}) {  // this part is λ₀/λ_b
      const Reference u = contact.speed_at(Reference(part * sharing.floor()));
      const Reference w = pow(Reference(part), Reference(1) / sharing_exponent_of_film);
      const Reference bound =
          film_exponent * w / (sharing_exponent_of_film * (1 - w) * sharing.floor() * hazard);
      const Reference slope = film_log_slope(scene, u);
      EXPECT_GT(slope, 0);
      EXPECT_LT(slope, bound) << describe({{"part", part}});
      EXPECT_GT(5 * slope, bound) << describe({{"part", part}});
    }
  }
}

const Reference speed = 1;  // the speed of the starved scenes, m/s

// A scene whose inlet makes r = h_ff/h_oil about the given value at 1 m/s. At this speed the flow
// and the film of the inlet are the same number.
Scene scene_at_ratio(StarvationClosure closure, SupplyKind supply, double r) {
  Scene scene = starved_scene(PaperSurface::smooth, closure, SupplyKind::flooded);
  scene.supply = {supply, MixedContact<double>(scene).solve(1).film_flooded / r};
  return scene;
}

// r, x = h*/h_oil = r y and 0.67 − s of such a scene.
struct StarvedState {
  Reference r, x;
  SlopeDeficit deficit;
};
StarvedState starved_state(const Scene& scene) {
  const MixedContact<Reference> contact(scene);
  const FloodedFilm<Reference> film = contact.flooded(speed);
  const InletState<Reference> inlet = contact.inlet(film);
  return {inlet.flooded_over_inlet, inlet.flooded_over_inlet * inlet.film_ratio,
          flooded_slope_deficit(scene.closures.asperity, contact.sharing().stiffness(),
                                contact.sharing().offset(), film.shares.film_parameter)};
}

// `starved_inlet` means 1 = x + r ψ^{3/2}/c. With b = 5.4/π, κ = 1/(c b^{3/2}) = 0.837 and z = πy/2
// = πx/(2r), ψ = tan(z)/2.7 lies between y/b and (y/b)/(1 − 4z²/π²) (Becker and Stark), so that
//   κ r^{−1/2} x^{3/2} ≤ 1 − x ≤ κ r^{−1/2} x^{3/2} (1 − x²/r²)^{−3/2}.
// Because x ≤ 1, the right side is at most U = κ r^{−1/2} (1 − r^{−2})^{−3/2}. Then x ≥ 1 − U, and
// on the left side x^{3/2} ≥ 1 − 3U/2. Thus h*/h_oil = 1 − κ r^{−1/2} with an error of the order of
// 1/r.
TEST(Asymptotics, StarvedInletTendsToTheInletFilmAsTheRootOfTheRatio) {
  const Reference c = 3 / (4 * sqrt(Reference(2)));
  const Reference b = Reference("5.4") / pi<Reference>();
  const Reference kappa = 1 / (c * b * sqrt(b));
  EXPECT_LT(abs(kappa - Reference("0.837")), Reference("0.0005"));
  for (const double ratio : {4.0, 100.0, 1e4, 1e8, 1e16, 1e30}) {
    const Reference r(ratio);
    const Reference x = r * starvation_ratio(starved_inlet, r, Reference(3));
    const Reference leading = kappa / sqrt(r);
    const Reference high = leading * pow(Reference(1 - 1 / (r * r)), Reference(-3) / 2);
    EXPECT_TRUE(is_between(leading * (1 - 3 * high / 2), 1 - x, high, {{"r", ratio}}));
  }
}

// At constant flow d ln h*/d ln u is −1 + (1 + s)(1 + σ), where σ = d ln y/d ln r. With
// k = ψ^{3/2}/c and w = d ln y/d ln ψ, d ln(1/r)/d ln ψ is (yw + 3k/2)/(y + k). Therefore
//   1 + σ = k(3/2 − w)/(yw + 3k/2),  k/y = (1 − x)/x.
// w = 1/((v + 1/v) arctan v) lies between 1/(1 + v²) and 1, where v = 2.7ψ = tan(πx/(2r)).
TEST(Asymptotics, StarvedInletAtConstantFlowTendsToTheSlopeMinus1) {
  for (const double ratio : {10.0, 1e3, 1e6, 1e10}) {
    const Scene scene = scene_at_ratio(starved_inlet, SupplyKind::inlet_flow, ratio);
    const StarvedState at = starved_state(scene);
    const Reference v = tan(Reference(pi<Reference>() * at.x / (2 * at.r)));
    const Reference k_over_y = (1 - at.x) / at.x;
    const Reference least_w = 1 / (1 + v * v);
    const Reference low = k_over_y / 2 / (1 + 3 * k_over_y / 2);
    const Reference high = k_over_y * (Reference("1.5") - least_w) / (least_w + 3 * k_over_y / 2);
    const Reference distance = 1 + film_log_slope(scene, speed);
    EXPECT_TRUE(is_between((1 + film_exponent - at.deficit.high) * low, distance,
                           (1 + film_exponent) * high, {{"r", ratio}}));
    // Both bounds tend to 1.67/2·κ r^{−1/2}.
    EXPECT_LT(high, low * (1 + 10 / (at.r * at.r))) << describe({{"r", ratio}});
    EXPECT_LT(distance, Reference("1.67") / sqrt(at.r));
  }
}

// The closure `damiens` has x = (1 + r^−γ)^{−1/γ} and d ln x/d ln r = 1/(1 + r^γ). The slope is
// therefore −1 + (1 + s)/(1 + r^γ), and Bernoulli's inequality gives 0 ≤ 1 − x ≤ r^−γ/γ.
TEST(Asymptotics, DamiensAtConstantFlowTendsToTheSlopeMinus1) {
  for (const double gamma : {1.0, 3.0, 4.5})
    for (const double ratio : {2.0, 30.0, 1e4, 1e8}) {
      Scene scene = scene_at_ratio(damiens, SupplyKind::inlet_flow, ratio);
      scene.closures.damiens_exponent = gamma;
      const StarvedState at = starved_state(scene);
      const Reference power = pow(at.r, Reference(gamma));
      EXPECT_TRUE(is_between(0, 1 - at.x, 1 / (gamma * power), {{"r", ratio}, {"gamma", gamma}}));
      EXPECT_TRUE(is_between(
          (1 + film_exponent - at.deficit.high) / (1 + power), 1 + film_log_slope(scene, speed),
          (1 + film_exponent - at.deficit.low) / (1 + power), {{"r", ratio}, {"gamma", gamma}}));
    }
}

// The closure `printed_exponents` has k = ψ^{3/2}y^{−5/4}/c and d ln(1/r)/d ln ψ = D/(y + k), where
// D is yw + k(3/2 − 5w/4). Therefore
//   σ + 4 = (3yw + 6k(1 − w))/D,  D ≥ k/4.
// Because y ≤ bψ and 1 − w ≤ v² = (2.7ψ)², 0 ≤ σ + 4 ≤ B(ψ) = 12 c b^{9/4} ψ^{3/4} + 24 (2.7ψ)².
// Because 1/r ≥ k, ψ ≤ (c b^{5/4}/r)⁴. The slope is s(1 + σ) at constant h_oil, and s + (1 + s)σ at
// constant flow. For s = 0.67 and σ = −4 these are −2.01 and −6.01. Because |1 + σ| ≤ 3, the slopes
// differ from them by at most 3(0.67 − s) + 0.67 B and 3(0.67 − s) + 1.67 B.
TEST(Asymptotics, PrintedExponentsTendToTheSlopesMinus201AndMinus601) {
  const Reference c = 3 / (4 * sqrt(Reference(2)));
  const Reference b = Reference("5.4") / pi<Reference>();
  for (const auto supply : {SupplyKind::inlet_film, SupplyKind::inlet_flow})
    for (const double ratio : {3.0, 10.0, 100.0, 1e4, 1e7}) {
      const Scene scene = scene_at_ratio(printed_exponents, supply, ratio);
      const StarvedState at = starved_state(scene);
      const bool flow = supply == SupplyKind::inlet_flow;
      const Reference limit = flow ? Reference("-6.01") : Reference("-2.01");
      const Reference root = c * b * sqrt(sqrt(b)) / at.r;  // at least √√ψ
      const Reference v = Reference("2.7") * root * root * root * root;
      const Reference departure = 12 * c * b * b * sqrt(sqrt(b)) * root * root * root + 24 * v * v;
      const Reference bound =
          3 * at.deficit.high + (flow ? Reference("1.67") : film_exponent) * departure;
      EXPECT_TRUE(is_between(-bound, film_log_slope(scene, speed) - limit, bound,
                             {{"r", ratio}, {"flow", flow ? 1.0 : 0.0}}));
      // The bound of ψ^{3/4} falls as r^−3.
      if (ratio > 5) {
        EXPECT_LT(bound - 3 * at.deficit.high, 100 / (at.r * at.r * at.r))
            << describe({{"r", ratio}});
      }
    }
}

// At a film maximum the slope is 0. The reported speed is a double whose relative distance from the
// maximum is at most `contract`: a little to its left the film rises, and a little to its right it
// falls. Between these places the slope is at most curvature × contract.
TEST(Asymptotics, SlopeAtTheOnsetIs0WithinTheRoundingOfTheSpeed) {
  const Reference contract("1e-13");  // as in onset.hpp
  for (const auto closure : starvation_closures)
    for (const auto supply : {SupplyKind::inlet_film_ratio, SupplyKind::inlet_flow})
      for (const auto model : asperity_models) {
        const Scene scene = starved_scene(PaperSurface::medium, closure, supply, model);
        const Onset<double> found = onset(MixedContact<double>(scene), scene,
                                          OnsetCriterion::film_maximum, default_departure);
        if (!found.exists) continue;
        const Reference u(found.speed);
        const Reference left = film_log_slope(scene, u * (1 - contract));
        const Reference here = film_log_slope(scene, u);
        const Reference right = film_log_slope(scene, u * (1 + contract));
        EXPECT_GT(left, 0) << describe({{"u", found.speed}});
        EXPECT_LT(right, 0) << describe({{"u", found.speed}});
        const Reference curvature = (left - right) / (2 * contract);
        // The curvature is of the order of 1, so there is no plateau. It is assumed to be equal on
        // both sides.
        EXPECT_TRUE(is_between(Reference("0.1"), curvature, 100, {{"u", found.speed}}));
        EXPECT_LT(abs(here), curvature * contract) << describe({{"u", found.speed}});
      }
}

}  // namespace
}  // namespace tribo::verification
