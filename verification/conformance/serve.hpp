// SPDX-License-Identifier: Apache-2.0
// A solver in C++ that answers tribocheck: give functions, link tribocheck::conformance_serve.
//
//   int main() {
//     tribo::conformance::Solver solver;
//     solver.gaussian_moment = tribo::conformance::each(
//         [](const auto& asked) { return my_moment(asked.order, asked.argument); });
//     return tribo::conformance::serve(solver);
//   }
//
//   tribocheck verify --subject ./my_solver
//
// SI units; formulas, symbols and ranges: model/README.md. Cases are in range.
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "tribo/mixed_contact.hpp"

namespace tribo::conformance {

struct MomentCase {
  double order;     // n: 0, 0.5, 1, 1.5, 2 or 2.5
  double argument;  // d
};
struct HertzCase {
  double load;               // F, N
  double effective_modulus;  // E*, Pa
  double reduced_radius;     // R, m
};
struct FilmCase {
  double speed;               // u, m/s, entrainment
  double viscosity;           // η₀, Pa·s
  double pressure_viscosity;  // α, 1/Pa
  double load;                // F, N
  double effective_modulus;   // E*, Pa
  double reduced_radius;      // R, m
  double ellipticity;         // k
};
struct StarvationCase {
  StarvationClosure closure;
  double flooded_over_inlet;  // r = h_ff/h_oil
  double damiens_exponent;    // γ
};
struct SharingCase {
  AsperityModel asperity;
  double flooded_film_parameter;  // λ₀
  double stiffness;               // K
  double offset;                  // δ
};

// A number in a result that is not finite has a meaning. NaN: this result is not offered. Infinity:
// this result is undefined at this point. A function with only one result always offers it: there
// NaN is an error.
inline constexpr double not_offered = std::numeric_limits<double>::quiet_NaN();
inline constexpr double undefined_here = std::numeric_limits<double>::infinity();

struct HertzResult {
  double radius = not_offered;         // a, m
  double mean_pressure = not_offered;  // Pa
  double peak_pressure = not_offered;  // Pa
  double approach = not_offered;       // m
};

// A word of a result.
template <class Word>
struct WordResult {
  enum class Kind : std::uint8_t { absent, undefined, word };
  WordResult() = default;
  WordResult(Word given) : kind(Kind::word), word(given) {}
  Kind kind = Kind::absent;  // not offered
  Word word{};
};

// Meaning and units: tribo/outputs.hpp.
struct PointResult {
  double film_flooded = not_offered;
  double film = not_offered;
  double separation = not_offered;
  double film_parameter = not_offered;
  double asperity_load_share = not_offered;
  double fluid_load_share = not_offered;
  double real_area_ratio = not_offered;
  double summit_count = not_offered;
  double friction = not_offered;
  WordResult<Regime> regime;
  WordResult<Inlet> inlet;
};

// Instead of a result.
enum class Status : std::uint8_t { done, skipped, undefined, failed };
struct NoResult {
  Status status;
  std::string reason;
};
inline NoResult skip(std::string reason) { return {Status::skipped, std::move(reason)}; }
inline NoResult undefined(std::string reason) { return {Status::undefined, std::move(reason)}; }
inline NoResult failed(std::string reason) { return {Status::failed, std::move(reason)}; }

template <class Result>
struct Answer {
  Answer() = default;
  Answer(Result given) : result(std::move(given)), status(Status::done) {}
  Answer(NoResult none) : status(none.status), reason(std::move(none.reason)) {}
  Result result{};
  Status status = Status::failed;
  std::string reason = "no answer was given";
};

// Answers several cases; both spans have the same size, at least 1.
template <class Case, class Result>
using Batch = std::function<void(std::span<const Case>, std::span<Answer<Result>>)>;

// What a solver offers; what is left empty is skipped. An operating point is a scene with one
// speed.
struct Solver {
  Batch<MomentCase, double> gaussian_moment;  // F_n(d)
  Batch<HertzCase, HertzResult> hertz_point;
  Batch<FilmCase, double> hamrock_dowson_central;  // m
  Batch<StarvationCase, double> starvation_ratio;  // h*/h_ff
  Batch<SharingCase, double> load_sharing;         // λ
  Batch<Scene, PointResult> operating_point;
};

// Makes a function of several cases from a function of one case, which returns a result, a NoResult
// or an Answer. If it throws, the case failed with the message as the reason.
template <class Function>
auto each(Function function) {
  return [function = std::move(function)](auto cases, auto answers) {
    for (std::size_t i = 0; i < cases.size(); ++i) try {
        answers[i] = function(cases[i]);
      } catch (const std::exception& error) {
        answers[i] = failed(error.what());
      }
  };
}

// Answers JSON lines from stdin on stdout until the input ends: the protocol of `tribocheck verify
// --subject`. From then on what the solver prints to stdout comes out on stderr. Returns an exit
// code: 0, or 1 after a line on stderr where input or output broke.
int serve(const Solver& solver);

// The same with answers to a descriptor, for who has used take_stdout() before.
int serve(const Solver& solver, int answers);

// Returns a copy of stdout, or −1 if there is no stdout. From then on stdout leads to stderr, or
// nowhere if stderr is closed.
int take_stdout();

}  // namespace tribo::conformance
