// SPDX-License-Identifier: Apache-2.0
// The table behind all checks of contracts. For each function it has the domain from which points
// are drawn, the model's promise for the results, and the values in any number type. The values in
// ball arithmetic are the truth. A point of `model_stress` follows from seed and index alone, so
// that any point can be looked at again, however many threads the run had.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sampling/sampler.hpp"
#include "support/enclosure.hpp"
#include "tribo/contract.hpp"
#include "tribo/scene.hpp"

namespace tribo::verification {

// A result: its name, and the contract that the model promises for it.
struct Row {
  std::string name;
  Contract contract;
};
std::span<const Row> rows();
inline constexpr std::size_t stress_rows = 36;  // the first rows, those that model_stress draws

enum class Kind : std::uint8_t {
  scene,          // of steel, as built
  extreme_scene,  // decades beyond what can be built
  load_sharing,   // K and λ₀ from 1e-300 to 1e300, and K about its critical value
  load_shares,    // λ₀ within 30 % of a floor, which may be of any height
  film_ratio,     // r from 1e-300 to 1e300, and about 1
  moment,         // d from −45 to 45, all orders, and the neighbours of every branch
  // The kinds below are drawn by the contract test alone.
  scaled_moment,  // and its logarithm
  deficit,        // 1 − y of the starved film; r at a given 1 − y; slope
  hertz,
  film,
  rough_contact,
  viscosity,
  shear,
  effective_modulus,
  reduced_radius,
  hertz_ellipse,
  hertz_line,
  film_law,  // all film laws but the central one
  moes_line,
  moes_point,
  film_regime,
  thermal_reduction,
  density,
  pressure_viscosity,
  astm_d341,
  spectral_moments,
  count
};
inline constexpr auto kind_count = static_cast<std::size_t>(Kind::count);

struct KindInfo {
  Kind kind;
  std::string_view name;
  // The contract test draws `points` points and adds the hard ones. The truth has to be certain for
  // at least `certain` of all these.
  int points, certain;
};
inline constexpr std::array<KindInfo, kind_count> kinds{{
    {Kind::scene, "scene", 400, 700},
    {Kind::extreme_scene, "extreme_scene", 200, 180},
    {Kind::load_sharing, "load_sharing", 700, 1900},
    {Kind::load_shares, "load_shares", 400, 400},
    {Kind::film_ratio, "film_ratio", 1000, 1000},
    {Kind::moment, "moment", 600, 1000},
    {Kind::scaled_moment, "scaled_moment", 400, 800},
    {Kind::deficit, "deficit", 400, 400},
    {Kind::hertz, "hertz", 400, 400},
    {Kind::film, "film", 400, 400},
    {Kind::rough_contact, "rough_contact", 400, 400},
    {Kind::viscosity, "viscosity", 600, 600},
    {Kind::shear, "shear", 600, 600},
    {Kind::effective_modulus, "effective_modulus", 400, 400},
    {Kind::reduced_radius, "reduced_radius", 400, 395},
    {Kind::hertz_ellipse, "hertz_ellipse", 400, 400},
    {Kind::hertz_line, "hertz_line", 400, 400},
    {Kind::film_law, "film_law", 800, 800},
    {Kind::moes_line, "moes_line", 500, 500},
    {Kind::moes_point, "nijenbanning_venner_moes", 500, 500},
    {Kind::film_regime, "film_regime", 500, 500},
    {Kind::thermal_reduction, "thermal_reduction", 400, 400},
    {Kind::density, "density", 200, 200},
    {Kind::pressure_viscosity, "pressure_viscosity", 400, 400},
    {Kind::astm_d341, "astm_d341", 400, 400},
    {Kind::spectral_moments, "spectral_moments", 400, 400},
}};
static_assert([] {
  std::size_t place = 0;
  for (const KindInfo& one : kinds)
    if (one.kind != static_cast<Kind>(place++)) return false;
  return true;
}());
// GoogleTest looks for this function beside the type, and without it prints bytes.
inline void PrintTo(const KindInfo& one, std::ostream* to) { *to << one.name; }
constexpr std::string_view name(Kind kind) { return kinds[static_cast<std::size_t>(kind)].name; }

struct Point {
  Kind kind = Kind::scene;
  Scene scene;  // other kinds than scenes use only its choices of laws
  const FilmLaw* film = &hamrock_dowson_central_law;  // of load_sharing, load_shares and film_law
  std::array<double, 9> x{};                          // K, δ, λ₀ | r, γ, departure | d | …
};

Point point_at(std::uint64_t seed, std::uint64_t index);
// Draws the numbers of a point of this kind from its domain, hard ones among them.
void draw(Sampler& sampler, Point& point);

// Names and numbers that define the point.
std::vector<std::pair<std::string, double>> inputs_of(const Point& point);

// The results of a point in one number type.
template <class T>
struct Values {
  std::vector<T> numbers;
  std::array<int, 2> states{};  // of a scene: regime, inlet
};
// Defined for float, double, long double, Reference (support/judge.hpp) and Enclosure.
template <class T>
Values<T> values_of(const Point& point);

// The row of the first number of a point; the others follow.
std::size_t first_row(const Point& point);

// A number in double and in long double, under its row.
struct Measured {
  std::size_t row = 0;
  double got = 0;
  long double expected = 0;
};

struct Evaluation {
  std::vector<Measured> numbers;
  bool states_differ = false;  // regime, inlet; a share beyond [0, 1]
  std::size_t state_row = 0;   // the row of the states, where the point has any
  // The condition number of one of the numbers, at least 1; costs more than the rest.
  std::function<double(std::size_t)> condition;
};

Evaluation evaluate(const Point& point);

// The condition numbers of any point, as Evaluation::condition gives them.
std::vector<double> conditions_of(const Point& point);

// The values of values_of(), as enclosures. Throws std::runtime_error where a root has no proof;
// empty where a branch was not certain.
Values<Enclosure> enclose(const Point& point);

// The greatest |error|, in ulp, that a contract allows.
double allowed_ulp(const Contract& contract, double condition);

// Whether an output is so near the ends of the range of double that a factor of it may leave the
// range: `expected` is below 1e-290 and `got` below 2e-290, or `expected` is above 1e280 and `got`
// infinite.
bool is_at_the_ends(double got, long double expected);

}  // namespace tribo::verification
