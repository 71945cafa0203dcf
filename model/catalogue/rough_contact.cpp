// SPDX-License-Identifier: Apache-2.0
// Rough contact.
#include "catalogue/families.hpp"
#include "catalogue/parameters.hpp"
#include "tribo/batch.hpp"
#include "tribo/gaussian_moment.hpp"

namespace tribo::catalogue {
namespace {

constexpr std::array moment_parameters{
    Parameter{.name = "order", .meaning = "n", .range = Range::half_order, .greatest = 2.5},
    Parameter{.name = "argument",
              .meaning = "d, separation less offset, over the sd of summit heights",
              .range = Range::any,
              .least = -10,
              .greatest = 10}};
constexpr std::array moment_results{Result{"value", "F_n(d)"}};

constexpr std::array entries{
    Function{.name = "gaussian_moment",
             .meaning = "moment of the Gaussian tail, for load, area and count of a rough contact",
             .equation = "F_n(d) = ∫ (s−d)ⁿ e^(−s²/2)/√(2π) ds from d to ∞",
             .source =
                 "J. A. Greenwood, J. H. Tripp: The contact of two nominally flat rough surfaces. "
                 "Proc. Inst. Mech. Eng. 185 (1970) 625, doi 10.1243/PIME_PROC_1970_185_069_02",
             .parameters = moment_parameters,
             .results = moment_results,
             .value = [](const Arguments& x,
                         Results& y) { y[0] = gaussian_moment(enum_at<Order>(2 * x[0]), x[1]); },
             .contract = gaussian_moment_contract,
             .example = {2.5, -1.146},
             .values =
                 [](std::size_t count, const Column* x, double* const* y) {
                   for_each_run(x[0], count, [&](std::size_t first, std::size_t length) {
                     gaussian_moment(enum_at<Order>(2 * x[0].numbers[first]),
                                     std::span(x[1].numbers + first, length),
                                     std::span(y[0] + first, length));
                   });
                 }},
};

}  // namespace

std::span<const Function> rough_contact() { return entries; }

}  // namespace tribo::catalogue
