// SPDX-License-Identifier: Apache-2.0
#include "sweep/summary.hpp"

#include <algorithm>
#include <array>
#include <boost/math/distributions/binomial.hpp>
#include <iterator>
#include <map>
#include <numeric>

namespace tribo::sweep {
namespace {

// From this variance of K on, the expansion in ranks_of() is off by less than 1/50 of a rank.
constexpr double exact_below_variance = 400;
constexpr double two_sided_95 = 1.959963984540054;

// low and high: the least k with P(K ≤ k) ≥ 2.5 %, and with P(K ≤ k) ≥ 97.5 %. K is the number of n
// independent values that are below the p-quantile.
struct QuantileRanks {
  double low, high;
};
QuantileRanks ranks_of(double n, double p) {
  const double variance = n * p * (1 - p);
  if (variance < exact_below_variance) {
    using namespace boost::math::policies;
    using Up = policy<discrete_quantile<integer_round_up>>;
    const boost::math::binomial_distribution<double, Up> below(n, p);
    return {boost::math::quantile(below, 0.025), boost::math::quantile(below, 0.975)};
  }
  // Cornish and Fisher's expansion up to the skewness, with the correction for continuity.
  const double centre = n * p - 0.5 + (two_sided_95 * two_sided_95 - 1) * (1 - 2 * p) / 6;
  const double reach = two_sided_95 * std::sqrt(variance);
  return {std::ceil(centre - reach), std::ceil(centre + reach)};
}

// Keeps the ranks of the last n, because many columns of a result have the same number of values.
QuantileRanks known_ranks_of(double n, double p) {
  thread_local double count = -1;
  thread_local std::map<double, QuantileRanks> by_level;
  if (n != count) by_level.clear();
  count = n;
  const auto [known, is_new] = by_level.try_emplace(p);
  if (is_new) known->second = ranks_of(n, p);
  return known->second;
}

// Calls use(lane, value) for each value. The lanes are so many that an addition need not wait for
// the one before it.
constexpr std::size_t lanes = 8;
template <class Use>
void in_lanes(std::span<const double> values, const Use& use) {
  std::size_t first = 0;
  for (; first + lanes <= values.size(); first += lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane) use(lane, values[first + lane]);
  for (std::size_t i = first; i < values.size(); ++i) use(i - first, values[i]);
}

}  // namespace

void Moments::add(std::span<const double> values) {
  if (values.empty()) return;
  const auto n = static_cast<double>(values.size());
  const double origin = values[0];  // so that equal values have their mean exactly
  std::array<double, lanes> distances{}, lowest, highest;
  lowest.fill(origin);
  highest.fill(origin);
  in_lanes(values, [&](std::size_t lane, double value) {
    distances[lane] += value - origin;
    lowest[lane] = std::min(lowest[lane], value);
    highest[lane] = std::max(highest[lane], value);
  });
  const double near_mean = origin + std::accumulate(distances.begin(), distances.end(), 0.0) / n;
  std::array<double, lanes> rests{}, squared_rests{};
  in_lanes(values, [&](std::size_t lane, double value) {
    const double rest = value - near_mean;
    rests[lane] += rest;
    squared_rests[lane] += rest * rest;
  });
  const double rest = std::accumulate(rests.begin(), rests.end(), 0.0) / n;
  const double sum = std::accumulate(squared_rests.begin(), squared_rests.end(), 0.0);
  merge({values.size(), near_mean + rest, std::max(sum - n * rest * rest, 0.0),
         std::ranges::min(lowest), std::ranges::max(highest)});
}

void Moments::merge(const Moments& other) {
  if (other.count == 0) return;
  if (count == 0) {
    *this = other;
    return;
  }
  const auto ours = static_cast<double>(count);
  const auto theirs = static_cast<double>(other.count);
  const double distance = other.mean - mean;
  const double part = theirs / (ours + theirs);
  mean += distance * part;
  squares += other.squares + distance * distance * ours * part;
  count += other.count;
  least = std::min(least, other.least);
  greatest = std::max(greatest, other.greatest);
}

void ValueSummary::add(std::span<const double> values) {
  const auto is_defined = [](double value) { return std::isfinite(value); };
  if (std::all_of(values.begin(), values.end(), is_defined)) {
    moments.add(values);
    sketch.add(values);
    return;
  }
  std::vector<double> defined;
  defined.reserve(values.size());
  std::copy_if(values.begin(), values.end(), std::back_inserter(defined), is_defined);
  undefined += values.size() - defined.size();
  moments.add(defined);
  sketch.add(defined);
}

void ValueSummary::merge(const ValueSummary& other) {
  moments.merge(other.moments);
  sketch.merge(other.sketch);
  undefined += other.undefined;
}

Bounded quantile_of(const ValueSummary& summary, double p) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const QuantileSketch& sketch = summary.sketch;
  const std::uint64_t count = sketch.count();
  if (count == 0) return {nan, nan, nan};
  const auto n = static_cast<double>(count);
  const auto within = [&](double value) {
    return std::clamp(value, summary.moments.least, summary.moments.greatest);
  };
  const auto at = [&](double rank) {  // rank 0 is the least value
    return sketch.value_at_rank(
        std::min(static_cast<std::uint64_t>(std::max(rank, 0.0)), count - 1));
  };
  // The values in order are x₁ ≤ x₂ …. The interval [x_l, x_h] is above the quantile if K < l, and
  // below it if K ≥ h. Each has at most 2.5 % probability for l = low and h = high + 1.
  const QuantileRanks ranks = known_ranks_of(n, p);
  Bounded quantile{within(at(std::ceil(n * p) - 1)), -infinity, infinity};
  if (ranks.low >= 1) {
    const double low = at(ranks.low - 1);
    quantile.low = within(low - QuantileSketch::relative_error * std::abs(low));
  }
  if (ranks.high < n) {
    const double high = at(ranks.high);
    quantile.high = within(high + QuantileSketch::relative_error * std::abs(high));
  }
  return quantile;
}

std::vector<QuantileSketch::Bin> histogram_of(const QuantileSketch& sketch, std::size_t most) {
  const std::vector<QuantileSketch::Bin> bins = sketch.bins();
  if (bins.empty() || most == 0) return {};
  // Bins are found by their middles: the lower edge of a negative bin belongs to the bin below it.
  const auto number = [](const QuantileSketch::Bin& bin) {
    return QuantileSketch::bin_of(bin.low / 2 + bin.high / 2);
  };
  const std::int32_t first = number(bins.front());
  const auto span = static_cast<std::size_t>(number(bins.back()) - first) + 1;
  const std::size_t joined = (span + most - 1) / most;
  std::vector<QuantileSketch::Bin> histogram((span + joined - 1) / joined);
  for (std::size_t i = 0; i < histogram.size(); ++i) {
    const std::int32_t low = first + static_cast<std::int32_t>(i * joined);
    histogram[i] = {QuantileSketch::edge(low),
                    QuantileSketch::edge(low + static_cast<std::int32_t>(joined)), 0};
  }
  for (const QuantileSketch::Bin& bin : bins)
    histogram[static_cast<std::size_t>(number(bin) - first) / joined].count += bin.count;
  return histogram;
}

}  // namespace tribo::sweep
