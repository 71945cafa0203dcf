// SPDX-License-Identifier: Apache-2.0
// The way to measure a solver: callgrind or perf for what is compiled, cProfile for Python.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "conformance/call_graph.hpp"

namespace tribo::cli {

class Profiler {
 public:
  enum class Tool : std::uint8_t { callgrind, perf, cprofile };

  // One of --plugin and --subject is given, the other one is empty. `tool`, of what is compiled:
  // callgrind or perf; empty: callgrind, or perf where callgrind alone is missing. Throws
  // std::invalid_argument with one line where it cannot be measured: it is not there, it is an
  // interpreter of another language, only the shell can read its command line, or the tool is not
  // installed.
  Profiler(const std::string& plugin, const std::string& command, const std::string& tool);

  Tool tool() const { return tool_; }
  // "callgrind 3.19.0", "perf 6.1.187"; of cProfile the version of Python follows from measured().
  std::string tool_name() const;
  std::string unit() const { return tool_ == Tool::callgrind ? "instructions" : "s"; }
  const std::string& plain_command() const { return plain_; }  // of the shell, without the tool

  // The file that the tool writes in a folder, and the command that makes it write.
  std::filesystem::path raw_file(const std::filesystem::path& folder) const;
  std::vector<std::string> command(const std::filesystem::path& folder) const;

  // The result of the tool. Throws std::runtime_error with one line.
  conformance::CallGraph measured(const std::filesystem::path& folder) const;

 private:
  void choose_tool(const std::string& tool);
  conformance::CallGraph::Kind kind_of(const std::string& object) const;
  void take_program(std::vector<std::string> words);
  void take_python(std::size_t at);
  conformance::CallGraph measured_calls(const std::filesystem::path& raw) const;
  conformance::CallGraph measured_instructions(const std::filesystem::path& raw) const;
  conformance::CallGraph measured_samples(const std::filesystem::path& raw) const;

  Tool tool_ = Tool::callgrind;
  std::string plain_;
  std::vector<std::string> words_;  // of the solver's command
  std::size_t tool_place_ = 0;      // of the tool's words, in front of this one of them
  std::string own_object_;          // the library or program, without links
  std::string module_;              // of Python's -m
};

}  // namespace tribo::cli
