// SPDX-License-Identifier: Apache-2.0
// The inputs of a case as numbers, read once, which mistakes then change.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "catalogue/catalogue.hpp"
#include "conformance/conformance_case.hpp"
#include "tribo/film_thickness.hpp"
#include "tribo/friction.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/operating_point.hpp"
#include "tribo/outputs.hpp"
#include "tribo/scene.hpp"

namespace tribo::conformance {

// The results of a function, in the order of the catalogue, or the numbers of an operating point,
// in the order of Output. NaN: nothing is said of this one.
using Numbers = std::array<double, number_count>;
static_assert(number_count >= catalogue::most_results);
inline constexpr double unsaid = std::numeric_limits<double>::quiet_NaN();

// Load sharing: λ = λ₀ (1−A)^−e with A = (K F_n(λ − jδ))^q; 0 stands for the model's own n, q and
// e. With the numbers of a fit, F is c (d₁ − d)^m, and 0 beyond d₁.
struct SharingReading {
  double order = 0, share_exponent = 0, film_exponent = 0;  // n, q, e
  double offset_times = 1;                                  // j
  double fit_constant = 0, fit_end = 0, fit_exponent = 0;   // c, d₁, m

  bool operator==(const SharingReading&) const = default;
};

// How friction is put together: μ = μ_b A + d τ (1 − A_r/A_nom)/p̄ with the weight d = 1, and the
// fluid's shear stress τ.
struct FrictionReading {
  double film = 1;  // d
  double roelands_pressure = tribo::roelands_pressure<double>();
  double roelands_log_viscosity = tribo::roelands_log_viscosity<double>();  // 9.67
  double roelands_logarithm = 1;   // 1/ln 10: log₁₀ η₀ for ln η₀
  double limiting_by_minimum = 0;  // 1: min(ηγ̇, τ₀) for τ₀(1 − e^{−ηγ̇/τ₀})
  double limiting_by_tangent = 0;  // 1: τ₀ tanh(ηγ̇/τ₀) for the same
  double eyring_by_line = 0;       // 1: ηγ̇ for τ₀ asinh(ηγ̇/τ₀)
  // In place of the point's own: the pressure that thickens in Pa, ln(η/η₀), shear rate in 1/s, gap
  // in m, ηγ̇/τ₀; A beside μ_b, A_r/A_nom, and p̄ in Pa under τ.
  std::optional<double> pressure = {}, log_viscosity = {}, shear_rate = {}, gap = {},
                        shear_number = {};
  std::optional<double> boundary_share = {}, real_area = {}, mean_pressure = {};

  bool operator==(const FrictionReading&) const = default;
};

// The numbers that the fluid's shear stress is computed from: the pressure that thickens it in Pa,
// ln(η/η₀), the shear rate in 1/s, the gap in m, and ηγ̇/τ₀.
struct ShearedFilm {
  double pressure, log_viscosity, shear_rate, gap, shear_number;
};

struct Question {
  const TestCase* asked;
  const catalogue::Function* function;  // null for an operating point
  catalogue::Arguments arguments{};     // of the function
  std::optional<FilmLaw> law = {};      // another film law in place of the function's own
  std::optional<Scene> scene = {};      // of an operating point, with its one speed
  SharingReading sharing = {};    // of load_sharing; of an operating point its film's exponent
  double summit_count_times = 1;  // of an operating point
  double real_area_times = 1;     // of an operating point
  // The model by which the real area or the summits of a point are computed, where that is not the
  // model that shares its load.
  std::optional<AsperityModel> area_model = {}, count_model = {};
  FrictionReading friction = {};  // of an operating point
};

Question question_of(const TestCase& asked);

struct ResultName {
  std::string_view name, unit;
};
// The results of a function in the order of Numbers; of an operating point (null) those that are
// words come last.
std::vector<ResultName> results_of(const catalogue::Function* function);

Numbers numbers_of(const catalogue::Results& results);
// The numbers of an operating point, with the question's changes of the real area, of the number of
// summits and of friction.
Numbers numbers_of(const OperatingPoint<double>& point, const Question& question);

// The sheared film of an operating point. Empty where the point has collapsed or lacks the inputs
// of friction, and for a question to a function.
std::optional<ShearedFilm> sheared_film(const Question& question);

// The model's results with the changes that the question carries. NaN where nothing is said.
Numbers right_numbers(const Question& question);

// The question to load_sharing at the first speed of a scene.
Question sharing_question(const MixedContact<double>& contact, const Scene& scene);

// The point with the flooded film parameter `lambda`, wherever that comes from: its shares follow
// from λ = λ₀ (1 − A)^−e, where e is `exponent`.
Numbers shared_point(const Question& question, const MixedContact<double>& contact, double lambda,
                     double exponent);

// The place of a field or an argument, as "closures.film", in a request; whether it is left out.
nlohmann::json::json_pointer pointer_to(std::string_view path);
bool is_left_out(const nlohmann::json& inputs, std::string_view path);

// An argument of the function as the request has it: a number, or a word of its list. Throws
// std::runtime_error for anything else.
double argument_of(const catalogue::Parameter& parameter, const nlohmann::json& written);

}  // namespace tribo::conformance
