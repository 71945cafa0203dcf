// SPDX-License-Identifier: Apache-2.0
#include "protocol/question.hpp"

#include <iterator>
#include <utility>

#include "protocol/json_answers.hpp"
#include "protocol/ordinary_scene.hpp"

namespace tribo::protocol {

Question read_question(std::string_view line, std::size_t number) {
  const std::string source = fmt::format("line {}", number);
  // Only a line that may call a function is parsed for a call.
  if (line.find("\"function\"") != std::string_view::npos)
    if (std::optional<FunctionCall> call = read_function_call(line)) return *std::move(call);
  if (std::optional<SceneReading> reading = read_ordinary_scene(line, source))
    return *std::move(reading);
  return parse_scene_json(line, source, SceneUse::one_speed);
}

bool is_blank(std::string_view line) {
  return line.find_first_not_of(" \t\r") == std::string_view::npos;
}

void append_first_error(Text& to, const SceneReading& reading) {
  const InputProblem& problem = reading.errors.front();
  std::string message = problem.message;
  if (problem.column > 0)
    fmt::format_to(std::back_inserter(message), " (column {})", problem.column);
  append_error(to, reading.id, problem.field, message);
}

}  // namespace tribo::protocol
