// SPDX-License-Identifier: Apache-2.0
#include "generators/load_sharing_root.hpp"
#include "generators/sampler.hpp"
#include "generators/table.hpp"

namespace tribo::reference {
namespace {

struct Problem {
  Rough model;
  double stiffness, offset, film;
  const char* region;
};

std::vector<Problem> problems() {
  std::vector<Problem> all;
  Sampler sampler(202);
  for (int i = 0; i < 120; ++i)
    all.push_back({sampler.pick({Rough::tripp, Rough::williamson}), sampler.log_uniform(1e-6, 10),
                   sampler.uniform(0, 3), sampler.log_uniform(1e-4, 100), "regular"});
  // One of the paper's surfaces, over the range of its films.
  for (int i = 0; i < 40; ++i)
    all.push_back({Rough::tripp, 0.3, 1.146, sampler.log_uniform(1e-3, 20), "regular"});
  // A(0) near 1: K near 1/F_p(−δ).
  for (const Rough model : {Rough::tripp, Rough::williamson})
    for (const double offset : {0.0, 1.146}) {
      const int order = model == Rough::tripp ? 5 : 3;
      const double critical = (1 / moment_by_hypergeometric(order, Ball(-offset))).nearest();
      for (const double away : {-1e-2, -1e-4, -1e-8, 1e-8, 1e-4, 1e-2})
        for (const double film : {1e-6, 1e-3, 0.1})
          all.push_back({model, critical * (1 + away), offset, film, "critical"});
    }
  for (int i = 0; i < 60; ++i)
    all.push_back({sampler.pick({Rough::tripp, Rough::williamson}),
                   sampler.log_uniform(1e-300, 1e300), sampler.uniform(0, 10),
                   sampler.log_uniform(1e-300, 1e300), "extreme"});
  // Inputs at which simple solvers fail.
  const double broken[][3] = {
      {10, 1.146, 1e-4},    {10, 1.146, 1.9},    {0.30652, 1.146, 0.00776499},
      {1e6, 1.146, 4.5},    {10, 1.146, 2.1},    {0.303626, 1.146, 0.00175},
      {1e300, 1.146, 30.0}, {1e-300, 0, 1e-300}, {1e300, 10, 1e-300}};
  for (const auto& b : broken)
    for (const Rough model : {Rough::tripp, Rough::williamson})
      all.push_back({model, b[0], b[1], b[2], "worst"});
  // The second model takes the steps backwards, so that it begins where the first one ends.
  for (const Numbers& x : steps({0.3, 1.1, 0.8}, {0.7, 0.6, 1.3}))
    all.push_back({Rough::tripp, x[0], x[1], x[2], "regular"});
  for (const Numbers& x : steps({0.7, 0.6, 1.3}, {0.3, 1.1, 0.8}))
    all.push_back({Rough::williamson, x[0], x[1], x[2], "regular"});
  for (const Rough model : {Rough::tripp, Rough::williamson})
    for (const Numbers& x : at_ends({0.3, 1.1, 0.8}, {{0, 0, 1e6}, {1, 0, 10}, {2, 1e-4, 1e3}}))
      all.push_back({model, x[0], x[1], x[2], "end"});
  return all;
}

// |d ln λ/d ln λ₀| + |d ln λ/d ln K| + |d ln λ/d ln δ|, at least 1, with w the share of the film:
// (w + 0.14 A a) d ln λ = w d ln λ₀ + 0.14 A (q d ln K + a (δ/λ) d ln δ), a = −d ln A/d ln λ.
Ball condition(const RoughContact& contact, const Ball& film, const Ball& lambda) {
  const Ball fluid = pow(film / lambda, fraction(100, 14));
  const Ball share = 1 - fluid, m = fraction(14, 100);
  if (share < pow(Ball(2), Ball(-300))) return Ball(1);
  const Ball a = -contact.share_slope(lambda) * lambda;
  const Ball q = contact.model == Rough::tripp ? fraction(1, 2) : Ball(1);
  const Ball sum =
      (fluid + m * share * (q + a * contact.offset / lambda)) / (fluid + m * share * a);
  return (sum < 1 ? Ball(1) : sum).midpoint();
}

}  // namespace

std::vector<Table> load_sharing_roots() {
  Table table{{"load_sharing",
               "lambda with ln lambda - ln lambda0 + 0.14 ln(1-A) = 0, A = (K F_p(lambda-delta))^q",
               "dimensionless",
               "K and lambda0 in [1e-300, 1e300], delta in [0, 10]; p, q = 5/2, 1/2 "
               "(greenwood_tripp) or 3/2, 1 (greenwood_williamson)",
               "Newton's method, then a change of certain signs across a width of 2^-145 or less",
               "bisection in ball arithmetic", "asperity,stiffness,offset,flooded_film_parameter"},
              "r"};
  for (const Problem& p : problems())
    table.add([=] {
      const RoughContact contact{p.model, Ball(p.stiffness), Ball(p.offset)};
      const Ball film(p.film);
      const Ball root = root_by_newton(contact, film);
      return Row{{p.model == Rough::tripp ? "greenwood_tripp" : "greenwood_williamson"},
                 {p.stiffness, p.offset, p.film},
                 root,
                 root_by_bisection(contact, film),
                 condition(contact, film, root.midpoint()),
                 p.region};
    });
  return {table};
}

}  // namespace tribo::reference
