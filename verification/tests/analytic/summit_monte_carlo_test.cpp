// SPDX-License-Identifier: Apache-2.0
// Greenwood–Tripp and Greenwood–Williamson against summits drawn at random: each touching one is a
// Hertz contact of paraboloids, and nothing else goes in. Judged by z = (estimate − model)/standard
// error; the prefactors that the paper prints must be rejected by the same samples.
#include <gtest/gtest.h>

#include <vector>

#include "sampling/philox.hpp"
#include "support/judge.hpp"
#include "tribo/asperity_contact.hpp"
#include "tribo/hertz.hpp"

namespace tribo::verification {
namespace {

constexpr double accepted = 5;   // |z| of the model; chance alone passes it once in two million
constexpr double rejected = 20;  // |z| of a wrong prefactor

// Vectors 1 to 3 of Random123's kat_vectors.
TEST(Philox, GivesTheKnownAnswersOfRandom123) {
  EXPECT_EQ(philox_words({0, 0, 0, 0}, {0, 0}),
            (PhiloxCounter{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(
      philox_words({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
      (PhiloxCounter{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(
      philox_words({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
      (PhiloxCounter{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

// The mean of a quantity over samples, with the means of its batches.
class Estimate {
 public:
  static constexpr int batches = 200;
  static constexpr std::uint64_t samples_per_batch = 20000;
  static constexpr std::uint64_t samples = batches * samples_per_batch;

  void add(std::uint64_t i, double value) {
    batch_sums_[i / samples_per_batch] += value;
    sum_of_squares_ += value * value;
  }
  double mean() const {
    double sum = 0;
    for (const double batch : batch_sums_) sum += batch;
    return sum / static_cast<double>(samples);
  }
  double z_score(double expected) const { return (mean() - expected) / standard_error(samples); }
  // The mean over batches of the squared z-score of a batch: 1 where the standard error is honest.
  double mean_square_batch_z(double expected) const {
    double sum = 0;
    for (const double batch : batch_sums_) {
      const double z = (batch / static_cast<double>(samples_per_batch) - expected) /
                       standard_error(samples_per_batch);
      sum += z * z;
    }
    return sum / batches;
  }

 private:
  double standard_error(std::uint64_t count) const {
    const double variance = sum_of_squares_ / static_cast<double>(samples) - mean() * mean();
    return std::sqrt(variance / static_cast<double>(count));
  }
  std::array<double, batches> batch_sums_{};
  double sum_of_squares_ = 0;
};

struct Estimates {
  Estimate load, area, count;
};

// The load of paraboloids pressed together by w > 0, and the area on which they touch.
double hertz_load(double w, double radius, double modulus) {
  return 4.0 / 3 * modulus * std::sqrt(radius) * w * std::sqrt(w);
}
double hertz_area(double w, double radius) { return std::numbers::pi * radius * w; }

// A rough surface under load; δ = 0.4, so that its sign matters.
struct Case {
  double density = 7e10, radius = 1.3e-5, sd = 6e-8, offset = 0.4;
  double modulus = 9e10, load = 30, body_radius = 0.012;
  double area = hertz_point(load, modulus, body_radius).nominal_area;
  double roughness = density * radius * sd;

  AsperityContact<double> contact(AsperityModel model) const {
    return asperity_contact(model, density, radius, sd, offset, modulus, area, load);
  }
};

constexpr std::array separations{0.0, 0.7, 1.9, 2.8};  // of the mean planes, over σ_s

// What the model says of the same, and whether the samples agree with it.
void expect_agreement(const Estimate& estimate, double model, const char* quantity,
                      double separation) {
  EXPECT_TRUE(is_within(estimate.z_score(model), 0, accepted))
      << quantity << ": estimate " << estimate.mean() << ", model " << model
      << describe({{"separation", separation}});
  // a mean of 200 squares of nearly normal numbers: 1 ± √(2/200)
  EXPECT_TRUE(is_within(estimate.mean_square_batch_z(model), 1, 5 * std::sqrt(2.0 / 200)))
      << quantity << ": the standard error is not that of the batches"
      << describe({{"separation", separation}});
}
void expect_rejection(const Estimate& estimate, double wrong, const char* what, double separation) {
  EXPECT_GT(std::abs(estimate.z_score(wrong)), rejected)
      << what << " is not told from the model" << describe({{"separation", separation}});
}

// A smooth plane at the separation above the mean plane of the rough face; its summits stand δσ_s
// above that plane in the mean. Quantities are those of all n A_nom summits.
std::vector<Estimates> summits_against_a_plane(const Case& c) {
  std::vector<Estimates> estimates(separations.size());
  const double summits = c.density * c.area;
  for (std::uint64_t i = 0; i < Estimate::samples; i += 2) {
    const RandomSample sample = random_sample(1, i);
    for (const std::uint64_t k : {std::uint64_t{0}, std::uint64_t{1}}) {
      const double height = c.sd * ((k == 0 ? sample.first : sample.second) + c.offset);
      for (std::size_t s = 0; s < separations.size(); ++s) {
        const double w = height - separations[s] * c.sd;
        if (!(w > 0)) continue;
        estimates[s].load.add(i + k, summits * hertz_load(w, c.radius, c.modulus));
        estimates[s].area.add(i + k, summits * hertz_area(w, c.radius));
        estimates[s].count.add(i + k, summits);
      }
    }
  }
  return estimates;
}

TEST(GreenwoodWilliamson, IsRandomSummitsAgainstAPlane) {
  const Case c;
  const auto contact = c.contact(AsperityModel::greenwood_williamson);
  const std::vector<Estimates> estimates = summits_against_a_plane(c);
  for (std::size_t s = 0; s < separations.size(); ++s) {
    const double separation = separations[s];
    const double load =
        c.load * moment_product(contact.stiffness, Order::three_halves, separation - c.offset);
    const double area = c.area * real_area_ratio(contact, separation);
    const double count = summit_count(contact, separation);
    expect_agreement(estimates[s].load, load, "load", separation);
    expect_agreement(estimates[s].area, area, "area", separation);
    expect_agreement(estimates[s].count, count, "count", separation);
    expect_rejection(estimates[s].load, 2 * load, "2E* for E*", separation);
    expect_rejection(estimates[s].area, 2 * area, "the section of the summits, 2πβw", separation);
    expect_rejection(estimates[s].count, count / 2, "half the count", separation);
    // the offset with the other sign, and two planes for one
    for (const double offset : {-c.offset, 2 * c.offset})
      expect_rejection(
          estimates[s].load,
          c.load * moment_product(contact.stiffness, Order::three_halves, separation - offset),
          "another offset", separation);
  }
}

// Two faces of n summits per area each, every height of standard deviation σ_s/√2. The paraboloids
// z₁ − p²/2β and −(z₂ − (p−x)²/2β) approach each other most half way between the summits. The
// lateral offset is drawn on the disc within which the pair touches, x² ≤ 4β(z₁ + z₂ − d); there
// are n² A_nom pairs per area of offset, so that the disc's area is the weight of the sample.
std::vector<Estimates> pairs_of_summits(const Case& c) {
  std::vector<Estimates> estimates(separations.size());
  const double pairs = c.density * c.density * c.area;
  for (std::uint64_t i = 0; i < Estimate::samples; ++i) {
    const RandomSample sample = random_sample(2, i);
    const double one = c.sd * std::numbers::sqrt2 / 2 * sample.first + c.sd * c.offset;
    const double other = c.sd * std::numbers::sqrt2 / 2 * sample.second;
    for (std::size_t s = 0; s < separations.size(); ++s) {
      const double d = separations[s] * c.sd;
      const double reach_squared = 4 * c.radius * (one + other - d);
      if (!(reach_squared > 0)) continue;
      const double weight = pairs * std::numbers::pi * reach_squared;
      const double half_offset = std::sqrt(reach_squared * sample.uniform) / 2;
      const double fall = half_offset * half_offset / (2 * c.radius);
      const double w = (one - fall) + (other - fall) - d;
      estimates[s].load.add(i, weight * hertz_load(w, c.radius / 2, c.modulus));
      estimates[s].area.add(i, weight * hertz_area(w, c.radius / 2));
      estimates[s].count.add(i, weight);
    }
  }
  return estimates;
}

TEST(GreenwoodTripp, IsRandomPairsOfSummits) {
  const Case c;
  const auto contact = c.contact(AsperityModel::greenwood_tripp);
  const std::vector<Estimates> estimates = pairs_of_summits(c);
  for (std::size_t s = 0; s < separations.size(); ++s) {
    const double separation = separations[s];
    const double load =
        c.load * moment_product(contact.stiffness, Order::five_halves, separation - c.offset);
    const double area = c.area * real_area_ratio(contact, separation);
    const double count = summit_count(contact, separation);
    expect_agreement(estimates[s].load, load, "load", separation);
    expect_agreement(estimates[s].area, area, "area", separation);
    expect_agreement(estimates[s].count, count, "count", separation);
    expect_rejection(estimates[s].load, load / 2, "8√2/15 with E*, as printed", separation);
    expect_rejection(estimates[s].area, area / (std::numbers::pi * c.roughness),
                     "\"μnβ\" for π²(nβσ_s)²", separation);
    expect_rejection(estimates[s].count, count / 2, "2π for 4π", separation);
    for (const double offset : {-c.offset, 2 * c.offset})
      expect_rejection(
          estimates[s].load,
          c.load * moment_product(contact.stiffness, Order::five_halves, separation - offset),
          "another offset", separation);
    // each height with σ_s, not σ_s/√2: the sum of both then has √2 σ_s
    const double wide = std::numbers::sqrt2;
    expect_rejection(estimates[s].load,
                     load * std::pow(wide, 2.5) *
                         gaussian_moment(Order::five_halves, (separation - c.offset) / wide) /
                         gaussian_moment(Order::five_halves, separation - c.offset),
                     "σ_s of one face for that of the sum", separation);
  }
}

}  // namespace
}  // namespace tribo::verification
