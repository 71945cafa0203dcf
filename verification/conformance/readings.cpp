// SPDX-License-Identifier: Apache-2.0
#include "conformance/readings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>

#include "catalogue/ways_to_ask.hpp"
#include "conformance/question.hpp"
#include "conformance/viscosity_index_table.hpp"
#include "tribo/hertz_ellipse.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/viscosity_index.hpp"

namespace tribo::conformance {
namespace {

using Real = long double;

// --- Roelands' law with the printed viscosity at which all isotherms meet. The usual constant 9.67
// is minus the logarithm of it, rounded.

Real log_thickening(Real viscosity, Real alpha, Real pressure, Real log_pole) {
  const Real scale = std::log(viscosity) - log_pole,
             relative = pressure / roelands_pressure<Real>();
  return scale * std::expm1(alpha * roelands_pressure<Real>() / scale * std::log1p(relative));
}

std::optional<Real> viscosity_with(const Question& question, Real log_pole) {
  const catalogue::Arguments& x = question.arguments;
  return x[0] * std::exp(log_thickening(x[0], x[1], x[2], log_pole));
}

std::optional<Real> friction_with(const Question& question, Real log_pole) {
  const Scene& scene = *question.scene;
  if (scene.friction.viscosity != ViscosityLaw::roelands || !has_friction_inputs(scene))
    return std::nullopt;
  const OperatingPoint<Real> point = MixedContact<Real>(scene).solve(scene.speeds[0]);
  if (std::isnan(point.friction)) return std::nullopt;
  const auto numbers = detail::numbers_of<Real>(scene);
  const Real mean_pressure = hertz_contact(scene.bodies.shape(), numbers).mean_pressure;
  const Real pressure = point.fluid_load_share * mean_pressure;
  const Real sliding = Real(scene.friction.slide_roll_ratio) * Real(scene.speeds[0]);
  const auto stress = [&](Real thickening) {
    return fluid_shear_stress(scene.friction.fluid, Real(*scene.lubricant.eyring_stress),
                              numbers.viscosity, thickening, sliding, point.separation);
  };
  const Real own = log_thickening(numbers.viscosity, numbers.pressure_viscosity, pressure,
                                  -roelands_log_viscosity<Real>());
  const Real other =
      log_thickening(numbers.viscosity, numbers.pressure_viscosity, pressure, log_pole);
  const Real sheared = std::max(Real(0), 1 - point.real_area_ratio);
  return point.friction + (stress(other) - stress(own)) * sheared / mean_pressure;
}

template <int digits>  // of the printed number: 631 or 6315
Real log_pole() {
  return std::log(Real(digits) / (digits < 1000 ? Real(10000000) : Real(100000000)));
}

// --- ASTM D341 with the exponential terms that the standard prints for thin liquids. ν in mm²/s.

Real term(Real viscosity) {
  return std::exp(-(Real(147) + viscosity * (Real(184) + Real(51) * viscosity)) / 100);
}
// ν from Z − 0.7 by the printed inverse, which inverts the term above to about 1e-3 of ν.
Real printed_viscosity(Real z) {
  const Real power = -7487 + z * (-32950 + z * (6119 - z * 3193));
  return z - std::exp(power / 10000);
}
Real solved_viscosity(Real z) {
  Real viscosity = z;
  for (int i = 0; i < 60; ++i) {  // Newton's method: the slope is above 0.5 from ν = 0 on
    const Real of_term = term(viscosity);
    const Real slope = 1 - of_term * (Real(184) + Real(102) * viscosity) / 100;
    viscosity = std::max(Real(0), viscosity - (viscosity + of_term - z) / slope);
  }
  return viscosity;
}

std::optional<Real> full_astm_d341(const Question& question, Real (*viscosity_of)(Real)) {
  const catalogue::Arguments& x = question.arguments;
  const auto log_log = [](Real viscosity) {
    const Real millions = 1000000 * viscosity;
    return std::log(std::log(millions + Real(7) / 10 + term(millions)));
  };
  const Real first = log_log(x[1]), second = log_log(x[3]);
  const Real part = std::log(Real(x[4]) / Real(x[0])) / std::log(Real(x[2]) / Real(x[0]));
  const Real z = std::exp(std::exp(first + part * (second - first))) - Real(7) / 10;
  return viscosity_of(z) / 1000000;
}

// --- The viscosity index by the standard's table 1, with interpolation between its rows. Beyond
// them equations 1 and 2 hold. Their constants are those of table X2.1, rounded.

std::optional<Real> index_by_table(const Question& question) {
  const Real at_100 = 1000000 * Real(question.arguments[1]);
  const auto viscosity = [](std::size_t row) { return Real(index_table_tenths(row)) / 10; };
  const std::size_t last = index_table.size() - 1;
  // The ends are compared in m²/s as doubles: in long double 1e6 · 2e-6 is less than 2.
  if (!(question.arguments[1] >= 2e-6)) return std::nullopt;
  detail::IndexOils<Real> oils{(Real(8353) / 10000 * at_100 + Real(1467) / 100) * at_100 - 216,
                               (Real(1684) / 10000 * at_100 + Real(1185) / 100) * at_100 - 97};
  if (question.arguments[1] <= 70e-6) {
    std::size_t row = 0;
    while (row + 1 < last && at_100 > viscosity(row + 1)) ++row;
    const Real part = (at_100 - viscosity(row)) / (viscosity(row + 1) - viscosity(row));
    const auto between = [&](double IndexTableRow::*oil) {
      return (1 - part) * Real(index_table[row].*oil) + part * Real(index_table[row + 1].*oil);
    };
    oils = {between(&IndexTableRow::zero), between(&IndexTableRow::hundred)};
  }
  return detail::index_among(Real(question.arguments[0]), Real(question.arguments[1]), oils);
}

// --- Films of a solver that is given both radii, and computes the ellipticity k by a fit of the
// film laws' own authors: B. J. Hamrock, D. Dowson: Isothermal elastohydrodynamic lubrication of
// point contacts, part I. J. Lubr. Technol. 98 (1976) 223, k = 1.03 (R_y/R_x)^0.64; D. E. Brewe,
// B. J. Hamrock: Simplified solution for elliptical-contact deformation between two elastic solids.
// J. Lubr. Technol. 99 (1977) 485, k = 1.0339 (R_y/R_x)^0.636.

std::optional<Real> film_with(const Question& question, double factor, double exponent) {
  const auto parameters = question.function->parameters;
  const std::size_t place = place_in(parameters, "ellipticity");
  if (place == parameters.size()) return std::nullopt;
  catalogue::Arguments arguments = question.arguments;
  arguments[place] = factor * std::pow(radius_ratio_of(arguments[place]), exponent);
  catalogue::Results film{};
  question.function->value(arguments, film);
  return film[0];
}

// --- The readings.

constexpr std::string_view film_of_radii = "film of radii";

struct Reading {
  // "operating_point": each kind of point. film_of_radii: each film law asked with both radii.
  std::string_view function;
  std::string_view field;
  std::string_view text;
  std::optional<Real> (*value)(const Question&);  // empty: the certified value holds
};

constexpr std::string_view with_631 =
    "the constant 6.31e-5 Pa·s as it is printed, of which 9.67 "
    "is the rounding";
constexpr std::string_view with_6315 = "the constant 6.315e-5 Pa·s, the rounding of e^−9.67";
constexpr std::array readings{
    Reading{"roelands_viscosity", "value", with_631,
            [](const Question& asked) { return viscosity_with(asked, log_pole<631>()); }},
    Reading{"roelands_viscosity", "value", with_6315,
            [](const Question& asked) { return viscosity_with(asked, log_pole<6315>()); }},
    Reading{"operating_point", "friction", with_631,
            [](const Question& asked) { return friction_with(asked, log_pole<631>()); }},
    Reading{"operating_point", "friction", with_6315,
            [](const Question& asked) { return friction_with(asked, log_pole<6315>()); }},
    Reading{"astm_d341_viscosity", "value",
            "the exponential terms that the standard prints for thin liquids",
            [](const Question& asked) { return full_astm_d341(asked, printed_viscosity); }},
    Reading{"astm_d341_viscosity", "value",
            "the exponential term that the standard prints for thin liquids, solved for ν",
            [](const Question& asked) { return full_astm_d341(asked, solved_viscosity); }},
    Reading{"viscosity_index", "value",
            "the rows of the standard's table 1, between which it interpolates", index_by_table},
    Reading{film_of_radii, "value", "the fit k = 1.03 (R_y/R_x)^0.64 for the ellipse of contact",
            [](const Question& asked) { return film_with(asked, 1.03, 0.64); }},
    Reading{film_of_radii, "value", "the fit k = 1.0339 (R_y/R_x)^0.636 for the ellipse of contact",
            [](const Question& asked) { return film_with(asked, 1.0339, 0.636); }}};

bool is_of(const Reading& reading, const std::string& function, const AskedWays& ways) {
  if (reading.function == film_of_radii) {
    const catalogue::Function* const known = catalogue::function_named(function);
    return ways.has_radii() && known != nullptr &&
           std::any_of(catalogue::ways_to_ask().begin(), catalogue::ways_to_ask().end(),
                       [&](const catalogue::WayToAsk& way) {
                         return way.name == ways.ellipticity && has_way(*known, way);
                       });
  }
  return reading.function == function ||
         (is_operating_point(reading.function) && is_operating_point(function));
}

Expected* expected_of(TestCase& one, std::string_view field) {
  for (Expected& expected : one.expected)
    if (expected.field == field && expected.word.empty()) return &expected;
  return nullptr;
}

// The answer that a reading expects; `expected` itself if the reading has no finite value.
Expected read_as(const Reading& reading, const TestCase& one, Expected expected) {
  const std::optional<Real> value = reading.value(question_of(one));
  if (!value || !std::isfinite(static_cast<double>(*value))) return expected;
  expected.high = static_cast<double>(*value);
  expected.low = static_cast<double>(*value - static_cast<Real>(expected.high));
  return expected;
}

// An answer, and what is expected of it.
struct Judged {
  TestCase* asked;
  Expected* expected;
  const Reply* answer;
};

std::vector<Judged> judged_of(std::vector<TestCase>& cases, const Conversation& conversation,
                              const std::string& function, std::string_view field) {
  std::vector<Judged> all;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Reply& answer = conversation.answers[i];
    if (cases[i].function != function || answer.outcome != Outcome::answered) continue;
    Expected* const expected = expected_of(cases[i], field);
    if (expected != nullptr) all.push_back({&cases[i], expected, &answer});
  }
  return all;
}

std::vector<Expected> certified_of(const std::vector<Judged>& answers) {
  std::vector<Expected> all;
  for (const Judged& one : answers) all.push_back(*one.expected);
  return all;
}

bool is_met(const Judged& one, const Expected& expected, const Tolerance& tolerance) {
  const auto found = one.answer->fields.find(expected.field);
  if (found == one.answer->fields.end() || !found->is_number()) return false;
  const double error = std::abs((found->get<double>() - expected.high) - expected.low);
  return error <= allowed_error(*one.asked, expected, tolerance);
}

std::size_t count_met(const std::vector<Judged>& answers, const std::vector<Expected>& expected,
                      const Tolerance& tolerance) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < answers.size(); ++i)
    count += is_met(answers[i], expected[i], tolerance) ? 1 : 0;
  return count;
}

// Whether the reading is met by at least half of the answers where it differs from the certified
// one. A few answers of a solver that is wrong elsewhere may meet it by accident.
bool is_likely(const std::vector<Judged>& answers, const std::vector<Expected>& expected,
               const Tolerance& tolerance) {
  std::size_t moved = 0, met = 0;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const Expected& certified = *answers[i].expected;
    const double apart =
        std::abs((expected[i].high - certified.high) + (expected[i].low - certified.low));
    if (!(apart > allowed_error(*answers[i].asked, certified, tolerance))) continue;
    ++moved;
    met += is_met(answers[i], expected[i], tolerance) ? 1 : 0;
  }
  return 2 * met >= moved;
}

}  // namespace

std::vector<std::string> take_readings(std::vector<TestCase>& cases,
                                       const Conversation& conversation, const Tolerance& tolerance,
                                       const AskedWays& ways) {
  std::set<std::string> functions;
  for (const TestCase& one : cases) functions.insert(one.function);
  std::vector<std::string> notes;
  for (const std::string& function : functions) {
    // The answers to cases of the function that expect a number in the reading's field.
    std::vector<Judged> answers;
    const Reading* best = nullptr;
    std::size_t most = 0;  // answers that meet the best reading
    std::vector<Expected> best_expected;
    for (const Reading& reading : readings) {
      if (!is_of(reading, function, ways)) continue;
      if (answers.empty()) {
        answers = judged_of(cases, conversation, function, reading.field);
        most = count_met(answers, certified_of(answers), tolerance);
      }
      if (most == answers.size()) break;
      std::vector<Expected> expected;
      for (const Judged& one : answers)
        expected.push_back(read_as(reading, *one.asked, *one.expected));
      const std::size_t met = count_met(answers, expected, tolerance);
      if (met <= most || !is_likely(answers, expected, tolerance)) continue;
      best = &reading;
      most = met;
      best_expected = std::move(expected);
    }
    if (best == nullptr) continue;
    for (std::size_t i = 0; i < answers.size(); ++i) *answers[i].expected = best_expected[i];
    notes.push_back(
        fmt::format("{} is held to the law with {}.", answers[0].expected->quantity, best->text));
  }
  return notes;
}

}  // namespace tribo::conformance
