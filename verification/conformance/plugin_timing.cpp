// SPDX-License-Identifier: Apache-2.0
#include "conformance/plugin_timing.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <chrono>
#include <csignal>
#include <exception>
#include <functional>
#include <stdexcept>
#include <string_view>
#include <variant>
#include <vector>

#include "conformance/cpu_time.hpp"
#include "conformance/plugin.hpp"
#include "conformance/plugin_scene.hpp"
#include "protocol/answers.hpp"
#include "protocol/question.hpp"
#include "protocol/text_streams.hpp"

namespace tribo::conformance {
namespace {

constexpr double enough = 5e-3;  // s, least length of a measurement
constexpr int not_written = -1;  // a status that the plug-in has not written

using protocol::FunctionCall;
using protocol::Question;

// A block with all arrays that its calls need.
struct Block {
  std::function<bool()> call;  // false: the plug-in does not offer the function
  std::vector<int> status;
  std::vector<std::vector<double>> arguments, results;
  std::vector<const double*> argument_columns;
  std::vector<double*> result_columns;
  std::vector<tribocheck_scene> scenes;
  std::vector<double> speeds;
  std::vector<tribocheck_point> points;
};

void prepare_calls(Block& block, const PluginFunctions& functions,
                   const std::vector<Question>& questions) {
  const catalogue::Function& asked = *std::get<FunctionCall>(questions[0]).function;
  for (std::size_t k = 0; k < asked.parameters.size(); ++k) {
    std::vector<double>& column = block.arguments.emplace_back();
    for (const Question& one : questions) {
      const auto* call = std::get_if<FunctionCall>(&one);
      if (call == nullptr || call->function != &asked)
        throw std::invalid_argument("a block has questions of one function");
      column.push_back(call->arguments[k]);
    }
    block.argument_columns.push_back(column.data());
  }
  for (std::size_t k = 0; k < asked.results.size(); ++k)
    block.result_columns.push_back(
        block.results.emplace_back(questions.size(), not_offered).data());
  if (functions.function == nullptr) return;
  block.call = [&block, function = functions.function, name = asked.name.data()] {
    return function(name, block.status.size(), block.argument_columns.data(),
                    block.result_columns.data(), block.status.data()) != 0;
  };
}

void prepare_points(Block& block, const PluginFunctions& functions,
                    const std::vector<Question>& questions) {
  for (const Question& one : questions) {
    const auto* reading = std::get_if<SceneReading>(&one);
    if (reading == nullptr) throw std::invalid_argument("a block has questions of one function");
    const Scene& scene = *reading->scene;
    // A plug-in's scene is a circle with the default film law. A block with others is not asked.
    if (scene.closures.film != FilmFormula::hamrock_dowson_central ||
        scene.bodies.shape() != ContactShape::circle)
      return;
    block.scenes.push_back(plugin_scene(scene));
    block.speeds.push_back(scene.speeds[0]);
  }
  block.points.assign(questions.size(), empty_point());
  if (functions.operating_point == nullptr) return;
  block.call = [&block, function = functions.operating_point] {
    for (std::size_t i = 0; i < block.scenes.size(); ++i)
      function(&block.scenes[i], 1, &block.speeds[i], &block.points[i], &block.status[i]);
    return true;
  };
}

// Throws std::invalid_argument with the fault of the line.
Question question_of(std::string_view line, std::size_t number) {
  Question question = protocol::read_question(line, number);
  const auto* call = std::get_if<FunctionCall>(&question);
  if (call != nullptr && call->fault) throw std::invalid_argument(call->fault->message);
  if (call == nullptr && !std::get<SceneReading>(question).scene)
    throw std::invalid_argument("the line is no question");
  return question;
}

struct Times {
  double seconds, wall;  // of one call
};

Times times_of(const Block& block, std::size_t calls) {
  const auto start = std::chrono::steady_clock::now();
  const double before = own_cpu_seconds();
  for (std::size_t i = 0; i < calls; ++i) block.call();
  const double spent = own_cpu_seconds() - before;
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  return {spent / static_cast<double>(calls), wall.count() / static_cast<double>(calls)};
}

void prepare(Block& block, const PluginFunctions& functions,
             const std::vector<Question>& questions) {
  block.status.assign(questions.size(), not_written);
  if (std::holds_alternative<FunctionCall>(questions[0]))
    prepare_calls(block, functions, questions);
  else
    prepare_points(block, functions, questions);
}

// Takes away the questions that have no answer.
void keep_answered(const PluginFunctions& functions, std::vector<Question>& questions) {
  Block block;
  prepare(block, functions, questions);
  std::vector<Question> answered;
  if (block.call && block.call())
    for (std::size_t i = 0; i < questions.size(); ++i)
      if (block.status[i] == TRIBOCHECK_DONE || block.status[i] == TRIBOCHECK_UNDEFINED)
        answered.push_back(std::move(questions[i]));
  questions = std::move(answered);
}

// The time of a call with new cases over the time of the same call made again, as the median of up
// to 15 pairs of calls. In a new case one number is greater by a part in 1e9. No pair follows once
// all calls together have taken 0.1 s.
double new_over_asked(Block& block, const std::vector<Question>& questions) {
  constexpr std::size_t most_pairs = 15;
  constexpr double long_enough = 0.1;  // s
  std::vector<double*> changed;
  for (tribocheck_scene& scene : block.scenes) changed.push_back(&scene.load);
  if (const auto* call = std::get_if<FunctionCall>(&questions[0])) {
    for (double& number : block.arguments[varied_parameter(*call->function)])
      changed.push_back(&number);
  }
  std::vector<double> ratios;
  double spent = 0;
  while (ratios.size() < most_pairs && spent < long_enough) {
    for (double* const number : changed) *number *= 1 + 1e-9;
    const double fresh = times_of(block, 1).seconds, asked = times_of(block, 1).seconds;
    ratios.push_back(fresh / std::max(asked, 1e-9));
    spent += fresh + asked;
  }
  return boost::math::statistics::median(ratios);
}

std::string answer_to(const PluginFunctions& functions, std::vector<Question> questions) {
  if (!questions.empty()) keep_answered(functions, questions);
  if (questions.empty()) return "{\"answered\": 0}";
  double ratio = 0;
  {
    Block block;
    prepare(block, functions, questions);
    ratio = new_over_asked(block, questions);
  }
  Block block;
  prepare(block, functions, questions);
  std::size_t calls = 1;
  while (times_of(block, calls).seconds * static_cast<double>(calls) < enough) calls *= 2;
  const double before = control_seconds(Control::exponentials);
  const Times times = times_of(block, calls);
  const double control = (before + control_seconds(Control::exponentials)) / 2;
  const auto count = static_cast<double>(questions.size());
  return fmt::format(
      "{{\"answered\": {}, \"seconds\": {}, \"wall\": {}, \"control\": {}, \"new_over_asked\": "
      "{}}}",
      questions.size(), times.seconds / count, times.wall / count, control, ratio);
}

std::string error_of(std::string_view message) {
  protocol::Text text;
  protocol::append(text, "{\"error\": ");
  protocol::append_json_text(text, message);
  protocol::append(text, "}");
  return fmt::to_string(text);
}

}  // namespace

int time_plugin(const std::string& path) {
  std::signal(SIGPIPE, SIG_IGN);  // a reader that goes away shows as a failed write
  protocol::OutputStream output(take_stdout());
  const Plugin plugin = load_plugin(path);
  protocol::LineReader lines(STDIN_FILENO, max_scene_bytes);
  std::vector<Question> questions;
  std::string fault;
  for (std::size_t number = 1;; ++number) {
    const protocol::Line line = lines.next();
    if (line.kind == protocol::Line::Kind::end_of_input) return 0;
    if (!protocol::is_blank(line.text)) {
      try {
        questions.push_back(question_of(line.text, number));
      } catch (const std::invalid_argument& error) {
        fault = error.what();
      }
      continue;
    }
    std::string answer;
    try {
      answer = fault.empty() ? answer_to(plugin.functions, questions) : error_of(fault);
    } catch (const std::exception& error) {
      answer = error_of(error.what());
    }
    protocol::append(output.text(), answer + "\n");
    output.flush();
    questions.clear();
    fault.clear();
  }
}

}  // namespace tribo::conformance
