// SPDX-License-Identifier: Apache-2.0
// Running gnuplot.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tribo::report {

enum class GnuplotEnd : std::uint8_t { drawn, failed, not_found };

struct GnuplotRun {
  GnuplotEnd end;
  std::string message;  // why not; what gnuplot said
};

// Runs `gnuplot script argument…` without the user's own settings (-d) and waits for its end.
GnuplotRun run_gnuplot(const std::filesystem::path& script,
                       const std::vector<std::string>& arguments);

}  // namespace tribo::report
