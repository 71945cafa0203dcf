// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "contenders/line_film_ways.hpp"
#include "ehl/line_contact.hpp"
#include "ehl/solved_film.hpp"
#include "work_precision/measures.hpp"

namespace tribo::benchmarks {
namespace {

constexpr double slow = 3;  // seconds: a slower pass is not repeated

struct RelativeErrors {
  double greatest = 0, sum = 0;
  int numbers = 0, no_numbers = 0, steps = 0;

  void add(double got, double exact) {
    if (!std::isfinite(got)) {
      ++no_numbers;
      return;
    }
    ++numbers;
    const double error = std::fabs(got / exact - 1);
    greatest = std::fmax(greatest, error);
    sum += error;
  }
};

template <class Contact>
RelativeErrors judge(const FilmWay<Contact>& way,
                     const std::vector<JudgedFilm<Contact>>& contacts) {
  RelativeErrors errors;
  for (const JudgedFilm<Contact>& one : contacts) {
    // The formulas are for liquids whose viscosity rises with pressure.
    if (way.quantity != nullptr && one.contact.material_number == 0) continue;
    const FilmAnswer answer = way.run(one.contact);
    errors.steps += answer.steps;
    if (way.quantity != nullptr) {
      errors.add(answer.*way.quantity, one.exact.*way.quantity);
      continue;
    }
    errors.add(answer.central, one.exact.central);
    errors.add(answer.minimum, one.exact.minimum);
  }
  return errors;
}

}  // namespace

std::vector<JudgedFilm<ehl::LineContact>> judged_contacts(double tolerance) {
  std::vector<JudgedFilm<ehl::LineContact>> all;
  for (const auto& [load_number, material_number] :
       {std::pair{1., 0.}, {10., 5.}, {100., 10.}, {200., 20.}}) {
    const ehl::LineContact contact = ehl::barus_contact(load_number, material_number);
    const ehl::SolvedFilm solved =
        ehl::solve_line_film(contact, {.tolerance = tolerance, .greatest_cells = 16384});
    if (solved.outcome != ehl::Outcome::solved) throw std::runtime_error(solved.reason);
    all.push_back({contact, film_numbers(contact, solved)});
  }
  return all;
}

template <class Contact>
Rows film_errors(const std::string& job, const std::vector<FilmWay<Contact>>& ways,
                 const std::vector<JudgedFilm<Contact>>& contacts, const Effort& effort) {
  std::vector<RelativeErrors> errors;
  std::vector<double> seconds;
  std::vector<Timed> timed;
  std::vector<std::size_t> repeated;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const double start = cpu_seconds();
    errors.push_back(judge(ways[i], contacts));
    seconds.push_back(cpu_seconds() - start);
    if (seconds.back() > slow) continue;
    repeated.push_back(i);
    timed.push_back({[&, i] {
      for (const JudgedFilm<Contact>& one : contacts) ways[i].run(one.contact);
    }});
  }
  const std::vector<double> medians =
      median_seconds(timed, std::min(effort.rounds, 3), effort.least_seconds);
  for (std::size_t i = 0; i < repeated.size(); ++i) seconds[repeated[i]] = medians[i];

  Rows rows;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const RelativeErrors& found = errors[i];
    const bool is_formula = ways[i].quantity != nullptr;
    nlohmann::ordered_json greatest, mean, steps;
    if (found.numbers > 0) {
      greatest = four_digits(found.greatest);
      mean = four_digits(found.sum / found.numbers);
    }
    if (!is_formula)
      steps = four_digits(static_cast<double>(found.steps) / static_cast<double>(contacts.size()));
    rows.push_back({{"job", job},
                    {"family", ways[i].family},
                    {"series", ways[i].series},
                    {"name", ways[i].name},
                    {"ns", four_digits(1e9 * seconds[i] / static_cast<double>(contacts.size()))},
                    {"steps", steps},
                    {"max_relative", greatest},
                    {"mean_relative", mean},
                    {"no_numbers", found.no_numbers},
                    {"judged", found.numbers + found.no_numbers}});
  }
  return rows;
}

template Rows film_errors(const std::string&, const std::vector<FilmWay<ehl::LineContact>>&,
                          const std::vector<JudgedFilm<ehl::LineContact>>&, const Effort&);
template Rows film_errors(const std::string&, const std::vector<FilmWay<ehl::PointContact>>&,
                          const std::vector<JudgedFilm<ehl::PointContact>>&, const Effort&);

}  // namespace tribo::benchmarks
