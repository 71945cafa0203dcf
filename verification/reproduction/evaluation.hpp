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
  std::optional<Margin> margin;  // of the verdict; none where there is no number

  bool is_decided() const { return !margin || margin->is_decided(); }
};
ItemResult judged(const Item& item, const Observed& observed);

// In the order of the items.
std::vector<ItemResult> evaluate(const PaperScenes& scenes, const Reading& reading,
                                 const std::vector<Item>& items);

// One item alone: computes only what it rests on.
Observed evaluate(const PaperScenes& scenes, const Reading& reading, const Item& item);

// The constant in the place of 2.69(1 − 0.61 e^{−0.73}) in a reading, times the scale on it.
double film_constant(const PaperScenes& scenes, const Reading& reading);

// The asperities' share at the lowest speed in a contact (ContactName).
double slow_asperity_share(const PaperScenes& scenes, const Reading& reading, std::size_t contact);

// The number that λ divides the film by, over σ_s.
inline double lambda_divisor(const Reading& reading) {
  return reading.is(Switch::lambda_scale, 1) ? 1.4 : 1;
}

// One contact's onset by the criterion of the reading; friction by `law` where the criterion needs
// it.
std::optional<OnsetPoint> onset_of(const FloodedCurve& flooded, const StarvedCurve& starved,
                                   const ReadInlet& inlet, const OnsetChoice& choice,
                                   FrictionLaw law);

// Verdict of each claim, in the order of claim_names().
std::vector<Verdict> claim_verdicts(const std::vector<Item>& items,
                                    const std::vector<ItemResult>& results);
// Is each of the claim's verdicts decided, whatever the numerical errors?
bool is_decided(const std::string& claim, const std::vector<Item>& items,
                const std::vector<ItemResult>& results);

}  // namespace tribo::reproduction
