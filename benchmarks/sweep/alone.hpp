// SPDX-License-Identifier: Apache-2.0
// The work that no sweep can avoid, written for these outputs alone: scenes are prepared, points
// solved and onsets found. The inputs are made beforehand, and the results are not stored.
#pragma once

#include <span>
#include <vector>

#include "sweep/plan.hpp"
#include "tribo/mixed_contacts.hpp"
#include "tribo/onset.hpp"
#include "tribo/operating_points.hpp"

namespace tribo::benchmarks {

class Alone {
 public:
  // The film at the scene's one speed or a drawn one, or the onset at the film maximum.
  explicit Alone(const sweep::SceneSweep& sweep);

  // inputs: case by case, as CaseGenerator makes them.
  void solve(std::span<const double> inputs, std::span<double> results);

  // --- Its steps, to be timed one by one.
  void prepare(std::span<const double> inputs);  // a contact for each case, at most block_cases
  void solve_points(std::span<double> results);
  void find_onsets(std::span<double> results);

  static constexpr std::size_t block_cases = 256;

 private:
  void solve_speeds(std::span<const double> inputs, std::span<double> results);

  const sweep::SceneSweep& sweep_;
  Scene scene_;
  OutputSet film_;
  bool has_one_contact_;
  MixedContact<double> contact_;
  InletOnsets<double> inlet_;
  OperatingPoints points_;
  MixedContacts contacts_;
  std::vector<std::uint64_t> contact_of_;
  std::vector<double> speeds_;
};

}  // namespace tribo::benchmarks
