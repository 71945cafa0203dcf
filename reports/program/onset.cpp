// SPDX-License-Identifier: Apache-2.0
// tribocheck onset: where starvation sets in, by each criterion.
#include "tribo/onset.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "command.hpp"
#include "example_scenes.hpp"
#include "exit_code.hpp"
#include "number_option.hpp"
#include "onset_writers.hpp"
#include "protocol/answers.hpp"
#include "scene_arguments.hpp"

namespace tribo::cli {
namespace {

struct OnsetArguments {
  SceneArguments scenes;
  std::vector<std::string> criteria;  // empty: all
  double departure = default_departure;
};

bool is_asked(const OnsetArguments& arguments, OnsetCriterion criterion) {
  const auto& asked = arguments.criteria;
  return asked.empty() || std::find(asked.begin(), asked.end(), name(criterion)) != asked.end();
}

// An overflow in between is no onset.
Onset<double> checked(Onset<double> onset) {
  if (!onset.exists || std::isfinite(onset.speed + onset.film + onset.film_parameter)) return onset;
  onset.exists = false;
  onset.reason = protocol::beyond_double;
  return onset;
}

std::vector<Onset<double>> onsets_of(const Scene& scene, const OnsetArguments& arguments) {
  const MixedContact<double> contact(scene);
  std::vector<Onset<double>> onsets;
  for (const OnsetCriterion criterion : onset_criteria)
    if (is_asked(arguments, criterion))
      onsets.push_back(checked(onset(contact, scene, criterion, arguments.departure)));
  return onsets;
}

int find_onsets(const OnsetArguments& arguments, OutputStream& output) {
  const LoadedScenes loaded = load_scenes(arguments.scenes.paths, SceneUse::onset);
  if (loaded.scenes.empty()) return exit_bad;
  const auto writer = make_onset_writer(arguments.scenes.format, output);
  for (const Scene& scene : loaded.scenes) {
    writer->add(scene, onsets_of(scene, arguments));
    output.end_row();
  }
  writer->finish();
  return loaded.all_good ? exit_done : exit_bad;
}

std::vector<std::string> criterion_names() {
  std::vector<std::string> names;
  names.reserve(onset_criteria.size());
  for (const OnsetCriterion criterion : onset_criteria) names.emplace_back(name(criterion));
  return names;
}

constexpr const char* onset_footer = R"(Criteria:
  film_maximum      the film no longer grows with speed
  film_departure    the film is a part ε below the flooded one
  friction_minimum  the lowest friction within the scene's speeds
  asperity_minimum  the least load on the asperities
Speed in m/s, film in m, film_parameter = film/summit_height_sd. Where a criterion has no point, the
answer says why. `speed` may be absent from the scene; friction_minimum alone needs it.

Example:
  tribocheck onset reference/published/rough.toml
  tribocheck onset reference/published/rough.toml --criterion film_departure --departure 0.1)";

}  // namespace

Command add_onset(CLI::App& program) {
  CLI::App* app = program.add_subcommand("onset", "speed and film at the onset of starvation");
  app->footer(footer_with_scenes(onset_footer));
  const auto arguments = std::make_shared<OnsetArguments>();
  add_scene_arguments(*app, arguments->scenes);
  app->add_option("--criterion", arguments->criteria,
                  "only this one; may be repeated (default: all)")
      ->allow_extra_args(false)
      ->check(CLI::IsMember(criterion_names()));
  add_number_option(
      *app, "--departure", [arguments](double departure) { arguments->departure = departure; },
      [](double departure) { return departure > 0 && departure < 1; },
      "a number above 0 and below 1", "the ε of film_departure (default: 0.05)");
  return {app, [arguments](OutputStream& output) { return find_onsets(*arguments, output); },
          [arguments]() -> std::vector<Ignored> {
            return {{{"--departure"},
                     !is_asked(*arguments, OnsetCriterion::film_departure),
                     "without --criterion film_departure"}};
          }};
}

}  // namespace tribo::cli
