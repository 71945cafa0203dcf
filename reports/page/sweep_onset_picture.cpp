// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "page/number_text.hpp"
#include "page/sweep_picture_parts.hpp"
#include "page/sweep_values.hpp"

namespace tribo::report {
namespace {

using namespace sweep_picture;
using sweep::ColumnResult;

// In units of a lane: a scene's name, and the room below its lanes.
constexpr double name_room = 0.55, gap = 0.15, peak = 0.82;
constexpr double points_a_lane = 50, points_around = 78 + 92;

struct Lane {
  const ColumnResult* column;
  double base;
};
struct Group {
  const sweep::SceneResult* scene;
  std::uint32_t colour;
  std::vector<Lane> lanes;
  double top, bottom;
};

bool is_onset_speed(const ColumnResult& column) {
  return column.name.starts_with("onset.") && column.name.ends_with(".speed") &&
         column.values.size() == 1;
}

std::vector<Group> lay_out(const sweep::SweepResult& result, double& height) {
  const std::vector<std::uint32_t> colour = colours(result);
  std::vector<Group> groups;
  height = 0;
  for (std::size_t i = result.scenes.size(); i-- > 0;) {
    const sweep::SceneResult& scene = result.scenes[i];
    Group group{&scene, colour[i], {}, 0, height};
    for (std::size_t c = scene.columns.size(); c-- > 0;) {
      if (!is_onset_speed(scene.columns[c])) continue;
      group.lanes.push_back({&scene.columns[c], height});
      height += 1;
    }
    if (group.lanes.empty()) continue;
    group.top = height;
    height += name_room + gap;
    groups.push_back(std::move(group));
  }
  height -= gap;
  return groups;
}

// Half as many bins as the result has: quiet enough to see a shape.
std::vector<sweep::QuantileSketch::Bin> bins_of(const ColumnResult::Value& value) {
  std::vector<sweep::QuantileSketch::Bin> bins;
  for (std::size_t i = 0; i < value.histogram.size(); ++i) {
    const auto& bin = value.histogram[i];
    if (i % 2 == 0 || bins.empty()) {
      bins.push_back(bin);
    } else {
      bins.back().high = bin.high;
      bins.back().count += bin.count;
    }
  }
  return bins;
}

double density(const sweep::QuantileSketch::Bin& bin) {
  return bin.low > 0 ? static_cast<double>(bin.count) / std::log(bin.high / bin.low) : 0;
}

// A number of cases over the logarithm of the speed, the highest bar `peak` high.
std::string outline(const Lane& lane, std::uint32_t colour) {
  const auto bins = bins_of(lane.column->values.front());
  double greatest = 0;
  for (const auto& bin : bins) greatest = std::max(greatest, density(bin));
  std::string text;
  for (const auto& bin : bins) {
    if (!(bin.low > 0) || greatest == 0) continue;
    const double top = lane.base + peak * density(bin) / greatest;
    for (const double speed : {bin.low, bin.high})
      text += fmt::format("{}\t{}\t{}\t{}\n", speed, lane.base, top, colour);
  }
  return text.empty() ? fmt::format("NaN\t{0}\t{0}\t{1}\n", lane.base, colour) : text;
}

// What stands beside a lane: "0.0934 (0.0810 to 0.108)".
std::string numbers(const ColumnResult::Value& value) {
  if (value.count == 0) return "none in any case";
  return fmt::format("{} ({} to {})", rounded(quantile(value, 0.5).value, 3),
                     rounded(quantile(value, 0.025).value, 3),
                     rounded(quantile(value, 0.975).value, 3));
}

std::string missing(const ColumnResult::Value& value) {
  if (value.count == 0 || value.undefined == 0) return "-";  // gnuplot knows no empty cell
  const auto all = static_cast<double>(value.count + value.undefined);
  return fmt::format("none in {} % of the cases",
                     rounded(100 * static_cast<double>(value.undefined) / all, 2));
}

// The height of the outline at a speed, as a part of the greatest height of the outline.
double height_at(const ColumnResult::Value& value, double speed) {
  double greatest = 0, here = 0;
  for (const auto& bin : bins_of(value)) {
    greatest = std::max(greatest, density(bin));
    if (speed >= bin.low && speed < bin.high) here = density(bin);
  }
  return greatest > 0 ? here / greatest : 0;
}

}  // namespace

std::optional<SweepPicture> onset_distribution(const sweep::SweepResult& result,
                                               const std::vector<ReportedOnset>& reported) {
  double height = 0;
  const std::vector<Group> groups = lay_out(result, height);
  Range range{std::numeric_limits<double>::infinity(), 0};
  std::string lanes, scenes, outlines;
  std::uint64_t cases = 0;
  const auto take = [&range](double low, double high) {
    if (low > 0) range.low = std::min(range.low, low);
    range.high = std::max(range.high, high);
  };
  for (const Group& group : groups) {
    cases += group.scene->cases;
    for (const Lane& lane : group.lanes) {
      const ColumnResult::Value& value = lane.column->values.front();
      for (const auto& bin : value.histogram) take(bin.low, bin.high);
      const std::string criterion(split_name(split_name(lane.column->name).first).second);
      const double median = quantile(value, 0.5).value;
      lanes += fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\n", lane.base,
                           cell(group.scene->id), in_words(criterion), group.colour, exact(median),
                           exact(quantile(value, 0.025).value), exact(quantile(value, 0.975).value),
                           height_at(value, median), numbers(value), missing(value));
      outlines += "\n\n" + outline(lane, group.colour);
    }
    const auto mark = std::find_if(reported.begin(), reported.end(),
                                   [&](const auto& one) { return one.scene == group.scene->id; });
    const bool has_mark = mark != reported.end();
    if (has_mark) take(mark->low, mark->high);
    const double none = std::numeric_limits<double>::quiet_NaN();
    scenes += fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\n", cell(group.scene->id, 16),
                          group.top + 0.2, group.bottom, group.top,
                          exact(has_mark ? mark->value : none), exact(has_mark ? mark->low : none),
                          exact(has_mark ? mark->high : none), group.colour);
  }
  if (groups.empty() || !(range.high > 0)) return std::nullopt;
  range = with_room(range, 0.02);
  const std::string blocks = fmt::format(
      "# low\thigh\ttop\treported\n{}\t{}\t{}\t{}\n\n\n"
      "# base\tscene\tcriterion\tcolour\tmedian\tquantile_0.025\tquantile_0.975\theight_at_median\t"
      "text\tmissing\n{}\n\n# "
      "scene\tname_at\tbottom\ttop\treported\treported_low\treported_high\tcolour\n{}"
      "{}",
      range.low, range.high, height, reported.empty() ? 0 : 1, lanes, scenes, outlines);
  return make("onset_distribution", "sweep_onset_distribution.gp", "How the onset speeds scatter",
              "Each lane is the distribution of the onset speed by one criterion, all to the same "
              "height; the bar under it spans 95 % of the cases, the line stands at the median.",
              "Histograms of the onset speed on a logarithmic axis, a lane for each scene and "
              "criterion, with medians and intervals of 95 %.",
              fmt::format("{} cases, over the logarithm of the speed; each lane to the same height",
                          grouped(cases)),
              static_cast<int>(std::lround(points_around + points_a_lane * (height + 0.12))),
              blocks);
}

}  // namespace tribo::report
