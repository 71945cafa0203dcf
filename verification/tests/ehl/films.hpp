// SPDX-License-Identifier: Apache-2.0
// Contacts for the tests of films, and the check whether an estimate holds the truth.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "ehl/film_conditions.hpp"
#include "ehl/solved_film.hpp"
#include "sampling/sampler.hpp"
#include "support/judge.hpp"

namespace tribo::verification {

// A Barus liquid, a Roelands liquid with Hertz' peak p₀ = 0.98 GPa, and a compressible Barus liquid
// with p₀ = 0.59 GPa.
inline std::array<ehl::LineContact, 3> three_liquids(double load_number, double material_number) {
  std::array<ehl::LineContact, 3> contacts;
  contacts.fill(ehl::barus_contact(load_number, material_number));
  contacts[1].fluid.roelands_pressure = 5;
  contacts[1].fluid.roelands_index = 0.6;
  contacts[2].fluid.density_pressure = 1;
  return contacts;
}

// Contacts of soft and of stiff bodies. Each number is drawn from a wide range.
inline ehl::FilmConditions random_conditions(Sampler& sampler) {
  return {.speed = sampler.log_uniform(1e-3, 50),
          .viscosity = sampler.log_uniform(1e-3, 1),
          .pressure_viscosity = sampler.log_uniform(1e-9, 4e-8),
          .load = sampler.log_uniform(1e3, 1e6),
          .effective_modulus = sampler.log_uniform(1e9, 3e11),
          .radius = sampler.log_uniform(1e-3, 1)};
}

// Does the truth lie within the estimate's error, widened by the uncertainty of the truth?
inline testing::AssertionResult is_estimated(const ehl::Estimate& got, double truth,
                                             double uncertainty) {
  const double off = std::abs(got.value - truth), bound = got.error + uncertainty;
  record_part_of_bound(off / bound);
  if (off <= bound) return testing::AssertionSuccess();
  return testing::AssertionFailure() << fmt::format(
             "\n  expected {:.10g} ± {:.2g}\n  got      {:.10g} ± {:.2g}, off by {:.3g}, {:.3g} "
             "times the bound",
             truth, uncertainty, got.value, got.error, off, off / bound);
}

inline ehl::SolvedFilm solved(const ehl::LineContact& contact,
                              const ehl::SolveOptions& options = {}) {
  ehl::SolvedFilm film = ehl::solve_line_film(contact, options);
  EXPECT_EQ(film.outcome, ehl::Outcome::solved)
      << "M = " << contact.load_number << ", L = " << contact.material_number << ": "
      << film.reason;
  return film;
}

}  // namespace tribo::verification
