// SPDX-License-Identifier: Apache-2.0
// Smooth elastic contact.
#include "catalogue/families.hpp"
#include "catalogue/parameters.hpp"
#include "tribo/adhesion.hpp"
#include "tribo/hertz.hpp"
#include "tribo/hertz_ellipse.hpp"
#include "tribo/hertz_line.hpp"
#include "tribo/subsurface_shear.hpp"

namespace tribo::catalogue {
namespace {

constexpr std::array hertz_parameters{load, effective_modulus, reduced_radius};
constexpr std::array hertz_results{Result{"radius", "a of the circle of contact", "m"},
                                   Result{"mean_pressure", "F/(πa²)", "Pa"},
                                   Result{"peak_pressure", "3/2 of the mean pressure", "Pa"},
                                   Result{"approach", "a²/R, of the two bodies", "m"}};

constexpr std::array ellipse_parameters{load, effective_modulus, radius_x, radius_y};
constexpr std::array ellipse_results{
    Result{"semi_axis_x", "a_x of the ellipse of contact, along the direction of entrainment", "m"},
    Result{"semi_axis_y", "a_y, across it", "m"},
    Result{"ellipticity", "k = a_y/a_x, below 1 where R_y < R_x"},
    Result{"mean_pressure", "F/(πa_xa_y)", "Pa"},
    Result{"peak_pressure", "3/2 of the mean pressure", "Pa"},
    Result{"approach", "of the two bodies", "m"}};

constexpr std::array line_parameters{
    load_per_length, effective_modulus,
    Parameter{.name = "reduced_radius",
              .meaning = "R, 1/R = 1/R₁ + 1/R₂, of a roller on a flat the roller's radius",
              .unit = "m",
              .least = tribo::catalogue::reduced_radius.least,
              .greatest = tribo::catalogue::reduced_radius.greatest}};
constexpr std::array line_results{
    Result{"half_width", "b, half of the strip's width", "m"},
    Result{"mean_pressure", "F/(2bL)", "Pa"},
    Result{"peak_pressure", "p₀ = 2F/(πbL), 4/π of the mean pressure", "Pa"},
    Result{"peak_shear", "0.300283 p₀, the greatest shear stress, 0.786 b below the surface",
           "Pa"}};

constexpr std::array ellipse_combinations{
    Combination{.name = "radius_ratio",
                .meaning = "R_y/R_x",
                .least = 1e-4,
                .greatest = 1e4,
                .value = [](const Arguments& x) { return x[3] / x[2]; },
                .parameter = "radius_y"}};
constexpr std::array shear_parameters{Parameter{.name = "peak_pressure",
                                                .meaning = "p₀, of Hertz",
                                                .unit = "Pa",
                                                .least = 1e4,
                                                .greatest = 2e10},
                                      Parameter{.name = "radius",
                                                .meaning = "a, of the circle of contact",
                                                .unit = "m",
                                                .least = 1e-8,
                                                .greatest = 0.1},
                                      Parameter{.name = "depth",
                                                .meaning = "z, below the surface, on the axis",
                                                .unit = "m",
                                                .range = Range::not_below_zero,
                                                .greatest = 1},
                                      Parameter{.name = "poisson_ratio",
                                                .meaning = "ν, of the body",
                                                .range = Range::poisson_ratio,
                                                .greatest = 0.5}};
constexpr std::array shear_combinations{
    Combination{.name = "relative_depth",
                .meaning = "z/a",
                .greatest = 10,
                .value = [](const Arguments& x) { return x[2] / x[1]; },
                .parameter = "depth"}};
constexpr std::array shear_results{
    Result{"value", "τ, the greatest shear stress there, (σ_r − σ_z)/2", "Pa"}};

constexpr Parameter work_of_adhesion{.name = "work_of_adhesion",
                                     .meaning = "w, of both faces: γ₁ + γ₂ − γ₁₂",
                                     .unit = "J/m²",
                                     .least = 1e-4,
                                     .greatest = 10};
constexpr Parameter tip_radius{.name = "reduced_radius",
                               .meaning = tribo::catalogue::reduced_radius.meaning,
                               .unit = "m",
                               .least = 1e-9,
                               .greatest = tribo::catalogue::reduced_radius.greatest};
constexpr std::array jkr_parameters{Parameter{.name = "load",
                                              .meaning = "F, below 0 where it pulls",
                                              .unit = "N",
                                              .range = Range::any,
                                              .least = -10,
                                              .greatest = 1e6},
                                    work_of_adhesion, effective_modulus, tip_radius};
constexpr std::array jkr_combinations{
    Combination{.name = "relative_load",
                .meaning = "F/(πwR)",
                .least = -1.5,
                .greatest = 1e6,
                .value = [](const Arguments& x) { return x[0] / (pi<double>() * x[1] * x[3]); },
                .parameter = "load"}};
constexpr std::array jkr_results{Result{"value", "a, radius of the circle of contact", "m"}};
std::optional<Refusal> has_parted(const Arguments& x) {
  if (2 * x[0] + 3 * pi<double>() * x[1] * x[3] >= 0) return std::nullopt;
  return Refusal{"load",
                 "the bodies have parted: they can be pulled with at most (3/2)πwR, so that load "
                 "has to be -4.712 work_of_adhesion reduced_radius or more"};
}
constexpr std::array pull_off_parameters{
    Parameter{.name = "adhesion", .meaning = "theory", .words = adhesion_words}, work_of_adhesion,
    tip_radius};
constexpr std::array pull_off_results{
    Result{"value", "the tensile force that parts the bodies, above 0", "N"}};

constexpr std::array entries{
    Function{.name = "hertz_point",
             .meaning = "circular contact of two smooth elastic bodies",
             .equation = "a³ = 3FR/(4E*)",
             .source = "H. Hertz: Über die Berührung fester elastischer Körper. J. reine angew. "
                       "Math. 92 (1881) 156; K. L. Johnson: Contact Mechanics (1985), section 4.2",
             .parameters = hertz_parameters,
             .results = hertz_results,
             .value =
                 [](const Arguments& x, Results& y) {
                   const HertzPoint<double> hertz = hertz_point(x[0], x[1], x[2]);
                   y = {hertz.radius, hertz.mean_pressure, hertz.peak_pressure, hertz.approach};
                 },
             .contract = hertz_contract,
             .example = {50, 107.9e9, 9.5e-3}},
    Function{.name = "hertz_ellipse",
             .meaning = "elliptical contact of two smooth elastic bodies",
             .equation = "α = R_y/R_x = (k²E − K)/(K − E), K and E complete elliptic integrals of "
                         "parameter 1 − 1/k² (of modulus √(1 − 1/k²)); 1/R = 1/R_x + 1/R_y; a_x³ = "
                         "3EFR/(πkE*), a_y = ka_x, approach a_x²K/(2RE); for R_y < R_x with x and "
                         "y exchanged",
             .source = "H. Hertz: Über die Berührung fester elastischer Körper. J. reine angew. "
                       "Math. 92 (1881) 156; K. L. Johnson: Contact Mechanics (1985), section "
                       "4.2(c)",
             .parameters = ellipse_parameters,
             .results = ellipse_results,
             .value =
                 [](const Arguments& x, Results& y) {
                   const HertzEllipse<double> hertz = hertz_ellipse(x[0], x[1], x[2], x[3]);
                   y = {hertz.semi_axis_x,   hertz.semi_axis_y,   hertz.ellipticity,
                        hertz.mean_pressure, hertz.peak_pressure, hertz.approach};
                 },
             .contract = hertz_ellipse_contract,
             .example = {50, 107.9e9, 9.5e-3, 19e-3},
             .combinations = ellipse_combinations},
    Function{
        .name = "hertz_line",
        .meaning = "line contact of two smooth elastic cylinders",
        .equation = "b² = 4(F/L)R/(πE*)",
        .source = "H. Hertz: Über die Berührung fester elastischer Körper. J. reine angew. "
                  "Math. 92 (1881) 156; K. L. Johnson: Contact Mechanics (1985), section "
                  "4.2(c), equations 4.42 to 4.46",
        .parameters = line_parameters,
        .results = line_results,
        .value =
            [](const Arguments& x, Results& y) {
              const HertzLine<double> hertz = hertz_line(x[0], x[1], x[2]);
              y = {hertz.half_width, hertz.mean_pressure, hertz.peak_pressure, hertz.peak_shear};
            },
        .contract = hertz_line_contract,
        .example = {1e5, 107.9e9, 9.5e-3}},
    Function{
        .name = "subsurface_shear",
        .meaning = "greatest shear stress on the axis below a circular contact without friction",
        .equation = "τ = (p₀/2)|3q/2 − (1 + ν)(1 − ζ atan(1/ζ))|, q = 1/(1 + ζ²), ζ = z/a",
        .source = "K. L. Johnson: Contact Mechanics (1985), section 3.4, equations 3.45; greatest "
                  "at 0.48a, 0.31p₀, for ν = 0.3",
        .parameters = shear_parameters,
        .results = shear_results,
        .value = [](const Arguments& x,
                    Results& y) { y[0] = tribo::subsurface_shear(x[0], x[1], x[2], x[3]); },
        .contract = subsurface_shear_contract,
        .example = {1e9, 1e-4, 4.8e-5, 0.3},
        .combinations = shear_combinations},
    Function{.name = "jkr_radius",
             .meaning = "radius of the circle of contact of soft bodies that adhere",
             .equation = "a³ = 3R/(4E*) [F + 3πwR + √(6πwRF + (3πwR)²)]; refused below the "
                         "pull-off, F = −(3/2)πwR",
             .source = "K. L. Johnson, K. Kendall, A. D. Roberts: Surface energy and the contact "
                       "of elastic solids. Proc. R. Soc. Lond. A 324 (1971) 301; their K is "
                       "4E*/3",
             .parameters = jkr_parameters,
             .results = jkr_results,
             .value = [](const Arguments& x,
                         Results& y) { y[0] = tribo::jkr_radius(x[0], x[1], x[2], x[3]); },
             .contract = jkr_contract,
             .example = {1e-3, 0.05, 1e6, 0.01},
             .refusal = has_parted,
             .combinations = jkr_combinations},
    Function{.name = "pull_off_force",
             .meaning = "force that parts two bodies that adhere",
             .equation = "F = (3/2)πwR by jkr, 2πwR by dmt",
             .source = "jkr: K. L. Johnson, K. Kendall, A. D. Roberts: Surface energy and the "
                       "contact of elastic solids. Proc. R. Soc. Lond. A 324 (1971) 301; dmt: B. "
                       "V. Derjaguin, V. M. Muller, Yu. P. Toporov: Effect of contact "
                       "deformations on the adhesion of particles. J. Colloid Interface Sci. 53 "
                       "(1975) 314",
             .parameters = pull_off_parameters,
             .results = pull_off_results,
             .value =
                 [](const Arguments& x, Results& y) {
                   y[0] = tribo::pull_off_force(enum_at<Adhesion>(x[0]), x[1], x[2]);
                 },
             .contract = pull_off_contract,
             .example = {0, 0.05, 0.01}},
};

}  // namespace

std::span<const Function> smooth_contact() { return entries; }

}  // namespace tribo::catalogue
