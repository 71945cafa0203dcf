// SPDX-License-Identifier: Apache-2.0
#include "sweep/sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tribo::sweep {
namespace {

constexpr double standard_errors = 1.96;

struct Values {
  std::vector<double> first_order, total;
};

// The indices; NaN where nothing varies, or where too few groups are left (not `is_good`).
Values values_of(const SensitivitySums& sums, bool is_good) {
  Values values{sums.first_order, sums.total};
  const double groups = static_cast<double>(sums.both.count) / 2;
  const double variance = sums.both.sd() * sums.both.sd();
  // A result that varies by no more than its rounding is a constant.
  constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
  const bool varies = sums.both.sd() > rounding * std::abs(sums.both.mean);
  const double unit =
      varies && is_good ? groups * variance : std::numeric_limits<double>::quiet_NaN();
  for (double& value : values.first_order) value /= unit;
  for (double& value : values.total) value /= 2 * unit;
  return values;
}

SensitivitySums merged_without(const SensitivityBlocks& blocks, std::size_t left_out) {
  SensitivitySums sums;
  for (std::size_t b = 0; b < blocks.size(); ++b)
    if (b != left_out) sums.merge(blocks[b]);
  return sums;
}

// replicates: for each block that is not empty, the index without that block.
Bounded with_interval(double value, const std::vector<double>& replicates) {
  const auto n = static_cast<double>(replicates.size());
  double mean = 0;
  for (const double replicate : replicates) mean += replicate / n;
  double squares = 0;
  for (const double replicate : replicates) squares += (replicate - mean) * (replicate - mean);
  const double reach = replicates.size() > 1 ? standard_errors * std::sqrt(squares * (n - 1) / n)
                                             : std::numeric_limits<double>::quiet_NaN();
  return {value, value - reach, value + reach};
}

}  // namespace

std::size_t block_of(std::uint64_t group, std::uint64_t groups) {
  // Each block has about groups/32 groups; group · 32 is not computed, as it may overflow.
  const std::uint64_t whole = groups / jackknife_blocks;
  const std::uint64_t rest = groups % jackknife_blocks;
  // The first `rest` blocks have whole + 1 groups.
  const std::uint64_t in_longer = rest * (whole + 1);
  return static_cast<std::size_t>(group < in_longer ? group / (whole + 1)
                                                    : rest + (group - in_longer) / whole);
}

void SensitivitySums::add(std::span<const double> values, double nominal) {
  const std::size_t variables = values.size() - 2;
  first_order.resize(variables);
  total.resize(variables);
  if (!std::all_of(values.begin(), values.end(),
                   [](double value) { return std::isfinite(value); })) {
    ++left_out;
    return;
  }
  const double of_a = values[0], of_b = values[1];
  both.add(values.first(2));
  const double constant = std::isfinite(nominal) ? nominal : 0;
  for (std::size_t i = 0; i < variables; ++i) {
    const double change = values[2 + i] - of_a;
    first_order[i] += (of_b - constant) * change;
    total[i] += change * change;
  }
}

void SensitivitySums::merge(const SensitivitySums& other) {
  first_order.resize(std::max(first_order.size(), other.first_order.size()));
  total.resize(first_order.size());
  both.merge(other.both);
  left_out += other.left_out;
  for (std::size_t i = 0; i < other.first_order.size(); ++i) {
    first_order[i] += other.first_order[i];
    total[i] += other.total[i];
  }
}

void SensitivitySums::write(Bytes& to) const {
  Sender{to}(both, left_out, static_cast<std::uint32_t>(first_order.size()));
  for (const double sum : first_order) put(to, sum);
  for (const double sum : total) put(to, sum);
}

SensitivitySums SensitivitySums::read(Receiver& from) {
  SensitivitySums sums;
  from(sums.both, sums.left_out);
  const auto variables = from.take<std::uint32_t>();
  // Sums are read one by one: if `variables` is false, the bytes run out before the memory does.
  for (std::uint32_t i = 0; i < variables; ++i) sums.first_order.push_back(from.take<double>());
  for (std::uint32_t i = 0; i < variables; ++i) sums.total.push_back(from.take<double>());
  return sums;
}

SobolIndices sobol_indices(const SensitivityBlocks& blocks) {
  const SensitivitySums all = merged_without(blocks, blocks.size());
  SobolIndices indices;
  indices.groups = all.both.count / 2;
  const bool is_good = has_enough_groups(indices.groups, indices.groups + all.left_out);
  const Values values = values_of(all, is_good);
  std::vector<Values> replicates;
  for (std::size_t b = 0; b < blocks.size(); ++b)
    if (blocks[b].both.count > 0)
      replicates.push_back(values_of(merged_without(blocks, b), is_good));

  const auto index = [&](std::vector<double> Values::*kind, std::size_t i) {
    std::vector<double> of_each;
    of_each.reserve(replicates.size());
    for (const Values& replicate : replicates)
      of_each.push_back(i < (replicate.*kind).size() ? (replicate.*kind)[i]
                                                     : std::numeric_limits<double>::quiet_NaN());
    return with_interval((values.*kind)[i], of_each);
  };
  for (std::size_t i = 0; i < values.total.size(); ++i) {
    indices.first_order.push_back(index(&Values::first_order, i));
    indices.total.push_back(index(&Values::total, i));
  }
  return indices;
}

}  // namespace tribo::sweep
