// SPDX-License-Identifier: Apache-2.0
#include "page/gnuplot.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "page/child_process.hpp"

namespace tribo::report {
namespace {

// The end of what gnuplot said, on one line: it repeats the whole command before the reason.
std::string reason_in(const std::string& said) {
  constexpr std::size_t longest = 300;
  std::string line;
  for (const char sign : said) {
    const bool blank = sign == '\n' || sign == '\t' || sign == ' ';
    if (!blank)
      line += sign;
    else if (!line.empty() && line.back() != ' ')
      line += ' ';
  }
  if (line.size() <= longest) return line;
  const std::size_t word = line.find(' ', line.size() - longest);
  return "…" + line.substr(word == std::string::npos ? line.size() - longest : word);
}

}  // namespace

GnuplotRun run_gnuplot(const std::filesystem::path& script,
                       const std::vector<std::string>& arguments) {
  std::vector<std::string> command{"gnuplot", "-d", "-c", script.string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  const ChildEnd end = run_child(std::move(command), Heard::last_errors);
  if (end.start_error == ENOENT || end.start_error == EACCES || end.start_error == ENOTDIR)
    return {GnuplotEnd::not_found, "gnuplot was not found in PATH"};
  if (end.start_error != 0)
    return {GnuplotEnd::failed,
            "gnuplot cannot be started: " + std::generic_category().message(end.start_error)};
  if (end.succeeded()) return {GnuplotEnd::drawn, {}};
  if (end.signal() != 0)
    return {GnuplotEnd::failed, fmt::format("gnuplot ended by signal {}", end.signal())};
  return {GnuplotEnd::failed, "gnuplot: " + reason_in(end.text)};
}

}  // namespace tribo::report
