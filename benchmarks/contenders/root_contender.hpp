// SPDX-License-Identifier: Apache-2.0
// Methods for the film parameter λ of load sharing (model/README.md, section 6) after Greenwood and
// Tripp:  A(λ) + (λ₀/λ)^{1/0.14} = 1,  A = √(K F_{5/2}(λ−δ)).
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "contenders/contender.hpp"

namespace tribo::benchmarks {

struct RootCase {
  double stiffness, offset, flooded;  // K, δ, λ₀
};

struct RootCases {
  std::span<const double> stiffness;  // K
  std::span<const double> offset;     // δ
  std::span<const double> flooded;    // λ₀
  std::size_t size() const { return flooded.size(); }
  RootCase operator[](std::size_t i) const { return {stiffness[i], offset[i], flooded[i]}; }
};

using RootRun = std::function<void(const RootCases&, std::span<double> film_parameter)>;

struct RootContender {
  std::string family;
  std::string name;
  // Returns the function that is timed. If that function uses the same data of one surface in all
  // its calls, `prepare` makes these data from the first case, which is not timed.
  std::function<RootRun(const RootCases&)> prepare;
  // The number of moments that these cases need. A moment with its derivatives counts once. Empty:
  // moments are not counted.
  std::function<double(const RootCases&)> evaluations{};
  bool is_slow = false;                   // a case takes some microseconds or more; fewer are timed
  std::function<double()> own_seconds{};  // CPU time of the last call in another process
};

// Contenders that take a new surface in each case, and contenders for one surface (all cases have
// the same K and δ). Our own come last.
std::vector<RootContender> wide_root_contenders(Settings settings = Settings::usual);
std::vector<RootContender> one_surface_root_contenders(Settings settings = Settings::usual);

// The contenders by their kind of method.
std::vector<RootContender> bracketing_roots(Settings settings);  // Brent, TOMS 748
std::vector<RootContender> derivative_roots(Settings settings);  // Newton, Halley
std::vector<RootContender> textbook_roots(Settings settings);    // fixed point, Newton on the film
std::vector<RootContender> inverse_tables(Settings settings);    // one surface only
// SciPy's fsolve, in the same process of Python as scipy_moments().
std::vector<RootContender> scipy_roots();

}  // namespace tribo::benchmarks
