// SPDX-License-Identifier: Apache-2.0
// The root of load sharing in double, one by one and in batches on each instruction set: to its
// contract, within its bounds and steps, and skipped where the bounds say, without harm.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <vector>

#include "accuracy/reference_table.hpp"
#include "support/instruction_sets.hpp"
#include "support/long_double.hpp"
#include "support/scenes.hpp"
#include "tribo/mixed_contact.hpp"

namespace tribo::verification {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::array models{AsperityModel::greenwood_tripp, AsperityModel::greenwood_williamson};

// Points of load sharing, as arrays.
struct Points {
  std::vector<double> stiffness, offset, flooded;

  void add(double k, double delta, double lambda0) {
    stiffness.push_back(k);
    offset.push_back(delta);
    flooded.push_back(lambda0);
  }
  std::size_t size() const { return flooded.size(); }
};

struct Roots {
  std::vector<double> film_parameter;
  SharingWork work;
};
Roots roots_of(AsperityModel model, const Points& points) {
  Roots roots{std::vector<double>(points.size()), {}};
  roots.work =
      film_parameter(model, points.stiffness, points.offset, points.flooded, roots.film_parameter);
  return roots;
}
Roots roots_of(const LoadSharing<double>& sharing, std::span<const double> flooded) {
  Roots roots{std::vector<double>(flooded.size()), {}};
  roots.work = film_parameter(sharing, flooded, roots.film_parameter);
  return roots;
}

std::string text(const Points& points, std::size_t i) {
  return describe(
      {{"K", points.stiffness[i]}, {"delta", points.offset[i]}, {"lambda0", points.flooded[i]}});
}

// Next to K F_p(−δ) = 1 the rounding of A may keep the kernels from an end: then it is Newton's.
bool is_critical(AsperityModel model, double k, double delta) {
  return std::fabs(k * gaussian_moment(load_order(model), -delta) - 1) < 1e-6;
}

// All ways to a root: `hold(root, i)` judges point i.
template <class Hold>
void find_in_all_ways(AsperityModel model, const Points& points, Hold&& hold) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double k = points.stiffness[i], delta = points.offset[i], lambda0 = points.flooded[i];
    hold(film_parameter(model, k, delta, lambda0), i, "of one point");
    const LoadShares<double> shares = LoadSharing<double>(model, k, delta).solve(lambda0);
    hold(shares.film_parameter, i, "with shares");
    const bool is_in_range = k >= 1e-300 && k <= 1e300 && lambda0 >= 1e-280 && lambda0 <= 1e280;
    const int most = is_in_range && !is_critical(model, k, delta) ? max_sharing_steps : 80;
    EXPECT_LE(shares.iterations, most) << text(points, i);
  }
  on_each_instruction_set([&] {
    const Roots many = roots_of(model, points);
    EXPECT_LE(many.work.steps, points.size() * max_sharing_steps);
    for (std::size_t i = 0; i < points.size(); ++i) {
      hold(many.film_parameter[i], i, "of many surfaces");
      const LoadSharing<double> surface(model, points.stiffness[i], points.offset[i]);
      hold(roots_of(surface, std::span(&points.flooded[i], 1)).film_parameter[0], i,
           "of one surface");
    }
  });
}

// All ways against long double, the contract, and the lower bound of every root.
void hold_against_long_double(AsperityModel model, const Points& points) {
  std::vector<LoadShares<long double>> truths;
  std::vector<long double> floors;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const LoadSharing<long double> sharing(model, static_cast<long double>(points.stiffness[i]),
                                           static_cast<long double>(points.offset[i]));
    truths.push_back(sharing.solve(static_cast<long double>(points.flooded[i])));
    floors.push_back(sharing.floor());
  }
  find_in_all_ways(model, points, [&](double got, std::size_t i, const char* which) {
    EXPECT_TRUE(
        is_root(got, model, points.stiffness[i], points.offset[i], points.flooded[i], truths[i]))
        << which;
    EXPECT_GE(got, points.flooded[i]) << which << text(points, i);
  });
}

double uniform_offset(Sampler& sampler) {
  return sampler.pick({0, 1, 1, 1}) * sampler.uniform(0, 10);
}

TEST(BatchRoot, KeepsItsContractOnTheCertifiedRows) {
  const auto rows = read_reference_table(TRIBOCHECK_SOURCE_DIR "/reference/exact/load_sharing.csv");
  for (const AsperityModel model : models) {
    Points points;
    std::vector<const ReferenceRow*> chosen;
    for (const ReferenceRow& row : rows) {
      if ((row.text("asperity") == "greenwood_tripp") != (model == AsperityModel::greenwood_tripp))
        continue;
      chosen.push_back(&row);
      points.add(row.number("stiffness"), row.number("offset"),
                 row.number("flooded_film_parameter"));
    }
    ASSERT_GT(points.size(), 100u);
    find_in_all_ways(model, points, [&](double got, std::size_t i, const char* which) {
      const double error = chosen[i]->error_in_ulp(got);
      const double allowed =
          std::max(load_sharing_contract.ulp, load_sharing_contract.ulp_per_condition *
                                                  std::max(1.0, chosen[i]->number("condition")));
      record_part_of_bound(error / allowed);
      EXPECT_LE(error, allowed) << chosen[i]->text("id") << ", " << which << text(points, i);
    });
  }
}

TEST(BatchRoot, KeepsItsContractOverAllSurfaces) {
  Sampler sampler(151);
  for (const AsperityModel model : models) {
    Points wide;
    for (int i = 0; i < 1500; ++i)
      wide.add(sampler.log_uniform(1e-6, 10), sampler.uniform(0, 3),
               sampler.log_uniform(1e-4, 100));
    hold_against_long_double(model, wide);
  }
}

TEST(BatchRoot, KeepsItsContractOverTheWholeRangeOfNumbers) {
  Sampler sampler(152);
  for (const AsperityModel model : models) {
    Points extreme;
    for (int i = 0; i < 1000; ++i) {
      extreme.add(sampler.log_uniform(1e-300, 1e300), uniform_offset(sampler),
                  sampler.log_uniform(1e-300, 1e300));
      // where a stiff surface carries the load
      extreme.add(sampler.log_uniform(1e-30, 1e300), uniform_offset(sampler),
                  sampler.log_uniform(1e-3, 60));
    }
    hold_against_long_double(model, extreme);
  }
}

TEST(BatchRoot, KeepsItsContractBesideACriticalStiffness) {
  Sampler sampler(153);
  for (const AsperityModel model : models) {
    Points critical;
    for (int i = 0; i < 1000; ++i) {
      const double delta = uniform_offset(sampler);
      const double away = 1 + sampler.pick({-1, 1}) * sampler.log_uniform(1e-16, 0.5);
      critical.add(away / gaussian_moment(load_order(model), -delta), delta,
                   sampler.log_uniform(1e-10, 100));
    }
    hold_against_long_double(model, critical);
  }
}

TEST(BatchRoot, KeepsItsContractBesideTheFloor) {
  Sampler sampler(154);
  for (const AsperityModel model : models) {
    Points beside;
    for (int i = 0; i < 1000; ++i) {
      const double k = sampler.log_uniform(0.5, 1e12), delta = uniform_offset(sampler);
      const double floor = LoadSharing<double>(model, k, delta).floor();
      if (floor > 0)
        beside.add(k, delta, floor * (1 + sampler.pick({-1, 1}) * sampler.log_uniform(1e-15, 0.3)));
    }
    ASSERT_GT(beside.size(), 300u);
    hold_against_long_double(model, beside);
  }
}

// Where fixed-point iteration, Newton on h − h₀(1−A)^−0.14 and unsplit d² fail.
TEST(BatchRoot, KeepsItsContractOnInputsThatBreakTheUsualWays) {
  constexpr std::array<std::array<double, 3>, 8> inputs{{{10, 1.146, 1e-4},
                                                         {10, 1.146, 1.9},
                                                         {10, 1.146, 2.1},
                                                         {0.30652, 1.146, 0.00776499},
                                                         {0.303626, 1.146, 0.00175},
                                                         {1e6, 1.146, 4.5},
                                                         {1e300, 1.146, 30},
                                                         {1e300, 0, 37.3}}};
  for (const AsperityModel model : models) {
    Points points;
    for (const auto& [k, delta, lambda0] : inputs)
      for (const double factor : {1.0, 1 - 0x1p-53, 1 + 0x1p-52, 0.999, 1.001})
        points.add(k, delta, lambda0 * factor);
    for (const double delta : {0.0, 1.146, 8.0})
      for (const double lambda0 : {1e-12, 1e-4, 0.1, 1.0, 3.0}) {
        const double critical = 1 / gaussian_moment(load_order(model), -delta);
        for (const double k : {critical, std::nextafter(critical, 0.0), critical * (1 + 1e-15)})
          points.add(k, delta, lambda0);
      }
    hold_against_long_double(model, points);
  }
}

// One surface with many λ₀, in the order in which a curve asks for them and at random.
TEST(BatchRoot, OfOneSurfaceKeepsItsContract) {
  Sampler sampler(155);
  std::vector<std::array<double, 2>> surfaces{{0.3, 1.146}, {10, 1.146}, {1e-3, 0},      {1e9, 4},
                                              {1e300, 0},   {1e-300, 2}, {0.3036, 1.146}};
  for (int i = 0; i < 15; ++i)
    surfaces.push_back({sampler.log_uniform(1e-6, 1e3), uniform_offset(sampler)});
  for (const AsperityModel model : models)
    for (const auto& [k, delta] : surfaces) {
      const LoadSharing<double> surface(model, k, delta);
      const LoadSharing<long double> exact(model, static_cast<long double>(k),
                                           static_cast<long double>(delta));
      std::vector<double> flooded;
      for (double lambda0 = 1e-4; lambda0 < 100; lambda0 *= 1.25) flooded.push_back(lambda0);
      for (int i = 0; i < 100; ++i) flooded.push_back(sampler.log_uniform(1e-6, 60));
      std::vector<LoadShares<long double>> truths;
      for (const double lambda0 : flooded)
        truths.push_back(exact.solve(static_cast<long double>(lambda0)));
      on_each_instruction_set([&, k = k, delta = delta] {
        const Roots got = roots_of(surface, flooded);
        EXPECT_EQ(got.work.by_newton, 0u);
        for (std::size_t i = 0; i < flooded.size(); ++i) {
          EXPECT_TRUE(is_root(got.film_parameter[i], model, k, delta, flooded[i], truths[i]));
          EXPECT_GE(got.film_parameter[i], std::max(flooded[i], surface.floor()));
        }
      });
    }
}

// g = ln λ − ln λ₀ + 0.14 ln(1 − A) is negative left of the root and positive right of it; no other
// point has that.
TEST(BatchRoot, TheResidualChangesItsSignAcrossIt) {
  Sampler sampler(156);
  for (const AsperityModel model : models) {
    Points points;
    for (int i = 0; i < 1500; ++i)
      points.add(sampler.log_uniform(1e-6, 1e6), sampler.uniform(0, 5),
                 sampler.log_uniform(1e-4, 50));
    on_each_instruction_set([&] {
      const Roots roots = roots_of(model, points);
      for (std::size_t i = 0; i < points.size(); ++i) {
        const auto offset = static_cast<long double>(points.offset[i]);
        const LoadSharing<long double> sharing(model, static_cast<long double>(points.stiffness[i]),
                                               offset);
        const long double lambda = roots.film_parameter[i];
        const long double share = sharing.asperity_share(lambda);
        const double condition =
            root_condition(model, offset, {lambda, share, std::max(1 - share, 1e-19L), 0});
        const long double width =
            0x1p-52L * std::max(load_sharing_contract.ulp,
                                load_sharing_contract.ulp_per_condition * condition);
        const auto residual = [&](long double x) {
          const long double at = sharing.asperity_share(x);
          return at >= 1 ? -infinity
                         : std::log(x / static_cast<long double>(points.flooded[i])) +
                               0.14L * std::log1p(-at);
        };
        EXPECT_LT(residual(lambda * (1 - width)), 0) << text(points, i);
        EXPECT_GT(residual(lambda * (1 + width)), 0) << text(points, i);
      }
    });
  }
}

// Steps are few, and Newton's method is not needed where anybody computes.
TEST(BatchRoot, TakesFewStepsAndNoneOfNewtons) {
  Sampler sampler(157);
  for (const AsperityModel model : models) {
    Points wide;
    for (int i = 0; i < 100000; ++i)
      wide.add(sampler.log_uniform(1e-6, 10), sampler.uniform(0, 4),
               sampler.log_uniform(1e-4, 100));
    const LoadSharing<double> surface(model, 0.3, 1.146);
    on_each_instruction_set([&] {
      const Roots many = roots_of(model, wide);
      const Roots one = roots_of(surface, wide.flooded);
      for (const SharingWork& work : {many.work, one.work}) {
        EXPECT_EQ(work.by_newton, 0u);
        EXPECT_LE(work.steps, 3 * wide.size());
      }
      EXPECT_GE(many.work.steps, wide.size() / 2);
    });
  }
}

TEST(BatchRoot, IsRarelyLeftToNewtonsMethodWithinTheRangeOfTheKernels) {
  Sampler sampler(158);
  for (const AsperityModel model : models) {
    Points inside, critical, outside;
    for (int i = 0; i < 50000; ++i) {
      const double k = sampler.log_uniform(1e-300, 1e300);
      const double delta = sampler.uniform(0, 10);
      inside.add(k, delta, sampler.log_uniform(1e-279, 1e279));
      inside.add(k, delta, sampler.log_uniform(1e-3, 40));
      critical.add(1 / gaussian_moment(load_order(model), -delta) *
                       (1 + sampler.pick({-1, 1}) * sampler.log_uniform(1e-16, 0.1)),
                   delta, sampler.log_uniform(1e-12, 10));
    }
    for (int i = 0; i < 500; ++i) {
      outside.add(sampler.log_uniform(1e-3, 1e3), 1, sampler.log_uniform(1e-300, 1e-281));
      outside.add(sampler.log_uniform(1e-3, 1e3), 1, sampler.log_uniform(1e281, 1e300));
      outside.add(sampler.log_uniform(1e-3, 1e3), sampler.uniform(40.1, 1e3), 1);
      outside.add(sampler.log_uniform(1e-307, 1e-301), 1, sampler.log_uniform(1e-3, 1e3));
      outside.add(sampler.log_uniform(1e301, 1e307), 1, sampler.log_uniform(1e-3, 1e3));
    }
    on_each_instruction_set([&] {
      EXPECT_LE(roots_of(model, inside).work.by_newton, inside.size() / 1000);
      EXPECT_LE(roots_of(model, critical).work.by_newton, critical.size() / 100);
      const Roots beyond = roots_of(model, outside);
      EXPECT_EQ(beyond.work.by_newton, outside.size());
      EXPECT_EQ(beyond.work.steps, 0u);
      for (std::size_t i = 0; i < outside.size(); ++i)
        EXPECT_EQ(beyond.film_parameter[i],
                  LoadSharing<double>(model, outside.stiffness[i], outside.offset[i])
                      .film_parameter(outside.flooded[i]))
            << text(outside, i);
    });
  }
}

// λ = λ₀ to half an ulp from film_from on, and no step is taken there.
TEST(BatchRoot, IsTheFilmItselfWhereTheBoundSaysSo) {
  Sampler sampler(159);
  for (const AsperityModel model : models) {
    Points points;
    for (int i = 0; i < 1000; ++i) {
      const double k = sampler.pick({0, 1, 1}) == 0 ? sampler.log_uniform(1e-300, 1e300)
                                                    : sampler.log_uniform(1e-40, 1e10);
      const double delta = uniform_offset(sampler);
      const double from = LoadSharing<double>(model, k, delta).surface().film_from;
      if (!(from > 1e-3)) continue;
      const double lambda0 = from * (1 + sampler.log_uniform(1e-14, 0.5));
      points.add(k, delta, lambda0);
      const long double root = LoadSharing<long double>(model, static_cast<long double>(k),
                                                        static_cast<long double>(delta))
                                   .solve(static_cast<long double>(lambda0))
                                   .film_parameter;
      EXPECT_TRUE(is_within_ulp(lambda0, root, 0.5, {{"K", k}, {"delta", delta}}));
      const LoadSharing<double> surface(model, k, delta);
      const LoadShares<double> shares = surface.solve(lambda0);
      EXPECT_EQ(shares.film_parameter, lambda0);
      EXPECT_EQ(shares.iterations, 0);
      EXPECT_EQ(film_parameter(model, k, delta, lambda0), lambda0);
    }
    on_each_instruction_set([&] {
      const Roots many = roots_of(model, points);
      EXPECT_EQ(many.work.steps, 0u);
      EXPECT_EQ(many.film_parameter, points.flooded);
      for (std::size_t i = 0; i < points.size(); i += 10) {
        const LoadSharing<double> surface(model, points.stiffness[i], points.offset[i]);
        const Roots one = roots_of(surface, std::span(&points.flooded[i], 1));
        EXPECT_EQ(one.work.steps, 0u);
        EXPECT_EQ(one.film_parameter[0], points.flooded[i]);
      }
    });
  }
}

// λ = λ_b to half an ulp up to floor_up_to, beside the floor's own error; no step is taken there.
TEST(BatchRoot, IsTheFloorWhereTheBoundSaysSo) {
  Sampler sampler(160);
  std::size_t far_up = 0;
  for (const AsperityModel model : models)
    for (int i = 0; i < 1000; ++i) {
      const double k = sampler.log_uniform(0.1, 1e300), delta = uniform_offset(sampler);
      const LoadSharing<double> surface(model, k, delta);
      if (!(surface.floor() > 0)) continue;
      const double up_to = surface.surface().floor_up_to;
      far_up += up_to > 1e-3 * surface.floor() ? 1 : 0;
      const std::vector<double> flooded{up_to * (1 - sampler.log_uniform(1e-15, 0.9)), up_to,
                                        1e-279};
      const LoadSharing<long double> exact(model, static_cast<long double>(k),
                                           static_cast<long double>(delta));
      for (const double lambda0 : flooded) {
        const long double root = exact.solve(static_cast<long double>(lambda0)).film_parameter;
        const long double rise = (root - exact.floor()) / exact.floor();
        record_part_of_bound(static_cast<double>(rise / 0x1p-54L));
        EXPECT_LE(rise, 0x1p-54L) << describe({{"K", k}, {"delta", delta}, {"lambda0", lambda0}});
        const LoadShares<double> shares = surface.solve(lambda0);
        EXPECT_EQ(shares.film_parameter, surface.floor());
        EXPECT_EQ(shares.iterations, 0);
      }
      on_each_instruction_set([&] {
        const Roots one = roots_of(surface, flooded);
        EXPECT_EQ(one.work.steps, 0u);
        EXPECT_EQ(one.film_parameter, std::vector<double>(flooded.size(), surface.floor()));
      });
    }
  EXPECT_GT(far_up, 500u);
}

// Beside one another: roots of one step and of many, skipped ones, and what is left to Newton.
Points mixed_points(std::size_t count) {
  Sampler sampler(161);
  Points points;
  while (points.size() < count) {
    points.add(sampler.log_uniform(1e-6, 10), sampler.uniform(0, 3),
               sampler.log_uniform(1e-4, 100));
    points.add(sampler.log_uniform(1, 1e6), sampler.uniform(0, 3), sampler.log_uniform(1e-6, 3));
    points.add(0.3036, 1.146, sampler.log_uniform(1e-6, 1));
    points.add(0.3, 1.146, sampler.pick({1e-290, 50.0, infinity, 1e285, 3.0, 0.0}));
  }
  return points;
}

TEST(BatchRoot, BitsDoNotDependOnPlaceOrSize) {
  const Points points = mixed_points(64);
  const auto part = [](const std::vector<double>& all, std::size_t first, std::size_t count) {
    return std::span<const double>(all).subspan(first, count);
  };
  const LoadSharing<double> surface(AsperityModel::greenwood_tripp, 1.5, 1.146);
  on_each_instruction_set([&] {
    for (const AsperityModel model : models)
      hold_bits_whatever_place_and_size(
          points.size(), [&](std::size_t first, std::size_t count, std::span<double> result) {
            film_parameter(model, part(points.stiffness, first, count),
                           part(points.offset, first, count), part(points.flooded, first, count),
                           result);
          });
    hold_bits_whatever_place_and_size(
        points.size(), [&](std::size_t first, std::size_t count, std::span<double> result) {
          film_parameter(surface, part(points.flooded, first, count), result);
        });
  });
}

// Beyond one block of the batch, and its edges.
TEST(BatchRoot, BitsAndWorkDoNotDependOnTheBlocks) {
  const Points points = mixed_points(2100);
  const LoadSharing<double> surface(AsperityModel::greenwood_tripp, 1.5, 1.146);
  on_each_instruction_set([&] {
    const Roots many = roots_of(AsperityModel::greenwood_tripp, points);
    const Roots one = roots_of(surface, points.flooded);
    for (const std::size_t size : {1, 7, 511, 512, 513, 1025}) {
      std::vector<double> lambda(points.size()), of_one(points.size());
      SharingWork work, work_of_one;
      for (std::size_t first = 0; first < points.size(); first += size) {
        const std::size_t count = std::min(size, points.size() - first);
        const auto part = [&](const std::vector<double>& all) {
          return std::span<const double>(all).subspan(first, count);
        };
        const SharingWork some = film_parameter(
            AsperityModel::greenwood_tripp, part(points.stiffness), part(points.offset),
            part(points.flooded), std::span(lambda).subspan(first, count));
        const SharingWork some_of_one =
            film_parameter(surface, part(points.flooded), std::span(of_one).subspan(first, count));
        work = {work.steps + some.steps, work.by_newton + some.by_newton};
        work_of_one = {work_of_one.steps + some_of_one.steps,
                       work_of_one.by_newton + some_of_one.by_newton};
      }
      EXPECT_EQ(lambda, many.film_parameter) << size;
      EXPECT_EQ(of_one, one.film_parameter) << size;
      EXPECT_EQ(work.steps, many.work.steps) << size;
      EXPECT_EQ(work.by_newton, many.work.by_newton) << size;
      EXPECT_EQ(work_of_one.steps, one.work.steps) << size;
      EXPECT_EQ(work_of_one.by_newton, one.work.by_newton) << size;
    }
  });
}

TEST(BatchRoot, TheResultMayOverwriteAnArgument) {
  const Points points = mixed_points(1200);
  const LoadSharing<double> surface(AsperityModel::greenwood_tripp, 1.5, 1.146);
  on_each_instruction_set([&] {
    for (const AsperityModel model : models) {
      const std::vector<double> apart = roots_of(model, points).film_parameter;
      Points over = points;
      film_parameter(model, over.stiffness, over.offset, over.flooded, over.flooded);
      EXPECT_EQ(over.flooded, apart);
      over = points;
      film_parameter(model, over.stiffness, over.offset, over.flooded, over.stiffness);
      EXPECT_EQ(over.stiffness, apart);
      over = points;
      film_parameter(model, over.stiffness, over.offset, over.flooded, over.offset);
      EXPECT_EQ(over.offset, apart);
    }
    std::vector<double> over = points.flooded;
    film_parameter(surface, over, over);
    EXPECT_EQ(over, roots_of(surface, points.flooded).film_parameter);
  });
}

TEST(BatchRoot, OfWhatIsNoOrdinaryNumberIsWhatTheContractSays) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> flooded{1, infinity, nan, 0, 5e-324, 1e-310, 1e300, 2};
  on_each_instruction_set([&] {
    for (const AsperityModel model : models)
      for (const double k : {0.0, 5e-324, 0.1, 10.0, 1e308, infinity, nan})
        for (const double delta : {0.0, 1.146, 39.9, 41.0, 1e10}) {
          const LoadSharing<double> surface(model, k, delta);
          Points points;
          for (const double lambda0 : flooded) points.add(k, delta, lambda0);
          const Roots many = roots_of(model, points);
          const Roots one = roots_of(surface, flooded);
          for (std::size_t i = 0; i < flooded.size(); ++i) {
            const double expected = surface.solve(flooded[i]).film_parameter;
            for (const double got : {many.film_parameter[i], one.film_parameter[i],
                                     film_parameter(model, k, delta, flooded[i])}) {
              if (std::isnan(expected)) {
                EXPECT_NE(got, got) << text(points, i);
              } else if (!std::isfinite(expected) || expected == 0) {
                EXPECT_EQ(got, expected) << text(points, i);
              } else {
                EXPECT_GE(got, std::max(flooded[i], surface.floor() * (1 - 1e-12)))
                    << text(points, i);
                EXPECT_LT(got, infinity) << text(points, i);
              }
            }
          }
        }
  });
}

}  // namespace
}  // namespace tribo::verification
