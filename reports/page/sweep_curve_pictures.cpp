// SPDX-License-Identifier: Apache-2.0
// Pictures over speed: bands and the map of the film.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <stdexcept>

#include "page/number_text.hpp"
#include "page/sweep_picture_parts.hpp"
#include "page/sweep_values.hpp"

namespace tribo::report {
namespace {

using namespace sweep_picture;
using sweep::ColumnResult;
using sweep::SceneResult;

constexpr double log_from_ratio = 20;

class Extremes {
 public:
  void take(double value) {
    if (!std::isfinite(value)) return;
    least_ = std::min(least_, value);
    greatest_ = std::max(greatest_, value);
  }
  bool empty() const { return greatest_ < least_; }
  bool is_wide() const { return least_ > 0 && greatest_ > log_from_ratio * least_; }
  double least() const { return least_; }
  double greatest() const { return greatest_; }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  double least_ = infinity, greatest_ = -infinity;
};

bool is_band(const SceneResult& scene, const ColumnResult& column) {
  return scene.design != "factorial" && column.words.empty() && column.values.size() > 1 &&
         column.values.size() == scene.speeds.size();
}

// A linear axis that holds all of it, from 0 where that is not far.
Range linear_range(const Extremes& extremes) {
  const double low =
      extremes.least() >= 0 && extremes.least() < extremes.greatest() / 2 ? 0 : extremes.least();
  const double room = 0.04 * (extremes.greatest() - low);
  return {low == 0 ? 0 : low - room, extremes.greatest() + (room > 0 ? room : 1)};
}

std::string axis_label(std::string_view words, const std::string& unit) {
  return unit.empty() ? fmt::format("{} (–)", words) : fmt::format("{} ({})", words, unit);
}

}  // namespace

std::optional<SweepPicture> curve_band(const sweep::SweepResult& result, std::string_view column) {
  const std::vector<std::uint32_t> colour = colours(result);
  Extremes speeds, values;
  std::string scenes, curves;
  ReadableUnit unit{"", 1};
  for (const SceneResult& scene : result.scenes)
    if (const ColumnResult* const found = scene.column(column); found && is_band(scene, *found))
      if (const ReadableUnit own = readable_unit(*found);
          unit.name.empty() || own.factor < unit.factor)
        unit = own;
  std::size_t count = 0;
  for (std::size_t s = 0; s < result.scenes.size(); ++s) {
    const SceneResult& scene = result.scenes[s];
    const ColumnResult* const found = scene.column(column);
    if (found == nullptr || !is_band(scene, *found)) continue;
    ++count;
    scenes += fmt::format("{}\t{}\t{}\n", count, cell(scene.id, 24), colour[s]);
    curves += "\n\n# speed\tquantile_0.025\tquantile_0.5\tquantile_0.975\n";
    for (std::size_t i = 0; i < scene.speeds.size(); ++i) {
      const ColumnResult::Value& value = found->values[i];
      speeds.take(scene.speeds[i]);
      curves += exact(scene.speeds[i]);
      for (const double level : {0.025, 0.5, 0.975}) {
        // Where most cases have no value, the quantiles of the rest do not describe the scene.
        const bool is_of_few = value.undefined > value.count;
        const double at = is_of_few ? std::nan("") : unit.factor * quantile(value, level).value;
        values.take(at);
        curves += '\t' + exact(at);
      }
      curves += '\n';
    }
  }
  if (count == 0 || values.empty()) return std::nullopt;
  const bool is_log = values.is_wide();
  const Range range =
      is_log ? with_room({values.least(), values.greatest()}, 0.03) : linear_range(values);
  std::string stem = fmt::format("curve_band_{}", column);
  std::replace(stem.begin(), stem.end(), '.', '_');
  const std::string words = column_words(column);
  return make(
      stem, "sweep_curve_band.gp", with_capital(words + " over speed"),
      "Lines: medians of the cases; bands: 95 % of them at each speed. Where most cases have "
      "no value, as friction without a film, there is neither.",
      with_capital(words + " against speed: a line and a band for each scene."),
      "lines: medians; bands: 95 % of the cases at each speed", 640,
      fmt::format("# low\thigh\tbottom\ttop\tlog\tlabel\n{}\t{}\t{}\t{}\t{}\t{}\n\n\n"
                  "# number\tscene\tcolour\n{}{}",
                  speeds.least(), speeds.greatest(), range.low, range.high, is_log ? 1 : 0,
                  axis_label(words, unit.name), scenes, curves));
}

namespace {

// So many polygons are still an SVG that opens.
constexpr std::size_t most_columns = 120, most_rows = 90;

std::vector<std::size_t> thinned(std::size_t count, std::size_t most) {
  std::vector<std::size_t> places;
  const std::size_t some = std::min(count, most);
  for (std::size_t i = 0; i < some; ++i) places.push_back(i * (count - 1) / (some - 1));
  return places;
}

// The speed where the parabola through the greatest value and its neighbours is highest, all in
// logarithms. NaN if the greatest value is at an end; if a neighbour has no film, the speed of the
// greatest value itself.
double speed_of_greatest(std::span<const double> speeds, std::span<const double> films) {
  const auto at =
      static_cast<std::size_t>(std::max_element(films.begin(), films.end()) - films.begin());
  if (at == 0 || at + 1 >= films.size()) return std::nan("");
  const double before = std::log(speeds[at - 1] / speeds[at]);
  const double after = std::log(speeds[at + 1] / speeds[at]);
  const double fall_before = std::log(films[at - 1] / films[at]) / before;
  const double fall_after = std::log(films[at + 1] / films[at]) / after;
  const double curvature = (fall_after - fall_before) / (after - before);
  if (!std::isfinite(curvature) || curvature >= 0) return speeds[at];
  const double slope = fall_before - curvature * before;
  return speeds[at] * std::exp(std::clamp(-slope / (2 * curvature), before, after));
}

// The film of a grid of one field, in ascending order of the field.
struct FilmGrid {
  std::vector<double> field;
  std::vector<std::vector<double>> films;
};

// Empty where the scene is not such a grid.
FilmGrid read_grid(const SceneResult& scene, const std::string& path) {
  const ColumnResult* const film = scene.column("film");
  if (scene.design != "factorial" || !scene.has_points || scene.inputs.size() != 1 ||
      !scene.inputs.front().words.empty() || film == nullptr || film->values.size() < 3 ||
      film->values.size() != scene.speeds.size())
    return {};
  const std::vector<double> field = sweep::read_input(path, scene.id, scene.inputs.front().path);
  const std::vector<double> films = sweep::read_column(path, scene.id, film->name);
  const std::size_t speeds = scene.speeds.size();
  if (films.size() != field.size() * speeds) throw std::runtime_error(path + " has a torn film");
  std::vector<std::size_t> order(field.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return field[a] < field[b]; });
  FilmGrid grid;
  for (const std::size_t i : order) {
    grid.field.push_back(field[i]);
    const auto first = films.begin() + static_cast<std::ptrdiff_t>(i * speeds);
    grid.films.emplace_back(first, first + static_cast<std::ptrdiff_t>(speeds));
  }
  return grid;
}

ReadableUnit unit_of_field(const sweep::InputResult& input, const FilmGrid& grid) {
  ColumnResult as_column{input.path, input.unit, {}, {}};
  as_column.values.resize(1);
  as_column.values.front().least = grid.field.front();
  as_column.values.front().greatest = grid.field.back();
  return readable_unit(as_column);
}

}  // namespace

std::optional<SweepPicture> film_map(const SceneResult& scene, const std::string& path) {
  const FilmGrid grid = read_grid(scene, path);
  if (grid.field.size() < 3 || !(grid.field.front() < grid.field.back())) return std::nullopt;
  const sweep::InputResult& input = scene.inputs.front();
  const ReadableUnit unit = unit_of_field(input, grid);

  constexpr double nanometres = 1e9;
  Extremes shown;
  std::string map, ridge;
  bool has_gaps = false, has_ridge = false;
  for (const std::size_t i : thinned(grid.field.size(), most_rows)) {
    const double field = unit.factor * grid.field[i];
    for (const std::size_t j : thinned(scene.speeds.size(), most_columns)) {
      // A film of 0 has collapsed: a hole in the map, as on any logarithmic scale.
      const double film = grid.films[i][j];
      has_gaps = has_gaps || !(film > 0);
      const double here = film > 0 ? nanometres * film : std::nan("");
      shown.take(here);
      map += fmt::format("{}\t{}\t{}\n", exact(scene.speeds[j]), exact(field), exact(here));
    }
    map += '\n';
    const double speed = speed_of_greatest(scene.speeds, grid.films[i]);
    has_ridge = has_ridge || !std::isnan(speed);
    ridge += fmt::format("{}\t{}\n", exact(speed), exact(field));
  }
  if (shown.empty() || !(shown.least() < shown.greatest())) return std::nullopt;
  const double low = unit.factor * grid.field.front(), high = unit.factor * grid.field.back();
  const std::string words = in_words(input.path.substr(input.path.rfind('.') + 1));
  return make(
      "film_map", "sweep_film_map.gp", fmt::format("Film over speed and {}", words),
      "Colours and contour lines: the film; the orange line: the greatest film of each "
      "value, where starvation sets in; white: the film has collapsed.",
      fmt::format("A map of the film over speed and {}, with contour lines.", words),
      fmt::format("{}: {} × {} points{}{}", plain_words(cell(scene.id)), scene.speeds.size(),
                  grid.field.size(), has_ridge ? "; orange: the greatest film" : "",
                  has_gaps ? "; white: it has collapsed" : ""),
      720,
      fmt::format("# low\thigh\tbottom\ttop\tlog\tleast\tgreatest\tlabel\n"
                  "{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\n\n\n# speed\tfield\tfilm_nm\n{}\n"
                  "# speed\tfield, of the greatest film\n{}",
                  scene.speeds.front(), scene.speeds.back(), low, high,
                  low > 0 && high > 3 * low ? 1 : 0, shown.least(), shown.greatest(),
                  axis_label(words, unit.name), map, ridge));
}

}  // namespace tribo::report
