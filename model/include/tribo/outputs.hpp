// SPDX-License-Identifier: Apache-2.0
// The outputs of an operating point, under the names that scenes, tables and JSON use.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace tribo {

enum class Output : std::uint8_t {
  film_flooded,
  film,
  separation,
  film_parameter,
  asperity_load_share,
  fluid_load_share,
  real_area_ratio,
  summit_count,
  friction,
  regime,
  inlet,
  peak_pressure,
  mean_pressure,
  minimum_film,
  lambda_ratio,
};

// The values of the outputs that are words. The inlet is `collapsed` where there is no film. The
// regime is so where also no floor keeps the faces apart: nothing balances the load.
enum class Regime : std::uint8_t { boundary, mixed, elastohydrodynamic, collapsed };
enum class Inlet : std::uint8_t { flooded, starved, collapsed };
inline constexpr auto regime_words =
    std::to_array<std::string_view>({"boundary", "mixed", "elastohydrodynamic", "collapsed"});
inline constexpr auto inlet_words =
    std::to_array<std::string_view>({"flooded", "starved", "collapsed"});

constexpr std::string_view name(Regime regime) {
  return regime_words[static_cast<std::size_t>(regime)];
}
constexpr std::string_view name(Inlet inlet) {
  return inlet_words[static_cast<std::size_t>(inlet)];
}

struct OutputInfo {
  Output output;
  std::string_view name;
  std::string_view unit;  // empty: dimensionless
  std::string_view meaning;
  std::span<const std::string_view> words = {};  // empty: a number
  bool is_of_smooth_contact = false;  // no point holds it; only where a scene asks for its name
};

// In the order of Output: numbers of operating points first, then words, then the outputs that no
// point holds. The columns of tables and files have this order.
inline constexpr auto output_infos = std::to_array<OutputInfo>({
    {Output::film_flooded, "film_flooded", "m",
     "h_ff, film of the fully flooded contact with load sharing; the film law's h₀, which is that "
     "of smooth faces, is thinner"},
    {Output::film, "film", "m", "h*, film behind the starved inlet (h_ff without a supply)"},
    {Output::separation, "separation", "m", "max(h*, floor), the distance of the mean planes"},
    {Output::film_parameter, "film_parameter", "", "λ* = h*/σ_s"},
    {Output::asperity_load_share, "asperity_load_share", "",
     "A, part of the load on asperities; undefined where the film has collapsed and no floor keeps "
     "the faces apart"},
    {Output::fluid_load_share, "fluid_load_share", "",
     "1 − A, part of the load on the film; undefined where A is"},
    {Output::real_area_ratio, "real_area_ratio", "",
     "real area of contact over the nominal area, not clipped"},
    {Output::summit_count, "summit_count", "", "summits in contact"},
    {Output::friction, "friction", "",
     "μ, friction coefficient: μ_b A and the shear of the oil beside the summits, which adds to "
     "μ_b on a floor too; undefined where A is"},
    {Output::regime, "regime", "",
     "boundary, mixed or elastohydrodynamic, by the load shares; collapsed where these are "
     "undefined",
     regime_words},
    {Output::inlet, "inlet", "", "flooded, starved, or collapsed: without a film", inlet_words},
    {.output = Output::peak_pressure,
     .name = "peak_pressure",
     .unit = "Pa",
     .meaning = "p₀, greatest pressure of Hertz' dry, smooth contact",
     .is_of_smooth_contact = true},
    {.output = Output::mean_pressure,
     .name = "mean_pressure",
     .unit = "Pa",
     .meaning = "p̄, mean pressure of Hertz' dry, smooth contact",
     .is_of_smooth_contact = true},
    {.output = Output::minimum_film,
     .name = "minimum_film",
     .unit = "m",
     .meaning = "h_min, least film: h* times the part that the law of the least film is of "
                "closures.film; 0 where the film has collapsed",
     .is_of_smooth_contact = true},
    {.output = Output::lambda_ratio,
     .name = "lambda_ratio",
     .unit = "",
     .meaning = "Λ = h_min/Rq, Rq the composite roughness of both faces; not λ* = h*/σ_s",
     .is_of_smooth_contact = true},
});

// How many outputs are numbers of an operating point.
inline constexpr std::size_t number_count = [] {
  std::size_t count = 0;
  while (output_infos[count].words.empty()) ++count;
  return count;
}();

constexpr const OutputInfo& info(Output output) {
  return output_infos[static_cast<std::size_t>(output)];
}

constexpr std::optional<Output> output_by_name(std::string_view name) {
  for (const OutputInfo& row : output_infos)
    if (row.name == name) return row.output;
  return std::nullopt;
}

// A set of outputs, passed by value.
class OutputSet {
 public:
  constexpr OutputSet() = default;
  // All outputs of an operating point. Those of the smooth contact are asked for by name.
  static constexpr OutputSet all() {
    OutputSet set;
    for (const OutputInfo& row : output_infos)
      if (!row.is_of_smooth_contact) set.insert(row.output);
    return set;
  }
  constexpr void insert(Output output) { bits_ |= bit(output); }
  constexpr void erase(Output output) { bits_ &= ~bit(output); }
  constexpr bool contains(Output output) const { return (bits_ & bit(output)) != 0; }
  constexpr bool contains_any(OutputSet other) const { return (bits_ & other.bits_) != 0; }
  constexpr bool empty() const { return bits_ == 0; }
  friend constexpr bool operator==(OutputSet, OutputSet) = default;

 private:
  static constexpr std::uint32_t bit(Output output) {
    return std::uint32_t{1} << static_cast<unsigned>(output);
  }
  std::uint32_t bits_ = 0;
};

// The outputs that an operating point does not hold (smooth_contact.hpp).
constexpr OutputSet smooth_outputs() {
  OutputSet set;
  for (const OutputInfo& row : output_infos)
    if (row.is_of_smooth_contact) set.insert(row.output);
  return set;
}

// The outputs that depend on the balance of the load: an output that is computed from A belongs
// here.
constexpr OutputSet balance_outputs() {
  OutputSet set;
  for (const Output output :
       {Output::asperity_load_share, Output::fluid_load_share, Output::friction, Output::regime})
    set.insert(output);
  return set;
}

// The outputs that say what summits do.
constexpr OutputSet summit_outputs() {
  OutputSet set = balance_outputs();
  set.insert(Output::real_area_ratio);
  set.insert(Output::summit_count);
  return set;
}

// The outputs that a point must have so that the asked outputs follow from them. The film is added
// where the least film or Λ is asked. It is also added where it tells whether outputs are
// undefined: where only Rq of the faces is known (`knows_rq_alone`), or where a film may lie beyond
// the tables of solved films (`may_lack_film`).
constexpr OutputSet solved_outputs(OutputSet asked, bool knows_rq_alone, bool may_lack_film) {
  if (may_lack_film || asked.contains(Output::minimum_film) ||
      asked.contains(Output::lambda_ratio) ||
      (knows_rq_alone && asked.contains_any(summit_outputs())))
    asked.insert(Output::film);
  return asked;
}

}  // namespace tribo
