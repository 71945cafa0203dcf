// SPDX-License-Identifier: Apache-2.0
// Readings of the paper. Each open or misprinted place of it is a switch, and a reading is one
// choice at each switch. The authors may have computed with any reading. The model knows only the
// corrected one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <string>
#include <string_view>

namespace tribo::reproduction {

enum class Switch : std::uint8_t {
  asperity_prefactor,
  nominal_area,
  offset_planes,
  inlet,
  gap,
  summit_radius,
  shear,
  viscosity,
  lambda_scale,
  speed_modulus,
  material_modulus,
  load_modulus,
  speed,
  film_constant,
  criterion,
};
inline constexpr std::size_t switch_count = 15;

// The choices of the switch `offset_planes`, in its order: m in the offset δ = m D_d/σ_s. It is 1
// for one rough face, 2 for two as printed, and 2/√2 for two equal faces if the printed D_d/σ_s is
// that of one face and the printed σ_s that of their sum. The paper does not say which m it used.
inline constexpr std::array offset_planes{1.0, 2.0, std::numbers::sqrt2};

// The choices of the switch `inlet`, in its order.
enum class InletRule : std::uint8_t { flooded_inlet, starved_inlet, printed_exponents, as_printed };

// The choices of the switch `criterion`: what counts as the onset.
enum class OnsetRule : std::uint8_t {
  film_maximum,
  film_departure,
  friction_minimum,
  asperity_minimum
};
struct OnsetChoice {
  OnsetRule rule;
  double departure;  // ε of film_departure, else 0
};
inline constexpr std::array onset_choices{
    OnsetChoice{OnsetRule::film_maximum, 0},      OnsetChoice{OnsetRule::film_departure, 0.01},
    OnsetChoice{OnsetRule::film_departure, 0.05}, OnsetChoice{OnsetRule::film_departure, 0.1},
    OnsetChoice{OnsetRule::film_departure, 0.2},  OnsetChoice{OnsetRule::film_departure, 0.3},
    OnsetChoice{OnsetRule::friction_minimum, 0},  OnsetChoice{OnsetRule::asperity_minimum, 0}};

struct SwitchInfo {
  std::string_view name;
  std::string_view errata;  // "E3", "E10, E11"
  std::span<const std::string_view> choices;
  std::uint8_t corrected;  // the choice of the model
  std::uint8_t literal;    // the choice that follows the print
  std::string_view meaning;
};
const SwitchInfo& info(Switch which);

struct Reading {
  std::array<std::uint8_t, switch_count> choice{};

  std::uint8_t at(Switch which) const { return choice[static_cast<std::size_t>(which)]; }
  std::uint8_t& at(Switch which) { return choice[static_cast<std::size_t>(which)]; }
  bool is(Switch which, std::uint8_t index) const { return at(which) == index; }
  InletRule inlet() const { return static_cast<InletRule>(at(Switch::inlet)); }
  const OnsetChoice& onset() const { return onset_choices[at(Switch::criterion)]; }
  friend bool operator==(const Reading&, const Reading&) = default;
};

Reading corrected_reading();
Reading literal_reading();
// A reading with another choice at one switch.
Reading with(Switch which, std::uint8_t choice, Reading reading = corrected_reading());

// All combinations, numbered 0 … reading_count() − 1; the first switch turns slowest.
std::size_t reading_count();
Reading reading_at(std::size_t index);
std::size_t index_of(const Reading& reading);

// The departures from the corrected reading, such as "inlet=printed_exponents speed=sum". If there
// are none, the text is "corrected".
std::string departures(const Reading& reading);

// Sets one switch from "speed=sum". Throws std::invalid_argument that names the allowed choices,
// and for an unknown switch the nearest known name.
void set_switch(Reading& reading, std::string_view assignment);

}  // namespace tribo::reproduction
