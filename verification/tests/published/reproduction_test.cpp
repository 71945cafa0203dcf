// SPDX-License-Identifier: Apache-2.0
// The reading model is compared with the model, the enumeration with each reading alone, and the
// ledger with the committed one. The inputs that inversions find have to make their items hold.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "published/paper.hpp"
#include "support/temporary_folder.hpp"

namespace tribo::reproduction {
namespace {

const std::string committed = TRIBOCHECK_SOURCE_DIR "/reference/baselines/ledger.csv";

const Ledger& ledger() {
  static const Ledger made = make_ledger({published, {}, 3, 2000});
  return made;
}
TEST(CorrectedReading, IsTheModelAtEverySpeed) {
  const Reading reading = corrected_reading();
  const ReadInlet inlet(reading);
  for (const Scene& scene : scenes().scene) {
    const MixedContact<double> model(scene);
    const ReadContact contact(scene, reading);
    for (const double speed : speed_grid(scene.speeds.from, scene.speeds.to)) {
      const OperatingPoint<double> expected = model.solve(speed);
      const ContactPoint got = contact.point(speed, inlet);
      const auto close = [&](double value, double to) {
        EXPECT_TRUE(is_close(value, to, 1e-11, {{"speed", speed}}));
      };
      EXPECT_EQ(got.collapsed, expected.inlet == Inlet::collapsed);
      if (!got.collapsed) close(got.film_parameter, expected.film_parameter);
      // Beyond a collapse without a floor, readings go on with A(0), as the paper draws it.
      const bool is_balanced = expected.regime != Regime::collapsed;
      close(got.asperity_share,
            is_balanced ? expected.asperity_load_share : model.sharing().asperity_share(0));
      close(got.real_area_ratio, expected.real_area_ratio);
      close(got.summit_count, expected.summit_count);
      if (is_balanced) close(contact.friction(got, friction_law(reading)), expected.friction);
    }
  }
}

TEST(CorrectedReading, HasTheModelsOnsets) {
  const std::vector<double> speeds = speed_grid(1e-4, 3);
  constexpr std::array<std::pair<OnsetCriterion, std::uint8_t>, 4> criteria{
      {{OnsetCriterion::film_maximum, 0},
       {OnsetCriterion::film_departure, 2},
       {OnsetCriterion::friction_minimum, 6},
       {OnsetCriterion::asperity_minimum, 7}}};
  for (const Scene& scene : scenes().scene)
    for (const auto& [criterion, choice] : criteria) {
      const Reading reading = with(Switch::criterion, choice);
      const ReadInlet inlet(reading);
      const FloodedCurve flooded = flooded_curve(ReadContact(scene, reading), speeds);
      const auto got = onset_of(flooded, starved_curve(flooded, inlet, speeds), inlet,
                                reading.onset(), friction_law(reading));
      const Onset<double> expected = model_onset(scene, criterion);
      ASSERT_TRUE(got.has_value() && expected.exists);
      // Friction is flat at its minimum.
      const double bound = criterion == OnsetCriterion::friction_minimum ? 2e-6 : 1e-12;
      EXPECT_TRUE(is_close(got->speed, expected.speed, bound, {}));
      EXPECT_TRUE(is_close(got->film_parameter, expected.film_parameter, bound, {}));
    }
}

// With little boundary friction and little sliding the first minimum is the lower one.
TEST(CorrectedReading, HasTheModelsOnsetWhereFrictionHasTwoMinima) {
  Scene scene = scenes().scene[static_cast<std::size_t>(PaperSurface::medium)];
  scene.supply.value = 2;
  scene.friction.boundary_coefficient = 0.005;
  scene.friction.slide_roll_ratio = 0.001;
  const std::vector<double> speeds = speed_grid(1e-4, 3);
  const Reading reading = with(Switch::criterion, 6);
  const ReadInlet inlet(reading);
  const FloodedCurve flooded = flooded_curve(ReadContact(scene, reading), speeds);
  const StarvedCurve starved = starved_curve(flooded, inlet, speeds);
  const std::vector<double> friction =
      friction_curve(flooded, starved, friction_law(reading)).coefficient;
  std::size_t minima = 0;
  for (std::size_t i = 1; i + 1 < friction.size(); ++i)
    minima += friction[i] < friction[i - 1] && friction[i] < friction[i + 1] ? 1U : 0U;
  ASSERT_EQ(minima, 2U);
  const auto got = onset_of(flooded, starved, inlet, reading.onset(), friction_law(reading));
  const Onset<double> expected = model_onset(scene, OnsetCriterion::friction_minimum);
  ASSERT_TRUE(got && expected.exists);
  EXPECT_TRUE(is_close(got->speed, expected.speed, 2e-6, {}));
}

// Erratum E9: the switch gives the numbers of the model with the offset of two faces. For two equal
// faces the printed D_d/σ_s is that of one face, and the printed σ_s that of their sum.
TEST(OffsetPlanes, AreTheModelsOwn) {
  constexpr std::array<std::array<double, 3>, 2> shares{
      {{1.00, 1.00, 0.97}, {0.999, 0.841, 0.704}}};
  constexpr std::array printed_onsets{2.068, 0.739, 0.264};  // of two equal faces
  for (const std::uint8_t choice : {std::uint8_t{1}, std::uint8_t{2}}) {
    const Reading reading = with(Switch::offset_planes, choice);
    const ReadInlet inlet(reading);
    for (std::size_t i = 0; i < surface_count; ++i) {
      Scene scene = scenes().scene[i];
      scene.surface.offset_planes = 2;
      if (choice == 2) scene.surface.summit_plane_offset /= std::sqrt(2.0);
      const OperatingPoint<double> expected = MixedContact<double>(scene).solve(1e-4);
      const ContactPoint got = ReadContact(scenes().scene[i], reading).point(1e-4, inlet);
      EXPECT_TRUE(is_close(got.asperity_share, expected.asperity_load_share, 1e-11, {}));
      EXPECT_TRUE(is_within(got.asperity_share, shares[choice - 1U][i], choice == 1 ? 5e-3 : 5e-4));
      if (choice == 1) continue;
      const double onset = model_onset(scene).speed;
      EXPECT_TRUE(is_within(onset, printed_onsets[i], 5e-4));
      EXPECT_TRUE(is_close(explicit_onset(ReadContact(scenes().scene[i], reading), inlet,
                                          {OnsetRule::film_maximum, 0})
                               ->speed,
                           onset, 1e-11, {}));
    }
    // GW has one rough face, whatever the choice.
    EXPECT_EQ(slow_asperity_share(scenes(), reading, 3),
              slow_asperity_share(scenes(), corrected_reading(), 3));
  }
}

TEST(Tolerances, AreNarrowerAndWiderForAllRules) {
  EXPECT_EQ(judge(with_tolerance(item("C1.rough"), 2), {0.59}), Verdict::reproduced);
  EXPECT_EQ(judge(with_tolerance(item("C1.rough"), 2), {0.61}), Verdict::order_only);
  EXPECT_EQ(judge(with_tolerance(item("C1.rough"), 0.5), {0.53}), Verdict::within_ten_percent);
  EXPECT_EQ(judge(with_tolerance(item("C13"), 0.5), {1.06, 1.06, 1}), Verdict::within_ten_percent);
  EXPECT_EQ(judge(with_tolerance(item("C6"), 2), {0.006, 1, 1}), Verdict::reproduced);
  EXPECT_EQ(judge(with_tolerance(item("C6"), 0.5), {0.019, 1, 0}), Verdict::not_reproduced);
  const Ledger& made = ledger();
  for (const ToleranceScores& one : made.tolerances) {
    ASSERT_EQ(one.scores.size(), made.readings.size());
    if (one.factor != 1) continue;
    for (std::size_t i = 0; i < one.scores.size(); ++i)
      EXPECT_EQ(one.scores[i], made.readings[i].score) << made.readings[i].name;
  }
  for (std::size_t i = 0; i < made.readings.size(); ++i)
    for (std::size_t k = 1; k < made.tolerances.size(); ++k)
      EXPECT_GE(made.tolerances[k].scores[i], made.tolerances[k - 1].scores[i]);
}

// All numbers that print as the given one lie within the plausible range.
TEST(Inputs, ArePlausibleWithinTheirPrintPrecision) {
  const std::vector<Input> inputs = read_inputs(published + "/inputs.tsv");
  ASSERT_FALSE(inputs.empty());
  for (const Input& one : inputs) {
    const double half = one.last_digit / 2;
    EXPECT_LE(one.low, (one.value - half) * (1 + 1e-12)) << name(one.field) << one.surface;
    EXPECT_GE(one.high, (one.value + half) * (1 - 1e-12)) << name(one.field) << one.surface;
  }
}

TEST(ReadInlets, AreTheModelsClosuresWithTheLineContactsGap) {
  constexpr std::array<std::pair<std::uint8_t, StarvationClosure>, 3> rules{
      {{0, StarvationClosure::flooded_inlet},
       {1, StarvationClosure::starved_inlet},
       {2, StarvationClosure::printed_exponents}}};
  for (const auto& [choice, closure] : rules) {
    const ReadInlet inlet(with(Switch::inlet, choice)), of_many(with(Switch::inlet, choice), true);
    const InletLaw<double> law{closure, 3};
    for (const double r : {1e-4, 0.01, 0.3, 0.6, 0.9, 0.999}) {
      EXPECT_TRUE(is_close(inlet.film_ratio(r), law.film_ratio(r), 1e-13, {{"r", r}}));
      EXPECT_TRUE(is_close(inlet.slope(r), law.slope(r), 1e-11, {{"r", r}}));
    }
    // Within the table and beyond its ends.
    Sampler sampler(45);
    for (int i = 0; i < 2000; ++i) {
      const double r =
          sampler.log_uniform(1e-8, closure == StarvationClosure::flooded_inlet ? 0.999 : 1e4);
      // A film that falls as r^−7 is seven times as sensitive to ln r.
      EXPECT_TRUE(is_close(of_many.film_ratio(r), law.film_ratio(r),
                           5e-15 * (1 + std::abs(law.slope(r))), {{"r", r}}));
      EXPECT_TRUE(is_close(of_many.slope(r), law.slope(r), 1e-11, {{"r", r}}));
    }
    for (const OnsetChoice& onset : onset_choices) {
      if (onset.rule != OnsetRule::film_departure) continue;
      EXPECT_TRUE(is_close(inlet.departure(onset.departure), law.at_departure(onset.departure),
                           1e-13, {{"epsilon", onset.departure}}));
    }
    const double maximum = law.at_film_maximum();
    ASSERT_EQ(inlet.maximum().has_value(), maximum == maximum);
    if (!inlet.maximum()) continue;
    EXPECT_TRUE(is_close(*inlet.maximum(), maximum, 1e-12, {}));
  }
}

// As printed, h*/h_oil = (2/π) arctan(2.7ψ) and h_oil/h* = 1 + ψ^{3/2}/c, without h_ff.
TEST(ReadInlets, AsPrintedGivesOneFilmAtEverySpeed) {
  const ReadInlet inlet(with(Switch::inlet, 3));
  EXPECT_TRUE(is_within(inlet.film_ratio(1), 0.597, 0.0005));
  const double psi = wolveridge_inlet_length(inlet.film_ratio(1));
  EXPECT_TRUE(is_close(1 / inlet.film_ratio(1), 1 + psi * std::sqrt(psi) * 4 * std::sqrt(2.0) / 3,
                       1e-12, {}));
  for (const double r : {0.01, 0.5, 2.0})
    EXPECT_TRUE(is_close(r * inlet.film_ratio(r), inlet.film_ratio(1), 1e-15, {{"r", r}}));
}

TEST(ReadInlets, GapOfACircularContactIsGreaterByFourOverPi) {
  // ψ at a given film goes as c^{2/3}, so that at the same r the two gaps have different ψ.
  const ReadInlet line(with(Switch::inlet, 0)), point(with(Switch::gap, 1));
  for (const double r : {0.1, 0.5, 0.9}) {
    const double psi_line = wolveridge_inlet_length(line.film_ratio(r));
    const double psi_point = wolveridge_inlet_length(point.film_ratio(r));
    EXPECT_TRUE(
        is_close(psi_point / psi_line, std::pow(pi<double>() / 4, 2.0 / 3), 1e-12, {{"r", r}}));
  }
}

TEST(Readings, AreNumberedOneByOne) {
  EXPECT_EQ(reading_count(), 589824U);
  Sampler sampler(11);
  for (int i = 0; i < 1000; ++i) {
    const auto index =
        static_cast<std::size_t>(sampler.uniform(0, static_cast<double>(reading_count())));
    EXPECT_EQ(index_of(reading_at(index)), index);
  }
  EXPECT_EQ(departures(corrected_reading()), "corrected");
  Reading reading = corrected_reading();
  set_switch(reading, "speed=sum");
  set_switch(reading, "inlet=printed_exponents");
  EXPECT_EQ(departures(reading), "inlet=printed_exponents speed=sum");
  EXPECT_THROW(set_switch(reading, "inlet=flood"), std::invalid_argument);
  EXPECT_THROW(set_switch(reading, "inlets=as_printed"), std::invalid_argument);
  EXPECT_THROW(set_switch(reading, "inlet"), std::invalid_argument);
}

// Two hundred readings at random, and two hundred of those that the grid of speeds left open, which
// lie nearest to the thresholds.
std::vector<std::size_t> sampled_readings(const Enumeration& all) {
  const auto at_a_threshold = [&](ItemMask refined, ItemMask undecided) {
    return (refined & ~undecided) != 0;
  };
  std::vector<std::size_t> chosen, near;
  for (std::size_t i = 0; i < all.items.size(); ++i)
    if (at_a_threshold(all.refined[i], all.undecided[i])) near.push_back(i);
  EXPECT_GT(near.size(), 1000U);
  Sampler sampler(12);
  for (int i = 0; i < 200; ++i) {
    chosen.push_back(
        static_cast<std::size_t>(sampler.uniform(0, static_cast<double>(reading_count()))));
    chosen.push_back(
        near[static_cast<std::size_t>(sampler.uniform(0, static_cast<double>(near.size())))]);
  }
  return chosen;
}

TEST(Enumeration, OfAllReadingsIsEachReadingByItself) {
  const Enumeration all = enumerate(scenes(), items());
  for (const std::size_t index : sampled_readings(all)) {
    const std::vector<ItemResult> results = evaluate(scenes(), reading_at(index), items());
    ItemMask mask = 0, undecided = 0;
    std::vector<std::string_view> claims;  // in the paper's order
    std::set<std::string_view> missed;     // claims with an item that is not reproduced
    for (std::size_t k = 0; k < results.size(); ++k) {
      const std::string_view claim = items()[k].claim;
      if (claims.empty() || claims.back() != claim) claims.push_back(claim);
      if (results[k].verdict == Verdict::reproduced)
        mask |= 1U << k;
      else
        missed.insert(claim);
      if (!is_sure(items()[k], results[k].observed)) undecided |= 1U << k;
    }
    ItemMask whole = 0;
    for (std::size_t k = 0; k < claims.size(); ++k)
      if (!missed.contains(claims[k])) whole |= 1U << k;
    EXPECT_EQ(all.items[index], mask) << departures(reading_at(index));
    EXPECT_EQ(all.claims[index], whole) << departures(reading_at(index));
    EXPECT_EQ(all.undecided[index], undecided) << departures(reading_at(index));
  }
}

TEST(Enumeration, ComputesAStageOnceForTheReadingsThatShareIt) {
  const Ledger& made = ledger();
  // 24 film laws: E* and the sum of speeds both double U, so that four choices give three U. 24
  // rough contacts of each of three surfaces with GT, and 4 with GW.
  EXPECT_EQ(made.work.films, 24U * (3 * 24 + 4));
  EXPECT_EQ(made.work.inlets, made.work.films * 8);
  EXPECT_EQ(made.work.friction_curves, made.work.inlets * 6);
}

TEST(Verdicts, FollowTheirRules) {
  const auto number = [](double value) { return judge(item("C1.rough"), {value, value}); };
  EXPECT_EQ(number(0.55), Verdict::reproduced);
  EXPECT_EQ(number(0.5501), Verdict::order_only);
  EXPECT_EQ(number(1.58), Verdict::order_only);
  EXPECT_EQ(number(1.59), Verdict::not_reproduced);
  EXPECT_EQ(judge(item("C17"), {1.8994, 0}), Verdict::reproduced);
  EXPECT_EQ(judge(item("C17"), {1.8996, 0}), Verdict::within_ten_percent);
  EXPECT_EQ(judge(item("C1.rough"), {}), Verdict::not_reproduced);
  EXPECT_EQ(judge(item("C14"), {1.01, 2, 1}), Verdict::reproduced);
  EXPECT_EQ(judge(item("C14"), {1.01, 2, 0.9}), Verdict::in_part);
  EXPECT_EQ(judge(item("C14"), {0.99, 2, 0.9}), Verdict::in_part);
  EXPECT_EQ(judge(item("C14"), {0.99, 2, 0.5}), Verdict::in_part);
  EXPECT_EQ(judge(item("C14"), {0.99, 2, 0.49}), Verdict::not_reproduced);
  EXPECT_EQ(judge(item("C13"), {1 / 1.0999, 1, 1}), Verdict::reproduced);
  EXPECT_EQ(judge(item("C13"), {1.12, 1, 0.7}), Verdict::in_part);
  EXPECT_EQ(judge(item("C13"), {1 / 1.12, 1, 0.7}), Verdict::in_part);
  EXPECT_EQ(judge(item("C8"), {1.05, 1.05, 0}), Verdict::within_ten_percent);
  EXPECT_EQ(judge(item("C6"), {0.01, 1, 1}), Verdict::reproduced);
  EXPECT_EQ(judge(item("C6"), {0.009, 1, 2 / 3.0}), Verdict::in_part);
}

TEST(Verdicts, ANumberIsAsPrintedToHalfAUnitOfItsLastDigit) {
  for (const double value : {1.35, 1.36, 1.4, 1.449, 1.45})
    EXPECT_EQ(is_as_printed(value, 1.4, 0.1), true) << value;
  for (const double value : {1.3, 1.349, 1.451, 1.5, -1.4, std::nan("")})
    EXPECT_EQ(is_as_printed(value, 1.4, 0.1), false) << value;
}

// Inversions search for margins of 0: a rule has to be met exactly where no margin is below 0.
TEST(Verdicts, ARuleIsMetWhereItsMarginIsNotBelowZero) {
  for (const char* const id : {"C14", "C13", "C6", "C1.rough", "C4.smooth"})
    for (double value = 1e-3; value < 10; value *= 1.003) {
      const Observed observed{value, value, value > 1 ? 1.0 : 0.0};
      const bool is_met = judge(item(id), observed) == Verdict::reproduced;
      const std::array<double, 2> margins = threshold_margins(item(id), observed);
      EXPECT_EQ(std::isnan(margins[1]), item(id).rule != Rule::number) << id;
      EXPECT_EQ(margins[0] >= 0 && !(margins[1] < 0), is_met) << id << ' ' << value;
    }
  const std::array<double, 2> margins = threshold_margins(item("C1.rough"), {1.0, 1});
  EXPECT_TRUE(is_close(margins[0], std::log(1.0 / 0.45), 1e-8, {}));
  EXPECT_TRUE(is_close(margins[1], std::log(0.55 / 1.0), 1e-8, {}));
  for (const double value : {0.1, 0.5, 1.0})
    EXPECT_TRUE(is_close(nearest_as_printed(item("C1.rough"), value), std::clamp(value, 0.45, 0.55),
                         1e-8, {}));
  for (const double no_number : {0.0, -1.0, std::nan("")})
    for (const double none : threshold_margins(item("C14"), {no_number, 1}))
      EXPECT_TRUE(std::isnan(none));
}

TEST(Verdicts, AClaimHasTheWorstOfItsItems) {
  const NamedReading& corrected = ledger().readings.front();
  const std::vector<std::string> claims = claim_names(items());
  ASSERT_EQ(claims.size(), 17U);
  for (std::size_t k = 0; k < claims.size(); ++k) {
    Verdict least = Verdict::reproduced;
    for (std::size_t i = 0; i < items().size(); ++i)
      if (items()[i].claim == claims[k]) least = std::max(least, corrected.results[i].verdict);
    EXPECT_EQ(corrected.verdicts[k], least) << claims[k];
  }
  EXPECT_EQ(worst(Verdict::reproduced, Verdict::in_part), Verdict::in_part);
  EXPECT_EQ(worst(Verdict::not_reproduced, Verdict::in_part), Verdict::not_reproduced);
}

TEST(Ranking, CountsEveryReading) {
  const Ranking& ranking = ledger().ranking;
  std::size_t sum = 0, weighted = 0;
  for (std::size_t score = 0; score < ranking.histogram.size(); ++score) {
    sum += ranking.histogram[score];
    weighted += score * ranking.histogram[score];
  }
  EXPECT_EQ(sum, reading_count());
  EXPECT_TRUE(is_close(ranking.mean_score, static_cast<double>(weighted) / static_cast<double>(sum),
                       1e-14, {}));
  double variance = 0;
  for (std::size_t score = 0; score < ranking.histogram.size(); ++score) {
    const double part =
        static_cast<double>(ranking.histogram[score]) / static_cast<double>(reading_count());
    variance += part * std::pow(static_cast<double>(score) - ranking.mean_score, 2);
    std::size_t above = 0;
    for (std::size_t s = score + 1; s < ranking.histogram.size(); ++s)
      above += ranking.histogram[s];
    EXPECT_EQ(standing(ranking, static_cast<int>(score)).above, above);
    EXPECT_EQ(standing(ranking, static_cast<int>(score)).equal, ranking.histogram[score]);
  }
  EXPECT_TRUE(is_close(ranking.score_sd, std::sqrt(variance), 1e-9, {}));
  double parts = 0;
  for (const double part : ledger().claim_parts) parts += part;
  EXPECT_TRUE(is_close(parts, ranking.mean_score, 1e-12, {}));
  const RankedGroup& best = ranking.best.front();
  EXPECT_EQ(ranking.histogram[static_cast<std::size_t>(best.score)], ranking.best_ties);
  for (std::size_t s = static_cast<std::size_t>(best.score) + 1; s < ranking.histogram.size(); ++s)
    EXPECT_EQ(ranking.histogram[s], 0U);
  EXPECT_EQ(named_reading(scenes(), items(), "", best.representative).score, best.score);
}

// All readings with one choice of the inlet reproduce an item, and some with another choice do.
Enumeration with_one_inlet(double part_of_the_others) {
  const std::vector<ItemMask> none(reading_count());
  Enumeration made{none, none, 0, 0, 0, none, none};
  std::vector<std::size_t> others;
  std::size_t of_the_choice = 0;
  for (std::size_t i = 0; i < reading_count(); ++i) {
    const std::uint8_t choice = reading_at(i).choice[static_cast<std::size_t>(Switch::inlet)];
    if (choice == 2) made.items[i] = 1, ++of_the_choice;
    if (choice == 1) others.push_back(i);
  }
  const double wanted = static_cast<double>(of_the_choice) * part_of_the_others;
  for (std::size_t i = 0; static_cast<double>(i) < wanted; ++i) made.items[others[i]] = 1;
  made.claims = made.items;
  return made;
}

TEST(Ranking, IdentifiesAChoiceThatNearlyAllReadingsShare) {
  // The first choice has 1/1.05 (95.2 %) or 1/1.06 (94.3 %) of the readings with the item.
  for (const auto& [others, is_identified] :
       {std::pair{0.0, true}, std::pair{0.05, true}, std::pair{0.06, false}}) {
    const ItemStatistics found = item_statistics(with_one_inlet(others), items()).front();
    const bool has_inlet =
        std::any_of(found.identified.begin(), found.identified.end(), [](const auto& one) {
          return one.which == Switch::inlet && one.choice == 2 && one.chance == 0.25;
        });
    EXPECT_EQ(has_inlet, is_identified) << others;
  }
}

TEST(Ranking, SaysWhatTheBestReadingsShareAndInWhatTheyDiffer) {
  const RankedGroup best = rank(with_one_inlet(0), items(), 3).best.front();
  EXPECT_EQ(best.ties, reading_count() / 4);
  EXPECT_EQ(departures(best.representative), "inlet=printed_exponents");
  EXPECT_EQ(best.fixed, "inlet=printed_exponents");
  EXPECT_EQ(best.free.find("inlet"), std::string::npos) << best.free;
  EXPECT_EQ(std::count(best.free.begin(), best.free.end(), ','), switch_count - 2) << best.free;
}

TEST(Requirements, MakeTheirItemHold) {
  std::size_t found = 0;
  for (const Requirement& one : ledger().requirements) {
    if (!one.factor) continue;
    ++found;
    if (items()[one.item].has_surface) {
      EXPECT_EQ(one.surface, name(items()[one.item].surface)) << items()[one.item].id;
    }
    EXPECT_TRUE(is_close(one.value, one.paper_value * *one.factor, 1e-12, {}));
    PaperScenes changed = scenes();
    scale_all(changed, one.field, *one.factor);
    const Item& wanted = items()[one.item];
    const Observed observed = evaluate(changed, corrected_reading(), wanted);
    EXPECT_EQ(judge(wanted, observed), Verdict::reproduced) << wanted.id << ' ' << name(one.field);
    if (wanted.rule != Rule::number) continue;
    // No factor nearer to 1 makes the item hold: of the interval that prints as reported, the
    // number lies at the end nearer to where it was.
    const double before = *ledger().readings.front().results[one.item].observed.value;
    const double end =
        wanted.reported + (before < wanted.reported ? -0.5 : 0.5) * wanted.last_digit;
    EXPECT_TRUE(is_close(*observed.value, end, 1e-5, {{"factor", *one.factor}}));
    PaperScenes nearer = scenes();
    scale_all(nearer, one.field, std::pow(*one.factor, 0.999));
    EXPECT_NE(judge(wanted, evaluate(nearer, corrected_reading(), wanted)), Verdict::reproduced);
  }
  EXPECT_GT(found, 40U);
}

TEST(Requirements, SayWhetherTheyArePlausibleAndWhatElseTheyChange) {
  const std::vector<Verdict>& before = ledger().readings.front().verdicts;
  std::size_t too_low = 0, too_high = 0, broken = 0, mended = 0;
  for (const Requirement& one : ledger().requirements) {
    if (!one.factor) continue;
    too_low += one.value < one.low ? 1U : 0U;
    too_high += one.value > one.high ? 1U : 0U;
    EXPECT_EQ(one.plausible, one.value >= one.low && one.value <= one.high) << name(one.field);
    // The range is measured in logarithms, as for the draws.
    const double beyond = std::max(one.low / one.value, one.value / one.high);
    EXPECT_EQ(one.at_limit, beyond > 1 && beyond <= std::pow(one.high / one.low, 0.05))
        << name(one.field);
    PaperScenes changed = scenes();
    scale_all(changed, one.field, *one.factor);
    const std::vector<Verdict> after =
        claim_verdicts(items(), evaluate(changed, corrected_reading(), items()));
    std::vector<std::string> lost, gained;
    for (std::size_t k = 0; k < after.size(); ++k) {
      const bool held = before[k] == Verdict::reproduced, holds = after[k] == Verdict::reproduced;
      if (held && !holds) lost.push_back(ledger().claims[k]);
      if (!held && holds) gained.push_back(ledger().claims[k]);
    }
    EXPECT_EQ(one.broken, lost) << name(one.field);
    EXPECT_EQ(one.mended, gained) << name(one.field);
    broken += lost.size();
    mended += gained.size();
  }
  for (const std::size_t count : {too_low, too_high, broken, mended}) EXPECT_GT(count, 0U);
}

// At a given film u ∝ 1/η. Therefore the sensitivity of the onset speed to viscosity is −1, and the
// factor found is the computed speed over the greatest speed that prints as reported.
TEST(Requirements, InvertThePowerLawsOfTheFilmFormula) {
  std::size_t found = 0;
  for (const Requirement& one : ledger().requirements) {
    const Item& wanted = items()[one.item];
    if (wanted.quantity != Quantity::onset_speed) continue;
    const double ratio = *ledger().readings.front().results[one.item].observed.value /
                         (wanted.reported + wanted.last_digit / 2);
    if (one.field == Field::viscosity || one.field == Field::speed) {
      EXPECT_TRUE(is_close(*one.sensitivity, -1, 1e-6, {}));
      EXPECT_TRUE(is_close(*one.factor, ratio, 1e-6, {}));
      ++found;
    }
    if (one.field != Field::pressure_viscosity) continue;
    EXPECT_TRUE(is_close(*one.factor, std::pow(ratio, 0.67 / 0.53), 1e-6, {}));
  }
  EXPECT_EQ(found, 6U);
}

TEST(CommonDepartures, GiveTheReportedSpeedsByTheModelToo) {
  constexpr std::array reported{0.5, 0.15, 0.09};
  const CommonDeparture& found = ledger().departure;
  for (std::size_t i = 0; i < surface_count; ++i) {
    ASSERT_TRUE(found.own[i].has_value());
    const Scene& scene = scenes().scene[i];
    const auto speed = [&](double departure) {
      return model_onset(scene, OnsetCriterion::film_departure, departure).speed;
    };
    EXPECT_TRUE(is_close(speed(*found.own[i]), reported[i], 1e-9, {}));
    EXPECT_TRUE(is_close(speed(found.best) / reported[i], found.factor[i], 1e-9, {}));
  }
  // The best common ε makes the greatest factors upwards and downwards equal.
  const auto [least, greatest] = std::minmax_element(found.factor.begin(), found.factor.end());
  EXPECT_TRUE(is_close(*least * *greatest, 1, 1e-6, {}));
}

TEST(Uncertainties, AreTheSameForTheSameDrawsAndWiderForWiderInputs) {
  const std::vector<Input> inputs = read_inputs(published + "/inputs.tsv");
  const ReportedOnsets reported{{0.5, 0.15, 0.09}, {0.1, 0.01, 0.01}};
  const Uncertainty first = uncertainty(scenes(), inputs, Spread::print, 500, reported);
  const Uncertainty again = uncertainty(scenes(), inputs, Spread::print, 500, reported);
  const Uncertainty wide = uncertainty(scenes(), inputs, Spread::plausible, 500, reported);
  for (std::size_t i = 0; i < surface_count; ++i) {
    EXPECT_EQ(first.onset_speed[i].low, again.onset_speed[i].low);
    EXPECT_EQ(first.onset_speed[i].high, again.onset_speed[i].high);
    const Interval& a = first.onset_speed[i];
    const Interval& b = wide.onset_speed[i];
    EXPECT_LT(b.low, a.low);
    EXPECT_GT(b.high, a.high);
    EXPECT_LE(a.least, a.low);
    EXPECT_LE(a.low, a.median);
    EXPECT_LE(a.median, a.high);
    EXPECT_LE(a.high, a.greatest);
    const double nominal =
        *ledger().readings.front().results[i].observed.value;  // C1.rough, C1.medium, C1.smooth
    EXPECT_LT(a.least, nominal);
    EXPECT_GT(a.greatest, nominal);
  }
}

// At a given film u ∝ 1/η. With viscosity alone uncertain, 1/u is drawn as a number that is uniform
// within half a unit of its last digit.
TEST(Uncertainties, OfTheViscosityAreThoseOfItsLastDigit) {
  constexpr double viscosity = 0.02, last_digit = 0.01;
  const std::vector<Input> inputs{
      {Field::viscosity, "all", viscosity, last_digit, 0.01, 0.04, "Pa·s", ""}};
  PaperScenes drawn = scenes();
  for (Scene& scene : drawn.scene) scene.lubricant.viscosity = viscosity;
  constexpr double never = 100;
  const auto found = [&](const ReportedOnsets& reported) {
    return uncertainty(drawn, inputs, Spread::print, 2000, reported);
  };
  const Uncertainty first = found({{never, never, never}, {0.1, 0.1, 0.1}});
  for (std::size_t i = 0; i < surface_count; ++i) {
    const Scene& scene = drawn.scene[i];
    const double nominal = model_onset(scene).speed;
    // The viscosity that gives a speed, as its place from 0 to 1 within the digit.
    const auto place = [&](double speed) {
      return (viscosity * nominal / speed - viscosity) / last_digit + 0.5;
    };
    const Interval& speed = first.onset_speed[i];
    EXPECT_TRUE(is_within(place(speed.greatest), 0, 0.005));
    EXPECT_TRUE(is_within(place(speed.high), 0.025, 0.015));
    EXPECT_TRUE(is_within(place(speed.median), 0.5, 0.05));
    EXPECT_TRUE(is_within(place(speed.low), 0.975, 0.015));
    EXPECT_TRUE(is_within(place(speed.least), 1, 0.005));
  }
  // One viscosity is drawn for all surfaces: the ratios of their speeds and λ stay the same.
  const auto onset = [&](std::size_t i) { return model_onset(drawn.scene[i]); };
  for (const auto& [found_interval, exact] :
       {std::pair{first.medium_over_smooth, onset(1).speed / onset(2).speed},
        {first.rough_over_medium, onset(0).speed / onset(1).speed},
        {first.film_parameter, onset(0).film_parameter}})
    for (const double one : {found_interval.least, found_interval.median, found_interval.greatest})
      EXPECT_TRUE(is_within(one, exact, 1e-9 * exact));
  // No draw has all reported speeds where one surface never has its speed. Every draw has them
  // where the last digits are wide.
  EXPECT_EQ(first.all_onsets_reported, 0U);
  EXPECT_EQ(found({{1, 1, 1}, {100, 100, 100}}).all_onsets_reported, 2000U);
  EXPECT_EQ(found({{never, 1, 1}, {0.1, 100, 100}}).all_onsets_reported, 0U);
  EXPECT_EQ(found({{1, never, 1}, {100, 0.1, 100}}).all_onsets_reported, 0U);
}

TEST(Errata, AreAllThereAndChangeWhatTheyClaimToChange) {
  const std::vector<Erratum>& errata = ledger().errata;
  ASSERT_EQ(errata.size(), 26U);
  for (std::size_t i = 0; i < errata.size(); ++i) {
    const Erratum& one = errata[i];
    EXPECT_EQ(one.id, fmt::format("E{}", i + 1));
    if (one.kind == "notation") {
      EXPECT_FALSE(one.as_printed.has_value()) << one.id;
      continue;
    }
    ASSERT_TRUE(one.as_printed && one.as_corrected) << one.id;
    EXPECT_GT(std::abs(*one.as_printed - *one.as_corrected), 1e-3 * std::abs(*one.as_corrected))
        << one.id;
  }
}

// Errata of this kind name every switch but the criterion, and nothing else.
TEST(Errata, OfTheKindReadingNameTheirSwitches) {
  std::set<std::string> named, switches;
  for (const Erratum& one : ledger().errata) {
    if (one.kind != "reading") continue;
    std::string name;
    for (const char c : one.switch_or_reason + ',') {
      if (c == ',')
        named.insert(std::exchange(name, ""));
      else if (c != ' ')
        name += c;
    }
  }
  for (std::size_t i = 0; i < switch_count; ++i)
    switches.insert(std::string(info(static_cast<Switch>(i)).name));
  switches.erase("criterion");
  EXPECT_EQ(named, switches);
}

TEST(Arguments, IdentifyTheConstantAndSigmaAlone) {
  std::vector<std::size_t> agreeing;
  for (const Argument& one : ledger().arguments) agreeing.push_back(one.agreeing());
  // The rough surface's σ_s has one digit. With it rough over medium leaves all exponents and all
  // criteria open, and medium over smooth leaves none. One film constant agrees, and one σ:
  // 0.82·1.4 is 1.146 within the precision of its factors.
  EXPECT_EQ(agreeing, (std::vector<std::size_t>{4, 3, 0, 9, 5, 1, 1}));
}

// h_oil/σ_s = 4 has one digit. λ is in proportion to it, and may be off by an eighth.
TEST(Arguments, OfTheInletCountThePrintPrecisionOfTheOil) {
  std::vector<std::string> agree;
  for (const Candidate& one : ledger().arguments[1].candidates) {
    if (one.agrees) agree.push_back(one.name);
    if (!one.value || one.name.ends_with("1.4σ_s")) continue;
    EXPECT_TRUE(is_close(*one.low, *one.value * 3.5 / 4, 1e-15, {})) << one.name;
    EXPECT_TRUE(is_close(*one.high, *one.value * 4.5 / 4, 1e-15, {})) << one.name;
  }
  EXPECT_EQ(agree, (std::vector<std::string>{"flooded_inlet, line gap", "flooded_inlet, point gap",
                                             "printed_exponents, line gap"}));
}

// For claim C2 the print precision leaves the inlet and the gap open, but not the scale of λ. Other
// claims keep the switches that they identify.
TEST(Arguments, LeaveNothingIdentifiedThatTheirCandidatesLeaveOpen) {
  std::size_t found = 0, others = 0;
  for (std::size_t i = 0; i < items().size(); ++i) {
    if (items()[i].claim != "C2") {
      others += ledger().item_statistics[i].identified.size();
      continue;
    }
    ++found;
    std::vector<Switch> identified;
    for (const Identification& one : ledger().item_statistics[i].identified)
      identified.push_back(one.which);
    EXPECT_EQ(identified, std::vector{Switch::lambda_scale}) << items()[i].id;
  }
  EXPECT_EQ(found, 3U);
  EXPECT_GT(others, 0U);
}

// An interval contains its candidate's value, and overlaps the reported one if they agree.
TEST(Arguments, IntervalsHoldTheirValuesAndDecide) {
  for (const Argument& argument : ledger().arguments)
    for (const Candidate& one : argument.candidates) {
      EXPECT_EQ(one.value.has_value(), one.low || one.high) << one.name;
      if (!one.value) continue;
      EXPECT_LE(one.low.value_or(*one.value), *one.value) << one.name;
      EXPECT_GE(one.high.value_or(*one.value), *one.value) << one.name;
      if (!one.low || !one.high) continue;
      EXPECT_EQ(one.agrees, *one.low <= argument.high && *one.high >= argument.low) << one.name;
    }
}

TEST(IndependentNumbers, AreReproducedToTheirLastDigit) {
  ASSERT_EQ(ledger().independent.size(), 12U);
  for (const IndependentNumber& one : ledger().independent) {
    EXPECT_EQ(one.reproduced, true) << one.case_name << ' ' << one.quantity;
    EXPECT_TRUE(is_close(one.computed, one.reported, std::pow(10, 1 - one.digits) / 2, {}));
  }
}

TEST(CommittedLedger, HasTheVerdictsAndNumbersThatComeOut) {
  const LedgerChanges changes = changes_since(committed, ledger(), ledger().readings, {});
  for (const std::string& line : changes.verdicts) ADD_FAILURE() << "verdict changed: " << line;
  for (const std::string& line : changes.numbers) ADD_FAILURE() << "number moved: " << line;
  // The whole file is compared: no reading or item is missing in it.
  const std::string text = content_of(committed);
  const auto lines = std::count(text.begin(), text.end(), '\n');
  EXPECT_EQ(static_cast<std::size_t>(lines), 1 + ledger().readings.size() * items().size());
}

LedgerChanges changes_since_text(const std::string& text) {
  const TemporaryFolder folder;
  return changes_since(folder.written("ledger.csv", text), ledger(), ledger().readings, {});
}

TEST(CommittedLedger, ChangesAreNamed) {
  std::string text = ledger_csv(ledger(), ledger().readings, {});
  text = replaced(text, ",reproduced,reproduced,", ",not reproduced,reproduced,");  // C2.rough
  text =
      replaced(text, "corrected,corrected,C1.rough,C1,2.0", "corrected,corrected,C1.rough,C1,2.1");
  const LedgerChanges changes = changes_since_text(text);
  ASSERT_EQ(changes.verdicts.size(), 1U);
  EXPECT_TRUE(changes.verdicts[0].starts_with("C2.rough, corrected: was not reproduced"))
      << changes.verdicts[0];
  ASSERT_EQ(changes.numbers.size(), 1U);
  EXPECT_TRUE(changes.numbers[0].starts_with("C1.rough, corrected: was 2.1")) << changes.numbers[0];
}

// A number counts as moved if it changed by a millionth or more. An item that the committed ledger
// lacks is reported.
TEST(CommittedLedger, MovedAndMissingItemsAreNamed) {
  const std::string text = ledger_csv(ledger(), ledger().readings, {});
  const std::string start = "corrected,corrected,C1.rough,C1,";
  const std::size_t number = text.find(start) + start.size();
  const std::size_t length = text.find(',', number) - number;
  const double computed = std::stod(text.substr(number, length));
  for (const auto& [factor, is_told] : {std::pair{1 + 5e-7, false}, std::pair{1 + 2e-6, true},
                                        std::pair{1 - 2e-6, true}, std::pair{1.01, true}}) {
    std::string moved = text;
    moved.replace(number, length, fmt::format("{}", computed * factor));
    const LedgerChanges changes = changes_since_text(moved);
    EXPECT_EQ(changes.numbers.size(), is_told ? 1U : 0U) << factor;
    EXPECT_EQ(changes.verdicts.size(), 0U) << factor;
  }
  std::string shorter = text;
  const std::size_t line = shorter.find("corrected,corrected,C2.rough");
  shorter.erase(line, shorter.find('\n', line) + 1 - line);
  const LedgerChanges changes = changes_since_text(shorter);
  ASSERT_EQ(changes.verdicts.size(), 1U);
  EXPECT_EQ(changes.verdicts[0], "C2.rough, corrected: was not there");
}

// The message on a wrong data file is one line that names the file.
TEST(PublishedFiles, AreRefusedByNameWhereTheyAreWrong) {
  const TemporaryFolder folder;
  const std::string path = folder.file("claims.tsv"), good = content_of(published + "/claims.tsv");
  const auto refused = [&](const std::string& from, const std::string& to, const std::string& why) {
    try {
      read_claims(folder.written("claims.tsv", replaced(good, from, to)));
      ADD_FAILURE() << "not refused: " << to;
    } catch (const std::runtime_error& error) {
      const std::string what = error.what();
      EXPECT_TRUE(what.starts_with(path)) << what;
      EXPECT_NE(what.find(why), std::string::npos) << what;
      EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    }
  };
  refused("\tonset_speed\t", "\tonset_speeds\t", "onset_speeds is no quantity");
  refused("\tnumber\t", "\tnumbers\t", "numbers is no rule");
  refused("\t0.5\t0.1\t", "\thalf\t0.1\t", "half is no number");
  refused("\trough\tboth\t", "\trough\t", "a row of 15 cells under 16 columns");
  for (const std::string part : {"0.01 of 3 to 0.0001", "0.01 of 0.0001", "0 of 0.0001 to 3",
                                 "0.01 of 0 to 3", "0.01 of 0.0001 to 3 m/s", "0.01 of it"})
    refused("\t0.01 of 0.0001 to 3\t", "\t" + part + "\t", part + " is no ");
  refused("quantity\tsurface", "quantities\tsurface", "no column quantity");
  std::filesystem::remove(path);
  EXPECT_THROW(read_claims(path), std::runtime_error);
  EXPECT_THROW(read_paper_scenes(folder.file("no_such_folder")), std::runtime_error);
}

}  // namespace
}  // namespace tribo::reproduction
