// SPDX-License-Identifier: Apache-2.0
// The work that no sweep can avoid, written for film and onset alone: it prepares scenes, solves
// points and finds onsets. The inputs are made beforehand, and no results are written to files.
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
  // Solves for the film at the scene's one speed or at a drawn speed. Where the sweep asks for an
  // onset, it solves for the speed, film and film parameter of the onset at the film maximum.
  explicit Alone(const sweep::SceneSweep& sweep);

  // `inputs` has the numbers of one case after the other, as CaseGenerator makes them.
  void solve(std::span<const double> inputs, std::span<double> results);

  // --- The steps of solve(), which are timed one by one.
  void prepare(std::span<const double> inputs);  // a contact for each of at most block_cases cases
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
