// SPDX-License-Identifier: Apache-2.0
// tribocheck's own model, registered as anybody's: what it scores here, `tribocheck verify` has to
// find without it.
#include <cmath>

#include "conformance/serve.hpp"
#include "tribo/film_thickness.hpp"
#include "tribo/gaussian_moment.hpp"
#include "tribo/hertz.hpp"
#include "tribo/load_sharing.hpp"
#include "tribo/operating_points.hpp"
#include "tribo/starvation.hpp"

namespace {

using namespace tribo;
using namespace tribo::conformance;

double or_undefined(double number) { return std::isfinite(number) ? number : undefined_here; }

double moment(const MomentCase& asked) {
  const auto order = static_cast<Order>(static_cast<int>(2 * asked.order));
  return or_undefined(gaussian_moment(order, asked.argument));
}

HertzResult hertz(const HertzCase& asked) {
  const HertzPoint<double> point =
      tribo::hertz_point(asked.load, asked.effective_modulus, asked.reduced_radius);
  return {or_undefined(point.radius), or_undefined(point.mean_pressure),
          or_undefined(point.peak_pressure), or_undefined(point.approach)};
}

double film(const FilmCase& asked) {
  return or_undefined(tribo::hamrock_dowson_central(
      asked.speed, asked.viscosity, asked.pressure_viscosity, asked.load, asked.effective_modulus,
      asked.reduced_radius, asked.ellipticity));
}

double film_ratio(const StarvationCase& asked) {
  return or_undefined(
      tribo::starvation_ratio(asked.closure, asked.flooded_over_inlet, asked.damiens_exponent));
}

double shared_film(const SharingCase& asked) {
  const LoadSharing<double> sharing(asked.asperity, asked.stiffness, asked.offset);
  return or_undefined(sharing.solve(asked.flooded_film_parameter).film_parameter);
}

template <class Word>
WordResult<Word> word(Word word, double rests_on) {
  WordResult<Word> result = word;
  if (!std::isfinite(rests_on)) result.kind = WordResult<Word>::Kind::undefined;
  return result;
}

PointResult operating_point(const Scene& scene) {
  OutputSet outputs = OutputSet::all();
  if (!has_friction_inputs(scene)) outputs.erase(Output::friction);
  const OperatingPoint<double> point = MixedContact<double>(scene).solve(scene.speeds[0], outputs);
  return {or_undefined(point.film_flooded),
          or_undefined(point.film),
          or_undefined(point.separation),
          or_undefined(point.film_parameter),
          or_undefined(point.asperity_load_share),
          or_undefined(point.fluid_load_share),
          or_undefined(point.real_area_ratio),
          or_undefined(point.summit_count),
          point.friction_undefined ? undefined_here : or_undefined(point.friction),
          word(point.regime, point.asperity_load_share + point.fluid_load_share),
          word(point.inlet, point.film)};
}

}  // namespace

int main() {
  return serve({each(moment), each(hertz), each(film), each(film_ratio), each(shared_film),
                each(operating_point)});
}
