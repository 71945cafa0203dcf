// SPDX-License-Identifier: Apache-2.0
// libtribocheck.so: scenes, their operating points, curves and onsets, and solved films.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "program/film_case.hpp"
#include "program/onset_writers.hpp"
#include "program/prepared_scenes.hpp"
#include "program/validity_writers.hpp"
#include "protocol/answers.hpp"
#include "telling.hpp"
#include "tribo/operating_points.hpp"
#include "tribo/scene_reader.hpp"
#include "tribo/validity.hpp"
#include "tribocheck.h"

namespace {

using namespace tribo;
using namespace tribo::bindings;
using nlohmann::ordered_json;

constexpr std::string_view source = "scene";

bool is_speed(double speed) { return speed > 0 && std::isfinite(speed); }
constexpr std::string_view speed_allowed = "a number above 0, in m/s";

// The scene that was read. Throws std::invalid_argument with all its faults, a line each, where it
// has any.
Scene scene_of(SceneReading reading) {
  if (reading.scene) return std::move(*reading.scene);
  std::string faults;
  for (const InputProblem& one : reading.errors)
    faults += (faults.empty() ? "" : "\n") + one.line();
  throw std::invalid_argument(faults);
}

Scene scene_of(const char* text, SceneUse use, std::span<const std::string_view> outputs = {}) {
  return scene_of(parse_scene(text, source, use, outputs));
}

cli::Warnings warnings_of(const Scene& scene, SceneUse use) {
  cli::Warnings warnings;
  warnings.add(source, scene.id, passed_limits(scene, use));
  return warnings;
}

std::string one_text(const protocol::Text& text) {
  return without_controls({text.data(), text.size()});
}

// The JSON about a scene. No output is "asked" if the scene has inputs for solved films only.
std::string about(const char* text) {
  SceneUse use = SceneUse::onset;
  SceneReading reading = parse_scene(text, source, use);
  if (!reading.scene) {
    use = SceneUse::film;
    if (SceneReading of_films = parse_scene(text, source, use); of_films.scene)
      reading = std::move(of_films);
  }
  ordered_json notes = ordered_json::array(), outputs = notes;
  for (const InputProblem& one : reading.warnings) notes.push_back(one.line());
  const ordered_json id = reading.id ? ordered_json(*reading.id) : ordered_json(nullptr);
  const Scene scene = scene_of(std::move(reading));
  for (const OutputInfo& info : output_infos)
    outputs.push_back({{"name", info.name},
                       {"asked", use != SceneUse::film && scene.outputs.contains(info.output)},
                       {"unit", info.unit},
                       {"words", info.words},
                       {"meaning", info.meaning}});
  const std::size_t count = scene.speeds.size();
  if (use == SceneUse::onset && count > 0) use = SceneUse::speeds;
  return without_controls(ordered_json{
      {"id", id},
      {"speeds", count},
      {"outputs", outputs},
      {"warnings", warnings_of(scene, use).json()},
      {"notes", notes}}.dump());
}

// The caller's arrays for results. The name of each is "speed" or that of an output.
class Columns {
 public:
  Columns(std::size_t count, const char* const* names, double* const* results)
      : results_(results, count) {
    for (const std::string_view name : std::span(names, count)) {
      outputs_.push_back(output_by_name(name));
      if (name != "speed" && std::find(names_.begin(), names_.end(), name) == names_.end())
        names_.push_back(name);
    }
  }

  // The names of the outputs that are asked for, in place of the scene's own outputs; empty where
  // only the speed is asked for.
  std::span<const std::string_view> names() const { return names_; }

  // Copies the first points of a batch into the columns, from index `first` on. `speeds` are the
  // speeds of these points.
  void put(std::size_t first, std::span<const double> speeds, const OperatingPoints& points,
           const SmoothContact* smooth) {
    for (std::size_t k = 0; k < results_.size(); ++k) {
      const std::span to(results_[k] + first, speeds.size());
      if (outputs_[k])
        protocol::put_values(points, smooth, *outputs_[k], to);
      else
        std::copy(speeds.begin(), speeds.end(), to.begin());
    }
  }

 private:
  std::vector<std::string_view> names_;
  std::vector<std::optional<Output>> outputs_;
  std::span<double* const> results_;
};

// Solves block by block. fill(first, speeds) sets the speeds of a block that begins at `first`.
template <class Fill>
void solve(Scene& scene, std::size_t count, Columns& columns, const Fill& fill) {
  if (columns.names().empty()) scene.outputs = {};
  const MixedContact<double> contact(scene);
  const OutputSet outputs = protocol::needed_for(scene);
  std::optional<SmoothContact> smooth;
  if (protocol::needs_smooth_contact(scene)) smooth.emplace(contact);
  constexpr std::size_t block = 4096;  // points that fit in the caches
  std::vector<double> speeds(std::min(block, count));
  OperatingPoints points;
  points.resize(speeds.size(), outputs);
  for (std::size_t first = 0; first < count; first += speeds.size()) {
    speeds.resize(std::min(block, count - first));
    fill(first, speeds);
    tribo::solve(contact, speeds, outputs, points);
    columns.put(first, speeds, points, smooth ? &*smooth : nullptr);
  }
}

void solve_own(Scene& scene, std::size_t count, Columns& columns) {
  if (count != scene.speeds.size())
    throw std::invalid_argument(
        fmt::format("count: {} is not allowed; allowed: {}, as many as the "
                    "scene has speeds",
                    count, scene.speeds.size()));
  solve(scene, count, columns,
        [&](std::size_t first, std::span<double> speeds) { scene.speeds.fill(first, speeds); });
}

void solve_at(Scene& scene, std::span<const double> all, Columns& columns) {
  const auto wrong = std::find_if_not(all.begin(), all.end(), is_speed);
  if (wrong != all.end())
    throw std::invalid_argument(
        refusal(fmt::format("speeds[{}]", wrong - all.begin()), *wrong, speed_allowed));
  solve(scene, all.size(), columns, [&](std::size_t first, std::span<double> speeds) {
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(first), speeds.size(), speeds.begin());
  });
}

std::string onsets(const char* text, double departure) {
  if (!cli::is_departure(departure))
    throw std::invalid_argument(refusal("departure", departure, cli::departure_allowed));
  const Scene scene = scene_of(text, SceneUse::onset);
  protocol::OutputStream output;
  cli::write_onsets("json", {&scene, 1}, {.departure = departure},
                    warnings_of(scene, SceneUse::onset), output);
  return one_text(output.text());
}

std::string films(const char* text, const char* request, tribocheck_watch watch, void* user,
                  int& code) {
  Members members(request);
  cli::FilmSettings settings;
  const double speed = members.take_number("speed", 0, is_speed, speed_allowed);
  settings.tolerance =
      members.take_number("tolerance", 0, cli::is_film_tolerance, cli::film_tolerance_allowed);
  settings.viscosity = members.take_one_of("viscosity", {"", "barus", "roelands"});
  settings.density = members.take_one_of("density", {"incompressible", "dowson_higginson"});
  settings.is_flooded = members.take("flooded", false);
  const bool with_profile = members.take("profile", false);
  members.refuse_others();
  Scene scene = scene_of(text, SceneUse::film);
  if (settings.is_flooded && !cli::has_supply_of_film(scene))
    throw std::invalid_argument(fmt::format("flooded: it {}", cli::no_supply_of_film));
  if (const std::string fault = prepare_film(scene, speed, settings); !fault.empty())
    throw std::invalid_argument(fault);
  protocol::Text told;
  cli::FilmWriter writer("json", with_profile, told);
  for (std::size_t i = 0; i < scene.speeds.size(); ++i) {
    bool is_stopped = false;
    const cli::FilmCase film =
        solve_film(scene, scene.speeds[i], settings, [&](int cells, int step) {
          is_stopped = is_stopped || (watch != nullptr && watch(user, cells, step) != 0);
          return !is_stopped;
        });
    if (is_stopped) throw std::runtime_error("stopped");
    if (!film.reason.empty()) code = TRIBOCHECK_WRONG;
    writer.add(writer.text_of(film));
  }
  writer.finish(warnings_of(scene, SceneUse::film).json());
  return one_text(told);
}

}  // namespace

TRIBOCHECK_EXPORT int tribocheck_describe_scene(const char* scene, char* text, size_t size,
                                                size_t* length) {
  return tell({text, size, length}, [&](int&) { return about(scene); });
}

TRIBOCHECK_EXPORT int tribocheck_solve(const char* scene, size_t count, const double* speeds,
                                       size_t columns, const char* const* names,
                                       double* const* result, char* text, size_t size,
                                       size_t* length) {
  return tell({text, size, length}, [&](int&) {
    Columns asked(columns, names, result);
    Scene read =
        scene_of(scene, speeds == nullptr ? SceneUse::speeds : SceneUse::onset, asked.names());
    if (speeds == nullptr)
      solve_own(read, count, asked);
    else
      solve_at(read, {speeds, count}, asked);
    return std::string();
  });
}

TRIBOCHECK_EXPORT int tribocheck_curve(const char* scene, size_t count, size_t columns,
                                       const char* const* names, double* const* result, char* text,
                                       size_t size, size_t* length) {
  return tell({text, size, length}, [&](int&) {
    Columns asked(columns, names, result);
    Scene read = scene_of(scene, SceneUse::speeds, asked.names());
    if (const std::string fault = cli::prepare_curve(read); !fault.empty())
      throw std::invalid_argument(fault);
    solve_own(read, count, asked);
    return std::string();
  });
}

TRIBOCHECK_EXPORT int tribocheck_onset(const char* scene, double departure, char* text, size_t size,
                                       size_t* length) {
  return tell({text, size, length}, [&](int&) { return onsets(scene, departure); });
}

TRIBOCHECK_EXPORT int tribocheck_film(const char* scene, const char* request,
                                      tribocheck_watch watch, void* user, char* text, size_t size,
                                      size_t* length) {
  return tell({text, size, length},
              [&](int& code) { return films(scene, request, watch, user, code); });
}
