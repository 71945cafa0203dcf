// SPDX-License-Identifier: Apache-2.0
// One reading of the paper, item by item.
#pragma once

#include <vector>

#include "reproduction/inputs.hpp"
#include "reproduction/observation.hpp"

namespace tribo::reproduction {

struct ItemResult {
  Observed observed;
  Verdict verdict;
  std::optional<Margin> margin;  // of the verdict; empty where there is no number

  bool is_decided() const { return !margin || margin->is_decided(); }
};
ItemResult judged(const Item& item, const Observed& observed);

// The results of all items, in their order.
std::vector<ItemResult> evaluate(const PaperScenes& scenes, const Reading& reading,
                                 const std::vector<Item>& items);

// The result of one item; computes only the stages that this item needs.
Observed evaluate(const PaperScenes& scenes, const Reading& reading, const Item& item);

// The reading's film constant, 2.69(1 − 0.61 e^{−0.73}) or 2.69, times film_constant_scale.
double film_constant(const PaperScenes& scenes, const Reading& reading);

// The asperities' share of the load at the lowest speed; `contact` is the index of a ContactName.
double slow_asperity_share(const PaperScenes& scenes, const Reading& reading, std::size_t contact);

// λ under the reading is the film divided by this number times σ_s.
inline double lambda_divisor(const Reading& reading) {
  return reading.is(Switch::lambda_scale, 1) ? 1.4 : 1;
}

// One contact's onset by the criterion `choice`. Only friction_minimum uses `law`. Empty: no onset.
std::optional<OnsetPoint> onset_of(const FloodedCurve& flooded, const StarvedCurve& starved,
                                   const ReadInlet& inlet, const OnsetChoice& choice,
                                   FrictionLaw law);

// Verdict of each claim, in the order of claim_names().
std::vector<Verdict> claim_verdicts(const std::vector<Item>& items,
                                    const std::vector<ItemResult>& results);
// Are the verdicts of all items of the claim decided, whatever the numerical errors?
bool is_decided(const std::string& claim, const std::vector<Item>& items,
                const std::vector<ItemResult>& results);

}  // namespace tribo::reproduction
