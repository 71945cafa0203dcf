// SPDX-License-Identifier: Apache-2.0
// The output of a command: results, which go through the protocol's output stream, lines on stderr,
// and the exit code. Bad input gives one line for each mistake, and has its own exit code.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "page/project_files.hpp"
#include "protocol/text_streams.hpp"

namespace tribo::cli {

using protocol::append;
using protocol::OutputClosed;
using protocol::OutputFailed;
using protocol::OutputStream;
using protocol::Text;

inline constexpr int exit_done = 0;    // done, all held
inline constexpr int exit_failed = 1;  // a check or gate failed, or results could not be written
inline constexpr int exit_bad = 2;     // bad usage or input

// Writes "tribocheck: <text>" as one line. Signs that could steer a terminal are escaped. A failed
// write, such as to a closed stderr, is ignored.
void complain(std::string_view text);

// Writes `text` and below it the lines, each as "  <line>", in the same way. Writes nothing if
// there are no lines.
void complain_of(std::string_view text, const std::vector<std::string>& lines);

// Complains, and returns the exit code.
int fail(int code, std::string_view text);

// Returns what `run` returns. If the input cannot be used, prints what `run` threw and returns
// exit_bad. An OutputFailed passes through: a result that cannot be written is not bad input.
template <class Run>
int answered_or_complained(Run&& run) {
  try {
    return run();
  } catch (const report::ReportError& error) {
    for (const std::string& line : error.lines()) complain(line);
  } catch (const OutputFailed&) {
    throw;
  } catch (const std::invalid_argument& error) {
    complain(error.what());
  } catch (const std::runtime_error& error) {
    complain(error.what());
  }
  return exit_bad;
}

}  // namespace tribo::cli
