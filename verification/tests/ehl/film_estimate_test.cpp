// SPDX-License-Identifier: Apache-2.0
// Checks that stated errors hold: for sequences with a known limit; for solved films against films
// on finer grids, against those of the second method (generators/line_collocation.hpp), and as the
// inlet grows.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "ehl/films.hpp"
#include "ehl/sampled_contact.hpp"
#include "generators/line_collocation.hpp"
#include "support/judge.hpp"

namespace tribo::verification {
namespace {

using ehl::Estimate;
using ehl::SolvedFilm;

std::vector<double> sequence(int count, double limit, double second, double fourth) {
  std::vector<double> values;
  for (int k = 0; k < count; ++k)
    values.push_back(limit + second * std::pow(0.25, k) + fourth * std::pow(0.0625, k));
  return values;
}

TEST(EstimateOf, TakesRichardsonsValueOfTheSecondOrder) {
  const Estimate pure = ehl::estimate_of(sequence(4, 3, 1, 0));
  EXPECT_TRUE(is_within(pure.value, 3, 1e-15));
  const ehl::Caution usual;
  EXPECT_TRUE(is_within(pure.error, usual.of_change * 3. / 64, 1e-15));  // the last change is 3/64
  EXPECT_TRUE(is_within(ehl::estimate_of(sequence(4, 3, 1, 0), {.of_change = 0}).error, 0, 1e-15));
  EXPECT_TRUE(is_within(pure.order, 2, 1e-13));
  // 3 + 1/16 + 0.5/256 and 3 + 1/64 + 0.5/4096 give 3 − 4 · 0.5/4096.
  const Estimate mixed = ehl::estimate_of(sequence(4, 3, 1, 0.5));
  EXPECT_TRUE(is_within(mixed.value, 3 - 4 * 0.5 / 4096, 1e-15));
  // Richardson's value changed by 15 · 4 · 0.5/256 on the grids before. This change counts an
  // eighth of what the last change counts.
  EXPECT_TRUE(is_within(mixed.error, usual.of_last * usual.falling * 15 * 4 * 0.5 / 256, 1e-14));
  // The change before that counts an eighth again, and earlier changes do not count.
  EXPECT_TRUE(is_within(ehl::estimate_of(sequence(6, 3, 1, 0.5), {1, 0.5, 0}).error,
                        0.25 * 15 * 4 * 0.5 / std::pow(16, 3), 1e-14));
  EXPECT_TRUE(is_within(ehl::estimate_of(sequence(4, 3, 1, 0.5), {1, 0, 0}).error,
                        15 * 4 * 0.5 / 4096, 1e-14));
}

TEST(EstimateOf, GridBesideCountsByWhatItDiffersFromTheSecondOrder) {
  const std::vector<double> values = sequence(4, 3, 1, 0);
  // The last grid shows 3 + 1/64; one of 7/8 of its cells shows 3 + (8/7)²/64.
  const double second_order = 3 + 64. / 49 / 64, waver = 1e-3;
  const ehl::Caution caution{.of_last = 0, .of_change = 0, .of_waver = 8};
  for (const double off : {-waver, 0., waver}) {
    const Estimate got = ehl::estimate_of(values, caution, {second_order + off, 8. / 7});
    EXPECT_TRUE(is_within(got.value, 3, 1e-15));
    EXPECT_TRUE(is_within(got.error, 8 * std::fabs(off), 1e-13)) << off;
  }
  // The greatest of the shares is the error; this grid does not make it smaller.
  EXPECT_EQ(ehl::estimate_of(values, {}, {second_order, 8. / 7}).error,
            ehl::estimate_of(values).error);
  // Without that grid, the one change of Richardson's value on three grids counts three times.
  const std::vector<double> three = sequence(3, 3, 1, 0.1);
  const ehl::Caution of_last{.of_last = 1, .of_change = 0};
  EXPECT_EQ(ehl::estimate_of(three, of_last).error,
            3 * ehl::estimate_of(three, of_last, {3.1, 8. / 7}).error);
}

TEST(EstimateOf, ErrorHoldsWhateverTheCoefficients) {
  Sampler sampler(21);
  for (int i = 0; i < 2000; ++i) {
    const double limit = sampler.uniform(1, 10);
    const int count = static_cast<int>(sampler.uniform(3, 8));
    const double second = sampler.uniform(-1, 1), fourth = sampler.uniform(-3, 3);
    const Estimate got = ehl::estimate_of(sequence(count, limit, second, fourth));
    EXPECT_TRUE(is_estimated(got, limit, 1e-15))
        << count << " grids: " << second << "/4^k + " << fourth << "/16^k";
  }
}

TEST(EstimateOf, NoiseAddsNoMoreThanItsOwnSize) {
  Sampler sampler(22);
  for (int i = 0; i < 2000; ++i) {
    const double noise = sampler.log_uniform(1e-8, 1e-2);
    std::vector<double> values = sequence(4, 5, sampler.uniform(-1, 1), sampler.uniform(-1, 1));
    for (double& value : values) value += noise * sampler.uniform(-1, 1);
    EXPECT_TRUE(is_estimated(ehl::estimate_of(values), 5, 5. / 3 * noise)) << "noise " << noise;
  }
}

TEST(EstimateOf, IrregularValuesKeepTheLastAndItsChanges) {
  for (const std::vector<double>& values :
       {std::vector<double>{1, 2, 1.5}, {1, 2, 3}, {1, 1, 2}, {1, 1.5, 1.4999}}) {
    const Estimate got = ehl::estimate_of(values);
    EXPECT_EQ(got.value, values[2]);
    EXPECT_EQ(got.error, 1.5 * (std::abs(values[2] - values[1]) + std::abs(values[1] - values[0])));
    EXPECT_EQ(std::isnan(got.order), true);
  }
  // An order of 1 is regular only where the caution says so.
  EXPECT_EQ(ehl::estimate_of({1, 1.5, 1.75}).value, 1.75);
  EXPECT_TRUE(
      is_within(ehl::estimate_of({1, 1.5, 1.75}, {.least_order = 0.9, .greatest_order = 1.1}).value,
                1.75 + 0.25 / 3, 1e-15));
  EXPECT_EQ(ehl::estimate_of({1, 1.5, 1.75}, {.least_order = 1}).value, 1.75);
  EXPECT_EQ(ehl::estimate_of({1, 1.5, 1.75}, {.least_order = 0, .greatest_order = 1}).value, 1.75);
  EXPECT_EQ(ehl::estimate_of({2, 2, 2}).value, 2);
  EXPECT_EQ(ehl::estimate_of({2, 2, 2}).error, 0);
}

TEST(EstimateOf, IrregularValuesTakeRichardsonsWhereAGridBesideCounts) {
  const std::vector<double> values{1, 1.5, 1.54};  // an order of 3.6
  const double richardson = 1.54 + 0.04 / 3, ratio = 4. / 3;
  const double second_order = richardson - ratio * ratio * 0.04 / 3;
  const ehl::Caution caution{.of_waver = 3, .of_irregular = 0.5};
  for (const double waver : {-0.1, -0.02, 0., 0.02, 0.1}) {
    const Estimate got = ehl::estimate_of(values, caution, {second_order + waver, ratio});
    EXPECT_TRUE(is_within(got.value, richardson, 1e-15)) << waver;
    // The change before counts a quarter, and here more than the last one.
    EXPECT_TRUE(is_within(got.error, std::fmax(0.5 * 0.5 / 4, 3 * std::abs(waver)), 1e-14))
        << waver;
    EXPECT_TRUE(std::isnan(got.order)) << waver;
  }
  const Estimate by_last = ehl::estimate_of({1, 1.1, 1.5}, caution, {1.3, ratio});
  EXPECT_GE(by_last.error, 0.5 * 0.4);
  for (const Estimate& got : {ehl::estimate_of(values, caution),
                              ehl::estimate_of(values, {.of_waver = 3}, {second_order, ratio})}) {
    EXPECT_EQ(got.value, 1.54);
    EXPECT_TRUE(is_within(got.error, 1.5 * 0.54, 1e-14));
  }
}

// Values of any order from 1 to 4, and of the second order with noise that falls like it.
TEST(EstimateOf, ErrorHoldsForIrregularValuesWithAGridBeside) {
  constexpr ehl::Caution caution{.of_waver = 3, .of_irregular = 1};
  Sampler sampler(71);
  int judged = 0;
  for (int i = 0; i < 4000; ++i) {
    const bool is_noisy = i % 2 == 0;
    const double order = is_noisy ? 2 : sampler.uniform(1, 4);
    const auto value = [&](double cells) {
      const double noise = is_noisy ? 0.3 * sampler.uniform(-1, 1) : 0;
      return 5 - (1 + noise) * std::pow(cells, -order);
    };
    const std::vector<double> values{value(1), value(2), value(4)};
    const Estimate got = ehl::estimate_of(values, caution, {value(3), 4. / 3});
    if (!std::isnan(got.order)) continue;
    ++judged;
    EXPECT_TRUE(is_estimated(got, 5, 0)) << "order " << order << (is_noisy ? ", noisy" : "");
  }
  EXPECT_GT(judged, 500);
}

TEST(EstimateOf, TooFewValuesGiveNoNumber) {
  for (const std::vector<double>& values : {std::vector<double>{}, {1}, {1, 2}}) {
    EXPECT_EQ(std::isnan(ehl::estimate_of(values).value), true);
    EXPECT_EQ(std::isnan(ehl::estimate_of(values).error), true);
  }
}

using Member = Estimate SolvedFilm::*;
constexpr std::array<Member, 3> films{&SolvedFilm::central, &SolvedFilm::minimum,
                                      &SolvedFilm::at_greatest_pressure};

// A small sample of what `make film-survey` checks on 300 contacts, and compressible liquids whose
// spike no grid resolves: their least film lies beside the spike and depends on it.
TEST(SolvedFilm, ErrorsHoldAgainstFinerGridsAndAreNotFarTooLarge) {
  ContactSampler sampler(23);
  std::vector<SampledContact> contacts;
  while (contacts.size() < 36) {
    const SampledContact drawn = sampler.next();
    const bool has_sharp_spike =
        drawn.contact.load_number > 20 && drawn.contact.material_number > 12;
    if (contacts.size() < 24 || (drawn.is_compressible && has_sharp_spike))
      contacts.push_back(drawn);
  }
  std::array<std::vector<double>, 3> cautions;  // of each film: stated error over true error
  for (const SampledContact& drawn : contacts) {
    const SolvedFilm fine = solved(drawn.contact, {.tolerance = 1e-4, .greatest_cells = 2048});
    for (const double tolerance : {1e-3, 1e-2}) {
      const SolvedFilm loose =
          solved(drawn.contact, {.tolerance = tolerance, .greatest_cells = 512});
      for (std::size_t i = 0; i < films.size(); ++i) {
        const Estimate &one = loose.*films[i], &truth = fine.*films[i];
        EXPECT_TRUE(is_estimated(one, truth.value, truth.error))
            << "M = " << drawn.contact.load_number << ", L = " << drawn.contact.material_number
            << ", tolerance " << tolerance << ", " << loose.grids << " grids";
        if (truth.error < one.error / 3)
          cautions[i].push_back(one.error / std::fabs(one.value - truth.value));
      }
    }
  }
  // Stated errors that are far too large would hold, too, but would be useless.
  for (std::vector<double>& of_film : cautions) {
    ASSERT_GT(of_film.size(), 30U);
    const auto middle = of_film.begin() + static_cast<long>(of_film.size() / 2);
    std::nth_element(of_film.begin(), middle, of_film.end());
    EXPECT_LT(*middle, 10);
  }
}

// Central films of contacts whose errors an earlier version stated up to a fifth too small.
TEST(SolvedFilm, ErrorsHoldOnEachGridOfContactsWithSharpSpikes) {
  std::vector<ehl::LineContact> contacts;
  for (const auto& [m, l] : {std::array<double, 2>{352.042881943644, 24.8705698235098},
                             {178.166599613328, 21.911676564499},
                             {279.105850514544, 11.404423268982}})
    contacts.push_back(ehl::barus_contact(m, l));
  contacts.back().fluid.roelands_pressure = 14.3646775197676;
  contacts.back().fluid.roelands_index = 1.00428297964475;
  contacts.back().fluid.density_pressure = 4.77199456588891;
  for (const ehl::LineContact& contact : contacts) {
    const SolvedFilm fine = solved(contact, {.tolerance = 1e-9, .greatest_cells = 4096});
    for (const int cells : {256, 512, 1024}) {
      const SolvedFilm coarse = solved(contact, {.tolerance = 1e-9, .greatest_cells = cells});
      for (const Member film : films)
        EXPECT_TRUE(is_estimated(coarse.*film, (fine.*film).value, (fine.*film).error))
            << "M = " << contact.load_number << ", " << cells << " cells";
    }
  }
}

TEST(SolvedFilm, AgreesWithTheSecondMethodWithinBothErrors) {
  Sampler sampler(24);
  std::vector<ehl::LineContact> contacts;
  constexpr std::pair<double, double> numbers[]{{1, 0},     {200, 0}, {1, 7.5}, {10, 5},
                                                {200, 2.5}, {50, 5},  {0.1, 0}, {5, 7.5}};
  for (const auto& [m, l] : numbers) contacts.push_back(ehl::barus_contact(m, l));
  for (int i = 0; i < 6; ++i)
    contacts.push_back(three_liquids(sampler.log_uniform(1, 100),
                                     sampler.uniform(0, 5))[static_cast<std::size_t>(i % 3)]);
  int with_spike = 0;
  for (const ehl::LineContact& contact : contacts) {
    const SolvedFilm film = solved(contact);
    const std::size_t count = film.film.x.size();
    const reference::CollocatedFilm other =
        reference::collocate_line_film(contact, {film.film.x,
                                                 {film.film.pressure.data(), count},
                                                 {film.film.film.data(), count},
                                                 film.film.separation,
                                                 film.film.mass_flow});
    EXPECT_EQ(other.is_solved, true) << other.reason;
    const auto compare = [&](const Estimate& one, const reference::CollocatedNumber& two,
                             const char* name) {
      EXPECT_TRUE(is_estimated(one, two.value, two.error))
          << name << ", M = " << contact.load_number << ", L = " << contact.material_number
          << "; expected is the second method's";
    };
    compare(film.central, other.central, "central film");
    compare(film.minimum, other.minimum, "least film");
    compare(film.at_greatest_pressure, other.at_greatest_pressure, "film at the greatest pressure");
    EXPECT_LT(other.central.error, 1e-5 * other.central.value);
    if (std::isnan(film.spike_pressure.value) || std::isnan(other.spike_pressure.value)) continue;
    compare(film.spike_pressure, other.spike_pressure, "height of the spike");
    compare(film.spike_place, other.spike_place, "place of the spike");
    ++with_spike;
  }
  EXPECT_GE(with_spike, 3);
}

TEST(CollocatedFilm, SaysThatThereIsNoStart) {
  const reference::CollocatedFilm film =
      reference::collocate_line_film(ehl::barus_contact(10, 5), {{}, {}, {}, 0, 0});
  EXPECT_EQ(film.is_solved, false);
  EXPECT_EQ(film.reason, "there is no pressure to start from");
}

// The second start has a pressure that is 10 % off, on another mesh.
TEST(CollocatedFilm, DoesNotDependOnItsStart) {
  const ehl::LineContact contact = ehl::barus_contact(2, 1);
  const ehl::LineFilm solved_film = solved(contact).film;
  const std::size_t count = solved_film.x.size();
  const std::span<const double> h(solved_film.film.data(), count);
  ehl::Numbers rough(solved_film.pressure.begin(), solved_film.pressure.end());
  const reference::CollocatedFilm one = reference::collocate_line_film(
      contact, {solved_film.x, rough, h, solved_film.separation, solved_film.mass_flow});
  for (std::size_t i = 0; i < count; ++i) rough[i] *= 1 + 0.1 * std::sin(3 * solved_film.x[i]);
  const reference::CollocatedFilm two = reference::collocate_line_film(
      contact, {solved_film.x, rough, h, 1.1 * solved_film.separation, 0.9 * solved_film.mass_flow},
      {.elements = 45});
  for (const auto number :
       {&reference::CollocatedFilm::central, &reference::CollocatedFilm::minimum,
        &reference::CollocatedFilm::outlet})
    EXPECT_TRUE(is_within((one.*number).value, (two.*number).value,
                          (one.*number).error + (two.*number).error));
  EXPECT_LT(one.central.error, 1e-6 * one.central.value);
}

TEST(SolvedFilm, LongerInletMovesItByNoMoreThanStated) {
  for (const auto& [m, l] : {std::array<double, 2>{0.01, 0}, {0.1, 0}, {1, 0}, {2, 2}}) {
    const ehl::LineContact contact = ehl::barus_contact(m, l);
    // The grids are so fine that the error left is that of the inlet.
    const SolvedFilm film = solved(contact, {.tolerance = 1e-9});
    ehl::Numbers x = film.film.x;
    const double growth = x[0] / x[1];
    ehl::Numbers upstream;
    for (double at = 8 * x[0]; at < x[0] * std::sqrt(growth); at /= growth) upstream.push_back(at);
    x.insert(x.begin(), upstream.begin(), upstream.end());
    const ehl::LineFilm longer = ehl::solve_on(contact, x, film.film, {});
    ASSERT_EQ(longer.outcome, ehl::Outcome::solved);
    const ehl::FilmFeatures before = ehl::features_of(contact, film.film);
    const ehl::FilmFeatures after = ehl::features_of(contact, longer);
    EXPECT_GE(film.central.error, film.domain_error * film.central.value);
    EXPECT_GE(film.minimum.error, film.domain_error * film.minimum.value);
    // An inlet eight times as long leaves a 64th of the error of this one.
    for (const auto number : {&ehl::FilmFeatures::central, &ehl::FilmFeatures::minimum,
                              &ehl::FilmFeatures::at_greatest_pressure})
      EXPECT_TRUE(is_within(after.*number / before.*number, 1, film.domain_error))
          << m << ", " << l;
  }
}

TEST(SolvedFilm, ConvergesAtSecondOrderWhereTheContactIsResolved) {
  for (const auto& [m, l] : {std::array<double, 2>{5, 3}, {10, 0}, {10, 5}, {20, 2}, {50, 1}}) {
    const SolvedFilm film = solved(ehl::barus_contact(m, l), {.tolerance = 1e-5});
    for (const Member member : films)
      EXPECT_TRUE(is_within((film.*member).order, 2, 0.2)) << "M = " << m << ", L = " << l;
  }
}

}  // namespace
}  // namespace tribo::verification
