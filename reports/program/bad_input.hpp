// SPDX-License-Identifier: Apache-2.0
// Bad input is one line for each thing that is wrong, and an exit code of its own.
#pragma once

#include <stdexcept>
#include <string>

#include "exit_code.hpp"
#include "messages.hpp"
#include "output.hpp"
#include "page/report_error.hpp"

namespace tribo::cli {

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
