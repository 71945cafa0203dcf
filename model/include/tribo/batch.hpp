// SPDX-License-Identifier: Apache-2.0
// Many points in one call, in double: vector code of Google Highway, compiled for each instruction
// set and chosen at run time. A point's bits do not depend on its place in a batch, nor on the
// batch's size. Nothing is allocated, nothing throws, any thread may call.
//
// All spans of a call have one length; the result may be the span of an argument.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "tribo/contract.hpp"
#include "tribo/gaussian_moment.hpp"
#include "tribo/load_sharing.hpp"

namespace tribo {

// The error of ln F_n is at most `ulp` times ε·max(1, |ln F_n|).
inline constexpr Contract log_gaussian_moment_contract{2, 0};

// F_n(d), S_n(d) (e^{d²/2} F_n(d) for d ≥ 0, F_n(d) for d < 0) and ln F_n(d), for every double. F_n
// and S_n have the same bits as the functions of one number in gaussian_moment.hpp, and keep
// gaussian_moment_contract.
void gaussian_moment(Order n, std::span<const double> d, std::span<double> moments);
void scaled_gaussian_moment(Order n, std::span<const double> d, std::span<double> moments);
void log_gaussian_moment(Order n, std::span<const double> d, std::span<double> logarithms);

// The work of a batch of roots.
struct SharingWork {
  std::size_t steps = 0;      // of all roots together
  std::size_t by_newton = 0;  // roots left to the template, whose steps are not counted
};

// The film parameters λ of load sharing (load_sharing.hpp) at flooded film parameters λ₀. The first
// function takes one surface for each point, by its K ≥ 0 and δ ≥ 0; the second takes one surface
// for all points. The bits are those of LoadSharing<double>.
SharingWork film_parameter(AsperityModel model, std::span<const double> stiffness,
                           std::span<const double> offset,
                           std::span<const double> flooded_film_parameter,
                           std::span<double> film_parameter,
                           const FilmLaw& film = hamrock_dowson_central_law);
SharingWork film_parameter(const LoadSharing<double>& sharing,
                           std::span<const double> flooded_film_parameter,
                           std::span<double> film_parameter);

// The film parameter of a single point; its surface is prepared for this call alone.
double film_parameter(AsperityModel model, double stiffness, double offset,
                      double flooded_film_parameter,
                      const FilmLaw& film = hamrock_dowson_central_law);

// The instruction set that this process uses, by Highway's name: AVX3, AVX2, SSE4, SCALAR
std::string_view instruction_set();
// Does this instruction set have fused multiply-add? All sets that have it give the same bits, and
// all sets that lack it give the same bits as each other.
bool is_fused();
// "FMA" or "no FMA": the word for it in results and parts of sweeps.
std::string_view arithmetic();
// The instruction sets that this machine has, the best first. The setting
// GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX512F,-AVX2,-FMA in the environment switches sets off, for
// this library as for the C library.
std::span<const std::string_view> instruction_sets();
// Makes batches use this instruction set from now on, for tests and benchmarks; false if the
// machine lacks the set. Do not call this while a batch runs.
bool use_instruction_set(std::string_view name);

}  // namespace tribo
