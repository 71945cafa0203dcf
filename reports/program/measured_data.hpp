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
  double unit_in_si = 1;              // that unit in the SI unit
  bool has_other_conditions = false;  // the row has another load, slide-roll ratio or temperature
};

struct MeasuredPoints {
  std::vector<MeasuredNumber> numbers;
  std::vector<std::string> ignored;  // headings of the columns that are not read
  // A line for each column that a scene has a number for, such as the load, and in which some rows
  // have another number.
  std::vector<std::string> contradictions;
};

// Reads a file of which each line is a point. The first line has the names of the columns with
// their units: `speed [m/s],film [nm],friction`; names are those of outputs that are numbers, and
// those that test rigs use for them. An empty cell was not measured. Blank lines, and lines that
// begin with #, are skipped. Throws report::ReportError with one line for each mistake; an output
// that the scene does not ask for is a mistake.
MeasuredPoints read_measured(const std::string& path, const Scene& scene);

struct Comparison {
  MeasuredNumber measured;
  protocol::OutputValue computed;
  double deviation_percent = 0;  // (computed − measured)/measured; NaN where there is none
  bool is_outside = false;       // of the speeds of the scene's curve

  // Was the contact of the scene measured, at a speed of its curve at which the model has a film?
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
