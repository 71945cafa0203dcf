// SPDX-License-Identifier: Apache-2.0
// Asperities and film together.
#include "tribo/load_sharing.hpp"

#include "catalogue/families.hpp"
#include "catalogue/parameters.hpp"
#include "tribo/batch.hpp"
#include "tribo/scene.hpp"

namespace tribo::catalogue {
namespace {

constexpr std::array sharing_parameters{
    Parameter{
        .name = "asperity", .meaning = "model of the rough contact", .words = asperity_model_words},
    Parameter{
        .name = "flooded_film_parameter", .meaning = "λ₀ = h₀/σ_s", .least = 1e-4, .greatest = 1e3},
    Parameter{.name = "stiffness",
              .meaning = "K of A = (K F_p(λ−δ))^q",
              .range = Range::not_below_zero,
              .greatest = 1e6},
    Parameter{.name = "offset",
              .meaning = "δ, mean plane to the plane of summits, over σ_s",
              .range = Range::not_below_zero,
              .greatest = 10}};
constexpr std::array sharing_results{Result{"value", "λ = h/σ_s"}};

constexpr std::array entries{
    Function{
        .name = "load_sharing",
        .meaning = "film parameter at which asperities and film carry the load together",
        .equation = "λ = λ₀ (1−A)^−0.14, A = (K F_p(λ−δ))^q, (p, q) = (5/2, 1/2) of "
                    "greenwood_tripp, (3/2, 1) of greenwood_williamson",
        .source =
            "K. L. Johnson, J. A. Greenwood, S. Y. Poon: A simple theory of asperity contact in "
            "elastohydrodynamic lubrication. Wear 19 (1972) 91, doi 10.1016/0043-1648(72)90445-0",
        .parameters = sharing_parameters,
        .results = sharing_results,
        .value =
            [](const Arguments& x, Results& y) {
              const LoadSharing<double> sharing(enum_at<AsperityModel>(x[0]), x[2], x[3]);
              y[0] = sharing.solve(x[1]).film_parameter;
            },
        .contract = load_sharing_contract,
        .example = {0, 0.5, 20, 1.146},
        .values =
            [](std::size_t count, const Column* x, double* const* y) {
              for_each_run(x[0], count, [&](std::size_t first, std::size_t length) {
                const auto part = [&](std::size_t k) {
                  return std::span(x[k].numbers + first, length);
                };
                film_parameter(enum_at<AsperityModel>(x[0].numbers[first]), part(2), part(3),
                               part(1), std::span(y[0] + first, length));
              });
            }},
};

}  // namespace

std::span<const Function> load_sharing_rules() { return entries; }

}  // namespace tribo::catalogue
