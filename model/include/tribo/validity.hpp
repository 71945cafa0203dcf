// SPDX-License-Identifier: Apache-2.0
// Is the model valid for a scene? One table of what the model assumes: each limit has a word, a
// number that follows from the scene and its slowest and fastest speed, and bounds with a source.
// Beside it each number of a scene has a range that no real contact leaves. A scene may accept
// limits that it passes: accept = ["barus", "speed_range"].
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tribo/operating_point.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo {

template <class T>
class MixedContact;
struct FilmLaw;

// A limit, and the value that a scene has for it. The limit is passed where the value lies outside
// its bounds. The views' texts live as long as the program.
struct Validity {
  std::string_view word;              // "hertz_pressure"
  std::string_view assumption;        // a whole sentence; for a range the meaning of its field
  double value = 0;                   // in `unit`
  double least = 0, greatest = 0;     // the bounds, in `unit`; 0 and ∞: there is none
  std::string_view unit = "";         // empty: dimensionless
  std::string_view source = "";       // where the bounds come from; empty: a range of a field
  std::string_view field = "";        // whose range this is, "load"; else empty
  std::string_view likely_unit = "";  // the unit probably meant, where the value is not in range
  // The results that are wrong where the limit is passed, with all that follows from them:
  // "friction", of a solved film "pressure", "film", "shares, friction", or "everything".
  std::string_view touches = "everything";
  std::string advice = "";     // what passing it means, and what to do; empty: nothing to add
  bool value_follows = false;  // of a field: it follows from other given fields
  bool is_accepted = false;    // by the scene, whether it is passed or not
  // For a sweep: how many of its judged cases pass the limit. `value` is then that of the case
  // furthest beyond the limit, whose number is furthest_case.
  std::uint64_t cases = 0, judged_cases = 0, all_cases = 0, furthest_case = 0;

  bool is_known() const { return least != 0 || greatest < std::numeric_limits<double>::infinity(); }
  bool holds() const { return value >= least && value <= greatest; }
  bool is_passed() const { return !holds() && !is_accepted; }
  // The bound that is passed; where none is, the upper one if there is one.
  double limit() const;
};

// The words that a scene may accept: those of the assumptions, and after them "<field>_range" for
// each field whose numbers have a range.
std::span<const std::string_view> limit_words();
std::span<const std::string_view> assumption_words();

// The least ellipticity that a film law was fitted to, less the rounding of a ratio of two axes.
double least_fitted_ellipticity(const FilmLaw& law);

// The table "is the model valid here?": each assumption that concerns the scene, and each field
// whose number is outside its range. An assumption that the scene does not make is left out: one on
// summits without a surface, one on the film without a speed.
std::vector<Validity> validity_of(const Scene& scene, SceneUse use = SceneUse::speeds);

// The limits that the scene passes and does not accept: the user is warned of these.
std::vector<Validity> passed_limits(const Scene& scene, SceneUse use = SceneUse::speeds);

// The same for a scene as a reader made it, with one speed, whose point its contact has solved
// already. Nothing more is solved: limits on outputs that the point does not have are left out.
std::vector<Validity> passed_limits(const Scene& scene, const MixedContact<double>& contact,
                                    const OperatingPoint<double>& point);

}  // namespace tribo
