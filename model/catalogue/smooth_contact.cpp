// SPDX-License-Identifier: Apache-2.0
// Smooth elastic contact.
#include "catalogue/families.hpp"
#include "catalogue/parameters.hpp"
#include "tribo/hertz.hpp"
#include "tribo/hertz_ellipse.hpp"
#include "tribo/hertz_line.hpp"

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
};

}  // namespace

std::span<const Function> smooth_contact() { return entries; }

}  // namespace tribo::catalogue
