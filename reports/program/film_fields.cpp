// SPDX-License-Identifier: Apache-2.0
// The fields of a film as HDF5 or CSV. Only this part of the command `film` needs HDF5.
#include <fstream>
#include <stdexcept>
#include <utility>

#include "build_info.hpp"
#include "film_command.hpp"
#include "protocol/answers.hpp"
#include "sweep/hdf5_handles.hpp"

namespace tribo::cli {
namespace {

namespace hdf5 = sweep::hdf5;

// The rows of both halves, y ascending: the sign of y, and the index of |y| in `y`.
std::vector<std::pair<int, std::size_t>> rows_across(const FilmFields& fields) {
  std::vector<std::pair<int, std::size_t>> rows;
  for (std::size_t j = fields.y.size(); j-- > 1;) rows.emplace_back(-1, j);
  for (std::size_t j = 0; j < fields.y.size(); ++j) rows.emplace_back(1, j);
  return rows;
}

void write_csv(const FilmFields& fields, const std::string& path) {
  std::ofstream file(path);
  file << "x [m],y [m],pressure [Pa],film [m]\n";
  Text row;
  for (const auto& [sign, j] : rows_across(fields))
    for (std::size_t i = 0; i < fields.x.size(); ++i) {
      const std::size_t node = j * fields.x.size() + i;
      row.clear();
      protocol::append_number(row, fields.x[i]);
      for (const double value : {sign * fields.y[j], fields.pressure[node], fields.film[node]}) {
        row.push_back(',');
        protocol::append_number(row, value);
      }
      row.push_back('\n');
      file.write(row.data(), static_cast<std::streamsize>(row.size()));
    }
  if (!file.flush()) throw std::runtime_error("not all of it could be written");
}

void write_hdf5(const FilmCase& film, const std::string& path) {
  const hdf5::QuietErrors quiet;
  const FilmFields& fields = film.fields;
  hdf5::Handle file = hdf5::create_file(path);
  const auto tell = [&file](const char* name, auto value) {
    hdf5::write_attribute(file, name, value);
  };
  tell("format", std::string_view("tribocheck film fields 1"));
  tell("tribocheck_commit", program_commit());
  tell("id", std::string_view(film.id));
  tell("speed", film.speed);
  tell("load_number", film.load_number);
  tell("material_number", film.material_number);
  tell("half_width", film.half_width);
  tell("ellipticity", film.ellipticity);
  tell("peak_pressure", film.peak_pressure);
  if (film.is_starved()) tell("inlet_film", film.inlet_film);
  tell("viscosity", film.viscosity);
  tell("density", film.density);
  tell("tolerance", film.tolerance);
  const auto rows = rows_across(fields);
  const auto add = [&](const char* name, const std::vector<double>& values, const char* unit,
                       std::string_view meaning, std::vector<hsize_t> extents) {
    const hdf5::Handle dataset = hdf5::write_array(file, name, values, std::move(extents));
    hdf5::write_attribute(dataset, "unit", std::string_view(unit));
    hdf5::write_attribute(dataset, "meaning", meaning);
  };
  const auto both_halves = [&](const std::vector<double>& half) {
    const auto width = static_cast<std::ptrdiff_t>(fields.x.size());
    std::vector<double> all;
    for (const auto& [sign, j] : rows) {
      const auto start = half.begin() + width * static_cast<std::ptrdiff_t>(j);
      all.insert(all.end(), start, start + width);
    }
    return all;
  };
  std::vector<double> y;
  for (const auto& [sign, j] : rows) y.push_back(sign * fields.y[j]);
  const std::vector<hsize_t> extents{y.size(), fields.x.size()};
  add("x", fields.x, "m", "along the direction of entrainment, from the middle of the contact",
      {fields.x.size()});
  add("y", y, "m", "across the direction of entrainment, from the middle of the contact",
      {y.size()});
  add("pressure", both_halves(fields.pressure), "Pa", "at y (first index) and x, finest grid",
      extents);
  add("film", both_halves(fields.film), "m", "at y (first index) and x, finest grid", extents);
  hdf5::checked(H5Fflush(file, H5F_SCOPE_GLOBAL));
  file.close();
  if (const auto failed = hdf5::take_failed_close()) throw hdf5::Error(*failed);
}

void write_fields(const FilmCase& film, const std::string& path, bool is_csv) {
  is_csv ? write_csv(film.fields, path) : write_hdf5(film, path);
}

}  // namespace

Command add_film_with_fields(CLI::App& program) { return film_command(program, &write_fields); }

}  // namespace tribo::cli
