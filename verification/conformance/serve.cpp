// SPDX-License-Identifier: Apache-2.0
#include "conformance/serve.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <variant>
#include <vector>

#include "protocol/answers.hpp"
#include "protocol/question.hpp"

namespace tribo::conformance {
namespace {

using protocol::FunctionCall;
using protocol::LineId;
using protocol::OutputValue;
using protocol::Question;
using protocol::Text;

struct Field {
  std::string_view name;
  std::optional<OutputValue> value;  // none: not offered
};
using Fields = std::vector<Field>;

std::optional<OutputValue> value_of(double number,
                                    std::string_view undefined = protocol::beyond_double) {
  if (is_not_offered(number)) return std::nullopt;
  if (std::isnan(number)) return OutputValue{.undefined = {}, .word = "NaN"};
  if (std::isinf(number)) return OutputValue{.undefined = undefined, .word = {}};
  return OutputValue{.undefined = {}, .word = {}, .number = number};
}

template <class Word>
std::optional<OutputValue> value_of(const WordResult<Word>& result) {
  using Kind = typename WordResult<Word>::Kind;
  if (result.kind == Kind::absent) return std::nullopt;
  if (result.kind == Kind::undefined)
    return OutputValue{.undefined = protocol::beyond_double, .word = {}};
  return OutputValue{.undefined = {}, .word = name(result.word)};
}

template <class Word>
bool is(const WordResult<Word>& result, Word word) {
  return result.kind == WordResult<Word>::Kind::word && result.word == word;
}

// A number that depends on the balance of the load. If nothing balances the load, NaN means that
// the number is undefined.
std::optional<OutputValue> of_balance(double number, const PointResult& point) {
  const bool has_collapsed = is(point.inlet, Inlet::collapsed);
  if (std::isnan(number) && is(point.regime, Regime::collapsed))
    return OutputValue{.undefined = protocol::film_collapsed, .word = {}};
  return value_of(number, has_collapsed ? protocol::film_collapsed : protocol::beyond_double);
}

std::optional<OutputValue> value_of(const PointResult& point, Output output) {
  if (output == Output::regime) return value_of(point.regime);
  if (output == Output::inlet) return value_of(point.inlet);
  if (info(output).is_of_smooth_contact) return std::nullopt;  // solvers are not asked for it
  const double number = point.numbers[static_cast<std::size_t>(output)];
  return balance_outputs().contains(output) ? of_balance(number, point) : value_of(number);
}

Fields fields_of(const catalogue::Results& values, const Question& asked) {
  const catalogue::Function& function = *std::get<FunctionCall>(asked).function;
  Fields fields;
  for (std::size_t i = 0; i < function.results.size(); ++i)
    fields.push_back({function.results[i].name, value_of(values[i])});
  return fields;
}

Fields fields_of(const PointResult& point, const Question& asked) {
  Fields fields;
  for (const OutputInfo& output : output_infos)
    if (std::get<SceneReading>(asked).scene->outputs.contains(output.output))
      fields.push_back({output.name, value_of(point, output.output)});
  return fields;
}

// A function with one result always offers it: any NaN, not_offered too, is an error.
bool is_nan_alone(const catalogue::Results& values, const Question& asked) {
  return std::get<FunctionCall>(asked).function->results.size() == 1 && std::isnan(values[0]);
}
bool is_nan_alone(const PointResult&, const Question&) { return false; }

LineId id_of(const Question& question) {
  return std::visit([](const auto& asked) { return protocol::id_of(asked); }, question);
}

template <class Result>
void append_answer(Text& to, const Question& asked, const Answer<Result>& answer,
                   bool tells_place) {
  if (answer.status == Status::failed)
    return protocol::append_error(to, id_of(asked), "", answer.reason);
  if (answer.status == Status::done && is_nan_alone(answer.result, asked))
    return protocol::append_error(to, id_of(asked), "", "the solver gave NaN");
  protocol::AnswerObject object(to, id_of(asked));
  if (tells_place && answer.of > 0)
    object.word("place", "place " + std::to_string(answer.place) + " of an array of " +
                             std::to_string(answer.of));
  if (answer.status == Status::skipped) {
    object.word("skip", answer.reason);
  } else {
    for (const Field& field : fields_of(answer.result, asked))
      if (answer.status == Status::undefined)
        object.undefined(field.name, answer.reason);
      else if (field.value)
        object.value(field.name, *field.value);
  }
  object.close();
  to.push_back('\n');
}

void fill(catalogue::Arguments& to, const Question& question) {
  to = std::get<FunctionCall>(question).arguments;
}
void fill(Scene& to, const Question& question) { to = *std::get<SceneReading>(question).scene; }

// The name of the function that a question asks for, or "operating_point"; for messages.
std::string_view subject_of(const Question& question) {
  const auto* call = std::get_if<FunctionCall>(&question);
  return call == nullptr ? "operating_point" : call->function->name;
}

// Questions of one kind in a row go to the solver together, once no complete line is waiting.
// Earlier answers are written before that, so that they are not lost if the solver crashes.
class Server {
 public:
  Server(const Solver& solver, int descriptor, bool tells_places)
      : solver_(solver), output_(descriptor), tells_places_(tells_places) {}

  void answer(protocol::LineReader& lines) {
    for (std::size_t number = 1;; ++number) {
      if (!lines.line_waiting()) {
        answer_waiting();
        output_.flush();
      }
      const protocol::Line line = lines.next();
      if (line.kind == protocol::Line::Kind::end_of_input) return;
      if (line.kind == protocol::Line::Kind::too_long)
        complain({}, "", protocol::line_too_long);
      else if (!protocol::is_blank(line.text))
        take(protocol::read_question(line.text, number));
    }
  }

 private:
  static constexpr std::size_t most_together = 1024;

  void complain(LineId id, std::string_view field, std::string_view message) {
    answer_waiting();
    protocol::append_error(output_.text(), id, field, message);
    output_.end_row();
  }

  void take(Question question) {
    if (const auto* call = std::get_if<FunctionCall>(&question); call && call->fault)
      return complain(protocol::id_of(*call), call->fault->field, call->fault->message);
    if (const auto* reading = std::get_if<SceneReading>(&question); reading && !reading->scene) {
      answer_waiting();
      protocol::append_first_error(output_.text(), *reading);
      return output_.end_row();
    }
    const bool is_other = !waiting_.empty() && subject_of(waiting_[0]) != subject_of(question);
    if (is_other || waiting_.size() == most_together) answer_waiting();
    waiting_.push_back(std::move(question));
  }

  void answer_waiting() {
    if (waiting_.empty()) return;
    if (const auto* call = std::get_if<FunctionCall>(&waiting_[0]))
      answer_by(solver_.batch(*call->function));
    else
      answer_by(solver_.operating_point);
    waiting_.clear();
  }

  template <class Asked, class Result>
  void answer_by(const Batch<Asked, Result>& batch) {
    if (!batch) return skip_waiting();
    std::vector<Asked> cases(waiting_.size());
    for (std::size_t i = 0; i < cases.size(); ++i) fill(cases[i], waiting_[i]);
    std::vector<Answer<Result>> answers(cases.size());
    output_.flush();
    if (!answers_all<Asked, Result>(batch, cases, answers))
      for (std::size_t i = 0; i < cases.size(); ++i)
        answers_all<Asked, Result>(batch, {&cases[i], 1}, {&answers[i], 1});
    for (std::size_t i = 0; i < answers.size(); ++i) {
      append_answer(output_.text(), waiting_[i], answers[i], tells_places_);
      output_.end_row();
    }
  }

  // Returns false if the solver threw an exception. All cases have failed then, and the caller asks
  // each of them alone.
  template <class Asked, class Result>
  static bool answers_all(const Batch<Asked, Result>& batch, std::span<const Asked> cases,
                          std::span<Answer<Result>> answers) {
    try {
      batch(cases, answers);
      return true;
    } catch (const std::exception& error) {
      std::fill(answers.begin(), answers.end(), failed(error.what()));
    } catch (...) {
      std::fill(answers.begin(), answers.end(), failed("the solver threw an exception"));
    }
    return false;
  }

  void skip_waiting() {
    const Answer<PointResult> none = skip("no " + std::string(subject_of(waiting_[0])));
    for (const Question& question : waiting_) {
      append_answer(output_.text(), question, none, false);
      output_.end_row();
    }
  }

  const Solver& solver_;
  protocol::OutputStream output_;
  const bool tells_places_;
  std::vector<Question> waiting_;
};

// Solver::batch() of a function that is not offered.
const FunctionBatch no_batch;

}  // namespace

void Solver::check_arguments(std::string_view name, std::size_t count) {
  const catalogue::Function* const function = catalogue::function_named(name);
  if (function == nullptr || function->parameters.size() == count) return;
  std::string names;
  for (const catalogue::Parameter& parameter : function->parameters)
    names.append(names.empty() ? "" : ", ").append(parameter.name);
  throw std::invalid_argument(std::string(name) + " takes " + names + ": " +
                              std::to_string(function->parameters.size()) + " arguments, not " +
                              std::to_string(count));
}

void Solver::offer_batch(std::string_view name, FunctionBatch batch) {
  const catalogue::Function* const function = catalogue::function_named(name);
  if (function == nullptr)
    throw std::invalid_argument("no function is called " + std::string(name) +
                                "; `tribocheck functions` lists all");
  functions_[function] = std::move(batch);
}

const FunctionBatch& Solver::batch(const catalogue::Function& function) const {
  const auto found = functions_.find(&function);
  return found == functions_.end() ? no_batch : found->second;
}

int serve(const Solver& solver, int answers, bool tells_places) {
  std::signal(SIGPIPE, SIG_IGN);  // a reader that goes away shows as a failed write
  try {
    protocol::LineReader lines(STDIN_FILENO, max_scene_bytes);
    Server(solver, answers, tells_places).answer(lines);
    return 0;
  } catch (const protocol::OutputClosed&) {
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tribocheck: %s\n", error.what());
    return 1;
  }
}

int serve(const Solver& solver) { return serve(solver, take_stdout()); }

int take_stdout() {
  std::fflush(stdout);
  const int copy = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  if (::dup2(STDERR_FILENO, STDOUT_FILENO) < 0) {
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    ::dup2(nowhere, STDOUT_FILENO);
    if (nowhere > STDERR_FILENO) ::close(nowhere);
  }
  return copy;
}

}  // namespace tribo::conformance
