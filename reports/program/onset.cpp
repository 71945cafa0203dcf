// SPDX-License-Identifier: Apache-2.0
// tribocheck onset: where starvation sets in, by each criterion.
#include "tribo/onset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "command.hpp"
#include "messages.hpp"
#include "options.hpp"
#include "page/texts.hpp"
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
  for (const CriterionInfo& info : onset_criteria)
    if (is_asked(arguments, info.criterion))
      onsets.push_back(checked(onset(contact, scene, info.criterion, arguments.departure)));
  return onsets;
}

struct Number {
  std::string_view name, unit;
  double Onset<double>::*value;
};
constexpr auto numbers =
    std::to_array<Number>({{"speed", "[m/s]", &Onset<double>::speed},
                           {"film", "[m]", &Onset<double>::film},
                           {"film_parameter", "[-]", &Onset<double>::film_parameter}});

constexpr std::size_t criterion_width = width_of_words(onset_criterion_words);

// Onsets as a table, CSV or JSON.
class OnsetWriter {
 public:
  OnsetWriter(std::string_view format, Text& text) : format_(format), text_(text) {
    if (format == "csv") append(text, "id,criterion,speed,film,film_parameter,reason\n");
  }

  // All onsets of one scene.
  void add(const Scene& scene, const std::vector<Onset<double>>& onsets) {
    if (format_ == "table") add_heads(scene);
    for (const Onset<double>& onset : onsets)
      if (format_ == "csv")
        add_csv(scene, onset);
      else if (format_ == "json")
        add_json(scene, onset);
      else
        add_line(onset);
  }

  void finish() {
    if (format_ == "json") append(text_, "\n]\n");
  }

 private:
  void add_csv(const Scene& scene, const Onset<double>& onset) {
    append(text_, report::csv_text(scene.id) + ',');
    append(text_, name(onset.criterion));
    for (const Number& one : numbers) {
      text_.push_back(',');
      if (onset.exists) protocol::append_number(text_, onset.*one.value);
    }
    append(text_, ',' + report::csv_text(onset.reason) + '\n');
  }

  void add_json(const Scene& scene, const Onset<double>& onset) {
    append(text_, std::exchange(before_, ",\n"));
    protocol::AnswerObject answer(text_, scene.id);
    answer.word("criterion", name(onset.criterion));
    for (const Number& one : numbers)
      if (onset.exists)
        answer.number(one.name, onset.*one.value);
      else
        answer.undefined(one.name, onset.reason);
    answer.close();
  }

  void add_heads(const Scene& scene) {
    append(text_, std::exchange(blank_, "\n"));
    append_title(text_, scene.id + ": onset of starvation");
    std::vector<ColumnHead> heads{{"criterion", "", criterion_width}};
    for (const Number& one : numbers) heads.emplace_back(one.name, one.unit, number_width);
    append_heads(text_, heads);
  }

  void add_line(const Onset<double>& onset) {
    append_cell(text_, name(onset.criterion), criterion_width);
    if (onset.exists)
      for (const Number& one : numbers)
        append_cell(text_, readable(onset.*one.value), number_width);
    else
      append(text_, fmt::format("  none: {}", onset.reason));
    text_.push_back('\n');
  }

  std::string_view format_;
  Text& text_;
  const char* before_ = "[\n";
  const char* blank_ = "";
};

int find_onsets(const OnsetArguments& arguments, OutputStream& output) {
  const LoadedScenes loaded = load_scenes(arguments.scenes.paths, SceneUse::onset);
  if (loaded.scenes.empty()) return exit_bad;
  OnsetWriter writer(arguments.scenes.format, output.text());
  for (const Scene& scene : loaded.scenes) {
    writer.add(scene, onsets_of(scene, arguments));
    output.end_row();
  }
  writer.finish();
  return loaded.all_good ? exit_done : exit_bad;
}

constexpr const char* onset_footer =
    R"(Speed in m/s, film in m, film_parameter = film/summit_height_sd. Where a criterion has no point, the
answer says why. `speed` may be absent from the scene; friction_minimum alone needs it.

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
      "a number above 0 and below 1", "the ε of film_departure (default: 0.05)");
  return {app, [arguments](OutputStream& output) { return find_onsets(*arguments, output); },
          [arguments]() -> std::vector<Ignored> {
            return {{{"--departure"},
                     !is_asked(*arguments, OnsetCriterion::film_departure),
                     "without --criterion film_departure"}};
          }};
}

}  // namespace tribo::cli
