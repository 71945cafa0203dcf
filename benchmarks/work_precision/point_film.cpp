// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <malloc.h>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include "accuracy/reference_table.hpp"
#include "contenders/textbook_point_film.hpp"
#include "ehl/plane_kernel.hpp"
#include "sweep/on_threads.hpp"
#include "work_precision/measures.hpp"

namespace tribo::benchmarks {
namespace {

constexpr double radius_ratio = 1;

// The row of reference/ehl/point_films.csv of a flooded circle.
verification::ReferenceRow row_of(double load_number, double material_number) {
  for (const verification::ReferenceRow& row :
       verification::read_reference_table(TRIBOCHECK_REFERENCE "/ehl/point_films.csv"))
    if (row.text("supply").empty() && row.number("radius_ratio") == radius_ratio &&
        row.number("load_number") == load_number &&
        row.number("material_number") == material_number)
      return row;
  throw std::runtime_error(fmt::format("point_films.csv has no circle with M = {} and L = {}",
                                       load_number, material_number));
}

void check(const verification::ReferenceRow& row, const char* name, const ehl::Estimate& got,
           double unit) {
  const double value = row.number(name), error = row.number(std::string(name) + "_error");
  if (!(std::fabs(unit * got.value - value) <= unit * got.error + error))
    throw std::runtime_error(
        fmt::format("M = {}, L = {}: the {} film is {:.6g} ± {:.1g}, in point_films.csv "
                    "{:.6g} ± {:.1g}",
                    row.number("load_number"), row.number("material_number"), name,
                    unit * got.value, unit * got.error, value, error));
}

double bytes_in(const std::string& what) {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(what)) return 1024 * std::stod(line.substr(what.size()));
  throw std::runtime_error("/proc/self/status has no " + what);
}

// The most memory, in bytes, that some work adds to the memory of this process at any time.
double most_bytes(const std::function<void()>& work) {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;  // resets VmHWM to the present memory
  const double before = bytes_in("VmHWM:");
  work();
  return bytes_in("VmHWM:") - before;
}

struct OnGrid {
  const char* solver;
  ehl::PlaneGrid grid;
  double kernel_seconds, step_seconds, bytes;
};

nlohmann::ordered_json growth_row(const OnGrid& one) {
  return {{"solver", one.solver},
          {"cells", (one.grid.count_x() - 1) * one.grid.beside},
          {"kernel_ns", four_digits(1e9 * one.kernel_seconds)},
          {"step_ns", four_digits(1e9 * one.step_seconds)},
          {"bytes", std::round(one.bytes)}};
}

template <class Work>
double seconds_of(Work&& work) {
  const double start = cpu_seconds();
  work();
  return cpu_seconds() - start;
}

}  // namespace

std::vector<JudgedFilm<ehl::PointContact>> judged_points(Eigen::Index greatest_nodes) {
  std::vector<JudgedFilm<ehl::PointContact>> all;
  for (const auto& [load_number, material_number] : {std::pair{20., 5.}, {200., 10.}}) {
    const ehl::PointContact contact = ehl::barus_point(load_number, material_number, radius_ratio);
    // The tolerance is too small to be reached, so that all allowed grids are solved.
    const ehl::SolvedPoint solved =
        ehl::solve_point_film(contact, {.tolerance = 1e-9, .greatest_nodes = greatest_nodes});
    if (solved.outcome != ehl::Outcome::solved) throw std::runtime_error(solved.reason);
    const verification::ReferenceRow row = row_of(load_number, material_number);
    const double unit = ehl::numbers_of(contact).film_number;
    check(row, "central", solved.central, unit);
    check(row, "minimum", solved.minimum, unit);
    all.push_back({contact, film_numbers(contact, solved)});
  }
  return all;
}

Rows point_film_errors(const std::vector<JudgedFilm<ehl::PointContact>>& contacts,
                       const Effort& effort) {
  Rows rows;
  for (const JudgedFilm<ehl::PointContact>& one : contacts)
    for (nlohmann::ordered_json& row : film_errors<ehl::PointContact>(
             "point_film", point_film_ways(one.contact), {one}, effort)) {
      for (const char* const column : {"series", "name"})
        row[column] =
            fmt::format("{}, M = {}", row.at(column).get<std::string>(), one.contact.load_number);
      rows.push_back(std::move(row));
    }
  return rows;
}

Rows point_film_growth(Eigen::Index greatest_nodes) {
  const ehl::PointContact contact = ehl::barus_point(20, 5, radius_ratio);
  const int coarsest = coarsest_cells(contact);
  ehl::PlaneGrid grid = ehl::grid_for(contact, coarsest);
  const ehl::PointFilm coarse = ehl::solve_from_nothing(contact, grid, {});
  Rows rows;
  for (ehl::PointFilm film = coarse; grid.size() <= greatest_nodes; grid = grid.finer()) {
    OnGrid one{"tribocheck: sparse LU", grid, 0, 0, 0};
    one.kernel_seconds = seconds_of([&] { const ehl::PlaneKernel kernel(grid); });
    const int before = film.steps;
    one.bytes = most_bytes([&] {
      one.step_seconds = seconds_of([&] { film = ehl::solve_on(contact, grid, film, {}); });
    });
    one.step_seconds /= film.steps - before;
    rows.push_back(growth_row(one));
  }
  for (int cells = coarsest - 2; ehl::grid_for(contact, cells).size() <= 2500; ++cells) {
    OnGrid one{"textbook: dense LU", ehl::grid_for(contact, cells), 0, 0, 0};
    TextbookPointFilm textbook(contact, one.grid);
    textbook.start_from(coarse);
    one.kernel_seconds = seconds_of([&] { textbook.fill_kernel(); });
    one.step_seconds = seconds_of([&] { textbook.newton_step(); });
    one.bytes = static_cast<double>(textbook.newton_bytes());
    rows.push_back(growth_row(one));
  }
  return rows;
}

Rows point_films_on_threads(int films_a_thread) {
  using Clock = std::chrono::steady_clock;
  const ehl::PointContact contact = ehl::barus_point(20, 5, radius_ratio);
  Rows rows;
  for (int threads = 1; threads <= thread_count(0); threads *= 2) {
    const auto films = static_cast<std::size_t>(threads * films_a_thread);
    const auto start = Clock::now();
    each_on_threads(threads, films, [&](std::size_t) { ehl::solve_point_film(contact); });
    const std::chrono::duration<double, std::nano> took = Clock::now() - start;
    rows.push_back(
        {{"threads", threads}, {"ns", four_digits(took.count() / static_cast<double>(films))}});
  }
  return rows;
}

}  // namespace tribo::benchmarks
