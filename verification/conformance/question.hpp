// SPDX-License-Identifier: Apache-2.0
// The inputs of a case as numbers. They are read once; mistakes then change them.
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
// in the order of Output. NaN: nothing is said of this number.
using Numbers = std::array<double, number_count>;
static_assert(number_count >= catalogue::most_results);
inline constexpr double unsaid = std::numeric_limits<double>::quiet_NaN();

// How the load is shared: λ = λ₀ (1−A)^−e with A = (K F_n(λ − jδ))^q. If n, q or e is 0, it is that
// of the model. If c is not 0, F is a fit: c (d₁ − d)^m, and 0 beyond d₁.
struct SharingReading {
  double order = 0, share_exponent = 0, film_exponent = 0;  // n, q, e
  double offset_times = 1;                                  // j
  double fit_constant = 0, fit_end = 0, fit_exponent = 0;   // c, d₁, m

  bool operator==(const SharingReading&) const = default;
};

// How friction is computed: μ = μ_b A + d τ (1 − A_r/A_nom)/p̄. τ is the fluid's shear stress. The
// right weight is d = 1.
struct FrictionReading {
  double film = 1;  // d
  double roelands_pressure = tribo::roelands_pressure<double>();
  double roelands_log_viscosity = tribo::roelands_log_viscosity<double>();  // 9.67
  double roelands_logarithm = 1;   // times ln η₀; 1/ln 10: log₁₀ η₀
  double limiting_by_minimum = 0;  // 1: min(ηγ̇, τ₀) for τ₀(1 − e^{−ηγ̇/τ₀})
  double limiting_by_tangent = 0;  // 1: τ₀ tanh(ηγ̇/τ₀) for the same
  double eyring_by_line = 0;       // 1: ηγ̇ for τ₀ asinh(ηγ̇/τ₀)
  // Each replaces the point's own number: the pressure in the viscosity law in Pa, ln(η/η₀), shear
  // rate in 1/s, gap in m, ηγ̇/τ₀; A in μ_b A, A_r/A_nom, and p̄ in Pa.
  std::optional<double> pressure = {}, log_viscosity = {}, shear_rate = {}, gap = {},
                        shear_number = {};
  std::optional<double> boundary_share = {}, real_area = {}, mean_pressure = {};

  bool operator==(const FrictionReading&) const = default;
};

// The numbers from which the fluid's shear stress is computed: the pressure in its viscosity law in
// Pa, ln(η/η₀), the shear rate in 1/s, the gap in m, and ηγ̇/τ₀.
struct ShearedFilm {
  double pressure, log_viscosity, shear_rate, gap, shear_number;
};

struct Question {
  const TestCase* asked;
  const catalogue::Function* function;  // null for an operating point
  catalogue::Arguments arguments{};     // of the function
  std::optional<FilmLaw> law = {};      // another film law in place of the function's own
  std::optional<Scene> scene = {};      // of an operating point, with its one speed
  SharingReading sharing = {};          // for load_sharing; for a point if film_exponent is not 0
  double summit_count_times = 1;        // of an operating point
  double real_area_times = 1;           // of an operating point
  // The model of a point's real area, and that of its number of summits. Empty: the model that
  // shares its load.
  std::optional<AsperityModel> area_model = {}, count_model = {};
  FrictionReading friction = {};  // of an operating point
};

Question question_of(const TestCase& asked);

struct ResultName {
  std::string_view name, unit;
};
// The results of a function, or of an operating point (null), in the order of Numbers. The words
// of a point come last.
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

// The numbers of the point if its flooded film parameter is `lambda`. The load shares follow from
// λ = λ₀ (1 − A)^−e, where e is `exponent`.
Numbers shared_point(const Question& question, const MixedContact<double>& contact, double lambda,
                     double exponent);

// The place in a request of a field or argument, such as "closures.film"; whether it is left out.
nlohmann::json::json_pointer pointer_to(std::string_view path);
bool is_left_out(const nlohmann::json& inputs, std::string_view path);

// An argument of the function as the request has it: a number, or a word of its list. Throws
// std::runtime_error for anything else.
double argument_of(const catalogue::Parameter& parameter, const nlohmann::json& written);

}  // namespace tribo::conformance
