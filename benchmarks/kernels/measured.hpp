// SPDX-License-Identifier: Apache-2.0
// A contender as a benchmark "job/family/name", with what is known of it besides its time.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "cases/errors.hpp"

namespace tribo::benchmarks {

struct Measured {
  std::string job;
  std::string family;
  std::string name;
  std::size_t points;                   // solved by one call of run
  std::function<void()> run;            // all of it is timed
  std::function<Errors()> judge;        // empty: nothing to judge
  std::function<double()> evaluations;  // a point; empty: none
  std::function<double()> own_seconds;  // of the last run, if it was in another process
};

void register_benchmark(Measured measured);
// What a job is, for people; in the context of the JSON output.
void describe_job(const std::string& job, const std::string& title);
// "job/family/name" of all that were registered.
const std::vector<std::string>& registered_names();

void register_moments();
void register_roots();
void register_curves();

}  // namespace tribo::benchmarks
