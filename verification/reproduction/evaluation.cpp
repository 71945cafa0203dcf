// SPDX-License-Identifier: Apache-2.0
#include "reproduction/evaluation.hpp"

#include "tribo/film_thickness.hpp"

namespace tribo::reproduction {
namespace {

// All stages of one reading, computed when they are first asked for.
class ReadingStages {
 public:
  ReadingStages(const PaperScenes& scenes, const Reading& reading)
      : reading_(reading),
        inlet_(reading),
        speeds_(speed_grid(scenes.scene[0].speeds.from, scenes.scene[0].speeds.to)) {
    for (std::size_t i = 0; i < contact_count; ++i) {
      flooded_.push_back(
          flooded_curve(ReadContact(scenes.scene[i], reading, scenes.film_scale()), speeds_));
      starved_.push_back(starved_curve(flooded_.back(), inlet_, speeds_));
    }
    stages_.inlet = &inlet_;
    stages_.law = friction_law(reading);
    for (std::size_t i = 0; i < contact_count; ++i) {
      stages_.flooded[i] = &flooded_[i];
      stages_.starved[i] = &starved_[i];
    }
    stages_.lambda_divisor = lambda_divisor(reading);
    stages_.film_constant = film_constant(scenes, reading);
  }
  ReadingStages(const ReadingStages&) = delete;
  ReadingStages& operator=(const ReadingStages&) = delete;

  const Stages& for_what(Stage what) {
    if (what == Stage::friction && friction_.empty()) {
      for (std::size_t i = 0; i < contact_count; ++i)
        friction_.push_back(friction_curve(flooded_[i], starved_[i], stages_.law));
      for (std::size_t i = 0; i < contact_count; ++i) stages_.friction[i] = &friction_[i];
    }
    if (what == Stage::onsets && !onsets_known_) {
      for (std::size_t i = 0; i < contact_count; ++i)
        stages_.onsets[i] =
            onset_of(flooded_[i], starved_[i], inlet_, reading_.onset(), stages_.law);
      onsets_known_ = true;
    }
    return stages_;
  }

 private:
  const Reading reading_;
  const ReadInlet inlet_;
  const std::vector<double> speeds_;
  std::vector<FloodedCurve> flooded_;
  std::vector<StarvedCurve> starved_;
  std::vector<FrictionCurve> friction_;
  bool onsets_known_ = false;
  Stages stages_;
};

}  // namespace

double film_constant(const PaperScenes& scenes, const Reading& reading) {
  return scenes.film_constant_scale *
         tribo::film_constant(film_law(reading), scenes.scene[0].bodies.ellipticity);
}

double slow_asperity_share(const PaperScenes& scenes, const Reading& reading, std::size_t contact) {
  const Scene& scene = scenes.scene[contact];
  return ReadContact(scene, reading, scenes.film_scale())
      .point(scene.speeds.from, ReadInlet(reading))
      .asperity_share;
}

std::optional<OnsetPoint> onset_of(const FloodedCurve& flooded, const StarvedCurve& starved,
                                   const ReadInlet& inlet, const OnsetChoice& choice,
                                   FrictionLaw law) {
  if (choice.rule != OnsetRule::friction_minimum)
    return explicit_onset(flooded.contact, inlet, choice);
  return friction_minimum(flooded, starved, friction_curve(flooded, starved, law), inlet, law);
}

ItemResult judged(const Item& item, const Observed& observed) {
  return {observed, judge(item, observed), margin_of_verdict(item, observed)};
}

std::vector<ItemResult> evaluate(const PaperScenes& scenes, const Reading& reading,
                                 const std::vector<Item>& items) {
  ReadingStages stages(scenes, reading);
  std::vector<ItemResult> results;
  results.reserve(items.size());
  for (const Item& item : items)
    results.push_back(judged(item, observe(item, stages.for_what(stage(item.quantity)))));
  return results;
}

Observed evaluate(const PaperScenes& scenes, const Reading& reading, const Item& item) {
  ReadingStages stages(scenes, reading);
  return observe(item, stages.for_what(stage(item.quantity)));
}

std::vector<Verdict> claim_verdicts(const std::vector<Item>& items,
                                    const std::vector<ItemResult>& results) {
  std::vector<Verdict> verdicts;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i == 0 || items[i].claim != items[i - 1].claim) verdicts.push_back(Verdict::reproduced);
    verdicts.back() = worst(verdicts.back(), results[i].verdict);
  }
  return verdicts;
}

bool is_decided(const std::string& claim, const std::vector<Item>& items,
                const std::vector<ItemResult>& results) {
  for (std::size_t i = 0; i < items.size(); ++i)
    if (items[i].claim == claim && !results[i].is_decided()) return false;
  return true;
}

}  // namespace tribo::reproduction
