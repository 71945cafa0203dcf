// SPDX-License-Identifier: Apache-2.0
// The format (`man perf-script`): a line with the period of the sample in nanoseconds, then a line
// for each frame of its stack, the innermost one first, then an empty line. The line of a frame is
// "ADDRESS NAME (OBJECT)" after a tab.
#include "conformance/perf_script.hpp"

#include <charconv>
#include <map>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace tribo::conformance {
namespace {

constexpr double nanosecond = 1e-9;

struct Frame {
  std::uint64_t address = 0;
  std::string_view function, object;
};

std::string_view without_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return first == text.npos ? std::string_view() : text.substr(first);
}

// A name can have blanks and brackets. An object is taken to have no blank before a bracket.
Frame frame_of(std::string_view text) {
  Frame frame;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), frame.address, 16);
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  const std::size_t open = text.rfind(" (");
  if (error != std::errc() || open == text.npos || !text.ends_with(')')) return {};
  frame.function = without_blanks(text.substr(0, open));
  frame.object = text.substr(open + 2, text.size() - open - 3);
  return frame;
}

// The time of each of the solver's addresses.
class Samples {
 public:
  explicit Samples(const std::function<CallGraph::Kind(const std::string&)>& kind_of)
      : kind_of_(kind_of) {}

  void take(std::string_view line) {
    const std::string_view words = without_blanks(line);
    if (words.empty()) return;
    if (line.front() == '\t') {
      if (period_) take_frame(frame_of(words));
      return;
    }
    std::uint64_t period = 0;
    std::from_chars(words.data(), words.data() + words.size(), period);
    period_ = static_cast<double>(period) * nanosecond;
    has_samples_ |= period > 0;
  }

  bool has_samples() const { return has_samples_; }
  // For each object, for each address in it: the name of the function, and the time in seconds.
  const std::map<std::string, std::map<std::uint64_t, std::pair<std::string, double>>>& times()
      const {
    return times_;
  }

 private:
  void take_frame(const Frame& frame) {
    const std::string object(frame.object);
    const CallGraph::Kind kind = kind_of_(object);
    if (kind == CallGraph::Kind::library) return;
    if (kind == CallGraph::Kind::own) {
      auto& [function, time] = times_[object][frame.address];
      function = frame.function;
      time += *period_;
    }
    period_.reset();  // the sample is counted
  }

  const std::function<CallGraph::Kind(const std::string&)>& kind_of_;
  std::map<std::string, std::map<std::uint64_t, std::pair<std::string, double>>> times_;
  std::optional<double> period_;  // empty: the sample belongs to a line already
  bool has_samples_ = false;
};

}  // namespace

CallGraph read_perf_script(
    std::istream& text, const std::function<CallGraph::Kind(const std::string&)>& kind_of,
    const std::function<std::vector<CallGraph::Line>(
        const std::string& object, const std::vector<std::uint64_t>& addresses)>& lines_of) {
  Samples samples(kind_of);
  for (std::string line; std::getline(text, line);) samples.take(line);
  if (!samples.has_samples()) throw std::runtime_error("it has no samples of perf");
  CallGraph graph;
  for (const auto& [object, times] : samples.times()) {
    std::vector<std::uint64_t> addresses;
    for (const auto& [address, time] : times) addresses.push_back(address);
    const std::vector<CallGraph::Line> lines = lines_of(object, addresses);
    std::map<std::string, CallGraph::Function> functions;
    std::size_t place = 0;
    for (const auto& [address, time] : times) {
      CallGraph::Function& function = functions[time.first];
      function.cost[lines.at(place++)] += time.second;
    }
    for (auto& [name, function] : functions)
      graph.functions.push_back({name, object, CallGraph::Kind::own, 0, std::move(function.cost)});
  }
  return graph;
}

}  // namespace tribo::conformance
