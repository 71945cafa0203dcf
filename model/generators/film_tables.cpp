// SPDX-License-Identifier: Apache-2.0
// Makes the tables of tribo/solved_films.hpp and solved_inlet.hpp from the rows of reference/ehl,
// at each build:
// `film_tables line_films.csv line_films_between.csv point_films.csv film_tables.inc`.
//
// Between the rows it interpolates ln(solved/formula). The formula is that of all regimes: Moes'
// for lines, Nijenbanning, Venner and Moes' for circles, in the reading that is nearer to the
// solved films. The pieces are bicubic over ln M and ln(1 + L); their slopes at the rows are those
// of cubic splines (not-a-knot) along the rows of one L and of one M. A piece exists where the rows
// at its four corners exist. Pieces over L or over its root, flatter slopes, and pieces without the
// formula were each further from films solved between the rows.
//
// Each row of a starved film gives the ln γ for which Damiens' formula has this film. Between the
// rows ln γ is a cubic spline along ln r, along ln(1 + L) and along ln M, for the M that have rows
// of all r and L.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tribo/moes_film.hpp"

namespace {

using Row = std::map<std::string, std::string>;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
  return fields;
}

std::vector<Row> rows_of(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::string> names;
  std::vector<Row> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    const std::vector<std::string> fields = fields_of(line);
    if (names.empty()) {
      names = fields;
      continue;
    }
    Row& row = rows.emplace_back();
    for (std::size_t i = 0; i < std::min(fields.size(), names.size()); ++i)
      row[names[i]] = fields[i];
  }
  if (rows.empty()) throw std::runtime_error(path + " has no rows");
  return rows;
}

// The slopes at the knots x of a cubic spline through y: not-a-knot; of three knots a parabola, of
// two a line.
std::vector<double> spline_slopes(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size();
  if (n == 1) return {0};
  std::vector<double> h(n - 1), d(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    h[i] = x[i + 1] - x[i];
    d[i] = (y[i + 1] - y[i]) / h[i];
  }
  if (n == 2) return {d[0], d[0]};
  if (n == 3) {
    const double bend = (d[1] - d[0]) / (h[0] + h[1]);
    return {d[0] - bend * h[0], d[0] + bend * h[0], d[1] + bend * h[1]};
  }
  // Rows of equations for the slopes, by Gauss' elimination with pivots
  std::vector<std::vector<double>> a(n, std::vector<double>(n + 1));
  const auto end = [&](std::size_t row, std::size_t i0, std::size_t i1, std::size_t i2, double h0,
                       double h1, double d0, double d1) {
    // the third derivatives of the two pieces next to the end are equal
    a[row][i0] = h1 * h1;
    a[row][i1] = h1 * h1 - h0 * h0;
    a[row][i2] = -h0 * h0;
    a[row][n] = 2 * (h1 * h1 * d0 - h0 * h0 * d1);
  };
  end(0, 0, 1, 2, h[0], h[1], d[0], d[1]);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    a[i][i - 1] = h[i];
    a[i][i] = 2 * (h[i - 1] + h[i]);
    a[i][i + 1] = h[i - 1];
    a[i][n] = 3 * (h[i] * d[i - 1] + h[i - 1] * d[i]);
  }
  end(n - 1, n - 1, n - 2, n - 3, h[n - 2], h[n - 3], d[n - 2], d[n - 3]);
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (std::fabs(a[i][k]) > std::fabs(a[pivot][k])) pivot = i;
    std::swap(a[k], a[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const double factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j <= n; ++j) a[i][j] -= factor * a[k][j];
    }
  }
  std::vector<double> slopes(n);
  for (std::size_t k = 0; k < n; ++k) slopes[k] = a[k][n] / a[k][k];
  return slopes;
}

// The slopes of y along x, of each run of neighbours that are numbers; NaN elsewhere.
std::vector<double> slopes_of(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> slopes(x.size(), none);
  for (std::size_t first = 0; first < x.size();) {
    std::size_t end = first;
    while (end < x.size() && !std::isnan(y[end])) ++end;
    if (end > first) {
      const auto at = [&](const std::vector<double>& all) {
        return std::vector<double>(all.begin() + static_cast<std::ptrdiff_t>(first),
                                   all.begin() + static_cast<std::ptrdiff_t>(end));
      };
      const std::vector<double> run = spline_slopes(at(x), at(y));
      std::copy(run.begin(), run.end(), slopes.begin() + static_cast<std::ptrdiff_t>(first));
    }
    first = std::max(end, first + 1);
  }
  return slopes;
}

// f and its derivatives by x = ln M and y, and by both.
struct Node {
  double value, by_x, by_y, by_both;
};

// ln(solved/formula) on the grid of the rows, and between.
class Rows {
 public:
  // `formula`: the law by which the films are divided; for points at R_x/R_y = 1.
  Rows(tribo::FilmForm formula, std::map<std::pair<double, double>, double> films)
      : formula_(formula) {
    std::set<double> loads, materials;
    for (const auto& [key, film] : films) {
      loads.insert(key.first);
      materials.insert(key.second);
    }
    for (const double m : loads) x_.push_back(std::log(m));
    for (const double l : materials) y_.push_back(std::log1p(l));
    value_.assign(x_.size(), std::vector<double>(y_.size(), none));
    std::size_t i = 0;
    for (const double m : loads) {
      std::size_t j = 0;
      for (const double l : materials) {
        if (const auto found = films.find({m, l}); found != films.end())
          value_[i][j] = std::log(found->second) - formula_at(x_[i], l).value;
        ++j;
      }
      ++i;
    }
    by_y_ = along_y(value_);
    by_x_ = along_x(value_);
    by_both_ = along_y(by_x_);
  }

  double first_x() const { return x_.front(); }
  double last_x() const { return x_.back(); }
  double last_material() const { return std::expm1(y_.back()); }

  // ln Ĥ and its derivatives, where y is L; NaN where rows are missing.
  Node at(double x, double material) const {
    const Node formula = formula_at(x, material), rest = piece_at(x, std::log1p(material));
    return {formula.value + rest.value, formula.by_x + rest.by_x,
            formula.by_y + rest.by_y / (1 + material),
            formula.by_both + rest.by_both / (1 + material)};
  }

 private:
  using Grid = std::vector<std::vector<double>>;

  Grid along_y(const Grid& f) const {
    Grid slopes;
    for (const auto& column : f) slopes.push_back(slopes_of(y_, column));
    return slopes;
  }
  Grid along_x(const Grid& f) const {
    Grid slopes(x_.size(), std::vector<double>(y_.size()));
    for (std::size_t j = 0; j < y_.size(); ++j) {
      std::vector<double> line;
      for (const auto& column : f) line.push_back(column[j]);
      const std::vector<double> found = slopes_of(x_, line);
      for (std::size_t i = 0; i < x_.size(); ++i) slopes[i][j] = found[i];
    }
    return slopes;
  }

  // ln Ĥ of the formula; y is L. At L = 0, where the slope rises as L^{1/8}, that of L = 0.1.
  Node formula_at(double x, double y) const {
    const auto at = [&](double log_load, double material) {
      return tribo::film_number<double>(formula_, std::exp(log_load), material, 1.0);
    };
    const auto here = at(x, y > 0 ? y : 1e-30);
    constexpr double step = 1e-4, beside = 0.1;
    const double material = y > 0 ? y : beside;
    const double bend =
        (at(x + step, material).material_slope - at(x - step, material).material_slope) /
        (2 * step);
    return {std::log(here.value), here.load_slope, at(x, material).material_slope / material,
            bend / material};
  }

  Node piece_at(double x, double y) const {
    const auto place = [](const std::vector<double>& at, double t) {
      const auto next = std::upper_bound(at.begin(), at.end(), t);
      const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(next - at.begin() - 1, 0));
      return std::min(i, at.size() - 2);
    };
    const std::size_t i = place(x_, x), j = place(y_, y);
    const double dx = x_[i + 1] - x_[i], dy = y_[j + 1] - y_[j];
    const tribo::detail::CubicWeights<double> along((x - x_[i]) / dx), across((y - y_[j]) / dy);
    double value[2], slope[2], value_y[2], slope_y[2];
    for (std::size_t side = 0; side < 2; ++side) {
      const auto two = [&](const Grid& f) { return std::pair(f[i + side][j], f[i + side][j + 1]); };
      const auto [v0, v1] = two(value_);
      const auto [y0, y1] = two(by_y_);
      const auto [x0, x1] = two(by_x_);
      const auto [b0, b1] = two(by_both_);
      value[side] = across.value(v0, dy * y0, v1, dy * y1);
      value_y[side] = across.slope(v0, dy * y0, v1, dy * y1) / dy;
      slope[side] = dx * across.value(x0, dy * b0, x1, dy * b1);
      slope_y[side] = dx * across.slope(x0, dy * b0, x1, dy * b1) / dy;
    }
    return {along.value(value[0], slope[0], value[1], slope[1]),
            along.slope(value[0], slope[0], value[1], slope[1]) / dx,
            along.value(value_y[0], slope_y[0], value_y[1], slope_y[1]),
            along.slope(value_y[0], slope_y[0], value_y[1], slope_y[1]) / dx};
  }

  tribo::FilmForm formula_;
  std::vector<double> x_, y_;
  Grid value_, by_x_, by_y_, by_both_;
};

void write_table(std::ostream& to, const char* name, const Rows& rows, std::size_t load_steps,
                 std::size_t material_steps) {
  const double load_step = (rows.last_x() - rows.first_x()) / static_cast<double>(load_steps);
  const double material_step = rows.last_material() / static_cast<double>(material_steps);
  to << "alignas(64) constexpr double " << name << "_nodes[][4] = {\n";
  char text[200];
  for (std::size_t i = 0; i <= load_steps; ++i)
    for (std::size_t j = 0; j <= material_steps; ++j) {
      // The last node is at the last row, to the bit.
      const double x =
          i == load_steps ? rows.last_x() : rows.first_x() + load_step * static_cast<double>(i);
      const Node node = rows.at(x, material_step * static_cast<double>(j));
      if (std::isnan(node.value + node.by_x + node.by_y + node.by_both)) {
        to << "{no_film, no_film, no_film, no_film},\n";
        continue;
      }
      std::snprintf(text, sizeof text, "{%a, %a, %a, %a},\n", node.value, node.by_x * load_step,
                    node.by_y * material_step, node.by_both * load_step * material_step);
      to << text;
    }
  std::snprintf(text, sizeof text, "constexpr FilmTable %s{%a, %a, %a, %zu, %zu, %s_nodes};\n",
                name, rows.first_x(), load_step, material_step, load_steps, material_steps, name);
  to << "};\n" << text;
}

// Ĥ by M and L. add() takes it from flooded rows of lines or circles with M from least_load on.
using Films = std::map<std::pair<double, double>, double>;
void add(Films& films, const std::vector<Row>& rows, const std::string& film, double least_load) {
  for (const Row& row : rows) {
    const auto text = [&](const std::string& name) {
      const auto found = row.find(name);
      return found == row.end() ? std::string() : found->second;
    };
    const bool is_circle = text("radius_ratio").empty() || std::stod(text("radius_ratio")) == 1;
    if (!is_circle || !text("supply").empty() || text("role") == "check" || text(film).empty())
      continue;
    const double load = std::stod(text("load_number"));
    if (load >= least_load)
      films[{load, std::stod(text("material_number"))}] = std::stod(text(film));
  }
}

// Takes out the L that at most half of the M have: flooded films that belong to starved ones.
void keep_whole_columns(Films& films) {
  std::map<double, std::size_t> loads;
  std::set<double> all_loads;
  for (const auto& [at, film] : films) {
    ++loads[at.second];
    all_loads.insert(at.first);
  }
  std::erase_if(films,
                [&](const auto& one) { return 2 * loads[one.first.second] <= all_loads.size(); });
}

// The ln γ at which (1 + r^γ)^{−1/γ} is y.
double log_exponent(double r, double y) {
  const double greatest = std::fmin(1, 1 / r);
  if (!(y < greatest)) throw std::runtime_error("a starved film is not thinner than its limits");
  double low = std::log(0.1), high = std::log(100.);
  for (int i = 0; i < 80; ++i) {
    const double middle = (low + high) / 2, exponent = std::exp(middle);
    const double found = std::exp(-std::log1p(std::pow(r, exponent)) / exponent);
    (found < y ? low : high) = middle;
  }
  return (low + high) / 2;
}

// A cubic spline through y over x (spline_slopes), at t within.
double spline_at(const std::vector<double>& x, const std::vector<double>& y, double t) {
  const std::vector<double> slopes = spline_slopes(x, y);
  const auto next = std::upper_bound(x.begin(), x.end(), t);
  const auto i = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(next - x.begin() - 1, 0, std::ssize(x) - 2));
  const double h = x[i + 1] - x[i];
  return tribo::detail::CubicWeights<double>((t - x[i]) / h)
      .value(y[i], h * slopes[i], y[i + 1], h * slopes[i + 1]);
}

// γ of the starved rows, by M, L and ln r.
class InletRows {
 public:
  explicit InletRows(const std::vector<Row>& rows) {
    std::map<std::pair<double, double>, double> flooded;
    std::map<std::pair<double, double>, std::map<double, double>> starved;  // films by ln r
    const auto at = [](const Row& row, const char* name) {
      const auto found = row.find(name);
      return found == row.end() || found->second.empty() ? none : std::stod(found->second);
    };
    for (const Row& row : rows) {
      const double supply = at(row, "supply"), film = at(row, "central");
      const std::pair key{at(row, "load_number"), at(row, "material_number")};
      if (at(row, "radius_ratio") != 1 || std::isnan(film)) continue;
      if (std::isnan(supply))
        flooded[key] = film;
      else
        starved[key][-std::log(supply)] = film;
    }
    // Load numbers whose material numbers and ratios are all there
    std::map<double, std::size_t> count;
    std::set<double> materials;
    std::size_t most = 0;
    for (auto& [key, films] : starved) {
      materials.insert(key.second);
      most = std::max(most, count[key.first] += films.size());
    }
    for (const double l : materials) material_.push_back(std::log1p(l));
    for (const auto& [m, films] : count)
      if (films == most) load_.push_back(std::log(m));
    for (const auto& [m, films] : count) {
      if (films != most) continue;
      auto& plane = exponent_.emplace_back();
      for (const double l : materials) {
        auto& line = plane.emplace_back();
        ratio_.clear();
        for (const auto& [log_r, film] : starved.at({m, l})) {
          ratio_.push_back(log_r);
          line.push_back(log_exponent(std::exp(log_r), film / flooded.at({m, l})));
        }
      }
    }
  }

  double first_load() const { return load_.front(); }
  double last_load() const { return load_.back(); }
  double first_material() const { return std::expm1(material_.front()); }
  double last_material() const { return std::expm1(material_.back()); }
  double first_ratio() const { return ratio_.front(); }
  double last_ratio() const { return ratio_.back(); }

  double at(double log_load, double material, double log_ratio) const {
    std::vector<double> by_load;
    for (const auto& plane : exponent_) {
      std::vector<double> by_material;
      for (const auto& line : plane) by_material.push_back(spline_at(ratio_, line, log_ratio));
      by_load.push_back(spline_at(material_, by_material, std::log1p(material)));
    }
    return std::exp(spline_at(load_, by_load, log_load));
  }

 private:
  std::vector<double> load_, material_, ratio_;             // ln M, ln(1 + L) and ln r
  std::vector<std::vector<std::vector<double>>> exponent_;  // ln γ
};

void write_inlet_table(std::ostream& to, const InletRows& rows) {
  // With these steps the linear pieces lie within 5e-4 of the rows (ehl.SolvedInlet).
  constexpr std::size_t loads = 16, materials = 20, ratios = 40;
  const auto step = [](double first, double last, std::size_t steps) {
    return (last - first) / static_cast<double>(steps);
  };
  const double by_load = step(rows.first_load(), rows.last_load(), loads),
               by_material = step(rows.first_material(), rows.last_material(), materials),
               by_ratio = step(rows.first_ratio(), rows.last_ratio(), ratios);
  const auto node = [&](std::size_t i, std::size_t j, std::size_t k) {
    return rows.at(rows.first_load() + by_load * static_cast<double>(i),
                   rows.first_material() + by_material * static_cast<double>(j),
                   rows.first_ratio() + by_ratio * static_cast<double>(k));
  };
  char text[300];
  to << "alignas(64) constexpr double inlet_nodes[][4] = {\n";
  for (std::size_t i = 0; i <= loads; ++i)
    for (std::size_t j = 0; j < materials; ++j)
      for (std::size_t k = 0; k < ratios; ++k) {
        std::snprintf(text, sizeof text, "{%a, %a, %a, %a},\n", node(i, j, k), node(i, j, k + 1),
                      node(i, j + 1, k), node(i, j + 1, k + 1));
        to << text;
      }
  std::snprintf(text, sizeof text,
                "constexpr InletTable inlet_exponents{%a, %a, %a, %a, %a, %a, %zu, %zu, %zu, "
                "inlet_nodes};\n",
                rows.first_load(), by_load, rows.first_material(), by_material, rows.first_ratio(),
                by_ratio, loads, materials, ratios);
  to << "};\n" << text;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 5) throw std::runtime_error("film_tables takes three tables and a file to write");
  const auto lines = rows_of(argv[1]), between = rows_of(argv[2]), points = rows_of(argv[3]);
  std::ofstream to(argv[4]);
  to << "// Made by model/generators/film_tables.cpp of the rows of reference/ehl.\n";
  for (const std::string film : {"central", "minimum"}) {
    // Below these M a central film in a liquid of high L rises with M, and falls with γ: load
    // sharing would have several roots.
    Films of_lines, of_points;
    add(of_lines, lines, film, 2.25);
    add(of_lines, between, film, 2.25);
    add(of_points, points, film, 10);
    keep_whole_columns(of_points);
    const Rows line_rows(tribo::FilmForm::moes_line, of_lines);
    const Rows point_rows(tribo::FilmForm::nijenbanning_venner_moes, of_points);
    write_table(to, ("line_" + film).c_str(), line_rows, 48, 40);
    write_table(to, ("point_" + film).c_str(), point_rows, 48, 30);
  }
  write_inlet_table(to, InletRows(points));
  to.close();
  if (!to) throw std::runtime_error(std::string(argv[4]) + " cannot be written");
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
