// SPDX-License-Identifier: Apache-2.0
#include "sweep/compare_results.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

namespace tribo::sweep {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// The most numbers of each file that are in memory at once: 32 MB.
constexpr std::uint64_t block_numbers = std::uint64_t{1} << 22;

bool is_same(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) ||
         std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

double relative_difference(double a, double b) {
  if (!std::isfinite(a) || !std::isfinite(b)) return infinity;
  const double greatest = std::max(std::abs(a), std::abs(b));
  if (greatest == 0) return 0;  // 0 and −0
  const double gap = std::abs(a - b);
  return std::isfinite(gap) ? gap / greatest : std::abs(a / greatest - b / greatest);
}

double absolute_difference(double a, double b) {
  return std::isfinite(a) && std::isfinite(b) ? std::abs(a - b) : infinity;
}

double word_difference(double, double) { return infinity; }

// Counts differences, and keeps the greatest ones.
class Counter {
 public:
  using Measure = double (*)(double, double);

  Counter(double tolerance, std::size_t most) : tolerance_(tolerance), most_(most) {}

  // The next numbers are of this column.
  void begin(ComparedColumn column, Measure measure) {
    result_.columns.push_back(std::move(column));
    measure_ = measure;
  }

  void compare(double a, double b, std::uint64_t one_case, double speed,
               std::string_view statistic = {}) {
    ComparedColumn& column = result_.columns.back();
    ++column.compared;
    if (is_same(a, b)) return;
    const double size = measure_(a, b);
    if (tolerance_ > 0 && size <= tolerance_) return;
    ++column.differing;
    column.worst = std::max(column.worst, size);
    if (worst_.size() == most_ && (most_ == 0 || size <= worst_.rbegin()->difference.size)) return;
    worst_.insert(
        {{result_.columns.size() - 1, one_case, speed, std::string(statistic), a, b, size},
         number_++});
    if (worst_.size() > most_) worst_.erase(std::prev(worst_.end()));
  }

  void note(std::string text) { result_.notes.push_back(std::move(text)); }

  ComparedResults take() {
    for (const Numbered& one : worst_) result_.worst.push_back(one.difference);
    return std::move(result_);
  }

 private:
  struct Numbered {
    Difference difference;
    std::uint64_t number;  // in the files' order
    bool operator<(const Numbered& other) const {
      return difference.size != other.difference.size ? difference.size > other.difference.size
                                                      : number < other.number;
    }
  };

  double tolerance_;
  std::size_t most_;
  Measure measure_ = nullptr;
  ComparedResults result_;
  std::set<Numbered> worst_;
  std::uint64_t number_ = 0;
};

// --- Whether two results can be compared.

// The first member of `list` whose name `other` does not have; null: there is none.
template <class T>
const T* first_missing(const std::vector<T>& list, const std::vector<T>& other,
                       std::string T::*name_of) {
  for (const T& one : list)
    if (std::none_of(other.begin(), other.end(),
                     [&](const T& same) { return same.*name_of == one.*name_of; }))
      return &one;
  return nullptr;
}

template <class T>
const T& named(const std::vector<T>& list, const std::string& wanted, std::string T::*name_of) {
  return *std::find_if(list.begin(), list.end(),
                       [&](const T& one) { return one.*name_of == wanted; });
}

// The two files that are compared, which a refusal names.
struct Pair {
  const ResultFile& first;
  const ResultFile& second;

  [[noreturn]] void refuse(const std::string& why) const {
    throw std::invalid_argument(first.path() + " and " + second.path() +
                                " cannot be compared: " + why);
  }
  // `of` is the text behind the name, such as " of scene a".
  template <class T>
  void check_names(const std::vector<T>& a, const std::vector<T>& b, std::string T::*name_of,
                   const std::string& kind, const std::string& of = {}) const {
    if (const T* const one = first_missing(a, b, name_of))
      refuse("only " + first.path() + " has the " + kind + " " + one->*name_of + of);
    if (const T* const one = first_missing(b, a, name_of))
      refuse("only " + second.path() + " has the " + kind + " " + one->*name_of + of);
  }
};

std::string both(const std::string& a, const std::string& b) { return a + " and " + b; }

void check_column(const Pair& files, const std::string& scene, const ColumnResult& a,
                  const ColumnResult& b) {
  const std::string column = "column " + a.name + " of scene " + scene;
  if (a.unit != b.unit) files.refuse(column + " has the units " + both(a.unit, b.unit));
  if (a.words != b.words) files.refuse(column + " has other words");
  if (a.values.size() != b.values.size())
    files.refuse(column + " has " +
                 both(std::to_string(a.values.size()), std::to_string(b.values.size())) +
                 " values a case");
}

void check_scene(const Pair& files, const SceneResult& a, const SceneResult& b) {
  const std::string of_scene = " of scene " + a.id;
  if (a.cases != b.cases)
    files.refuse("scene " + a.id + " has " +
                 both(std::to_string(a.cases), std::to_string(b.cases)) + " cases");
  if (a.speeds.size() != b.speeds.size())
    files.refuse("scene " + a.id + " has " +
                 both(std::to_string(a.speeds.size()), std::to_string(b.speeds.size())) +
                 " speeds");
  files.check_names(a.inputs, b.inputs, &InputResult::path, "varying field", of_scene);
  for (const InputResult& input : a.inputs)
    if (named(b.inputs, input.path, &InputResult::path).words != input.words)
      files.refuse("field " + input.path + of_scene + " has other words");
  files.check_names(a.columns, b.columns, &ColumnResult::name, "column", of_scene);
  for (const ColumnResult& column : a.columns)
    check_column(files, a.id, column, named(b.columns, column.name, &ColumnResult::name));
  if (a.sensitivity_variables != b.sensitivity_variables)
    files.refuse("scene " + a.id +
                 " has sensitivity indices of other fields, or one result has none");
}

// --- Comparing.

double speed_of(const SceneResult& scene, std::size_t width, std::size_t i) {
  return width > 1 && i < scene.speeds.size() ? scene.speeds[i] : nan;
}

void compare_speeds(Counter& counter, const SceneResult& a, const SceneResult& b) {
  if (a.speeds.empty()) return;
  counter.begin(
      {.scene = a.id, .kind = ComparedKind::speed, .name = "speed", .unit = "m/s", .words = {}},
      relative_difference);
  for (std::size_t i = 0; i < a.speeds.size(); ++i)
    counter.compare(a.speeds[i], b.speeds[i], 0, a.speeds[i]);
}

using ReadCases = std::vector<double> (ResultFile::*)(const std::string&, const std::string&,
                                                      const ResultFile::Range&) const;

void compare_cases(Counter& counter, const Pair& files, const SceneResult& scene,
                   const std::string& column, std::size_t width, ReadCases read) {
  if (width == 0) return;
  const std::uint64_t cases_at_once = std::max<std::uint64_t>(block_numbers / width, 1);
  for (std::uint64_t start = 0; start < scene.cases; start += cases_at_once) {
    const CaseRange range{start, std::min(cases_at_once, scene.cases - start)};
    const std::vector<double> a = (files.first.*read)(scene.id, column, range);
    const std::vector<double> b = (files.second.*read)(scene.id, column, range);
    if (a.size() != b.size()) files.refuse("one of them was changed while it was read");
    for (std::size_t i = 0; i < a.size(); ++i)
      counter.compare(a[i], b[i], start + i / width, speed_of(scene, width, i % width));
  }
}

void compare_points(Counter& counter, const Pair& files, const SceneResult& scene) {
  const auto begin = [&](ComparedKind kind, const std::string& name, const std::string& unit,
                         const std::vector<std::string>& words) {
    counter.begin({.scene = scene.id, .kind = kind, .name = name, .unit = unit, .words = words},
                  words.empty() ? relative_difference : word_difference);
  };
  for (const InputResult& input : scene.inputs) {
    begin(ComparedKind::input, input.path, input.unit, input.words);
    compare_cases(counter, files, scene, input.path, 1, &ResultFile::input);
  }
  for (const ColumnResult& column : scene.columns) {
    begin(ComparedKind::output, column.name, column.unit, column.words);
    compare_cases(counter, files, scene, column.name, column.values.size(), &ResultFile::column);
  }
}

struct Statistic {
  std::string name;
  double value;
};

std::vector<Statistic> statistics_of(const ColumnResult::Value& value) {
  std::vector<Statistic> all{{"count", static_cast<double>(value.count)},
                             {"undefined", static_cast<double>(value.undefined)},
                             {"mean", value.mean},
                             {"sd", value.sd},
                             {"least", value.least},
                             {"greatest", value.greatest}};
  for (std::size_t q = 0; q < value.quantiles.size(); ++q) {
    std::string name = std::to_string(quantile_levels[q]);
    name.erase(name.find_last_not_of('0') + 1);
    name += " quantile";
    all.push_back({name, value.quantiles[q].value});
    all.push_back({name + ", low", value.quantiles[q].low});
    all.push_back({name + ", high", value.quantiles[q].high});
  }
  for (std::size_t b = 0; b < histogram_bins; ++b) {
    const bool is_there = b < value.histogram.size();
    const std::string name = "histogram bin " + std::to_string(b + 1);
    all.push_back({name + ", low", is_there ? value.histogram[b].low : nan});
    all.push_back({name + ", high", is_there ? value.histogram[b].high : nan});
    all.push_back(
        {name + ", count", is_there ? static_cast<double>(value.histogram[b].count) : 0.0});
  }
  return all;
}

std::vector<Statistic> indices_of(const ColumnResult::Value& value,
                                  const std::vector<std::string>& variables) {
  std::vector<Statistic> all{{"groups", static_cast<double>(value.sensitivity.groups)}};
  const auto add = [&](const std::string& kind, const std::vector<Bounded>& indices) {
    for (std::size_t v = 0; v < indices.size(); ++v) {
      const std::string name = kind + " of " + variables[v];
      all.push_back({name, indices[v].value});
      all.push_back({name + ", low", indices[v].low});
      all.push_back({name + ", high", indices[v].high});
    }
  };
  add("first order", value.sensitivity.first_order);
  add("total", value.sensitivity.total);
  return all;
}

// Compares the statistics that `all_of` gives of each value of each column.
template <class AllOf>
void compare_statistics(Counter& counter, const SceneResult& a, const SceneResult& b,
                        ComparedKind kind, Counter::Measure measure, AllOf&& all_of) {
  for (const ColumnResult& column : a.columns) {
    const ColumnResult& other = named(b.columns, column.name, &ColumnResult::name);
    counter.begin({.scene = a.id,
                   .kind = kind,
                   .name = column.name,
                   .unit = kind == ComparedKind::summary ? column.unit : std::string(),
                   .words = {}},
                  measure);
    for (std::size_t i = 0; i < column.values.size(); ++i) {
      const std::vector<Statistic> first = all_of(column.values[i]);
      const std::vector<Statistic> second = all_of(other.values[i]);
      const double speed = speed_of(a, column.values.size(), i);
      for (std::size_t s = 0; s < first.size(); ++s)
        counter.compare(first[s].value, second[s].value, 0, speed, first[s].name);
    }
  }
}

void compare_scene(Counter& counter, const Pair& files, const SceneResult& a,
                   const SceneResult& b) {
  if (a.text != b.text) counter.note("scene " + a.id + ": the sweep files differ");
  compare_speeds(counter, a, b);
  if (a.has_points && b.has_points) {
    compare_points(counter, files, a);
  } else {
    if (a.has_points != b.has_points)
      counter.note("scene " + a.id + ": only the summaries are compared, as " +
                   (a.has_points ? files.second : files.first).path() + " keeps no cases");
    compare_statistics(counter, a, b, ComparedKind::summary, relative_difference, statistics_of);
  }
  if (a.sensitivity_variables.empty()) return;
  compare_statistics(counter, a, b, ComparedKind::sensitivity, absolute_difference,
                     [&a](const ColumnResult::Value& value) {
                       return indices_of(value, a.sensitivity_variables);
                     });
}

}  // namespace

std::uint64_t ComparedResults::compared() const {
  std::uint64_t sum = 0;
  for (const ComparedColumn& column : columns) sum += column.compared;
  return sum;
}

std::uint64_t ComparedResults::differing() const {
  std::uint64_t sum = 0;
  for (const ComparedColumn& column : columns) sum += column.differing;
  return sum;
}

ComparedResults compare_results(const ResultFile& first, const ResultFile& second, double tolerance,
                                std::size_t most) {
  const Pair files{first, second};
  const SweepResult a = first.read(), b = second.read();
  files.check_names(a.scenes, b.scenes, &SceneResult::id, "scene");
  for (const SceneResult& scene : a.scenes)
    check_scene(files, scene, named(b.scenes, scene.id, &SceneResult::id));
  Counter counter(tolerance, most);
  if (a.identity.version != b.identity.version)
    counter.note("they are of versions " + both(a.identity.version, b.identity.version));
  if (a.identity.arithmetic != b.identity.arithmetic)
    counter.note("their arithmetic differs: " + both(a.identity.arithmetic, b.identity.arithmetic));
  for (const SceneResult& scene : a.scenes)
    compare_scene(counter, files, scene, named(b.scenes, scene.id, &SceneResult::id));
  ComparedResults results = counter.take();
  if (results.compared() == 0) files.refuse("they hold no numbers");
  return results;
}

}  // namespace tribo::sweep
