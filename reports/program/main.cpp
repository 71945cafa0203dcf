// SPDX-License-Identifier: Apache-2.0
// tribocheck: the model from the command line.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

#include "command.hpp"
#include "messages.hpp"
#include "shell.hpp"

namespace tribo::cli {
namespace {

// Sweeps need HDF5 and MPI, and the fields of films need HDF5. Loading their forty libraries takes
// as long as the start of any other command. A separate program therefore does both; it replaces
// this process.
bool needs_sweep_program(std::span<char* const> arguments) {
  if (arguments.size() < 2) return false;
  const std::string_view command = arguments[1];
  return command == "sweep" ||
         (command == "film" && std::ranges::any_of(arguments, [](std::string_view argument) {
            return argument == "--fields" || argument.starts_with("--fields=");
          }));
}

Command name_sweep(CLI::App& program) {
  return {program.add_subcommand("sweep", sweep_description), {}};
}

int become_sweep_program(char** arguments) {
  const std::string path = helper_program("tribocheck_sweep");
  if (!path.empty()) ::execv(path.c_str(), arguments);
  return fail(exit_bad, path.empty() ? "the program tribocheck_sweep is not there; it is built and "
                                       "installed with this one, and has to be in the same folder"
                                     : path + " cannot be started: " + std::strerror(errno));
}

// Every command, in the order of the help.
constexpr std::array<AddCommand, 16> commands{
    &add_contact,   &add_solve,   &add_curve,     &add_onset,       &add_film,  &add_stream,
    &add_functions, &name_sweep,  &add_reproduce, &add_verify,      &add_field, &add_bench,
    &add_report,    &add_profile, &add_init,      &add_plugin_host,
};

}  // namespace
}  // namespace tribo::cli

int main(int count, char** arguments) {
  using namespace tribo::cli;
  if (needs_sweep_program({arguments, static_cast<std::size_t>(count)}))
    return become_sweep_program(arguments);
  return run_program(commands, count, arguments);
}
