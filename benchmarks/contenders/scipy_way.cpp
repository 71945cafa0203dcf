// SPDX-License-Identifier: Apache-2.0
// SciPy's quad and fsolve, asked in a Python process.
#include <chrono>
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/child_process.hpp"
#include "contenders/moment_contender.hpp"
#include "contenders/root_contender.hpp"
#include "protocol/bounded_json.hpp"

namespace tribo::benchmarks {
namespace {

// ask() starts the process at its first call. It throws std::runtime_error if no answer comes, for
// example without SciPy.
class Scipy {
 public:
  nlohmann::json ask(std::string_view function,
                     std::initializer_list<std::span<const double>> arguments) {
    if (!process_) {
      process_.emplace(std::vector<std::string>{"/usr/bin/python3", "-B", TRIBOCHECK_SCIPY_WAY},
                       conformance::ChildProcess::Pipes::all);
      answer();  // the process says that it is ready
    }
    nlohmann::json lists = nlohmann::json::array();
    for (const std::span<const double> list : arguments)
      lists.push_back(std::vector<double>(list.begin(), list.end()));
    process_->send(nlohmann::json{{"function", function}, {"arguments", lists}}.dump());
    return protocol::parse_bounded_json(answer());
  }

 private:
  std::string answer() {
    std::string line;
    if (process_->next_line(line, std::chrono::hours(1)) != conformance::ChildProcess::Event::line)
      throw std::runtime_error("the process has gone");
    return line;
  }

  std::optional<conformance::ChildProcess> process_;
};

Scipy& scipy() {
  static Scipy process;
  return process;
}

double seconds_of_last = 0;

void take(const nlohmann::json& answer, std::span<double> values) {
  seconds_of_last = answer.at("seconds");
  for (std::size_t i = 0; i < values.size(); ++i) {
    const nlohmann::json& value = answer.at("values")[i];
    values[i] = value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
  }
}

nlohmann::json ask_roots(const RootCases& cases) {
  return scipy().ask("film_parameter", {cases.stiffness, cases.offset, cases.flooded});
}

}  // namespace

std::vector<MomentContender> scipy_moments() {
  MomentContender quad{"SciPy", "quad", Order::five_halves, {}, {}};
  quad.run = [](std::span<const double> d, std::span<double> moments) {
    take(scipy().ask("moment", {d}), moments);
  };
  quad.own_seconds = [] { return seconds_of_last; };
  return {quad};
}

std::vector<RootContender> scipy_roots() {
  RootContender fsolve{"SciPy", "fsolve + quad", {}, {}};
  fsolve.prepare = [](const RootCases&) -> RootRun {
    return [](const RootCases& cases, std::span<double> film) { take(ask_roots(cases), film); };
  };
  fsolve.evaluations = [](const RootCases& cases) {
    return ask_roots(cases).at("evaluations").get<double>();
  };
  fsolve.own_seconds = [] { return seconds_of_last; };
  fsolve.is_slow = true;
  return {fsolve};
}

}  // namespace tribo::benchmarks
