// SPDX-License-Identifier: Apache-2.0
// All commands share this: the text of the help, bad usage, exit codes. Results go to stdout, all
// else to stderr.
#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "build_info.hpp"
#include "command.hpp"
#include "messages.hpp"
#include "page/text_table.hpp"
#include "protocol/text_streams.hpp"
#include "scene/schema.hpp"
#include "scene_arguments.hpp"
#include "table.hpp"

namespace tribo::cli {
namespace {

constexpr const char* program_footer =
    R"(Results go to stdout, all else to stderr. Exit code 0: done; 1: a check failed, or results could
not be written; 2: bad usage or input.

Example:
  tribocheck solve reference/published/rough.toml
Scenes to start from are in reference/scenes. The paper, whose model this is, is by D. Gasni: The
influence of surface roughness on starvation in a point contact. Its scenes are in
reference/published, its sweeps in reference/published/sweeps.
See also: tribocheck solve --help)";

constexpr std::size_t description_column = 34;

// The column at which a wrapped line goes on: that of an option's description, else of its start.
std::size_t indent_of(const std::string& line) {
  const std::size_t start = line.find_first_not_of(' ');
  if (start == 0 || start == std::string::npos) return 0;
  // One space parts a description from an option or argument that nearly fills its column.
  const bool is_option = line.starts_with("  -") || line.find(" TEXT") < description_column;
  if (is_option && line.size() > description_column && line[description_column - 1] == ' ')
    return description_column;
  const std::size_t gap = line.find("  ", start);
  const std::size_t description =
      gap == std::string::npos ? std::string::npos : line.find_first_not_of(' ', gap);
  return description == std::string::npos ? start : report::width_of(line.substr(0, description));
}

void append_wrapped(std::string& to, const std::string& line, std::size_t width) {
  const std::size_t indent = indent_of(line);
  if (report::width_of(line) <= width || indent >= width) {
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

// The help on 80 columns, because CLI11 2.1 does not wrap lines. Descriptions of options go on in
// their column, and paragraphs are filled anew. Indented lines after "Example:" can be copied.
std::string wrapped_help(const std::string& help) {
  constexpr std::size_t width = 80;
  std::vector<std::string> lines;
  std::istringstream stream(help);
  bool is_example = false;
  for (std::string line; std::getline(stream, line);) {
    const std::size_t previous = lines.size() - 1;
    const bool goes_on = !is_example && !lines.empty() && is_prose(line) &&
                         is_prose(lines[previous]) && report::width_of(lines[previous]) > 60 &&
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

// The fault of the first argument, which names the command; empty if there is no fault.
std::string command_fault(const CLI::App& program, int count, char** arguments) {
  std::vector<std::string_view> names;
  for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
  const std::string known = fmt::format("the commands are {} (see --help)", fmt::join(names, ", "));
  if (count < 2) return "no command is given; " + known;
  const std::string word = arguments[1];
  if (word.starts_with('-') && word.size() > 1) {
    if (program.get_option_no_throw(word) != nullptr) return {};
    return fmt::format("unknown option \"{}\" in front of the command; {}", printable(word), known);
  }
  if (std::find(names.begin(), names.end(), word) != names.end()) return {};
  const std::string_view nearest = scene_detail::nearest_choice(word, names);
  return fmt::format("unknown command \"{}\"; {}", printable(word),
                     nearest.empty() ? known : fmt::format("did you mean {}?", nearest));
}

// CLI11 throws for --help and --version too.
int answer_parse_error(const CLI::App& program, const CLI::ParseError& error,
                       OutputStream& output) {
  if (error.get_exit_code() == 0) {
    std::ostringstream text;
    program.exit(error, text, text);
    const bool is_version = error.get_name() == "CallForVersion";  // one line, which programs read
    append(output.text(), is_version ? text.str() : wrapped_help(text.str()));
    output.flush();
    return exit_done;
  }
  return fail(exit_bad, std::string(error.what()) + " (see --help)");
}

// CLI11 2.1 takes "[name]" for a list, even if it is a file's name; "./" in front prevents that.
std::vector<std::string> guarded(int count, char** arguments) {
  std::vector<std::string> result;
  for (int i = count - 1; i > 0; --i) {  // CLI11 wants them in reverse order
    const std::string argument = arguments[i];
    const bool in_brackets = argument.starts_with('[') && argument.ends_with(']');
    result.push_back(in_brackets ? "./" + argument : argument);
  }
  return result;
}

int run(std::span<const AddCommand> commands, int count, char** arguments, OutputStream& output) {
  CLI::App program(
      "Starved, rough point contacts: film, load shares, friction, onset of starvation");
  program.name("tribocheck");
  program.footer(footer_with_scenes(program_footer));
  program.set_version_flag("--version", version_line);
  program.get_formatter()->column_width(description_column);
  program.require_subcommand(1);
  std::vector<Command> added;
  for (const AddCommand add : commands) {
    added.push_back(add(program));
    added.back().app->set_version_flag("--version", version_line);
  }
  if (const std::string fault = command_fault(program, count, arguments); !fault.empty())
    return fail(exit_bad, fault);
  try {
    program.parse(guarded(count, arguments));
  } catch (const CLI::ParseError& error) {
    return answer_parse_error(program, error, output);
  }
  int exit_code = exit_bad;
  for (const Command& command : added) {
    if (!command.app->parsed()) continue;
    const std::string refusal =
        ignored_option(*command.app, command.ignored ? command.ignored() : std::vector<Ignored>{});
    if (refusal.empty())
      exit_code = command.run(output);
    else
      complain(refusal);
  }
  output.flush();
  return exit_code;
}

// If stdin, stdout or stderr is closed, a file that is opened later would get its number, and
// output would overwrite the file. Each closed stream is replaced by a descriptor on which reading
// or writing fails, as on a closed stream.
void occupy_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) >= 0) continue;
    // The file gets the lowest free number, that of this stream.
    if (::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0) return;
  }
}

}  // namespace

int run_program(std::span<const AddCommand> commands, int count, char** arguments) {
  occupy_closed_streams();
  std::signal(SIGPIPE, SIG_IGN);  // a reader that goes away shows as a failed write
  OutputStream output(STDOUT_FILENO);
  try {
    return run(commands, count, arguments, output);
  } catch (const OutputClosed&) {
    return exit_done;
  } catch (const report::ReportError& error) {
    for (const std::string& line : error.lines()) complain(line);
    return exit_bad;
  } catch (const protocol::InputFailed& failure) {
    return fail(exit_bad, failure.what());
  } catch (const std::exception& failure) {
    return fail(exit_failed, failure.what());
  }
}

}  // namespace tribo::cli
