// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reproduction/ledger.hpp"
#include "tribo/film_thickness.hpp"

namespace tribo::reproduction {
namespace {

constexpr std::size_t roughest = 0, smoothest = 2;  // of the paper's three surfaces

struct Printed {
  double value, low, high;
};
Printed printed(const std::vector<Item>& items, std::string_view id) {
  for (const Item& item : items)
    if (item.id == id)
      return {item.reported, item.reported - item.last_digit / 2,
              item.reported + item.last_digit / 2};
  return {};
}

Argument decided(Argument argument) {
  for (Candidate& one : argument.candidates)
    one.agrees = one.value && *one.value >= argument.low && *one.value <= argument.high;
  return argument;
}

// A = (K F_{5/2})^q: between the rough and the smooth surface K doubles, at equal λ.
Argument sharing_exponent(const PaperScenes& scenes, const std::vector<Item>& items) {
  const Printed a = printed(items, "C4.rough"), b = printed(items, "C4.smooth");
  const auto stiffness = [&](std::size_t i) {
    const Scene& s = scenes.scene[i];
    return std::pow(s.surface.summit_density * s.surface.summit_radius * s.surface.summit_height_sd,
                    2) *
           std::sqrt(s.surface.summit_height_sd / s.surface.summit_radius);
  };
  const double ratio = stiffness(roughest) / stiffness(smoothest);
  const double shares = slow_asperity_share(scenes, corrected_reading(), roughest) /
                        slow_asperity_share(scenes, corrected_reading(), smoothest);
  return decided(
      {"the exponent q of A = (K F_5/2)^q, from the ratio of the asperity shares at low speed, "
       "rough over smooth",
       fmt::format("{}/{} = {:.3g}", a.value, b.value, a.value / b.value),
       a.low / b.high,
       a.high / b.low,
       {{fmt::format("q = 1/2, equal separations: {:.3g}^1/2", ratio), std::sqrt(ratio), false},
        {"q = 1/2, the separations that come out", shares, false},
        {fmt::format("q = 1, equal separations: {:.3g}", ratio), ratio, false},
        {"q = 1, the same separations", shares * shares, false}}});
}

Argument onset_film_parameter(const PaperScenes& scenes, const std::vector<Item>& items) {
  const Printed lambda = printed(items, "C2.smooth");
  Argument argument{"the inlet, from λ at the greatest film, whatever the surface",
                    fmt::format("{}", lambda.value),
                    lambda.low,
                    lambda.high,
                    {}};
  for (std::uint8_t rule = 0; rule < 4; ++rule)
    for (std::uint8_t gap = 0; gap < 2; ++gap) {
      const Reading reading = with(Switch::gap, gap, with(Switch::inlet, rule));
      const ReadInlet inlet(reading);
      const double ratio = scenes.scene[smoothest].supply.value;
      std::optional<double> value;
      if (inlet.rule() == InletRule::as_printed) value = ratio * inlet.film_ratio(1);
      if (inlet.maximum()) value = ratio * *inlet.maximum() * inlet.film_ratio(*inlet.maximum());
      argument.candidates.push_back(
          {fmt::format("{}, {} gap{}", info(Switch::inlet).choices[rule],
                       info(Switch::gap).choices[gap],
                       inlet.rule() == InletRule::as_printed ? ": at every speed"
                       : inlet.maximum()                     ? ""
                                                             : ": no greatest film"),
           value, false});
    }
  const ReadInlet inlet(corrected_reading());
  argument.candidates.push_back({"flooded_inlet, line gap, λ by σ = 1.4σ_s",
                                 scenes.scene[smoothest].supply.value * *inlet.maximum() *
                                     inlet.film_ratio(*inlet.maximum()) / 1.4,
                                 false});
  return decided(std::move(argument));
}

Argument film_formula(const PaperScenes& scenes, const std::vector<Item>& items) {
  const Printed constant = printed(items, "C17");
  return decided(
      {"the constant of the film formula",
       fmt::format("{}", constant.value),
       constant.low,
       constant.high,
       {{"2.69 (1 − 0.61 e^−0.73)", film_constant(scenes, corrected_reading()), false},
        {"2.69 (1 − 0.6 e^−0.73), as 1.20 prints it", 2.69 * (1 - 0.6 * std::exp(-0.73)), false},
        {"2.69, the bracket dropped", film_constant(scenes, with(Switch::film_constant, 1)),
         false}}});
}

// 0.82 σ in units of σ_s, beside Table 1's number. All three numbers are printed to a few digits,
// and the factors less precisely than Table 1's.
Argument plane_offset(const PaperScenes& scenes, const std::vector<Input>& inputs) {
  const double offset = scenes.scene[smoothest].surface.summit_plane_offset;
  const auto precision = std::find_if(inputs.begin(), inputs.end(), [](const Input& one) {
    return one.field == Field::summit_plane_offset;
  });
  const double half = precision == inputs.end() ? 0 : precision->last_digit / 2;
  const double factors = (1 + 0.005 / 0.82) * (1 + 0.05 / 1.4);
  return decided(
      {"σ against σ_s, from D_d = 0.82 σ (Whitehouse and Archard), the factor 1.4 and "
       "Table 1's D_d",
       fmt::format("{}", offset),
       (offset - half) / factors,
       (offset + half) * factors,
       {{"σ = 1.4 σ_s: 0.82·1.4", 0.82 * 1.4, false},
        {"σ_s = 1.4 σ, as 1.8 prints it: 0.82/1.4", 0.82 / 1.4, false}}});
}

Argument summit_radius(const PaperScenes& scenes, const std::vector<Item>& items) {
  const Printed share = printed(items, "C4.smooth");
  Argument argument{
      "β and what multiplies the asperities' load, from their share on the smooth surface at low "
      "speed",
      fmt::format("{}", share.value),
      share.low,
      share.high,
      {}};
  const Reading small = with(Switch::summit_radius, 1);
  const Reading two_planes = with(Switch::offset_planes, 1);
  const std::vector<std::pair<std::string, Reading>> readings{
      {"β = 10 µm", corrected_reading()},
      {"β = 0.1 µm", small},
      {"β = 0.1 µm, two offset planes", with(Switch::offset_planes, 1, small)},
      {"β = 10 µm, two offset planes", two_planes},
      {"β = 10 µm, two offset planes, 8√2/15", with(Switch::asperity_prefactor, 1, two_planes)},
      {"β = 10 µm, two offset planes, A_nom = a²", with(Switch::nominal_area, 1, two_planes)},
      {"β = 10 µm, two offset planes, A_nom = a², 8√2/15",
       with(Switch::asperity_prefactor, 1, with(Switch::nominal_area, 1, two_planes))}};
  for (const auto& [name, reading] : readings)
    argument.candidates.push_back({name, slow_asperity_share(scenes, reading, smoothest), false});
  return decided(std::move(argument));
}

// A criterion on r alone gives the same λ on all surfaces. Then u ∝ σ_s^{1/0.67}, apart from load
// sharing.
Argument onset_spacing(const PaperScenes& scenes, const std::vector<Item>& items,
                       std::string_view above, std::size_t upper, std::string_view below,
                       std::size_t lower) {
  const Printed a = printed(items, fmt::format("C1.{}", above));
  const Printed b = printed(items, fmt::format("C1.{}", below));
  Argument argument{
      fmt::format("the criterion, from the ratio of the onset speeds, {} over {}", above, below),
      fmt::format("{}/{} = {:.3g}", a.value, b.value, a.value / b.value),
      a.low / b.high,
      a.high / b.low,
      {}};
  const double sds =
      scenes.scene[upper].surface.summit_height_sd / scenes.scene[lower].surface.summit_height_sd;
  argument.candidates.push_back(
      {"σ_s^1/0.67, no load sharing",
       decimal_power(sds, inverse(hamrock_dowson_central_law.speed_exponent)), false});
  const std::vector<double> speeds =
      speed_grid(scenes.scene[0].speeds.from, scenes.scene[0].speeds.to);
  for (std::size_t k = 0; k < onset_choices.size(); ++k) {
    const Reading reading = with(Switch::criterion, static_cast<std::uint8_t>(k));
    const ReadInlet inlet(reading);
    const auto onset = [&](std::size_t i) {
      const FloodedCurve flooded =
          flooded_curve(ReadContact(scenes.scene[i], reading, scenes.film_scale()), speeds);
      return onset_of(flooded, starved_curve(flooded, inlet, speeds), inlet, reading.onset(),
                      friction_law(reading));
    };
    const auto high = onset(upper), low = onset(lower);
    std::optional<double> ratio;
    if (high && low) ratio = high->speed / low->speed;
    argument.candidates.push_back({std::string(info(Switch::criterion).choices[k]), ratio, false});
  }
  return decided(std::move(argument));
}

}  // namespace

std::size_t Argument::agreeing() const {
  return static_cast<std::size_t>(std::count_if(candidates.begin(), candidates.end(),
                                                [](const Candidate& one) { return one.agrees; }));
}

std::vector<Argument> arguments(const PaperScenes& scenes, const std::vector<Item>& items,
                                const std::vector<Input>& inputs) {
  return {sharing_exponent(scenes, items),
          onset_film_parameter(scenes, items),
          onset_spacing(scenes, items, "medium", 1, "smooth", 2),
          onset_spacing(scenes, items, "rough", 0, "medium", 1),
          summit_radius(scenes, items),
          film_formula(scenes, items),
          plane_offset(scenes, inputs)};
}

}  // namespace tribo::reproduction
