// SPDX-License-Identifier: Apache-2.0
// Grids and memory that are estimated before a point contact is solved, against those it takes.
#include "ehl/point_needs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>

#include "support/judge.hpp"

namespace tribo::verification {
namespace {

// The greatest memory of this program so far, in bytes. getrusage() does not give it: its number
// also covers the process that started this one.
double greatest_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (double kibibytes = 0; word == "VmHWM:" && status >> kibibytes) return 1024 * kibibytes;
  ADD_FAILURE() << "/proc/self/status has no VmHWM";
  return 0;
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
            ehl::needs_of(ehl::barus_point(5, 5), {.greatest_nodes = 4'000'000}).most_grids);
}

// Above M = 200 the first grid has more cells than the inlet needs, 8(M/30)^0.38: with no more,
// three grids leave the least film an error of a tenth. With few nodes it has fewer cells again.
TEST(PointNeeds, BeginWithMoreCellsUnderHeavyLoadsWhereTheNodesLeaveThem) {
  const auto cells = [](double load, Eigen::Index nodes) {
    const ehl::PointContact contact = ehl::barus_point(load, 5);
    const ehl::PointNeeds needs = ehl::needs_of(contact, {.greatest_nodes = nodes});
    EXPECT_GE(needs.most_grids, 3) << load << ": " << needs.reason;
    return std::lround(ehl::reach_of(contact) / needs.coarsest.dx);
  };
  for (const double load : {50., 200., 700., 1100., 2000., 5000.}) {
    SCOPED_TRACE(testing::Message() << "M = " << load);
    const double least = 8 * std::pow(load / 30, 0.38);
    const double asked = least * std::fmax(1, std::pow(load / 200, 0.25));
    EXPECT_EQ(cells(load, 4'000'000), std::lround(std::ceil(asked)));
    EXPECT_GE(cells(load, 900'000), std::lround(std::ceil(least)));
    EXPECT_GE(cells(load, 280'000), std::lround(std::ceil(least)));
    if (load > 1500) {
      EXPECT_LT(cells(load, 280'000), asked);
    }
  }
}

// Where three grids leave too great an error, three finer ones follow, if the nodes allow them.
TEST(PointNeeds, MoreCellsFollowWhereTheNodesLeaveATenthMore) {
  const ehl::PointContact contact = ehl::barus_point(100, 5);
  const auto nodes = [&](int cells) { return 16 * ehl::grid_for(contact, cells).size(); };
  EXPECT_EQ(ehl::more_cells(contact, 20, {.greatest_nodes = nodes(30)}), 30);
  EXPECT_EQ(ehl::more_cells(contact, 20, {.greatest_nodes = nodes(30) - 1}), 29);
  EXPECT_EQ(ehl::more_cells(contact, 20, {.greatest_nodes = nodes(22)}), 22);
  EXPECT_EQ(ehl::more_cells(contact, 20, {.greatest_nodes = nodes(22) - 1}), 0);
}

// The error from the first grid's ends is 0.6 of the first tolerance, and 0.9 of the second.
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
    double megabytes;  // of 2^20 bytes, without the program's 22
  };
  for (const auto& [nodes, megabytes] : {Taken{232'609, 352},
                                         {300'713, 439},
                                         {409'665, 625},
                                         {616'113, 963},
                                         {628'353, 1026},
                                         {810'081, 1301}}) {
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
