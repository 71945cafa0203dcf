// SPDX-License-Identifier: Apache-2.0
#include "conformance/follow.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "conformance/dependence.hpp"
#include "conformance/description.hpp"
#include "conformance/misread.hpp"
#include "conformance/mistake_entry.hpp"
#include "conformance/mistake_search.hpp"
#include "conformance/variable.hpp"
#include "tribo/mixed_contact.hpp"

namespace tribo::conformance {
namespace {

// The error with which a slip is known, relative to its change: by a formula, by factors of cases.
constexpr double closeness_of_formula = 1e-4, closeness_of_curve = 2e-2;
constexpr double nearly_all = 0.97;  // of the wrong answers of a function

Question asked_of(std::string_view function, catalogue::Arguments arguments) {
  return {nullptr, catalogue::function_named(function), arguments};
}

double half_order_of(Order order) { return static_cast<int>(order) / 2.0; }

void add_moments(std::vector<Question>& inner, AsperityModel model, double argument) {
  for (const Order order : {load_order(model), area_order(model), count_order(model)})
    inner.push_back(asked_of("gaussian_moment", {half_order_of(order), argument}));
}

// A wrong result in one branch, and the subject's answer.
struct WrongResult {
  std::size_t place;
  std::string branch;
  std::function<double(const Question&, double right)> answer;
};

}  // namespace

Question contact_question(const Scene& scene) {
  const auto numbers = detail::numbers_of<double>(scene);
  const double load = numbers.load, modulus = numbers.effective_modulus;
  const ContactShape shape = scene.bodies.shape();
  if (shape == ContactShape::line)
    return asked_of("hertz_line", {load / numbers.across, modulus, numbers.radius_x});
  if (shape == ContactShape::ellipse)
    return asked_of("hertz_ellipse", {load, modulus, numbers.radius_x, numbers.across});
  return asked_of("hertz_point", {load, modulus, numbers.radius_x});
}

std::vector<Question> inner_questions(const Question& question) {
  std::vector<Question> inner;
  if (question.function != nullptr && question.function->name == "load_sharing") {
    const auto model = static_cast<AsperityModel>(question.arguments[0]);
    inner.push_back(asked_of(
        "gaussian_moment",
        {half_order_of(load_order(model)), right_numbers(question)[0] - question.arguments[3]}));
  }
  if (question.function != nullptr || !question.scene) return inner;
  const Scene& scene = *question.scene;
  const MixedContact<double> contact(scene);
  const AsperityModel model = scene.closures.asperity;
  const double offset = contact.sharing().offset(), speed = scene.speeds[0];
  const FloodedFilm<double> flooded = contact.flooded(speed);
  const InletState<double> inlet = contact.inlet(flooded);
  inner.push_back(contact_question(scene));
  inner.push_back(film_question(scene));
  inner.push_back(
      asked_of("load_sharing", {static_cast<double>(model), contact.flooded_film_parameter(speed),
                                contact.sharing().stiffness(), offset}));
  add_moments(inner, model, flooded.shares.film_parameter - offset);
  if (scene.supply.kind == SupplyKind::flooded) return inner;
  const double starved = flooded.shares.film_parameter * inlet.film_ratio;
  add_moments(inner, model, std::max(starved, contact.sharing().floor()) - offset);
  inner.push_back(
      asked_of("starvation_ratio", {static_cast<double>(contact.inlet_law().closure),
                                    inlet.flooded_over_inlet, contact.inlet_law().exponent}));
  return inner;
}

WrongFunction::WrongFunction(std::string name, std::vector<AnsweredCase> cases,
                             const std::vector<Mistake>& named)
    : name_(std::move(name)) {
  std::size_t explained = 0;
  for (AnsweredCase& one : cases)
    for (AnsweredNumber& number : one.numbers) {
      wrong_answers_ += number.is_wrong ? 1 : 0;
      explained += number.is_explained ? 1 : 0;
      number.is_explained = false;
    }
  for (const Part& part : parts_left(cases))
    branches_[part.branch].push_back({place_of_wrong(part)});
  const bool is_named = !named.empty() && static_cast<double>(explained) >=
                                              nearly_all * static_cast<double>(wrong_answers_);
  find_slip(cases, is_named ? named : std::vector<Mistake>{});
}

bool WrongFunction::is_wrong_at(const Question& inner) const {
  if (inner.function == nullptr || inner.function->name != name_) return false;
  const auto branch = branches_.find(branch_of(inner));
  if (branch == branches_.end()) return false;
  return std::any_of(branch->second.begin(), branch->second.end(), [&](const Branch& one) {
    return !one.place || !one.place->holds || one.place->holds(inner);
  });
}

const Mistake* WrongFunction::at_points(const Question& inner, bool is_shared_alike) const {
  if (!at_points_) return nullptr;
  const Mistake* const slip = &*slip_;
  const std::optional<Numbers> numbers = numbers_with({&slip, 1}, inner);
  const bool is_known = numbers && std::none_of(numbers->begin(), numbers->end(),
                                                [](double one) { return std::isnan(one); });
  return is_known ? &*(is_shared_alike && with_sharing_ ? with_sharing_ : at_points_) : nullptr;
}

void WrongFunction::find_slip(const std::vector<AnsweredCase>& cases,
                              const std::vector<Mistake>& named) {
  Mistake slip{.function = name_, .name = name_, .text = name_, .touches = {}};
  if (!named.empty()) {
    closeness_ = closeness_of_formula;
    slip.instead = [named](const Question& question) {
      Mistakes together;
      for (const Mistake& one : named) together.push_back(&one);
      std::optional<Numbers> numbers = numbers_with(together, question);
      return numbers ? numbers : std::optional(right_numbers(question));
    };
  } else {
    std::vector<WrongResult> results;
    for (const Part& part : parts_left(cases)) {
      WrongResult result{part.place, part.branch, {}};
      const auto times = [](const std::function<double(const Question&)>& factor) {
        return
            [factor](const Question& question, double right) { return right * factor(question); };
      };
      if (const auto factor = power_factor(part)) {
        result.answer = times(factor);
      } else if (const auto bounded = floor_or_cap(part)) {
        result.answer = [bounded](const Question&, double right) { return bounded(right); };
      } else if (const std::optional<Misread> misread = misread_input(part, {})) {
        result.answer = [answer = misread->answer, place = part.place](
                            const Question& question, double) { return answer(question, place); };
      }
      if (result.answer) {
        closeness_ = std::max(closeness_, closeness_of_formula);
      } else {
        // Without a known factor the result is NaN, so that at_points() is null in this branch.
        const auto depends = dependence_of(part);
        result.answer = times(depends ? depends->factor : [](const Question&) { return unsaid; });
        if (depends) closeness_ = closeness_of_curve;
      }
      results.push_back(std::move(result));
    }
    if (closeness_ == 0) return;
    slip.instead = [results](const Question& question) {
      Numbers numbers = right_numbers(question);
      for (const WrongResult& one : results)
        if (one.branch == branch_of(question))
          numbers[one.place] = one.answer(question, numbers[one.place]);
      return std::optional(numbers);
    };
  }
  slip_ = slip;
  at_points_ = name_.starts_with("hertz_") ? std::optional(with_contact(slip)) : for_points(slip);
  if (!is_film_of_points(name_)) return;
  at_points_ = with_film({slip});
  with_sharing_ = with_film_and_sharing(slip);
}

}  // namespace tribo::conformance
