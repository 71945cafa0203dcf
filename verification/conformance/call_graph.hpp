// SPDX-License-Identifier: Apache-2.0
// The result of a profiler: functions, the cost of each of their lines, and the calls between them.
// hot_lines() finds the lines of a solver that cost most.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tribo::conformance {

struct CallGraph {
  enum class Kind : std::uint8_t {
    own,      // code of the solver
    library,  // other code; its cost counts for the line of the solver that calls it
    apart,    // reads questions, writes answers or loads code; is left out, and so is the cost of
              // the libraries for its calls
  };
  using Line = std::pair<std::string, std::uint64_t>;  // file and number; 0: not known
  struct Function {
    std::string name;
    std::string object;  // the file of its code; empty: not known
    Kind kind = Kind::library;
    std::uint64_t calls = 0;
    std::map<Line, double> cost;  // of each line, without what it calls
  };
  struct Call {
    std::size_t caller = 0, callee = 0;  // indices in `functions`
    Line line;                           // of the caller
    double cost = 0;                     // of these calls, with all that the callee calls
  };

  std::vector<Function> functions;
  std::vector<Call> calls;
};

struct HotLine {
  std::string file;
  std::uint64_t line = 0;  // 0: not known
  std::string function;
  std::string object;
  std::uint64_t calls = 0;  // of the function
  double cost = 0;          // with the libraries that the line calls
};

// The lines of the solver's own functions, the greatest cost first. The cost of a library is shared
// out among the lines that call it, directly or through other libraries, in proportion to the cost
// of their calls.
std::vector<HotLine> hot_lines(const CallGraph& graph);

}  // namespace tribo::conformance
