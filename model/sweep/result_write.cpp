// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "build_commit.hpp"
#include "sweep/chunk.hpp"
#include "sweep/hdf5_handles.hpp"
#include "sweep/output_file.hpp"
#include "sweep/result_file.hpp"
#include "sweep/result_seal.hpp"

namespace tribo::sweep {
namespace {

using hdf5::checked;
using hdf5::Handle;
using hdf5::write_array;
using hdf5::write_attribute;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// The checksum of HDF5's filter of this name, from big-endian words of 16 bits.
std::uint32_t fletcher32(std::span<const std::byte> bytes) {
  constexpr std::size_t words_between = 360;  // the most for which no sum overflows
  const auto folded = [](std::uint32_t sum) { return (sum & 0xFFFF) + (sum >> 16); };
  std::uint32_t first = 0, second = 0;
  for (std::size_t i = 0; i < bytes.size();) {
    const std::size_t end = std::min(bytes.size(), i + 2 * words_between);
    for (; i < end; i += 2) {
      first += std::to_integer<std::uint32_t>(bytes[i]) << 8;
      if (i + 1 < bytes.size()) first += std::to_integer<std::uint32_t>(bytes[i + 1]);
      second += first;
    }
    first = folded(first);
    second = folded(second);
  }
  return folded(second) << 16 | folded(first);
}

// Opens the group at a path below `parent`, and makes the groups on the way that are missing.
Handle make_groups(hid_t parent, const std::string& path) {
  Handle group(H5Gopen2(parent, ".", H5P_DEFAULT));
  for (std::size_t start = 0; start < path.size();) {
    const std::size_t end = std::min(path.find('/', start), path.size());
    const std::string name = path.substr(start, end - start);
    const bool is_there = checked(H5Lexists(group, name.c_str(), H5P_DEFAULT)) > 0;
    group = is_there ? Handle(H5Gopen2(group, name.c_str(), H5P_DEFAULT))
                     : hdf5::make_group(group, name);
    start = end + 1;
  }
  return group;
}

// A dataset of all cases, to which packed chunks are written.
class CaseDataset {
 public:
  // The extents are [cases] where the width is 1, else [cases, width]. 0 cases: none are kept.
  CaseDataset(hid_t group, const std::string& name, const std::vector<std::string>& words,
              std::uint64_t cases, std::uint64_t chunk_cases, std::size_t width)
      : element_size_(words.empty() ? 8 : 1), chunk_cases_(chunk_cases), rank_(width > 1 ? 2 : 1) {
    // The greatest extents. HDF5 takes no chunk that is longer than its dataset can become.
    const std::array<hsize_t, 2> extents{cases, width};
    const std::array<hsize_t, 2> greatest{std::max<hsize_t>(cases, chunk_cases), width};
    const std::array<hsize_t, 2> chunk{chunk_cases, width};
    const Handle space(H5Screate_simple(rank_, extents.data(), greatest.data()));
    const Handle creation(H5Pcreate(H5P_DATASET_CREATE));
    checked(H5Pset_chunk(creation, rank_, chunk.data()));
    checked(H5Pset_fill_time(creation, H5D_FILL_TIME_NEVER));
    checked(H5Pset_shuffle(creation));
    checked(H5Pset_deflate(creation, 1));
    checked(H5Pset_fletcher32(creation));
    dataset_ = hdf5::make_dataset(group, name, words.empty() ? H5T_IEEE_F64LE : H5T_STD_U8LE, space,
                                  creation);
    if (!words.empty()) write_attribute(dataset_, "words", words);
  }

  hid_t id() const { return dataset_; }
  std::uint32_t element_size() const { return element_size_; }
  void write(std::uint64_t chunk, PackedValues& values) {
    const std::array<hsize_t, 2> first{chunk * chunk_cases_, 0};
    put(values.bytes, fletcher32(values.bytes));
    checked(H5Dwrite_chunk(dataset_, H5P_DEFAULT, 0, first.data(), values.bytes.size(),
                           values.bytes.data()));
  }

 private:
  Handle dataset_;
  std::uint32_t element_size_;
  std::uint64_t chunk_cases_;
  int rank_;
};

// Writes the datasets NAME, NAME_low and NAME_high: the values, and the ends of their intervals. A
// relative error above 0 becomes an attribute of each.
void write_bounded(hid_t group, const std::string& name, const std::vector<Bounded>& numbers,
                   const std::vector<hsize_t>& extents, double relative_error = 0) {
  for (const auto& [ending, part] :
       {std::pair{"", &Bounded::value}, std::pair{"_low", &Bounded::low},
        std::pair{"_high", &Bounded::high}}) {
    std::vector<double> values;
    for (const Bounded& number : numbers) values.push_back(number.*part);
    const Handle dataset = write_array(group, name + ending, values, extents);
    if (relative_error > 0) write_attribute(dataset, "relative_error", relative_error);
  }
}

void write_summary(hid_t group, const Column& column, const std::vector<ValueSummary>& summaries) {
  constexpr std::size_t levels = quantile_levels.size();
  write_attribute(group, "unit", column.unit);
  write_attribute(group, "meaning", column.meaning);
  if (!column.words.empty()) write_attribute(group, "words", column.words);

  std::vector<std::uint64_t> count, undefined, counts;
  std::vector<double> mean, sd, least, greatest, edges;
  std::vector<Bounded> quantiles;
  for (const ValueSummary& summary : summaries) {
    const Moments& moments = summary.moments;
    const bool is_empty = moments.count == 0;
    count.push_back(moments.count);
    undefined.push_back(summary.undefined);
    mean.push_back(is_empty ? nan : moments.mean);
    sd.push_back(moments.sd());
    least.push_back(is_empty ? nan : moments.least);
    greatest.push_back(is_empty ? nan : moments.greatest);
    for (const double level : quantile_levels) quantiles.push_back(quantile_of(summary, level));
    double* const edge = &*edges.insert(edges.end(), histogram_bins + 1, nan);
    std::uint64_t* const in_bin = &*counts.insert(counts.end(), histogram_bins, 0);
    const std::vector<QuantileSketch::Bin> bins = histogram_of(summary.sketch, histogram_bins);
    for (std::size_t i = 0; i < bins.size(); ++i) {
      edge[i] = bins[i].low;
      edge[i + 1] = bins[i].high;
      in_bin[i] = bins[i].count;
    }
  }

  const hsize_t width = summaries.size();
  write_array(group, "count", count, {width});
  write_array(group, "undefined", undefined, {width});
  write_array(group, "mean", mean, {width});
  write_array(group, "sd", sd, {width});
  write_array(group, "least", least, {width});
  write_array(group, "greatest", greatest, {width});
  write_array(group, "quantile_levels",
              std::vector<double>(quantile_levels.begin(), quantile_levels.end()), {levels});
  write_bounded(group, "quantiles", quantiles, {width, levels}, QuantileSketch::relative_error);
  write_array(group, "histogram_edges", edges, {width, histogram_bins + 1});
  write_array(group, "histogram_counts", counts, {width, histogram_bins});
}

void write_sensitivity(hid_t group, std::size_t variables,
                       const std::vector<SensitivityBlocks>& values) {
  std::vector<Bounded> first_order, total;
  std::vector<std::uint64_t> groups, left_out;
  // Where no chunk has a value, all indices of this value are NaN.
  const auto append = [&](std::vector<Bounded>& to, std::vector<Bounded> indices) {
    indices.resize(variables, {nan, nan, nan});
    to.insert(to.end(), indices.begin(), indices.end());
  };
  for (const SensitivityBlocks& blocks : values) {
    const SobolIndices indices = sobol_indices(blocks);
    append(first_order, indices.first_order);
    append(total, indices.total);
    groups.push_back(indices.groups);
    left_out.push_back(0);
    for (const SensitivitySums& sums : blocks) left_out.back() += sums.left_out;
  }
  const hsize_t width = values.size();
  write_bounded(group, "first_order", first_order, {width, variables});
  write_bounded(group, "total", total, {width, variables});
  write_array(group, "groups", groups, {width});
  write_array(group, "left_out", left_out, {width});
}

// Writes the group of one scene: its points as the chunks come, and its summaries at the end.
class SceneWriter {
 public:
  SceneWriter(hid_t file, const SceneSweep& scene)
      : scene_(scene), group_(hdf5::make_group(file, scene.scene.id)) {
    write_attributes();
    if (scene.asks_at_speeds()) write_speeds();
    make_inputs();
    if (scene.keep_points) make_outputs();
    for (const Column& column : scene.columns) {
      summaries_.emplace_back(column.width);
      if (scene.sensitivity) sensitivities_.emplace_back(column.width);
    }
  }

  void add(std::uint64_t number, Chunk chunk) {
    if (!fits(chunk)) throw std::runtime_error("a chunk does not fit the plan");
    if (scene_.keep_points)
      for (std::size_t i = 0; i < datasets_.size(); ++i)
        datasets_[i].write(number, chunk.values[i]);
    for (std::size_t c = 0; c < summaries_.size(); ++c)
      for (std::size_t i = 0; i < summaries_[c].size(); ++i) {
        summaries_[c][i].merge(chunk.summaries[c][i]);
        if (!scene_.sensitivity) continue;
        for (const auto& [block, sums] : chunk.sensitivities[c][i])
          sensitivities_[c][i][block].merge(sums);
      }
  }

  void finish() {
    const Handle summary = hdf5::make_group(group_, "summary");
    for (std::size_t c = 0; c < summaries_.size(); ++c) {
      const Column& column = scene_.columns[c];
      write_summary(make_groups(summary, path_of_column(column.name)), column, summaries_[c]);
    }
    if (!scene_.sensitivity) return;
    const Handle sensitivity = hdf5::make_group(group_, "sensitivity");
    std::vector<std::string> variables;
    for (const Variable& variable : scene_.variables)
      if (variable.is_drawn()) variables.push_back(variable.path);
    write_attribute(sensitivity, "variables", variables);
    for (std::size_t c = 0; c < sensitivities_.size(); ++c)
      write_sensitivity(make_groups(sensitivity, path_of_column(scene_.columns[c].name)),
                        variables.size(), sensitivities_[c]);
  }

 private:
  void write_attributes() const {
    write_attribute(group_, "scene", scene_.text);
    write_attribute(group_, "file", scene_.file);
    write_attribute(group_, "design", name(scene_.design));
    write_attribute(group_, "seed", scene_.seed);
    write_attribute(group_, "draws", scene_.draws);
    write_attribute(group_, "cases", scene_.cases());
    write_attribute(group_, "points", scene_.points());
    write_attribute(group_, "departure", scene_.departure);
    std::vector<std::string> columns;
    for (const Column& column : scene_.columns) columns.push_back(column.name);
    write_attribute(group_, "columns", columns);
  }

  void write_speeds() const {
    const Speeds& speeds = scene_.scene.speeds;
    std::vector<double> values(speeds.size());
    speeds.fill(0, values);
    write_attribute(write_array(group_, "speed", values, {values.size()}), "unit", "m/s");
  }

  void make_inputs() {
    const Handle inputs = hdf5::make_group(group_, "inputs");
    for (const Variable& variable : scene_.variables) {
      CaseDataset dataset(inputs, variable.path, variable.words,
                          scene_.keep_points ? scene_.cases() : 0, scene_.chunk_cases(), 1);
      write_attribute(dataset.id(), "unit", variable.unit);
      write_attribute(dataset.id(), "meaning", variable.meaning);
      write_attribute(dataset.id(), "varies", variable.text);
      if (scene_.keep_points) datasets_.push_back(std::move(dataset));
    }
  }

  void make_outputs() {
    const Handle outputs = hdf5::make_group(group_, "outputs");
    std::vector<hid_t> over_speed;
    for (const Column& column : scene_.columns) {
      const std::string path = path_of_column(column.name);
      const std::size_t last = path.rfind('/') + 1;
      datasets_.emplace_back(make_groups(outputs, path.substr(0, last)), path.substr(last),
                             column.words, scene_.cases(), scene_.chunk_cases(), column.width);
      write_attribute(datasets_.back().id(), "unit", column.unit);
      write_attribute(datasets_.back().id(), "meaning", column.meaning);
      if (column.width > 1) over_speed.push_back(datasets_.back().id());
    }
    if (!over_speed.empty())
      hdf5::make_scale(Handle(H5Dopen2(group_, "speed", H5P_DEFAULT)), "speed", over_speed);
  }

  bool fits(const Chunk& chunk) const {
    const auto has_widths = [this](const auto& columns) {
      return std::equal(
          columns.begin(), columns.end(), scene_.columns.begin(), scene_.columns.end(),
          [](const auto& values, const Column& column) { return values.size() == column.width; });
    };
    const bool has_points =
        std::equal(chunk.values.begin(), chunk.values.end(), datasets_.begin(), datasets_.end(),
                   [](const PackedValues& values, const CaseDataset& dataset) {
                     return values.element_size == dataset.element_size();
                   });
    return (!scene_.keep_points || has_points) && has_widths(chunk.summaries) &&
           (!scene_.sensitivity || has_widths(chunk.sensitivities));
  }

  const SceneSweep& scene_;
  Handle group_;
  std::vector<CaseDataset> datasets_;  // variables, then columns; none where points are not kept
  std::vector<std::vector<ValueSummary>> summaries_;
  std::vector<std::vector<SensitivityBlocks>> sensitivities_;
};

void write_result_content(const std::string& path, const SweepPlan& plan, const PartSet& chunks,
                          const std::function<void(std::uint64_t)>& told) {
  Handle file = hdf5::create_file(path);
  std::string title = "Results of tribocheck sweep:";
  for (const SceneSweep& scene : plan.scenes) title += ' ' + scene.file;
  write_attribute(file, "format", result_format);
  write_attribute(file, "title", title);
  write_attribute(file, "tribocheck_version", plan.version);
  write_attribute(file, "tribocheck_commit", build_commit);
  write_attribute(file, "sweep_digest", plan.digest);
  write_attribute(file, "arithmetic", chunks.arithmetics());
  checked(H5Fflush(file, H5F_SCOPE_GLOBAL));  // the file now has our mark: is_start_of_result()
  std::uint64_t written = 0;
  for (const SceneSweep& scene : plan.scenes) {
    SceneWriter writer(file, scene);
    for (std::uint64_t i = 0; i < scene.chunks; ++i) {
      writer.add(i, Chunk::from(chunks.read(written)));
      ++written;
      if (told) told(written);
    }
    writer.finish();
  }
  checked(H5Fflush(file, H5F_SCOPE_GLOBAL));
  file.close();
  if (const auto failed = hdf5::take_failed_close()) throw hdf5::Error(*failed);
}

}  // namespace

bool is_start_of_result(std::span<const std::byte> start) {
  return hdf5::is_start_of(start, result_format);
}

Descriptor write_result(const std::string& path, const SweepPlan& plan, const PartSet& chunks,
                        const std::function<void(std::uint64_t)>& told,
                        const Replaceable& replaceable, bool is_shared) {
  const hdf5::QuietErrors quiet;
  const auto cannot_write = [&path](const std::string& why) {
    return std::runtime_error("cannot write " + path + ": " + why);
  };
  const std::uint64_t count = plan.chunks();
  if (chunks.chunks() != count || chunks.count() != count)
    throw cannot_write(std::to_string(chunks.count()) + " of " + std::to_string(count) +
                       " chunks are there");
  try {
    PartFile part = is_shared ? PartFile(path) : PartFile(path, is_start_of_result);
    write_result_content(part.open_path(), plan, chunks, told);
    seal(part.file());
    part.keep(replaceable);
    return part.release();
  } catch (const Stopped&) {
    throw;
  } catch (const std::exception& error) {
    throw cannot_write(error.what());
  }
}

}  // namespace tribo::sweep
