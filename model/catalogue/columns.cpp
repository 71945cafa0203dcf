// SPDX-License-Identifier: Apache-2.0
#include "catalogue/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tribo::catalogue {
namespace {

constexpr std::size_t block = 512;  // points whose columns stay in the fastest cache

template <class Test>
void refuse_unless(Test is_legal, const double* column, std::size_t count, int* status) {
  for (std::size_t i = 0; i < count; ++i)
    status[i] |= std::abs(column[i]) <= std::numeric_limits<double>::max() && is_legal(column[i])
                     ? point_done
                     : point_refused;
}

template <Range range>
void refuse(const double* column, std::size_t count, int* status) {
  refuse_unless([](double number) { return is_in_range(number, range); }, column, count, status);
}

// A loop for each range, so that each of them is made vector code.
void refuse(const Parameter& parameter, const double* column, std::size_t count, int* status) {
  if (!parameter.words.empty()) {
    const auto words = static_cast<double>(parameter.words.size());
    const auto is_place = [words](double number) {
      return number >= 0 && number < words && number == std::trunc(number);
    };
    return refuse_unless(is_place, column, count, status);
  }
  switch (parameter.range) {
    case Range::above_zero:
      return refuse<Range::above_zero>(column, count, status);
    case Range::not_below_zero:
      return refuse<Range::not_below_zero>(column, count, status);
    case Range::not_zero:
      return refuse<Range::not_zero>(column, count, status);
    case Range::half_order:
      return refuse<Range::half_order>(column, count, status);
    case Range::poisson_ratio:
      return refuse<Range::poisson_ratio>(column, count, status);
    case Range::any:
      return refuse<Range::any>(column, count, status);
  }
}

using ArgumentColumns = std::array<const double*, most_parameters>;
using ResultColumns = std::array<double*, most_results>;

void value_at(const Function& function, std::size_t i, const ArgumentColumns& x,
              const ResultColumns& y, int& status) {
  Arguments arguments{};
  Results results;
  results.fill(std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < function.parameters.size(); ++k)
    arguments[k] = x[k][i] + 0.0;  // −0 becomes 0
  if (status == point_done && function.refusal != nullptr && function.refusal(arguments))
    status = point_refused;
  if (status == point_done) function.value(arguments, results);
  for (std::size_t k = 0; k < function.results.size(); ++k) y[k][i] = results[k];
}

}  // namespace

std::optional<ArgumentFault> fault_in(const Function& function, const Arguments& arguments) {
  for (std::size_t k = 0; k < function.parameters.size(); ++k) {
    const Parameter& parameter = function.parameters[k];
    int status = point_done;
    refuse(parameter, &arguments[k], 1, &status);
    if (status == point_refused)
      return ArgumentFault{parameter.name, fmt::format("{} is not allowed; allowed: {}",
                                                       arguments[k], allowed_with_unit(parameter))};
  }
  if (function.refusal == nullptr) return std::nullopt;
  const std::optional<Refusal> refusal = function.refusal(arguments);
  if (!refusal) return std::nullopt;
  return ArgumentFault{refusal->parameter, std::string(refusal->reason)};
}

void values_at(const Function& function, std::size_t count, const double* const* argument,
               double* const* result, int* status) {
  const std::size_t parameters = function.parameters.size(), results = function.results.size();
  ArgumentColumns x{};
  ResultColumns y{};
  for (std::size_t first = 0; first < count; first += block) {
    const std::size_t length = std::min(block, count - first);
    int* const of_block = status + first;
    for (std::size_t k = 0; k < parameters; ++k) x[k] = argument[k] + first;
    for (std::size_t k = 0; k < results; ++k) y[k] = result[k] + first;
    std::fill_n(of_block, length, point_done);
    for (std::size_t k = 0; k < parameters; ++k)
      refuse(function.parameters[k], x[k], length, of_block);
    const bool is_legal =
        std::find(of_block, of_block + length, point_refused) == of_block + length;
    if (is_legal && function.values != nullptr)
      function.values(length, x.data(), y.data());
    else
      for (std::size_t i = 0; i < length; ++i) value_at(function, i, x, y, of_block[i]);
    for (std::size_t k = 0; k < results; ++k)
      for (std::size_t i = 0; i < length; ++i)
        if (of_block[i] == point_done && !std::isfinite(y[k][i]))
          y[k][i] = std::numeric_limits<double>::infinity();
  }
}

}  // namespace tribo::catalogue
