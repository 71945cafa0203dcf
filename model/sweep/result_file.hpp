// SPDX-License-Identifier: Apache-2.0
// The result of a sweep: an HDF5 file. Its bytes are a function of the plan, the chunks and the
// program's commit alone.
//
//   /                        attributes: format, title, tribocheck_version, tribocheck_commit (of
//                            the build; empty: not known), sweep_digest, arithmetic
//   /<scene id>              attributes: scene (the sweep file's text), file, design, seed, draws,
//                            cases, points, departure, columns (their names)
//     speed                  [speeds] the scene's speeds, where outputs or solved films are asked;
//                            the dimension scale of columns with a value for each speed
//     inputs/<field>         [cases] attributes: unit, meaning, varies, words
//     outputs/<column>       [cases] or [cases, speeds] attributes: unit, meaning (and why it may
//                            be NaN), words
//     summary/<column>/      attributes: unit, meaning, words
//                            count, undefined, mean, sd, least, greatest: [width];
//                            quantile_levels: [levels]; quantiles, quantiles_low, quantiles_high:
//                            [width, levels], attribute relative_error;
//                            histogram_edges: [width, bins + 1], histogram_counts: [width, bins]
//                            (NaN and 0 where there are fewer bins)
//     sensitivity/           attribute variables;
//       <column>/            first_order, first_order_low, first_order_high, total, total_low,
//                            total_high: [width, variables]; groups, left_out: [width]; NaN where
//                            too few groups are left (sensitivity.hpp)
//
// The column "onset.film_maximum.speed" is at outputs/onset/film_maximum/speed. Counts, groups and
// left_out are integers of 64 bits, other numbers doubles, NaN where undefined. A word is one byte:
// its place, from 0, in the attribute `words` (Octave cannot read HDF5's enumerations). Where
// points are not kept, there are no outputs, and inputs are of length 0. Every dataset has HDF5's
// checksums (fletcher32). The file ends in its checksum (result_seal.hpp); HDF5 ignores it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sweep/output_file.hpp"
#include "sweep/part.hpp"
#include "sweep/plan.hpp"
#include "sweep/sensitivity.hpp"
#include "sweep/summary.hpp"

namespace tribo::sweep {

inline constexpr std::string_view result_format = "tribocheck sweep 2";

// "onset.film_maximum.speed" lies at onset/film_maximum/speed.
inline std::string path_of_column(std::string name) {
  std::replace(name.begin(), name.end(), '.', '/');
  return name;
}

// The levels of quantiles in results.
inline constexpr std::array quantile_levels{0.001, 0.01, 0.025, 0.05,  0.16, 0.25, 0.5,
                                            0.75,  0.84, 0.95,  0.975, 0.99, 0.999};
inline constexpr std::size_t histogram_bins = 100;

// The mark of results (output_file.hpp).
bool is_start_of_result(std::span<const std::byte> start);

// Writes the result to the disk at PATH.part (`is_shared`: at a name that no other process uses),
// and renames it to `path`, where it may replace what `replaceable` says. All chunks have to be
// there. It takes them in order, one at a time, and calls told(chunks written) after each. Returns
// the open file. Throws std::runtime_error (disk full, not writable …) with a text that names the
// file, and removes the unfinished file. A Stopped that told() throws passes through.
Descriptor write_result(const std::string& path, const SweepPlan& plan, const PartSet& chunks,
                        const std::function<void(std::uint64_t)>& told,
                        const Replaceable& replaceable = {.any = true, .only = {}},
                        bool is_shared = false);

struct ResultIdentity {
  std::string version;
  std::string digest;
  std::string arithmetic;
};
// The summaries of a result, for tables and pictures.
struct ColumnResult {
  struct Value {  // one of a column's `width` values of a case
    std::uint64_t count = 0, undefined = 0;
    double mean = 0, sd = 0, least = 0, greatest = 0;
    std::vector<Bounded> quantiles;              // at quantile_levels
    std::vector<QuantileSketch::Bin> histogram;  // ascending
    SobolIndices sensitivity;                    // empty without
  };
  std::string name;
  std::string unit;
  std::vector<std::string> words;
  std::vector<Value> values;
};
struct InputResult {
  std::string path, unit, meaning, varies;
  std::vector<std::string> words;
};
struct SceneResult {
  std::string id, file, text, design;
  std::uint64_t seed = 0, draws = 0, cases = 0, points = 0;
  std::vector<double> speeds;
  std::vector<InputResult> inputs;
  std::vector<std::string> sensitivity_variables;  // paths; empty without
  std::vector<ColumnResult> columns;
  bool has_points = false;  // are inputs and outputs of each case there?

  const ColumnResult* column(std::string_view name) const;  // null: none of that name
};
struct SweepResult {
  ResultIdentity identity;
  std::vector<SceneResult> scenes;
};

// Cases in a row.
struct CaseRange {
  std::uint64_t first = 0, count = 0;
};

// A result, open for reading. A file that another process has written is read in a child process
// with limits of time and memory (apart.hpp), because a forged file may crash or hang HDF5. All
// functions throw std::runtime_error, with a text that names the file, where it is not a whole
// result of `tribocheck sweep`.
class ResultFile {
 public:
  // Throws Stopped once stopped() gives true, while the checksum is read.
  explicit ResultFile(const std::string& path, const std::function<bool()>& stopped = {});
  // The result that this process itself has written at `path`; `own` is its open file.
  ResultFile(const std::string& path, Descriptor own);

  const std::string& path() const { return path_; }
  ResultIdentity identity() const;
  SweepResult read() const;
  // The kept values of one input or column of a scene, [cases, width]. Words are given as their
  // places. With a range, the values are of these cases alone.
  using Range = std::optional<CaseRange>;
  std::vector<double> input(const std::string& scene_id, const std::string& name,
                            const Range& range = {}) const;
  std::vector<double> column(const std::string& scene_id, const std::string& name,
                             const Range& range = {}) const;

 private:
  template <class Result, class Read>
  Result read_with(Read&& read) const;
  std::vector<double> cases(const std::string& scene_id, const std::string& folder,
                            const std::string& name, const Range& range) const;

  std::string path_;
  Descriptor file_;
  bool is_own_;
};

}  // namespace tribo::sweep
