// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "conformance/mistake.hpp"
#include "tribo/hertz.hpp"

namespace tribo::conformance {
namespace {

using nlohmann::json;
using Value = std::optional<double>;
constexpr double pi = std::numbers::pi;

double number(const json& inputs, const char* name) { return inputs.at(name).get<double>(); }

template <class Wrong>
Mistake hertz(std::string name, std::string text, Wrong&& wrong) {
  return {"hertz_point", std::move(name), std::move(text),
          [wrong](const json& in, std::string_view field) -> Value {
            const HertzPoint<double> point = wrong(
                number(in, "load"), number(in, "effective_modulus"), number(in, "reduced_radius"));
            return field == "radius"          ? point.radius
                   : field == "mean_pressure" ? point.mean_pressure
                   : field == "peak_pressure" ? point.peak_pressure
                                              : point.approach;
          }};
}

}  // namespace

std::vector<Mistake> hertz_mistakes() {
  using Point = HertzPoint<double>;
  return {
      hertz("hertz-radius-halved", "R/2 in place of R (a ball on a flat has the ball's radius)",
            [](double f, double e, double r) { return hertz_point(f, e, r / 2); }),
      hertz("hertz-radius-doubled", "2R in place of R",
            [](double f, double e, double r) { return hertz_point(f, e, 2 * r); }),
      hertz("hertz-2E*", "2E* in place of E* (E′ of the film formulas is 2E*)",
            [](double f, double e, double r) { return hertz_point(f, 2 * e, r); }),
      hertz("hertz-E*-halved", "E*/2 in place of E*",
            [](double f, double e, double r) { return hertz_point(f, e / 2, r); }),
      hertz("hertz-area-without-pi", "A = a² in place of πa²",
            [](double f, double e, double r) {
              Point p = hertz_point(f, e, r);
              p.mean_pressure *= pi;
              p.peak_pressure *= pi;
              return p;
            }),
      hertz("hertz-peak-is-mean", "the peak pressure without its 3/2",
            [](double f, double e, double r) {
              Point p = hertz_point(f, e, r);
              p.peak_pressure = p.mean_pressure;
              return p;
            }),
      hertz("hertz-diameter", "the contact's diameter in place of its radius",
            [](double f, double e, double r) {
              Point p = hertz_point(f, e, r);
              p.radius *= 2;
              return p;
            }),
      hertz("hertz-approach-2E*", "2E* in place of E* in the approach alone",
            [](double f, double e, double r) {
              Point p = hertz_point(f, e, r);
              p.approach = hertz_point(f, 2 * e, r).approach;
              return p;
            }),
      hertz("hertz-approach-halved", "a²/(2R), the gap's geometry, in place of the approach a²/R",
            [](double f, double e, double r) {
              Point p = hertz_point(f, e, r);
              p.approach /= 2;
              return p;
            }),
      hertz("hertz-R-in-mm", "R in mm in place of m",
            [](double f, double e, double r) { return hertz_point(f, e, 1e3 * r); })};
}

}  // namespace tribo::conformance
