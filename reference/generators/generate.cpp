// SPDX-License-Identifier: Apache-2.0
// Makes the tables of reference/exact, or makes a seeded sample of their rows again and compares
// bytes.
#include <fmt/chrono.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <thread>

#include "generators/checksum.hpp"
#include "generators/quantities.hpp"
#include "generators/sampler.hpp"

namespace {

using tribo::reference::Table;

struct Named {
  std::string file;
  std::function<Table()> table;
};
const std::vector<Named> tables = [] {
  std::vector<Named> all{
      {"effective_modulus.csv", tribo::reference::effective_moduli},
      {"reduced_radius.csv", tribo::reference::reduced_radii},
      {"gaussian_moment.csv", tribo::reference::gaussian_moments},
      {"load_sharing.csv", tribo::reference::load_sharing_roots},
      {"starvation_ratio.csv", tribo::reference::starvation_ratios},
      {"onset_constant.csv", tribo::reference::onset_constants},
      {"hertz_point.csv", tribo::reference::hertz_contacts},
      {"hertz_ellipse.csv", tribo::reference::elliptical_contact_values},
      {"hertz_line.csv", tribo::reference::line_contact_values},
      {"moes_line.csv", tribo::reference::moes_lines},
      {"regime_film.csv", tribo::reference::regime_films},
      {"gupta_thermal_reduction.csv", tribo::reference::thermal_reductions},
      {"dowson_higginson_density.csv", tribo::reference::densities},
      {"astm_d341_viscosity.csv", tribo::reference::temperature_viscosities},
      {"summits_from_spectral_moments.csv", tribo::reference::summits_of_moments},
      {"operating_point.csv", tribo::reference::operating_points}};
  for (const std::string law : {"barus_viscosity", "roelands_viscosity"})
    all.push_back({law + ".csv", [=] { return tribo::reference::pressure_viscosities(law); }});
  for (const std::string& law : tribo::reference::film_laws())
    all.push_back({law + ".csv", [=] { return tribo::reference::film_table(law); }});
  return all;
}();

std::string header_text(const tribo::reference::Header& h, const std::string& rows) {
  return fmt::format(
      "# quantity: {}\n# definition: {}\n# units: {}\n# domain: {}\n"
      "# generator: reference/generators, Arb {} at {} bits\n"
      "# digits: 40, enclosed to 133 bits or more; high + low are doubles, high the nearest\n"
      "# first method: {}\n# second method: {}; each row's enclosures overlap\n"
      "# condition: sum of |d ln value/d ln input|\n# date: {:%Y-%m-%d}\n# sha256 of the rows: "
      "{}\n{}\n",
      h.quantity, h.definition, h.units, h.domain, arb_version, tribo::reference::ball_precision,
      h.first_method, h.second_method, fmt::gmtime(std::time(nullptr)),
      tribo::reference::sha256(rows), h.columns);
}

// Groups of rows that share work (an operating point's outputs) stay on one thread: blocks of 9.
std::vector<std::string> make_rows(const Table& table, const std::string& file) {
  constexpr std::size_t block = 9;
  std::vector<std::string> lines(table.rows.size());
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> failed = false;
  const auto work = [&] {
    for (std::size_t start; (start = block * next++) < table.rows.size() && !failed;) {
      for (std::size_t i = start; i < std::min(start + block, table.rows.size()); ++i) try {
          lines[i] = line(table.rows[i]());
        } catch (const std::exception& error) {
          std::cerr << fmt::format("{}: {}\n", file, error.what());
          failed = true;
        }
      if (start % (64 * block) == 0)
        std::cerr << fmt::format("{}: {} of {} rows\n", file, start, table.rows.size());
    }
    flint_cleanup();
  };
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
    threads.emplace_back(work);
  for (std::thread& thread : threads) thread.join();
  if (failed) std::exit(1);
  return lines;
}

int make_tables(const std::filesystem::path& folder, const std::string& only) {
  for (const Named& named : tables) {
    if (!only.empty() && only != named.file) continue;
    const Table table = named.table();
    std::string rows;
    for (const std::string& line : make_rows(table, named.file)) rows += line + "\n";
    const auto temporary = folder / (named.file + ".part");
    std::ofstream(temporary) << header_text(table.header, rows) << rows;
    std::filesystem::rename(temporary, folder / named.file);
    std::cerr << fmt::format("{}: {} rows\n", named.file, table.rows.size());
  }
  return 0;
}

std::vector<std::string> committed_rows(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::vector<std::string> rows;
  std::string line;
  while (std::getline(in, line))
    if (!line.starts_with("#") && !line.starts_with("id,")) rows.push_back(line);
  return rows;
}

int check_sample(const std::filesystem::path& folder, std::uint64_t seed, int count) {
  int different = 0;
  for (const Named& named : tables) {
    const Table table = named.table();
    const std::vector<std::string> rows = committed_rows(folder / named.file);
    if (rows.size() != table.rows.size()) {
      std::cout << fmt::format("{}: {} rows, the generator makes {}\n", named.file, rows.size(),
                               table.rows.size());
      ++different;
      continue;
    }
    tribo::reference::Sampler sampler(seed);
    for (int i = 0; i < count; ++i) {
      const auto at =
          std::min(rows.size() - 1,
                   static_cast<std::size_t>(sampler.uniform(0, static_cast<double>(rows.size()))));
      const std::string again = line(table.rows[at]());
      if (again == rows[at]) continue;
      ++different;
      std::cout << fmt::format("{}:\n  committed {}\n  again     {}\n", named.file, rows[at],
                               again);
    }
    std::cout << fmt::format("{}: {} of {} rows made again\n", named.file, count, rows.size());
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
  app.add_option("--only", only, "make this file alone");
  app.add_option("--sample", sample, "make this many rows of each table again and compare bytes");
  app.add_option("--seed", seed, "of the sample");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return sample > 0 ? check_sample(folder, seed, sample) : make_tables(folder, only);
}
