// SPDX-License-Identifier: Apache-2.0
// The engine's kernels as plain functions. Beyond their range they return NaN, and leave the point
// to the templates.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "sharing_method.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/operating_points.hpp"

namespace tribo::detail {

// Where the numbers of operating points go; null for what is not asked.
struct Destination {
  std::array<double*, number_count> numbers;  // by Output
  Regime* regime;
  Inlet* inlet;
};

// λ at a speed and a γ, and its exponents. λ is NaN beyond a table of solved films.
struct FilmOfSpeed {
  double film_parameter;
  FilmExponents<double> exponents;
};

// The kernels of an instruction set. Those without arrays compute one lane.
struct Kernels {
  const char* (*instruction_set)();
  bool is_fused;
  // F_n(d), S_n(d), of one argument and of `count`, and ln F_n(d)
  double (*moment)(Order n, double d);
  double (*scaled_moment)(Order n, double d);
  void (*moments)(Order n, const double* d, double* result, std::size_t count);
  void (*scaled_moments)(Order n, const double* d, double* result, std::size_t count);
  void (*log_moments)(Order n, const double* d, double* result, std::size_t count);
  // e^x and ln x, of `count` too, and x^{p/q}
  double (*exponential)(double x);
  void (*exponentials)(const double* x, double* result, std::size_t count);
  double (*logarithm)(double x);
  void (*logarithms)(const double* x, double* result, std::size_t count);
  double (*power)(double x, const Exponent& exponent);
  // Kernels of one surface: its floor; A at λ − δ; the shares at λ = λ_b + distance; the distance
  // at a fluid share; a root with its steps; the root of a surface that is used once; the shares at
  // a root.
  SurfaceNumbers<double> (*surface)(Order order, const FilmLaw& law, double stiffness,
                                    double offset);
  double (*share)(Order order, double stiffness, double argument);
  LoadShares<double> (*shares_above_floor)(Order order, const SurfaceNumbers<double>& surface,
                                           double distance);
  double (*distance_above_floor)(Order order, const SurfaceNumbers<double>& surface, double fluid);
  SharingRoot<double> (*root)(Order order, const FilmLaw& law,
                              const SurfaceNumbers<double>& surface, double flooded_film_parameter);
  double (*root_of_surface)(Order order, const FilmLaw& law, double stiffness, double offset,
                            double flooded_film_parameter);
  LoadShares<double> (*shares_at_root)(Order order, const FilmLaw& law,
                                       const SurfaceNumbers<double>& surface,
                                       double flooded_film_parameter, double film_parameter);
  // Roots of one surface for all points, and of one surface for each point; at most sharing_block
  // points. They return the number of steps.
  std::size_t (*roots_of_one)(Order order, const FilmLaw& law,
                              const SurfaceNumbers<double>& surface, const double* flooded,
                              double* film_parameter, std::size_t count);
  std::size_t (*roots_of_many)(Order order, const FilmLaw& law, const double* stiffness,
                               const double* offset, const double* flooded, double* film_parameter,
                               std::size_t count);
  // Prepares contacts of one shape, asperity model and film law from scenes. Where K or δ is beyond
  // the kernels' range, the floor that this gives is not valid.
  void (*prepare)(const ContactWords& words, const SceneNumbers<double>* scenes,
                  ContactNumbers<double>* contacts, std::size_t count);
  // film_of: λ of a law without fixed exponents at a speed and ln γ, with d ln λ/d ln u and d ln
  // λ/d ln γ. stiffened: the flooded film with its shares.
  FilmOfSpeed (*film_of)(const FilmLaw& law, const ContactNumbers<double>& contact, double speed,
                         double log_stiffening);
  LoadShares<double> (*stiffened)(const ContactWords& words, const ContactNumbers<double>& contact,
                                  double speed);
  // λ₀ at a speed, the inlet at a film, and the outputs from both.
  double (*flooded_film_parameter)(const FilmLaw& law, const ContactNumbers<double>& contact,
                                   double speed);
  InletState<double> (*inlet)(const ContactWords& words, const ContactNumbers<double>& contact,
                              double speed, double film_parameter);
  void (*complete)(const ContactWords& words, const ContactNumbers<double>& contact,
                   const FloodedFilm<double>& flooded, const InletState<double>& inlet,
                   OutputSet outputs, const Destination& to);
  // Computes one point. Returns its λ; NaN beyond the kernels' range.
  double (*point)(const ContactWords& words, const ContactNumbers<double>& contact, double speed,
                  OutputSet outputs, const Destination& to);
  // Points of one contact, or of the contact index[i] of many; at most sharing_block. λ of each
  // goes to `film_parameter`; NaN beyond the kernels' range.
  void (*points)(const ContactWords& words, const ContactNumbers<double>* contacts,
                 const std::uint64_t* index, const double* speeds, OutputSet outputs,
                 const Destination& to, double* film_parameter, std::size_t count,
                 WorkCounts* work);
};

// The kernels of the instruction set that was chosen at run time.
const Kernels& engine();

// Are K and δ within the range of the kernels?
bool is_within_engine(double stiffness, double offset);

// Like the kernel `prepare`; beyond its range the floors come from the template.
void prepare(const ContactWords& words, std::span<const SceneNumbers<double>> scenes,
             std::span<ContactNumbers<double>> contacts);

}  // namespace tribo::detail
