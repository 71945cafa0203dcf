// SPDX-License-Identifier: Apache-2.0
// Makes the tables of reference/exact, or makes a seeded sample of their rows again and compares
// their texts byte by byte.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>

#include "generators/table.hpp"
#include "generators/table_file.hpp"

namespace {

using namespace tribo::reference;

std::vector<Table> all_tables() {
  std::vector<Table> all;
  for (const auto make :
       {two_bodies, gaussian_moments, load_sharing_roots, starvation, hertz_contacts, film_formulas,
        liquids, operating_points, film_laws, rough_faces, adhesion})
    for (Table& table : make()) all.push_back(std::move(table));
  return all;
}
std::string file_of(const Table& table) { return table.header.quantity + ".csv"; }

std::string header_text(const Header& h, const std::string& rows) {
  return fmt::format(
      "# quantity: {}\n# definition: {}\n# units: {}\n# domain: {}\n"
      "# generator: reference/generators, Arb {} at {} bits\n"
      "# digits: 40, enclosed to 133 bits or more; high + low are doubles, high the nearest\n"
      "# first method: {}\n# second method: {}; each row's enclosures overlap\n"
      "# condition: sum of |d ln value/d ln input|\n{}id,{},value,high,low,condition,region\n",
      h.quantity, h.definition, h.units, h.domain, arb_version, ball_precision, h.first_method,
      h.second_method, dated(rows), h.inputs);
}

// Blocks of 9 rows stay on one thread, because the 9 outputs of an operating point share work.
std::vector<std::string> make_rows(const Table& table) {
  constexpr std::size_t block = 9;
  const auto make = [&](std::size_t i) {
    if (i % (64 * block) == 0)
      std::cerr << fmt::format("{}: {} of {} rows\n", file_of(table), i, table.rows.size());
    return table.rows[i]();
  };
  return made_on_all_cores(table.rows.size(), block, file_of(table) + ": ", make, flint_cleanup);
}

int make_tables(const std::filesystem::path& folder, const std::string& only) {
  bool is_known = only.empty();
  for (const Table& table : all_tables()) {
    const std::string file = file_of(table);
    if (!only.empty() && only != file) continue;
    is_known = true;
    const std::string rows = joined(make_rows(table));
    write_whole(folder / file, header_text(table.header, rows) + rows);
    std::cerr << fmt::format("{}: {} rows\n", file, table.rows.size());
  }
  if (is_known) return 0;
  std::cerr << fmt::format("--only: no table is named {}\n", only);
  return 2;
}

int check_sample(const std::filesystem::path& folder, std::uint64_t seed, int count) {
  int different = 0;
  for (const Table& table : all_tables()) {
    const auto again = [&](const std::vector<std::size_t>& places) {
      std::vector<std::string> rows;
      for (const std::size_t place : places) rows.push_back(table.rows[place]());
      return rows;
    };
    different += different_rows(file_of(table), committed_rows(folder / file_of(table), "id,"),
                                table.rows.size(), seed, count, again, std::equal_to<>());
  }
  return different == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Makes the tables of reference/exact in ball arithmetic"};
  app.footer("Example:\n  generate_references reference/exact --sample 5 --seed 42");
  std::string folder, only;
  int sample = 0;
  std::uint64_t seed = 1;
  app.add_option("folder", folder, "where the tables are, or go")
      ->required()
      ->check(CLI::ExistingDirectory);
  CLI::Option* const of_only = app.add_option("--only", only, "make this file alone");
  app.add_option("--sample", sample, "make this many rows of each table again and compare bytes")
      ->check(CLI::PositiveNumber)
      ->excludes(of_only);
  app.add_option("--seed", seed, "of the sample");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return sample > 0 ? check_sample(folder, seed, sample) : make_tables(folder, only);
}
