// SPDX-License-Identifier: Apache-2.0
// Starvation ratios and onset constants.
#include <utility>

#include "generators/sampler.hpp"
#include "generators/starved_film.hpp"
#include "generators/table.hpp"

namespace tribo::reference {
namespace {

// |d ln y/d ln r| + |d ln y/d ln γ| by a step of 2^-100, at least 1.
Ball ratio_condition(Inlet inlet, const Ball& r, const Ball& gamma, const Ball& y) {
  const Ball h = pow(Ball(2), Ball(-100));
  const auto slope = [&](const Ball& moved) { return abs(moved / y - 1) / h; };
  const Ball sum = slope(film_ratio_by_inlet_length(inlet, (r * (1 + h)).midpoint(), gamma)) +
                   slope(film_ratio_by_inlet_length(inlet, r, (gamma * (1 + h)).midpoint()));
  return sum < 1 ? Ball(1) : sum.midpoint();
}

// The zero y of d ln(r y)/d ln y, where y dG/dy = G = 1/r, by bisection on central differences.
// Their sign is certain except within 2^-150 of the zero. The two ways differ in their step.
Ball maximum_film_ratio(Inlet inlet, int step_bits) {
  const Ball h = pow(Ball(2), Ball(-step_bits));
  const auto excess = [&](const Ball& y) {
    // Richardson's extrapolation: the error is of order h⁴
    const auto log_inverse = [&](int k) { return log(inverse_ratio(inlet, y * exp(k * h))); };
    const Ball slope =
        (8 * (log_inverse(1) - log_inverse(-1)) - (log_inverse(2) - log_inverse(-2))) / (12 * h);
    return slope - 1;
  };
  return zero_between(excess, fraction(1, 100), fraction(99, 100));
}

Table starvation_ratios() {
  Table table{{"starvation_ratio", "y = h*/h_ff at r = h_ff/h_oil", "dimensionless",
               "r in [1e-12, 1e12], gamma in [0.5, 6] (damiens alone uses it)",
               "explicit, or Newton's method in ln psi with a proof by signs",
               "bisection on y in ball arithmetic (damiens: the other form, rho = 1/r)",
               "closure,flooded_over_inlet,damiens_exponent"},
              "s"};
  const auto add = [&table](Inlet inlet, double r, double gamma) {
    table.add([=] {
      const Ball y = film_ratio_by_inlet_length(inlet, Ball(r), Ball(gamma));
      const bool collapsed = inlet == Inlet::flooded_inlet && r >= 1;
      return Row{{name(inlet)},
                 {r, gamma},
                 y,
                 film_ratio_by_bisection(inlet, Ball(r), Ball(gamma)),
                 collapsed ? Ball(1) : ratio_condition(inlet, Ball(r), Ball(gamma), y),
                 collapsed             ? "collapsed"
                 : r < 1e-3 || r > 1e3 ? "far"
                                       : "ordinary"};
    });
  };
  Sampler sampler(303);
  for (const Inlet inlet : inlets) {
    std::vector<double> ratios{0.5, 1 - 0x1p-30, 1, 0.6327757634209, 0.6962389029717};
    for (int i = 0; i < 60; ++i) ratios.push_back(sampler.log_uniform(1e-3, 1e3));
    for (int i = 0; i < 30; ++i) ratios.push_back(sampler.log_uniform(1e-12, 1e12));
    for (const double r : ratios) add(inlet, r, sampler.uniform(0.5, 6));
  }
  // Every second closure takes the steps backwards, so that each begins where the last one ends.
  for (std::size_t i = 0; i < std::size(inlets); ++i)
    for (const Numbers& x : i % 2 == 0 ? steps({0.8, 3}, {0.4, 2}) : steps({0.4, 2}, {0.8, 3}))
      add(inlets[i], x[0], x[1]);
  for (const Inlet inlet : inlets)
    for (const Numbers& x : at_ends({0.8, 3}, {{0, 1e-3, 1e3}, {1, 1, 6}}))
      if (inlet == Inlet::damiens || x[1] == 3) add(inlet, x[0], x[1]);
  return table;
}

Table onset_constants() {
  Table table{
      {"onset_constant",
       "r, and h*/h_oil, at which h* is greatest at constant h_oil; r at a departure",
       "dimensionless",
       "flooded_inlet and printed_exponents (maximum); all closures (departure 0.05, gamma 3)",
       "bisection on the slope of ln(1/r) in ln y, differences of step 2^-40",
       "the same with a step of 2^-45; departures: substitution into r -> y by bisection",
       "closure,constant"},
      "o"};
  const auto add = [&](Inlet inlet, const char* constant,
                       std::function<std::pair<Ball, Ball>()> both, const char* region) {
    table.add([=] {
      const auto [first, second] = both();
      return Row{{name(inlet), constant}, {}, first, second, Ball(1), region};
    });
  };
  for (const Inlet inlet : {Inlet::flooded_inlet, Inlet::printed_exponents}) {
    // Differences of step h are off by about h⁴.
    const auto ratio = [inlet](int bits) {
      return with_relative_radius(
          1 / inverse_ratio(inlet, maximum_film_ratio(inlet, bits)).midpoint(), 4 * bits - 12);
    };
    const auto film = [inlet](int bits) {
      const Ball y = maximum_film_ratio(inlet, bits);
      return with_relative_radius((y / inverse_ratio(inlet, y)).midpoint(), 4 * bits - 12);
    };
    const auto by_both = [](auto of) { return [=] { return std::pair{of(40), of(45)}; }; };
    add(inlet, "flooded_over_inlet_at_maximum", by_both(ratio), "maximum");
    add(inlet, "film_over_inlet_at_maximum", by_both(film), "maximum");
  }
  for (const Inlet inlet : inlets)
    add(
        inlet, "flooded_over_inlet_at_departure_0.05",
        [=] {
          const Ball y = fraction(95, 100), gamma(3);
          const Ball r = inlet == Inlet::damiens ? pow(1 - pow(y, gamma), 1 / gamma) / y
                                                 : 1 / inverse_ratio(inlet, y);
          // the second way: bisection on r of y(r) − 0.95
          const Ball found = zero_between(
              [&](const Ball& x) { return y - film_ratio_by_inlet_length(inlet, x, gamma); },
              fraction(1, 1000), inlet == Inlet::flooded_inlet ? fraction(999, 1000) : Ball(100));
          return std::pair{r, found};
        },
        "departure");
  return table;
}

}  // namespace

std::vector<Table> starvation() { return {starvation_ratios(), onset_constants()}; }

}  // namespace tribo::reference
