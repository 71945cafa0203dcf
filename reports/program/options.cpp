// SPDX-License-Identifier: Apache-2.0
#include "options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>
#include <utility>

#include "scene/units.hpp"

namespace tribo::cli {
namespace {

std::string refusal(std::string_view option, std::string_view why) {
  return fmt::format("{} would be ignored {}; leave it out (see --help)", option, why);
}

std::vector<const CLI::Option*> given_options(const CLI::App& command) {
  return command.get_options([](const CLI::Option* option) { return option->count() > 0; });
}

std::string empty_option(const CLI::App& command) {
  for (const CLI::Option* option : given_options(command)) {
    const std::vector<std::string>& values = option->results();
    if (option->get_expected_min() > 0 &&
        std::find(values.begin(), values.end(), "") != values.end())
      return option->get_name() + ": nothing is given; leave it out, or give a value (see --help)";
  }
  return {};
}

std::optional<double> number_in(const std::string& text) {
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end) return std::nullopt;
  return number;
}

// The number of an option, with or without the unit that it may have.
std::optional<double> number_of(const std::string& text, std::string_view unit) {
  const auto decimal = unit.empty() ? std::nullopt : scene_detail::si_decimal(text, unit);
  return number_in(decimal ? *decimal : text);
}

}  // namespace

std::string ignored_option(const CLI::App& command, const std::vector<Ignored>& table) {
  if (std::string empty = empty_option(command); !empty.empty()) return empty;
  for (const CLI::App* below : command.get_subcommands()) {
    if (const auto before = given_options(command); !before.empty())
      return refusal(before.front()->get_name(),
                     fmt::format("in front of `{} {}`", command.get_name(), below->get_name()));
    if (std::string empty = empty_option(*below); !empty.empty()) return empty;
  }
  for (const Ignored& one : table)
    for (const std::string_view option : one.options)
      if (one.is_so && command.count(std::string(option)) > 0) return refusal(option, one.why);
  return {};
}

void add_number_option(CLI::App& app, const std::string& name, std::function<void(double)> store,
                       bool (*is_allowed)(double), const std::string& allowed,
                       const std::string& description, std::string_view unit) {
  const auto read = [=, store = std::move(store)](const std::string& text) {
    const std::optional<double> number = number_of(text, unit);
    if (!number || !is_allowed(*number))
      throw CLI::ValidationError(name, text + " is not allowed; allowed: " + allowed);
    store(*number);
  };
  app.add_option_function<std::string>(name, read, description);
}

void add_speed_option(CLI::App& app, std::function<void(double)> store) {
  add_number_option(
      app, "--speed", std::move(store),
      [](double speed) { return speed > 0 && std::isfinite(speed); },
      "a number above 0, in m/s, or with its unit: " +
          std::string(scene_detail::usual_units("m/s")),
      "this one speed, in m/s or with its unit, in place of the scenes' own", "m/s");
}

}  // namespace tribo::cli
