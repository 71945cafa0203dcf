// SPDX-License-Identifier: Apache-2.0
// The names of the onset criteria; onset.hpp says what they are.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace tribo {

enum class OnsetCriterion : std::uint8_t {
  film_maximum,
  film_departure,
  friction_minimum,
  asperity_minimum
};
inline constexpr std::array<OnsetCriterion, 4> onset_criteria{
    OnsetCriterion::film_maximum, OnsetCriterion::film_departure, OnsetCriterion::friction_minimum,
    OnsetCriterion::asperity_minimum};

constexpr std::string_view name(OnsetCriterion criterion) {
  constexpr std::array<std::string_view, 4> names{"film_maximum", "film_departure",
                                                  "friction_minimum", "asperity_minimum"};
  return names[static_cast<std::size_t>(criterion)];
}

inline constexpr double default_departure = 0.05;  // ε of film_departure

}  // namespace tribo
