// SPDX-License-Identifier: Apache-2.0
// Rough faces.
#include "catalogue/families.hpp"
#include "tribo/spectral_moments.hpp"

namespace tribo::catalogue {
namespace {

constexpr std::array moment_parameters{
    Parameter{.name = "m0",
              .meaning = "m₀, mean square of the profile's heights",
              .unit = "m²",
              .least = 1e-20,
              .greatest = 1e-8},
    Parameter{.name = "m2",
              .meaning = "m₂, mean square of the profile's slopes",
              .least = 1e-8,
              .greatest = 1},
    Parameter{.name = "m4",
              .meaning = "m₄, mean square of the profile's curvatures",
              .unit = "1/m²",
              .least = 1e2,
              .greatest = 1e16}};
constexpr std::array moment_combinations{
    Combination{.name = "bandwidth",
                .meaning = "α = m₀m₄/m₂²",
                .least = 1.5,
                .greatest = 1000,
                .value = [](const Arguments& x) { return x[0] * x[2] / (x[1] * x[1]); },
                .parameter = "m4"}};
constexpr std::array summit_results{
    Result{"bandwidth", "α = m₀m₄/m₂²; 1.5 or more of an isotropic Gaussian face"},
    Result{"summit_density", "n", "1/m²"},
    Result{"summit_radius", "β, of the mean curvature of the summits", "m"},
    Result{"summit_height_sd", "σ_s, standard deviation of the summits' heights", "m"},
    Result{"summit_plane_offset",
           "D_d/σ_s, from the mean plane of the face to the mean of the summits, over σ_s"}};

std::optional<Refusal> too_narrow_a_band(const Arguments& x) {
  if (tribo::summits_from_spectral_moments(x[0], x[1], x[2]).bandwidth > 0) return std::nullopt;
  return Refusal{"m4",
                 "the bandwidth m0 m4/m2² has to be above 0.8968, or the variance of the summits' "
                 "heights is not above 0; an isotropic Gaussian face has 1.5 or more"};
}

constexpr std::array entries{
    Function{.name = "summits_from_spectral_moments",
             .meaning = "summits of an isotropic Gaussian face from the moments of its profile",
             .equation = "α = m₀m₄/m₂² > 0.8968, n = m₄/(6π√3 m₂), β = (3/8)√(π/m₄), σ_s² = (1 − "
                         "0.8968/α)m₀, D_d = 4√(m₀/(πα))",
             .source = "J. I. McCool: Relating profile instrument measurements to the functional "
                       "performance of rough surfaces. J. Tribol. 109 (1987) 264; P. R. Nayak: "
                       "Random process model of rough surfaces. J. Lubr. Technol. 93 (1971) 398",
             .parameters = moment_parameters,
             .results = summit_results,
             .value =
                 [](const Arguments& x, Results& y) {
                   const Summits<double> s = tribo::summits_from_spectral_moments(x[0], x[1], x[2]);
                   y = {s.bandwidth, s.summit_density, s.summit_radius, s.summit_height_sd,
                        s.summit_plane_offset};
                 },
             .contract = spectral_moments_contract,
             .example = {1e-14, 1e-4, 4e6},
             .refusal = too_narrow_a_band,
             .combinations = moment_combinations},
};

}  // namespace

std::span<const Function> surfaces() { return entries; }

}  // namespace tribo::catalogue
