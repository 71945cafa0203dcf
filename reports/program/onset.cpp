// SPDX-License-Identifier: Apache-2.0
// tribocheck onset: where starvation sets in, by each criterion.
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "command.hpp"
#include "messages.hpp"
#include "onset_writers.hpp"
#include "options.hpp"
#include "scene_arguments.hpp"

namespace tribo::cli {
namespace {

struct OnsetArguments {
  SceneArguments scenes;
  OnsetsAsked asked;
};

int find_onsets(const OnsetArguments& arguments, OutputStream& output) {
  const LoadedScenes loaded = load_scenes(arguments.scenes.paths, SceneUse::onset);
  if (loaded.scenes.empty()) return exit_bad;
  write_onsets(arguments.scenes.format, loaded.scenes, arguments.asked, loaded.warnings, output);
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
  app->add_option("--criterion", arguments->asked.criteria,
                  "only this one; may be repeated (default: all)")
      ->allow_extra_args(false)
      ->check(CLI::IsMember(
          std::vector<std::string>(onset_criterion_words.begin(), onset_criterion_words.end())));
  add_number_option(
      *app, "--departure",
      [arguments](double departure) { arguments->asked.departure = departure; }, is_departure,
      std::string(departure_allowed) + ", or in %", "the ε of film_departure (default: 0.05)", "%");
  return {app, [arguments](OutputStream& output) { return find_onsets(*arguments, output); },
          [arguments]() -> std::vector<Ignored> {
            return {{{"--departure"},
                     !is_asked(arguments->asked, OnsetCriterion::film_departure),
                     "without --criterion film_departure"}};
          }};
}

}  // namespace tribo::cli
