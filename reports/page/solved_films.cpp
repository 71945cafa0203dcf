// SPDX-License-Identifier: Apache-2.0
#include "page/solved_films.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <set>
#include <stdexcept>

#include "accuracy/reference_table.hpp"

namespace tribo::report {
namespace {

// Where films change fast over the numbers, the table is too coarse for a smooth map.
constexpr std::array close_load_numbers{1.2, 1.5, 1.75, 2.25, 2.5, 3.5};
constexpr std::array close_material_numbers{1.5, 7.};
constexpr ehl::SolveOptions map_options{.tolerance = 1e-3, .greatest_cells = 1024};

const SolvedNumbers* find_numbers(const std::vector<SolvedNumbers>& table, double load_number,
                                  double material_number) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const SolvedNumbers& one) {
    return one.load_number == load_number && one.material_number == material_number;
  });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace

std::vector<SolvedNumbers> read_solved_films(const std::string& path) {
  constexpr std::array names{"central", "minimum", "at_greatest_pressure"};
  std::vector<SolvedNumbers> table;
  for (const verification::ReferenceRow& row : verification::read_reference_table(path)) {
    SolvedNumbers one{row.number("load_number"), row.number("material_number"), {}, {}};
    bool is_whole = true;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::string error = fmt::format("{}_error", names[i]);
      is_whole = is_whole && !row.text(names[i]).empty() && !row.text(error).empty();
      if (!is_whole) break;
      one.film[i] = row.number(names[i]);
      one.error[i] = row.number(error);
    }
    if (is_whole) table.push_back(one);
  }
  return table;
}

SolvedNumbers solved_numbers(double load_number, double material_number) {
  const ehl::LineContact contact = ehl::barus_contact(load_number, material_number);
  const ehl::SolvedFilm solved = ehl::solve_line_film(contact, map_options);
  if (solved.outcome != ehl::Outcome::solved)
    throw std::runtime_error(fmt::format("the line contact of M = {} and L = {}: {}", load_number,
                                         material_number, solved.reason));
  const double unit = contact.film_number(1);
  SolvedNumbers numbers{load_number, material_number, {}, {}};
  const std::array estimates{solved.central, solved.minimum, solved.at_greatest_pressure};
  for (std::size_t i = 0; i < estimates.size(); ++i) {
    numbers.film[i] = unit * estimates[i].value;
    numbers.error[i] = unit * estimates[i].error;
  }
  return numbers;
}

FilmMap::FilmMap(const std::vector<SolvedNumbers>& table) {
  std::set<double> loads, materials;
  for (const SolvedNumbers& one : table) {
    loads.insert(one.load_number);
    if (one.material_number > 0) materials.insert(one.material_number);
  }
  if (loads.size() < 4 || materials.size() < 4)
    throw std::runtime_error("line_films.csv has fewer than four load or material numbers");
  const auto add_within = [](std::set<double>& numbers, const auto& more) {
    for (const double number : more)
      if (number > *numbers.begin() && number < *numbers.rbegin()) numbers.insert(number);
  };
  add_within(loads, close_load_numbers);
  add_within(materials, close_material_numbers);
  load_numbers.assign(loads.begin(), loads.end());
  material_numbers.assign(materials.begin(), materials.end());

  std::vector<Eigen::MatrixXd> films(
      3, Eigen::MatrixXd(static_cast<Eigen::Index>(load_numbers.size()),
                         static_cast<Eigen::Index>(material_numbers.size())));
  const auto fill = [&](std::size_t m) {
    std::size_t solved = 0;
    for (std::size_t l = 0; l < material_numbers.size(); ++l) {
      const SolvedNumbers* const known = find_numbers(table, load_numbers[m], material_numbers[l]);
      if (known == nullptr) ++solved;
      const SolvedNumbers numbers =
          known != nullptr ? *known : solved_numbers(load_numbers[m], material_numbers[l]);
      for (std::size_t i = 0; i < films.size(); ++i)
        films[i](static_cast<Eigen::Index>(m), static_cast<Eigen::Index>(l)) = numbers.film[i];
    }
    return solved;
  };
  std::vector<std::future<std::size_t>> rows;
  for (std::size_t m = 0; m < load_numbers.size(); ++m)
    rows.push_back(std::async(std::launch::async, fill, m));
  for (std::future<std::size_t>& row : rows) solved_here += row.get();
  for (const Eigen::MatrixXd& film : films)
    surfaces.emplace_back(load_numbers, material_numbers, film);
}

}  // namespace tribo::report
