// SPDX-License-Identifier: Apache-2.0
// tribocheck's own model, registered as any solver may be. It has to get the same verdicts as
// `tribocheck stream`.
#include <algorithm>
#include <cmath>

#include "conformance/serve.hpp"
#include "tribo/operating_points.hpp"

namespace {

using namespace tribo;
using namespace tribo::conformance;

double or_undefined(double number) { return std::isfinite(number) ? number : undefined_here; }

// Answers a function of the catalogue by the catalogue's own value.
FunctionBatch batch_of(const catalogue::Function& function) {
  return each([&function](const catalogue::Arguments& arguments) {
    catalogue::Results results{};
    function.value(arguments, results);
    for (double& result : results) result = or_undefined(result);
    return results;
  });
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
  const auto numbers = numbers_of(point);
  const double shares = point.asperity_load_share + point.fluid_load_share;
  PointResult result;
  std::transform(numbers.begin(), numbers.end(), result.numbers.begin(), or_undefined);
  result.regime = word(point.regime, point.regime == Regime::collapsed ? point.film : shares);
  result.inlet = word(point.inlet, point.film);
  return result;
}

}  // namespace

int main() {
  Solver solver;
  for (const catalogue::Function& function : catalogue::functions())
    solver.offer_batch(function.name, batch_of(function));
  solver.operating_point = each(operating_point);
  return serve(solver);
}
