// SPDX-License-Identifier: Apache-2.0
// Errors about what a file holds name the file.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace tribo::reproduction {

// Returns what `read` returns. If `read` throws a std::runtime_error, puts the path in front of the
// message, unless it is there already.
template <class Read>
auto in_file(const std::string& path, Read&& read) {
  try {
    return read();
  } catch (const std::runtime_error& error) {
    const std::string what = error.what();
    throw std::runtime_error(what.starts_with(path) ? what : fmt::format("{}: {}", path, what));
  }
}

}  // namespace tribo::reproduction
