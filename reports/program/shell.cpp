// SPDX-License-Identifier: Apache-2.0
#include "shell.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "conformance/child_process.hpp"

namespace tribo::cli {
namespace {

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("_-./+,:@%=").find(c) != std::string_view::npos;
}

// Takes one word off the front of a command line. Empty where the shell would replace the word by
// another text.
std::optional<std::string> take_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t\n"), line.size()));
  std::string word;
  while (!line.empty()) {
    const char c = line.front();
    if (c == '\'' || c == '"') {
      const std::size_t end = line.find(c, 1);
      if (end == std::string_view::npos) return std::nullopt;
      const std::string_view inside = line.substr(1, end - 1);
      if (c == '"' && inside.find_first_of("$`\\") != std::string_view::npos) return std::nullopt;
      word += inside;
      line.remove_prefix(end + 1);
    } else if (is_plain(c)) {
      word += c;
      line.remove_prefix(1);
    } else if (std::string_view(" \t\n;&|<>").find(c) != std::string_view::npos) {
      break;
    } else {
      return std::nullopt;
    }
  }
  return word;
}

std::optional<std::string> program_of(std::string_view line) {
  std::optional<std::string> word = take_word(line);
  while (word && (*word == "exec" || word->find('=') != std::string::npos)) word = take_word(line);
  return word;
}

}  // namespace

std::string shell_word(const std::string& text) {
  if (!text.empty() && std::all_of(text.begin(), text.end(), is_plain)) return text;
  std::string word = "'";
  for (const char c : text) {
    if (c == '\'')
      word += "'\\''";
    else
      word += c;
  }
  return word + "'";
}

std::optional<std::vector<std::string>> words_of(const std::string& command) {
  std::vector<std::string> words;
  std::string_view line = command;
  while (true) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t\n"), line.size()));
    if (line.empty()) return words;
    const std::size_t before = line.size();
    std::optional<std::string> word = take_word(line);
    if (!word || line.size() == before) return std::nullopt;
    words.push_back(std::move(*word));
  }
}

std::string found_by_shell(const std::string& program) {
  const conformance::ChildEnd found =
      conformance::run_child({"/bin/sh", "-c", "command -v -- \"$1\"", "sh", program});
  if (found.start_error != 0) return program;  // starting the program will tell the error
  return found.text.substr(0, found.text.find('\n'));
}

std::optional<std::string> why_not_startable(const std::string& command) {
  const std::optional<std::string> program = program_of(command);
  if (!program || program->empty()) return std::nullopt;
  if (program->find('/') == std::string::npos) {
    if (!found_by_shell(*program).empty()) return std::nullopt;
    return fmt::format("no program {} is on PATH; install it, or give its path", *program);
  }
  std::error_code error;
  if (!std::filesystem::exists(*program, error))
    return fmt::format("there is no file {}; correct the path, or build it first", *program);
  if (std::filesystem::is_directory(*program, error))
    return fmt::format("{} is a folder; give a program", *program);
  if (::access(program->c_str(), X_OK) != 0)
    return fmt::format(
        "{} may not be executed; chmod +x it, or put the program that runs it in front", *program);
  return std::nullopt;
}

void check_solver(const std::string& plugin, const std::string& command) {
  if (plugin.empty()) {
    if (const std::optional<std::string> why_not = why_not_startable(command))
      throw std::invalid_argument("--subject: " + *why_not);
  } else if (!std::filesystem::exists(plugin)) {
    throw std::invalid_argument(
        fmt::format("--plugin: there is no file {}; correct the path, or build it first", plugin));
  }
}

std::string this_program() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

std::vector<std::string> plugin_host(const std::string& plugin) {
  return {this_program(), "plugin-host", plugin};
}

std::string plugin_host_command(const std::string& plugin, const std::string& option) {
  return fmt::format("exec {} plugin-host {}{}", shell_word(this_program()),
                     option.empty() ? "" : option + ' ', shell_word(plugin));
}

std::string helper_program(const std::string& name) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path here = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  for (const fs::path& path : {here / name, here.parent_path() / "libexec/tribocheck" / name})
    if (fs::is_regular_file(path, ignored)) return path;
  return {};
}

}  // namespace tribo::cli
