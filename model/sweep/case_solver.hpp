// SPDX-License-Identifier: Apache-2.0
// All columns of some cases of a scene, in one pass.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "sweep/plan.hpp"
#include "tribo/mixed_contacts.hpp"
#include "tribo/onset.hpp"
#include "tribo/operating_points.hpp"

namespace tribo::sweep {

// Two threads must not use one solver at once: each thread has its own.
class CaseSolver {
 public:
  // stopped() is asked for each case, or for each 256 where the speed alone varies (only_contact_).
  // Once it gives true, solve() throws Stopped.
  explicit CaseSolver(const SceneSweep& sweep, std::function<bool()> stopped = {});

  // variables: the values of each case's variables. results: the values of each case's columns, NaN
  // where undefined. A case's bits depend on nothing but its variables.
  void solve(std::span<const double> variables, std::span<double> results);

 private:
  std::size_t film_width() const { return solved_columns.size() * scene_.speeds.size(); }
  bool is_contact_of(std::span<const double> values) const;
  void find_places();
  void add(std::span<const double> values);  // adds a case to those in hand
  // The results of the only contact, at the speeds of the cases.
  void solve_speeds(std::span<const double> speeds, std::span<double> results);
  // contact_at(i): the contact of point i.
  template <class ContactAt>
  void put_points(std::span<double> results, std::size_t cases, const ContactAt& contact_at) const;
  void solve_few_speeds(std::span<const double> variables, std::span<double> results);
  void prepare_inlet(const InletLaw<double>& law);
  // The solved films of a case at its speeds.
  void solve_films(std::span<const double> values, std::span<double> results);
  void find_onsets(std::span<const double> values, const MixedContact<double>& contact,
                   std::span<double> results);

  bool is_stopped() const { return stopped_ && stopped_(); }

  const SceneSweep& sweep_;
  std::function<bool()> stopped_;
  Scene scene_;
  // The words and numbers of the scene that a contact needs. places_[v] is the number that variable
  // v sets; it is not used for the speed. places_ is empty where a variable is not just one of
  // these numbers (a closure, say); then all variables go through the scene.
  detail::ContactWords words_;
  detail::SceneNumbers<double> numbers_;
  std::vector<double detail::SceneNumbers<double>::*> places_;
  std::size_t speed_variable_ = 0;  // number of the variable `speed`; past the last: none
  // The contact of all cases, where the speed alone varies and no onset is asked for.
  std::optional<MixedContact<double>> only_contact_;
  MixedContacts contacts_;                         // of the cases in hand
  std::vector<std::uint64_t> contact_of_;          // for each of these cases: its contact's place
  std::span<const double> prepared_;               // the last contact's variables
  std::vector<InletOnsets<double>> inlet_onsets_;  // by each criterion, for inlet_law_
  std::optional<InletLaw<double>> inlet_law_;
  std::vector<double> speeds_;
  std::vector<Output> asked_;
  bool has_rq_alone_ = false;    // Rq alone is known, and outputs of summits are asked for
  OutputSet solved_;             // the outputs that points need for these
  std::size_t point_width_ = 0;  // a case's values of operating points; then those of onsets
  OperatingPoints points_;
  std::vector<std::uint64_t> contact_of_point_;
  std::vector<double> point_speeds_;
};

}  // namespace tribo::sweep
