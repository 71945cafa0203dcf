// SPDX-License-Identifier: Apache-2.0
// tribocheck stream: JSON lines in, JSON lines out, in order.
#include <fmt/format.h>
#include <unistd.h>

#include <set>
#include <string_view>
#include <vector>

#include "command.hpp"
#include "messages.hpp"
#include "protocol/answers.hpp"
#include "protocol/text_streams.hpp"
#include "validity_writers.hpp"

namespace tribo::cli {
namespace {

int stream(OutputStream& output) {
  protocol::LineReader lines(STDIN_FILENO, max_scene_bytes);
  // A stream may be endless: only the first scene that passes a limit is reported.
  std::set<std::string_view> told;
  const auto warn = [&told](std::size_t number, const std::vector<Validity>& passed) {
    std::vector<Validity> news;
    for (const Validity& limit : passed)
      if (told.insert(limit.word).second) news.push_back(limit);
    Warnings warnings;
    warnings.add(fmt::format("line {}", number), "", news);
    warnings.tell("`tribocheck solve --explain` explains those of a scene in a file");
  };
  protocol::answer_lines(lines, output, warn);
  return exit_done;
}

constexpr const char* example =
    R"(Each line in is a scene with one speed, and may name the outputs it wants; or it calls
one function of the model. Each gets one line out, in order:
  {"id": "p1", "film": 3.42e-08, "friction": null, "undefined": {"friction": "the film has collapsed: nothing balances the load"}}
  {"id": "p2", "error": {"field": "load", "message": "-5 is not allowed; allowed: ..."}}
A line that is not JSON or is over 1 MiB gets an error too, with "id": null; blank lines get no
answer. An id is a text or a number, and comes back as it is. Answers are flushed whenever no complete line is waiting. Errors are answers: the exit code
is 0 at the end of the input. A limit of the model's validity is told on stderr for the first scene
that goes beyond it and does not accept it.

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
