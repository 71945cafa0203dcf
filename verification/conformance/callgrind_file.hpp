// SPDX-License-Identifier: Apache-2.0
// Reads the file that valgrind's callgrind writes: the instructions of each source line.
#pragma once

#include <functional>
#include <istream>
#include <string>

#include "conformance/call_graph.hpp"

namespace tribo::conformance {

// `kind_of` gives the kind of an object (a program or a shared library) by its path. Throws
// std::runtime_error with one line if the text is no such file.
CallGraph read_callgrind(std::istream& text,
                         const std::function<CallGraph::Kind(const std::string&)>& kind_of);

}  // namespace tribo::conformance
