// SPDX-License-Identifier: Apache-2.0
// What reads reference/baselines/work_precision.json: ways of doing a job, timed and judged.
#pragma once

#include <string>
#include <vector>

#include "page/baselines.hpp"
#include "page/data_file.hpp"
#include "page/figure.hpp"

namespace tribo::report {

// One way of doing a job at one setting.
struct Way {
  std::string family;
  std::string name;
  double ns;           // CPU time a point
  double max_ulp;      // true error; NaN where nothing could be judged, as
  double evaluations;  // where nothing was counted
};

// Of each family the fastest way that failed nowhere and was judged, in the order of the file.
std::vector<Way> fastest_ways(const Json& baseline, const std::string& job);

// Ours among them, and the fastest of the others; null: there is none.
struct Contest {
  const Way* ours = nullptr;
  const Way* other = nullptr;
};
Contest contest(const std::vector<Way>& ways);

std::vector<std::string> jobs(const Json& baseline);  // in the order of the file
std::string job_name(const std::string& job);         // in words, as markup

// The tables for gnuplot: a block a series, with its name as title.
std::vector<DataFile> work_precision_data(const Json& baseline);

std::vector<Figure> work_precision_figures(const Json& baseline);

}  // namespace tribo::report
