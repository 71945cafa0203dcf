// SPDX-License-Identifier: Apache-2.0
// tribocheck profile: in which lines of a solver the time goes.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "build_info.hpp"
#include "command.hpp"
#include "conformance/busy_run.hpp"
#include "conformance/conformance.hpp"
#include "options.hpp"
#include "page/project_files.hpp"
#include "page/text_table.hpp"
#include "page/texts.hpp"
#include "picture.hpp"
#include "profiler.hpp"
#include "scene/schema.hpp"
#include "stop_signal.hpp"

namespace tribo::cli {
namespace {

namespace fs = std::filesystem;
using conformance::HotLine;
using conformance::TestCase;
using nlohmann::ordered_json;

struct ProfileArguments {
  std::string plugin, command, tool;
  std::vector<std::string> functions;  // empty: all that it offers
  std::string format = "table";
  std::string out;  // the folder for the tool's file; empty: the file is not kept
  std::size_t most = 20;
  std::string picture;  // empty: none
  double seconds = 1, start_timeout = 60, timeout = 600;

  const std::string& subject() const { return plugin.empty() ? command : plugin; }
};

// A folder that is removed at the end, unless it was given.
class WorkFolder {
 public:
  explicit WorkFolder(const std::string& given) : path_(given), is_kept_(!given.empty()) {
    if (is_kept_) {
      report::make_folder(path_);
      return;
    }
    std::string name = (fs::temp_directory_path() / "tribocheck-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw std::runtime_error(fmt::format("cannot make a folder in {}: {}",
                                           fs::temp_directory_path().string(),
                                           std::generic_category().message(errno)));
    path_ = name;
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  ~WorkFolder() {
    std::error_code ignored;
    if (!is_kept_) fs::remove_all(path_, ignored);
  }

  const fs::path& path() const { return path_; }
  bool is_kept() const { return is_kept_; }

 private:
  fs::path path_;
  bool is_kept_;
};

// --- The cases that keep the solver busy.

std::vector<std::string> functions_in(const std::vector<TestCase>& cases) {
  std::vector<std::string> names;
  for (const TestCase& one : cases)
    if (std::find(names.begin(), names.end(), one.function) == names.end())
      names.push_back(one.function);
  return names;
}

std::vector<TestCase> cases_of(const std::vector<std::string>& functions,
                               std::vector<TestCase> cases) {
  std::erase_if(cases, [&](const TestCase& one) {
    return std::find(functions.begin(), functions.end(), one.function) == functions.end();
  });
  return cases;
}

void check_names(const std::vector<std::string>& asked, const std::vector<TestCase>& cases) {
  const std::vector<std::string> known = functions_in(cases);
  const std::vector<std::string_view> names(known.begin(), known.end());
  for (const std::string& one : asked) {
    if (std::find(known.begin(), known.end(), one) != known.end()) continue;
    const std::string_view nearest = scene_detail::nearest_choice(one, names);
    throw std::invalid_argument(
        fmt::format("--function: {} is no function; {}", one,
                    nearest.empty() ? std::string("`tribocheck functions` lists them, and there is "
                                                  "operating_point")
                                    : fmt::format("did you mean {}?", nearest)));
  }
}

struct Offered {
  std::vector<TestCase> cases;  // that the solver answers
  bool answers_at_end_of_input = false;
};

// Asks three cases of each function. This shows whether answers come only at the end of the input.
// If they come at once, more cases are asked, because a solver may skip many cases of a function:
// all cases of the functions that --function names, else 20 cases of each function.
Offered offered_by(const Profiler& profiler, const ProfileArguments& arguments,
                   const std::vector<TestCase>& cases) {
  conformance::Limits limits;
  limits.first_answer = milliseconds(arguments.start_timeout);
  // The input of a subject that is silent for so long is closed: it may answer only then.
  limits.one_case = std::min(limits.one_case, limits.first_answer / 2);
  limits.all_cases = milliseconds(arguments.timeout);
  std::vector<TestCase> asked;
  conformance::Conversation conversation;
  const std::size_t all = 0, some = 20, few = 3;
  for (const std::size_t sample : {few, arguments.functions.empty() ? some : all}) {
    if (conversation.answers_at_end_of_input) break;
    asked = conformance::cases_for(cases, conformance::engineering_tolerance(), sample);
    conversation = conformance::ask(profiler.plain_command(), asked, limits, [](std::size_t) {});
    if (!conversation.never_answered.empty()) {
      complain_of("the last it wrote to stderr:", conversation.error_lines);
      throw std::invalid_argument(
          fmt::format("{} never answered: {}", arguments.subject(), conversation.never_answered));
    }
  }
  std::vector<TestCase> answered;
  for (std::size_t i = 0; i < asked.size(); ++i)
    if (conversation.answers[i].outcome == conformance::Outcome::answered)
      answered.push_back(asked[i]);
  const std::vector<std::string> offered = functions_in(answered);
  for (const std::string& one : arguments.functions)
    if (std::find(offered.begin(), offered.end(), one) == offered.end())
      throw std::invalid_argument(
          fmt::format("--function: {} does not offer {}", arguments.subject(), one));
  if (offered.empty())
    throw std::invalid_argument(arguments.subject() + " offers nothing that could be measured");
  return {std::move(answered), conversation.answers_at_end_of_input};
}

// --- Telling.

struct Profile {
  std::string subject, tool, unit;
  std::vector<std::string> functions;  // that were asked
  std::size_t answers = 0;
  double total = 0;  // cost of all lines
  std::vector<HotLine> lines;
  std::string raw_file;  // empty: it was not kept
  Profiler::Tool kind;

  bool counts_instructions() const { return kind == Profiler::Tool::callgrind; }
  bool counts_calls() const { return kind != Profiler::Tool::perf; }
};

std::string file_text(const HotLine& line) {
  if (line.file.empty()) return fs::path(line.object).filename().string();
  const fs::path below = fs::path(line.file).lexically_proximate(fs::current_path());
  return below.string().starts_with("..") ? line.file : below.string();
}

std::string place_text(const HotLine& line) {
  return line.line == 0 ? file_text(line) : fmt::format("{}:{}", file_text(line), line.line);
}

// The source text of a line; empty if it cannot be read.
std::string source_of(const HotLine& line) {
  constexpr std::size_t most_signs = 60;
  std::ifstream file(line.file);
  std::string text;
  for (std::uint64_t i = 0; i < line.line && std::getline(file, text); ++i) {
  }
  if (line.line == 0 || !file) return {};
  text.erase(0, text.find_first_not_of(" \t"));
  return printable(text, most_signs);
}

report::TextTable table_of(const Profile& profile, std::size_t shown) {
  const bool counts = profile.counts_instructions();
  report::TextTable table{
      fmt::format("{}: where the {}", profile.subject, counts ? "instructions go" : "time goes"),
      {"share", counts ? "instructions" : "time, s", "calls", "place", "function", "source"},
      {true, true, true, false, false, false},
      {},
      ""};
  for (std::size_t i = 0; i < shown; ++i) {
    const HotLine& line = profile.lines[i];
    table.rows.push_back({fmt::format("{:.1f} %", 100 * line.cost / profile.total),
                          counts ? report::grouped(static_cast<std::uint64_t>(line.cost))
                                 : fmt::format("{:.3f}", line.cost),
                          profile.counts_calls() ? report::grouped(line.calls) : "",
                          place_text(line), line.function, source_of(line)});
  }
  return table;
}

std::string left_out(const Profile& profile, std::size_t shown) {
  double cost = 0;
  for (std::size_t i = shown; i < profile.lines.size(); ++i) cost += profile.lines[i].cost;
  return fmt::format("{} more with {:.1f} % of the whole", profile.lines.size() - shown,
                     100 * cost / profile.total);
}

void append_table(Text& to, const Profile& profile, std::size_t most) {
  constexpr double least_share = 5e-4;  // is shown as 0.1 %
  std::size_t shown = 0;
  while (shown < std::min(most, profile.lines.size()) &&
         profile.lines[shown].cost >= least_share * profile.total)
    ++shown;
  append(to, report::plain_table(table_of(profile, shown)) + '\n');
  const auto note = [&](const std::string& words) {
    const char* before = "  - ";
    for (const std::string& line : report::wrapped(printable(words, words.npos), 92))
      append(to, std::exchange(before, "    ") + line + '\n');
  };
  if (profile.lines.size() > shown) note(left_out(profile, shown));
  note(fmt::format("measured by {} in {} answers of {}", profile.tool,
                   report::grouped(profile.answers), fmt::join(profile.functions, ", ")));
  if (profile.kind != Profiler::Tool::cprofile) {
    note(fmt::format(
        "the {} of libraries belong{} to the line that calls them; {} of tribocheck {} left out",
        profile.counts_instructions() ? "instructions" : "time",
        profile.counts_instructions() ? "" : "s", profile.counts_instructions() ? "those" : "that",
        profile.counts_instructions() ? "are" : "is"));
    if (profile.lines.front().line == 0)
      note("it has no line numbers: build it with -g, and optimized as before");
  } else {
    note(
        "cProfile knows functions, not lines: a place is where a function begins. The time of "
        "libraries belongs to the function that calls them; reading, JSON, writing and imports "
        "are left out");
  }
  note(profile.raw_file.empty()
           ? "--out FOLDER keeps the file of the tool"
           : fmt::format("{}: for {}", profile.raw_file,
                         profile.counts_instructions() ? "callgrind_annotate or kcachegrind"
                         : profile.kind == Profiler::Tool::perf ? "perf report -i"
                                                                : "python3 -m pstats"));
}

std::string json_text(const Profile& profile, std::size_t most) {
  ordered_json object{{"subject", profile.subject},
                      {"tool", profile.tool},
                      {"unit", profile.unit},
                      {"functions", profile.functions},
                      {"answers", profile.answers},
                      {"total", profile.total},
                      {"raw_file", profile.raw_file.empty() ? ordered_json(nullptr)
                                                            : ordered_json(profile.raw_file)},
                      {"lines", ordered_json::array()}};
  for (std::size_t i = 0; i < std::min(most, profile.lines.size()); ++i) {
    const HotLine& line = profile.lines[i];
    object["lines"].push_back(
        {{"file", line.file.empty() ? line.object : line.file},
         {"line", line.line == 0 ? ordered_json(nullptr) : ordered_json(line.line)},
         {"function", line.function},
         {"calls", profile.counts_calls() ? ordered_json(line.calls) : ordered_json(nullptr)},
         {"cost", line.cost},
         {"share", line.cost / profile.total}});
  }
  return document("profile/1", object).dump(1, ' ', false, ordered_json::error_handler_t::replace) +
         "\n";
}

// --- The command.

int measure(const ProfileArguments& arguments, OutputStream& output) {
  if (arguments.subject().empty())
    throw std::invalid_argument(
        "profile: nothing to measure is given; allowed: --plugin LIB, or "
        "--subject COMMAND");
  const report::ReferenceFiles files = report::reference_files({});
  std::vector<TestCase> cases = conformance::read_cases({files.exact, files.published});
  cases = conformance::cases_for(std::move(cases), conformance::engineering_tolerance());
  check_names(arguments.functions, cases);
  if (!arguments.functions.empty()) cases = cases_of(arguments.functions, std::move(cases));
  const Profiler profiler(arguments.plugin, arguments.command, arguments.tool);
  const Offered offered = offered_by(profiler, arguments, cases);

  watch_for_stop();
  const WorkFolder folder(arguments.out);
  std::error_code ignored;
  fs::remove(profiler.raw_file(folder.path()), ignored);
  conformance::BusySettings settings;
  settings.work = milliseconds(arguments.seconds);
  settings.limit = milliseconds(arguments.timeout);
  settings.answers_at_end_of_input = offered.answers_at_end_of_input;
  settings.stopped = [] { return stop_signal() != 0; };
  const conformance::BusyRun run =
      conformance::keep_busy(profiler.command(folder.path()), offered.cases, settings);
  if (run.was_stopped) return 128 + stop_signal();
  if (!run.failure.empty()) {
    complain(fmt::format("{} under {} {}", arguments.subject(), profiler.tool_name(), run.failure));
    complain_of("the last it wrote to stderr:", run.error_lines);
    return exit_failed;
  }
  Profile profile{arguments.subject(),
                  profiler.tool_name(),
                  profiler.unit(),
                  functions_in(offered.cases),
                  run.answers,
                  0,
                  conformance::hot_lines(profiler.measured(folder.path())),
                  folder.is_kept() ? profiler.raw_file(folder.path()).string() : std::string(),
                  profiler.tool()};
  for (const HotLine& line : profile.lines) profile.total += line.cost;
  if (profile.lines.empty())
    throw std::runtime_error(profile.tool + " saw no work of the solver's own");
  if (arguments.format == "json")
    append(output.text(), json_text(profile, arguments.most));
  else
    append_table(output.text(), profile, arguments.most);
  output.flush();
  const bool is_drawn =
      arguments.picture.empty() ||
      draw_picture("profile_picture.py", json_text(profile, arguments.most), arguments.picture);
  return is_drawn ? exit_done : exit_failed;
}

constexpr const char* profile_footer =
    R"(The solver answers certified cases of each function for about a second (--seconds). What is compiled is measured by
callgrind of valgrind, which counts the instructions of each line (build with -g, and optimized as you ship
it), or with --tool perf by that, which takes the time of each line; Python by cProfile, which takes the time
of each function. Work in libraries, such as exp(), belongs to
the line that calls it; that of tribocheck is left out.
Exit code 0: done; 1: the solver failed under the tool, or the picture
is missing; 2: bad usage, or it cannot be started or measured.

Example:
  tribocheck profile --plugin ./libmine.so
  tribocheck profile --subject 'python3 my_solver.py' --function gaussian_moment
  tribocheck profile --plugin ./libmine.so --tool perf --seconds 5
  tribocheck profile --plugin ./libmine.so --out profile && kcachegrind profile/callgrind.out)";

}  // namespace

Command add_profile(CLI::App& program) {
  CLI::App* app = program.add_subcommand("profile", "in which lines of your solver the time goes");
  app->footer(profile_footer);
  const auto arguments = std::make_shared<ProfileArguments>();
  CLI::Option* const command =
      app->add_option("--subject", arguments->command,
                      "command line of a program that answers JSON lines: compiled, or Python");
  app->add_option("--plugin", arguments->plugin, "shared library with the plug-in functions")
      ->excludes(command);
  app->add_option("--function", arguments->functions,
                  "measure this function; may be repeated (default: all that it offers)")
      ->allow_extra_args(false);
  app->add_option(
         "--tool", arguments->tool,
         "what measures a compiled solver (default: callgrind; perf where callgrind alone is "
         "missing)")
      ->check(CLI::IsMember({"callgrind", "perf"}));
  app->add_option("--most", arguments->most, "show so many lines, the worst (default: 20)")
      ->check(CLI::Range(1, 100'000));
  app->add_option("--format", arguments->format, "how to write them (default: table)")
      ->check(CLI::IsMember({"table", "json"}));
  app->add_option("--out", arguments->out, "keep the file of the tool in this folder");
  add_picture_option(*app, arguments->picture, "the shares");
  app->add_option("--seconds", arguments->seconds, "keep the solver busy so long (default: 1)")
      ->check(CLI::Range(0.01, 1e5));
  app->add_option("--start-timeout", arguments->start_timeout,
                  "seconds from a start to the first answer (default: 60)")
      ->check(CLI::Range(0.01, 1e5));
  app->add_option("--timeout", arguments->timeout, "seconds for the whole run (default: 600)")
      ->check(CLI::Range(0.01, 1e6));
  return {app, [arguments](OutputStream& output) {
            return answered_or_complained([&] { return measure(*arguments, output); });
          }};
}

}  // namespace tribo::cli
