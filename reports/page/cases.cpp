// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "page/facts.hpp"
#include "tribo/onset.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::report {
namespace {

std::string stem_of(std::string_view surface, AsperityModel model) {
  return fmt::format("{}{}", surface, model == AsperityModel::greenwood_tripp ? "" : "_gw");
}

// Says why the report cannot take a scene that is otherwise good; empty if the report can.
std::string missing_for_report(const Scene& scene, AsperityModel model) {
  if (scene.closures.asperity != model)
    return fmt::format("closures.asperity: the report needs {} here",
                       asperity_model_words[static_cast<std::size_t>(model)]);
  if (!has_friction_inputs(scene))
    return "the report needs lubricant.eyring_stress and friction.boundary_coefficient";
  const auto span = detail::speed_span(scene.speeds);
  if (!(span.low < span.high)) return "speed: the report needs a range of speeds";
  return {};
}

class CaseReader {
 public:
  explicit CaseReader(const ReportPlaces& places) : places_(places) {}

  void read(std::string_view surface, AsperityModel model) {
    const std::filesystem::path path = places_.scenes / (stem_of(surface, model) + ".toml");
    SceneReading reading = read_scene(path.string(), SceneUse::speeds);
    for (const InputProblem& warning : reading.warnings) note(warning);
    for (const InputProblem& error : reading.errors) problems.push_back(error.line());
    if (!reading.scene) return;
    const std::string missing = missing_for_report(*reading.scene, model);
    if (!missing.empty()) problems.push_back(fmt::format("{}: {}", path.string(), missing));
    result.cases.push_back({surface, model, places_.shown(path), std::move(*reading.scene)});
  }

  // One line for each warning, whichever scenes have it.
  std::vector<std::string> warnings() const {
    std::vector<std::string> lines;
    for (const auto& [first, more] : warnings_) {
      lines.push_back(first.line());
      if (more > 0)
        lines.back() += fmt::format("; the same of {} more scene{}", more, more == 1 ? "" : "s");
    }
    return lines;
  }

  ReadCases result;
  std::vector<std::string> problems;

 private:
  void note(const InputProblem& warning) {
    for (auto& [first, more] : warnings_)
      if (first.field == warning.field && first.message() == warning.message()) {
        ++more;
        return;
      }
    warnings_.emplace_back(warning, 0);
  }

  std::vector<std::pair<InputProblem, int>> warnings_;  // first scene's warning, number of others
  const ReportPlaces& places_;
};

}  // namespace

std::string Case::stem() const { return stem_of(surface, model); }

ReadCases read_cases(const ReportPlaces& places) {
  CaseReader reader(places);
  for (const auto model : {AsperityModel::greenwood_tripp, AsperityModel::greenwood_williamson})
    for (const std::string_view surface : surfaces) reader.read(surface, model);
  if (!reader.problems.empty()) throw ReportError(std::move(reader.problems));
  reader.result.warnings = reader.warnings();
  return std::move(reader.result);
}

}  // namespace tribo::report
