// SPDX-License-Identifier: Apache-2.0
// The onsets of the inlet alone, at constant h_oil (model/README.md, section 9). They depend on the
// closure, and not on the contact.
#pragma once

#include "tribo/onset_criterion.hpp"
#include "tribo/starvation.hpp"

namespace tribo {

template <class T>
struct InletOnsets {
  T film_maximum;           // r = h_ff/h_oil at the maximum of y r; NaN where there is none
  T film_ratio_at_maximum;  // y there
  T departure;              // ε
  T film_departure;         // r at which y = 1 − ε
};

// The onsets that `criterion` needs; the other onsets are NaN.
template <class T>
InletOnsets<T> inlet_onsets(StarvationClosure closure, const T& damiens_exponent,
                            const T& departure, OnsetCriterion criterion) {
  InletOnsets<T> onsets{quiet_nan<T>(), quiet_nan<T>(), departure, quiet_nan<T>()};
  if (criterion == OnsetCriterion::film_departure)
    onsets.film_departure = departure_flooded_over_inlet(closure, departure, damiens_exponent);
  if (criterion != OnsetCriterion::film_maximum && criterion != OnsetCriterion::asperity_minimum)
    return onsets;
  onsets.film_maximum = film_maximum_flooded_over_inlet<T>(closure);
  if (onsets.film_maximum == onsets.film_maximum)
    onsets.film_ratio_at_maximum = starvation_ratio(closure, onsets.film_maximum, damiens_exponent);
  return onsets;
}

}  // namespace tribo
