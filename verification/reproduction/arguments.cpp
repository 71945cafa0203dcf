// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

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

using Value = std::function<std::optional<double>(const PaperScenes&)>;

// The scenes with one input at the least (side −1) or greatest value that prints alike.
PaperScenes at_end(PaperScenes scenes, const Input& input, int side) {
  for (std::size_t i = 0; i < contact_count; ++i)
    if (input.is_of(i))
      scale(scenes, i, input.field, 1 + side * input.last_digit / (2 * input.value));
  return scenes;
}

// Makes candidates with the interval that the print precision of their inputs leaves open. A value
// is monotonic in each input, so that the ends of its interval lie at two corners of the inputs.
class Candidates {
 public:
  Candidates(const PaperScenes& scenes, const std::vector<Input>& inputs)
      : scenes_(scenes), inputs_(inputs) {}

  Candidate operator()(std::string name, const Value& value) const {
    Candidate made{std::move(name), value(scenes_), {}, {}, false};
    if (!made.value) return made;
    PaperScenes least = scenes_, greatest = scenes_;
    for (const Input& input : inputs_) {
      const int rises = direction(input, value, *made.value);
      if (rises == 0) continue;
      least = at_end(std::move(least), input, -rises);
      greatest = at_end(std::move(greatest), input, rises);
    }
    made.low = value(least);
    made.high = value(greatest);
    return made;
  }

 private:
  // 1 where the value rises with the input, −1 where it falls, 0 where it does not depend on it.
  int direction(const Input& input, const Value& value, double here) const {
    std::optional<double> there = value(at_end(scenes_, input, 1));
    const int side = there ? 1 : -1;
    if (!there) there = value(at_end(scenes_, input, -1));
    if (!there || *there == here) return 0;
    return *there > here ? side : -side;
  }

  const PaperScenes& scenes_;
  const std::vector<Input>& inputs_;
};

// A candidate from published formulas alone, which have no print error.
Candidate exact(std::string name, double value) {
  return {std::move(name), value, value, value, false};
}

Argument decided(Argument argument) {
  for (Candidate& one : argument.candidates)
    one.agrees = one.value && one.high.value_or(argument.low) >= argument.low &&
                 one.low.value_or(argument.high) <= argument.high;
  return argument;
}

// A = (K F_{5/2})^q. At equal λ, K of the rough surface is twice that of the smooth surface.
Argument sharing_exponent(const PaperScenes& scenes, const std::vector<Item>& items,
                          const Candidates& candidate) {
  const Printed a = printed(items, "C4.rough"), b = printed(items, "C4.smooth");
  const auto stiffness = [](const Scene& s) {
    return std::pow(s.surface.summit_density * s.surface.summit_radius * s.surface.summit_height_sd,
                    2) *
           std::sqrt(s.surface.summit_height_sd / s.surface.summit_radius);
  };
  const auto ratio = [&](const PaperScenes& changed) {
    return stiffness(changed.scene[roughest]) / stiffness(changed.scene[smoothest]);
  };
  const auto shares = [](const PaperScenes& changed) {
    return slow_asperity_share(changed, corrected_reading(), roughest) /
           slow_asperity_share(changed, corrected_reading(), smoothest);
  };
  const double here = ratio(scenes);
  return decided(
      {"the exponent q of A = (K F_5/2)^q, from the ratio of the asperity shares at low speed, "
       "rough over smooth",
       fmt::format("{}/{} = {:.3g}", a.value, b.value, a.value / b.value),
       a.low / b.high,
       a.high / b.low,
       {candidate(fmt::format("q = 1/2, equal separations: {:.3g}^1/2", here),
                  [&](const PaperScenes& changed) { return std::sqrt(ratio(changed)); }),
        candidate("q = 1/2, the separations that come out", shares),
        candidate(fmt::format("q = 1, equal separations: {:.3g}", here), ratio),
        candidate("q = 1, the same separations",
                  [&](const PaperScenes& changed) { return std::pow(shares(changed), 2); })}});
}

// At the greatest film λ is h_oil/σ_s times a number that depends on the inlet alone.
Argument onset_film_parameter(const std::vector<Item>& items, const Candidates& candidate) {
  const Printed lambda = printed(items, "C2.smooth");
  Argument argument{"the inlet, from λ at the greatest film, whatever the surface",
                    fmt::format("{}", lambda.value),
                    lambda.low,
                    lambda.high,
                    {},
                    "C2"};
  for (std::uint8_t rule = 0; rule < 4; ++rule)
    for (std::uint8_t gap = 0; gap < 2; ++gap) {
      const Reading reading = with(Switch::gap, gap, with(Switch::inlet, rule));
      const ReadInlet inlet(reading);
      const bool is_as_printed = inlet.rule() == InletRule::as_printed;
      argument.candidates.push_back(
          candidate(fmt::format("{}, {} gap{}", info(Switch::inlet).choices[rule],
                                info(Switch::gap).choices[gap],
                                is_as_printed     ? ": at every speed"
                                : inlet.maximum() ? ""
                                                  : ": no greatest film"),
                    [&](const PaperScenes& changed) -> std::optional<double> {
                      if (!is_as_printed && !inlet.maximum()) return std::nullopt;
                      const double r = is_as_printed ? 1 : *inlet.maximum();
                      return changed.scene[smoothest].supply.value * r * inlet.film_ratio(r);
                    }));
      argument.candidates.back().reading = reading;
    }
  // 1.4 is printed to two digits too.
  Candidate by_sigma = argument.candidates.front();
  by_sigma.name = "flooded_inlet, line gap, λ by σ = 1.4σ_s";
  by_sigma.value = *by_sigma.value / 1.4;
  by_sigma.low = *by_sigma.low / 1.45;
  by_sigma.high = *by_sigma.high / 1.35;
  by_sigma.reading = with(Switch::lambda_scale, 1);
  argument.candidates.push_back(std::move(by_sigma));
  return decided(std::move(argument));
}

Argument film_formula(const PaperScenes& scenes, const std::vector<Item>& items) {
  const Printed constant = printed(items, "C17");
  return decided(
      {"the constant of the film formula",
       fmt::format("{}", constant.value),
       constant.low,
       constant.high,
       {exact("2.69 (1 − 0.61 e^−0.73)", film_constant(scenes, corrected_reading())),
        exact("2.69 (1 − 0.6 e^−0.73), as 1.20 prints it", 2.69 * (1 - 0.6 * std::exp(-0.73))),
        exact("2.69, the bracket dropped",
              film_constant(scenes, with(Switch::film_constant, 1)))}});
}

// D_d = 0.82σ in units of σ_s, against Table 1's D_d. Both 0.82 and 1.4 have two printed digits.
Argument plane_offset(const PaperScenes& scenes, const std::vector<Input>& inputs) {
  const double offset = scenes.scene[smoothest].surface.summit_plane_offset;
  const auto precision = std::find_if(inputs.begin(), inputs.end(), [](const Input& one) {
    return one.field == Field::summit_plane_offset;
  });
  const double half = precision == inputs.end() ? 0 : precision->last_digit / 2;
  return decided(
      {"σ against σ_s, from D_d = 0.82 σ (Whitehouse and Archard), the factor 1.4 and "
       "Table 1's D_d",
       fmt::format("{}", offset),
       offset - half,
       offset + half,
       {{"σ = 1.4 σ_s: 0.82·1.4", 0.82 * 1.4, 0.815 * 1.35, 0.825 * 1.45, false},
        {"σ_s = 1.4 σ, as 1.8 prints it: 0.82/1.4", 0.82 / 1.4, 0.815 / 1.45, 0.825 / 1.35,
         false}}});
}

Argument summit_radius(const std::vector<Item>& items, const Candidates& candidate) {
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
      {"β = 0.1 µm, offset 2D_d", with(Switch::offset_planes, 1, small)},
      {"β = 10 µm, offset 2D_d", two_planes},
      {"β = 10 µm, offset 2D_d, 8√2/15", with(Switch::asperity_prefactor, 1, two_planes)},
      {"β = 10 µm, offset 2D_d, A_nom = a²", with(Switch::nominal_area, 1, two_planes)},
      {"β = 10 µm, offset 2D_d, A_nom = a², 8√2/15",
       with(Switch::asperity_prefactor, 1, with(Switch::nominal_area, 1, two_planes))}};
  for (const auto& entry : readings)
    argument.candidates.push_back(candidate(entry.first, [&](const PaperScenes& changed) {
      return slow_asperity_share(changed, entry.second, smoothest);
    }));
  return decided(std::move(argument));
}

// A criterion on r alone gives the same λ on all surfaces. Then u ∝ σ_s^{1/0.67}, apart from load
// sharing.
Argument onset_spacing(const PaperScenes& scenes, const std::vector<Item>& items,
                       const Candidates& candidate, std::string_view above, std::size_t upper,
                       std::string_view below, std::size_t lower) {
  const Printed a = printed(items, fmt::format("C1.{}", above));
  const Printed b = printed(items, fmt::format("C1.{}", below));
  Argument argument{
      fmt::format("the criterion, from the ratio of the onset speeds, {} over {}", above, below),
      fmt::format("{}/{} = {:.3g}", a.value, b.value, a.value / b.value),
      a.low / b.high,
      a.high / b.low,
      {}};
  argument.candidates.push_back(
      candidate("σ_s^1/0.67, no load sharing", [&](const PaperScenes& changed) {
        return decimal_power(changed.scene[upper].surface.summit_height_sd /
                                 changed.scene[lower].surface.summit_height_sd,
                             inverse(hamrock_dowson_central_law.speed_exponent));
      }));
  const std::vector<double> speeds =
      speed_grid(scenes.scene[0].speeds.from, scenes.scene[0].speeds.to);
  for (std::size_t k = 0; k < onset_choices.size(); ++k) {
    const Reading reading = with(Switch::criterion, static_cast<std::uint8_t>(k));
    const ReadInlet inlet(reading);
    const auto onset = [&](const PaperScenes& changed, std::size_t i) {
      const FloodedCurve flooded =
          flooded_curve(ReadContact(changed.scene[i], reading, changed.film_scale()), speeds);
      return onset_of(flooded, starved_curve(flooded, inlet, speeds), inlet, reading.onset(),
                      friction_law(reading));
    };
    argument.candidates.push_back(
        candidate(std::string(info(Switch::criterion).choices[k]),
                  [&](const PaperScenes& changed) -> std::optional<double> {
                    const auto high = onset(changed, upper), low = onset(changed, lower);
                    if (!high || !low) return std::nullopt;
                    return high->speed / low->speed;
                  }));
  }
  return decided(std::move(argument));
}

}  // namespace

std::size_t Argument::agreeing() const {
  return static_cast<std::size_t>(std::count_if(candidates.begin(), candidates.end(),
                                                [](const Candidate& one) { return one.agrees; }));
}

void keep_what_print_precision_identifies(std::vector<ItemStatistics>& statistics,
                                          const std::vector<Item>& items,
                                          const std::vector<Argument>& arguments) {
  const auto is_open = [](const Argument& argument, const Identification& found) {
    return std::any_of(
        argument.candidates.begin(), argument.candidates.end(), [&](const auto& one) {
          return one.agrees && one.reading &&
                 one.reading->choice[static_cast<std::size_t>(found.which)] != found.choice;
        });
  };
  for (const Argument& argument : arguments)
    for (std::size_t i = 0; i < items.size(); ++i)
      if (items[i].claim == argument.claim)
        std::erase_if(statistics[i].identified,
                      [&](const Identification& found) { return is_open(argument, found); });
}

std::vector<Argument> arguments(const PaperScenes& scenes, const std::vector<Item>& items,
                                const std::vector<Input>& inputs) {
  const Candidates candidate(scenes, inputs);
  return {sharing_exponent(scenes, items, candidate),
          onset_film_parameter(items, candidate),
          onset_spacing(scenes, items, candidate, "medium", 1, "smooth", 2),
          onset_spacing(scenes, items, candidate, "rough", 0, "medium", 1),
          summit_radius(items, candidate),
          film_formula(scenes, items),
          plane_offset(scenes, inputs)};
}

}  // namespace tribo::reproduction
