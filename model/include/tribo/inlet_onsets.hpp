// SPDX-License-Identifier: Apache-2.0
// The onsets of the inlet alone, at constant h_oil (model/README.md, section 9). They depend on the
// law of the inlet, and not on the contact.
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
InletOnsets<T> inlet_onsets(const InletLaw<T>& law, const T& departure, OnsetCriterion criterion) {
  InletOnsets<T> onsets{quiet_nan<T>(), quiet_nan<T>(), departure, quiet_nan<T>()};
  if (criterion == OnsetCriterion::film_departure)
    onsets.film_departure = law.at_departure(departure);
  if (criterion != OnsetCriterion::film_maximum && criterion != OnsetCriterion::asperity_minimum)
    return onsets;
  onsets.film_maximum = law.at_film_maximum();
  if (onsets.film_maximum == onsets.film_maximum)
    onsets.film_ratio_at_maximum = law.film_ratio(onsets.film_maximum);
  return onsets;
}

}  // namespace tribo
