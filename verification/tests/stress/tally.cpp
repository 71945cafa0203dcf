// SPDX-License-Identifier: Apache-2.0
#include "stress/tally.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tribo::verification {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// |got − expected| in units in the last place of the double nearest to `expected`.
double error_in_ulp(double got, long double expected) {
  const auto nearest = static_cast<double>(expected);
  if (static_cast<long double>(got) == expected) return 0;
  if (!std::isfinite(got) || !std::isfinite(nearest)) return got == nearest ? 0 : infinity;
  const double unit = nearest == 0 ? std::numeric_limits<double>::denorm_min()
                                   : std::max(std::numeric_limits<double>::denorm_min(),
                                              std::ldexp(1.0, std::ilogb(nearest) - 52));
  return static_cast<double>(std::abs(static_cast<long double>(got) - expected) /
                             static_cast<long double>(unit));
}

}  // namespace

Tally::Tally(std::size_t suspects) : suspects_(suspects), rows_(stress_rows) {}

void Tally::keep(RowTally& row, const Suspect& suspect) const {
  if (suspects_ == 0) return;
  if (row.suspects.size() == suspects_) {
    if (!(suspect < row.suspects.front())) return;
    std::pop_heap(row.suspects.begin(), row.suspects.end());
    row.suspects.pop_back();
  }
  row.suspects.push_back(suspect);
  std::push_heap(row.suspects.begin(), row.suspects.end());
}

// A condition number is at least 1, and a bound at least contract.ulp. So error/condition is a new
// worst only if the error alone exceeds the old worst, and error/bound only if error/contract.ulp
// does. Few condition numbers are computed, and the worst stays exact.
void Tally::add(std::uint64_t index, const Evaluation& evaluation) {
  for (std::size_t i = 0; i < evaluation.numbers.size(); ++i) {
    const Measured& number = evaluation.numbers[i];
    const Contract& contract = verification::rows()[number.row].contract;
    RowTally& row = rows_[number.row];
    ++row.cases;
    if (std::isnan(number.got) || std::isnan(number.expected)) {
      ++row.not_a_number;
      row.broken.index = std::min(row.broken.index, index);
      continue;
    }
    if (contract.ulp_per_condition > 0 && is_at_the_ends(number.got, number.expected)) continue;
    const double error = error_in_ulp(number.got, number.expected);
    row.ulp.add(error, index);
    const double suspected = error / contract.ulp;
    const bool may_be_suspect = suspects_ > 0 && (row.suspects.size() < suspects_ ||
                                                  suspected > row.suspects.front().part_of_bound);
    if (!(error > row.ulp_per_condition.value) && !(suspected > row.part_of_bound.value) &&
        !may_be_suspect && !(suspected > 1))
      continue;
    const double condition = error == 0 ? 1 : evaluation.condition(i);
    const double part = error / allowed_ulp(contract, condition);
    row.ulp_per_condition.add(error / condition, index);
    row.part_of_bound.add(part, index);
    if (!(part <= 1)) {
      ++row.beyond_contract;
      row.broken.index = std::min(row.broken.index, index);
    }
    keep(row, {part, index, i});
  }
  if (evaluation.state_row == 0) return;
  RowTally& states = rows_[evaluation.state_row];
  if (verification::rows()[evaluation.state_row].contract.ulp == 0) ++states.cases;
  if (!evaluation.states_differ) return;
  ++states.beyond_contract;
  states.broken.index = std::min(states.broken.index, index);
}

void Tally::merge(const Tally& other) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    RowTally& row = rows_[i];
    const RowTally& its = other.rows_[i];
    row.cases += its.cases;
    row.beyond_contract += its.beyond_contract;
    row.not_a_number += its.not_a_number;
    row.broken.index = std::min(row.broken.index, its.broken.index);
    row.ulp.add(its.ulp);
    row.ulp_per_condition.add(its.ulp_per_condition);
    row.part_of_bound.add(its.part_of_bound);
    for (const Suspect& suspect : its.suspects) keep(row, suspect);
  }
}

std::vector<ProofTally> prove(const Tally& tally, std::uint64_t seed, std::size_t part,
                              std::size_t parts) {
  std::vector<ProofTally> proofs(stress_rows);
  std::size_t position = 0;
  for (std::size_t r = 0; r < proofs.size(); ++r) {
    const Contract& contract = rows()[r].contract;
    ProofTally& proof = proofs[r];
    for (const Suspect& suspect : tally.rows()[r].suspects) {
      if (position++ % parts != part) continue;
      const Point point = point_at(seed, suspect.index);
      const Evaluation evaluation = evaluate(point);
      std::vector<Enclosure> truths;
      try {
        truths = enclose(point).numbers;
      } catch (const std::runtime_error&) {
      }
      ++proof.cases;
      if (truths.empty() || !is_narrow(truths[suspect.number], 1e-25)) {
        ++proof.undecided;
        continue;
      }
      const Enclosure& truth = truths[suspect.number];
      const Measured& number = evaluation.numbers[suspect.number];
      const double condition = evaluation.condition(suspect.number);
      const double error = verification::error_in_ulp(number.got, truth);
      proof.ulp.add(error, suspect.index);
      proof.ulp_per_condition.add(error / condition, suspect.index);
      if (!(error <= allowed_ulp(contract, condition))) ++proof.beyond_contract;
      proof.long_double_ulp_per_condition.add(
          verification::error_in_ulp(number.expected, truth) / condition, suspect.index);
    }
  }
  return proofs;
}

void merge(std::vector<ProofTally>& into, const std::vector<ProofTally>& from) {
  for (std::size_t i = 0; i < into.size(); ++i) {
    ProofTally& proof = into[i];
    proof.cases += from[i].cases;
    proof.undecided += from[i].undecided;
    proof.beyond_contract += from[i].beyond_contract;
    proof.ulp.add(from[i].ulp);
    proof.ulp_per_condition.add(from[i].ulp_per_condition);
    proof.long_double_ulp_per_condition.add(from[i].long_double_ulp_per_condition);
  }
}

}  // namespace tribo::verification
