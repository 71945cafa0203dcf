// SPDX-License-Identifier: Apache-2.0
#include "contenders/plugin_way.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "cases/errors.hpp"
#include "conformance/plugin_scene.hpp"

namespace tribo::benchmarks {
namespace {

using conformance::Plugin;
using conformance::PluginFunctions;

constexpr const char* family = "plugin";
constexpr int unset = -1;
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double slow = 5e-6;  // seconds per case; a slower contender is timed on fewer cases

// The number that is judged, as in `verify`: not_offered if the status says so, `value` if it is
// finite and the status is TRIBOCHECK_DONE, and otherwise NaN.
double answer_of(int status, double value) {
  if (status == TRIBOCHECK_NOT_OFFERED) return not_offered;
  return status == TRIBOCHECK_DONE && std::isfinite(value) ? value : no_number;
}

// The time of the second of two calls, because a library may set itself up in the first one.
template <class Call>
double seconds_of(Call&& call) {
  call();
  const auto start = std::chrono::steady_clock::now();
  call();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Arrays that are kept between calls, so that the timed call allocates nothing: `shared` has, for
// each case, the argument that is the same in all cases, and `status` has the status of each case.
struct Room {
  std::vector<double> shared;
  std::vector<int> status;
};

// Calls a function of the plug-in for all cases of its arguments. Returns false if the plug-in does
// not offer the function.
bool ask(const PluginFunctions& functions, const char* function,
         std::span<const double* const> arguments, std::span<double> values,
         std::vector<int>& status) {
  status.assign(values.size(), unset);
  std::fill(values.begin(), values.end(), no_number);
  double* const to = values.data();
  const bool is_offered =
      functions.function(function, values.size(), arguments.data(), &to, status.data()) != 0;
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = answer_of(status[i], values[i]);
  return is_offered;
}

bool ask_moments(const PluginFunctions& functions, Order order, std::span<const double> d,
                 std::span<double> moments, Room& room) {
  room.shared.resize(d.size(), value_of<double>(order));
  return ask(functions, "gaussian_moment", std::array{std::as_const(room.shared).data(), d.data()},
             moments, room.status);
}

MomentBatch moment_batch(const PluginFunctions& functions, Order order) {
  return
      [=, room = std::make_shared<Room>()](std::span<const double> d, std::span<double> moments) {
        ask_moments(functions, order, d, moments, *room);
      };
}

bool offers(const PluginFunctions& functions, Order order) {
  if (functions.function == nullptr) return false;
  const double d = 0.5;
  double value = no_number;
  Room room;
  return ask_moments(functions, order, {&d, 1}, {&value, 1}, room) && value != not_offered;
}

bool ask_roots(const PluginFunctions& functions, const RootCases& cases, std::span<double> film,
               Room& room) {
  room.shared.resize(cases.size(), TRIBOCHECK_GREENWOOD_TRIPP);
  return ask(functions, "load_sharing",
             std::array{std::as_const(room.shared).data(), cases.flooded.data(),
                        cases.stiffness.data(), cases.offset.data()},
             film, room.status);
}

RootRun root_run(const PluginFunctions& functions) {
  return [=, room = std::make_shared<Room>()](const RootCases& cases, std::span<double> film) {
    ask_roots(functions, cases, film, *room);
  };
}

RootCases ordinary_root() {
  static constexpr double flooded = 1, stiffness = 0.3, offset = 1.146;
  return {{&stiffness, 1}, {&offset, 1}, {&flooded, 1}};
}

bool offers_roots(const PluginFunctions& functions) {
  if (functions.function == nullptr) return false;
  double film = no_number;
  Room room;
  return ask_roots(functions, ordinary_root(), {&film, 1}, room) && film != not_offered;
}

double seconds_of_root(const RootRun& run) {
  double film = no_number;
  return seconds_of([&] { run(ordinary_root(), {&film, 1}); });
}

struct PointRoom {
  std::vector<tribocheck_point> points;
  std::vector<int> status;
};

void solve_points(const PluginFunctions& functions, PointRoom& room, const Scene& scene,
                  std::span<const double> speeds, OperatingPoints& points) {
  const tribocheck_scene given = conformance::plugin_scene(scene);
  room.points.assign(speeds.size(), conformance::empty_point());
  room.status.assign(speeds.size(), unset);
  functions.operating_point(&given, speeds.size(), speeds.data(), room.points.data(),
                            room.status.data());
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    const tribocheck_point& point = room.points[i];
    points.speed[i] = speeds[i];
    points.film[i] = answer_of(room.status[i], point.film);
    points.asperity_load_share[i] = point.asperity_load_share;
    points.friction[i] = point.friction;
  }
}

// A scene that is not starved, with a film of about the height of the roughness.
Scene ordinary_scene() {
  Scene scene;
  scene.load = 50;
  scene.surface = {5e10, 1e-5, 1e-7, 1.146, 1};
  scene.bodies = {107.9e9, 9.5e-3, 1};
  scene.lubricant = {0.0202, 2e-8, 2.5e6};
  scene.friction.boundary_coefficient = 0.13;
  return scene;
}

bool offers_points(const PluginFunctions& functions) {
  if (functions.operating_point == nullptr) return false;
  const tribocheck_scene scene = conformance::plugin_scene(ordinary_scene());
  const double speed = 0.1;
  tribocheck_point point = conformance::empty_point();
  int status = unset;
  functions.operating_point(&scene, 1, &speed, &point, &status);
  return status == TRIBOCHECK_DONE &&
         !std::isnan(point.film + point.asperity_load_share + point.friction);
}

}  // namespace

std::vector<MomentContender> plugin_moments(const Plugin& plugin) {
  std::vector<MomentContender> all;
  for (const Order order : {Order::five_halves, Order::two})
    if (offers(plugin.functions, order))
      all.push_back({family, plugin.name, order, moment_batch(plugin.functions, order)});
  return all;
}

std::vector<RootContender> plugin_roots(const Plugin& plugin) {
  if (!offers_roots(plugin.functions)) return {};
  const RootRun run = root_run(plugin.functions);
  return {{family,
           plugin.name,
           [run](const RootCases&) { return run; },
           {},
           seconds_of_root(run) > slow}};
}

std::vector<CurveContender> plugin_curves(const Plugin& plugin) {
  if (!offers_points(plugin.functions)) return {};
  const auto room = std::make_shared<PointRoom>();
  const auto run = [=, functions = plugin.functions](const Scene& scene,
                                                     std::span<const double> speeds,
                                                     OperatingPoints& points) {
    solve_points(functions, *room, scene, speeds, points);
  };
  OperatingPoints one;
  one.resize(1, curve_outputs());
  const double speed = 0.1;
  const double seconds = seconds_of([&] { run(ordinary_scene(), {&speed, 1}, one); });
  return {{family, plugin.name, run, seconds > slow}};
}

}  // namespace tribo::benchmarks
