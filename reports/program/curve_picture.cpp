// SPDX-License-Identifier: Apache-2.0
#include "curve_picture.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "point_writers.hpp"
#include "protocol/answers.hpp"
#include "tribo/onset.hpp"
#include "tribo/stribeck_walk.hpp"

namespace tribo::cli {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t drawn_points = 400;  // so close that a line looks smooth
constexpr Output usual_panels[] = {Output::friction, Output::film, Output::asperity_load_share};

// The values of the panels; null for an output that is undefined or that the scene does not ask
// for. `missing` gets the reason, except for a collapsed film, which has a mark in the picture.
ordered_json drawn_values(const OperatingPoint<double>& point, const SmoothContact& smooth,
                          const Scene& scene, const std::vector<Output>& panels,
                          ordered_json& missing) {
  ordered_json values = ordered_json::array();
  for (const Output output : panels) {
    values.push_back(nullptr);
    if (!scene.outputs.contains(output)) continue;
    const protocol::OutputValue value = protocol::value_of(point, &smooth, output);
    if (value.undefined.empty())
      values.back() = value.number;
    else if (value.undefined != protocol::film_collapsed)
      missing[std::string(info(output).name)] = value.undefined;
  }
  return values;
}

ordered_json drawn_scene(const Scene& scene, const std::vector<Output>& panels) {
  const MixedContact<double> contact(scene);
  const SmoothContact smooth(contact);
  OutputSet outputs;
  for (const Output output : panels)
    if (scene.outputs.contains(output)) outputs.insert(output);
  outputs.insert(Output::inlet);
  outputs = protocol::needed_for(scene, outputs);
  ordered_json speeds = ordered_json::array(), rows = ordered_json::array();
  ordered_json collapsed = ordered_json::array(), missing = ordered_json::object();
  const detail::SpeedSpan span = detail::speed_span(scene.speeds);
  stribeck_curve(contact, span.low, span.high, drawn_points, outputs,
                 [&](const OperatingPoint<double>& point) {
                   speeds.push_back(point.speed);
                   rows.push_back(drawn_values(point, smooth, scene, panels, missing));
                   collapsed.push_back(point.inlet == Inlet::collapsed);
                 });
  ordered_json mark = nullptr;
  const Onset<double> starts =
      onset(contact, scene, OnsetCriterion::film_maximum, default_departure);
  if (starts.exists && starts.speed >= span.low && starts.speed <= span.high)
    mark = {{"speed", starts.speed},
            {"values", drawn_values(contact.solve(starts.speed), smooth, scene, panels, missing)}};
  return {{"id", scene.id},
          {"speed", std::move(speeds)},
          {"values", std::move(rows)},
          {"collapsed", std::move(collapsed)},
          {"missing", std::move(missing)},
          {"onset", std::move(mark)}};
}

}  // namespace

std::vector<Output> drawn_outputs(const std::vector<Scene>& scenes,
                                  const std::vector<Comparison>& measured) {
  std::vector<Output> outputs;
  for (const Output output : usual_panels)
    if (std::any_of(scenes.begin(), scenes.end(),
                    [output](const Scene& scene) { return scene.outputs.contains(output); }))
      outputs.push_back(output);
  for (const Comparison& one : measured)
    if (std::find(outputs.begin(), outputs.end(), one.measured.output) == outputs.end())
      outputs.push_back(one.measured.output);
  return outputs;
}

ordered_json curve_picture(const std::vector<Scene>& scenes,
                           const std::vector<Comparison>& measured) {
  const std::vector<Output> outputs = drawn_outputs(scenes, measured);
  ordered_json panels = ordered_json::array(), curves = ordered_json::array();
  ordered_json points = ordered_json::array();
  for (const Output output : outputs)
    panels.push_back({{"name", info(output).name}, {"unit", info(output).unit}});
  for (const Scene& scene : scenes) curves.push_back(drawn_scene(scene, outputs));
  for (const Comparison& one : measured) {
    const auto panel = std::find(outputs.begin(), outputs.end(), one.measured.output);
    points.push_back({{"panel", panel - outputs.begin()},
                      {"speed", one.measured.speed},
                      {"value", one.measured.value},
                      {"is_on_curve", one.is_on_curve()}});
  }
  return {{"panels", std::move(panels)},
          {"scenes", std::move(curves)},
          {"measured", std::move(points)}};
}

}  // namespace tribo::cli
