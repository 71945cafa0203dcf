// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "page/facts.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/onset.hpp"
#include "tribo/operating_points.hpp"

namespace tribo::report {
namespace {

constexpr std::size_t count = 10000;  // speeds of each scene, log-spaced over its range

std::vector<double> speeds_of(const Scene& scene) {
  const auto span = detail::speed_span(scene.speeds);
  Speeds speeds;
  speeds.from = span.low;
  speeds.to = span.high;
  speeds.count = count;
  speeds.spacing = Spacing::log;
  std::vector<double> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = speeds[i];
  return all;
}

WorkCounts work_of(const MixedContact<double>& contact, const std::vector<double>& speeds,
                   OutputSet outputs) {
  OperatingPoints points;
  points.resize(speeds.size(), outputs);
  WorkCounts work;
  solve(contact, speeds, outputs, points, work);
  return work;
}

struct Request {
  std::vector<std::string> names;
  OutputSet outputs;
};

Request request(const std::vector<std::string>& names) {
  OutputSet outputs;
  for (const std::string& name : names) outputs.insert(output_by_name(name).value());
  return {names, outputs};
}

// Evaluations of F_n that all outputs take when every root takes a step or more: a root that is λ₀
// or λ_b without a step counts as one step; a share and two moments a point come on top.
std::uint64_t full_work(const MixedContact<double>& contact, const std::vector<double>& speeds) {
  const WorkCounts work = work_of(contact, speeds, request({"film_flooded"}).outputs);
  return work[Work::root_step] + work[Work::root_is_film] + work[Work::root_is_floor] + 3 * count;
}

double saved_part(const WorkCounts& work, std::uint64_t full) {
  const auto done = work[Work::root_step] + work[Work::share] + work[Work::moment];
  return static_cast<double>(full - std::min(full, done)) / static_cast<double>(full);
}

}  // namespace

Json skipped_work_facts(const std::vector<Case>& cases) {
  const std::vector<Request> requests{{{}, OutputSet::all()},
                                      request({"film"}),
                                      request({"fluid_load_share", "regime"}),
                                      request({"real_area_ratio"})};
  Json rows = Json::array();
  double least = 1, greatest = 0;
  for (const Case& one : cases) {
    const MixedContact<double> contact(one.scene);
    const std::vector<double> speeds = speeds_of(one.scene);
    const std::uint64_t full = full_work(contact, speeds);
    for (const Request& asked : requests) {
      const WorkCounts work = work_of(contact, speeds, asked.outputs);
      const double saved = saved_part(work, full);
      least = std::min(least, saved);
      greatest = std::max(greatest, saved);
      rows.push_back(
          {{"scene", one.stem()},
           {"asked", asked.names},
           {"root_steps", work[Work::root_step]},
           {"roots_that_are_film", work[Work::root_is_film]},
           {"roots_that_are_floor", work[Work::root_is_floor]},
           {"shares_skipped", work[Work::share_not_asked] + work[Work::share_is_nothing]},
           {"starvation_skipped", count - work[Work::starvation]},
           {"saved", saved}});
    }
  }
  return {{"data",
           {{"speeds", count},
            {"rows", std::move(rows)},
            {"least_saved", least},
            {"greatest_saved", greatest}}},
          {"files", Json::object()}};
}

}  // namespace tribo::report
