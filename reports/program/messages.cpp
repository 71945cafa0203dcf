// SPDX-License-Identifier: Apache-2.0
#include "messages.hpp"

#include <cstdio>
#include <string>

namespace tribo::cli {

void complain(std::string_view text) {
  std::string line = "tribocheck: ";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    line += code < 0x20 || code == 0x7F ? ' ' : c;
  }
  line += '\n';
  // Not fmt::print, which throws where the write fails.
  std::fwrite(line.data(), 1, line.size(), stderr);
}

}  // namespace tribo::cli
