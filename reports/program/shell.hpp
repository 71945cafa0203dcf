// SPDX-License-Identifier: Apache-2.0
// Words and command lines of /bin/sh. This shell starts subjects, and users paste lines of the
// program's output into it. The last function finds the programs that are installed with this one.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tribo::cli {

// A text as one word of a command line. It is in quotes only if it needs them.
std::string shell_word(const std::string& text);

// The words of a command line. The result is std::nullopt if only the shell can read the line,
// because it has variables, pipes or other signs of the shell.
std::optional<std::vector<std::string>> words_of(const std::string& command);

// The path at which the shell finds a program. Where the command is built into the shell, or no
// shell can be started, it is the name that was given. It is empty if the shell finds no such
// program.
std::string found_by_shell(const std::string& program);

// Why the program at the start of a command line cannot be started, and what to do. The result is
// std::nullopt if it can be started, or if only the shell can read the start, such as $NAME.
std::optional<std::string> why_not_startable(const std::string& command);

// Throws std::invalid_argument with one line of text if a plug-in is not there, or if the program
// of a subject's command line cannot be started. One of the two arguments is given, the other one
// is empty.
void check_solver(const std::string& plugin, const std::string& command);

std::string this_program();  // the path of this program's file

// The words of a command that runs a plug-in in a process of its own, so that a crash there does
// not end this program.
std::vector<std::string> plugin_host(const std::string& plugin);
// The same command as a line for the shell.
std::string plugin_host_command(const std::string& plugin, const std::string& option = {});

// The path of a program that is built with this one. Its file lies beside this program's file, or
// where an installation puts helpers. The path is empty if there is no such file.
std::string helper_program(const std::string& name);

}  // namespace tribo::cli
