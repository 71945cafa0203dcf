// SPDX-License-Identifier: Apache-2.0
#include "sweep/case_solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "ehl/film_conditions.hpp"
#include "ehl/solved_film.hpp"
#include "scene/schema.hpp"
#include "tribo/onset.hpp"
#include "tribo/smooth_contact.hpp"

namespace tribo::sweep {
namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

// With this many speeds or more, the points of one case fill a batch; with fewer speeds, the points
// of many cases share a batch.
constexpr std::size_t speeds_of_a_curve = 16;
constexpr std::size_t cases_in_hand = 256;

}  // namespace

CaseSolver::CaseSolver(const SceneSweep& sweep, std::function<bool()> stopped)
    : sweep_(sweep),
      stopped_(std::move(stopped)),
      scene_(sweep.scene),
      words_(detail::words_of(scene_)),
      numbers_(detail::numbers_of<double>(scene_)) {
  contact_of_.reserve(cases_in_hand);
  while (speed_variable_ < sweep.variables.size() &&
         sweep.variables[speed_variable_].path != "speed")
    ++speed_variable_;
  find_places();
  if (sweep.outputs.empty()) return;
  speeds_.resize(scene_.speeds.size());
  scene_.speeds.fill(0, speeds_);
  for (const OutputInfo& info : output_infos)
    if (sweep.outputs.contains(info.output)) asked_.push_back(info.output);
  has_rq_alone_ = scene_.surface.has_rq_alone() && sweep.outputs.contains_any(summit_outputs());
  solved_ = solved_outputs(sweep.outputs, has_rq_alone_, may_lack_film(sweep));
  point_width_ = asked_.size() * speeds_.size();
  if (sweep.variables.size() == 1 && speed_variable_ == 0 && sweep.criteria.empty() &&
      !sweep.solves_film)
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
      if (is_stopped()) throw Stopped();
      solve_speeds(values, to);
      continue;
    }
    contacts_.clear();
    contact_of_.clear();
    if (point_width_ > 0 || !sweep_.criteria.empty()) {
      for (std::size_t i = 0; i < some; ++i) add(values.subspan(i * count, count));
      contacts_.prepare();
    }
    const bool curves = speeds_.size() >= speeds_of_a_curve;
    if (point_width_ > 0 && !curves) solve_few_speeds(values, to);
    for (std::size_t i = 0; i < some; ++i) {
      if (is_stopped()) throw Stopped();
      if (curves) {
        points_.resize(speeds_.size(), solved_);
        const MixedContact<double> contact = contacts_[contact_of_[i]];
        tribo::solve(contact, speeds_, solved_, points_);
        put_points(to.subspan(i * width, point_width_), 1,
                   [&](std::size_t) -> const MixedContact<double>& { return contact; });
      }
      if (!sweep_.criteria.empty())
        find_onsets(values.subspan(i * count, count), contacts_[contact_of_[i]],
                    to.subspan(i * width + point_width_, 3 * sweep_.criteria.size()));
      if (sweep_.solves_film)
        solve_films(values.subspan(i * count, count),
                    to.subspan((i + 1) * width - film_width(), film_width()));
    }
  }
}

void CaseSolver::solve_films(std::span<const double> values, std::span<double> results) {
  for (std::size_t v = 0; v < values.size(); ++v) sweep_.variables[v].store(scene_, values[v]);
  const std::size_t speeds = scene_.speeds.size();
  for (std::size_t j = 0; j < speeds; ++j) {
    const ehl::FilmConditions conditions = ehl::conditions_of(scene_, scene_.speeds[j]);
    const ehl::LineContact contact = ehl::contact_of(conditions);
    const ehl::SolvedFilm solved =
        ehl::solve_line_film(contact, {}, [this](const ehl::Step&) { return !is_stopped(); });
    if (is_stopped()) throw Stopped();
    const bool is_solved = solved.outcome == ehl::Outcome::solved;
    const double unit = is_solved ? ehl::scale_of(conditions).film : undefined;
    const SolvedOutcome outcome = !is_solved              ? SolvedOutcome::not_solved
                                  : solved.reason.empty() ? SolvedOutcome::solved
                                                          : SolvedOutcome::tolerance_missed;
    const std::array<double, solved_columns.size()> numbers{
        contact.load_number,         contact.material_number,     unit * solved.central.value,
        unit * solved.central.error, unit * solved.minimum.value, unit * solved.minimum.error,
        static_cast<double>(outcome)};
    for (std::size_t c = 0; c < numbers.size(); ++c) results[c * speeds + j] = numbers[c];
  }
}

void CaseSolver::find_places() {
  for (std::size_t v = 0; v < sweep_.variables.size(); ++v) {
    const std::size_t field = scene_detail::field_at(sweep_.variables[v].path);
    places_.push_back(scene_detail::contact_number(field, words_.shape));
    if (places_[v] == nullptr && v != speed_variable_) return places_.clear();
  }
}

// Cases that differ in their speed alone share a prepared contact.
bool CaseSolver::is_contact_of(std::span<const double> values) const {
  for (std::size_t v = 0; v < values.size(); ++v)
    if (v != speed_variable_ && values[v] != prepared_[v]) return false;
  return true;
}

void CaseSolver::add(std::span<const double> values) {
  if (contacts_.size() == 0 || !is_contact_of(values)) {
    prepared_ = values;
    if (places_.empty()) {
      for (std::size_t v = 0; v < values.size(); ++v) sweep_.variables[v].store(scene_, values[v]);
      contacts_.add(scene_);
    } else {
      detail::SceneNumbers<double>& numbers = contacts_.add(words_, numbers_);
      for (std::size_t v = 0; v < values.size(); ++v)
        if (v != speed_variable_) numbers.*places_[v] = values[v];
    }
  }
  contact_of_.push_back(contacts_.size() - 1);
}

void CaseSolver::solve_speeds(std::span<const double> speeds, std::span<double> results) {
  points_.resize(speeds.size(), solved_);
  tribo::solve(*only_contact_, speeds, solved_, points_);
  put_points(results, speeds.size(),
             [this](std::size_t) -> const MixedContact<double>& { return *only_contact_; });
}

void CaseSolver::solve_few_speeds(std::span<const double> variables, std::span<double> results) {
  const std::size_t cases = contact_of_.size(), speeds = speeds_.size();
  const std::size_t variable_count = sweep_.variables.size();
  contact_of_point_.clear();
  point_speeds_.clear();
  for (std::size_t i = 0; i < cases; ++i)
    for (std::size_t j = 0; j < speeds; ++j) {
      contact_of_point_.push_back(contact_of_[i]);
      point_speeds_.push_back(speed_variable_ < variable_count
                                  ? variables[i * variable_count + speed_variable_]
                                  : speeds_[j]);
    }
  points_.resize(point_speeds_.size(), solved_);
  contacts_.solve(contact_of_point_, point_speeds_, solved_, points_);
  put_points(results, cases,
             [this](std::size_t point) { return contacts_[contact_of_point_[point]]; });
}

// Copies the points of `cases` cases, which lie case after case, to the results: output o of point
// j of a case goes to place o·speeds + j of that case's results.
template <class ContactAt>
void CaseSolver::put_points(std::span<double> results, std::size_t cases,
                            const ContactAt& contact_at) const {
  const std::size_t speeds = points_.size() / cases, width = results.size() / cases;
  std::size_t column = 0;
  const auto put = [&](const auto& value_at) {
    for (std::size_t i = 0; i < cases; ++i)
      for (std::size_t j = 0; j < speeds; ++j)
        results[i * width + column + j] = value_at(i * speeds + j);
    column += speeds;
  };
  std::vector<bool> are_unknown(has_rq_alone_ ? points_.size() : 0);  // the summits of a point
  for (std::size_t i = 0; i < are_unknown.size(); ++i)
    are_unknown[i] =
        SmoothContact(contact_at(i)).has_unknown_summits(points_.speed[i], points_.film[i]);
  for_each_number(points_, [&](Output output, const std::vector<double>& numbers) {
    if (!sweep_.outputs.contains(output)) return;
    const bool is_of_summits = has_rq_alone_ && summit_outputs().contains(output);
    put([&](std::size_t i) { return is_of_summits && are_unknown[i] ? undefined : numbers[i]; });
  });
  // The word for a point without a film comes after the other words.
  const bool may_lack_film = sweep::may_lack_film(sweep_);
  const auto lacks_film = [&](std::size_t i) {
    return may_lack_film && std::isnan(points_.film[i]);
  };
  if (sweep_.outputs.contains(Output::regime))
    put([&](std::size_t i) {
      if (has_rq_alone_ && are_unknown[i] && points_.regime[i] != Regime::collapsed) return 0.0;
      if (lacks_film(i)) return has_rq_alone_ ? 0.0 : static_cast<double>(regime_words.size());
      return static_cast<double>(points_.regime[i]);
    });
  if (sweep_.outputs.contains(Output::inlet))
    put([&](std::size_t i) {
      return static_cast<double>(lacks_film(i) ? inlet_words.size()
                                               : static_cast<std::size_t>(points_.inlet[i]));
    });
  for (const Output output : asked_)
    if (info(output).is_of_smooth_contact)
      put([&](std::size_t i) {
        return SmoothContact(contact_at(i)).value(output, points_.speed[i], points_.film[i]);
      });
}

// Computes the inlet's onsets. They depend on its law alone, so that they are computed anew only
// when the law changes.
void CaseSolver::prepare_inlet(const InletLaw<double>& law) {
  if (law == inlet_law_) return;
  inlet_law_ = law;
  inlet_onsets_.clear();
  for (const OnsetCriterion criterion : sweep_.criteria)
    inlet_onsets_.push_back(inlet_onsets(law, sweep_.departure, criterion));
}

void CaseSolver::find_onsets(std::span<const double> values, const MixedContact<double>& contact,
                             std::span<double> results) {
  for (std::size_t v = 0; v < values.size(); ++v) sweep_.variables[v].store(scene_, values[v]);
  prepare_inlet(contact.inlet_law());
  for (std::size_t c = 0; c < sweep_.criteria.size(); ++c) {
    const Onset<double> found = onset(contact, scene_, sweep_.criteria[c], inlet_onsets_[c]);
    results[3 * c] = found.exists ? found.speed : undefined;
    results[3 * c + 1] = found.exists ? found.film : undefined;
    results[3 * c + 2] = found.exists ? found.film_parameter : undefined;
  }
}

}  // namespace tribo::sweep
