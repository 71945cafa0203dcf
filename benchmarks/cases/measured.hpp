// SPDX-License-Identifier: Apache-2.0
// A contender at its job, ready to be timed, with what is known of it besides its time.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "cases/errors.hpp"
#include "conformance/plugin_library.hpp"
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
  std::function<double()> own_seconds;  // of the last run, if it was in another process
};

std::vector<Measured> moment_jobs(Settings settings);
std::vector<Measured> root_jobs(Settings settings);
std::vector<Measured> curve_jobs(Settings settings);
std::vector<Measured> ellipse_jobs(Settings settings);
std::vector<Measured> all_jobs(Settings settings);
// What a plug-in offers, at every job.
std::vector<Measured> plugin_jobs(const conformance::Plugin& plugin);

// What each job is, for people.
const std::vector<std::pair<std::string, std::string>>& job_titles();

}  // namespace tribo::benchmarks
