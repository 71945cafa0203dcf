// SPDX-License-Identifier: Apache-2.0
// The error that stops a report: bad scenes, missing files. Exit code 2.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tribo::report {

class ReportError : public std::runtime_error {
 public:
  explicit ReportError(const std::string& line) : std::runtime_error(line), lines_{line} {}
  explicit ReportError(std::vector<std::string> lines)
      : std::runtime_error(lines.empty() ? "unknown error" : lines.front()),
        lines_(std::move(lines)) {}

  // One problem a line.
  const std::vector<std::string>& lines() const { return lines_; }

 private:
  std::vector<std::string> lines_;
};

}  // namespace tribo::report
