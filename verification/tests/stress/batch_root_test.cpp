// SPDX-License-Identifier: Apache-2.0
// Batches of roots of load sharing on each instruction set: few steps, steps skipped without harm
// where the bounds allow it, and the same bits at any place of a batch of any size.
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "support/condition.hpp"
#include "support/film_laws.hpp"
#include "support/instruction_sets.hpp"
#include "support/scenes.hpp"
#include "support/threshold.hpp"
#include "tribo/mixed_contact.hpp"

namespace tribo::verification {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

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
Roots roots_of(AsperityModel model, const Points& points,
               const FilmLaw& film = hamrock_dowson_central_law) {
  Roots roots{std::vector<double>(points.size()), {}};
  roots.work = film_parameter(model, points.stiffness, points.offset, points.flooded,
                              roots.film_parameter, film);
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

// The film parameter by the templates in long double.
long double exact_root(AsperityModel model, double k, double delta, double lambda0,
                       const FilmLaw& film = hamrock_dowson_central_law) {
  return LoadSharing<long double>(model, static_cast<long double>(k),
                                  static_cast<long double>(delta), film)
      .solve(static_cast<long double>(lambda0))
      .film_parameter;
}

double uniform_offset(Sampler& sampler) {
  return sampler.pick({0, 1, 1, 1}) * sampler.uniform(0, 10);
}

// Batches of one surface and of many surfaces. The contract test has single roots of each law.
TEST(BatchRoot, KeepsItsContractWithOtherFilmLaws) {
  Sampler sampler(77);
  for (const FilmLaw* const film : other_film_laws)
    for (const AsperityModel model : asperity_models) {
      Points points;
      for (int i = 0; i < 300; ++i)
        points.add(sampler.log_uniform(1e-6, 100), sampler.uniform(0, 4),
                   sampler.log_uniform(1e-6, 100));
      for (int i = 0; i < 100; ++i) {  // points near film_from and floor_up_to
        const double k = sampler.log_uniform(1, 1e20), delta = sampler.uniform(0, 4);
        const auto surface = LoadSharing<double>(model, k, delta, *film).surface();
        points.add(
            k, delta,
            sampler.uniform(0.95, 1.05) * (i % 2 == 0 ? surface.film_from : surface.floor_up_to));
      }
      std::vector<Reference> roots;
      std::vector<double> allowed;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const double k = points.stiffness[i], delta = points.offset[i], film0 = points.flooded[i];
        roots.emplace_back(exact_root(model, k, delta, film0, *film));
        allowed.push_back(allowed_by(load_sharing_contract, roots[i],
                                     root_condition(model, k, delta, film0, *film), 1));
      }
      on_each_instruction_set([&] {
        const Roots many = roots_of(model, points, *film);
        for (std::size_t i = 0; i < points.size(); ++i) {
          const LoadSharing<double> surface(model, points.stiffness[i], points.offset[i], *film);
          const double one = roots_of(surface, std::span(&points.flooded[i], 1)).film_parameter[0];
          for (const double got : {many.film_parameter[i], one})
            EXPECT_TRUE(is_close(got, roots[i], allowed[i],
                                 {{"a - b", film->sharing_power.value},
                                  {"K", points.stiffness[i]},
                                  {"delta", points.offset[i]},
                                  {"lambda0", points.flooded[i]}}));
        }
      });
    }
}

// Points in the usual ranges take few steps and never need Newton's method.
TEST(BatchRoot, TakesFewStepsAndNoneOfNewtons) {
  Sampler sampler(157);
  for (const AsperityModel model : asperity_models) {
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
  for (const AsperityModel model : asperity_models) {
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
      for (std::size_t i = 0; i < outside.size(); ++i) {
        const double k = outside.stiffness[i], delta = outside.offset[i];
        const double film0 = outside.flooded[i], got = beyond.film_parameter[i];
        EXPECT_EQ(got, LoadSharing<double>(model, k, delta).film_parameter(film0))
            << text(outside, i);
        const Reference root(exact_root(model, k, delta, film0));
        EXPECT_TRUE(is_close(
            got, root,
            allowed_by(load_sharing_contract, root, root_condition(model, k, delta, film0), 1),
            {{"K", k}, {"delta", delta}, {"lambda0", film0}}));
      }
    });
  }
}

TEST(BatchRoot, IsLeftToNewtonsMethodBeyondTheLimitsOfTheKernelsAndNotBefore) {
  for (const AsperityModel model : asperity_models)
    on_each_instruction_set([&] {
      const auto is_left = [&](double k, double delta, double film0) {
        Points one;
        one.add(k, delta, film0);
        const std::size_t newton = roots_of(model, one).work.by_newton;
        const LoadSharing<double> surface(model, k, delta);
        EXPECT_EQ(roots_of(surface, one.flooded).work.by_newton, newton);
        return newton == 1;
      };
      const auto stiffness = [&](double k) { return is_left(k, 1, 2); };
      const auto film = [&](double film0) { return is_left(0.3, 1, film0); };
      for (const Threshold& one : std::initializer_list<Threshold>{
               {"K", 1e-300, True::below, stiffness},
               {"K", 1e300, True::above, stiffness},
               {"delta", 40, True::above, [&](double delta) { return is_left(0.3, delta, 2); }},
               {"lambda0", 1e-280, True::below, film},
               {"lambda0", 1e280, True::above, film}})
        EXPECT_TRUE(changes_at_its_limit(one));
    });
}

// From film_from on, λ is λ₀ to half an ulp, and no step is taken.
TEST(BatchRoot, IsTheFilmItselfWhereTheBoundSaysSo) {
  Sampler sampler(159);
  for (const AsperityModel model : asperity_models) {
    Points points;
    for (int i = 0; i < 1000; ++i) {
      const double k = sampler.pick({0, 1, 1}) == 0 ? sampler.log_uniform(1e-300, 1e300)
                                                    : sampler.log_uniform(1e-40, 1e10);
      const double delta = uniform_offset(sampler);
      const double from = LoadSharing<double>(model, k, delta).surface().film_from;
      if (!(from > 1e-3)) continue;
      const double lambda0 = from * (1 + sampler.log_uniform(1e-14, 0.5));
      points.add(k, delta, lambda0);
      const Reference root(exact_root(model, k, delta, lambda0));
      EXPECT_TRUE(
          is_close(lambda0, root, allowed_by({0.5, 0}, root, 1, 1), {{"K", k}, {"delta", delta}}));
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

// No root of a batch is rounded to below the floor, at any place, for any length of the batch.
TEST(BatchRoot, IsNeverBelowTheFloor) {
  on_each_instruction_set([] {
    Sampler sampler(161);
    for (const AsperityModel model : asperity_models)
      for (int i = 0; i < 10000; ++i) {
        const double k = sampler.log_uniform(0.1, 1e6), delta = uniform_offset(sampler);
        const LoadSharing<double> surface(model, k, delta);
        if (!(surface.floor() > 0)) continue;
        std::vector<double> flooded(1 + i % 5), result(flooded.size());
        for (double& one : flooded) {
          const double power = sampler.uniform(0.9, 1);
          one = surface.floor() * std::pow(surface.surface().floor_up_to / surface.floor(), power);
        }
        film_parameter(surface, flooded, result);
        for (std::size_t place = 0; place < result.size(); ++place)
          EXPECT_GE(result[place], surface.floor())
              << describe({{"K", k}, {"delta", delta}, {"lambda0", flooded[place]}}) << place;
      }
  });
}

// Up to floor_up_to, λ is λ_b to half an ulp and the floor's own error, and no step is taken.
TEST(BatchRoot, IsTheFloorWhereTheBoundSaysSo) {
  Sampler sampler(160);
  std::size_t far_up = 0;
  for (const AsperityModel model : asperity_models)
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

// Side by side: roots of one step, of many steps and of none, and roots left to Newton's method.
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
    for (const AsperityModel model : asperity_models)
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

// Batches of more than one block, and the edges of blocks.
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
    for (const AsperityModel model : asperity_models) {
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
    for (const AsperityModel model : asperity_models)
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
