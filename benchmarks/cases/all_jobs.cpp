// SPDX-License-Identifier: Apache-2.0
#include <iterator>

#include "cases/measured.hpp"

namespace tribo::benchmarks {

std::vector<Measured> all_jobs(Settings settings) {
  std::vector<Measured> all = moment_jobs(settings);
  for (std::vector<Measured> jobs : {root_jobs(settings), curve_jobs(settings)})
    std::move(jobs.begin(), jobs.end(), std::back_inserter(all));
  return all;
}

const std::vector<std::pair<std::string, std::string>>& job_titles() {
  static const std::vector<std::pair<std::string, std::string>> titles{
      {"moment_5_2", "F_5/2(d), d in (0, 6)"},
      {"moment_2", "F_2(d), d in (0, 6)"},
      {"root_wide", "Film parameter: K 1e-6..10, delta 0..3, lambda0 1e-4..100"},
      {"root_one_surface", "Film parameter: K = 0.3, delta = 1.146, lambda0 1e-4..100"},
      {"curve_200", "Stribeck curve of 200 points: film, load share, friction"},
      {"points_1e6", "A million operating points of one scene"},
  };
  return titles;
}

}  // namespace tribo::benchmarks
