// SPDX-License-Identifier: Apache-2.0
#include "onset_writers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <forward_list>
#include <nlohmann/json.hpp>

#include "protocol/answers.hpp"

namespace tribo::cli {
namespace {

constexpr std::string_view without_roughness = "the bodies are smooth: λ has no σ_s";

// The onset. If one of its numbers overflows, it is marked as not existing, with the reason.
Onset<double> checked(Onset<double> onset) {
  if (!onset.exists ||
      (std::isfinite(onset.speed + onset.film) && !std::isinf(onset.film_parameter)))
    return onset;
  onset.exists = false;
  onset.reason = protocol::beyond_double;
  return onset;
}

std::vector<Onset<double>> onsets_of(const Scene& scene, const OnsetsAsked& asked) {
  const MixedContact<double> contact(scene);
  std::vector<Onset<double>> onsets;
  for (const CriterionInfo& info : onset_criteria)
    if (is_asked(asked, info.criterion))
      onsets.push_back(checked(onset(contact, scene, info.criterion, asked.departure)));
  return onsets;
}

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

// The onset speeds of one criterion by the other laws of the inlet, without printed_exponents and
// solved. The text is empty if no other law has this onset.
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

}  // namespace

bool is_asked(const OnsetsAsked& asked, OnsetCriterion criterion) {
  return asked.criteria.empty() || std::find(asked.criteria.begin(), asked.criteria.end(),
                                             name(criterion)) != asked.criteria.end();
}

void write_onsets(std::string_view format, std::span<const Scene> scenes, const OnsetsAsked& asked,
                  const Warnings& warnings, OutputStream& output) {
  const std::vector<Column> told = columns(format);
  RowWriter writer(format, output, told, {"onset/1", "onsets"}, RowWriter::Reasons::in_rows);
  std::forward_list<std::string> notes;  // the writer has views of them
  for (const Scene& scene : scenes) {
    writer.begin(scene.id, title_of(scene), told);
    for (const Onset<double>& found : onsets_of(scene, asked)) {
      const auto cells = cells_of(scene, found);
      writer.add(std::span(cells).first(told.size()));
      const bool is_of_film = found.criterion == OnsetCriterion::film_departure ||
                              found.criterion == OnsetCriterion::film_maximum;
      if (format != "table" || !is_of_film || scene.supply.kind == SupplyKind::flooded) continue;
      notes.push_front(by_other_laws(scene, found.criterion, asked.departure));
      if (!notes.front().empty()) writer.note(name(found.criterion), notes.front());
    }
  }
  writer.finish({{"warnings", warnings.json()}});
}

}  // namespace tribo::cli
