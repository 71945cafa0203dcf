// SPDX-License-Identifier: Apache-2.0
// Options that are numbers, and options that would be ignored: each one does what it says, or is
// refused by one line.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tribo::cli {

// Options that mean nothing where `is_so`, as other options make it.
struct Ignored {
  std::vector<std::string_view> options;
  bool is_so;
  std::string why;  // "without --subject", "beside --show": ends the sentence of the refusal
};

// The refusal of the first option of a parsed command that would be ignored: one of the table, one
// in front of a subcommand, or one without a value, as an unset variable of a shell gives it. Empty
// where there is none. An option whose value may be empty expects 0 to 1 values.
std::string ignored_option(const CLI::App& command, const std::vector<Ignored>& table);

// Not CLI11's own conversion, which rounds twice and lets "nan" through. `allowed` says in words
// what `is_allowed` takes.
CLI::Option* add_number_option(CLI::App& app, const std::string& name,
                               std::function<void(double)> store, bool (*is_allowed)(double),
                               const std::string& allowed, const std::string& description);

}  // namespace tribo::cli
