// SPDX-License-Identifier: Apache-2.0
// Measured points of a contact, read from a file of comma-separated values, and how far a model is
// from them.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "messages.hpp"
#include "protocol/answers.hpp"
#include "tribo/scene.hpp"

namespace tribo::cli {

// One number of the file, in SI units.
struct MeasuredNumber {
  std::size_t line = 0;  // of the file, from 1
  double speed = 0;      // m/s
  Output output{};
  double value = 0;
  std::string unit = {};              // of the file; empty: none
  double unit_in_si = 1;              // one of that unit, in SI units
  bool has_other_conditions = false;  // the row has another load, slide-roll ratio or temperature
};

struct MeasuredPoints {
  std::vector<MeasuredNumber> numbers;
  std::vector<std::string> ignored;  // headings of the columns that are not read
  // A line for each column, such as the load, in which some rows do not have the scene's number.
  std::vector<std::string> contradictions;
};

// Reads a file with one point on each line. The first line has the names and units of the columns:
// `speed [m/s],film [nm],friction`. A name is that of a numeric output, or one that test rigs use
// for it. An empty cell means that nothing was measured. Blank lines, and lines that begin with #,
// are skipped. Throws report::ReportError with one line for each mistake; an output that the scene
// does not ask for is a mistake.
MeasuredPoints read_measured(const std::string& path, const Scene& scene);

struct Comparison {
  MeasuredNumber measured;
  protocol::OutputValue computed;
  double deviation_percent = 0;  // (computed − measured)/measured; NaN where there is none
  bool is_outside = false;       // the speed lies outside the scene's curve

  // Does the point have the scene's conditions, a speed of its curve, and a film in the model?
  bool is_on_curve() const {
    return !measured.has_other_conditions && !is_outside && computed.undefined.empty() &&
           !(deviation_percent <= -100);
  }
};

// The deviations of one output: the median, the least and the greatest of those that exist, and the
// median of those that are on the curve. NaN: nothing is compared.
struct DeviationSummary {
  Output output{};
  std::size_t points = 0, compared = 0, on_curve = 0;
  double median_percent = 0, least_percent = 0, greatest_percent = 0, on_curve_percent = 0;
};

// In the order of the outputs.
std::vector<DeviationSummary> summaries_of(const std::vector<Comparison>& comparisons);

// format: "table", "csv" or "json", which has the `warnings` of the scene too.
void write_comparisons(std::string_view format, std::string_view scene_id, const std::string& path,
                       const std::vector<Comparison>& comparisons,
                       const nlohmann::ordered_json& warnings, OutputStream& output);

}  // namespace tribo::cli
