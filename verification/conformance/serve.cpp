// SPDX-License-Identifier: Apache-2.0
#include "conformance/serve.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <string_view>
#include <variant>
#include <vector>

#include "conformance/result_fields.hpp"
#include "protocol/answers.hpp"
#include "protocol/text_streams.hpp"
#include "protocol/question.hpp"

namespace tribo::conformance {
namespace {

using protocol::FunctionCall;
using protocol::Question;

void fill(catalogue::Arguments& to, const Question& question) {
  to = std::get<FunctionCall>(question).arguments;
}
void fill(Scene& to, const Question& question) { to = *std::get<SceneReading>(question).scene; }

std::optional<std::string_view> id_of(const Question& question) {
  return std::visit([](const auto& asked) -> std::optional<std::string_view> { return asked.id; },
                    question);
}

// The subject of a question, by a name that messages use.
std::string_view subject_of(const Question& question) {
  const auto* call = std::get_if<FunctionCall>(&question);
  return call == nullptr ? "operating_point" : call->function->name;
}

// Questions of one kind in a row go to the solver together, once no complete line is waiting.
// Earlier answers are written by then, whatever the solver does.
class Server {
 public:
  Server(const Solver& solver, int descriptor) : solver_(solver), output_(descriptor) {}

  void answer(protocol::LineReader& lines) {
    for (std::size_t number = 1;; ++number) {
      if (!lines.line_waiting()) answer_all();
      const protocol::Line line = lines.next();
      if (line.kind == protocol::Line::Kind::end_of_input) return;
      if (line.kind == protocol::Line::Kind::too_long)
        complain(std::nullopt, "", protocol::line_too_long);
      else if (!protocol::is_blank(line.text))
        take(protocol::read_question(line.text, number));
    }
  }

 private:
  static constexpr std::size_t most_together = 1024;

  void complain(std::optional<std::string_view> id, std::string_view field,
                std::string_view message) {
    answer_waiting();
    protocol::append_error(output_.text(), id, field, message);
    output_.end_row();
  }

  void take(Question question) {
    if (const auto* call = std::get_if<FunctionCall>(&question); call && call->fault)
      return complain(call->id, call->fault->field, call->fault->message);
    if (const auto* reading = std::get_if<SceneReading>(&question); reading && !reading->scene) {
      answer_waiting();
      protocol::append_first_error(output_.text(), *reading);
      return output_.end_row();
    }
    const bool is_other = !waiting_.empty() && subject_of(waiting_[0]) != subject_of(question);
    if (is_other || waiting_.size() == most_together) answer_waiting();
    waiting_.push_back(std::move(question));
  }

  void answer_all() {
    answer_waiting();
    output_.flush();
  }

  void answer_waiting() {
    if (waiting_.empty()) return;
    if (const auto* call = std::get_if<FunctionCall>(&waiting_[0]))
      answer_by(solver_.batch(*call->function));
    else
      answer_by(solver_.operating_point);
    waiting_.clear();
  }

  template <class Case, class Result>
  void answer_by(const Batch<Case, Result>& batch) {
    if (!batch) return skip_waiting();
    std::vector<Case> cases(waiting_.size());
    for (std::size_t i = 0; i < cases.size(); ++i) fill(cases[i], waiting_[i]);
    std::vector<Answer<Result>> answers(cases.size());
    output_.flush();
    if (!answers_all<Case, Result>(batch, cases, answers))
      for (std::size_t i = 0; i < cases.size(); ++i)
        answers_all<Case, Result>(batch, {&cases[i], 1}, {&answers[i], 1});
    for (std::size_t i = 0; i < answers.size(); ++i) {
      append(waiting_[i], answers[i]);
      output_.end_row();
    }
  }

  // False: one of the cases threw an exception, and all have failed. Which one it was shows when
  // each is asked alone.
  template <class Case, class Result>
  static bool answers_all(const Batch<Case, Result>& batch, std::span<const Case> cases,
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

  void append(const Question& question, const Answer<catalogue::Results>& answer) {
    const FunctionCall& call = std::get<FunctionCall>(question);
    append_answer_line(output_.text(), call.id, answer, *call.function);
  }
  void append(const Question& question, const Answer<PointResult>& answer) {
    const SceneReading& reading = std::get<SceneReading>(question);
    append_answer_line(output_.text(), reading.id, answer, reading.scene->outputs);
  }

  void skip_waiting() {
    const std::string reason = "no " + std::string(subject_of(waiting_[0]));
    for (const Question& question : waiting_) {
      append_skip_line(output_.text(), id_of(question), reason);
      output_.end_row();
    }
  }

  const Solver& solver_;
  protocol::OutputStream output_;
  std::vector<Question> waiting_;
};

// Solver::batch() of a function that is not offered.
const FunctionBatch no_batch;

}  // namespace

void Solver::check_arguments(std::string_view name, std::size_t count) {
  const catalogue::Function* const function = catalogue::find(name);
  if (function == nullptr || function->parameters.size() == count) return;
  std::string names;
  for (const catalogue::Parameter& parameter : function->parameters)
    names.append(names.empty() ? "" : ", ").append(parameter.name);
  throw std::invalid_argument(std::string(name) + " takes " + names + ": " +
                              std::to_string(function->parameters.size()) + " arguments, not " +
                              std::to_string(count));
}

void Solver::offer_batch(std::string_view name, FunctionBatch batch) {
  const catalogue::Function* const function = catalogue::find(name);
  if (function == nullptr)
    throw std::invalid_argument("no function is called " + std::string(name) +
                                "; `tribocheck functions` lists all");
  functions_[function] = std::move(batch);
}

const FunctionBatch& Solver::batch(const catalogue::Function& function) const {
  const auto found = functions_.find(&function);
  return found == functions_.end() ? no_batch : found->second;
}

int serve(const Solver& solver, int answers) {
  std::signal(SIGPIPE, SIG_IGN);  // a reader that goes away shows as a failed write
  try {
    protocol::LineReader lines(STDIN_FILENO, max_scene_bytes);
    Server(solver, answers).answer(lines);
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
