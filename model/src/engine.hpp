// SPDX-License-Identifier: Apache-2.0
// The engine's kernels as plain functions, each on the instruction set chosen at run time. What
// they leave to the formula text, beyond their range, is NaN.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "sharing_method.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/operating_points.hpp"

namespace tribo::detail {

// e^x, ln x and x^{p/q}
double engine_exponential(double x);
double engine_logarithm(double x);
double engine_power(double x, const Fraction& exponent);

// Of a surface: its floor, A at λ − δ, the shares at λ = λ_b + distance, the
// distance of a fluid share, a root with its steps, the shares at a root.
SurfaceNumbers<double> engine_surface(Order order, double stiffness, double offset);
double engine_share(Order order, double stiffness, double argument);
LoadShares<double> engine_shares_above_floor(Order order, const SurfaceNumbers<double>& surface,
                                             double distance);
double engine_distance_above_floor(Order order, const SurfaceNumbers<double>& surface,
                                   double fluid);
SharingRoot<double> engine_root(Order order, const SurfaceNumbers<double>& surface,
                                double flooded_film_parameter);
LoadShares<double> engine_shares_at_root(Order order, const SurfaceNumbers<double>& surface,
                                         double flooded_film_parameter, double film_parameter);
// Are K and δ within the range of the kernels?
bool is_within_engine(const SurfaceNumbers<double>& surface);

// Contacts of one asperity model, prepared from scenes. The engine's have no floor that holds where
// K or δ is beyond its range; prepare() gives them one by the formula text.
void engine_prepare(AsperityModel model, std::span<const SceneNumbers<double>> scenes,
                    std::span<ContactNumbers<double>> contacts);
void prepare(AsperityModel model, std::span<const SceneNumbers<double>> scenes,
             std::span<ContactNumbers<double>> contacts);

// Where the numbers of operating points go; null for what is not asked.
struct Destination {
  std::array<double*, number_count> numbers;  // by Output
  Regime* regime;
  Inlet* inlet;
  std::uint8_t* friction_undefined;
};

// λ₀ at a speed, the inlet at a film, and the outputs from both.
double engine_flooded_film_parameter(const ContactNumbers<double>& contact, double speed);
InletState<double> engine_inlet(const ContactWords& words, const ContactNumbers<double>& contact,
                                double speed, double film_parameter);
void engine_complete(const ContactWords& words, const ContactNumbers<double>& contact,
                     const FloodedFilm<double>& flooded, const InletState<double>& inlet,
                     OutputSet outputs, const Destination& to);

// A point alone: its λ, NaN where the kernels do not reach.
double engine_point(const ContactWords& words, const ContactNumbers<double>& contact, double speed,
                    OutputSet outputs, const Destination& to);

// Points of one contact, or of the contact index[i] of many; at most sharing_block. λ of each goes
// to `film_parameter`, NaN where the kernels do not reach.
void engine_points(const ContactWords& words, const ContactNumbers<double>* contacts,
                   const std::uint64_t* index, std::span<const double> speeds, OutputSet outputs,
                   const Destination& to, double* film_parameter, WorkCounts* work);

}  // namespace tribo::detail
