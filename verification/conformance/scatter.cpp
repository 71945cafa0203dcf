// SPDX-License-Identifier: Apache-2.0
#include "conformance/scatter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/statistics/bivariate_statistics.hpp>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "conformance/variable.hpp"

namespace tribo::conformance {
namespace {

constexpr std::size_t fewest_scattered = 20;
constexpr double small_error = 1e-3;        // relative
constexpr double least_of_each_sign = 0.2;  // of the errors
constexpr double least_changes = 0.25;  // of the signs, from one value of a variable to the next
constexpr double strong = 0.8;          // correlation of ranks

struct Error {
  double x, relative, absolute;
};

std::vector<double> ranks_in_order(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> ranks(values.size());
  for (std::size_t i = 0; i < order.size(); ++i) ranks[order[i]] = static_cast<double>(i);
  return ranks;
}

// Spearman's, of the sizes of the errors with the variable.
double correlation(const std::vector<Error>& errors) {
  std::vector<double> x, size;
  for (const Error& one : errors) {
    x.push_back(one.x);
    size.push_back(std::abs(one.relative));
  }
  const std::vector<double> of_x = ranks_in_order(x), of_size = ranks_in_order(size);
  return boost::math::statistics::correlation_coefficient(of_x, of_size);
}

double share_of_changes(const std::vector<Error>& errors) {
  std::size_t changes = 0;
  for (std::size_t i = 1; i < errors.size(); ++i)
    changes += (errors[i].relative < 0) != (errors[i - 1].relative < 0) ? 1 : 0;
  return static_cast<double>(changes) / static_cast<double>(errors.size());
}

// By the variable; empty where it has no value somewhere.
std::vector<Error> errors_along(const Part& part, const Variable& variable) {
  std::vector<Error> errors;
  for (const Part::Number& one : part.all) {
    if (!one.answered->is_left()) continue;
    const double x = variable.value(one.of->asked);
    if (!std::isfinite(x) || one.answered->expected->high == 0) return {};
    const double off = one.answered->error();
    errors.push_back({x, off / one.answered->expected->high, std::abs(off)});
  }
  std::stable_sort(errors.begin(), errors.end(),
                   [](const Error& a, const Error& b) { return a.x < b.x; });
  return errors;
}

bool has_both_signs(const std::vector<Error>& errors) {
  const auto below = std::count_if(errors.begin(), errors.end(),
                                   [](const Error& one) { return one.relative < 0; });
  const double share = static_cast<double>(below) / static_cast<double>(errors.size());
  return share > least_of_each_sign && share < 1 - least_of_each_sign;
}

// The middle of the sizes of the errors in a part of the list.
double middle_size(const std::vector<Error>& errors, std::size_t first, std::size_t last,
                   double Error::*of = &Error::relative) {
  std::vector<double> sizes;
  for (std::size_t i = first; i < last; ++i) sizes.push_back(std::abs(errors[i].*of));
  return boost::math::statistics::median(sizes);
}

// Whether the errors along the right answer are of one size, while the answer grows.
bool is_of_one_size(const std::vector<Error>& errors) {
  constexpr double of_answer = 30, of_size = 4;
  const std::size_t third = errors.size() / 3, last = errors.size() - third;
  const auto grown = [&](double Error::*of) {
    return middle_size(errors, last, errors.size(), of) / middle_size(errors, 0, third, of);
  };
  const double grows = grown(&Error::absolute);
  return grown(&Error::x) > of_answer && grows < of_size && grows > 1 / of_size;
}

// Text where errors of both signs have one size, whatever the answer is. Empty: they do not.
std::string fixed_width(const Part& part) {
  const Variable answer{
      {}, false, [&part](const Question& asked) { return right_numbers(asked)[part.place]; }};
  const std::vector<Error> errors = errors_along(part, answer);
  if (errors.empty() || errors.front().x <= 0 || !has_both_signs(errors) || !is_of_one_size(errors))
    return {};
  double greatest = 0;
  for (const Error& one : errors) greatest = std::max(greatest, one.absolute);
  return fmt::format(
      "The errors are of both signs and of one size, at most {:.2g}, large or small as the answers "
      "are: as of an iteration that stops at a fixed width, or of rounding to a fixed step.",
      greatest);
}

}  // namespace

std::string scatter_of(const Part& part) {
  if (part.function() == nullptr || part.wrong.size() < fewest_scattered) return {};
  if (std::string fixed = fixed_width(part); !fixed.empty()) return fixed;
  double greatest = 0, best = 0;
  std::string grows;
  for (const Variable& variable : variables_of(part.function())) {
    const std::vector<Error> errors = errors_along(part, variable);
    if (errors.empty() || errors.front().x == errors.back().x) continue;
    if (!has_both_signs(errors) || share_of_changes(errors) < least_changes) return {};
    for (const Error& one : errors) greatest = std::max(greatest, std::abs(one.relative));
    const double with = correlation(errors);
    if (std::abs(with) < std::max(strong, best)) continue;
    best = std::abs(with);
    const std::size_t third = errors.size() / 3;
    const double low = middle_size(errors, 0, third);
    const double high = middle_size(errors, errors.size() - third, errors.size());
    grows = fmt::format(
        "The errors are of both signs and in no order, and grow where {} is {}, from {:.2g} to "
        "{:.2g} of the value: as of digits that are lost, or rounded away.",
        variable.symbol, with < 0 ? "small" : "large", std::min(low, high), std::max(low, high));
  }
  if (!grows.empty() || greatest == 0 || greatest > small_error) return grows;
  return fmt::format(
      "The errors are small, at most {:.2g} of the value, of both signs and in no order: as of an "
      "iteration that stops too early, or of rounded numbers.",
      greatest);
}

}  // namespace tribo::conformance
