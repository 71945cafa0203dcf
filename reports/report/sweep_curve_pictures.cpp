// SPDX-License-Identifier: Apache-2.0
// Pictures over speed: bands and the map of the film.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>

#include "report/number_text.hpp"
#include "report/sweep_picture_parts.hpp"
#include "report/sweep_values.hpp"

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
        const double at = unit.factor * quantile(value, level).value;
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
  const std::string words = in_words(column);
  return make(stem, "sweep_curve_band.gp", fmt::format("{} over speed", words),
              "Lines: medians of the cases; bands: 95 % of them at each speed.",
              fmt::format("{} against speed: a line and a band for each scene.", words),
              "lines: medians; bands: 95 % of the cases at each speed", 640,
              fmt::format("# low\thigh\tbottom\ttop\tlog\tlabel\n{}\t{}\t{}\t{}\t{}\t{}\n\n\n"
                          "# number\tscene\tcolour\n{}{}",
                          speeds.least(), speeds.greatest(), range.low, range.high, is_log ? 1 : 0,
                          axis_label(words, unit.name), scenes, curves));
}

std::optional<SweepPicture> film_map(const SceneResult& scene, const std::string& path) {
  const ColumnResult* const film = scene.column("film");
  if (scene.design != "factorial" || !scene.has_points || scene.inputs.size() != 1 ||
      !scene.inputs.front().words.empty() || film == nullptr || film->values.size() < 3 ||
      film->values.size() != scene.speeds.size())
    return std::nullopt;
  const sweep::InputResult& input = scene.inputs.front();
  const std::vector<double> field = sweep::read_input(path, scene.id, input.path);
  const std::vector<double> films = sweep::read_column(path, scene.id, film->name);
  const std::size_t speeds = scene.speeds.size();
  if (films.size() != field.size() * speeds) throw std::runtime_error(path + " has a torn film");
  std::vector<std::size_t> order(field.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return field[a] < field[b]; });
  if (order.size() < 3 || field[order.front()] == field[order.back()]) return std::nullopt;

  constexpr double nanometres = 1e9;
  Extremes fields, shown;
  std::string map, ridge;
  for (const std::size_t i : order) {
    const auto row = std::span(films).subspan(i * speeds, speeds);
    fields.take(field[i]);
    for (std::size_t j = 0; j < speeds; ++j) {
      // A film of 0 has collapsed: a hole in the map, as in any on a logarithmic scale.
      const double here = row[j] > 0 ? nanometres * row[j] : std::nan("");
      shown.take(here);
      map += fmt::format("{}\t{}\t{}\n", exact(scene.speeds[j]), exact(field[i]), exact(here));
    }
    map += '\n';
    const auto greatest = static_cast<std::size_t>(
        std::max_element(row.begin(), row.end(),
                         [](double a, double b) { return std::isnan(a) || a < b; }) -
        row.begin());
    if (greatest > 0 && greatest + 1 < speeds)
      ridge += fmt::format("{}\t{}\n", exact(scene.speeds[greatest]), exact(field[i]));
  }
  if (shown.empty()) return std::nullopt;
  const bool is_log = fields.least() > 0 && fields.greatest() > 3 * fields.least();
  const std::string words = in_words(input.path.substr(input.path.rfind('.') + 1));
  const bool has_ridge = !ridge.empty();
  return make("film_map", "sweep_film_map.gp", fmt::format("Film over speed and {}", words),
              "Colours and contour lines: the film; the orange line: the greatest film of each "
              "value, where starvation sets in.",
              fmt::format("A map of the film over speed and {}, with contour lines.", words),
              fmt::format("{}: {} × {} points", plain_words(cell(scene.id)), speeds, field.size()),
              720,
              fmt::format("# low\thigh\tbottom\ttop\tlog\tleast\tgreatest\thas_ridge\tlabel\n"
                          "{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\n\n\n# speed\tfield\tfilm_nm\n{}\n"
                          "# speed\tfield, of the greatest film\n{}",
                          scene.speeds.front(), scene.speeds.back(), fields.least(),
                          fields.greatest(), is_log ? 1 : 0, shown.least(), shown.greatest(),
                          has_ridge ? 1 : 0, axis_label(words, input.unit), map,
                          has_ridge ? ridge : std::string("NaN\tNaN\n")));
}

}  // namespace tribo::report
