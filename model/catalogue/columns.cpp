// SPDX-License-Identifier: Apache-2.0
#include "catalogue/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace tribo::catalogue {
namespace {

constexpr std::size_t block = 1024;  // points whose columns stay in the fastest cache

constexpr double greatest_double = std::numeric_limits<double>::max();
constexpr double least_above_zero = std::numeric_limits<double>::denorm_min();

bool is_legal(const Parameter& parameter, double number) {
  if (!(std::abs(number) <= greatest_double)) return false;
  if (parameter.words.empty()) return is_in_range(number, parameter.range);
  return number >= 0 && number < static_cast<double>(parameter.words.size()) &&
         number == std::trunc(number);
}

// On x86-64 the loop is compiled for vectors of 16, 32 and 64 bytes, because the check has to be
// faster than the batch that it guards. Sanitizers run before the loader can choose one of these.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
[[gnu::target_clones("avx512f", "avx2", "default")]]
#endif
bool are_between(const double* column, std::size_t count, double least, double greatest) {
  std::int64_t beyond = 0;
  for (std::size_t i = 0; i < count; ++i)
    beyond |= ((column[i] >= least) & (column[i] <= greatest)) ? 0 : 1;  // no branch
  return beyond == 0;
}

bool are_legal(const Parameter& parameter, const Column& column, std::size_t count) {
  const double* const numbers = column.numbers;
  if (column.is_same) return is_legal(parameter, numbers[0]);
  if (parameter.words.empty()) switch (parameter.range) {
      case Range::above_zero:
        return are_between(numbers, count, least_above_zero, greatest_double);
      case Range::not_below_zero:
        return are_between(numbers, count, 0, greatest_double);
      case Range::any:
        return are_between(numbers, count, -greatest_double, greatest_double);
      case Range::not_zero:
      case Range::half_order:
      case Range::poisson_ratio:
        break;
    }
  return std::all_of(numbers, numbers + count,
                     [&](double number) { return is_legal(parameter, number); });
}

// The first parameter whose argument is not legal, or why legal arguments are not legal together.
struct Fault {
  const Parameter* parameter = nullptr;
  std::optional<Refusal> refusal = {};

  explicit operator bool() const { return parameter != nullptr || refusal; }
};
Fault fault_of(const Function& function, const Arguments& arguments) {
  for (std::size_t k = 0; k < function.parameters.size(); ++k)
    if (!is_legal(function.parameters[k], arguments[k]))
      return {.parameter = &function.parameters[k]};
  if (function.refusal == nullptr) return {};
  return {.parameter = nullptr, .refusal = function.refusal(arguments)};
}

using ArgumentColumns = std::array<Column, most_parameters>;
using ResultColumns = std::array<double*, most_results>;

// Computes one point. Returns false if it is refused; its results are then NaN.
bool value_at(const Function& function, std::size_t i, const ArgumentColumns& x,
              const ResultColumns& y) {
  Arguments arguments{};
  Results results;
  results.fill(std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < function.parameters.size(); ++k)
    arguments[k] = x[k].numbers[x[k].is_same ? 0 : i] + 0.0;  // −0 becomes 0
  const bool is_done = !fault_of(function, arguments);
  if (is_done) function.value(arguments, results);
  for (std::size_t k = 0; k < function.results.size(); ++k)
    y[k][i] = is_done && !std::isfinite(results[k]) ? std::numeric_limits<double>::infinity()
                                                    : results[k];
  return is_done;
}

}  // namespace

std::optional<ArgumentFault> fault_in(const Function& function, const Arguments& arguments) {
  const Fault fault = fault_of(function, arguments);
  if (fault.refusal)
    return ArgumentFault{fault.refusal->parameter, std::string(fault.refusal->reason)};
  if (!fault) return std::nullopt;
  const Parameter& parameter = *fault.parameter;
  const double given = arguments[static_cast<std::size_t>(&parameter - function.parameters.data())];
  return ArgumentFault{parameter.name, fmt::format("{} is not allowed; allowed: {}", given,
                                                   allowed_with_unit(parameter))};
}

std::size_t values_at(const Function& function, std::size_t count, const double* const* argument,
                      const std::size_t* step, double* const* result, int* status) {
  const std::size_t parameters = function.parameters.size(), results = function.results.size();
  ArgumentColumns x{};
  ResultColumns y{};
  std::array<std::array<double, block>, most_parameters> same;  // read by batches
  for (std::size_t k = 0; k < parameters; ++k) {
    x[k].is_same = step != nullptr && step[k] == 0;
    if (x[k].is_same && count > 0) {
      same[k].fill(argument[k][0]);
      x[k].numbers = same[k].data();
    }
  }
  std::size_t refused = 0;
  for (std::size_t first = 0; first < count; first += block) {
    const std::size_t length = std::min(block, count - first);
    for (std::size_t k = 0; k < parameters; ++k)
      if (!x[k].is_same) x[k].numbers = argument[k] + first;
    for (std::size_t k = 0; k < results; ++k) y[k] = result[k] + first;
    bool is_batch = function.values != nullptr && length > 1;
    for (std::size_t k = 0; is_batch && k < parameters; ++k)
      is_batch = are_legal(function.parameters[k], x[k], length);
    if (status != nullptr) std::fill_n(status + first, length, point_done);
    if (is_batch) {
      function.values(length, x.data(), y.data());
      continue;
    }
    for (std::size_t i = 0; i < length; ++i) {
      if (value_at(function, i, x, y)) continue;
      if (status != nullptr) status[first + i] = point_refused;
      ++refused;
    }
  }
  return refused;
}

}  // namespace tribo::catalogue
