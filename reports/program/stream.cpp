// SPDX-License-Identifier: Apache-2.0
// tribocheck stream: JSON lines in, JSON lines out, in order.
#include <unistd.h>

#include "command.hpp"
#include "messages.hpp"
#include "protocol/answers.hpp"
#include "protocol/text_streams.hpp"

namespace tribo::cli {
namespace {

constexpr int most_warnings = 20;  // on stderr, because a stream may be endless

int stream(OutputStream& output) {
  protocol::LineReader lines(STDIN_FILENO, max_scene_bytes);
  int count = 0;
  protocol::answer_lines(lines, output, [&count](const InputProblem& warning) {
    if (count < most_warnings) complain("warning: " + warning.line());
    if (count == most_warnings) complain("warning: and more, which are not listed");
    if (count <= most_warnings) ++count;
  });
  return exit_done;
}

constexpr const char* example =
    R"(Each line in is a scene with one speed, and may name the outputs it wants; or it calls
one function of the model. Each gets one line out, in order:
  {"id": "p1", "film": 3.42e-08, "friction": null, "undefined": {"friction": "the film has collapsed: nothing balances the load"}}
  {"id": "p2", "error": {"field": "load", "message": "-5 is not allowed; allowed: ..."}}
A line that is not JSON or is over 1 MiB gets an error too, with "id": null; blank lines get no
answer. Answers are flushed whenever no complete line is waiting. Errors are answers: the exit code
is 0 at the end of the input.

`tribocheck functions` lists the functions, and `tribocheck functions NAME` explains one.

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
