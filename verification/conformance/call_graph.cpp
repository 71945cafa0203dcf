// SPDX-License-Identifier: Apache-2.0
#include "conformance/call_graph.hpp"

#include <algorithm>
#include <tuple>

namespace tribo::conformance {
namespace {

using Kind = CallGraph::Kind;

// A line of one of the solver's functions.
struct Place {
  std::size_t function = 0;
  CallGraph::Line line;
  bool operator<(const Place& other) const {
    return std::tie(function, line) < std::tie(other.function, other.line);
  }
};
using Shares = std::map<Place, double>;  // their sum is at most 1; the rest is left out

// Shares the cost of each library function out among the lines of the solver.
class Owners {
 public:
  explicit Owners(const CallGraph& graph)
      : graph_(graph),
        calls_of_(graph.functions.size()),
        shares_(graph.functions.size()),
        states_(graph.functions.size(), State::unknown) {
    for (const CallGraph::Call& call : graph.calls) calls_of_[call.callee].push_back(&call);
  }

  const Shares& of(std::size_t function) {
    if (states_[function] != State::unknown) return shares_[function];
    states_[function] = State::begun;  // a call from a function in this state is a recursion
    Shares shares;
    double whole = 0;
    for (const CallGraph::Call* const call : calls_of_[function]) {
      const Kind kind = graph_.functions[call->caller].kind;
      if (kind == Kind::library && states_[call->caller] == State::begun) continue;
      whole += call->cost;
      if (kind == Kind::own) shares[{call->caller, call->line}] += call->cost;
      if (kind == Kind::library)
        for (const auto& [place, part] : of(call->caller)) shares[place] += part * call->cost;
    }
    if (whole > 0)
      for (auto& [place, part] : shares) part /= whole;
    shares_[function] = std::move(shares);
    states_[function] = State::known;
    return shares_[function];
  }

 private:
  enum class State : std::uint8_t { unknown, begun, known };

  const CallGraph& graph_;
  std::vector<std::vector<const CallGraph::Call*>> calls_of_;
  std::vector<Shares> shares_;
  std::vector<State> states_;
};

}  // namespace

std::vector<HotLine> hot_lines(const CallGraph& graph) {
  Owners owners(graph);
  std::map<Place, double> costs;
  for (std::size_t f = 0; f < graph.functions.size(); ++f) {
    const CallGraph::Function& function = graph.functions[f];
    for (const auto& [line, cost] : function.cost) {
      if (function.kind == Kind::own) costs[{f, line}] += cost;
      if (function.kind == Kind::library)
        for (const auto& [place, part] : owners.of(f)) costs[place] += part * cost;
    }
  }
  std::vector<HotLine> lines;
  for (const auto& [place, cost] : costs) {
    const CallGraph::Function& function = graph.functions[place.function];
    if (cost > 0)
      lines.push_back({place.line.first, place.line.second, function.name, function.object,
                       function.calls, cost});
  }
  std::stable_sort(lines.begin(), lines.end(),
                   [](const HotLine& a, const HotLine& b) { return a.cost > b.cost; });
  return lines;
}

}  // namespace tribo::conformance
