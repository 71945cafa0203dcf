// SPDX-License-Identifier: Apache-2.0
// The needs of a point contact that are told before it is solved, against those of its solution.
#include "ehl/point_needs.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>

#include "support/judge.hpp"

namespace tribo::verification {
namespace {

// Bytes, of this process, at most at any time until now.
double greatest_memory() {
  rusage used{};
  EXPECT_EQ(getrusage(RUSAGE_SELF, &used), 0);
  return 1024 * static_cast<double>(used.ru_maxrss);
}

TEST(PointNeeds, AreTheGridsAndTheMemoryThatTheSolutionTakes) {
  const ehl::PointContact contact = ehl::barus_point(100, 5);
  const ehl::PointNeeds needs = ehl::needs_of(contact);
  const double before = greatest_memory();
  const ehl::SolvedPoint solved = ehl::solve_point_film(contact, {.tolerance = 1e-2});
  const double taken = greatest_memory() - before;
  ASSERT_EQ(solved.outcome, ehl::Outcome::solved) << solved.reason;
  EXPECT_TRUE(needs.reason.empty());
  EXPECT_EQ(solved.grids, needs.least_grids);
  const ehl::PlaneGrid finest = needs.finest(needs.least_grids);
  EXPECT_EQ(solved.film.grid.count_x(), finest.count_x());
  EXPECT_EQ(solved.film.grid.count_y(), finest.count_y());
  const double told = ehl::point_memory(finest.size());
  EXPECT_TRUE(is_within(taken, told, 0.2 * told)) << taken << " bytes";
}

TEST(PointNeeds, MostGridsAreThoseThatTheNodesLeave) {
  const ehl::PointOptions options;
  for (const double load : {5., 100., 2000.}) {
    const ehl::PointNeeds needs = ehl::needs_of(ehl::barus_point(load, 5));
    EXPECT_LE(needs.finest(needs.most_grids).size(), needs.most_nodes) << load;
    EXPECT_LE(needs.most_nodes, options.greatest_nodes) << load;
    EXPECT_GT(needs.finest(needs.most_grids + 1).size(), options.greatest_nodes) << load;
  }
  EXPECT_LT(ehl::needs_of(ehl::barus_point(5, 5)).most_grids,
            ehl::needs_of(ehl::barus_point(5, 5), {.greatest_nodes = 2'000'000}).most_grids);
}

// Three grids leave the least film of heavy contacts unknown to a tenth.
TEST(PointNeeds, LeaveFourGridsUpToTheGreatestLoadsOfTheTable) {
  for (const double load : {200., 700., 1000., 1100., 1300., 1600., 2000.}) {
    EXPECT_GE(ehl::needs_of(ehl::barus_point(load, 5)).most_grids, 4) << load;
    // Cells are not made so large that the inlet is not resolved.
    EXPECT_EQ(ehl::needs_of(ehl::barus_point(load, 5), {.greatest_nodes = 160'000}).most_grids,
              load < 400 ? 4 : 3)
        << load;
  }
}

// The ends of the first grid take 0.6 of one tolerance, and 0.9 of the other.
TEST(PointNeeds, HoldAGridThatIsMadeLongerWhereItsEndsTakeTooMuch) {
  const ehl::PointContact contact = ehl::barus_point(50, 3, 8);
  for (const double tolerance : {3e-3, 2e-3}) {
    SCOPED_TRACE(testing::Message() << "to a tolerance of " << tolerance);
    const ehl::PointOptions options{.tolerance = tolerance};
    const ehl::SolvedPoint solved = ehl::solve_point_film(contact, options);
    const ehl::PointNeeds needs = ehl::needs_of(contact, options);
    EXPECT_EQ(solved.reason, "");
    EXPECT_LE(solved.domain_error, 0.8 * tolerance);
    EXPECT_LE(solved.film.grid.size(), needs.most_nodes);
    const int first = needs.finest(solved.grids).count_x();
    if (tolerance < 3e-3)
      EXPECT_GT(solved.film.grid.count_x(), first);
    else
      EXPECT_EQ(solved.film.grid.count_x(), first);
  }
}

// Contacts of `make point-survey` that took the most memory for their nodes.
TEST(PointNeeds, TellAtLeastTheMemoryThatTheSurveyTook) {
  struct Taken {
    Eigen::Index nodes;
    double megabytes;  // without the 22 of the program
  };
  for (const auto& [nodes, megabytes] :
       {Taken{87'153, 199}, {202'993, 768}, {249'865, 970}, {313'281, 1220}, {392'977, 1572}}) {
    const double told = ehl::point_memory(nodes) / 0x1p20;
    EXPECT_GT(told, megabytes) << nodes << " nodes";
    EXPECT_LT(told, 1.2 * megabytes) << nodes << " nodes";
  }
}

TEST(PointNeeds, SayWhyAContactIsRefused) {
  EXPECT_NE(ehl::needs_of(ehl::barus_point(0.99, 0)).reason.find("M = 0.99 is below 1"),
            std::string::npos);
  EXPECT_NE(ehl::needs_of(ehl::barus_point(20, 5), {.greatest_nodes = 4000})
                .reason.find("an error needs three grids"),
            std::string::npos);
}

}  // namespace
}  // namespace tribo::verification
