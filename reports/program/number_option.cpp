// SPDX-License-Identifier: Apache-2.0
#include "number_option.hpp"

#include <charconv>
#include <system_error>
#include <utility>

namespace tribo::cli {

CLI::Option* add_number_option(CLI::App& app, const std::string& name,
                               std::function<void(double)> store, bool (*is_allowed)(double),
                               const std::string& allowed, const std::string& description) {
  const auto read = [=, store = std::move(store)](const std::string& text) {
    double number = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || stop != end || !is_allowed(number))
      throw CLI::ValidationError(name, text + " is not allowed; allowed: " + allowed);
    store(number);
  };
  return app.add_option_function<std::string>(name, read, description);
}

}  // namespace tribo::cli
