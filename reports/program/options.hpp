// SPDX-License-Identifier: Apache-2.0
// Options that are numbers, and options that a command would ignore: an option either has an
// effect, or one line refuses it.
#pragma once

#include <CLI/CLI.hpp>
#include <chrono>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tribo::cli {

// If `is_so`, these options would have no effect beside the others that are given.
struct Ignored {
  std::vector<std::string_view> options;
  bool is_so;
  std::string why;  // "without --subject", "beside --show": ends the sentence of the refusal
};

// The refusal of the first given option that would be ignored; empty if there is none. These are
// refused: options of the table, options in front of a subcommand, and options whose value is
// empty, as when a variable of the shell is not set. An option whose value may be empty has to be
// declared with 0 to 1 values.
std::string ignored_option(const CLI::App& command, const std::vector<Ignored>& table);

// A limit of time that an option gives in seconds.
inline std::chrono::milliseconds milliseconds(double seconds) {
  return std::chrono::milliseconds(static_cast<long long>(1000 * seconds));
}

// Adds an option that is a number. CLI11's own conversion rounds twice and lets "nan" through.
// `allowed` tells in words which numbers `is_allowed` takes. With a `unit`, such as "m/s" or "%",
// the number may have a unit, as in scenes. A number in % is stored as a part of 1.
void add_number_option(CLI::App& app, const std::string& name, std::function<void(double)> store,
                       bool (*is_allowed)(double), const std::string& allowed,
                       const std::string& description, std::string_view unit = {});

// Adds --speed, which takes one speed in place of those of the scenes.
void add_speed_option(CLI::App& app, std::function<void(double)> store);

}  // namespace tribo::cli
