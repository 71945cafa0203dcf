// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

#include "sweep/apart.hpp"
#include "sweep/bytes.hpp"
#include "sweep/hdf5_handles.hpp"
#include "sweep/result_file.hpp"
#include "sweep/result_seal.hpp"

namespace tribo::sweep {
namespace {

using hdf5::checked;
using hdf5::Handle;
using hdf5::read_count;
using hdf5::read_text;
using hdf5::read_texts;

// Any fault that HDF5 or this reader finds in a result becomes one line with these words.
constexpr const char* not_whole = "is no whole result of tribocheck sweep: ";

struct NotThere : std::runtime_error {
  using std::runtime_error::runtime_error;
};

Handle open_result(const std::string& path) {
  Handle file;
  try {
    file = hdf5::open_file(path);
  } catch (const hdf5::Error& why) {
    throw NotThere(std::string("cannot be opened by HDF5: ") + why.what());
  }
  bool is_ours = false;
  try {
    is_ours = H5Aexists(file, "format") > 0 && read_text(file, "format") == result_format;
  } catch (const hdf5::Error&) {  // another program's attribute has that name
  }
  if (!is_ours) throw NotThere("is an HDF5 file, but no result of tribocheck sweep");
  return file;
}

// --- Groups and datasets. Each one is checked before it is read: it must have the form that
// result_write.cpp gives it.

bool exists(hid_t parent, const std::string& name) {
  return checked(H5Lexists(parent, name.c_str(), H5P_DEFAULT)) > 0;
}

// Opens the object at a path below a group. Only hard links are followed; a soft link, or a link
// into another file, is refused.
Handle open_object(hid_t parent, const std::string& path) {
  Handle object;
  for (std::size_t start = 0; start <= path.size();) {
    const std::size_t end = std::min(path.find('/', start), path.size());
    const std::string name = path.substr(start, end - start);
    const hid_t group = start == 0 ? parent : static_cast<hid_t>(object);
    H5L_info_t link;
    checked(H5Lget_info(group, name.c_str(), &link, H5P_DEFAULT));
    if (link.type != H5L_TYPE_HARD) throw hdf5::Error(path + " is a link to something else");
    object = Handle(H5Oopen(group, name.c_str(), H5P_DEFAULT));
    start = end + 1;
  }
  return object;
}

Handle open_group(hid_t parent, const std::string& path) {
  Handle group = open_object(parent, path);
  if (H5Iget_type(group) != H5I_GROUP) throw hdf5::Error(path + " is no group");
  return group;
}

// Allows only storage that the writer uses: no filter of another library is run, and no dataset
// made of other files is read.
void check_storage(hid_t dataset, const std::string& name) {
  const Handle creation(H5Dget_create_plist(dataset));
  if (H5Pget_layout(creation) != H5D_CHUNKED || checked(H5Pget_external_count(creation)) != 0)
    throw hdf5::Error(name + " is not stored as tribocheck stores it");
  const int filters = checked(H5Pget_nfilters(creation));
  for (int i = 0; i < filters; ++i) {
    unsigned flags = 0;
    std::size_t values = 0;
    const H5Z_filter_t filter = checked(H5Pget_filter2(creation, static_cast<unsigned>(i), &flags,
                                                       &values, nullptr, 0, nullptr, nullptr));
    if (filter != H5Z_FILTER_DEFLATE && filter != H5Z_FILTER_SHUFFLE &&
        filter != H5Z_FILTER_FLETCHER32)
      throw hdf5::Error(name + " is packed by a filter that tribocheck does not use");
  }
}

std::vector<hsize_t> extents_of(hid_t dataset, const std::string& name) {
  const Handle space(H5Dget_space(dataset));
  if (H5Sget_simple_extent_type(space) != H5S_SIMPLE) throw hdf5::Error(name + " is no array");
  std::vector<hsize_t> extents(
      static_cast<std::size_t>(checked(H5Sget_simple_extent_ndims(space))));
  checked(H5Sget_simple_extent_dims(space, extents.data(), nullptr));
  return extents;
}

// The length of a dataset of one dimension.
std::size_t length_of(hid_t parent, const std::string& name) {
  const std::vector<hsize_t> extents = extents_of(open_object(parent, name), name);
  if (extents.size() != 1) throw hdf5::Error(name + " is no list");
  return static_cast<std::size_t>(extents.front());
}

// The content of a dataset. Throws where its type or its extents are not the given ones. With a
// range, only the rows of the cases in that range are read.
template <class T>
std::vector<T> read_array(hid_t parent, const std::string& name, hid_t type,
                          const std::vector<hsize_t>& extents,
                          const std::optional<CaseRange>& range = {}) {
  const Handle dataset = open_object(parent, name);
  if (H5Iget_type(dataset) != H5I_DATASET) throw hdf5::Error(name + " is no dataset");
  if (checked(H5Tequal(Handle(H5Dget_type(dataset)), type)) == 0)
    throw hdf5::Error(name + " has values of another type");
  if (extents_of(dataset, name) != extents)
    throw hdf5::Error(name + " is of another size than its scene or column");
  check_storage(dataset, name);
  const Handle in_file(H5Dget_space(dataset));
  std::vector<hsize_t> read = extents;
  if (range) {
    std::vector<hsize_t> start(extents.size(), 0);
    start.front() = range->first;
    read.front() = range->count;
    checked(
        H5Sselect_hyperslab(in_file, H5S_SELECT_SET, start.data(), nullptr, read.data(), nullptr));
  }
  std::size_t count = 1;
  for (const hsize_t extent : read)
    if (__builtin_mul_overflow(count, extent, &count)) throw hdf5::Error(name + " is too large");
  std::vector<T> values(count);
  const Handle in_memory(H5Screate_simple(static_cast<int>(read.size()), read.data(), nullptr));
  checked(H5Dread(dataset, hdf5::memory_type(T()), in_memory, in_file, H5P_DEFAULT, values.data()));
  return values;
}
template <class T>
std::vector<T> read_array(hid_t parent, const std::string& name,
                          const std::vector<hsize_t>& extents) {
  return read_array<T>(parent, name, hdf5::file_type(T()), extents);
}

// The names of a group's members, in the order in which they were written.
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

std::vector<std::string> words_of(hid_t object) {
  if (checked(H5Aexists(object, "words")) == 0) return {};
  return read_texts(object, "words");
}

ResultIdentity identity_of(hid_t file) {
  return {read_text(file, "tribocheck_version"), read_text(file, "sweep_digest"),
          read_text(file, "arithmetic")};
}

// The numbers of a dataset NAME, and of NAME_low and NAME_high.
std::vector<Bounded> read_bounded(hid_t group, const std::string& name,
                                  const std::vector<hsize_t>& extents) {
  const auto value = read_array<double>(group, name, extents);
  const auto low = read_array<double>(group, name + "_low", extents);
  const auto high = read_array<double>(group, name + "_high", extents);
  std::vector<Bounded> numbers;
  for (std::size_t i = 0; i < value.size(); ++i) numbers.push_back({value[i], low[i], high[i]});
  return numbers;
}

// Row i of an array whose rows all have this length.
template <class T>
std::span<const T> row_of(const std::vector<T>& array, std::size_t i, std::size_t length) {
  return std::span(array).subspan(i * length, length);
}

ColumnResult read_summary(hid_t group, const std::string& name, std::size_t speeds) {
  constexpr std::size_t levels = quantile_levels.size();
  ColumnResult column{name, read_text(group, "unit"), words_of(group), {}};
  const std::size_t width = length_of(group, "count");
  if (width != 1 && width != speeds)
    throw hdf5::Error(name + " has neither one value a case nor one for each speed");
  const auto count = read_array<std::uint64_t>(group, "count", {width});
  const auto undefined = read_array<std::uint64_t>(group, "undefined", {width});
  const auto mean = read_array<double>(group, "mean", {width});
  const auto sd = read_array<double>(group, "sd", {width});
  const auto least = read_array<double>(group, "least", {width});
  const auto greatest = read_array<double>(group, "greatest", {width});
  const auto quantiles = read_bounded(group, "quantiles", {width, levels});
  const auto edges = read_array<double>(group, "histogram_edges", {width, histogram_bins + 1});
  const auto counts = read_array<std::uint64_t>(group, "histogram_counts", {width, histogram_bins});
  for (std::size_t i = 0; i < width; ++i) {
    const auto of_value = row_of(quantiles, i, levels);
    column.values.push_back({.count = count[i],
                             .undefined = undefined[i],
                             .mean = mean[i],
                             .sd = sd[i],
                             .least = least[i],
                             .greatest = greatest[i],
                             .quantiles = {of_value.begin(), of_value.end()},
                             .histogram = {},
                             .sensitivity = {}});
    const auto edge = row_of(edges, i, histogram_bins + 1);
    const auto in_bin = row_of(counts, i, histogram_bins);
    for (std::size_t b = 0; b < histogram_bins && !std::isnan(edge[b + 1]); ++b)
      column.values[i].histogram.push_back({edge[b], edge[b + 1], in_bin[b]});
  }
  return column;
}

void read_sensitivity(hid_t group, std::size_t variables, ColumnResult& column) {
  const std::size_t width = column.values.size();
  const auto groups = read_array<std::uint64_t>(group, "groups", {width});
  const auto first_order = read_bounded(group, "first_order", {width, variables});
  const auto total = read_bounded(group, "total", {width, variables});
  for (std::size_t i = 0; i < width; ++i) {
    const auto first = row_of(first_order, i, variables), all = row_of(total, i, variables);
    column.values[i].sensitivity = {
        {first.begin(), first.end()}, {all.begin(), all.end()}, groups[i]};
  }
}

InputResult read_input_texts(hid_t inputs, const std::string& path) {
  const Handle dataset = open_object(inputs, path);
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
  if (exists(group, "speed"))
    scene.speeds = read_array<double>(group, "speed", {length_of(group, "speed")});
  const Handle inputs = open_group(group, "inputs");
  for (const std::string& path : names_in(inputs))
    scene.inputs.push_back(read_input_texts(inputs, path));
  const Handle summary = open_group(group, "summary");
  for (const std::string& name : read_texts(group, "columns"))
    scene.columns.push_back(
        read_summary(open_group(summary, path_of_column(name)), name, scene.speeds.size()));
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

// The values of each case, or of a range of cases, at a path below a scene.
std::vector<double> read_cases(hid_t file, const std::string& scene_id, const std::string& folder,
                               const std::string& name, const std::optional<CaseRange>& range) {
  if (scene_id.empty() || !exists(file, scene_id)) throw NotThere("has no scene " + scene_id);
  const Handle scene = open_group(file, scene_id);
  if (!exists(scene, "outputs"))
    throw NotThere("keeps no points of scene " + scene_id + ", only summaries");
  const std::string place = folder == "outputs" ? path_of_column(name) : name;
  const Handle group = open_group(scene, folder);
  std::size_t end = 0;
  do {  // part by part, because H5Lexists() fails on a path with a missing group
    end = place.find('/', end + 1);
    if (!exists(group, place.substr(0, end)))
      throw NotThere("has no " + name + " among the " + folder + " of scene " + scene_id);
  } while (end != place.npos);
  std::vector<hsize_t> extents{read_count(scene, "cases")};
  if (folder == "outputs") {
    const Handle summary = open_group(scene, "summary");
    const std::size_t width = length_of(open_group(summary, place), "count");
    if (width > 1) extents.push_back(width);
  }
  const hid_t type =
      words_of(open_object(group, place)).empty() ? hdf5::file_type(0.0) : H5T_STD_U8LE;
  return read_array<double>(group, place, type, extents, range);
}

}  // namespace

// Passes every field of a struct once to a Sender or a Receiver (bytes.hpp).
template <class To, class T>
void each_field(To& to, T& of) {
  using Struct = std::remove_const_t<T>;
  if constexpr (std::is_same_v<Struct, ResultIdentity>)
    to(of.version, of.digest, of.arithmetic);
  else if constexpr (std::is_same_v<Struct, Bounded>)
    to(of.value, of.low, of.high);
  else if constexpr (std::is_same_v<Struct, QuantileSketch::Bin>)
    to(of.low, of.high, of.count);
  else if constexpr (std::is_same_v<Struct, SobolIndices>)
    to(of.first_order, of.total, of.groups);
  else if constexpr (std::is_same_v<Struct, ColumnResult::Value>)
    to(of.count, of.undefined, of.mean, of.sd, of.least, of.greatest, of.quantiles, of.histogram,
       of.sensitivity);
  else if constexpr (std::is_same_v<Struct, ColumnResult>)
    to(of.name, of.unit, of.words, of.values);
  else if constexpr (std::is_same_v<Struct, InputResult>)
    to(of.path, of.unit, of.meaning, of.varies, of.words);
  else if constexpr (std::is_same_v<Struct, SceneResult>)
    to(of.id, of.file, of.text, of.design, of.seed, of.draws, of.cases, of.points, of.speeds,
       of.inputs, of.sensitivity_variables, of.columns, of.has_points);
  else {
    static_assert(std::is_same_v<Struct, SweepResult>);
    to(of.identity, of.scenes);
  }
}

const ColumnResult* SceneResult::column(std::string_view name) const {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const ColumnResult& one) { return one.name == name; });
  return found == columns.end() ? nullptr : &*found;
}

ResultFile::ResultFile(const std::string& path, const std::function<bool()>& stopped)
    : path_(path), file_(open_file(path, O_RDONLY, path + " cannot be read")), is_own_(false) {
  if (const std::string why = broken_seal(file_, path, "result", stopped); !why.empty())
    throw std::runtime_error(path + ' ' + why);
}

ResultFile::ResultFile(const std::string& path, Descriptor own)
    : path_(path), file_(std::move(own)), is_own_(true) {}

template <class Result, class Read>
Result ResultFile::read_with(Read&& read) const {
  const auto read_here = [&] {
    const hdf5::QuietErrors quiet;
    return read(static_cast<hid_t>(open_result(open_path_of(file_))));
  };
  try {
    if (is_own_) return read_here();
    const Bytes bytes = apart(size_of(file_, "cannot read it"), [&] {
      Bytes answer;
      try {
        Sender{answer}(true, std::string(), read_here());
      } catch (const NotThere& why) {
        Sender{answer}(false, std::string(why.what()));
      }
      return answer;
    });
    Receiver received(bytes);
    bool is_there = false;
    std::string why;
    received(is_there, why);
    if (!is_there) throw NotThere(why);
    Result result;
    received(result);
    return result;
  } catch (const NotThere& why) {
    throw std::runtime_error(path_ + ' ' + why.what());
  } catch (const std::system_error&) {  // such an error says nothing about the file
    throw;
  } catch (const std::exception& error) {
    throw std::runtime_error(path_ + ' ' + not_whole + error.what());
  }
}

ResultIdentity ResultFile::identity() const { return read_with<ResultIdentity>(identity_of); }

SweepResult ResultFile::read() const {
  return read_with<SweepResult>([](hid_t file) {
    SweepResult result{identity_of(file), {}};
    for (const std::string& id : names_in(file)) result.scenes.push_back(read_scene(file, id));
    return result;
  });
}

std::vector<double> ResultFile::input(const std::string& scene_id, const std::string& name,
                                      const Range& range) const {
  return cases(scene_id, "inputs", name, range);
}

std::vector<double> ResultFile::column(const std::string& scene_id, const std::string& name,
                                       const Range& range) const {
  return cases(scene_id, "outputs", name, range);
}

std::vector<double> ResultFile::cases(const std::string& scene_id, const std::string& folder,
                                      const std::string& name, const Range& range) const {
  return read_with<std::vector<double>>(
      [&](hid_t file) { return read_cases(file, scene_id, folder, name, range); });
}

}  // namespace tribo::sweep
