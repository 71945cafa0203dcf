// SPDX-License-Identifier: Apache-2.0
// tribocheck onset: where starvation sets in, by each criterion.
#include "tribo/onset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <forward_list>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "command.hpp"
#include "messages.hpp"
#include "options.hpp"
#include "protocol/answers.hpp"
#include "scene_arguments.hpp"
#include "table.hpp"

namespace tribo::cli {
namespace {

struct OnsetArguments {
  SceneArguments scenes;
  std::vector<std::string> criteria;  // empty: all
  double departure = default_departure;
};

constexpr std::string_view without_roughness = "the bodies are smooth: λ has no σ_s";

bool is_asked(const OnsetArguments& arguments, OnsetCriterion criterion) {
  const auto& asked = arguments.criteria;
  return asked.empty() || std::find(asked.begin(), asked.end(), name(criterion)) != asked.end();
}

// The onset, or none with a reason where a number of it overflows.
Onset<double> checked(Onset<double> onset) {
  if (!onset.exists ||
      (std::isfinite(onset.speed + onset.film) && !std::isinf(onset.film_parameter)))
    return onset;
  onset.exists = false;
  onset.reason = protocol::beyond_double;
  return onset;
}

std::vector<Onset<double>> onsets_of(const Scene& scene, const OnsetArguments& arguments) {
  const MixedContact<double> contact(scene);
  std::vector<Onset<double>> onsets;
  for (const CriterionInfo& info : onset_criteria)
    if (is_asked(arguments, info.criterion))
      onsets.push_back(checked(onset(contact, scene, info.criterion, arguments.departure)));
  return onsets;
}

constexpr std::size_t criterion_width = width_of_words(onset_criterion_words);

// A table names the law of the inlet in its title, and has no column for it.
std::vector<Column> columns(std::string_view format) {
  std::vector<Column> columns{{"criterion", "", criterion_width, true},
                              {"speed", "m/s"},
                              {"film", "m"},
                              {"film_parameter"}};
  if (format != "table") columns.push_back({"starvation", "", 0, true});
  return columns;
}

std::string_view law_of(const Scene& scene) {
  return starvation_words[static_cast<std::size_t>(scene.closures.starvation)];
}

std::string title_of(const Scene& scene) {
  const std::string title = scene.id + ": onset of starvation";
  const bool is_flooded = scene.supply.kind == SupplyKind::flooded;
  return is_flooded ? title : fmt::format("{}, starvation = {}", title, law_of(scene));
}

std::array<protocol::OutputValue, 5> cells_of(const Scene& scene, const Onset<double>& onset) {
  const std::string_view reason = onset.exists ? std::string_view() : onset.reason;
  const bool is_smooth = onset.exists && std::isnan(onset.film_parameter);
  return {{{{}, name(onset.criterion)},
           {reason, {}, onset.speed},
           {reason, {}, onset.film},
           {is_smooth ? without_roughness : reason, {}, onset.film_parameter},
           {{}, law_of(scene)}}};
}

// The speeds of one criterion by the other laws of the inlet that scenes are made with; empty where
// none has it.
std::string by_other_laws(const Scene& scene, OnsetCriterion criterion, double departure) {
  std::string told;
  for (const StarvationClosure law :
       {StarvationClosure::flooded_inlet, StarvationClosure::starved_inlet,
        StarvationClosure::damiens}) {
    if (law == scene.closures.starvation) continue;
    Scene other = scene;
    other.closures.starvation = law;
    const Onset<double> found =
        checked(onset(MixedContact<double>(other), other, criterion, departure));
    if (found.exists)
      told += fmt::format("{}{} m/s by {}", told.empty() ? "" : ", ", readable(found.speed),
                          starvation_words[static_cast<std::size_t>(law)]);
  }
  return told.empty() ? told : told + ", another law of the inlet: closures.starvation";
}

int find_onsets(const OnsetArguments& arguments, OutputStream& output) {
  const LoadedScenes loaded = load_scenes(arguments.scenes.paths, SceneUse::onset);
  if (loaded.scenes.empty()) return exit_bad;
  const std::string& format = arguments.scenes.format;
  const std::vector<Column> told = columns(format);
  RowWriter writer(format, output, told, {"onset/1", "onsets"}, RowWriter::Reasons::in_rows);
  std::forward_list<std::string> notes;  // the writer has views of them
  for (const Scene& scene : loaded.scenes) {
    writer.begin(scene.id, title_of(scene), told);
    for (const Onset<double>& found : onsets_of(scene, arguments)) {
      const auto cells = cells_of(scene, found);
      writer.add(std::span(cells).first(told.size()));
      const bool is_of_film = found.criterion == OnsetCriterion::film_departure ||
                              found.criterion == OnsetCriterion::film_maximum;
      if (format != "table" || !is_of_film || scene.supply.kind == SupplyKind::flooded) continue;
      notes.push_front(by_other_laws(scene, found.criterion, arguments.departure));
      if (!notes.front().empty()) writer.note(name(found.criterion), notes.front());
    }
  }
  writer.finish({{"warnings", loaded.warnings.json()}});
  return loaded.exit_code(arguments.scenes);
}

constexpr const char* onset_footer =
    R"(Speed in m/s, film in m, film_parameter = film/summit_height_sd. Where a criterion has no point, the
answer says why. `speed` may be absent from the scene; friction_minimum alone needs it. The title, or
"starvation" in CSV and JSON, names the law of the inlet, closures.starvation; below the table stand the
speeds by other laws.

Example:
  tribocheck onset reference/published/rough.toml
  tribocheck onset reference/published/rough.toml --criterion film_departure --departure 0.1)";

std::string onset_help() {
  std::string text = "Criteria:\n";
  for (const CriterionInfo& info : onset_criteria)
    text += fmt::format("  {:<{}}  {}\n", info.name, criterion_width, info.meaning);
  return text + onset_footer;
}

}  // namespace

Command add_onset(CLI::App& program) {
  CLI::App* app = program.add_subcommand("onset", "speed and film at the onset of starvation");
  app->footer(footer_with_scenes(onset_help()));
  const auto arguments = std::make_shared<OnsetArguments>();
  add_scene_arguments(*app, arguments->scenes);
  app->add_option("--criterion", arguments->criteria,
                  "only this one; may be repeated (default: all)")
      ->allow_extra_args(false)
      ->check(CLI::IsMember(
          std::vector<std::string>(onset_criterion_words.begin(), onset_criterion_words.end())));
  add_number_option(
      *app, "--departure", [arguments](double departure) { arguments->departure = departure; },
      [](double departure) { return departure > 0 && departure < 1; },
      "a number above 0 and below 1, or in %", "the ε of film_departure (default: 0.05)", "%");
  return {app, [arguments](OutputStream& output) { return find_onsets(*arguments, output); },
          [arguments]() -> std::vector<Ignored> {
            return {{{"--departure"},
                     !is_asked(*arguments, OnsetCriterion::film_departure),
                     "without --criterion film_departure"}};
          }};
}

}  // namespace tribo::cli
