// SPDX-License-Identifier: Apache-2.0
#include "sweep/distribution.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "sweep/correlation.hpp"
#include "sweep/design.hpp"

namespace tribo::sweep {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double least_part = 1e-300;

double part_above(double z) { return std::erfc(z * (std::numbers::sqrt2 / 2)) / 2; }
double part_below(double z) { return part_above(-z); }

std::string shortest(double value) {
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

}  // namespace

Distribution::Distribution(DistributionKind kind, double first, double second, double from,
                           double to)
    : kind_(kind), first_(first), second_(second), from_(from), to_(to) {}

Distribution Distribution::uniform(double from, double to) {
  return {DistributionKind::uniform, from, to - from, from, to};
}

Distribution Distribution::log_uniform(double from, double to) {
  // In long double, so that the product with u loses nothing: exp would make much of it.
  const long double width = std::log(static_cast<long double>(to) / from);
  Distribution d(DistributionKind::log_uniform, from, static_cast<double>(width), from, to);
  d.second_rest_ = static_cast<double>(width - d.second_);
  return d;
}

Distribution Distribution::normal(double mean, double sd, double from, double to) {
  Distribution d(DistributionKind::normal, mean, sd, from, to);
  d.truncate((from - mean) / sd, (to - mean) / sd);
  return d;
}

Distribution Distribution::log_normal(double median, double log_sd, double from, double to) {
  Distribution d(DistributionKind::log_normal, median, log_sd, from, to);
  const auto z = [&](double x) {
    const long double ratio = static_cast<long double>(x) / median;
    return static_cast<double>(std::log(ratio) / log_sd);
  };
  d.truncate(from > 0 ? z(from) : -infinity, z(to));
  return d;
}

void Distribution::truncate(double from, double to) {
  below_from_ = part_below(from);
  above_to_ = part_above(to);
  // By the tail in which both lie, where there is one: its parts are small, and exact as such.
  if (from > 0)
    between_ = part_above(from) - above_to_;
  else if (to < 0)
    between_ = part_below(to) - below_from_;
  else
    between_ = 1 - below_from_ - above_to_;
  if (!(part_above(from) >= least_part && part_below(to) >= least_part))
    throw std::invalid_argument("its bounds are too far out: next to nothing lies within");
}

double Distribution::value_at(double z) const {
  const double value =
      kind_ == DistributionKind::normal ? first_ + second_ * z : first_ * std::exp(second_ * z);
  return std::clamp(value, from_, to_);
}

double Distribution::truncated(double u, double one_minus_u) const {
  const double below = below_from_ + u * between_;
  if (below < 0.5) return below > 0 ? value_at(standard_normal(below)) : from_;
  const double above = above_to_ + one_minus_u * between_;
  return above > 0 ? value_at(-standard_normal(above)) : to_;
}

// Calls use(f) with the f of this distribution that is its quantile().
template <class Use>
auto Distribution::with_quantile(Use use) const {
  switch (kind_) {
    case DistributionKind::uniform:
      return use([first = first_, width = second_, to = to_](double u) {
        return std::min(first + width * u, to);
      });
    case DistributionKind::log_uniform:
      return use([d = *this](double u) {
        const double log_ratio = d.second_ * u;
        const double rest = std::fma(d.second_, u, -log_ratio) + d.second_rest_ * u;
        return std::clamp(d.first_ * (std::exp(log_ratio) * (1 + rest)), d.from_, d.to_);
      });
    default:
      if (below_from_ == 0 && above_to_ == 0)
        return use([d = *this](double u) { return d.value_at(standard_normal(u)); });
      return use([d = *this](double u) { return d.truncated(u, 1 - u); });
  }
}

double Distribution::quantile(double u) const {
  return with_quantile([u](const auto& quantile) { return quantile(u); });
}

void Distribution::quantiles(Rows<const double> u, Rows<double> values, std::size_t count) const {
  with_quantile([&](const auto& quantile) {
    for (std::size_t i = 0; i < count; ++i) *values[i] = quantile(*u[i]);
  });
}

double Distribution::quantile_of_normal(double z) const {
  if (kind_ == DistributionKind::uniform || kind_ == DistributionKind::log_uniform)
    return quantile(part_below(z));
  if (below_from_ == 0 && above_to_ == 0) return value_at(z);
  return truncated(part_below(z), part_above(z));
}

double Distribution::least() const { return quantile(least_unit_number); }
double Distribution::greatest() const { return quantile(1 - least_unit_number); }

std::string Distribution::text() const {
  std::string text(name(kind_));
  if (kind_ == DistributionKind::uniform || kind_ == DistributionKind::log_uniform)
    return text + " from " + shortest(from_) + " to " + shortest(to_);
  const bool is_normal = kind_ == DistributionKind::normal;
  text += (is_normal ? ", mean " : ", median ") + shortest(first_);
  text += (is_normal ? ", sd " : ", log_sd ") + shortest(second_);
  const bool has_from = from_ > (is_normal ? -infinity : 0);
  const bool has_to = to_ < infinity;
  if (has_from || has_to) text += ",";
  if (has_from) text += " from " + shortest(from_);
  if (has_to) text += " to " + shortest(to_);
  return text;
}

}  // namespace tribo::sweep
