// SPDX-License-Identifier: Apache-2.0
// Ways to the film of a line contact: ways that solve the same equations on the same grid agree,
// and the others have their known errors.
#include "contenders/line_film_ways.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "contenders/dense_line_film.hpp"
#include "ehl/line_contact.hpp"

namespace tribo::benchmarks {
namespace {

FilmAnswer answer_of(const std::string& name, const ehl::LineContact& contact) {
  for (const LineFilmWay& way : line_film_ways())
    if (way.name == name) return way.run(contact);
  ADD_FAILURE() << name << " is no way";
  return {};
}

double apart(double a, double b) { return std::fabs(a / b - 1); }

TEST(LineFilmWays, OfOneGridGiveOneFilm) {
  for (const double material_number : {0., 5., 10.}) {
    const ehl::LineContact contact = ehl::barus_contact(10, material_number);
    const FilmAnswer ours = answer_of("one grid 256", contact);
    const FilmAnswer dense = answer_of("dense LU, our grid 256", contact);
    EXPECT_LT(apart(dense.central, ours.central), 1e-7);
    EXPECT_LT(apart(dense.minimum, ours.minimum), 1e-7);
    EXPECT_LT(apart(dense.at_greatest_pressure, ours.at_greatest_pressure), 1e-7);
  }
}

TEST(LineFilmWays, OfDenseMatricesKeepTwoOfAllNodes) {
  const ehl::LineContact contact = ehl::barus_contact(10, 5);
  for (const int cells : {64, 128}) {
    const ehl::Numbers x = coarse_film(contact).density.nodes(cells);
    EXPECT_EQ(DenseNewton(contact, x).bytes(), 2 * sizeof(double) * x.size() * x.size());
  }
}

TEST(LineFilmWays, AreOffByWhatIsKnown) {
  const ehl::LineContact contact = ehl::barus_contact(10, 5);
  const FilmAnswer solved = answer_of("to 1e-04", contact);
  EXPECT_LT(apart(answer_of("one grid 1024", contact).central, solved.central), 1e-3);
  EXPECT_LT(apart(answer_of("dense LU, uniform grid 1024", contact).central, solved.central), 0.02);
  EXPECT_LT(
      apart(answer_of("moes_line", contact).at_greatest_pressure, solved.at_greatest_pressure),
      0.03);
  EXPECT_GT(apart(answer_of("pan_hamrock_central", contact).central, solved.central), 0.1);
}

TEST(LineFilmWays, FormulasGiveOneNumberAndNoneOfConstantViscosity) {
  for (const LineFilmWay& way : line_film_ways()) {
    if (way.quantity == nullptr) continue;
    EXPECT_TRUE(std::isnan(way.run(ehl::barus_contact(10, 0)).*way.quantity)) << way.name;
    EXPECT_GT(way.run(ehl::barus_contact(10, 5)).*way.quantity, 1) << way.name;
  }
}

}  // namespace
}  // namespace tribo::benchmarks
