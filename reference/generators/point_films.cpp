// SPDX-License-Identifier: Apache-2.0
// Makes reference/ehl/point_films.csv row by row, or makes a seeded sample of its cheap rows again
// and compares them within the errors that both state.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "ehl/solved_point.hpp"
#include "generators/film_table.hpp"

namespace {

using tribo::ehl::SolvedPoint;
using tribo::reference::fields;

constexpr const char* columns =
    "radius_ratio,supply,load_number,material_number,central,central_error,minimum,minimum_error,"
    "at_greatest_pressure,at_greatest_pressure_error,nodes,seconds,";
constexpr std::size_t keys = 4, numbers = 10;  // columns that name a row, and that are made again
constexpr std::size_t before_note = 12;        // columns before the second method's
constexpr double cheap_seconds = 6;            // a sample takes no slower rows

struct Contact {
  double radius_ratio, load_number, material_number;
  double supply = 0;  // ρ = h_oil/(ρ̄(p₀)h_ff); 0: the inlet is flooded

  // The first columns of its row.
  std::string key() const {
    return fmt::format("{},{},{},{}", radius_ratio, supply > 0 ? fmt::format("{}", supply) : "",
                       load_number, material_number);
  }
};

enum class Table : char { main, between, compressible };

// Circles between those of the table, in the order of the rows.
std::vector<Contact> contacts_between() {
  std::vector<Contact> all;
  for (const auto& [m, l] : std::initializer_list<std::pair<double, double>>{
           {14, 5},     {14, 2.5},   {14, 1},    {12, 4},   {12, 8},      {20, 1},
           {25, 0.5},   {25, 8},     {30, 7},    {35, 2},   {50, 0.3},    {50, 3.5},
           {70, 3.5},   {70, 12.5},  {80, 7.5},  {100, 1},  {120, 0.5},   {150, 7},
           {180, 12.5}, {300, 1},    {300, 3.5}, {300, 7},  {400, 12},    {500, 0.3},
           {700, 3.5},  {700, 12.5}, {1000, 7},  {1400, 1}, {1400, 12.5}, {1700, 3.5}})
    all.push_back({1, m, l});
  for (const Contact& c : std::initializer_list<Contact>{{1, 30, 7, 0.6},
                                                         {1, 30, 7, 1.2},
                                                         {1, 50, 3.5, 0.45},
                                                         {1, 50, 3.5, 0.85},
                                                         {1, 50, 3.5, 2.8},
                                                         {1, 80, 7.5, 1},
                                                         {1, 150, 7, 0.6},
                                                         {1, 150, 7, 1},
                                                         {1, 300, 3.5, 0.85},
                                                         {1, 300, 3.5, 1.2},
                                                         {1, 300, 7, 0.45},
                                                         {1, 300, 7, 1},
                                                         {1, 300, 7, 1.7},
                                                         {1, 400, 12, 1},
                                                         {1, 1000, 5, 0.85}})
    all.push_back(c);
  return all;
}

// In the order of the rows.
std::vector<Contact> contacts(Table table) {
  if (table == Table::between) return contacts_between();
  std::vector<Contact> all;
  if (table == Table::compressible) {
    for (const double m : {20., 50., 100., 200., 500., 1000.})
      for (const double l : {5., 10.}) all.push_back({1, m, l});
    return all;
  }
  for (const double m : {5., 10., 20., 50., 100., 200., 500., 1000., 2000.})
    for (const double l : {0., 2.5, 5., 10., 15.}) all.push_back({1, m, l});
  for (const double ratio : {0.25, 0.5, 2., 4., 8.})
    for (const double m : {20., 200.})
      for (const double l : {5., 10.}) all.push_back({ratio, m, l});
  for (const double m : {20., 100., 500., 2000.}) all.push_back({1, m, 12.5});
  for (const double m : {20., 100., 500., 2000.})
    for (const double l : {2.5, 5., 12.5})
      for (const double supply : {0.25, 0.35, 0.5, 0.7, 1., 1.4, 2., 4.})
        all.push_back({1, m, l, supply});
  return all;
}

double processor_seconds() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

tribo::ehl::PointContact flooded(const Contact& c, Table table) {
  if (table != Table::compressible)
    return tribo::ehl::barus_point(c.load_number, c.material_number, c.radius_ratio);
  return tribo::ehl::point_contact_of(
      tribo::reference::compressible_conditions(c.load_number, c.material_number, c.radius_ratio));
}

SolvedPoint solved(const tribo::ehl::PointContact& contact) {
  tribo::ehl::PointOptions options{.tolerance = contact.load_number > 200 ? 3e-3 : 1e-3};
  if (contact.load_number > 1000 && contact.is_starved()) options.tolerance = 8e-3;
  SolvedPoint films = solve_point_film(contact, options);
  if (films.outcome == tribo::ehl::Outcome::solved && !films.reason.empty()) {
    // The tolerance was just missed: one more grid is allowed, which takes some minutes.
    options.greatest_nodes += options.greatest_nodes / 5;
    films = solve_point_film(contact, options);
  }
  return films;
}

// The flooded central film H, the unit of a row's supply. It is kept, because neighbours share it.
double flooded_film(const Contact& c) {
  static Contact last{};
  static double film = 0;
  if (last.key() != Contact{c.radius_ratio, c.load_number, c.material_number}.key()) {
    last = {c.radius_ratio, c.load_number, c.material_number};
    film = solved(flooded(last, Table::main)).central.value;
  }
  return film;
}

std::string row(const Contact& c, Table table) {
  tribo::ehl::PointContact contact = flooded(c, table);
  if (c.supply > 0) contact.inlet_film = c.supply * flooded_film(c);
  const double start = processor_seconds();
  const SolvedPoint films = solved(contact);
  const double seconds = processor_seconds() - start;
  std::string note = films.reason, text = c.key();
  for (std::size_t comma; (comma = note.find(',')) != std::string::npos;) note[comma] = ';';
  if (films.outcome == tribo::ehl::Outcome::solved) {
    const double unit = tribo::ehl::numbers_of(contact).film_number;
    text += fields(films.central, unit) + fields(films.minimum, unit) +
            fields(films.at_greatest_pressure, unit) + fmt::format(",{}", films.film.grid.size());
  } else {
    text += ",,,,,,,";
  }
  return text + fmt::format(",{:.2g},{}", seconds, note);
}

// `missing`: the rows that are not made yet, by their first columns.
std::string header(const std::string& rows, const std::string& missing, Table table) {
  const bool is_barus = table != Table::compressible;
  return std::string("# quantity: films of smooth circular ") +
         (table == Table::main ? "and elliptical contacts, solved"
          : is_barus           ? "contacts, solved, between those of point_films.csv"
                               : "contacts with a compressible liquid, solved") +
         "\n"
         "# definition: central, minimum and at_greatest_pressure are (h/R_x)(2U)^(-1/2) at x = y "
         "= 0, where h is least, and where p is greatest; load_number M = W(2U)^(-3/4) with W = "
         "F/(2E*R_x^2), material_number L = G(2U)^(1/4); radius_ratio R_y/R_x, x is the direction "
         "of entrainment; supply: h_oil over the flooded central film, empty where the inlet is "
         "flooded\n"
         "# equations: steady Reynolds equation, elastic half-spaces, load balance, p >= 0 where "
         "the film breaks; where starved, mass is conserved, and no liquid flows back into the "
         "track\n"
         "# assumptions: isothermal, Newtonian, " +
         (is_barus ? "Barus, incompressible" : tribo::reference::compressible_liquid) +
         ", smooth\n"
         "# units: none; each ..._error is absolute, in the unit of its number\n"
         "# generator: reference/generators/point_films.cpp, model/ehl\n"
         "# method: second order in space; Richardson's value of three or more grids, each of half "
         "the cells' size; one more grid is larger\n"
         "# error: shares of what Richardson's value and the value itself changed by, and what a "
         "larger grid would change; up to 1e-3 (minimum 3e-3) of the film at M <= 200, 3e-3 (1e-2) "
         "beyond, 8e-3 (2.4e-2) of starved films at M > 1000, else note tells\n"
         "# nodes: of the finest grid, a half plane; seconds: of one core of the machine that made "
         "the row\n" +
         (table == Table::main ? "# second method: finite elements (point_elements.hpp), which "
                                 "share no stencil with "
                                 "the first; second_method is by how much their central film of "
                                 "point_films_second_method.csv is greater, over the central film, "
                                 "empty where there "
                                 "is none\n"
                               : "") +
         "# missing: " + (missing.empty() ? "none" : missing) + "\n" +
         tribo::reference::dated(rows);
}

// The place of the comma behind the first `count` fields of a row.
std::size_t end_of(const std::string& row, std::size_t count) {
  std::size_t end = 0;
  for (std::size_t i = 0; i < count; ++i) end = row.find(',', end + (i > 0 ? 1 : 0));
  return end;
}

std::string key_of(const std::string& row) { return row.substr(0, end_of(row, keys)); }

// The rows of a file, without the column of the second method.
std::vector<std::string> rows_of(const std::filesystem::path& file) {
  std::vector<std::string> rows = tribo::reference::committed_rows(file, "radius_ratio");
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line) && line.starts_with("#")) continue;
  if (line.find(",second_method,") != std::string::npos)
    for (std::string& row : rows)
      row.erase(end_of(row, before_note), end_of(row, before_note + 1) - end_of(row, before_note));
  return rows;
}

// Writes the known rows in the order of the table. Rows of the main table get the column of the
// second method, from point_films_second_method.csv beside the table.
void write(const std::filesystem::path& file, Table table,
           const std::map<std::string, std::string>& known) {
  std::map<std::string, double> second;
  if (table == Table::main)
    for (const std::string& one : tribo::reference::committed_rows(
             file.parent_path() / "point_films_second_method.csv", "radius_ratio"))
      second[key_of(one)] = tribo::reference::numbers_of(one, keys + 1).back();
  std::string rows, missing;
  for (const Contact& c : contacts(table)) {
    const auto found = known.find(c.key());
    if (found == known.end()) {
      missing += (missing.empty() ? "" : " ") + c.key();
      continue;
    }
    std::string row = found->second;
    if (table == Table::main) {
      const auto other = second.find(c.key());
      const double central = tribo::reference::numbers_of(row, keys + 1).back();
      row.insert(end_of(row, before_note),
                 other == second.end() ? "," : fmt::format(",{:.2g}", other->second / central - 1));
    }
    rows += row + "\n";
  }
  tribo::reference::write_whole(
      file, header(rows, missing, table) + columns +
                (table == Table::main ? "second_method,note\n" : "note\n") + rows);
}

// Adds the rows that the file lacks, small M first. Each is in the file once it is solved, so that
// the next run goes on.
int add_rows(const std::filesystem::path& file, Table table, bool only_columns) {
  const std::vector<Contact> all = contacts(table);
  std::map<std::string, std::string> known;
  for (const std::string& one : rows_of(file)) known[key_of(one)] = one;
  std::vector<Contact> missing;
  for (const Contact& c : all)
    if (!known.contains(c.key())) missing.push_back(c);
  if (only_columns) missing.clear();
  write(file, table, known);
  std::ranges::stable_sort(missing, {}, &Contact::load_number);
  for (const Contact& c : missing) {
    const std::string made = known[c.key()] = row(c, table);
    std::cerr << fmt::format("{} of {}: {}\n", known.size(), all.size(), made);
    write(file, table, known);
  }
  return 0;
}

int check_sample(const std::filesystem::path& file, Table table, std::uint64_t seed, int count) {
  std::vector<std::string> cheap;
  std::vector<Contact> contacts_of_cheap;
  const std::vector<Contact> all = contacts(table);
  for (const std::string& one : rows_of(file)) {
    const auto c = std::ranges::find(all, key_of(one), &Contact::key);
    if (c == all.end()) {
      std::cout << fmt::format("{}: the generator does not make the row {}\n", file.string(), one);
      return 1;
    }
    // The seconds come after the numbers and the nodes.
    if (!(tribo::reference::numbers_of(one, numbers + 2).back() <= cheap_seconds)) continue;
    cheap.push_back(one);
    contacts_of_cheap.push_back(*c);
  }
  if (cheap.empty()) {
    std::cout << fmt::format("{}: has no cheap row\n", file.string());
    return 1;
  }
  const auto again = [&](const std::vector<std::size_t>& places) {
    std::vector<std::string> made;
    for (const std::size_t place : places) made.push_back(row(contacts_of_cheap[place], table));
    return made;
  };
  const auto is_same = [](const std::string& committed, const std::string& made) {
    return tribo::reference::is_within_errors(committed, made, keys, numbers);
  };
  const int different = tribo::reference::different_rows(file.string() + ", cheap rows", cheap,
                                                         cheap.size(), seed, count, again, is_same);
  return different == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Adds the rows that the table of solved point films lacks: all in an hour and a half of one "
      "core; a "
      "run "
      "that was stopped is taken up again"};
  app.footer("Example:\n  generate_point_films reference/ehl/point_films.csv --sample 4 --seed 42");
  std::string file;
  int sample = 0;
  std::uint64_t seed = 1;
  app.add_option("file", file, "where the table is, or goes")->required();
  app.add_option("--sample", sample, "make this many cheap rows again and compare them")
      ->check(CLI::PositiveNumber);
  app.add_option("--seed", seed, "of the sample");
  Table table = Table::main;
  app.add_flag_callback(
      "--between", [&] { table = Table::between; }, "the table of contacts between those");
  app.add_flag_callback(
      "--compressible", [&] { table = Table::compressible; },
      "the table of a compressible liquid, for the formulas that were fitted to one");
  bool only_columns = false;
  app.add_flag("--only-columns", only_columns,
               "make no rows, and write the column of the second method anew");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return sample > 0 ? check_sample(file, table, seed, sample) : add_rows(file, table, only_columns);
}
