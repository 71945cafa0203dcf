// SPDX-License-Identifier: Apache-2.0
// tribocheck's own model as a plug-in. It has to get the same verdicts as `tribocheck stream`.
#include <cmath>
#include <limits>
#include <span>

#include "catalogue/columns.hpp"
#include "conformance/plugin_scene.hpp"
#include "conformance/tribocheck_plugin.h"
#include "tribo/operating_points.hpp"

namespace {

using namespace tribo;

constexpr double none = std::numeric_limits<double>::infinity();
constexpr double nothing_said = std::numeric_limits<double>::quiet_NaN();

double or_undefined(double number) { return std::isfinite(number) ? number : none; }

template <class Word>
int code(Word word, double rests_on) {
  return std::isfinite(rests_on) ? static_cast<int>(word) : int{TRIBOCHECK_UNDEFINED_CODE};
}

tribocheck_point plugin_point(const OperatingPoint<double>& point) {
  const bool has_collapsed = point.regime == Regime::collapsed;
  const auto numbers = numbers_of(point);
  tribocheck_point result;
  for (size_t i = 0; i < number_count; ++i)
    result.*conformance::plugin_numbers[i] =
        has_collapsed && balance_outputs().contains(static_cast<Output>(i))
            ? nothing_said
            : or_undefined(numbers[i]);
  result.regime =
      code(point.regime,
           has_collapsed ? point.film : point.asperity_load_share + point.fluid_load_share);
  result.inlet = code(point.inlet, point.film);
  return result;
}

}  // namespace

int tribocheck_plugin_version() { return TRIBOCHECK_PLUGIN_VERSION; }

const char* tribocheck_plugin_name() { return "own model"; }

int tribocheck_function(const char* name, size_t count, const double* const* argument,
                        double* const* result, int* status) {
  const catalogue::Function* const function = catalogue::function_named(name);
  if (function == nullptr) return 0;
  catalogue::values_at(*function, count, argument, nullptr, result, status);
  return 1;
}

void tribocheck_operating_point(const tribocheck_scene* scene, size_t count, const double* speed,
                                tribocheck_point* point, int* status) {
  const Scene own = conformance::model_scene(*scene);
  OutputSet outputs = OutputSet::all();
  if (!has_friction_inputs(own)) outputs.erase(Output::friction);
  OperatingPoints points;
  points.resize(count, outputs);
  solve(MixedContact<double>(own), std::span(speed, count), outputs, points);
  for (size_t i = 0; i < count; ++i) {
    point[i] = plugin_point(points[i]);
    status[i] = TRIBOCHECK_DONE;
  }
}
