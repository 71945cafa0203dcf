// SPDX-License-Identifier: Apache-2.0
// The paper's contact under one reading, from the parts of the model. The changes by switches are
// made here, and the rest is the model's own. The supply has to be a constant h_oil/σ_s, as in the
// paper.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "reproduction/reading.hpp"
#include "tribo/asperity_contact.hpp"
#include "tribo/friction.hpp"
#include "tribo/load_sharing.hpp"
#include "tribo/scene.hpp"
#include "tribo/starvation.hpp"

namespace tribo::reproduction {

// A shear law with a law of viscosity: the choices of the switches on which only friction depends.
struct FrictionLaw {
  FluidShear shear;
  ViscosityLaw viscosity;
};
FrictionLaw friction_law(const Reading& reading);

// The film law of a reading, by its choices of E_HD, of u and of the constant.
FilmLaw film_law(const Reading& reading);

// ln ψ as a function of ln r, for a closure whose y needs a root. A table and one step of Newton's
// method replace the dozen evaluations of that root, because an enumeration asks for millions of
// films behind one inlet.
class InletLengths {
 public:
  explicit InletLengths(const InletCurve<double>& curve);

  // ln ψ at r > 0. Error: 4 ε × (10 + |ln ψ|).
  double log_length(double flooded_over_inlet) const;

 private:
  InletCurve<double> curve_;
  std::vector<double> log_length_, step_slope_;  // at the nodes; the slope times their distance
};

// The starved inlet of a reading: the model's with the reading's gap, or the inlet as printed.
class ReadInlet {
 public:
  // `of_many`: use InletLengths if the closure needs a root.
  explicit ReadInlet(const Reading& reading, bool of_many = false);

  // y = h*/h_ff at r = h_ff/h_oil > 0; 0 where the film has collapsed.
  double film_ratio(double flooded_over_inlet) const;
  // d ln y/d ln r.
  double slope(double flooded_over_inlet) const;
  // The r at which h* is greatest; empty where h* has no maximum.
  std::optional<double> maximum() const { return maximum_; }
  // The r at which y = 1 − ε.
  double departure(double departure) const;
  InletRule rule() const { return rule_; }

 private:
  InletRule rule_;
  InletCurve<double> curve_;
  std::optional<InletLengths> lengths_;
  std::optional<double> maximum_;
  double constant_film_ = 0;  // h*/h_oil of as_printed
};

struct ContactPoint {
  double speed;
  double film_parameter;  // λ* = h*/σ_s
  double separation;      // over σ_s, at least the floor
  double asperity_share;
  double real_area_ratio;
  double summit_count;
  bool collapsed;
};

// Relative rounding error of a point's numbers. The moments of the heights and the film are right
// to a few ulp. Moments fall with the separation λ as e^{−λ²/2}, so that a relative error of λ
// counts λ² times.
inline double rounding(const ContactPoint& point) {
  return 1e-14 * (10 + point.separation * point.separation);
}

struct OnsetPoint {
  double speed;           // m/s
  double film_parameter;  // h*/σ_s
  double error = 1e-13;   // relative, of both
};

// A scene under a reading. film_scale multiplies the film formula. It is 1, except in the search
// for requirements.
class ReadContact {
 public:
  ReadContact(const Scene& scene, const Reading& reading, double film_scale = 1);

  // λ of the flooded film at a speed, which is the only root to find. `flooded` below is this λ.
  double flooded_film_parameter(double speed) const;
  // The same at several speeds, with the same bits.
  std::vector<double> flooded_film_parameters(std::span<const double> at) const;
  ContactPoint point(double speed, double flooded, const ReadInlet& inlet) const;
  ContactPoint point(double speed, const ReadInlet& inlet) const {
    return point(speed, flooded_film_parameter(speed), inlet);
  }
  // NaN where the faces touch without a floor.
  double friction(const ContactPoint& point, FrictionLaw law) const;

  // The speed at which the flooded film is λ; empty at the floor and below.
  std::optional<double> speed_at(double film_parameter) const;
  // Onset at a given r, whatever the criterion; empty at the floor and below.
  std::optional<OnsetPoint> onset_at_ratio(double r, const ReadInlet& inlet) const;
  // d ln h*/d ln u at r, and the slope of the flooded film at λ.
  double film_slope(double r, const ReadInlet& inlet) const;
  double flooded_slope(double film_parameter) const;
  // The speed from which on the film has collapsed: ∞ where it never collapses, 0 where it has
  // collapsed at all speeds.
  double collapse_speed(const ReadInlet& inlet) const;
  double inlet_film_ratio() const { return inlet_film_ratio_; }
  double film_at_unit_speed() const { return film_at_unit_speed_; }

 private:
  double smooth_film_parameter(double speed) const;  // λ₀
  double asperity_share(double film_parameter) const;

  double inlet_film_ratio_;
  double film_at_unit_speed_;  // λ₀ at 1 m/s
  double summit_height_sd_;
  double mean_pressure_;
  Lubricant lubricant_;
  double boundary_coefficient_;
  double slide_roll_ratio_;
  AsperityContact<double> asperities_;
  LoadSharing<double> sharing_;
};

// Onset by film_maximum, film_departure or asperity_minimum; friction_minimum needs a curve
// (observation.hpp).
std::optional<OnsetPoint> explicit_onset(const ReadContact& contact, const ReadInlet& inlet,
                                         const OnsetChoice& choice);

}  // namespace tribo::reproduction
