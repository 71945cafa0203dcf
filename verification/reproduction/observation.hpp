// SPDX-License-Identifier: Apache-2.0
// The result of a reading for each quantity of the claims, in stages that many readings share: the
// films (root and inlet) on a grid of speeds, friction on the same grid, the onsets, the numbers.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "reproduction/claims.hpp"
#include "reproduction/reading_model.hpp"
#include "reproduction/sampled_curve.hpp"

namespace tribo::reproduction {

// The paper's three surfaces with GT, and the smooth one with GW, because the paper compares both.
enum class ContactName : std::uint8_t { rough, medium, smooth, smooth_gw };
inline constexpr std::size_t contact_count = 4;
template <class T>
using PerContact = std::array<T, contact_count>;
std::string_view name(ContactName contact);

// The contacts whose numbers an item takes from beyond the collapse of their film.
std::vector<std::string_view> beyond_collapse(const Observed& observed);
inline constexpr std::string_view beyond_collapse_words =
    "rests on points beyond the film's collapse";

// At least 20 speeds a decade, evenly in their logarithm, from one end of the range to the other.
std::vector<double> speed_grid(double from, double to);

// One contact's flooded films on the grid: the stage that has to find a root for each point.
struct FloodedCurve {
  ReadContact contact;
  std::vector<double> film_parameter;
};
FloodedCurve flooded_curve(const ReadContact& contact, const std::vector<double>& speeds);

// One contact's starved films.
struct StarvedCurve {
  std::vector<ContactPoint> points;
  std::optional<OnsetPoint> film_maximum;
};
StarvedCurve starved_curve(const FloodedCurve& flooded, const ReadInlet& inlet,
                           const std::vector<double>& speeds);

struct FrictionCurve {
  std::vector<double> coefficient;  // NaN where undefined
};
FrictionCurve friction_curve(const FloodedCurve& flooded, const StarvedCurve& starved,
                             FrictionLaw law);
// The lowest interior minimum, with the error of its speed. Empty if there is none.
std::optional<OnsetPoint> friction_minimum(const FloodedCurve& flooded, const StarvedCurve& starved,
                                           const FrictionCurve& friction, const ReadInlet& inlet,
                                           FrictionLaw law);

// All that the quantities of one reading are computed from. The objects behind the pointers have to
// outlive it.
struct Stages {
  const ReadInlet* inlet;
  PerContact<const FloodedCurve*> flooded;
  PerContact<const StarvedCurve*> starved;
  PerContact<const FrictionCurve*> friction{};     // smooth and smooth_gw, where asked for
  FrictionLaw law{};                               // of that friction
  PerContact<std::optional<OnsetPoint>> onsets{};  // by the reading's criterion
  double lambda_divisor = 1;                       // 1, or 1.4 for λ by σ
  double film_constant = 0;
};

// The stage that a quantity needs beyond the films.
enum class Stage : std::uint8_t { films, friction, onsets, constant };
Stage stage(Quantity quantity);

// The result for an item. Effort::grid uses the speeds of the grid alone: the error covers the
// numbers between them, and a comparison of speeds has part 1 or 0. Effort::refined also computes
// points between the speeds of the grid.
Observed observe(const Item& item, const Stages& stages, Effort effort = Effort::refined);

}  // namespace tribo::reproduction
