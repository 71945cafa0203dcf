// SPDX-License-Identifier: Apache-2.0
#include "alone.hpp"

#include <algorithm>

#include "tribo/batch.hpp"
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
      inlet_(inlet_onsets(contact_.closure(), contact_.damiens_exponent(), default_departure,
                          OnsetCriterion::film_maximum)) {
  film_.insert(Output::film);
  contacts_.reserve(block_cases);
  for (auto* const numbers : {&speeds_, &stiffness_, &offset_, &flooded_, &lambda_})
    numbers->resize(block_cases);
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
    find_flooded_films();
    find_roots();
    complete(to);
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
    contacts_.emplace_back(scene_);
    speeds_[i] = scene_.speeds[0];
  }
}

void Alone::find_flooded_films() {
  for (std::size_t i = 0; i < contacts_.size(); ++i)
    flooded_[i] = contacts_[i].flooded_film_parameter(speeds_[i]);
}

void Alone::find_roots() {
  const std::size_t count = contacts_.size();
  for (std::size_t i = 0; i < count; ++i) {
    stiffness_[i] = contacts_[i].asperities().stiffness;
    offset_[i] = contacts_[i].asperities().offset;
  }
  film_parameter(contacts_.front().asperities().model, std::span(stiffness_).first(count),
                 std::span(offset_).first(count), std::span(flooded_).first(count),
                 std::span(lambda_).first(count));
}

void Alone::complete(std::span<double> results) {
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const MixedContact<double>& contact = contacts_[i];
    const FloodedFilm<double> film =
        contact.flooded(speeds_[i], flooded_[i], {lambda_[i], 0}, film_);
    results[i] = contact.complete(film, contact.inlet(film), film_).film;
  }
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
