// SPDX-License-Identifier: Apache-2.0
// tribocheck solve computes the outputs at a scene's speeds. For each speed it finds a root of load
// sharing.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "build_info.hpp"
#include "command.hpp"
#include "messages.hpp"
#include "page/texts.hpp"
#include "point_writers.hpp"
#include "progress.hpp"
#include "protocol/answers.hpp"
#include "scene/schema.hpp"
#include "scene_arguments.hpp"
#include "table.hpp"
#include "tribo/onset.hpp"

namespace tribo::cli {
namespace {

struct SolveArguments : SceneArguments {
  int threads = 0;
  bool is_about_scenes = false, explains = false;
};

WorkCounts work_of(const Scene& scene, const MixedContact<double>& contact) {
  const OutputSet outputs = protocol::needed_for(scene);
  OperatingPoints points;
  WorkCounts work;
  in_chunks(scene, [&](const std::vector<double>& speeds) {
    points.resize(speeds.size(), outputs);
    tribo::solve(contact, speeds, outputs, points, work);
  });
  return work;
}

// --- What a scene is: --about

using nlohmann::ordered_json;

// A fact about a scene. The value is null where the scene has none.
struct Fact {
  std::string_view name;
  ordered_json value;
  std::string_view unit, meaning;
  std::string_view default_text = {};  // of an input; empty: it has none
};
struct Facts {
  std::string_view part;
  std::vector<Fact> all;
};

// The two temperatures and viscosities of an oil, written as in a scene. The result is null if the
// scene does not give them.
ordered_json pairs_text(const Oil& oil) {
  const auto& [first, second] = oil.viscosities;
  if (first.temperature == 0) return nullptr;
  return fmt::format("[[{}, {}], [{}, {}]]", first.temperature, first.viscosity, second.temperature,
                     second.viscosity);
}

// The speeds of a list. The result is null for a long list and for a range: their least and
// greatest speed are shown instead.
ordered_json list_text(const Speeds& speeds) {
  constexpr std::size_t most_shown = 20;
  if (speeds.list.empty() || speeds.list.size() > most_shown) return nullptr;
  return fmt::format("{}", fmt::join(speeds.list, ", "));
}

// The words of `accept`; null where there are none.
ordered_json accepted_text(const Scene& scene) {
  if (scene.accepted.empty()) return nullptr;
  return fmt::format("{}", fmt::join(scene.accepted, ", "));
}

// The value of a field as JSON; null where the scene has none. For a range or a long list of
// speeds, the fields speed.from and speed.to have the least and the greatest speed.
ordered_json input_of(const Scene& scene, std::size_t field) {
  const FieldInfo& info = scene_fields()[field];
  if (info.type == FieldType::speeds) return list_text(scene.speeds);
  if (info.type == FieldType::limits) return accepted_text(scene);
  const bool has_list = !list_text(scene.speeds).is_null();
  if (info.path == "speed.count") return has_list ? nullptr : ordered_json(scene.speeds.size());
  if (info.path == "speed.spacing" && !scene.speeds.list.empty()) return nullptr;
  if (info.path == "speed.from")
    return has_list ? nullptr : ordered_json(detail::speed_span(scene.speeds).low);
  if (info.path == "speed.to")
    return has_list ? nullptr : ordered_json(detail::speed_span(scene.speeds).high);
  if (info.type == FieldType::viscosities) return pairs_text(scene.lubricant.oil);
  const std::optional<double> value = scene_detail::value_in(scene, field);
  if (!value) return nullptr;
  if (info.type == FieldType::choice) return info.choices[static_cast<std::size_t>(*value)];
  if (info.type == FieldType::integer) return static_cast<int>(*value);
  return std::isinf(*value) ? ordered_json(*value > 0 ? "inf" : "-inf") : ordered_json(*value);
}

Facts inputs_of(const Scene& scene) {
  Facts inputs{"inputs", {}};
  for (std::size_t field = 0; field < scene_fields().size(); ++field) {
    const FieldInfo& info = scene_fields()[field];
    if (info.type == FieldType::text || info.type == FieldType::outputs) continue;
    inputs.all.push_back(
        {info.path, input_of(scene, field), info.unit, info.meaning, info.default_text});
  }
  return inputs;
}

Facts contact_of(const Scene& scene, const MixedContact<double>& contact) {
  // The names stand in the order of ContactShape.
  constexpr std::array<std::string_view, 3> shapes{"circle", "ellipse", "line"};
  const auto numbers = detail::numbers_of<double>(scene);
  const HertzContact<double> hertz = contact.hertz();
  const ContactShape shape = scene.bodies.shape();
  const bool is_line = shape == ContactShape::line;
  const auto of_point = [&](double x) { return is_line ? ordered_json(nullptr) : ordered_json(x); };
  return {"contact",
          {{"shape", shapes[static_cast<std::size_t>(shape)], "", "circle, ellipse or line"},
           {"effective_modulus", numbers.effective_modulus, "Pa", "E*"},
           {"radius_x", numbers.radius_x, "m", "R_x, along the direction of entrainment"},
           {"radius_y", of_point(shape == ContactShape::circle ? numbers.radius_x : numbers.across),
            "m", "R_y, across it"},
           {"length", is_line ? ordered_json(scene.bodies.length) : nullptr, "m", "L of a line"},
           {"semi_axis_x", hertz.semi_axis_x, "m", "a_x of the dry, smooth contact; of a line b"},
           {"semi_axis_y", of_point(hertz.semi_axis_y), "m", "a_y"},
           {"ellipticity", of_point(hertz.semi_axis_y / hertz.semi_axis_x), "", "a_y/a_x"},
           {"mean_pressure", hertz.mean_pressure, "Pa", "p̄ of the dry, smooth contact"},
           {"peak_pressure", hertz.peak_pressure, "Pa", "its greatest pressure"},
           {"approach", of_point(hertz.approach), "m", "of the two bodies"},
           {"summit_height_sd",
            scene.surface.is_smooth() ? nullptr : ordered_json(contact.summit_height_sd()), "m",
            "σ_s; smooth bodies have none"},
           {"share_without_film", contact.sharing().asperity_share(0), "",
            "A(0); above 1 the summits keep the faces apart at a film of no thickness"},
           {"speed_power", contact.film().speed_power.value, "",
            "the flooded film of smooth faces grows as this power of the speed"}}};
}

// All outputs. The value of each is whether the scene asks for it.
Facts outputs_of(const Scene& scene) {
  Facts outputs{"outputs", {}};
  for (const OutputInfo& info : output_infos)
    outputs.all.push_back(
        {info.name, scene.outputs.contains(info.output), info.unit, info.meaning});
  return outputs;
}

Facts work_facts(const Scene& scene, const MixedContact<double>& contact) {
  const WorkCounts work = work_of(scene, contact);
  Facts facts{"work", {{"points", scene.speeds.size(), "", "operating points, one a speed"}}};
  for (const WorkInfo& info : work_infos)
    facts.all.push_back({info.name, work[info.work], "", info.meaning});
  return facts;
}

std::string text_of(const Fact& fact, std::string (*number)(double)) {
  if (fact.value.is_null()) return "";
  if (fact.value.is_string()) return fact.value.get<std::string>();
  return fact.value.is_number_float() ? number(fact.value.get<double>()) : fact.value.dump();
}

void append_json(Text& to, const Scene& scene, const std::vector<Facts>& parts) {
  ordered_json told{{"id", scene.id}};
  for (const Facts& facts : parts)
    for (const Fact& one : facts.all)
      told[std::string(facts.part)].push_back(
          {{"name", one.name}, {"value", one.value}, {"unit", one.unit}, {"meaning", one.meaning}});
  append(to, without_controls(told.dump(-1, ' ', false, ordered_json::error_handler_t::replace)));
}

void append_csv(Text& to, const Scene& scene, const std::vector<Facts>& parts) {
  for (const Facts& facts : parts)
    for (const Fact& one : facts.all)
      append(to, fmt::format("{},{},{},{},{},{}\n", report::csv_text(scene.id), facts.part,
                             one.name, report::csv_text(text_of(one, report::exact)), one.unit,
                             report::csv_text(one.meaning)));
}

// Leaves out the facts that the scene does not have.
void append_tables(Text& to, const Scene& scene, const std::vector<Facts>& parts) {
  for (const Facts& facts : parts) {
    if (&facts != &parts.front()) to.push_back('\n');
    append_title(to, fmt::format("{}: {}{}", scene.id, facts.part,
                                 facts.part == "work" ? ", steps that the points took" : ""));
    std::size_t width = 30;
    for (const Fact& one : facts.all)
      if (!one.value.is_null()) width = std::max(width, one.name.size() + 1);
    for (const Fact& one : facts.all) {
      if (one.value.is_null()) continue;
      if (one.value.is_boolean()) {  // an output
        append_line(to, fmt::format("  {:<{}}{}", one.name, width,
                                    one.value.get<bool>() ? "computed" : "not computed"));
        continue;
      }
      const std::string unit =
          one.value.is_number_float() && one.unit.empty() ? "-" : std::string(one.unit);
      const std::string value = text_of(one, readable);
      const bool is_default = !one.default_text.empty() && value == one.default_text;
      append_line(to, fmt::format("  {:<{}}{}{}{}", one.name, width, value,
                                  unit.empty() ? "" : fmt::format(" [{}]", unit),
                                  is_default ? ", the default" : ""));
    }
  }
}

void tell_about(const LoadedScenes& loaded, std::string_view format, OutputStream& output) {
  Text& text = output.text();
  if (format == "csv") append(text, "id,part,name,value,unit,meaning\n");
  const bool is_json = format == "json";
  std::string before = is_json ? list_start("solve-about/1", "scenes") : "";
  for (const Scene& scene : loaded.scenes) {
    append(text, std::exchange(before, is_json ? list_comma : format == "csv" ? "" : "\n"));
    const MixedContact<double> contact(scene);
    const std::vector<Facts> parts{inputs_of(scene), contact_of(scene, contact), outputs_of(scene),
                                   work_facts(scene, contact)};
    (is_json ? append_json : format == "csv" ? append_csv : append_tables)(text, scene, parts);
    output.end_row();
  }
  if (is_json) append(text, list_end_with({{"warnings", loaded.warnings.json()}}));
}

// --- Is the model valid here? --explain

ordered_json explained(const std::vector<Scene>& scenes) {
  ordered_json all = ordered_json::array();
  for (const Scene& scene : scenes)
    for (ordered_json& row : validity_json(validity_of(scene))) {
      ordered_json named{{"id", scene.id}};
      named.update(row);
      all.push_back(std::move(named));
    }
  return all;
}

void append_explanations(Text& to, const std::vector<Scene>& scenes) {
  for (const Scene& scene : scenes) {
    to.push_back('\n');
    append_validity(to, scene.id, validity_of(scene));
  }
}

int solve(const SolveArguments& arguments, OutputStream& output) {
  const LoadedScenes loaded =
      load_scenes(arguments.paths, SceneUse::speeds, {}, arguments.explains);
  if (loaded.scenes.empty()) return exit_bad;
  if (arguments.is_about_scenes) {
    tell_about(loaded, arguments.format, output);
    return loaded.exit_code(arguments);
  }
  std::size_t total = 0;
  for (const Scene& scene : loaded.scenes) total += scene.speeds.size();
  Progress progress(total);
  PointWriter writer(arguments.format, output, loaded.scenes);
  for (const Scene& scene : loaded.scenes) write_points(scene, arguments.threads, writer, progress);
  ordered_json members{{"warnings", loaded.warnings.json()}};
  if (arguments.explains) members["validity"] = explained(loaded.scenes);
  writer.finish(members);
  if (arguments.explains && arguments.format == "table")
    append_explanations(output.text(), loaded.scenes);
  return loaded.exit_code(arguments);
}

constexpr const char* footer_start =
    R"(Columns: the speed in m/s, and what the scene's `outputs` ask of these; films and separation are
in m, pressures in Pa, all other numbers dimensionless. Without a list it is all from film_flooded
to inlet; the last four are there only by name.
)";
constexpr const char* footer_end = R"(
CSV and JSON numbers read back to the same double. What is undefined is - in a table, empty in
CSV, and null in JSON, which says why under "undefined". A bad scene is reported, the others are
still solved, and the exit code is 2.

With --about a scene has one answer in place of its points: its inputs with those that follow and
the defaults, its dry contact, the outputs that it asks for, and the work that they took: how many
steps of each kind, which tells where time goes.

With --explain a table follows the points: what the model assumes, its number here, the limit, and
whether that holds. `accept = ["smooth_film_law"]` in a scene accepts a limit that it goes
beyond: no warning is written for it.

Example:
  tribocheck solve reference/published/rough.toml --format csv > rough.csv
  tribocheck solve reference/published/rough.toml --about
  tribocheck solve reference/published/rough.toml --explain
  tribocheck solve reference/published/rough.toml reference/published/smooth.toml)";

std::string footer() {
  std::string text = footer_start;
  for (const OutputInfo& output : output_infos)
    text += fmt::format("  {:<21}{}\n", output.name, output.meaning);
  return text + footer_end;
}

}  // namespace

Command add_solve(CLI::App& program) {
  CLI::App* app = program.add_subcommand("solve", "the outputs of scenes at their speeds");
  app->footer(footer_with_scenes(footer()));
  const auto arguments = std::make_shared<SolveArguments>();
  add_scene_arguments(*app, *arguments);
  app->add_option(
         "--threads", arguments->threads,
         "threads for scenes of many speeds (default: all that it may run on); the results "
         "are the same bits for any number")
      ->check(CLI::Range(1, 1024));
  app->add_flag("--about", arguments->is_about_scenes,
                "in place of its points, all inputs of a scene, its dry contact, and the work that "
                "the points take");
  app->add_flag("--explain", arguments->explains,
                "after the points, the table \"is the model valid here?\"");
  return {app, [arguments](OutputStream& output) { return solve(*arguments, output); },
          [arguments]() -> std::vector<Ignored> {
            return {{{"--threads", "--explain"}, arguments->is_about_scenes, "beside --about"},
                    {{"--explain"}, arguments->format == "csv", "beside --format csv"}};
          }};
}

}  // namespace tribo::cli
