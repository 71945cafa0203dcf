// SPDX-License-Identifier: Apache-2.0
// A contender at its job, ready to be timed, with what is known of it besides its time.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "cases/errors.hpp"
#include "conformance/plugin.hpp"
#include "contenders/settings.hpp"

namespace tribo::benchmarks {

struct Measured {
  std::string job;
  std::string family;
  std::string name;
  std::size_t points;         // solved by one call of run
  std::function<void()> run;  // all of it is timed
  std::function<Errors()> judge;
  std::function<double()> evaluations;  // a point; empty: none
  std::function<double()> own_seconds;  // CPU time of the last run, if in another process
};

std::vector<Measured> moment_jobs(Settings settings);
std::vector<Measured> root_jobs(Settings settings);
std::vector<Measured> curve_jobs(Settings settings);
std::vector<Measured> ellipse_jobs(Settings settings);
std::vector<Measured> all_jobs(Settings settings);
// The plug-in at each job that it offers.
std::vector<Measured> plugin_jobs(const conformance::Plugin& plugin);

// The name of each job and its title for readers.
const std::vector<std::pair<std::string, std::string>>& job_titles();

}  // namespace tribo::benchmarks
