// SPDX-License-Identifier: Apache-2.0
// Makes reference/ehl/point_films_second_method.csv: contacts of point_films.csv solved by finite
// elements (point_elements.hpp), in some four minutes of one core. Rows that the file has are kept.
// A contact that is not solved is left out, and named on stderr.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <initializer_list>
#include <iostream>
#include <string>
#include <vector>

#include "generators/film_table.hpp"
#include "generators/point_elements.hpp"

namespace {

constexpr const char* header =
    "# quantity: films of smooth circular and elliptical contacts, solved by finite elements\n"
    "# definition: central and minimum are (h/R_x)(2U)^(-1/2) at x = y = 0 and where h is least; "
    "the other columns are those of point_films.csv\n"
    "# equations: those of point_films.csv\n"
    "# assumptions: isothermal, Newtonian, Barus, incompressible, smooth, fully flooded\n"
    "# units: none; each ..._error is absolute, in the unit of its number\n"
    "# generator: reference/generators/point_second.cpp\n"
    "# method: bilinear elements with upwind test functions, a penalty on suction "
    "(point_elements.hpp); "
    "Richardson's value of three meshes\n"
    "# error: twice what Richardson's value changed by, an eighth (minimum: half) of what it adds, "
    "and a quarter "
    "of "
    "what meshes of twice the reach change\n";
constexpr const char* columns =
    "radius_ratio,supply,load_number,material_number,central,central_error,minimum,minimum_error,"
    "nodes,seconds\n";

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: generate_point_films_second_method FILE\n";
    return 2;
  }
  std::string rows;
  const auto add = [&](const std::string& row) {
    rows += row + "\n";
    tribo::reference::write_whole(argv[1], header + tribo::reference::dated(rows) + columns + rows);
  };
  const std::vector<std::string> known = tribo::reference::committed_rows(argv[1], "radius_ratio");
  for (const auto& [ratio, m, l] : std::initializer_list<std::array<double, 3>>{{1, 20, 5},
                                                                                {1, 20, 2.5},
                                                                                {1, 50, 5},
                                                                                {1, 50, 2.5},
                                                                                {1, 100, 5},
                                                                                {1, 20, 0},
                                                                                {1, 100, 2.5},
                                                                                {1, 10, 5},
                                                                                {1, 10, 2.5},
                                                                                {2, 20, 5},
                                                                                {4, 20, 5},
                                                                                {8, 20, 5}}) {
    const std::string key = fmt::format("{},,{},{}", ratio, m, l);
    const auto same = std::ranges::find_if(
        known, [&](const std::string& row) { return row.starts_with(key + ","); });
    if (same != known.end()) {
      add(*same);
      continue;
    }
    const tribo::ehl::PointContact contact = tribo::ehl::barus_point(m, l, ratio);
    const std::clock_t start = std::clock();
    const auto film = tribo::reference::solve_point_film_by_elements(contact);
    if (!film.is_solved) {
      std::cerr << fmt::format("R_y/R_x = {}, M = {}, L = {}: {}\n", ratio, m, l, film.reason);
      continue;
    }
    const double unit = tribo::ehl::numbers_of(contact).film_number;
    add(key + tribo::reference::fields(film.central, unit) +
        tribo::reference::fields(film.minimum, unit) +
        fmt::format(",{},{:.2g}", film.nodes,
                    static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC));
  }
}
