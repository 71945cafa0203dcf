// SPDX-License-Identifier: Apache-2.0
// The work that a computation did, and the work that it skipped, for tests, gates and the report.
// Counting is a policy: with NoWork, the default, nothing is counted, and this costs nothing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace tribo {

enum class Work : std::uint8_t {
  root_step,
  share,
  moment,
  starvation,
  shear_stress,
  root_is_film,
  root_is_floor,
  root_by_newton,
  share_is_nothing,
  share_not_asked,
  supply_is_flooded,
};

struct WorkInfo {
  Work work;
  std::string_view name;
  std::string_view meaning;
};

inline constexpr auto work_infos = std::to_array<WorkInfo>({
    {Work::root_step, "root_steps",
     "steps to a root of load sharing; each evaluates F_p and its slope once"},
    {Work::share, "shares", "load shares at a film, from F_p"},
    {Work::moment, "moments", "F_n for the real area or the summits"},
    {Work::starvation, "starvation_ratios", "y(r) of a starved inlet"},
    {Work::shear_stress, "shear_stresses", "of the film, for friction"},
    {Work::root_is_film, "roots_skipped_at_film", "skipped: λ = λ₀ to half an ulp"},
    {Work::root_is_floor, "roots_skipped_at_floor", "skipped: λ = λ_b to half an ulp"},
    {Work::root_by_newton, "roots_by_newton", "roots that are left to Newton's method"},
    {Work::share_is_nothing, "shares_skipped_as_nothing",
     "skipped: A < 2^−54 and only 1 − A or the regime was asked"},
    {Work::share_not_asked, "shares_skipped_not_asked",
     "skipped: no asked output rests on the load shares"},
    {Work::supply_is_flooded, "starvation_skipped_flooded", "skipped: y = 1"},
});

struct NoWork {
  static constexpr bool counts = false;
  constexpr void add(Work, std::size_t = 1) const {}
};

class WorkCounts {
 public:
  static constexpr bool counts = true;
  constexpr void add(Work work, std::size_t count = 1) {
    counts_[static_cast<std::size_t>(work)] += count;
  }
  constexpr std::uint64_t operator[](Work work) const {
    return counts_[static_cast<std::size_t>(work)];
  }
  friend constexpr bool operator==(const WorkCounts&, const WorkCounts&) = default;

 private:
  std::array<std::uint64_t, work_infos.size()> counts_{};
};

}  // namespace tribo
