// SPDX-License-Identifier: Apache-2.0
#include "reproduction/enumeration.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "sweep/on_threads.hpp"

namespace tribo::reproduction {
namespace {

constexpr std::size_t inlet_count = 8;  // rule × gap
constexpr std::size_t law_count = 6;    // shear × viscosity
constexpr std::array gt_switches{Switch::asperity_prefactor, Switch::nominal_area,
                                 Switch::offset_planes, Switch::summit_radius};
constexpr std::array gw_switches{Switch::nominal_area, Switch::summit_radius};
constexpr std::array film_switches{Switch::speed_modulus, Switch::material_modulus,
                                   Switch::load_modulus, Switch::speed, Switch::film_constant};

// Sets switches to the digits of a number, the first switch turning fastest.
template <std::size_t n>
void set_digits(Reading& reading, const std::array<Switch, n>& which, std::size_t number) {
  for (const Switch one : which) {
    const std::size_t choices = info(one).choices.size();
    reading.at(one) = static_cast<std::uint8_t>(number % choices);
    number /= choices;
  }
}
template <std::size_t n>
std::size_t combinations(const std::array<Switch, n>& which) {
  std::size_t count = 1;
  for (const Switch one : which) count *= info(one).choices.size();
  return count;
}

void set_inlet(Reading& reading, std::size_t number) {
  set_digits(reading, std::array{Switch::inlet, Switch::gap}, number);
}
void set_law(Reading& reading, std::size_t number) {
  set_digits(reading, std::array{Switch::shear, Switch::viscosity}, number);
}
Reading with_law(std::size_t number) {
  Reading reading;
  set_law(reading, number);
  return reading;
}

// The choices of the film's switches that give the same film formula. There are one or two: E* in
// place of E′ doubles U, and so does the sum of the speeds in place of their mean.
struct FilmGroup {
  std::vector<std::size_t> numbers;  // of film_switches
};
std::vector<FilmGroup> film_groups() {
  std::vector<FilmGroup> groups;
  for (std::size_t number = 0; number < (std::size_t{1} << film_switches.size()); ++number) {
    const bool speed_modulus = (number & 1U) != 0, speed = (number & 8U) != 0;
    const std::size_t twin = number ^ 9U;
    if (speed_modulus != speed && twin < number) {
      for (FilmGroup& group : groups)
        if (group.numbers.front() == twin) group.numbers.push_back(number);
    } else {
      groups.push_back({{number}});
    }
  }
  return groups;
}

// The results of one contact with one film formula and one inlet.
struct Branch {
  StarvedCurve starved;
  std::array<FrictionCurve, law_count> friction;
  std::array<std::optional<OnsetPoint>, onset_choices.size()> onset;  // without friction_minimum
  std::array<std::optional<OnsetPoint>, law_count> friction_minimum;
};

Branch branch(const FloodedCurve& flooded, const ReadInlet& inlet,
              const std::vector<double>& speeds) {
  Branch made;
  made.starved = starved_curve(flooded, inlet, speeds);
  for (std::size_t law = 0; law < law_count; ++law) {
    const FrictionLaw laws = friction_law(with_law(law));
    made.friction[law] = friction_curve(flooded, made.starved, laws);
    made.friction_minimum[law] =
        friction_minimum(flooded, made.starved, made.friction[law], inlet, laws);
  }
  for (std::size_t k = 0; k < onset_choices.size(); ++k)
    if (onset_choices[k].rule != OnsetRule::friction_minimum)
      made.onset[k] = explicit_onset(flooded.contact, inlet, onset_choices[k]);
  return made;
}

// The items that are reproduced, those that had to be refined, and those that are not decided.
struct Masks {
  ItemMask reproduced = 0, refined = 0, undecided = 0;

  Masks operator|(const Masks& other) const {
    return {reproduced | other.reproduced, refined | other.refined, undecided | other.undecided};
  }
};

Masks judged(const std::vector<Item>& items, const Stages& stages, Stage what,
             std::optional<bool> film_parameter = std::nullopt) {
  Masks masks;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Item& item = items[i];
    if (stage(item.quantity) != what) continue;
    if (film_parameter && *film_parameter != (item.quantity == Quantity::onset_film_parameter))
      continue;
    Observed observed = observe(item, stages, Effort::grid);
    if (!is_sure(item, observed)) {
      observed = observe(item, stages, Effort::refined);
      masks.refined |= 1U << i;
      if (!is_sure(item, observed)) masks.undecided |= 1U << i;
    }
    if (judge(item, observed) == Verdict::reproduced) masks.reproduced |= 1U << i;
  }
  return masks;
}

class Enumerator {
 public:
  Enumerator(const PaperScenes& scenes, const std::vector<Item>& items)
      : scenes_(scenes),
        items_(items),
        speeds_(speed_grid(scenes.scene[0].speeds.from, scenes.scene[0].speeds.to)),
        groups_(film_groups()) {
    for (std::size_t number = 0; number < inlet_count; ++number) {
      Reading reading;
      set_inlet(reading, number);
      inlets_.emplace_back(reading, true);
    }
    for (std::vector<ItemMask>* const masks :
         {&result.items, &result.claims, &result.refined, &result.undecided})
      masks->resize(reading_count());
  }

  void run() {
    each_on_threads(0, groups_.size(), [&](std::size_t g) { film(groups_[g]); });
    result.films = groups_.size() * (3 * gt_count_ + gw_count_);
    result.inlets = result.films * inlet_count;
    result.friction_curves = result.inlets * law_count;
  }

  Enumeration result;

 private:
  FloodedCurve flooded(const Reading& reading, ContactName name) const {
    const auto i = static_cast<std::size_t>(name);
    return flooded_curve(ReadContact(scenes_.scene[i], reading, scenes_.film_scale()), speeds_);
  }

  void film(const FilmGroup& group) {
    Reading reading;
    set_digits(reading, film_switches, group.numbers.front());
    std::vector<FloodedCurve> gw;
    std::vector<Branch> gw_branches;  // [gw × inlet]
    for (std::size_t number = 0; number < gw_count_; ++number) {
      set_digits(reading, gw_switches, number);
      gw.push_back(flooded(reading, ContactName::smooth_gw));
      for (const ReadInlet& inlet : inlets_)
        gw_branches.push_back(branch(gw.back(), inlet, speeds_));
    }
    for (std::size_t number = 0; number < gt_count_; ++number) {
      set_digits(reading, gt_switches, number);
      const std::array<FloodedCurve, 3> gt{flooded(reading, ContactName::rough),
                                           flooded(reading, ContactName::medium),
                                           flooded(reading, ContactName::smooth)};
      const std::size_t k =
          reading.at(Switch::nominal_area) + 2U * reading.at(Switch::summit_radius);
      for (std::size_t i = 0; i < inlet_count; ++i) {
        set_inlet(reading, i);
        const std::array<Branch, 3> branches{branch(gt[0], inlets_[i], speeds_),
                                             branch(gt[1], inlets_[i], speeds_),
                                             branch(gt[2], inlets_[i], speeds_)};
        judge_all(group, reading, inlets_[i], {&gt[0], &gt[1], &gt[2], &gw[k]},
                  {&branches[0], &branches[1], &branches[2], &gw_branches[k * inlet_count + i]});
      }
    }
  }

  void judge_all(const FilmGroup& group, Reading reading, const ReadInlet& inlet,
                 const PerContact<const FloodedCurve*>& flooded,
                 const PerContact<const Branch*>& branches) {
    Stages stages{};
    stages.inlet = &inlet;
    stages.flooded = flooded;
    for (std::size_t c = 0; c < contact_count; ++c) stages.starved[c] = &branches[c]->starved;
    stages.film_constant = film_constant(scenes_, reading);
    const Masks base =
        judged(items_, stages, Stage::films) | judged(items_, stages, Stage::constant);
    for (std::size_t law = 0; law < law_count; ++law) {
      set_law(reading, law);
      stages.law = friction_law(reading);
      for (std::size_t c = 0; c < contact_count; ++c)
        stages.friction[c] = &branches[c]->friction[law];
      const Masks with_friction = base | judged(items_, stages, Stage::friction);
      for (std::size_t k = 0; k < onset_choices.size(); ++k)
        judge_onset(group, reading, k, law, stages, branches, with_friction);
    }
  }

  void judge_onset(const FilmGroup& group, Reading reading, std::size_t criterion, std::size_t law,
                   Stages& stages, const PerContact<const Branch*>& branches, Masks masks) {
    reading.at(Switch::criterion) = static_cast<std::uint8_t>(criterion);
    const bool by_friction = onset_choices[criterion].rule == OnsetRule::friction_minimum;
    for (std::size_t c = 0; c < contact_count; ++c)
      stages.onsets[c] =
          by_friction ? branches[c]->friction_minimum[law] : branches[c]->onset[criterion];
    masks = masks | judged(items_, stages, Stage::onsets, false);
    for (std::uint8_t scale = 0; scale < 2; ++scale) {
      reading.at(Switch::lambda_scale) = scale;
      stages.lambda_divisor = lambda_divisor(reading);
      const Masks all = masks | judged(items_, stages, Stage::onsets, true);
      for (const std::size_t number : group.numbers) {
        set_digits(reading, film_switches, number);
        const std::size_t index = index_of(reading);
        result.items[index] = all.reproduced;
        result.claims[index] = claims_of(all.reproduced, items_);
        result.refined[index] = all.refined;
        result.undecided[index] = all.undecided;
      }
    }
  }

  const PaperScenes& scenes_;
  const std::vector<Item>& items_;
  const std::vector<double> speeds_;
  const std::vector<FilmGroup> groups_;
  const std::size_t gt_count_ = combinations(gt_switches);
  const std::size_t gw_count_ = combinations(gw_switches);
  std::vector<ReadInlet> inlets_;
};

}  // namespace

ItemMask claims_of(ItemMask items_reproduced, const std::vector<Item>& items) {
  ItemMask claims = 0;
  std::size_t claim = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i == 0)
      claims = 1;
    else if (items[i].claim != items[i - 1].claim)
      claims |= 1U << ++claim;
    if ((items_reproduced >> i & 1U) == 0) claims &= ~(1U << claim);
  }
  return claims;
}

Enumeration enumerate(const PaperScenes& scenes, const std::vector<Item>& items) {
  Enumerator enumerator(scenes, items);
  enumerator.run();
  return std::move(enumerator.result);
}

}  // namespace tribo::reproduction
