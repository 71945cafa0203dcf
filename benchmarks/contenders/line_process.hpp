// SPDX-License-Identifier: Apache-2.0
// A program that answers each line on its input with one on its output.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <string>
#include <vector>

namespace tribo::benchmarks {

class LineProcess {
 public:
  // Looked for in PATH. Its errors go nowhere.
  explicit LineProcess(const std::vector<std::string>& command);
  LineProcess(const LineProcess&) = delete;
  LineProcess& operator=(const LineProcess&) = delete;
  ~LineProcess();  // closes its input and waits for its end

  // Throws std::runtime_error where it has gone.
  void write_line(const std::string& line);
  std::string read_line();

 private:
  std::FILE* to_ = nullptr;
  std::FILE* from_ = nullptr;
  pid_t child_ = -1;
};

}  // namespace tribo::benchmarks
