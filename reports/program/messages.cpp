// SPDX-License-Identifier: Apache-2.0
#include "messages.hpp"

#include <cstdio>
#include <string>

#include "tribo/scene_reader.hpp"

namespace tribo::cli {
namespace {

// Calls std::fwrite, because fmt::print throws where the write fails.
void write_line(std::string_view before, std::string_view text) {
  std::string line(before);
  line += printable(text, std::string::npos);
  line += '\n';
  std::fwrite(line.data(), 1, line.size(), stderr);
}

}  // namespace

void complain(std::string_view text) { write_line("tribocheck: ", text); }

void complain_of(std::string_view text, const std::vector<std::string>& lines) {
  if (!lines.empty()) complain(text);
  for (const std::string& line : lines) write_line("  ", line);
}

int fail(int code, std::string_view text) {
  complain(text);
  return code;
}

}  // namespace tribo::cli
