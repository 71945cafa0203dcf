// SPDX-License-Identifier: Apache-2.0
// Rough faces.
#include "catalogue/families.hpp"
#include "catalogue/parameters.hpp"
#include "tribo/rough_faces.hpp"
#include "tribo/roughness.hpp"
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

constexpr std::array plasticity_parameters{effective_modulus,
                                           Parameter{.name = "hardness",
                                                     .meaning = "H, of the softer body",
                                                     .unit = "Pa",
                                                     .least = 1e5,
                                                     .greatest = 1e11},
                                           Parameter{.name = "summit_height_sd",
                                                     .meaning = "σ_s, of the summits' heights",
                                                     .unit = "m",
                                                     .least = 1e-10,
                                                     .greatest = 1e-4},
                                           Parameter{.name = "summit_radius",
                                                     .meaning = "β, of the summits' tips",
                                                     .unit = "m",
                                                     .least = 1e-8,
                                                     .greatest = 0.1}};
constexpr std::array plasticity_results{
    Result{"value", "ψ: elastic summits below some 0.6, plastic ones above 1"}};

constexpr std::array yielding_parameters{
    Parameter{.name = "interference_ratio",
              .meaning = "x = ω/ω_c, interference over that at first yield; at most 110",
              .least = 1e-3,
              .greatest = 100}};
constexpr std::array yielding_results{Result{"value", "F/F_c, load over that at first yield"}};
std::optional<Refusal> beyond_kogut_etsion(const Arguments& x) {
  if (x[0] <= greatest_kogut_etsion_interference) return std::nullopt;
  return Refusal{"interference_ratio", "the fit ends at 110, where the summit is fully plastic"};
}

constexpr std::array persson_parameters{
    Parameter{.name = "pressure",
              .meaning = "p, the load over the nominal area",
              .unit = "Pa",
              .range = Range::not_below_zero,
              .least = 1,
              .greatest = 1e10},
    effective_modulus,
    Parameter{.name = "rms_gradient",
              .meaning = "h′, root mean square of the gradient of the gap, √2 times that of a "
                         "profile's slope",
              .least = 1e-4,
              .greatest = 2}};
constexpr std::array persson_combinations{
    Combination{.name = "relative_pressure",
                .meaning = "p/(E*h′)",
                .least = 1e-9,
                .greatest = 1.5,
                .value = [](const Arguments& x) { return x[0] / (x[1] * x[2]); },
                .parameter = "pressure"}};
constexpr std::array persson_results{Result{"value", "A/A₀, part of the nominal area in contact"}};

constexpr std::array flow_parameters{
    Parameter{.name = "film_ratio",
              .meaning = "H = h/σ, nominal film over the composite rms roughness; from 0.5 on",
              .least = 0.5,
              .greatest = 20}};
constexpr std::array flow_results{
    Result{"value", "φ, flow by pressure over that between smooth faces"}};

constexpr Parameter rms_roughness(std::string_view name, std::string_view meaning) {
  return {.name = name, .meaning = meaning, .unit = "m", .least = 1e-10, .greatest = 1e-4};
}
constexpr std::array lambda_parameters{
    Parameter{.name = "minimum_film",
              .meaning = "h_min, the least film",
              .unit = "m",
              .least = 1e-10,
              .greatest = 1e-3},
    rms_roughness("first_roughness", "Rq₁, of the first face"),
    rms_roughness("second_roughness", "Rq₂, of the second face")};
constexpr std::array lambda_results{Result{"composite_roughness", "Rq, of both faces", "m"},
                                    Result{"lambda_ratio", "Λ"}};

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
    Function{.name = "plasticity_index",
             .meaning = "plasticity index of a rough contact",
             .equation = "ψ = (E*/H) √(σ_s/β)",
             .source = "J. A. Greenwood, J. B. P. Williamson: Contact of nominally flat surfaces. "
                       "Proc. R. Soc. Lond. A 295 (1966) 300",
             .parameters = plasticity_parameters,
             .results = plasticity_results,
             .value = [](const Arguments& x,
                         Results& y) { y[0] = tribo::plasticity_index(x[0], x[1], x[2], x[3]); },
             .contract = plasticity_index_contract,
             .example = {1.1e11, 3e9, 1e-7, 5e-5}},
    Function{.name = "kogut_etsion_load",
             .meaning = "load on a summit that yields, over that at first yield",
             .equation = "F/F_c = x^1.5 for x < 1, 1.03 x^1.425 to 6, 1.40 x^1.263 to 110",
             .source = "L. Kogut, I. Etsion: Elastic-plastic contact analysis of a sphere and a "
                       "rigid flat. J. Appl. Mech. 69 (2002) 657, doi 10.1115/1.1490373; elastic "
                       "below 1 by Hertz",
             .parameters = yielding_parameters,
             .results = yielding_results,
             .value = [](const Arguments& x, Results& y) { y[0] = tribo::kogut_etsion_load(x[0]); },
             .contract = kogut_etsion_contract,
             .example = {10},
             .refusal = beyond_kogut_etsion},
    Function{.name = "persson_contact_area",
             .meaning = "part of the nominal area where rough elastic faces touch",
             .equation = "A/A₀ = erf(√2 p/(E*h′))",
             .source = "B. N. J. Persson: Theory of rubber friction and contact mechanics. J. "
                       "Chem. Phys. 115 (2001) 3840, doi 10.1063/1.1388626; in this form, with "
                       "the variance (E*h′/2)² of the pressure, by W. Manners, J. A. Greenwood: "
                       "Wear 261 (2006) 600",
             .parameters = persson_parameters,
             .results = persson_results,
             .value = [](const Arguments& x,
                         Results& y) { y[0] = tribo::persson_contact_area(x[0], x[1], x[2]); },
             .contract = persson_contract,
             .example = {1e7, 1e9, 0.1},
             .combinations = persson_combinations},
    Function{.name = "patir_cheng_pressure_flow",
             .meaning = "pressure flow factor of faces with isotropic roughness",
             .equation = "φ = 1 − 0.90 e^(−0.56H)",
             .source = "N. Patir, H. S. Cheng: An average flow model for determining effects of "
                       "three-dimensional roughness on partial hydrodynamic lubrication. J. Lubr. "
                       "Technol. 100 (1978) 12, doi 10.1115/1.3453103; the row of γ = 1",
             .parameters = flow_parameters,
             .results = flow_results,
             .value = [](const Arguments& x,
                         Results& y) { y[0] = tribo::patir_cheng_pressure_flow(x[0]); },
             .contract = patir_cheng_contract,
             .example = {2}},
    Function{.name = "lambda_ratio",
             .meaning = "composite roughness of two faces, and the least film over it",
             .equation = "Rq = √(Rq₁² + Rq₂²), Λ = h_min/Rq",
             .source = "T. E. Tallian: On competing failure modes in rolling contact. ASLE Trans. "
                       "10 (1967) 418; of faces whose heights do not depend on each other",
             .parameters = lambda_parameters,
             .results = lambda_results,
             .value =
                 [](const Arguments& x, Results& y) {
                   y[0] = tribo::composite_roughness(x[1], x[2]);
                   y[1] = x[0] / y[0];
                 },
             .contract = lambda_ratio_contract,
             .example = {3e-7, 2e-7, 1e-7}},
};

}  // namespace

std::span<const Function> surfaces() { return entries; }

}  // namespace tribo::catalogue
