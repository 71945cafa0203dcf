// SPDX-License-Identifier: Apache-2.0
#include "workloads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "sweep/plan_reader.hpp"

namespace tribo::benchmarks {
namespace {

using Fields = std::vector<std::pair<std::string, std::string>>;

const Fields& rough_surface() {
  static const Fields fields{{"id", "\"rough\""},
                             {"outputs", "[\"film\"]"},
                             {"load", "50"},
                             {"speed", "0.05"},
                             {"surface.summit_density", "5e10"},
                             {"surface.summit_radius", "1e-5"},
                             {"surface.summit_height_sd", "1e-7"},
                             {"surface.summit_plane_offset", "1.146"},
                             {"bodies.effective_modulus", "107.9e9"},
                             {"bodies.reduced_radius", "9.5e-3"},
                             {"bodies.ellipticity", "1"},
                             {"lubricant.viscosity", "0.0202"},
                             {"lubricant.pressure_viscosity", "2e-8"},
                             {"supply.inlet_film_ratio", "4"}};
  return fields;
}

std::string uniform(double from, double to) {
  return fmt::format("{{ distribution = \"uniform\", from = {}, to = {} }}", from, to);
}
std::string normal(double mean, double sd) {
  return fmt::format("{{ distribution = \"normal\", mean = {}, sd = {} }}", mean, sd);
}
std::string log_normal(double median, double log_sd) {
  return fmt::format("{{ distribution = \"log_normal\", median = {}, log_sd = {} }}", median,
                     log_sd);
}

// Some fields are uniform, as rounded printed numbers are. The others are spread as measured ones.
Fields five() {
  return {{"load", uniform(49.5, 50.5)},
          {"surface.summit_density", uniform(4.95e10, 5.05e10)},
          {"surface.summit_height_sd", log_normal(1e-7, 0.2)},
          {"lubricant.viscosity", normal(0.0202, 5e-4)},
          {"lubricant.pressure_viscosity", uniform(1.95e-8, 2.05e-8)}};
}

Fields twelve() {
  Fields fields = five();
  const Fields others{{"speed", log_normal(0.05, 0.1)},
                      {"surface.summit_radius", log_normal(1e-5, 0.1)},
                      {"surface.summit_plane_offset", uniform(1.1455, 1.1465)},
                      {"bodies.effective_modulus", normal(107.9e9, 1e9)},
                      {"bodies.reduced_radius", uniform(9.45e-3, 9.55e-3)},
                      {"bodies.ellipticity", uniform(0.99, 1.01)},
                      {"supply.inlet_film_ratio", normal(4, 0.1)}};
  fields.insert(fields.end(), others.begin(), others.end());
  return fields;
}

std::vector<Workload> make_workloads() {
  return {
      {"film_5_fields", "the film at one speed, five fields drawn", five(), ""},
      {"film_12_fields", "the film, twelve fields drawn", twelve(), ""},
      {"film_of_speed",
       "the film, the speed alone drawn",
       {{"speed", "{ distribution = \"log_uniform\", from = 1e-4, to = 3 }"}},
       ""},
      {"onset_5_fields", "the onset at the film maximum, five fields drawn", five(),
       "onset = [\"film_maximum\"]\n"},
  };
}

}  // namespace

const std::vector<Workload>& workloads() {
  static const std::vector<Workload> all = make_workloads();
  return all;
}

std::string text_of(const Workload& workload, std::uint64_t draws, std::string_view keep) {
  std::string text;
  for (const auto& [path, value] : rough_surface()) {
    // A workload of onsets has no outputs, because they would add operating points.
    if (path == "outputs" && !workload.settings.empty()) continue;
    const auto varied = std::find_if(workload.varied.begin(), workload.varied.end(),
                                     [&](const auto& field) { return field.first == path; });
    text +=
        fmt::format("{} = {}\n", path, varied == workload.varied.end() ? value : varied->second);
  }
  return text +
         fmt::format("[sweep]\ndraws = {}\nkeep = \"{}\"\n{}", draws, keep, workload.settings);
}

sweep::SweepPlan plan_of(const Workload& workload, std::uint64_t draws, std::string_view keep) {
  sweep::SweepReading reading =
      sweep::parse_sweep(text_of(workload, draws, keep), workload.name + ".toml");
  if (!reading.sweep) throw std::invalid_argument(reading.errors.front().line());
  std::vector<sweep::SceneSweep> scenes;
  scenes.push_back(std::move(*reading.sweep));
  return sweep::make_plan(std::move(scenes));
}

}  // namespace tribo::benchmarks
