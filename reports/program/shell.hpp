// SPDX-License-Identifier: Apache-2.0
// Words and command lines of /bin/sh: this shell starts subjects, and users paste lines of the
// program's output into it. And where the programs are that are installed with this one.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tribo::cli {

// A text as one word of a command line; in quotes only where it needs them.
std::string shell_word(const std::string& text);

// The words of a command line; empty where only the shell can read it, as it has variables, pipes
// or other signs of the shell.
std::optional<std::vector<std::string>> words_of(const std::string& command);

// The path at which the shell finds a program. Where the command is built into the shell, or no
// shell can be started, it is the name that was given. Empty where the shell finds no such program.
std::string found_by_shell(const std::string& program);

// Why the program at the start of a command line cannot be started, and what to do. Empty if it can
// be started, or if the line begins with something that only the shell can read, as a variable.
std::optional<std::string> why_not_startable(const std::string& command);

// Throws std::invalid_argument with one line where a plug-in is not there, or the program of a
// subject's command line cannot be started. One of them is given, the other one is empty.
void check_solver(const std::string& plugin, const std::string& command);

std::string this_program();  // the path of its file

// The words that run a plug-in in a process of its own, so that its crash does not end this one,
// and the same words as a command line of the shell.
std::vector<std::string> plugin_host(const std::string& plugin);
std::string plugin_host_command(const std::string& plugin, const std::string& option = {});

// The path of a program that is built with this one: beside it, or where an installation puts
// helpers. Empty where it is not there.
std::string helper_program(const std::string& name);

}  // namespace tribo::cli
