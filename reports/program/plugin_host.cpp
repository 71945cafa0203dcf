// SPDX-License-Identifier: Apache-2.0
// tribocheck plugin-host: loads somebody's shared library, which answers JSON lines in a process of
// its own.
#include <memory>
#include <string>

#include "command.hpp"
#include "conformance/plugin.hpp"
#include "conformance/plugin_timing.hpp"
#include "messages.hpp"

namespace tribo::cli {
namespace {

int host(const std::string& path, bool times, bool tells_places) {
  try {
    return times ? conformance::time_plugin(path) : conformance::host_plugin(path, tells_places);
  } catch (const conformance::PluginRefused& refusal) {
    return fail(exit_bad, refusal.what());
  }
}

constexpr const char* plugin_host_footer =
    R"(The library is one made for tribocheck_plugin.h. Lines and answers are those of `tribocheck stream`;
what the library does not offer is answered with "skip". What it prints to stdout comes out on stderr.
`tribocheck verify --plugin` starts this, with --places: each answer then has the place of its case in the
array that the library got. With --time an empty line ends a block of lines, which are all of one function. The
library computes the block again and again for some milliseconds. One line then answers it: the number of
questions with an answer, the CPU time and the wall time of a question, the CPU time of a std::exp for comparison
(all in s), and the time of new questions over that of questions asked again.
`tribocheck bench --plugin` starts this. Exit code 2: the library cannot be used.

Example:
  echo '{"id": "f1", "function": "gaussian_moment", "order": 2.5, "argument": 0}' |
    tribocheck plugin-host ./libsolver.so)";

}  // namespace

Command add_plugin_host(CLI::App& program) {
  CLI::App* app = program.add_subcommand("plugin-host",
                                         "answer JSON lines from stdin on stdout with a plug-in");
  app->footer(plugin_host_footer);
  const auto path = std::make_shared<std::string>();
  const auto times = std::make_shared<bool>(false), places = std::make_shared<bool>(false);
  app->add_option("LIBRARY", *path, "the shared library")->required();
  app->add_flag("--time", *times, "answer each block of lines with the time that it takes");
  app->add_flag("--places", *places, "tell the place of each case in its array")
      ->excludes("--time");
  return {app, [path, times, places](OutputStream&) { return host(*path, *times, *places); }};
}

}  // namespace tribo::cli
