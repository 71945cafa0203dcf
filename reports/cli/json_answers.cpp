// SPDX-License-Identifier: Apache-2.0
#include "json_answers.hpp"

#include <iterator>
#include <utility>

#include "answer_object.hpp"
#include "ordinary_scene.hpp"
#include "output_values.hpp"
#include "tribo/operating_points.hpp"

namespace tribo::cli {
namespace {

// An answer has room for one error: the first. Where the text is not JSON, its place is told too.
void append_first_error(Text& to, const SceneReading& reading) {
  const InputProblem& problem = reading.errors.front();
  std::string message = problem.message;
  if (problem.column > 0)
    fmt::format_to(std::back_inserter(message), " (column {})", problem.column);
  append_error(to, reading.id, problem.field, message);
}

void append_scene_answer(Text& to, SceneReading reading, std::vector<InputProblem>& warnings) {
  if (!reading.scene) return append_first_error(to, reading);
  append_point(to, *reading.scene, reading.id);
  for (InputProblem& warning : reading.warnings) warnings.push_back(std::move(warning));
}

}  // namespace

void append_error(Text& to, std::optional<std::string_view> id, std::string_view field,
                  std::string_view message) {
  AnswerObject answer(to, id);
  answer.error(field, message);
  answer.close();
  to.push_back('\n');
}

void append_point(Text& to, const Scene& scene, std::optional<std::string_view> id) {
  const MixedContact<double> contact(scene);
  const OperatingPoint<double> point =
      solve_one(contact, scene.speeds[0], needed_for(scene.outputs));
  AnswerObject answer(to, id);
  for (const OutputInfo& output : output_infos)
    if (scene.outputs.contains(output.output))
      answer.value(output.name, value_of(point, output.output));
  answer.close();
  to.push_back('\n');
}

void append_answer(Text& to, std::string_view line, std::size_t number,
                   std::vector<InputProblem>& warnings) {
  const std::string source = fmt::format("line {}", number);
  if (std::optional<SceneReading> reading = read_ordinary_scene(line, source))
    return append_scene_answer(to, *std::move(reading), warnings);
  // Most of the others are scenes too: only those that may call a function are parsed for one.
  const bool may_call = line.find("\"function\"") != std::string_view::npos;
  if (may_call && append_function_answer(to, line)) return;
  append_scene_answer(to, parse_scene_json(line, source, SceneUse::one_speed), warnings);
}

}  // namespace tribo::cli
