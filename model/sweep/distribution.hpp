// SPDX-License-Identifier: Apache-2.0
// The distribution that a varied field is drawn from, given by its quantile function, which turns
// numbers in (0, 1) into values.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace tribo::sweep {

// The bound where a distribution has none.
inline constexpr double infinity = std::numeric_limits<double>::infinity();

enum class DistributionKind : std::uint8_t { uniform, log_uniform, normal, log_normal };

inline constexpr auto distribution_names =
    std::to_array<std::string_view>({"uniform", "log_uniform", "normal", "log_normal"});
constexpr std::string_view name(DistributionKind kind) {
  return distribution_names[static_cast<std::size_t>(kind)];
}

// A column of a table: its first number, and the distance from one number to the next.
template <class T>
struct Rows {
  T* first;
  std::size_t stride;
  T* operator[](std::size_t row) const { return first + row * stride; }
};

// The bounds from < to hold for all four kinds. They truncate the two normal kinds, and may be
// infinite there. No value lies beyond the bounds.
class Distribution {
 public:
  Distribution() = default;
  static Distribution uniform(double from, double to);
  static Distribution log_uniform(double from, double to);  // 0 < from
  // normal() and log_normal() throw std::invalid_argument if both bounds are on one side and so far
  // out (37 sd) that the part of the whole normal beyond the nearer bound is less than 1e-300.
  static Distribution normal(double mean, double sd, double from, double to);
  // ln x is normal around ln median with the sd log_sd; 0 < median, 0 <= from.
  static Distribution log_normal(double median, double log_sd, double from, double to);

  // The value below which a part u in (0, 1) lies, for u as it comes from unit_number() of
  // design.hpp. Error: uniform 1.5 ulp of the greater bound, log_uniform 3 ulp, normal 4 ulp of the
  // greatest of |value|, |mean| and sd, log_normal 3 + 3|ln(value/median)| + 3·log_sd ulp.
  double quantile(double u) const;
  // The quantiles of many numbers, with the same bits and far faster.
  void quantiles(Rows<const double> u, Rows<double> values, std::size_t count) const;
  // The quantiles at u = P(Z < z) for many standard normal numbers z.
  void quantiles_of_normals(Rows<const double> z, Rows<double> values, std::size_t count) const;

  double median() const { return quantile(0.5); }
  // The extremes that can be drawn: the quantiles at the least and the greatest u.
  double least() const;
  double greatest() const;

  // The part of the draws of a normal kind that lies below x, or above it.
  double part_beyond(double x, bool above) const;

  DistributionKind kind() const { return kind_; }
  // "normal, mean 0.0202, sd 0.001, from 0.01 to 0.04"
  std::string text() const;

 private:
  Distribution(DistributionKind kind, double first, double second, double from, double to);
  void truncate(double from, double to);
  bool is_normal() const {
    return kind_ == DistributionKind::normal || kind_ == DistributionKind::log_normal;
  }
  bool is_truncated() const { return below_from_ != 0 || above_to_ != 0; }
  // In place: turns unit numbers into quantiles, and standard normals into values.
  void take_quantiles(std::span<double> numbers) const;
  void take_values(std::span<double> normals) const;
  template <class Below, class Above>
  void take_truncated(std::span<double> numbers, const Below& below, const Above& above) const;

  DistributionKind kind_ = DistributionKind::uniform;
  double first_ = 0;        // mean, median; of the uniform ones: from
  double second_ = 1;       // sd, sd of ln; of the uniform ones: to − from, ln(to/from)
  double second_rest_ = 0;  // the rounding error of ln(to/from)
  double from_ = 0;
  double to_ = 1;
  // Parts of the whole normal: P(Z < z(from)), P(Z > z(to)), and the part between.
  double below_from_ = 0;
  double above_to_ = 0;
  double between_ = 1;
};

}  // namespace tribo::sweep
