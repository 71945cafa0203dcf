// SPDX-License-Identifier: Apache-2.0
// The certified cases reach both ends of each number that a function takes, and of each combination
// of them (catalogue.hpp): a solver that cuts one off before its end gives a wrong answer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "catalogue/catalogue.hpp"
#include "conformance/answers.hpp"
#include "conformance/question.hpp"
#include "support/case_count.hpp"
#include "tribo/mixed_contact.hpp"

namespace tribo::conformance {
namespace {

using catalogue::Arguments;
using catalogue::Combination;
using catalogue::Function;
using catalogue::Parameter;
using catalogue::Results;

// An end of the reach of a number or of a combination, and how a solver cuts it off there.
struct End {
  std::string name;
  double next_to;  // the end, or within rounding of it
  double cut;      // the solver goes no further
  bool is_upper;
  std::function<double(const Arguments&)> value;  // of the number or combination
  std::size_t parameter;                          // the argument that is changed to move the value
  double least_step;                              // where the search begins if the argument is 0

  bool is_cut(double number) const { return is_upper ? number > cut : number < cut; }
};

// Where a solver cuts off: a tenth of the end before it, or, where the end is 0, at a hundredth of
// the other end.
double cut_of(double end, double other, bool is_upper) {
  if (end == 0) return other / 100;
  return end * (is_upper == (end > 0) ? 0.9 : 1.1);
}

std::size_t place_of(const Function& function, std::string_view parameter) {
  for (std::size_t i = 0; i < function.parameters.size(); ++i)
    if (function.parameters[i].name == parameter) return i;
  ADD_FAILURE() << function.name << " has no " << parameter;
  return 0;
}

std::vector<End> ends_of(const Function& function) {
  std::vector<End> all;
  const auto add = [&](std::string_view name, double least, double greatest, std::size_t parameter,
                       const std::function<double(const Arguments&)>& value, double rounding) {
    for (const bool is_upper : {false, true}) {
      const double end = is_upper ? greatest : least, other = is_upper ? least : greatest;
      all.push_back({std::string(name) + (is_upper ? ", greatest" : ", least"),
                     end * (is_upper == (end > 0) ? 1 - rounding : 1 + rounding),
                     cut_of(end, other, is_upper), is_upper, value, parameter,
                     1e-9 * function.parameters[parameter].greatest});
    }
  };
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const Parameter& one = function.parameters[i];
    // The orders of a moment are its branches, as words are.
    if (!one.words.empty() || one.range == catalogue::Range::half_order) continue;
    add(
        one.name, one.least, one.greatest, i, [i](const Arguments& x) { return x[i]; }, 0);
  }
  for (const Combination& one : function.combinations)
    add(one.name, one.least, one.greatest, place_of(function, one.parameter), one.value, 1e-9);
  return all;
}

// The arguments with the end's number moved to `wanted` by its parameter alone. Halving finds them,
// because the number is monotonic in the parameter.
Arguments moved_to(const End& end, Arguments x, double wanted) {
  double& number = x[end.parameter];
  const double before = end.value(x);
  if (before == wanted) return x;
  const auto is_before = [&] { return (end.value(x) < wanted) == (before < wanted); };
  const double start = number;
  double inside = start, outside = start;
  for (const double factor : {1 / 1.5, 1.5}) {
    number = start == 0 ? end.least_step : start;
    for (int i = 0; i < 200 && is_before(); ++i) number *= factor;
    if (!is_before() && std::isfinite(end.value(x))) outside = number;
  }
  for (int i = 0; i < 200; ++i) {
    number = inside + (outside - inside) / 2;
    if (number == inside || number == outside) break;
    (is_before() ? inside : outside) = number;
  }
  return x;
}

Results value_of(const Function& function, const Arguments& x) {
  Results results{};
  function.value(x, results);
  return results;
}

// The words and orders of the arguments: the branch of the function.
std::string branch_of(const Function& function, const Arguments& x) {
  std::string branch;
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const Parameter& one = function.parameters[i];
    if (!one.words.empty()) branch += ' ' + std::string(one.words[static_cast<std::size_t>(x[i])]);
    if (one.range == catalogue::Range::half_order) branch += " order " + std::to_string(x[i]);
  }
  return branch;
}

struct Asked {
  const TestCase* one;
  Arguments arguments;
};

bool is_caught(const Function& function, const End& end, const std::vector<Asked>& cases,
               const Tolerance& tolerance) {
  return std::any_of(cases.begin(), cases.end(), [&](const Asked& asked) {
    if (!end.is_cut(end.value(asked.arguments))) return false;
    if (!tolerance.is_strict && asked.one->is_extreme) return false;
    const Results results = value_of(function, moved_to(end, asked.arguments, end.cut));
    return std::any_of(
        asked.one->expected.begin(), asked.one->expected.end(), [&](const Expected& expected) {
          const double got = results[expected.place.value()];
          const double error = std::abs((got - expected.high) - expected.low);
          return expected.is_physical && !(error <= allowed_error(*asked.one, expected, tolerance));
        });
  });
}

// Whether a question at this end can show the cut. It cannot if the law is nearly constant there,
// as 1 − e^{−0.73k} at the greatest k. The bound has a margin, because the condition is not known.
bool can_be_seen(const Function& function, const End& end, const std::vector<Asked>& cases) {
  return std::any_of(cases.begin(), cases.end(), [&](const Asked& asked) {
    const Arguments at = moved_to(end, asked.arguments, end.next_to);
    if (!catalogue::is_physical(function, at) || (function.refusal && function.refusal(at)))
      return false;
    const Results right = value_of(function, at);
    const Results cut = value_of(function, moved_to(end, at, end.cut));
    for (std::size_t i = 0; i < function.results.size(); ++i)
      if (std::abs(cut[i] - right[i]) > 1e-4 * std::abs(right[i])) return true;
    return false;
  });
}

TEST(Reach, OfEachNumberAndCombinationIsAskedToItsEnds) {
  for (const Function& function : catalogue::functions()) {
    std::map<std::string, std::vector<Asked>> branches;
    for (const TestCase& one : all_cases())
      if (one.in_catalogue == &function) {
        const Arguments x = question_of(one).arguments;
        branches[branch_of(function, x)].push_back({&one, x});
      }
    for (const auto& [branch, cases] : branches)
      for (const End& end : ends_of(function)) {
        if (!can_be_seen(function, end, cases)) continue;
        ++verification::case_count.held;
        for (const Tolerance& tolerance : {strict_tolerance(), engineering_tolerance()})
          EXPECT_TRUE(is_caught(function, end, cases, tolerance))
              << function.name << branch << ", " << end.name
              << ": no case shows a solver that goes "
              << "no further than " << end.cut << " (" << tolerance.name << ')';
      }
  }
}

// Operating points show solvers that cut off the exponent αp, or η₀γ̇/τ₀ with η₀ at ambient
// pressure. Each is cut off a tenth below its greatest value in the catalogue.
TEST(Reach, OfFrictionIsAskedToAnExponentOf70AndAShearNumberOf10000) {
  constexpr double exponent_cut = 63, shear_cut = 9e3;
  std::map<std::string, std::pair<std::size_t, std::size_t>> caught;
  for (const TestCase& one : all_cases()) {
    const Question question = question_of(one);
    if (!question.scene || !has_friction_inputs(*question.scene)) continue;
    const Scene& scene = *question.scene;
    const OperatingPoint<double> point = MixedContact<double>(scene).solve(scene.speeds[0]);
    const auto numbers = detail::numbers_of<double>(scene);
    const double pressure = hertz_contact(scene.bodies.shape(), numbers).mean_pressure;
    const double exponent =
        log_viscosity_ratio(scene.friction.viscosity, numbers.viscosity, numbers.pressure_viscosity,
                            point.fluid_load_share * pressure);
    const double sliding = scene.friction.slide_roll_ratio * scene.speeds[0];
    const double stress_number =
        numbers.viscosity * sliding / point.separation / *scene.lubricant.eyring_stress;
    const auto stress = [&](double thickening) {
      return fluid_shear_stress(scene.friction.fluid, *scene.lubricant.eyring_stress,
                                numbers.viscosity, thickening, sliding, point.separation);
    };
    const double sheared = std::max(0.0, 1 - point.real_area_ratio);
    const auto is_seen = [&](double cut) {
      const double change = (stress(cut) - stress(exponent)) * sheared / pressure;
      return std::any_of(one.expected.begin(), one.expected.end(), [&](const Expected& expected) {
        return expected.field == "friction" && expected.is_physical &&
               std::abs(change) > 2 * allowed_error(one, expected, engineering_tolerance());
      });
    };
    auto& [exponents, numbers_seen] = caught[one.function];
    if (exponent > exponent_cut && exponent <= 70) exponents += is_seen(exponent_cut) ? 1 : 0;
    if (stress_number > shear_cut && stress_number <= 1e4)
      numbers_seen += is_seen(exponent + std::log(shear_cut / stress_number)) ? 1 : 0;
  }
  EXPECT_EQ(caught.size(), operating_point_functions.size());
  for (const auto& [function, counts] : caught) {
    EXPECT_GT(counts.first, 0U) << function << ", αp";
    EXPECT_GT(counts.second, 0U) << function << ", η₀γ̇/τ₀";
  }
}

}  // namespace
}  // namespace tribo::conformance
