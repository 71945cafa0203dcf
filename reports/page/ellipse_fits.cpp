// SPDX-License-Identifier: Apache-2.0
// How far off the published fits to Hertz' ellipse are, over the ratio of the radii. The fits are
// those of reference/mistakes.toml.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/mistake.hpp"
#include "page/facts.hpp"
#include "page/texts.hpp"
#include "tribo/hertz_ellipse.hpp"

namespace tribo::report {
namespace {

constexpr double greatest_ratio = 1e4, moderate_ratio = 10;
constexpr int ratio_steps = 320;  // steps of α, even in its logarithm

struct FittedResult {
  std::string_view name;
  std::size_t place;  // index in the catalogue's results
};
constexpr std::array<FittedResult, 4> fitted_results{
    {{"ellipticity", 2}, {"semi_axis_x", 0}, {"peak_pressure", 4}, {"approach", 5}}};

// Fits of k with fits of the integrals; those with the integrals of this k are named …-of-k.
bool is_fit(const conformance::Mistake& mistake) {
  return mistake.function == "hertz_ellipse" && mistake.name.starts_with("ellipse-fit-") &&
         !mistake.name.ends_with("-of-k");
}

// "k = 1.0339 α^0.636" of its text.
std::string formula_of(const conformance::Mistake& fit) {
  const std::size_t from = fit.text.find("k = ");
  if (from == std::string::npos) return fit.name;
  const std::size_t to = std::min(fit.text.find(", ", from), fit.text.find(" in place", from));
  return fit.text.substr(from, to - from);
}

// (got − exact)/exact of each quantity at R_y/R_x.
std::array<double, fitted_results.size()> errors_at(const conformance::Mistake& fit, double ratio) {
  constexpr double load = 50, modulus = 107.9e9, radius = 9.5e-3;
  conformance::Question question{};
  question.arguments = {load, modulus, radius, radius * ratio};
  const auto got = fit.instead(question);
  if (!got) throw std::runtime_error(fit.name + " says nothing of some ellipse");
  const HertzEllipse<double> exact = hertz_ellipse(load, modulus, radius, radius * ratio);
  const std::array expected{exact.semi_axis_x,   exact.semi_axis_y,   exact.ellipticity,
                            exact.mean_pressure, exact.peak_pressure, exact.approach};
  std::array<double, fitted_results.size()> errors{};
  for (std::size_t i = 0; i < errors.size(); ++i)
    errors[i] = (*got)[fitted_results[i].place] / expected[fitted_results[i].place] - 1;
  return errors;
}

}  // namespace

Json ellipse_fits_facts(const ReportPlaces& places) {
  Json data{{"greatest_ratio", greatest_ratio},
            {"moderate_ratio", moderate_ratio},
            {"fits", Json::array()}};
  std::string text =
      "# relative errors of fits to Hertz' ellipse, each a block\n# "
      "R_y/R_x\tellipticity\tsemi-axis "
      "a_x\tpeak pressure\tapproach\n";
  for (const conformance::Mistake& fit :
       conformance::read_mistakes((places.reference / "mistakes.toml").string())) {
    if (!is_fit(fit)) continue;
    const std::string name = formula_of(fit);
    text += (data["fits"].empty() ? "\"" : "\n\n\"") + name + "\"\n";
    Json greatest = Json::object(), moderate = Json::object();
    for (int step = 0; step <= ratio_steps; ++step) {
      const double ratio = std::pow(greatest_ratio, static_cast<double>(step) / ratio_steps);
      const auto errors = errors_at(fit, ratio);
      text += exact(ratio);
      for (std::size_t i = 0; i < errors.size(); ++i) {
        text += "\t" + exact(errors[i]);
        const std::string quantity(fitted_results[i].name);
        const auto add = [&](Json& to) {
          to[quantity] = std::max(to.value(quantity, 0.0), std::abs(errors[i]));
        };
        add(greatest);
        if (ratio <= moderate_ratio) add(moderate);
      }
      text += "\n";
    }
    data["fits"].push_back(
        {{"name", name}, {"text", fit.text}, {"greatest", greatest}, {"moderate", moderate}});
  }
  if (data["fits"].empty())
    throw std::runtime_error("reference/mistakes.toml has no fits to Hertz' ellipse");
  return {{"data", std::move(data)},
          {"files", {{"data/ellipse_fits.blocks.tsv", std::move(text)}}}};
}

}  // namespace tribo::report
