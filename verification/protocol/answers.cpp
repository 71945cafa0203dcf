// SPDX-License-Identifier: Apache-2.0
#include "protocol/answers.hpp"

#include <fmt/compile.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "protocol/question.hpp"
#include "sweep/on_threads.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::protocol {
namespace {

bool is_plain(std::string_view text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return c >= 0x20 && c < 0x7F && c != '"' && c != '\\'; });
}

// The loop has no branch, so that the compiler can vectorise it.
bool all_finite(std::span<const double> numbers) {
  std::uint64_t any = 0;  // its highest bit is set if the exponent of a number has all bits set
  for (const double number : numbers)
    any |= (std::bit_cast<std::uint64_t>(number) & ~(std::uint64_t{1} << 63)) +
           (std::uint64_t{1} << 52);
  return any >> 63 == 0;
}

// {"id": …, "film": …}, or what is wrong with the scene.
void append_scene_answer(Text& to, const SceneReading& reading, std::vector<Validity>& passed) {
  if (!reading.scene) return append_first_error(to, reading);
  const Scene& scene = *reading.scene;
  const MixedContact<double> contact(scene);
  const OperatingPoint<double> point = contact.solve(scene.speeds[0], needed_for(scene));
  std::optional<SmoothContact> smooth;
  if (needs_smooth_contact(scene)) smooth.emplace(contact);
  AnswerObject answer(to, id_of(reading));
  for (const OutputInfo& output : output_infos)
    if (scene.outputs.contains(output.output))
      answer.value(output.name, value_of(point, smooth ? &*smooth : nullptr, output.output));
  answer.close();
  to.push_back('\n');
  passed = passed_limits(scene, contact, point);
}

// {"id": …, "value": …}, or what is wrong with the call.
void append_function_answer(Text& to, const FunctionCall& call) {
  if (call.fault) return append_error(to, id_of(call), call.fault->field, call.fault->message);
  catalogue::Results results{};
  call.function->value(call.arguments, results);
  AnswerObject answer(to, id_of(call));
  for (std::size_t i = 0; i < call.function->results.size(); ++i)
    answer.number(call.function->results[i].name, results[i]);
  answer.close();
  to.push_back('\n');
}

// The answers to lines that follow one another.
struct Part {
  Text text;
  std::vector<std::pair<std::size_t, std::vector<Validity>>> passed;  // by the line's number

  void answer(std::span<const Line> lines, std::size_t number) {
    text.clear();
    passed.clear();
    std::vector<Validity> passed_by_line;
    for (const Line& line : lines) {
      if (line.kind == Line::Kind::too_long)
        append_error(text, {}, "", line_too_long);
      else if (!is_blank(line.text))
        append_answer(text, line.text, number, passed_by_line);
      if (!passed_by_line.empty()) passed.emplace_back(number, std::move(passed_by_line));
      passed_by_line.clear();
      ++number;
    }
  }
};

}  // namespace

void put_values(const OperatingPoints& points, const SmoothContact* smooth, Output output,
                std::span<double> to) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  // Gives what value_of() gives, but looks only at the numbers on which the output depends. If one
  // of them is not finite, the output is NaN; but the regime `collapsed` stays.
  const auto put = [&](const auto& column, const std::vector<double>& rests_on) {
    std::transform(column.begin(), column.begin() + std::ssize(to), to.begin(),
                   [](auto value) { return static_cast<double>(value); });
    const std::size_t count = std::min(rests_on.size(), to.size());
    if (all_finite({rests_on.data(), count})) return;
    for (std::size_t i = 0; i < count; ++i)
      if (!std::isfinite(rests_on[i]) &&
          !(output == Output::regime && points.regime[i] == Regime::collapsed))
        to[i] = nan;
  };
  if (output == Output::regime) {
    put(points.regime, points.asperity_load_share);
  } else if (output == Output::inlet) {
    put(points.inlet, points.film);
  } else {
    for_each_number(points, [&](Output one, const std::vector<double>& numbers) {
      if (one == output) put(numbers, numbers);
    });
  }
  if (smooth == nullptr) return;
  const bool is_of_smooth_contact = info(output).is_of_smooth_contact;
  const bool is_pressure = output == Output::peak_pressure || output == Output::mean_pressure;
  const bool is_of_summits = summit_outputs().contains(output);
  const auto has_collapsed = [&](std::size_t i) {
    return !points.regime.empty() && points.regime[i] == Regime::collapsed;
  };
  for (std::size_t i = 0; i < to.size(); ++i) {
    const double speed = points.speed[i], film = points.film.empty() ? 0 : points.film[i];
    if (is_of_smooth_contact) to[i] = smooth->value(output, speed, film);
    if ((is_of_smooth_contact && !std::isfinite(to[i])) ||
        (!is_pressure && smooth->is_beyond_solved_films(film)) ||
        (is_of_summits && !has_collapsed(i) && smooth->has_unknown_summits(speed, film)))
      to[i] = nan;
  }
}

OutputSet needed_for(const Scene& scene) { return needed_for(scene, scene.outputs); }
OutputSet needed_for(const Scene& scene, OutputSet asked) {
  if (asked.contains(Output::inlet)) asked.insert(Output::film);
  return solved_outputs(asked, scene.surface.has_rq_alone(), film_law(scene).is_solved());
}

void append_json_text(Text& to, std::string_view text) {
  if (!is_plain(text)) {
    using Json = nlohmann::json;
    append(to, without_controls(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace)));
    return;
  }
  to.push_back('"');
  append(to, text);
  to.push_back('"');
}

void append_number(Text& to, double number) {
  std::array<char, 32> digits;  // the shortest form has at most 24
  const char* const end = fmt::format_to(digits.data(), FMT_COMPILE("{}"), number);
  append(to, {digits.data(), static_cast<std::size_t>(end - digits.data())});
}

AnswerObject::AnswerObject(Text& to, LineId id) : to_(to) {
  append(to_, "{\"id\": ");
  if (!id.text)
    append(to_, "null");
  else if (id.is_number)
    append(to_, *id.text);
  else
    append_json_text(to_, *id.text);
}

void AnswerObject::start_member(std::string_view name) {
  const std::size_t before = to_.size();
  to_.resize(before + name.size() + 6);
  char* const end = std::copy(name.begin(), name.end(), std::copy_n(", \"", 3, &to_[before]));
  std::copy_n("\": ", 3, end);
}

void AnswerObject::number(std::string_view name, double value) {
  if (!std::isfinite(value)) return undefined(name, beyond_double);
  start_member(name);
  append_number(to_, value);
}

void AnswerObject::word(std::string_view name, std::string_view value) {
  start_member(name);
  append_json_text(to_, value);
}

void AnswerObject::undefined(std::string_view name, std::string_view reason) {
  start_member(name);
  append(to_, "null");
  if (undefined_count_ < undefined_.size()) undefined_[undefined_count_++] = {name, reason};
}

void AnswerObject::value(std::string_view name, const OutputValue& value) {
  if (!value.undefined.empty())
    undefined(name, value.undefined);
  else if (!value.word.empty())
    word(name, value.word);
  else
    number(name, value.number);
}

void AnswerObject::close() {
  const char* before = ", \"undefined\": {";
  for (std::size_t i = 0; i < undefined_count_; ++i) {
    append(to_, before);
    append_json_text(to_, undefined_[i].name);
    append(to_, ": ");
    append_json_text(to_, undefined_[i].reason);
    before = ", ";
  }
  append(to_, undefined_count_ > 0 ? "}}" : "}");
}

void append_error(Text& to, LineId id, std::string_view field, std::string_view message) {
  AnswerObject answer(to, id);
  append(to, ", \"error\": {\"field\": ");
  append_json_text(to, field);
  append(to, ", \"message\": ");
  append_json_text(to, message);
  to.push_back('}');
  answer.close();
  to.push_back('\n');
}

void append_first_error(Text& to, const SceneReading& reading) {
  const InputProblem& problem = reading.errors.front();
  std::string message = problem.message();
  if (problem.column > 0)
    fmt::format_to(std::back_inserter(message), " (column {})", problem.column);
  append_error(to, id_of(reading), problem.field, message);
}

void append_answer(Text& to, std::string_view line, std::size_t number,
                   std::vector<Validity>& passed) {
  const Question question = read_question(line, number);
  if (const auto* call = std::get_if<FunctionCall>(&question))
    return append_function_answer(to, *call);
  append_scene_answer(to, std::get<SceneReading>(question), passed);
}

void answer_lines(LineReader& lines, OutputStream& output,
                  const std::function<void(std::size_t, const std::vector<Validity>&)>& warn) {
  // More threads, or threads for fewer parts, would take longer to start than they save.
  constexpr std::size_t most_together = 1024, lines_of_part = 32, least_parts = 8;
  const int threads = std::min(8, thread_count(0));
  std::vector<Line> waiting;
  std::vector<Part> parts(most_together / lines_of_part);
  for (std::size_t number = 1;; number += waiting.size()) {
    if (!lines.line_waiting()) output.flush();
    waiting.assign(1, lines.next());
    while (waiting.size() < most_together && lines.line_waiting()) waiting.push_back(lines.next());
    if (waiting[0].kind == Line::Kind::end_of_input) return;
    const std::size_t count = (waiting.size() + lines_of_part - 1) / lines_of_part;
    each_on_threads(count < least_parts ? 1 : threads, count, [&](std::size_t i) {
      const std::size_t first = i * lines_of_part;
      const std::size_t some = std::min(lines_of_part, waiting.size() - first);
      parts[i].answer(std::span(waiting).subspan(first, some), number + first);
    });
    for (Part& part : std::span(parts).first(count)) {
      append(output.text(), {part.text.data(), part.text.size()});
      output.end_row();
      for (const auto& [line, passed] : part.passed) warn(line, passed);
    }
  }
}

}  // namespace tribo::protocol
