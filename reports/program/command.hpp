// SPDX-License-Identifier: Apache-2.0
// A command of the program. A new one needs a file with its add_… function, the function's
// declaration below, and a place in the list of main.cpp.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <span>
#include <vector>

#include "messages.hpp"
#include "options.hpp"

namespace tribo::cli {

struct Command {
  CLI::App* app;                          // owned by the program's CLI::App
  std::function<int(OutputStream&)> run;  // gives the exit code
  // Called after parsing: returns the options that the command would ignore. Empty if the command
  // ignores none.
  std::function<std::vector<Ignored>()> ignored = {};
};

using AddCommand = Command (*)(CLI::App& program);

// Runs the command that the arguments name. Returns the exit code; nothing is thrown.
int run_program(std::span<const AddCommand> commands, int count, char** arguments);

Command add_solve(CLI::App& program);
Command add_contact(CLI::App& program);
Command add_curve(CLI::App& program);
Command add_onset(CLI::App& program);
Command add_film(CLI::App& program);
Command add_stream(CLI::App& program);
Command add_functions(CLI::App& program);
Command add_report(CLI::App& program);
Command add_field(CLI::App& program);
Command add_verify(CLI::App& program);
Command add_bench(CLI::App& program);
Command add_profile(CLI::App& program);
Command add_plugin_host(CLI::App& program);
Command add_reproduce(CLI::App& program);
Command add_init(CLI::App& program);
Command add_sweep(CLI::App& program);
inline constexpr const char* sweep_description =
    "many cases of scenes: grids, uncertain inputs, sensitivities";

}  // namespace tribo::cli
