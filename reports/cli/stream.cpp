// SPDX-License-Identifier: Apache-2.0
// tribocheck stream: JSON lines in, JSON lines out, in order.
#include <unistd.h>

#include "command.hpp"
#include "exit_code.hpp"
#include "json_answers.hpp"
#include "line_reader.hpp"
#include "messages.hpp"

namespace tribo::cli {
namespace {

// A stream may be endless, what it says on stderr may not.
class LimitedWarnings {
 public:
  std::vector<InputProblem>& list() { return list_; }

  void report() {
    for (const InputProblem& warning : list_) {
      if (count_ < most) complain("warning: " + warning.line());
      if (count_ == most) complain("warning: and more, which are not listed");
      if (count_ <= most) ++count_;
    }
    list_.clear();
  }

 private:
  static constexpr int most = 20;
  std::vector<InputProblem> list_;
  int count_ = 0;
};

bool is_blank(std::string_view line) {
  return line.find_first_not_of(" \t\r") == std::string_view::npos;
}

int stream(OutputStream& output) {
  LineReader lines(STDIN_FILENO, max_scene_bytes);
  LimitedWarnings warnings;
  for (std::size_t number = 1;; ++number) {
    // Who waits for an answer before the next question gets it.
    if (!lines.line_waiting()) output.flush();
    const Line line = lines.next();
    if (line.kind == Line::Kind::end_of_input) return exit_done;
    if (line.kind == Line::Kind::too_long)
      append_error(output.text(), std::nullopt, "", "the line is over 1 MiB");
    else if (!is_blank(line.text))
      append_answer(output.text(), line.text, number, warnings.list());
    warnings.report();
    output.end_row();
  }
}

constexpr const char* example =
    R"(Each line in is a scene with one speed, and may name the outputs it wants; or it calls
one function of the model. Each gets one line out, in order:
  {"id": "p1", "film": 3.42e-08, "friction": null, "undefined": {"friction": "the film has collapsed"}}
  {"id": "p2", "error": {"field": "load", "message": "-5 is not allowed; allowed: ..."}}
A line that is not JSON or is over 1 MiB gets an error too, with "id": null; blank lines get no
answer. Answers are flushed whenever no complete line is waiting. Errors are answers: the exit code
is 0 at the end of the input.

Functions: gaussian_moment, hertz_point, hamrock_dowson_central, starvation_ratio, load_sharing

Example:
  echo '{"id": "f1", "function": "gaussian_moment", "order": 2.5, "argument": 0}' |
    tribocheck stream)";

}  // namespace

Command add_stream(CLI::App& program) {
  CLI::App* app = program.add_subcommand("stream", "answer JSON lines from stdin on stdout");
  app->footer(example);
  return {app, stream};
}

}  // namespace tribo::cli
