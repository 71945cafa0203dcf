// SPDX-License-Identifier: Apache-2.0
// Films behind a starved inlet.
#include "catalogue/families.hpp"
#include "catalogue/parameters.hpp"
#include "tribo/scene.hpp"
#include "tribo/starvation.hpp"

namespace tribo::catalogue {
namespace {

constexpr std::array inlet_parameters{
    Parameter{.name = "closure",
              .meaning = "what ties the starved film to the inlet",
              .words = starvation_closure_words},
    Parameter{
        .name = "flooded_over_inlet", .meaning = "r = h_ff/h_oil", .least = 1e-3, .greatest = 1e3},
    Parameter{.name = "damiens_exponent",
              .meaning = "γ, of the closure damiens alone",
              .least = 1,
              .greatest = 6,
              .default_value = 3}};
constexpr std::array inlet_results{Result{"value", "y = h*/h_ff"}};

constexpr std::array entries{
    Function{
        .name = "starvation_ratio",
        .meaning = "film behind a starved inlet over the flooded film",
        .equation = "y = (2/π) arctan(2.7ψ), ψ from Crook's gap at h_ff (flooded_inlet) or h* "
                    "(starved_inlet); damiens: y = (1 + r^γ)^(−1/γ)",
        .source =
            "A. W. Crook: The lubrication of rollers. Phil. Trans. R. Soc. Lond. A 250 (1958) 387; "
            "P. E. Wolveridge, K. P. Baglin, J. F. Archard: The starved lubrication of "
            "cylinders in line contact. Proc. Inst. Mech. Eng. 185 (1970) 1159; B. Damiens, "
            "C. H. Venner, P. M. E. Cann, A. A. Lubrecht: Starved lubrication of elliptical "
            "EHD contacts. J. Tribol. 126 (2004) 105, doi 10.1115/1.1631020; the exponents "
            "that the paper prints are a closure of their own",
        .parameters = inlet_parameters,
        .results = inlet_results,
        .value =
            [](const Arguments& x, Results& y) {
              y[0] = starvation_ratio(enum_at<StarvationClosure>(x[0]), x[1], x[2]);
            },
        .contract = starvation_ratio_contract,
        .example = {1, 0.8, 3}},
};

}  // namespace

std::span<const Function> inlets() { return entries; }

}  // namespace tribo::catalogue
