// SPDX-License-Identifier: Apache-2.0
#include "sweep/case_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "src/operating_points_arrays.hpp"
#include "tribo/batch.hpp"
#include "tribo/onset.hpp"

namespace tribo::sweep {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

// From so many speeds on, a case's own roots fill a batch; below, those of many cases share one.
constexpr std::size_t speeds_of_a_curve = 16;
constexpr std::size_t cases_in_hand = 256;

double value_of(const OperatingPoint<double>& point, Output output) {
  switch (output) {
    case Output::friction:
      return point.friction_undefined ? undefined : point.friction;
    case Output::regime:
      return static_cast<double>(point.regime);
    case Output::inlet:
      return static_cast<double>(point.inlet);
    default:
      return numbers_of(point)[static_cast<std::size_t>(output)];
  }
}

}  // namespace

CaseSolver::CaseSolver(const SceneSweep& sweep) : sweep_(sweep), scene_(sweep.scene) {
  contacts_.reserve(cases_in_hand);
  contact_of_.reserve(cases_in_hand);
  while (speed_variable_ < sweep.variables.size() &&
         sweep.variables[speed_variable_].path != "speed")
    ++speed_variable_;
  if (sweep.outputs.empty()) return;
  for (std::size_t i = 0; i < scene_.speeds.size(); ++i) speeds_.push_back(scene_.speeds[i]);
  for (const OutputInfo& info : output_infos)
    if (sweep.outputs.contains(info.output)) asked_.push_back(info.output);
  point_width_ = asked_.size() * speeds_.size();
  if (sweep.variables.size() == 1 && speed_variable_ == 0 && sweep.criteria.empty())
    only_contact_.emplace(scene_);
}

void CaseSolver::solve(std::span<const double> variables, std::span<double> results) {
  const std::size_t width = sweep_.width(), count = sweep_.variables.size();
  const std::size_t cases = results.size() / width;
  for (std::size_t first = 0; first < cases; first += cases_in_hand) {
    const std::size_t some = std::min(cases_in_hand, cases - first);
    const auto values = variables.subspan(first * count, some * count);
    const auto to = results.subspan(first * width, some * width);
    if (only_contact_) {
      solve_speeds(values, to);
      continue;
    }
    contacts_.clear();
    contact_of_.clear();
    const bool curves = speeds_.size() >= speeds_of_a_curve;
    for (std::size_t i = 0; i < some; ++i) {
      prepare(values.subspan(i * count, count));
      if (curves) solve_curve(to.subspan(i * width, point_width_));
      if (!sweep_.criteria.empty())
        find_onsets(to.subspan(i * width + point_width_, width - point_width_));
    }
    if (!curves && point_width_ > 0) solve_few_speeds(values, to);
  }
}

// Cases that differ in their speed alone share what is prepared.
bool CaseSolver::is_contact_of(std::span<const double> values) const {
  for (std::size_t v = 0; v < values.size(); ++v)
    if (v != speed_variable_ && values[v] != prepared_[v]) return false;
  return true;
}

void CaseSolver::prepare(std::span<const double> values) {
  if (contacts_.empty() || !is_contact_of(values)) {
    prepared_ = values;
    for (std::size_t v = 0; v < values.size(); ++v) sweep_.variables[v].store(scene_, values[v]);
    contacts_.emplace_back(scene_);
  }
  contact_of_.push_back(contacts_.size() - 1);
}

void CaseSolver::solve_curve(std::span<double> results) {
  points_.resize(speeds_.size(), sweep_.outputs);
  tribo::solve(contacts_.back(), speeds_, sweep_.outputs, points_);
  put_points(results, 1, speeds_.size());
}

void CaseSolver::solve_speeds(std::span<const double> speeds, std::span<double> results) {
  points_.resize(speeds.size(), sweep_.outputs);
  tribo::solve(*only_contact_, speeds, sweep_.outputs, points_);
  put_points(results, asked_.size(), 1);
}

// Output o of point i goes to results[i·point_stride + o·output_stride].
void CaseSolver::put_points(std::span<double> results, std::size_t point_stride,
                            std::size_t output_stride) const {
  const std::size_t count = points_.size();
  double* to = results.data();
  for_each_number(points_, [&](Output output, const std::vector<double>& numbers) {
    if (numbers.empty()) return;
    const bool may_lack = output == Output::friction;
    for (std::size_t i = 0; i < count; ++i)
      to[i * point_stride] =
          may_lack && points_.friction_undefined[i] != 0 ? undefined : numbers[i];
    to += output_stride;
  });
  const auto put_words = [&](const auto& words) {
    if (words.empty()) return;
    for (std::size_t i = 0; i < count; ++i) to[i * point_stride] = static_cast<double>(words[i]);
    to += output_stride;
  };
  put_words(points_.regime);
  put_words(points_.inlet);
}

void CaseSolver::solve_few_speeds(std::span<const double> variables, std::span<double> results) {
  const std::size_t cases = contact_of_.size(), speeds = speeds_.size(), width = sweep_.width();
  const std::size_t count = cases * speeds, variable_count = sweep_.variables.size();
  const bool is_speed_varied = speed_variable_ < variable_count;
  const bool needs_inlet = MixedContact<double>::needs_inlet(sweep_.outputs);
  stiffness_.resize(count), offset_.resize(count), flooded_.resize(count), lambda_.resize(count);
  const auto contact_of = [&](std::size_t i) -> const MixedContact<double>& {
    return contacts_[contact_of_[i]];
  };
  const auto speed_of = [&](std::size_t i, std::size_t j) {
    return is_speed_varied ? variables[i * variable_count + speed_variable_] : speeds_[j];
  };
  for (std::size_t i = 0; i < cases; ++i) {
    const MixedContact<double>& contact = contact_of(i);
    for (std::size_t j = 0; j < speeds; ++j) {
      const std::size_t at = i * speeds + j;
      stiffness_[at] = contact.asperities().stiffness;
      offset_[at] = contact.asperities().offset;
      flooded_[at] = contact.flooded_film_parameter(speed_of(i, j));
    }
  }
  // One call for each run of cases with one asperity model, which may vary too.
  for (std::size_t first = 0; first < cases;) {
    const AsperityModel model = contact_of(first).asperities().model;
    std::size_t end = first + 1;
    while (end < cases && contact_of(end).asperities().model == model) ++end;
    const std::size_t from = first * speeds, some = (end - first) * speeds;
    film_parameter(model, std::span(stiffness_).subspan(from, some),
                   std::span(offset_).subspan(from, some), std::span(flooded_).subspan(from, some),
                   std::span(lambda_).subspan(from, some));
    first = end;
  }
  for (std::size_t i = 0; i < cases; ++i) {
    const MixedContact<double>& contact = contact_of(i);
    for (std::size_t j = 0; j < speeds; ++j) {
      const std::size_t at = i * speeds + j;
      const FloodedFilm<double> film =
          contact.flooded(speed_of(i, j), flooded_[at], {lambda_[at], 0}, sweep_.outputs);
      const InletState<double> inlet =
          needs_inlet ? contact.inlet(film) : InletState<double>{1, 0, false};
      const OperatingPoint<double> point = contact.complete(film, inlet, sweep_.outputs);
      double* to = &results[i * width + j];
      for (const Output output : asked_) {
        *to = value_of(point, output);
        to += speeds;
      }
    }
  }
}

// Of the inlet's onsets, which rest on the closure alone, there are new ones only with another
// closure.
void CaseSolver::prepare_inlet(const MixedContact<double>& contact) {
  const bool is_known = !inlet_onsets_.empty() && contact.closure() == inlet_closure_ &&
                        contact.damiens_exponent() == inlet_exponent_;
  if (is_known) return;
  inlet_closure_ = contact.closure();
  inlet_exponent_ = contact.damiens_exponent();
  inlet_onsets_.clear();
  for (const OnsetCriterion criterion : sweep_.criteria)
    inlet_onsets_.push_back(
        inlet_onsets(inlet_closure_, inlet_exponent_, sweep_.departure, criterion));
}

void CaseSolver::find_onsets(std::span<double> results) {
  const MixedContact<double>& contact = contacts_.back();
  prepare_inlet(contact);
  for (std::size_t c = 0; c < sweep_.criteria.size(); ++c) {
    const Onset<double> found = onset(contact, scene_, sweep_.criteria[c], inlet_onsets_[c]);
    results[3 * c] = found.exists ? found.speed : undefined;
    results[3 * c + 1] = found.exists ? found.film : undefined;
    results[3 * c + 2] = found.exists ? found.film_parameter : undefined;
  }
}

}  // namespace tribo::sweep
