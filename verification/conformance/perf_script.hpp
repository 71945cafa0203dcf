// SPDX-License-Identifier: Apache-2.0
// Reads the text of `perf script`: the time of each line of a solver's code.
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

// The time of a sample belongs to the innermost of the solver's own lines on its stack: what a
// library does belongs to the line that has called it. The result has the time of these lines, in
// seconds, and no calls. `kind_of` tells, by its path, whether an object (a program or a shared
// library) is the solver's own. `lines_of` gives the lines of addresses in an object; perf itself
// would look them up one by one, which takes seconds. Throws std::runtime_error with one line where
// the text has no samples.
CallGraph read_perf_script(
    std::istream& text, const std::function<CallGraph::Kind(const std::string&)>& kind_of,
    const std::function<std::vector<CallGraph::Line>(
        const std::string& object, const std::vector<std::uint64_t>& addresses)>& lines_of);

}  // namespace tribo::conformance
