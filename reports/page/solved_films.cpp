// SPDX-License-Identifier: Apache-2.0
#include "page/solved_films.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "accuracy/reference_table.hpp"

namespace tribo::report {
namespace {

const SolvedNumbers* find_numbers(const std::vector<SolvedNumbers>& table, double load_number,
                                  double material_number) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const SolvedNumbers& one) {
    return one.load_number == load_number && one.material_number == material_number;
  });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace

std::vector<SolvedNumbers> read_solved_films(const std::string& path, std::string_view role) {
  constexpr std::array names{"central", "minimum", "at_greatest_pressure"};
  std::vector<SolvedNumbers> table;
  for (const verification::ReferenceRow& row : verification::read_reference_table(path)) {
    if (!role.empty() && row.text("role") != role) continue;
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

FilmMap::FilmMap(const std::vector<SolvedNumbers>& table) {
  std::set<double> loads, materials;
  for (const SolvedNumbers& one : table) {
    loads.insert(one.load_number);
    if (one.material_number > 0) materials.insert(one.material_number);
  }
  if (loads.size() < 4 || materials.size() < 4)
    throw std::runtime_error("line_films.csv has fewer than four load or material numbers");
  load_numbers.assign(loads.begin(), loads.end());
  material_numbers.assign(materials.begin(), materials.end());

  std::vector<Eigen::MatrixXd> films(
      3, Eigen::MatrixXd(static_cast<Eigen::Index>(load_numbers.size()),
                         static_cast<Eigen::Index>(material_numbers.size())));
  for (std::size_t m = 0; m < load_numbers.size(); ++m)
    for (std::size_t l = 0; l < material_numbers.size(); ++l) {
      const SolvedNumbers* const known = find_numbers(table, load_numbers[m], material_numbers[l]);
      if (known == nullptr)
        throw std::runtime_error(fmt::format(
            "neither line_films.csv nor line_films_between.csv has the film of M = {}, L = {}",
            load_numbers[m], material_numbers[l]));
      for (std::size_t i = 0; i < films.size(); ++i)
        films[i](static_cast<Eigen::Index>(m), static_cast<Eigen::Index>(l)) = known->film[i];
    }
  for (const Eigen::MatrixXd& film : films)
    surfaces.emplace_back(load_numbers, material_numbers, film);
}

}  // namespace tribo::report
