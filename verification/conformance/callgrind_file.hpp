// SPDX-License-Identifier: Apache-2.0
// The file that valgrind's callgrind leaves, with the instructions of each line.
#pragma once

#include <functional>
#include <istream>
#include <string>

#include "conformance/call_graph.hpp"

namespace tribo::conformance {

// `kind_of` tells, by its path, whether an object (a program or a shared library) is the solver's
// own. Throws std::runtime_error with one line where the text is no such file.
CallGraph read_callgrind(std::istream& text,
                         const std::function<CallGraph::Kind(const std::string&)>& kind_of);

}  // namespace tribo::conformance
