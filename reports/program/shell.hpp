// SPDX-License-Identifier: Apache-2.0
// Words and commands of /bin/sh, which starts subjects and is what a user copies a line into.
#pragma once

#include <optional>
#include <string>

namespace tribo::cli {

// A text as one word of a command line; in quotes only where it needs them.
std::string shell_word(const std::string& text);

// Where the shell finds a program: its path, or the name itself of what is built into the shell.
// Empty where it finds none.
std::string found_by_shell(const std::string& program);

// Why the program that a command line starts with cannot be started, and what to do; nothing where
// it can, or where the line starts with what only the shell can read, as a variable.
std::optional<std::string> why_not_startable(const std::string& command);

}  // namespace tribo::cli
