// SPDX-License-Identifier: Apache-2.0
#include "page/captions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "page/number_text.hpp"
#include "page/observations.hpp"

namespace tribo::report {
namespace {

constexpr double nanometres = 1e9;

std::string speed(double metres_per_second, int digits = 3) {
  return rounded(metres_per_second, digits) + " m/s";
}

std::string end_speed(double metres_per_second) { return unrounded(metres_per_second) + " m/s"; }

std::string percent(double share) { return rounded(100 * share, 3) + " %"; }

// "1 (rough), 2 (medium), 3 (smooth)", each told by a function of its GT case.
template <class Teller>
std::string for_each_surface(const Findings& findings, Teller&& tell) {
  std::string text;
  for (const std::string_view surface : surfaces) {
    if (!text.empty()) text += ", ";
    text += fmt::format("{} ({})", tell(findings.gt(surface)), surface);
  }
  return text;
}

std::string lowest_speed(const Findings& findings) {
  return end_speed(findings.gt("smooth").range.low);
}

std::string times(const std::vector<RatioPoint>& found) {
  if (found.empty()) return "an undefined number of times";
  const RatioRange range = range_of(found);
  return fmt::format("{} to {} times", rounded(range.least, 3), rounded(range.greatest, 3));
}

std::string onset_ratio(const Findings& findings) {
  const auto& gt = findings.gt("smooth").by(OnsetCriterion::film_maximum);
  const auto& gw = findings.gw("smooth").by(OnsetCriterion::film_maximum);
  if (!gt.exists || !gw.exists) return "one of the two has no onset";
  return fmt::format("the onset (`film_maximum`) lies at {} with GT and at {} with GW, {} times it",
                     speed(gt.speed), speed(gw.speed), rounded(gw.speed / gt.speed, 4));
}

std::string collapse(const SolvedCase& solved, int digits = 3) {
  return solved.at_collapse ? "at " + speed(solved.at_collapse->speed, digits)
                            : "none up to " + end_speed(solved.range.high);
}

std::string collapse_dotted() {
  return "Past the collapse of the film (×, h~ff~ ≥ h~oil~) the model has no film left, and the "
         "curves go on dotted, with the faces in contact.";
}

std::string reported(const Findings& findings, std::string_view quantity,
                     std::string_view surface) {
  const auto row = findings.reported.find(quantity, surface, "GT");
  return row ? unrounded(row->value) : "no number";
}

// first/second up to the onsets of both: beyond them one film vanishes before the other.
std::vector<RatioPoint> ratios_before_onset(const SolvedCase& first, const SolvedCase& second,
                                            double Point::*quantity) {
  double highest = std::numeric_limits<double>::infinity();
  for (const SolvedCase* one : {&first, &second})
    if (one->at_onset) highest = std::min(highest, one->at_onset->speed);
  return ratios(first, second, quantity, highest);
}

const SlopeCurve& slope_curve(const Findings& findings, std::string_view name) {
  for (const SlopeCurve& curve : findings.slopes.curves)
    if (curve.name == name) return curve;
  return findings.slopes.curves.front();
}

// The tail of the paper's own closure in Figure 4.
std::string own_closure_text(const Findings& findings) {
  const SolvedCase& base = *findings.slopes.base;
  const std::string own = fmt::format("The paper's own closure at constant h~oil~ (`{}`) ",
                                      closure_name(base.source.scene.closures.starvation));
  if (!base.at_onset || !base.at_collapse) return own + "is drawn beside them.";
  return own + fmt::format(
                   "has no u^−1^ range: its slope falls from {} through 0 at {} to −∞ where the "
                   "film collapses, at {}.",
                   rounded(slope_curve(findings, "paper").first_slope, 3),
                   speed(base.at_onset->speed), speed(base.at_collapse->speed));
}

}  // namespace

std::string_view closure_name(StarvationClosure closure) {
  return starvation_closure_words[static_cast<std::size_t>(closure)];
}

std::string two_slopes_caption(const Findings& findings) {
  const TwoSlopes& slopes = findings.slopes;
  const SlopeCurve& flooded = slope_curve(findings, "flooded");
  return fmt::format(
      "C16: the paper sketches a film that grows as u^0.67^ with a flooded inlet and falls as "
      "u^−1^ once it starves. With a flooded inlet the slope here is {} at {} and {} at {}; load "
      "sharing bends it in between. The u^−1^ range needs oil that comes at a constant rate: "
      "with h~oil~ = q/u and q = {} m²/s (chosen so that h~oil~ meets the flooded film at {}, the "
      "middle of the axis), the slope at {} is {} for `starved_inlet` and {} for `damiens`. {}",
      rounded(flooded.first_slope, 3), end_speed(slopes.base->range.low),
      rounded(flooded.last_slope, 3), end_speed(slopes.base->range.high),
      rounded(slopes.inlet_flow, 3), speed(slopes.knee), end_speed(slopes.base->range.high),
      rounded(slope_curve(findings, "starved_inlet").last_slope, 3),
      rounded(slope_curve(findings, "damiens").last_slope, 3), own_closure_text(findings));
}

std::string area_caption(const Findings& findings) {
  const auto area = &Point::real_area_ratio;
  return fmt::format(
      "At {} the three surfaces come to {} with GT; C8 reads the paper as: the same on all three. "
      "At equal speeds up to the onset on the smooth surface, the rough one has {} its area ratio "
      "(C9: rough above smooth). On the smooth surface GW gives {} the area of GT up to the onset "
      "(C7: GW above GT); {} (C10: no difference). {}",
      lowest_speed(findings),
      for_each_surface(
          findings, [](const SolvedCase& one) { return rounded(one.slowest.real_area_ratio, 3); }),
      times(ratios_before_onset(findings.gt("rough"), findings.gt("smooth"), area)),
      times(ratios_before_onset(findings.gw("smooth"), findings.gt("smooth"), area)),
      onset_ratio(findings), collapse_dotted());
}

std::string summits_caption(const Findings& findings) {
  const auto count = &Point::summit_count;
  const SolvedCase &gt = findings.gt("smooth"), &gw = findings.gw("smooth");
  return fmt::format(
      "At {} GT has {} summits in contact (C12: more on smoother surfaces). On the smooth surface "
      "GW has {} as many as GT at {}, and {} as many over all speeds up to the onset (C11: "
      "below GT in boundary lubrication, above it in mixed). {}",
      lowest_speed(findings),
      for_each_surface(findings,
                       [](const SolvedCase& one) { return rounded(one.slowest.summit_count, 4); }),
      rounded(gw.slowest.summit_count / gt.slowest.summit_count, 3) + " times",
      lowest_speed(findings), times(ratios_before_onset(gw, gt, count)), collapse_dotted());
}

std::string shares_caption(const Findings& findings) {
  const auto half = [](const SolvedCase& one) {
    const auto found = equal_share_speed(one);
    return found ? speed(*found) : std::string("at no speed");
  };
  const auto least = [](const SolvedCase& one) {
    return one.at_onset ? percent(one.at_onset->asperity_load_share) : std::string("no minimum");
  };
  const auto last = [](const SolvedCase& one) {
    return percent(one.curve.back().asperity_load_share);
  };
  return fmt::format(
      "At {} the asperities carry {}; the paper reports {} on the rough and {} on the smooth "
      "surface (C4). Fluid and asperities share alike at {} (C5: the speed rises with "
      "roughness). The asperities carry least at the onset, {}, and more again beyond it, {} at {} "
      "(C6). {}",
      lowest_speed(findings),
      for_each_surface(
          findings,
          [](const SolvedCase& one) { return rounded(one.slowest.asperity_load_share, 4); }),
      reported(findings, "slow_asperity_share", "rough"),
      reported(findings, "slow_asperity_share", "smooth"), for_each_surface(findings, half),
      for_each_surface(findings, least), for_each_surface(findings, last),
      end_speed(findings.gt("smooth").range.high), collapse_dotted());
}

std::string film_caption(const Findings& findings) {
  const auto highest = [](const SolvedCase& one) {
    if (!one.at_onset) return std::string("no maximum");
    return fmt::format("{} nm at {}", rounded(nanometres * one.at_onset->film, 3),
                       speed(one.at_onset->speed));
  };
  return fmt::format(
      "The film is greatest at the onset (●): {}. Open triangles stand at the onset speeds that "
      "the paper reports, {}, {} and {} m/s (C1; C3: smooth first, rough last). Collapse "
      "(×, h~ff~ ≥ h~oil~): {}. There the film is 0, which a logarithmic axis cannot show, and the "
      "curve ends.",
      for_each_surface(findings, highest), reported(findings, "onset_speed", "rough"),
      reported(findings, "onset_speed", "medium"), reported(findings, "onset_speed", "smooth"),
      for_each_surface(findings, [](const SolvedCase& one) { return collapse(one); }));
}

std::string models_caption(const Findings& findings) {
  const SolvedCase &gt = findings.gt("smooth"), &gw = findings.gw("smooth");
  return fmt::format(
      "Over all speeds up to the onset the film with GW is {} that with GT (C13: not significantly "
      "different); {} (C15: the same). The film collapses {} with GT and {} with GW; between "
      "the onset and there the ratio grows, because one film vanishes before the other.",
      times(ratios_before_onset(gw, gt, &Point::film)), onset_ratio(findings), collapse(gt, 5),
      collapse(gw, 5));
}

std::string stribeck_caption(const Findings& findings) {
  const SolvedCase &gt = findings.gt("smooth"), &gw = findings.gw("smooth");
  const auto friction = [](const SolvedCase& one) {
    const auto least = least_friction(one);
    return fmt::format(
        "{} and {}",
        one.slowest.friction_undefined ? "undefined" : rounded(one.slowest.friction, 3),
        least ? rounded(*least, 3) : "undefined");
  };
  const auto parameter = [](const SolvedCase& one) {
    return one.at_onset ? rounded(one.at_onset->film_parameter, 5) : std::string("none");
  };
  const auto &gt_minimum = gt.by(OnsetCriterion::friction_minimum),
             &gw_minimum = gw.by(OnsetCriterion::friction_minimum);
  return fmt::format(
      "Friction at {} and at its least is {}. On the smooth surface GT gives {} the friction of GW "
      "over all speeds up to the onset (C14: GT above GW); the least friction lies at {} with "
      "GT and {} with GW. λ at the onset (●) is {}; the paper reports {} on all three (C2, dashed "
      "line). Open triangles stand at the onset speeds that the paper reports. Past the collapse "
      "(×) λ is 0 and friction is undefined: its curves end, and just before that they rise "
      "without bound, as the shear rate does in a vanishing film.",
      lowest_speed(findings), for_each_surface(findings, friction),
      times(ratios_before_onset(gt, gw, &Point::friction)),
      gt_minimum.exists ? speed(gt_minimum.speed) : "no speed",
      gw_minimum.exists ? speed(gw_minimum.speed) : "no speed",
      for_each_surface(findings, parameter), reported(findings, "onset_film_parameter", "smooth"));
}

}  // namespace tribo::report
