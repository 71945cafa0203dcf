// SPDX-License-Identifier: Apache-2.0
#include "cases/jobs.hpp"
#include "contenders/plugin_way.hpp"

namespace tribo::benchmarks {

std::vector<Measured> all_jobs(Settings settings) {
  return joined<Measured>(
      {jobs_of(moment_contenders(settings)), jobs_of(wide_root_contenders(settings), RootJob::wide),
       jobs_of(one_surface_root_contenders(settings), RootJob::one_surface),
       jobs_of(curve_contenders(settings)), jobs_of(ellipse_contenders(settings))});
}

std::vector<Measured> plugin_jobs(const conformance::Plugin& plugin) {
  const std::vector<RootContender> roots = plugin_roots(plugin);
  return joined<Measured>({jobs_of(plugin_moments(plugin)), jobs_of(roots, RootJob::wide),
                           jobs_of(roots, RootJob::one_surface), jobs_of(plugin_curves(plugin))});
}

const std::vector<std::pair<std::string, std::string>>& job_titles() {
  static const std::vector<std::pair<std::string, std::string>> titles{
      {"moment_5_2", "F_5/2(d), d in (0, 6)"},
      {"moment_2", "F_2(d), d in (0, 6)"},
      {"root_wide", "Film parameter: K 1e-6..10, delta 0..3, lambda0 1e-4..100"},
      {"root_one_surface", "Film parameter: K = 0.3, delta = 1.146, lambda0 1e-4..100"},
      {"curve_200", "Stribeck curve of 200 points: film, load share, friction"},
      {"points_1e6", "A million operating points of one scene"},
      {"hertz_ellipse", "Hertz ellipse: R_y/R_x 1..1e4"},
  };
  return titles;
}

}  // namespace tribo::benchmarks
