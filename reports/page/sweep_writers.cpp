// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "page/sweep_tables.hpp"
#include "page/texts.hpp"

namespace tribo::report {
namespace {

using sweep::ColumnResult;
using sweep::SceneResult;
using sweep::SweepResult;

std::string csv_number(double value) { return std::isnan(value) ? "" : exact(value); }

// Appends the texts that `to` lacks.
void add_new(std::vector<std::string>& to, const std::vector<std::string>& texts) {
  for (const std::string& text : texts)
    if (std::find(to.begin(), to.end(), text) == to.end()) to.push_back(text);
}

struct CsvColumns {
  std::vector<std::string> words, variables;

  explicit CsvColumns(const SweepResult& result) {
    for (const SceneResult& scene : result.scenes) {
      add_new(variables, scene.sensitivity_variables);
      for (const ColumnResult& column : scene.columns) add_new(words, column.words);
    }
  }

  std::string head() const {
    std::string text = "scene,column,unit,speed_index,speed,count,undefined,mean,sd,least,greatest";
    for (const double level : sweep::quantile_levels)
      text += fmt::format(",quantile_{0},quantile_{0}_low,quantile_{0}_high", level);
    for (const std::string& word : words) text += csv_cells({"count_" + word});
    for (const std::string& variable : variables)
      for (const char* const kind : {"first_order", "total"})
        text += csv_cells({fmt::format("{}:{}", kind, variable),
                           fmt::format("{}_low:{}", kind, variable),
                           fmt::format("{}_high:{}", kind, variable)});
    return text + ",grid_values\n";
  }

  // `where` has the grid values. It is empty for a row over all sets of grid values.
  std::string row(const SceneResult& scene, const ColumnResult& column, std::size_t i,
                  const std::string& where) const {
    const ColumnResult::Value& value = column.values[i];
    const bool at_speed = column.values.size() > 1 && i < scene.speeds.size();
    std::string text =
        csv_text(scene.id) +
        csv_cells({column.name, column.unit, std::to_string(i),
                   at_speed ? exact(scene.speeds[i]) : "", std::to_string(value.count),
                   std::to_string(value.undefined), csv_number(value.mean), csv_number(value.sd),
                   csv_number(value.least), csv_number(value.greatest)});
    for (const double level : sweep::quantile_levels) {
      const sweep::Bounded& one = quantile(value, level);
      text += csv_cells({csv_number(one.value), csv_number(one.low), csv_number(one.high)});
    }
    const auto counts = word_counts(value, column.words.size());
    for (const std::string& word : words) {
      const auto found = std::find(column.words.begin(), column.words.end(), word);
      const auto place = static_cast<std::size_t>(found - column.words.begin());
      text += csv_cells({place < counts.size() ? std::to_string(counts[place]) : ""});
    }
    const auto& own = scene.sensitivity_variables;
    for (const std::string& variable : variables) {
      const auto place =
          static_cast<std::size_t>(std::find(own.begin(), own.end(), variable) - own.begin());
      for (const auto* const list : {&value.sensitivity.first_order, &value.sensitivity.total})
        text += place < list->size()
                    ? csv_cells({csv_number((*list)[place].value), csv_number((*list)[place].low),
                                 csv_number((*list)[place].high)})
                    : ",,,";
    }
    return text + csv_cells({where}) + '\n';
  }

 private:
  static std::string csv_cells(const std::vector<std::string>& cells) {
    std::string text;
    for (const std::string& cell : cells) text += ',' + csv_text(cell);
    return text;
  }
};

using nlohmann::ordered_json;

// Numbers that are not finite are written as null.
template <class T>
ordered_json with_ends(const T& one) {
  return {{"value", one.value}, {"low", one.low}, {"high", one.high}};
}

ordered_json histogram_json(const std::vector<sweep::QuantileSketch::Bin>& bins) {
  ordered_json edges = ordered_json::array(), counts = ordered_json::array();
  for (const auto& bin : bins) {
    edges.push_back(bin.low);
    counts.push_back(bin.count);
  }
  if (!bins.empty()) edges.push_back(bins.back().high);
  return {{"edges", edges}, {"counts", counts}};
}

ordered_json value_json(const SceneResult& scene, const ColumnResult& column, std::size_t i) {
  const ColumnResult::Value& value = column.values[i];
  ordered_json object = ordered_json::object();
  if (column.values.size() > 1 && i < scene.speeds.size()) object["speed"] = scene.speeds[i];
  object["count"] = value.count;
  object["undefined"] = value.undefined;
  if (!column.words.empty()) {
    const auto counts = word_counts(value, column.words.size());
    for (std::size_t w = 0; w < counts.size(); ++w) object["words"][column.words[w]] = counts[w];
    return object;
  }
  object["mean"] = value.mean;
  object["sd"] = value.sd;
  object["least"] = value.least;
  object["greatest"] = value.greatest;
  object["quantiles"] = ordered_json::array();
  for (std::size_t q = 0; q < value.quantiles.size(); ++q) {
    ordered_json one{{"level", sweep::quantile_levels[q]}};
    one.update(with_ends(value.quantiles[q]));
    object["quantiles"].push_back(std::move(one));
  }
  object["histogram"] = histogram_json(value.histogram);
  const sweep::SobolIndices& indices = value.sensitivity;
  if (indices.total.empty()) return object;
  object["sensitivity"] = {{"groups", indices.groups}, {"variables", ordered_json::object()}};
  for (std::size_t v = 0; v < indices.total.size(); ++v)
    object["sensitivity"]["variables"][scene.sensitivity_variables[v]] = {
        {"first_order", with_ends(indices.first_order[v])}, {"total", with_ends(indices.total[v])}};
  return object;
}

ordered_json columns_json(const SceneResult& scene, const std::vector<ColumnResult>& columns) {
  ordered_json list = ordered_json::array();
  for (const ColumnResult& column : columns) {
    ordered_json one{
        {"name", column.name}, {"unit", column.unit}, {"values", ordered_json::array()}};
    for (std::size_t i = 0; i < column.values.size(); ++i)
      one["values"].push_back(value_json(scene, column, i));
    list.push_back(std::move(one));
  }
  return list;
}

ordered_json scene_json(const SceneResult& scene, const SweepCells& cells) {
  ordered_json object{{"id", scene.id},
                      {"file", scene.file},
                      {"design", scene.design},
                      {"seed", scene.seed},
                      {"draws", scene.draws},
                      {"cases", scene.cases},
                      {"points", scene.points},
                      {"inputs", ordered_json::array()},
                      {"columns", columns_json(scene, scene.columns)},
                      {"cells", ordered_json::array()}};
  for (const sweep::InputResult& input : scene.inputs)
    object["inputs"].push_back({{"path", input.path},
                                {"unit", input.unit},
                                {"meaning", input.meaning},
                                {"varies", input.varies}});
  for (const SweepCell& cell : cells.cells)
    object["cells"].push_back(
        {{"values", cell.where}, {"columns", columns_json(scene, cell.columns)}});
  return object;
}

}  // namespace

const sweep::Bounded& quantile(const ColumnResult::Value& value, double level) {
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  static constexpr sweep::Bounded none{nan, nan, nan};
  const auto found = std::find(sweep::quantile_levels.begin(), sweep::quantile_levels.end(), level);
  const auto place = static_cast<std::size_t>(found - sweep::quantile_levels.begin());
  return place < value.quantiles.size() ? value.quantiles[place] : none;
}

// A column stores a word as its place, 0 to 3. The count of place 0 is that of the histogram's bin
// of 0. The other three counts follow from the number of cases, their sum and their sum of squares.
std::vector<std::uint64_t> word_counts(const ColumnResult::Value& value, std::size_t words) {
  std::uint64_t zeros = 0;
  for (const auto& bin : value.histogram)
    if (bin.high < 0.5) zeros += bin.count;
  const std::uint64_t others = value.count - std::min(value.count, zeros);
  const auto n = static_cast<double>(value.count), rest = static_cast<double>(others);
  const double sum = value.count > 0 ? n * value.mean : 0;
  const double squares =
      sum * (value.count > 0 ? value.mean : 0) +
      (value.count > 1 ? value.sd * value.sd * static_cast<double>(value.count - 1) : 0);
  const auto whole = [](double x) {
    return static_cast<std::uint64_t>(std::llround(std::max(x, 0.0)));
  };
  const std::uint64_t threes = whole((squares - 3 * sum + 2 * rest) / 2);
  const std::uint64_t twos = whole(sum - rest - 2 * static_cast<double>(threes));
  std::vector<std::uint64_t> counts{zeros, others - std::min(others, twos + threes), twos, threes};
  counts.resize(words);
  return counts;
}

std::string sweep_csv(const SweepResult& result, const std::vector<SweepCells>& cells) {
  const CsvColumns columns(result);
  std::string text = columns.head();
  for (std::size_t s = 0; s < result.scenes.size(); ++s) {
    const SceneResult& scene = result.scenes[s];
    const auto add_rows = [&](const std::vector<ColumnResult>& all, const std::string& where) {
      for (const ColumnResult& column : all)
        for (std::size_t i = 0; i < column.values.size(); ++i)
          text += columns.row(scene, column, i, where);
    };
    add_rows(scene.columns, "");
    for (const SweepCell& cell : cells[s].cells) add_rows(cell.columns, cell.where);
  }
  return text;
}

nlohmann::ordered_json sweep_json(const SweepResult& result, const std::vector<SweepCells>& cells) {
  ordered_json object{{"tribocheck_version", result.identity.version},
                      {"sweep_digest", result.identity.digest},
                      {"arithmetic", result.identity.arithmetic},
                      {"scenes", ordered_json::array()}};
  for (std::size_t s = 0; s < result.scenes.size(); ++s)
    object["scenes"].push_back(scene_json(result.scenes[s], cells[s]));
  return object;
}

}  // namespace tribo::report
