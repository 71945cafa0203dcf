// SPDX-License-Identifier: Apache-2.0
// The jobs: the cases at which contenders are timed, and the true values by which they are judged.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cases/errors.hpp"
#include "conformance/plugin.hpp"
#include "contenders/curve_contender.hpp"
#include "contenders/ellipse_contender.hpp"
#include "contenders/moment_contender.hpp"
#include "contenders/root_contender.hpp"

namespace tribo::benchmarks {

// A contender at its job, ready to be timed, with its counts and its judgement.
struct Measured {
  std::string job;
  std::string family;
  std::string name;
  std::size_t points;         // solved by one call of run
  std::function<void()> run;  // all of it is timed
  std::function<Errors()> judge;
  std::function<double()> evaluations{};  // number per point; empty: not counted
  std::function<double()> own_seconds{};  // CPU time of the last run, if in another process
};

std::vector<Measured> all_jobs(Settings settings);
// The jobs that a plug-in offers.
std::vector<Measured> plugin_jobs(const conformance::Plugin& plugin);

// The name of each job and its title for readers.
const std::vector<std::pair<std::string, std::string>>& job_titles();

// --- Moments.

// d spread evenly over (0, 6), in a seeded random order.
std::vector<double> moment_arguments(std::size_t count);
// The errors over the certified rows (reference/exact) of the contender's order whose argument d is
// above `from` and below `to`, and lies in the range that the contender claims.
Errors judge(const MomentContender& contender, double from = 0, double to = 6);
// Each contender at the job of its order.
std::vector<Measured> jobs_of(const std::vector<MomentContender>& contenders);

// --- Roots after Greenwood and Tripp, λ₀ log-uniform in 1e-4…100;
//   wide         K log-uniform in 1e-6…10, δ uniform in 0…3
//   one surface  K = 0.3, δ = 1.146

enum class RootJob { wide, one_surface };

constexpr std::string_view name(RootJob job) {
  return job == RootJob::wide ? "root_wide" : "root_one_surface";
}

struct StoredRootCases {
  std::vector<double> stiffness, offset, flooded;
  std::vector<double> high, low, condition;  // of λ; empty where λ is not known
  void add(double k, double delta, double lambda0);
  RootCases view(std::size_t first, std::size_t count) const;
  RootCases view() const { return view(0, flooded.size()); }
};

StoredRootCases random_root_cases(RootJob job, std::size_t count);
// The errors over the rows of reference/exact within the job's ranges.
Errors judge(const RootContender& contender, RootJob job);
// Each contender at this job.
std::vector<Measured> jobs_of(const std::vector<RootContender>& contenders, RootJob job);

// --- Curves of the paper's rough surface: curve_200 and points_1e6.

// reference/published/rough.toml
const Scene& curve_scene();
// Speeds that are log-spaced over the scene's range, ascending.
std::vector<double> curve_speeds(std::size_t count);
// The errors of the films at `count` speeds. The true films are those of the same model in long
// double, at the speeds in the contender's own points. Collapsed films are not judged.
Errors judge(const CurveContender& contender, std::size_t count = 200);
// Each contender at both jobs.
std::vector<Measured> jobs_of(const std::vector<CurveContender>& contenders);

// --- Ellipses, R_y/R_x log-uniform in 1…1e4.

std::vector<EllipseCase> random_ellipses(std::size_t count);
// The errors of the semi-axis a_x and the peak pressure over the certified rows (reference/exact).
Errors judge(const EllipseContender& contender);
// Each contender at its job.
std::vector<Measured> jobs_of(const std::vector<EllipseContender>& contenders);

}  // namespace tribo::benchmarks
