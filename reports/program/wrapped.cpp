// SPDX-License-Identifier: Apache-2.0
#include "wrapped.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

#include "page/text_table.hpp"

namespace tribo::cli {
namespace {

// Characters, not bytes: all but the later bytes of a character in UTF-8.
std::size_t columns(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

// Where a line goes on: below the description of an option, else below its own start.
std::size_t indent_of(const std::string& line) {
  const std::size_t start = line.find_first_not_of(' ');
  if (start == 0 || start == std::string::npos) return 0;
  const std::size_t gap = line.find("  ", start);
  const std::size_t description =
      gap == std::string::npos ? std::string::npos : line.find_first_not_of(' ', gap);
  return description == std::string::npos ? start : columns(line.substr(0, description));
}

void append_wrapped(std::string& to, const std::string& line, std::size_t width) {
  const std::size_t indent = indent_of(line);
  if (columns(line) <= width || indent >= width) {
    to += line + '\n';
    return;
  }
  // The text in front of the indent, an option with its type, is ASCII and stays as it is.
  const std::vector<std::string> parts = report::wrapped(line.substr(indent), width - indent);
  for (std::size_t i = 0; i < parts.size(); ++i)
    to += (i == 0 ? line.substr(0, indent) : std::string(indent, ' ')) + parts[i] + '\n';
}

bool is_prose(const std::string& line) {
  return !line.empty() && line.front() != ' ' && !line.starts_with("Usage:");
}

}  // namespace

std::string wrapped_help(const std::string& help, std::size_t width) {
  std::vector<std::string> lines;
  std::istringstream stream(help);
  bool is_example = false;
  for (std::string line; std::getline(stream, line);) {
    const std::size_t previous = lines.size() - 1;
    const bool goes_on = !is_example && !lines.empty() && is_prose(line) &&
                         is_prose(lines[previous]) && columns(lines[previous]) > 60 &&
                         !lines[previous].ends_with(':');
    is_example = is_example || line == "Example:";
    if (goes_on)
      lines[previous] += ' ' + line;
    else
      lines.push_back(line);
  }
  std::string text;
  is_example = false;
  for (const std::string& line : lines) {
    if (line == "Example:") is_example = true;
    if (is_example && line.starts_with(' '))
      text += line + '\n';
    else
      append_wrapped(text, line, width);
  }
  return text;
}

}  // namespace tribo::cli
