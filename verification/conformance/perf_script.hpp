// SPDX-License-Identifier: Apache-2.0
// The text that `perf script` makes of a recording, with the time of each line.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <istream>
#include <string>
#include <vector>

#include "conformance/call_graph.hpp"

namespace tribo::conformance {

// The options of `perf script` that give this text.
inline constexpr auto perf_script_options =
    std::to_array<const char*>({"-F", "period,ip,sym,dso", "--no-inline"});

// A sample of a clock is the time of the first of the solver's own lines on its stack, counted from
// the innermost one: what a library does belongs to the line that has called it. The result has
// these lines, in seconds, and no calls. `kind_of` tells whose an object (a program or a shared
// library, by its path) is, and `lines_of` the lines of addresses in it, which perf itself looks up
// one by one, in seconds. Throws std::runtime_error with one line where the text has no samples.
CallGraph read_perf_script(
    std::istream& text, const std::function<CallGraph::Kind(const std::string&)>& kind_of,
    const std::function<std::vector<CallGraph::Line>(
        const std::string& object, const std::vector<std::uint64_t>& addresses)>& lines_of);

}  // namespace tribo::conformance
