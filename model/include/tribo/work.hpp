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
  root_step,          // of load sharing; each evaluates F_p and its slope once
  share,              // load shares at a film, from F_p
  moment,             // F_n for the real area or the summits
  starvation,         // y(r)
  shear_stress,       // of the film, for friction
  root_is_film,       // skipped: λ = λ₀ to half an ulp
  root_is_floor,      // skipped: λ = λ_b to half an ulp
  root_by_newton,     // left to Newton's method
  share_is_nothing,   // skipped: A < 2^−54 and only 1 − A or the regime was asked
  share_not_asked,    // skipped: no asked output rests on the load shares
  supply_is_flooded,  // skipped: y = 1
};

struct WorkInfo {
  Work work;
  std::string_view name;
};

inline constexpr auto work_infos = std::to_array<WorkInfo>({
    {Work::root_step, "root_steps"},
    {Work::share, "shares"},
    {Work::moment, "moments"},
    {Work::starvation, "starvation_ratios"},
    {Work::shear_stress, "shear_stresses"},
    {Work::root_is_film, "roots_skipped_at_film"},
    {Work::root_is_floor, "roots_skipped_at_floor"},
    {Work::root_by_newton, "roots_by_newton"},
    {Work::share_is_nothing, "shares_skipped_as_nothing"},
    {Work::share_not_asked, "shares_skipped_not_asked"},
    {Work::supply_is_flooded, "starvation_skipped_flooded"},
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
