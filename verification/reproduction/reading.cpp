// SPDX-License-Identifier: Apache-2.0
#include "reproduction/reading.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

#include "scene/text.hpp"

namespace tribo::reproduction {
namespace {

using Names = std::string_view;
constexpr std::array prefactors{Names("16"), Names("8")};
constexpr std::array areas{Names("pi_a2"), Names("a2")};
constexpr std::array plane_counts{Names("1"), Names("2"), Names("equal_faces")};
constexpr std::array inlets{Names("flooded_inlet"), Names("starved_inlet"),
                            Names("printed_exponents"), Names("as_printed")};
constexpr std::array gaps{Names("line"), Names("point")};
constexpr std::array radii{Names("10um"), Names("0.1um")};
constexpr std::array shears{Names("eyring"), Names("limiting")};
constexpr std::array viscosities{Names("barus"), Names("ambient"), Names("roelands")};
constexpr std::array scales{Names("sigma_s"), Names("1.4sigma_s")};
constexpr std::array moduli{Names("2E*"), Names("E*")};
constexpr std::array speeds{Names("mean"), Names("sum")};
constexpr std::array constants{Names("1.899"), Names("2.69")};
constexpr std::array criteria{Names("film_maximum"),        Names("film_departure_0.01"),
                              Names("film_departure_0.05"), Names("film_departure_0.1"),
                              Names("film_departure_0.2"),  Names("film_departure_0.3"),
                              Names("friction_minimum"),    Names("asperity_minimum")};
static_assert(plane_counts.size() == offset_planes.size());
static_assert(criteria.size() == onset_choices.size());

constexpr std::array<SwitchInfo, switch_count> infos{{
    {"asperity_prefactor", "E3", prefactors, 0, 1,
     "16√2/15 or 8√2/15 in Greenwood and Tripp's load, with E*"},
    {"nominal_area", "E4", areas, 0, 1, "A_nom is πa², or a² as printed"},
    {"offset_planes", "E9", plane_counts, 0, 1,
     "m in GT's offset δ = m D_d/σ_s: 1; 2; or √2, for two equal faces with D_d/σ_s of one face "
     "and σ_s of their sum"},
    {"inlet", "E10, E11", inlets, 0, 3,
     "ψ at the flooded film; at the starved film; the same with the printed exponents; or "
     "equations 1.10 to 1.14 as printed"},
    {"gap", "E13", gaps, 0, 0,
     "Crook's constant 4√2/3 of a line contact, or 16√2/(3π) of a circular one"},
    {"summit_radius", "E17", radii, 0, 1, "β"},
    {"shear", "E19", shears, 0, 1, "the fluid's shear law, equation 1.30 or 1.31"},
    {"viscosity", "E20", viscosities, 0, 1, "viscosity under the fluid's pressure"},
    {"lambda_scale", "E8", scales, 0, 0, "what λ divides the film by: σ_s, or σ = 1.4σ_s"},
    {"speed_modulus", "E23", moduli, 0, 0, "modulus in the speed number U"},
    {"material_modulus", "E23", moduli, 0, 0, "modulus in the material number G"},
    {"load_modulus", "E23", moduli, 0, 0, "modulus in the load number W"},
    {"speed", "E24", speeds, 0, 0,
     "the film formula is fed the mean of the surface speeds, or their sum"},
    {"film_constant", "E25", constants, 0, 0,
     "2.69(1 − 0.61 e^−0.73), or 2.69 with the bracket dropped"},
    {"criterion", "–", criteria, 0, 0, "what counts as the onset of starvation"},
}};

Reading reading_of(std::uint8_t SwitchInfo::*choice) {
  Reading reading;
  for (std::size_t i = 0; i < switch_count; ++i) reading.choice[i] = infos[i].*choice;
  return reading;
}

}  // namespace

const SwitchInfo& info(Switch which) { return infos[static_cast<std::size_t>(which)]; }

Reading corrected_reading() { return reading_of(&SwitchInfo::corrected); }
Reading literal_reading() { return reading_of(&SwitchInfo::literal); }

Reading with(Switch which, std::uint8_t choice, Reading reading) {
  reading.at(which) = choice;
  return reading;
}

std::size_t reading_count() {
  std::size_t count = 1;
  for (const SwitchInfo& one : infos) count *= one.choices.size();
  return count;
}

Reading reading_at(std::size_t index) {
  Reading reading;
  for (std::size_t i = switch_count; i-- > 0;) {
    reading.choice[i] = static_cast<std::uint8_t>(index % infos[i].choices.size());
    index /= infos[i].choices.size();
  }
  return reading;
}

std::size_t index_of(const Reading& reading) {
  std::size_t index = 0;
  for (std::size_t i = 0; i < switch_count; ++i)
    index = index * infos[i].choices.size() + reading.choice[i];
  return index;
}

std::string departures(const Reading& reading) {
  std::string text;
  for (std::size_t i = 0; i < switch_count; ++i)
    if (reading.choice[i] != infos[i].corrected)
      text += fmt::format("{}{}={}", text.empty() ? "" : " ", infos[i].name,
                          infos[i].choices[reading.choice[i]]);
  return text.empty() ? "corrected" : text;
}

void set_switch(Reading& reading, std::string_view assignment) {
  const std::size_t split = assignment.find('=');
  const std::string_view name = assignment.substr(0, split);
  for (std::size_t i = 0; i < switch_count; ++i) {
    if (infos[i].name != name) continue;
    const std::string_view wanted =
        split == std::string_view::npos ? std::string_view() : assignment.substr(split + 1);
    for (std::size_t k = 0; k < infos[i].choices.size(); ++k)
      if (infos[i].choices[k] == wanted) {
        reading.choice[i] = static_cast<std::uint8_t>(k);
        return;
      }
    throw std::invalid_argument(fmt::format("{}: {} is not one of {}", name,
                                            wanted.empty() ? "nothing" : wanted,
                                            fmt::join(infos[i].choices, ", ")));
  }
  const SwitchInfo* nearest = &infos[0];
  for (const SwitchInfo& one : infos)
    if (scene_detail::edit_distance(name, one.name) <
        scene_detail::edit_distance(name, nearest->name))
      nearest = &one;
  throw std::invalid_argument(fmt::format("{}: no such switch; did you mean {}={}?", name,
                                          nearest->name, fmt::join(nearest->choices, "|")));
}

}  // namespace tribo::reproduction
