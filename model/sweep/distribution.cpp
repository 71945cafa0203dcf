// SPDX-License-Identifier: Apache-2.0
#include "sweep/distribution.hpp"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "sweep/correlation.hpp"
#include "sweep/design.hpp"
#include "tribo/elementary.hpp"
#include "tribo/gaussian_moment.hpp"

namespace tribo::sweep {
namespace {

constexpr double least_part = 1e-300;

constexpr std::size_t block = 256;  // the numbers that are computed at a time

double part_above(double z) { return gaussian_moment(Order::zero, z); }
double part_below(double z) { return part_above(-z); }

// A type with more digits than a double: numbers computed from a logarithm lose nothing.
using Wide = boost::multiprecision::cpp_bin_float_quad;

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
  // In two parts, so that the product with u loses no digits; exp() would enlarge this loss.
  const Wide width = log(Wide(to) / from);
  Distribution d(DistributionKind::log_uniform, from, static_cast<double>(width), from, to);
  d.second_rest_ = static_cast<double>(Wide(width - d.second_));
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
    if (std::isinf(x)) return x;
    return static_cast<double>(Wide(log(Wide(x) / median) / log_sd));
  };
  d.truncate(from > 0 ? z(from) : -infinity, z(to));
  return d;
}

void Distribution::truncate(double from, double to) {
  below_from_ = part_below(from);
  above_to_ = part_above(to);
  // If both bounds lie in one tail, the parts of that tail are used: they are small and exact.
  if (from > 0)
    between_ = part_above(from) - above_to_;
  else if (to < 0)
    between_ = part_below(to) - below_from_;
  else
    between_ = 1 - below_from_ - above_to_;
  if (!(part_above(from) >= least_part && part_below(to) >= least_part))
    throw std::invalid_argument("its bounds are too far out: next to nothing lies within");
}

void Distribution::take_quantiles(std::span<double> numbers) const {
  if (kind_ == DistributionKind::uniform) {
    for (double& number : numbers) number = std::min(first_ + second_ * number, to_);
  } else if (kind_ == DistributionKind::log_uniform) {
    std::array<double, block> rest;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const double u = numbers[i];
      numbers[i] = second_ * u;
      rest[i] = std::fma(second_, u, -numbers[i]) + second_rest_ * u;
    }
    exponential(numbers, numbers);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      numbers[i] = std::clamp(first_ * (numbers[i] * (1 + rest[i])), from_, to_);
  } else if (is_truncated()) {
    take_truncated(
        numbers, [](double u) { return u; }, [](double u) { return 1 - u; });
  } else {
    standard_normals(numbers);
    take_values(numbers);
  }
}

// below(number) is the part of the normal between the bounds that lies below the wanted value, and
// above(number) is the rest. The value is computed from the smaller tail, which has all its digits.
template <class Below, class Above>
void Distribution::take_truncated(std::span<double> numbers, const Below& below,
                                  const Above& above) const {
  std::array<bool, block> is_upper;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double lower = below_from_ + below(numbers[i]) * between_;
    is_upper[i] = !(lower < 0.5);
    numbers[i] = is_upper[i] ? above_to_ + above(numbers[i]) * between_ : lower;
  }
  standard_normals(numbers);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (is_upper[i]) numbers[i] = -numbers[i];
  take_values(numbers);
}

void Distribution::take_values(std::span<double> normals) const {
  if (kind_ == DistributionKind::log_normal) {
    for (double& z : normals) z *= second_;
    exponential(normals, normals);
    for (double& e : normals) e = std::clamp(first_ * e, from_, to_);
  } else {
    for (double& z : normals) z = std::clamp(first_ + second_ * z, from_, to_);
  }
}

namespace {

// Copies the numbers of each block side by side, calls use(some), which changes them in place, and
// copies them to `to`.
template <class Use>
void in_blocks(Rows<const double> from, Rows<double> to, std::size_t count, const Use& use) {
  std::array<double, block> numbers;
  for (std::size_t first = 0; first < count; first += block) {
    const std::span some(numbers.data(), std::min(block, count - first));
    for (std::size_t i = 0; i < some.size(); ++i) some[i] = *from[first + i];
    use(some);
    for (std::size_t i = 0; i < some.size(); ++i) *to[first + i] = some[i];
  }
}

}  // namespace

double Distribution::quantile(double u) const {
  double value = 0;
  quantiles({&u, 1}, {&value, 1}, 1);
  return value;
}

void Distribution::quantiles(Rows<const double> u, Rows<double> values, std::size_t count) const {
  in_blocks(u, values, count, [this](std::span<double> numbers) { take_quantiles(numbers); });
}

void Distribution::quantiles_of_normals(Rows<const double> z, Rows<double> values,
                                        std::size_t count) const {
  in_blocks(z, values, count, [this](std::span<double> numbers) {
    if (is_normal() && !is_truncated()) return take_values(numbers);
    if (!is_normal()) {
      for (double& number : numbers) number = part_below(number);
      return take_quantiles(numbers);
    }
    take_truncated(numbers, part_below, part_above);
  });
}

double Distribution::part_beyond(double x, bool above) const {
  const double z = kind_ == DistributionKind::log_normal ? std::log(x / first_) / second_
                                                         : (x - first_) / second_;
  const double part = above ? part_above(z) - above_to_ : part_below(z) - below_from_;
  return std::clamp(part / between_, 0.0, 1.0);
}

double Distribution::least() const { return quantile(least_unit_number); }
double Distribution::greatest() const { return quantile(1 - least_unit_number); }

std::string Distribution::text() const {
  std::string text(name(kind_));
  if (!is_normal()) return text + " from " + shortest(from_) + " to " + shortest(to_);
  const bool has_mean = kind_ == DistributionKind::normal;
  text += (has_mean ? ", mean " : ", median ") + shortest(first_);
  text += (has_mean ? ", sd " : ", log_sd ") + shortest(second_);
  const bool has_from = from_ > (has_mean ? -infinity : 0);
  const bool has_to = to_ < infinity;
  if (has_from || has_to) text += ",";
  if (has_from) text += " from " + shortest(from_);
  if (has_to) text += " to " + shortest(to_);
  return text;
}

}  // namespace tribo::sweep
