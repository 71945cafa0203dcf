// SPDX-License-Identifier: Apache-2.0
#include "protocol/json_answers.hpp"

#include <utility>

#include "protocol/answer_object.hpp"
#include "protocol/output_values.hpp"
#include "protocol/question.hpp"
#include "tribo/operating_points.hpp"

namespace tribo::protocol {
namespace {

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

void append_function_answer(Text& to, const FunctionCall& call) {
  if (call.mistake) return append_error(to, call.id, call.mistake->field, call.mistake->message);
  catalogue::Results results{};
  call.function->value(call.arguments, results);
  AnswerObject answer(to, call.id);
  for (std::size_t i = 0; i < call.function->results.size(); ++i)
    answer.number(call.function->results[i].name, results[i]);
  answer.close();
  to.push_back('\n');
}

void append_point(Text& to, const Scene& scene, std::optional<std::string_view> id) {
  const MixedContact<double> contact(scene);
  const OperatingPoint<double> point = contact.solve(scene.speeds[0], needed_for(scene.outputs));
  AnswerObject answer(to, id);
  for (const OutputInfo& output : output_infos)
    if (scene.outputs.contains(output.output))
      answer.value(output.name, value_of(point, output.output));
  answer.close();
  to.push_back('\n');
}

void append_answer(Text& to, std::string_view line, std::size_t number,
                   std::vector<InputProblem>& warnings) {
  Question question = read_question(line, number);
  if (const auto* call = std::get_if<FunctionCall>(&question))
    return append_function_answer(to, *call);
  append_scene_answer(to, std::get<SceneReading>(std::move(question)), warnings);
}

}  // namespace tribo::protocol
