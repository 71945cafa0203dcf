// SPDX-License-Identifier: Apache-2.0
// The outputs of an operating point as answers show them: each has a value, or a reason why it is
// undefined.
#pragma once

#include <string_view>

#include "tribo/operating_point.hpp"
#include "tribo/scene.hpp"
#include "tribo/smooth_contact.hpp"

namespace tribo::protocol {

inline constexpr std::string_view beyond_double = "outside the range of double precision";
inline constexpr std::string_view film_collapsed =
    "the film has collapsed: nothing balances the load";
inline constexpr std::string_view unknown_summits =
    "Λ is below 3: the faces touch, and Rq alone does not say what their summits carry";
inline constexpr std::string_view beyond_solved_films =
    "Moes' M or L is outside the tables of solved films, so that \"solved\" in closures has no "
    "film "
    "there";

// An output of an operating point as every format shows it. It is one of three: a reason why it is
// undefined, a word, or a finite number.
struct OutputValue {
  std::string_view undefined;
  std::string_view word;
  double number = 0;
};

// `output` must not be one of smooth_outputs(), because a point does not hold these.
OutputValue value_of(const OperatingPoint<double>& point, Output output);
// Takes any output. `smooth` is the scene's smooth contact; it may be null only if
// needs_smooth_contact(scene) is false. The point must be solved with the outputs of needed_for()
// (answers.hpp).
OutputValue value_of(const OperatingPoint<double>& point, const SmoothContact* smooth,
                     Output output);
bool needs_smooth_contact(const Scene& scene);

}  // namespace tribo::protocol
