// SPDX-License-Identifier: Apache-2.0
// The way to measure a solver: callgrind or perf for what is compiled, cProfile for Python.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "conformance/call_graph.hpp"

namespace tribo::cli {

class Profiler {
 public:
  enum class Tool : std::uint8_t { callgrind, perf, cprofile };

  // One of --plugin and --subject is given, and the other one is empty. `tool` is for compiled
  // solvers: callgrind or perf; empty: callgrind, or perf if only callgrind is missing. Throws
  // std::invalid_argument with one line where the solver cannot be measured: the solver is missing,
  // its program is an interpreter of another language than Python, only the shell can read its
  // command line, or the tool is not installed.
  Profiler(const std::string& plugin, const std::string& command, const std::string& tool);

  Tool tool() const { return tool_; }
  // "callgrind 3.19.0", "perf 6.1.187", or "cProfile" without a version.
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
  std::size_t tool_place_ = 0;      // the tool's words are put in front of this one of words_
  std::string own_object_;          // the library or program, without links
  std::string module_;              // of Python's -m
};

}  // namespace tribo::cli
