// SPDX-License-Identifier: Apache-2.0
// Options that are numbers.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace tribo::cli {

// Not CLI11's own conversion, which rounds twice and lets "nan" through. `allowed` says in words
// what `is_allowed` takes.
CLI::Option* add_number_option(CLI::App& app, const std::string& name,
                               std::function<void(double)> store, bool (*is_allowed)(double),
                               const std::string& allowed, const std::string& description);

}  // namespace tribo::cli
