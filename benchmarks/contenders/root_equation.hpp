// SPDX-License-Identifier: Apache-2.0
// The equation that every root contender solves. F_{5/2} is computed by a function that is given.
#pragma once

#include <cmath>
#include <cstddef>
#include <utility>

#include "contenders/root_contender.hpp"
#include "tribo/gaussian_moment.hpp"

namespace tribo::benchmarks {

inline constexpr double film_exponent = 0.14;

// Our F_{5/2}, for the solvers of other families.
inline double fast_moment(double d) { return gaussian_moment(Order::five_halves, d); }

// Moment is a function of d; Count counts its calls.
template <class Count, class Moment>
class LoadBalance {
 public:
  LoadBalance(const RootCase& root_case, const Moment& moment)
      : case_(root_case), moment_(moment) {}

  double asperity_share(double film) const {
    Count::one();
    return std::sqrt(case_.stiffness * moment_(film - case_.offset));
  }
  double fluid_share(double film) const {
    return std::pow(case_.flooded / film, 1 / film_exponent);
  }
  double operator()(double film) const { return asperity_share(film) + fluid_share(film) - 1; }

 private:
  RootCase case_;
  const Moment& moment_;
};

// The same equation as the paper writes it, h = h₀(1−A)^−0.14. The residual is positive if h is too
// small.
template <class Count, class Moment>
class FilmBalance {
 public:
  FilmBalance(const RootCase& root_case, const Moment& moment)
      : case_(root_case), moment_(moment) {}

  double operator()(double film) const {
    Count::one();
    const double share = std::sqrt(case_.stiffness * moment_(film - case_.offset));
    if (share >= 1) return below_floor;
    return case_.flooded * std::pow(1 - share, -film_exponent) - film;
  }

 private:
  static constexpr double below_floor = 1e3;  // any number > 0, for the bracket
  RootCase case_;
  const Moment& moment_;
};

struct Bracket {
  double low, high, at_low, at_high;
};

// A bracket of the root. The search starts from λ₀, where the residual is not negative, and goes
// upward. It doubles its step until the residual is not positive.
template <class Residual>
Bracket bracket_above(const RootCase& root_case, const Residual& residual) {
  Bracket bracket{root_case.flooded, root_case.flooded, residual(root_case.flooded), 0};
  bracket.at_high = bracket.at_low;
  for (double step = 0.5; bracket.at_high > 0 && step < 1e6; step *= 2) {
    bracket.low = bracket.high;
    bracket.at_low = bracket.at_high;
    bracket.high += step;
    bracket.at_high = residual(bracket.high);
  }
  return bracket;
}

// The bracket that many users would choose first: from λ₀ to a film far above the roughness.
template <class Residual>
Bracket bracket_over_roughness(const RootCase& root_case, const Residual& residual) {
  const double high = root_case.flooded + root_case.offset + 8;
  return {root_case.flooded, high, residual(root_case.flooded), residual(high)};
}

// Makes a contender from `solve`, which solves one case, and `counted`, which solves it and counts
// the moments in Counted.
template <class Solve, class CountedSolve>
RootContender one_by_one(std::string family, std::string name, Solve solve, CountedSolve counted) {
  return {std::move(family), std::move(name),
          [solve](const RootCases&) -> RootRun {
            return [solve](const RootCases& cases, std::span<double> film) {
              for (std::size_t i = 0; i < cases.size(); ++i) film[i] = solve(cases[i]);
            };
          },
          [counted](const RootCases& cases) {
            return evaluations_of([&] {
              for (std::size_t i = 0; i < cases.size(); ++i) counted(cases[i]);
            });
          }};
}

// Makes a contender from solver(case, residual), which gets each case with its FilmBalance.
template <class Moment, class Solver>
RootContender on_film(std::string family, std::string name, Moment moment, Solver solver) {
  return one_by_one(
      std::move(family), std::move(name),
      [moment, solver](const RootCase& c) {
        return solver(c, FilmBalance<Uncounted, Moment>(c, moment));
      },
      [moment, solver](const RootCase& c) {
        return solver(c, FilmBalance<Counted, Moment>(c, moment));
      });
}

template <class Moment, class Solver>
RootContender on_load_balance(std::string family, std::string name, Moment moment, Solver solver) {
  return one_by_one(
      std::move(family), std::move(name),
      [moment, solver](const RootCase& c) {
        return solver(c, LoadBalance<Uncounted, Moment>(c, moment));
      },
      [moment, solver](const RootCase& c) {
        return solver(c, LoadBalance<Counted, Moment>(c, moment));
      });
}

}  // namespace tribo::benchmarks
