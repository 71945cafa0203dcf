// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sweep/hdf5_handles.hpp"
#include "sweep/result_file.hpp"
#include "sweep/result_names.hpp"
#include "sweep/result_seal.hpp"

namespace tribo::sweep {
namespace {

using hdf5::checked;
using hdf5::Handle;
using hdf5::read_count;
using hdf5::read_text;
using hdf5::read_texts;

// A result, open; all that HDF5 finds wrong in it becomes one line.
class ResultReader {
 public:
  explicit ResultReader(const std::string& path) : path_(path) {
    if (const std::string why = broken_seal(path); !why.empty()) refuse(why);
    const Handle access(H5Pcreate(H5P_FILE_ACCESS));
    checked(H5Pset_fclose_degree(access, H5F_CLOSE_STRONG));
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
    if (file < 0) refuse("cannot be opened by HDF5: " + hdf5::last_error());
    file_ = Handle(file);
    bool is_ours = false;
    try {
      is_ours = H5Aexists(file_, "format") > 0 && read_text(file_, "format") == result_format;
    } catch (const hdf5::Error&) {  // somebody else's attribute of that name
    }
    if (!is_ours) refuse("is an HDF5 file, but no result of tribocheck sweep");
  }

  template <class Read>
  auto read(Read&& read_from) const {
    try {
      return read_from(static_cast<hid_t>(file_));
    } catch (const hdf5::Error& error) {
      refuse(std::string("is no whole result of tribocheck sweep: ") + error.what());
    }
  }

  [[noreturn]] void refuse(const std::string& why) const {
    throw std::runtime_error(path_ + " " + why);
  }

 private:
  hdf5::QuietErrors quiet_;
  std::string path_;
  Handle file_;
};

Handle open_group(hid_t parent, const std::string& name) {
  return Handle(H5Gopen2(parent, name.c_str(), H5P_DEFAULT));
}
Handle open_dataset(hid_t parent, const std::string& name) {
  return Handle(H5Dopen2(parent, name.c_str(), H5P_DEFAULT));
}
bool exists(hid_t parent, const std::string& name) {
  return checked(H5Lexists(parent, name.c_str(), H5P_DEFAULT)) > 0;
}

// Names of what a group holds, in the order in which it was written.
std::vector<std::string> names_in(hid_t group) {
  H5G_info_t info;
  checked(H5Gget_info(group, &info));
  std::vector<std::string> names;
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    const auto get = [&](char* text, std::size_t size) {
      return static_cast<std::size_t>(checked(H5Lget_name_by_idx(
          group, ".", H5_INDEX_CRT_ORDER, H5_ITER_INC, i, text, size, H5P_DEFAULT)));
    };
    std::string name(get(nullptr, 0), '\0');
    get(name.data(), name.size() + 1);
    names.push_back(std::move(name));
  }
  return names;
}

hid_t memory_type(double) { return H5T_NATIVE_DOUBLE; }
hid_t memory_type(std::uint64_t) { return H5T_NATIVE_UINT64; }

template <class T>
std::vector<T> read_array(hid_t dataset, hid_t type) {
  const Handle space(H5Dget_space(dataset));
  std::vector<T> values(static_cast<std::size_t>(checked(H5Sget_simple_extent_npoints(space))));
  checked(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
  return values;
}

// Of known size.
template <class T>
std::vector<T> read_array(hid_t group, const std::string& name, std::size_t size) {
  std::vector<T> values = read_array<T>(open_dataset(group, name), memory_type(T()));
  if (values.size() != size) throw hdf5::Error(name + " is of another size than its column");
  return values;
}

// Also words, as their places.
std::vector<double> read_values(hid_t dataset) {
  return read_array<double>(dataset, H5T_NATIVE_DOUBLE);
}

std::vector<std::string> words_of(hid_t object) {
  if (checked(H5Aexists(object, "words")) == 0) return {};
  return read_texts(object, "words");
}

std::size_t length_of(hid_t dataset) {
  const Handle space(H5Dget_space(dataset));
  return static_cast<std::size_t>(checked(H5Sget_simple_extent_npoints(space)));
}

ResultIdentity identity_of(hid_t file) {
  return {read_text(file, "tribocheck_version"), read_text(file, "sweep_digest"),
          read_text(file, "arithmetic")};
}

std::vector<QuantileSketch::Bin> bins_from(std::span<const double> edges,
                                           std::span<const std::uint64_t> counts) {
  std::vector<QuantileSketch::Bin> bins;
  for (std::size_t i = 0; i < counts.size() && !std::isnan(edges[i + 1]); ++i)
    bins.push_back({edges[i], edges[i + 1], counts[i]});
  return bins;
}

ColumnResult read_summary(hid_t group, const std::string& name) {
  constexpr std::size_t levels = quantile_levels.size();
  ColumnResult column{name, read_text(group, "unit"), words_of(group), {}};
  const std::size_t width = length_of(open_dataset(group, "count"));
  const auto count = read_array<std::uint64_t>(group, "count", width);
  const auto undefined = read_array<std::uint64_t>(group, "undefined", width);
  const auto mean = read_array<double>(group, "mean", width);
  const auto sd = read_array<double>(group, "sd", width);
  const auto least = read_array<double>(group, "least", width);
  const auto greatest = read_array<double>(group, "greatest", width);
  const auto quantiles = read_array<double>(group, "quantiles", width * levels);
  const auto low = read_array<double>(group, "quantiles_low", width * levels);
  const auto high = read_array<double>(group, "quantiles_high", width * levels);
  const auto edges = read_array<double>(group, "histogram_edges", width * (histogram_bins + 1));
  const auto counts = read_array<std::uint64_t>(group, "histogram_counts", width * histogram_bins);
  for (std::size_t i = 0; i < width; ++i) {
    ColumnResult::Value& value = column.values.emplace_back();
    value.count = count[i];
    value.undefined = undefined[i];
    value.mean = mean[i];
    value.sd = sd[i];
    value.least = least[i];
    value.greatest = greatest[i];
    for (std::size_t q = i * levels; q < (i + 1) * levels; ++q)
      value.quantiles.push_back({quantiles[q], low[q], high[q]});
    value.histogram =
        bins_from(std::span(edges).subspan(i * (histogram_bins + 1), histogram_bins + 1),
                  std::span(counts).subspan(i * histogram_bins, histogram_bins));
  }
  return column;
}

void read_sensitivity(hid_t group, std::size_t variables, ColumnResult& column) {
  const std::size_t width = column.values.size();
  const auto groups = read_array<std::uint64_t>(group, "groups", width);
  const auto read_index = [&](const std::string& name,
                              std::vector<SobolIndex> SobolIndices::*kind) {
    const auto value = read_array<double>(group, name, width * variables);
    const auto low = read_array<double>(group, name + "_low", width * variables);
    const auto high = read_array<double>(group, name + "_high", width * variables);
    for (std::size_t i = 0; i < value.size(); ++i)
      (column.values[i / variables].sensitivity.*kind).push_back({value[i], low[i], high[i]});
  };
  read_index("first_order", &SobolIndices::first_order);
  read_index("total", &SobolIndices::total);
  for (std::size_t i = 0; i < width; ++i) column.values[i].sensitivity.groups = groups[i];
}

InputResult read_input_texts(hid_t inputs, const std::string& path) {
  const Handle dataset = open_dataset(inputs, path);
  return {path, read_text(dataset, "unit"), read_text(dataset, "meaning"),
          read_text(dataset, "varies"), words_of(dataset)};
}

SceneResult read_scene(hid_t file, const std::string& id) {
  const Handle group = open_group(file, id);
  SceneResult scene;
  scene.id = id;
  scene.file = read_text(group, "file");
  scene.text = read_text(group, "scene");
  scene.design = read_text(group, "design");
  scene.seed = read_count(group, "seed");
  scene.draws = read_count(group, "draws");
  scene.cases = read_count(group, "cases");
  scene.points = read_count(group, "points");
  if (exists(group, "speed")) scene.speeds = read_values(open_dataset(group, "speed"));
  const Handle inputs = open_group(group, "inputs");
  for (const std::string& path : names_in(inputs))
    scene.inputs.push_back(read_input_texts(inputs, path));
  const Handle summary = open_group(group, "summary");
  for (const std::string& name : read_texts(group, "columns"))
    scene.columns.push_back(read_summary(open_group(summary, path_of_column(name)), name));
  if (exists(group, "sensitivity")) {
    const Handle sensitivity = open_group(group, "sensitivity");
    scene.sensitivity_variables = read_texts(sensitivity, "variables");
    for (ColumnResult& column : scene.columns)
      read_sensitivity(open_group(sensitivity, path_of_column(column.name)),
                       scene.sensitivity_variables.size(), column);
  }
  scene.has_points = exists(group, "outputs");
  return scene;
}

// The values of each case at a path below a scene.
std::vector<double> read_cases(const std::string& path, const std::string& scene_id,
                               const std::string& folder, const std::string& name,
                               const std::string& place) {
  const ResultReader result(path);
  return result.read([&](hid_t file) {
    if (scene_id.empty() || !exists(file, scene_id)) result.refuse("has no scene " + scene_id);
    const Handle scene = open_group(file, scene_id);
    if (!exists(scene, "outputs"))
      result.refuse("keeps no points of scene " + scene_id + ", only summaries");
    const Handle group = open_group(scene, folder);
    std::size_t end = 0;
    do {  // H5Lexists() wants to know of all groups on the way that they are there
      end = place.find('/', end + 1);
      if (!exists(group, place.substr(0, end)))
        result.refuse("has no " + name + " among the " + folder + " of scene " + scene_id);
    } while (end != place.npos);
    return read_values(open_dataset(group, place));
  });
}

}  // namespace

const ColumnResult* SceneResult::column(std::string_view name) const {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const ColumnResult& one) { return one.name == name; });
  return found == columns.end() ? nullptr : &*found;
}

ResultIdentity identity_of_result(const std::string& path) {
  return ResultReader(path).read(identity_of);
}

SweepResult read_result(const std::string& path) {
  return ResultReader(path).read([](hid_t file) {
    SweepResult result{identity_of(file), {}};
    for (const std::string& id : names_in(file)) result.scenes.push_back(read_scene(file, id));
    return result;
  });
}

std::vector<double> read_input(const std::string& path, const std::string& scene_id,
                               const std::string& input) {
  return read_cases(path, scene_id, "inputs", input, input);
}

std::vector<double> read_column(const std::string& path, const std::string& scene_id,
                                const std::string& column) {
  return read_cases(path, scene_id, "outputs", column, path_of_column(column));
}

}  // namespace tribo::sweep
