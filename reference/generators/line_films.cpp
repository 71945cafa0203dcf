// SPDX-License-Identifier: Apache-2.0
// Makes the tables of line films in reference/ehl: line_films.csv, the films between its rows, or
// those of a compressible liquid. Or it makes a seeded sample of the rows of line_films.csv again,
// and compares them within the errors that both state.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "ehl/film_conditions.hpp"
#include "ehl/solved_film.hpp"
#include "generators/film_table.hpp"
#include "generators/line_collocation.hpp"
#include "generators/table_file.hpp"

namespace {

using tribo::ehl::Estimate;
using tribo::ehl::SolvedFilm;
using tribo::reference::fields;
using tribo::reference::write_whole;

constexpr double load_numbers[] = {1, 2, 5, 10, 20, 50, 100, 200};
constexpr double material_numbers[] = {0, 1, 2.5, 5, 10, 15, 20};
constexpr const char* columns =
    "load_number,material_number,central,central_error,minimum,minimum_error,"
    "at_greatest_pressure,at_greatest_pressure_error,spike_pressure,spike_pressure_error,"
    "spike_place,spike_place_error,second_method,note\n";
constexpr int numbers = 12;              // columns that are made again
constexpr double sharpest_spike = 0.01;  // relative error of a spike's pressure that is still given

struct Contact {
  double load_number, material_number;
};

std::vector<Contact> contacts() {
  std::vector<Contact> all;
  for (const double m : load_numbers)
    for (const double l : material_numbers) all.push_back({m, l});
  return all;
}

// The greatest difference between the films of both methods, divided by the sum of both errors;
// empty where the second method did not solve the contact.
std::string part_of_errors(const tribo::ehl::LineContact& contact, const SolvedFilm& films) {
  // The start is a film on a coarser grid, on which the spike is less sharp.
  const tribo::ehl::LineFilm f = tribo::ehl::solve_line_film(contact).film;
  const std::size_t count = f.x.size();
  const tribo::reference::CollocatedFilm other = tribo::reference::collocate_line_film(
      contact,
      {f.x, {f.pressure.data(), count}, {f.film.data(), count}, f.separation, f.mass_flow});
  if (!other.is_solved) return "";
  double part = 0;
  const auto compare = [&](const Estimate& one, const tribo::reference::CollocatedNumber& two) {
    part = std::fmax(part, std::fabs(one.value - two.value) / (one.error + two.error));
  };
  compare(films.central, other.central);
  compare(films.minimum, other.minimum);
  compare(films.at_greatest_pressure, other.at_greatest_pressure);
  if (part > 1)
    throw std::runtime_error(
        fmt::format("M = {}, L = {}: the two methods differ by {:.2g} of the sum of their errors",
                    contact.load_number, contact.material_number, part));
  return fmt::format("{:.2g}", part);
}

std::string row(const Contact& c, bool with_second_method) {
  const tribo::ehl::LineContact contact =
      tribo::ehl::barus_contact(c.load_number, c.material_number);
  const SolvedFilm films =
      tribo::ehl::solve_line_film(contact, {.tolerance = 1e-5, .greatest_cells = 16384});
  // More nodes in the constriction show sharper spikes.
  const SolvedFilm spiky = tribo::ehl::solve_line_film(
      contact,
      {.tolerance = 1e-4, .spike_tolerance = 1e-4, .greatest_cells = 8192, .at_edge = 0.6});
  if (films.outcome != tribo::ehl::Outcome::solved)
    throw std::runtime_error(
        fmt::format("M = {}, L = {}: {}", c.load_number, c.material_number, films.reason));
  const double unit = contact.film_number(1);
  std::string text = fmt::format("{},{}", c.load_number, c.material_number);
  text += fields(films.central, unit) + fields(films.minimum, unit) +
          fields(films.at_greatest_pressure, unit);
  const double off = spiky.spike_pressure.relative_error();
  std::string note;
  if (std::isnan(spiky.spike_pressure.value)) {
    text += ",,,,";
    note = "no second maximum of the pressure";
  } else if (!(off <= sharpest_spike)) {
    text += ",,";
    text += fields(spiky.spike_place, 1);
    note = fmt::format(
        "spike too sharp for the grid: its pressure still changed by {:.0f} % from {} to {} cells",
        100 * off, (spiky.film.x.size() - 1) / 2, spiky.film.x.size() - 1);
  } else {
    text += fields(spiky.spike_pressure, 1) + fields(spiky.spike_place, 1);
  }
  return text + "," + (with_second_method ? part_of_errors(contact, films) : "") + "," + note;
}

// The rows of all contacts in `which`, made on all cores, in their order.
std::vector<std::string> rows_of(const std::vector<Contact>& which, bool with_second_method) {
  const auto make = [&](std::size_t i) {
    std::string made = row(which[i], with_second_method);
    std::cerr << fmt::format("{} of {}: {}\n", i + 1, which.size(), made);
    return made;
  };
  return tribo::reference::made_on_all_cores(which.size(), 1, "", make, [] {});
}

// The first lines of each file.
std::string header(const std::string& quantity, const std::string& liquid, const std::string& more,
                   const std::string& rows) {
  return fmt::format(
      "# quantity: {}\n"
      "# definition: central, minimum and at_greatest_pressure are (h/R)(2U)^(-1/2) at x = 0, "
      "where "
      "h is least, and where p is greatest upstream of the spike; load_number M = W(2U)^(-1/2), "
      "material_number L = G(2U)^(1/4)\n"
      "# equations: steady Reynolds equation, elastic half-planes, load balance, p >= 0 where the "
      "film breaks\n"
      "# assumptions: isothermal, Newtonian, {}, smooth, fully flooded\n"
      "# units: none; each ..._error is absolute, in the unit of its number\n"
      "# generator: reference/generators/line_films.cpp, model/ehl\n"
      "# method: second order in space; Richardson's value of grids of 64, 128, ... "
      "cells\n"
      "# error: shares of what Richardson's value and the value itself changed by and of what a "
      "grid beside differs by, and what a longer inlet would change\n"
      "{}{}",
      quantity, liquid, more, tribo::reference::dated(rows));
}
constexpr const char* barus_liquid = "Barus, incompressible";

int make_table(const std::filesystem::path& file) {
  const std::string rows = tribo::reference::joined(rows_of(contacts(), true));
  write_whole(
      file,
      header("films of smooth line contacts, solved", barus_liquid,
             "# spike: spike_pressure is p/p0 at the second maximum of the pressure, spike_place "
             "its x/b\n"
             "# second method: collocation up to a free boundary (line_collocation.hpp), which "
             "shares no stencil with the first; second_method is by how much of the sum of both "
             "errors the films differ at most, empty where it did not solve the contact\n"
             "# domain: M 1 to 200, L 0 to 20\n",
             rows) +
          columns + rows);
  return 0;
}

// Contacts for the maps on the page in addition to those of the table: further nodes of the maps,
// and contacts between the nodes, at which the maps are checked.
struct MapContacts {
  std::vector<Contact> nodes, checks;
};
MapContacts between_contacts() {
  constexpr double close_load_numbers[] = {1.2, 1.5, 1.75, 2.25, 2.5, 3.5};
  constexpr double close_material_numbers[] = {1.5, 7};
  MapContacts found{{},
                    {{1.1, 3.2},
                     {1.35, 8.4},
                     {1.62, 17},
                     {1.75, 17},
                     {2.2, 12},
                     {2.25, 17.5},
                     {4.2, 3.5},
                     {7, 12},
                     {14, 3.5},
                     {32, 8.4},
                     {71, 2},
                     {141, 17}}};
  const auto add = [&](double m, double l) {
    if (l > 0) found.nodes.push_back({m, l});
  };
  for (const double m : close_load_numbers) {
    for (const double l : material_numbers) add(m, l);
    for (const double l : close_material_numbers) add(m, l);
  }
  for (const double m : load_numbers)
    for (const double l : close_material_numbers) add(m, l);
  return found;
}

// A row: the numbers M and L of a contact, `more`, its three films and its role.
std::string map_row(const Contact& c, const tribo::ehl::LineContact& contact,
                    const std::string& more, const char* role) {
  // More cells than usual: where the front of the pressure passes the middle of the contact, the
  // observed order is irregular and the error is larger.
  const SolvedFilm films = tribo::ehl::solve_line_film(contact, {.greatest_cells = 16384});
  if (films.outcome != tribo::ehl::Outcome::solved)
    throw std::runtime_error(
        fmt::format("M = {}, L = {}: {}", c.load_number, c.material_number, films.reason));
  const double unit = contact.film_number(1);
  return fmt::format("{},{}{}", c.load_number, c.material_number, more) +
         fields(films.central, unit) + fields(films.minimum, unit) +
         fields(films.at_greatest_pressure, unit) + "," + role + "\n";
}

int make_between(const std::filesystem::path& file) {
  const MapContacts all = between_contacts();
  std::string rows;
  const auto add = [&](const std::vector<Contact>& some, const char* role) {
    for (const Contact& c : some)
      rows += map_row(c, tribo::ehl::barus_contact(c.load_number, c.material_number), "", role);
  };
  add(all.nodes, "node");
  add(all.checks, "check");
  write_whole(
      file,
      header("films of smooth line contacts, solved, between those of line_films.csv", barus_liquid,
             "# role: node of the map on the page, or check of what it joins\n", rows) +
          "load_number,material_number,central,central_error,minimum,minimum_error,"
          "at_greatest_pressure,at_greatest_pressure_error,role\n" +
          rows);
  return 0;
}

int make_compressible(const std::filesystem::path& file) {
  using namespace tribo::ehl;
  std::string rows;
  const auto add = [&](const Contact& c, const char* role) {
    const FilmConditions conditions = tribo::reference::compressible_conditions(
        c.load_number, c.material_number, std::numeric_limits<double>::infinity());
    const FilmScale scale = scale_of(conditions);
    rows += map_row(c, contact_of(conditions),
                    fmt::format(",{:.6g},{:.6g}", scale.speed_number, scale.peak_pressure), role);
  };
  for (const Contact& c : contacts())
    if (c.material_number > 0) add(c, "table");
  const MapContacts more = between_contacts();
  for (const Contact& c : more.nodes) add(c, "node");
  for (const Contact& c : more.checks) add(c, "check");
  write_whole(
      file,
      header("films of smooth line contacts with a compressible liquid, solved",
             tribo::reference::compressible_liquid,
             "# speed_number: U = eta0 u/(2 E* R), which follows from L; peak_pressure: Hertz', "
             "Pa\n"
             "# role: of the table of the formulas' errors, node of the map on the page, or check "
             "of what it joins\n",
             rows) +
          "load_number,material_number,speed_number,peak_pressure,central,central_error,minimum,"
          "minimum_error,at_greatest_pressure,at_greatest_pressure_error,role\n" +
          rows);
  return 0;
}

int check_sample(const std::filesystem::path& file, std::uint64_t seed, int count) {
  const std::vector<Contact> all = contacts();
  const auto again = [&](const std::vector<std::size_t>& places) {
    std::vector<Contact> some;
    for (const std::size_t place : places) some.push_back(all[place]);
    return rows_of(some, false);
  };
  const auto is_same = [](const std::string& committed, const std::string& made) {
    return tribo::reference::is_within_errors(committed, made, 2, numbers);
  };
  const int different = tribo::reference::different_rows(
      file.string(), tribo::reference::committed_rows(file, "load_number"), all.size(), seed, count,
      again, is_same);
  return different == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Makes the table of solved line films by two methods; some minutes on two cores"};
  app.footer("Example:\n  generate_line_films reference/ehl/line_films.csv --sample 5 --seed 42");
  std::string file;
  int sample = 0;
  std::uint64_t seed = 1;
  bool is_between = false, is_compressible = false;
  app.add_option("file", file, "where the table is, or goes")->required();
  CLI::Option* const of_sample =
      app.add_option("--sample", sample, "make this many rows again and compare them")
          ->check(CLI::PositiveNumber);
  app.add_option("--seed", seed, "of the sample");
  app.add_flag("--between", is_between, "make the films between those of the table, for the map")
      ->excludes(of_sample);
  app.add_flag("--compressible", is_compressible,
               "make the films of a compressible liquid, for the formulas that were fitted to one")
      ->excludes(of_sample);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (is_between) return make_between(file);
  if (is_compressible) return make_compressible(file);
  return sample > 0 ? check_sample(file, seed, sample) : make_table(file);
}
