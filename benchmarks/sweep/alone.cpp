// SPDX-License-Identifier: Apache-2.0
#include "alone.hpp"

#include <algorithm>
#include <numeric>

#include "tribo/onset.hpp"

namespace tribo::benchmarks {
namespace {

bool is_speed(const sweep::Variable& variable) { return variable.path == "speed"; }

}  // namespace

Alone::Alone(const sweep::SceneSweep& sweep)
    : sweep_(sweep),
      scene_(sweep.scene),
      has_one_contact_(std::all_of(sweep.variables.begin(), sweep.variables.end(), is_speed)),
      contact_(sweep.scene),
      inlet_(inlet_onsets(contact_.inlet_law(), default_departure, OnsetCriterion::film_maximum)) {
  film_.insert(Output::film);
  speeds_.resize(block_cases);
  contact_of_.resize(block_cases);
  std::iota(contact_of_.begin(), contact_of_.end(), std::uint64_t{0});
}

void Alone::solve(std::span<const double> inputs, std::span<double> results) {
  if (has_one_contact_) return solve_speeds(inputs, results);
  const std::size_t fields = sweep_.variables.size(), width = sweep_.width();
  const std::size_t cases = inputs.size() / fields;
  for (std::size_t first = 0; first < cases; first += block_cases) {
    const std::size_t some = std::min(block_cases, cases - first);
    const auto to = results.subspan(first * width, some * width);
    prepare(inputs.subspan(first * fields, some * fields));
    if (!sweep_.criteria.empty()) {
      find_onsets(to);
      continue;
    }
    solve_points(to);
  }
}

void Alone::solve_speeds(std::span<const double> inputs, std::span<double> results) {
  points_.resize(inputs.size(), film_);
  tribo::solve(contact_, inputs, film_, points_);
  std::copy(points_.film.begin(), points_.film.end(), results.begin());
}

void Alone::prepare(std::span<const double> inputs) {
  const std::size_t fields = sweep_.variables.size();
  contacts_.clear();
  for (std::size_t i = 0; i < inputs.size() / fields; ++i) {
    for (std::size_t v = 0; v < fields; ++v)
      sweep_.variables[v].store(scene_, inputs[i * fields + v]);
    contacts_.add(scene_);
    speeds_[i] = scene_.speeds[0];
  }
  contacts_.prepare();
}

void Alone::solve_points(std::span<double> results) {
  const std::size_t count = contacts_.size();
  points_.resize(count, film_);
  contacts_.solve(std::span(contact_of_).first(count), std::span(speeds_).first(count), film_,
                  points_);
  std::copy(points_.film.begin(), points_.film.end(), results.begin());
}

void Alone::find_onsets(std::span<double> results) {
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const Onset<double> found = onset(contacts_[i], scene_, OnsetCriterion::film_maximum, inlet_);
    results[3 * i] = found.speed;
    results[3 * i + 1] = found.film;
    results[3 * i + 2] = found.film_parameter;
  }
}

}  // namespace tribo::benchmarks
