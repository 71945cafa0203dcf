// SPDX-License-Identifier: Apache-2.0
#include "profiler.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "conformance/callgrind_file.hpp"
#include "conformance/child_process.hpp"
#include "conformance/perf_script.hpp"
#include "page/project_files.hpp"
#include "shell.hpp"

namespace tribo::cli {
namespace {

namespace fs = std::filesystem;
using conformance::CallGraph;

std::string without_links(const std::string& path) {
  std::error_code error;
  const fs::path real = fs::canonical(path, error);
  return error ? path : real.string();
}

bool is_python(const std::string& program) {
  return fs::path(program).filename().string().starts_with("python");
}

// Is a program an interpreter? A profile would show its work in place of the solver's.
bool is_interpreter(const std::string& program) {
  constexpr auto known = std::to_array<std::string_view>(
      {"sh", "bash", "dash", "ksh", "zsh", "octave", "octave-cli", "julia", "java", "node",
       "nodejs", "perl", "ruby", "lua", "luajit", "pypy", "R", "Rscript", "matlab"});
  std::string name = fs::path(program).filename().string();
  name.resize(name.find_last_not_of("0123456789.-") + 1);  // lua5.4, octave-cli-7.3.0
  return std::find(known.begin(), known.end(), name) != known.end();
}

// The words of a script's first line, such as "#!/usr/bin/env python3", without env. The list is
// empty for any other file.
std::vector<std::string> interpreter_of(const std::string& program) {
  std::ifstream file(program, std::ios::binary);
  std::string line;
  std::getline(file, line);
  if (!line.starts_with("#!")) return {};
  std::istringstream stream(line.substr(2));
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
    if (fs::path(word).filename() != "env" && word != "-S") words.push_back(word);
  return words;
}

[[noreturn]] void refuse(const std::string& why) {
  throw std::invalid_argument("--subject: " + why);
}

constexpr const char* measurable =
    "what can be measured: a plug-in, a compiled program, `python3 solver.py`";

// Does a library belong to the system, and not to the solver?
bool is_of_system(const std::string& object) {
  return object.empty() || object == "???" || object.starts_with('[') ||
         object.starts_with("/usr/lib") || object.starts_with("/lib") ||
         object.starts_with("/usr/local/lib/valgrind");
}

// The source lines of addresses in a program or library. addr2line prints "FILE:NUMBER" for each,
// or "??:0" or "??:?" if it knows no line: then the file is empty and the number 0.
std::vector<CallGraph::Line> lines_of(const std::string& object,
                                      const std::vector<std::uint64_t>& addresses) {
  std::vector<std::string> command{"addr2line", "-e", object};
  for (const std::uint64_t address : addresses) command.push_back(fmt::format("{:x}", address));
  std::istringstream text(conformance::run_child(std::move(command)).text);
  std::vector<CallGraph::Line> lines;
  for (std::string line; std::getline(text, line);) {
    const std::size_t colon = line.rfind(':');
    std::uint64_t number = 0;  // stays 0 for "?"; " (discriminator 3)" may follow
    if (colon != line.npos)
      std::from_chars(line.data() + colon + 1, line.data() + line.size(), number);
    lines.emplace_back(number == 0 ? std::string() : line.substr(0, colon), number);
  }
  if (lines.size() != addresses.size())
    throw std::runtime_error("addr2line of binutils cannot read " + object);
  return lines;
}

}  // namespace

Profiler::Profiler(const std::string& plugin, const std::string& command, const std::string& tool) {
  check_solver(plugin, command);
  if (!plugin.empty()) {
    words_ = plugin_host(plugin);
    own_object_ = without_links(plugin);
    plain_ = plugin_host_command(plugin);
    choose_tool(tool);
    return;
  }
  const std::optional<std::vector<std::string>> words = words_of(command);
  if (!words || words->empty())
    refuse("only the shell can read this; give a program and its arguments alone");
  plain_ = command;
  take_program(*words);
  if (tool_ != Tool::cprofile)
    choose_tool(tool);
  else if (!tool.empty())
    throw std::invalid_argument(
        fmt::format("--tool: {} measures what is compiled; Python is measured by cProfile, leave "
                    "--tool out",
                    tool));
}

void Profiler::choose_tool(const std::string& tool) {
  const bool has_callgrind = !found_by_shell("valgrind").empty();
  const bool has_perf = !found_by_shell("perf").empty();
  tool_ =
      tool == "perf" || (tool.empty() && !has_callgrind && has_perf) ? Tool::perf : Tool::callgrind;
  if (tool_ == Tool::callgrind && !has_callgrind)
    throw std::invalid_argument(
        "valgrind is not installed, which counts the instructions of each line; apt-get install "
        "valgrind");
  if (tool_ == Tool::perf && !has_perf)
    throw std::invalid_argument(
        "perf is not installed, which takes the time of each line; apt-get install linux-perf");
}

// Finds the program among the words. `exec`, `env` and VARIABLE=VALUE may stand in front of it;
// `env` is put in front of the variables.
void Profiler::take_program(std::vector<std::string> words) {
  for (const char* const starter : {"exec", "env"})
    if (!words.empty() && fs::path(words.front()).filename() == starter) words.erase(words.begin());
  const auto program = std::find_if(words.begin(), words.end(), [](const std::string& word) {
    return word.find('=') == word.npos;
  });
  if (program == words.end()) refuse("it names no program");
  if (program->starts_with('-'))
    refuse(
        fmt::format("{} stands in place of a program; allowed in front of one: env, and "
                    "VARIABLE=VALUE",
                    *program));
  tool_place_ = static_cast<std::size_t>(program - words.begin());
  if (tool_place_ > 0) {
    words.insert(words.begin(), "env");
    ++tool_place_;
  }
  words_ = std::move(words);
  if (is_python(words_[tool_place_])) return take_python(tool_place_);
  const std::string path = found_by_shell(words_[tool_place_]);
  std::vector<std::string> interpreter = interpreter_of(path);
  if (!interpreter.empty()) {
    words_[tool_place_] = path;
    words_.insert(words_.begin() + static_cast<std::ptrdiff_t>(tool_place_), interpreter.begin(),
                  interpreter.end());
  }
  const std::string& first = words_[tool_place_];
  if (is_python(first)) return take_python(tool_place_);
  if (!interpreter.empty() || is_interpreter(first))
    refuse(fmt::format("the work of {} would be shown, not that of the solver that it runs; {}",
                       fs::path(first).filename().string(), measurable));
  own_object_ = without_links(path);
}

// cProfile's words stand in front of the script or of -m, behind the options of Python.
void Profiler::take_python(std::size_t at) {
  tool_ = Tool::cprofile;
  tool_place_ = at + 1;
  while (tool_place_ < words_.size() && words_[tool_place_].starts_with('-') &&
         words_[tool_place_] != "-m" && words_[tool_place_] != "-c")
    tool_place_ += words_[tool_place_] == "-W" || words_[tool_place_] == "-X" ? 2 : 1;
  if (tool_place_ >= words_.size() || words_[tool_place_] == "-c")
    refuse("cProfile measures a script or a module; give python3 solver.py, or python3 -m solver");
  if (words_[tool_place_] == "-m" && tool_place_ + 1 < words_.size())
    module_ = words_[tool_place_ + 1];
}

std::string Profiler::tool_name() const {
  if (tool_ == Tool::cprofile) return "cProfile";
  const bool is_perf = tool_ == Tool::perf;
  // "valgrind-3.19.0", "perf version 6.1.187"
  const std::string version =
      conformance::run_child({is_perf ? "perf" : "valgrind", "--version"}).text;
  const std::string text = version.substr(0, version.find('\n'));
  return (is_perf ? "perf " : "callgrind ") + text.substr(text.find_last_of("- ") + 1);
}

fs::path Profiler::raw_file(const fs::path& folder) const {
  return folder / (tool_ == Tool::callgrind ? "callgrind.out"
                   : tool_ == Tool::perf    ? "perf.data"
                                            : "profile.pstats");
}

std::vector<std::string> Profiler::command(const fs::path& folder) const {
  std::string raw = raw_file(fs::absolute(folder)).string();
  std::vector<std::string> tool;
  if (tool_ == Tool::callgrind) {
    for (std::size_t at = 0; (at = raw.find('%', at)) != raw.npos; at += 2)
      raw.insert(at, 1, '%');  // valgrind replaces %p and the like
    tool = {"valgrind", "-q", "--tool=callgrind", "--callgrind-out-file=" + raw};
  } else if (tool_ == Tool::perf) {
    // The samples are taken by cpu-clock, which every machine has. They hold the stack, which tells
    // the caller of a library.
    tool = {"perf", "record",       "-q",         "-e", "cpu-clock:u", "-F",
            "997",  "--call-graph", "dwarf,4096", "-o", raw,           "--"};
  } else {
    tool = {"-m", "cProfile", "-o", raw};
  }
  std::vector<std::string> words = words_;
  words.insert(words.begin() + static_cast<std::ptrdiff_t>(tool_place_), tool.begin(), tool.end());
  return words;
}

CallGraph Profiler::measured(const fs::path& folder) const {
  const fs::path raw = raw_file(folder);
  try {
    return tool_ == Tool::callgrind ? measured_instructions(raw)
           : tool_ == Tool::perf    ? measured_samples(raw)
                                    : measured_calls(raw);
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(raw.string() + ": " + error.what());
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(raw.string() + ": " + error.what());
  }
}

CallGraph::Kind Profiler::kind_of(const std::string& object) const {
  if (object == own_object_) return CallGraph::Kind::own;
  if (object == without_links(this_program())) return CallGraph::Kind::apart;
  return is_of_system(object) ? CallGraph::Kind::library : CallGraph::Kind::own;
}

CallGraph Profiler::measured_instructions(const fs::path& raw) const {
  std::ifstream text(raw);
  if (!text) throw std::runtime_error("valgrind left no such file");
  return conformance::read_callgrind(text,
                                     [this](const std::string& object) { return kind_of(object); });
}

CallGraph Profiler::measured_samples(const fs::path& raw) const {
  if (!fs::exists(raw)) throw std::runtime_error("perf left no such file");
  std::vector<std::string> command{"perf", "script", "-i", raw.string()};
  command.insert(command.end(), conformance::perf_script_options.begin(),
                 conformance::perf_script_options.end());
  const conformance::ChildEnd end = conformance::run_child(std::move(command));
  if (!end.succeeded()) throw std::runtime_error("perf cannot read it: see above");
  std::istringstream text(end.text);
  return conformance::read_perf_script(
      text, [this](const std::string& object) { return kind_of(object); }, lines_of);
}

CallGraph Profiler::measured_calls(const fs::path& raw) const {
  if (!fs::exists(raw)) throw std::runtime_error("cProfile left no such file");
  const std::string script = (report::usual_places().render / "python_calls.py").string();
  std::vector<std::string> command(words_.begin(),
                                   words_.begin() + static_cast<std::ptrdiff_t>(tool_place_));
  command.insert(command.end(), {"-B", script, raw.string()});
  if (!module_.empty()) command.push_back(module_);
  const conformance::ChildEnd end = conformance::run_child(std::move(command));
  if (!end.succeeded()) throw std::runtime_error("Python cannot read it: see above");
  CallGraph graph;
  const nlohmann::json said = nlohmann::json::parse(end.text);
  for (const nlohmann::json& one : said.at("functions")) {
    const auto kind = one.at("kind").get<std::string>();
    const std::size_t place = graph.functions.size();
    const CallGraph::Line line{one.at("file").get<std::string>(),
                               one.at("line").get<std::uint64_t>()};
    graph.functions.push_back({one.at("name").get<std::string>(),
                               {},
                               kind == "own"       ? CallGraph::Kind::own
                               : kind == "library" ? CallGraph::Kind::library
                                                   : CallGraph::Kind::apart,
                               one.at("calls").get<std::uint64_t>(),
                               {{line, one.at("seconds").get<double>()}}});
    for (const nlohmann::json& caller : one.at("callers"))
      graph.calls.push_back(
          {caller.at(0).get<std::size_t>(), place, {}, caller.at(1).get<double>()});
  }
  // cProfile does not know the line of a call: the first line of the caller stands for it.
  for (CallGraph::Call& call : graph.calls)
    call.line = graph.functions.at(call.caller).cost.begin()->first;
  return graph;
}

}  // namespace tribo::cli
