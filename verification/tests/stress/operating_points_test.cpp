// SPDX-License-Identifier: Apache-2.0
// Operating points in batches, on each instruction set: outputs have the same bits whatever other
// outputs are asked for, and the work is counted.
#include "tribo/operating_points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "support/instruction_sets.hpp"
#include "support/point_bits.hpp"
#include "support/scenes.hpp"

namespace tribo::verification {
namespace {

constexpr auto arrays = std::to_array<std::vector<double> OperatingPoints::*>({
    &OperatingPoints::film_flooded,
    &OperatingPoints::film,
    &OperatingPoints::separation,
    &OperatingPoints::film_parameter,
    &OperatingPoints::asperity_load_share,
    &OperatingPoints::fluid_load_share,
    &OperatingPoints::real_area_ratio,
    &OperatingPoints::summit_count,
    &OperatingPoints::friction,
});
static_assert(arrays.size() == number_count);

OutputSet only(std::initializer_list<Output> outputs) {
  OutputSet set;
  for (const Output output : outputs) set.insert(output);
  return set;
}

struct Counted {
  OperatingPoints points;
  WorkCounts work;
};
Counted counted(const MixedContact<double>& contact, std::span<const double> speeds,
                OutputSet outputs = OutputSet::all()) {
  Counted result;
  result.points.resize(speeds.size(), outputs);
  solve(contact, speeds, outputs, result.points, result.work);
  return result;
}
OperatingPoints solved(const MixedContact<double>& contact, std::span<const double> speeds,
                       OutputSet outputs = OutputSet::all()) {
  OperatingPoints points;
  points.resize(speeds.size(), outputs);
  solve(contact, speeds, outputs, points);
  return points;
}
WorkCounts work_of(const MixedContact<double>& contact, std::span<const double> speeds,
                   OutputSet outputs = OutputSet::all()) {
  return counted(contact, speeds, outputs).work;
}

std::vector<std::uint64_t> bits_of_all(const std::vector<double>& numbers) {
  std::vector<std::uint64_t> bits;
  for (const double number : numbers) bits.push_back(std::bit_cast<std::uint64_t>(number));
  return bits;
}

std::vector<double> speeds_between(double low, double high, std::size_t count) {
  std::vector<double> speeds;
  for (std::size_t i = 0; i < count; ++i)
    speeds.push_back(low *
                     std::pow(high / low, static_cast<double>(i) / static_cast<double>(count - 1)));
  return speeds;
}

// Each supply and each closure on the paper's surfaces.
std::vector<Scene> paper_scenes() {
  std::vector<Scene> scenes;
  for (const auto model : asperity_models)
    for (const PaperSurface surface : paper_surfaces)
      for (const auto closure : starvation_closures)
        for (const Supply& supply :
             {Supply{SupplyKind::inlet_film_ratio, 4}, Supply{SupplyKind::inlet_flow, 1e-8},
              Supply{SupplyKind::inlet_film, 3e-8}, Supply{SupplyKind::flooded, 0}}) {
          if (supply.kind == SupplyKind::flooded && closure != StarvationClosure::starved_inlet)
            continue;
          Scene scene = paper_scene(surface, model);
          scene.supply = supply;
          scene.closures.starvation = closure;
          scenes.push_back(scene);
        }
  return scenes;
}

// paper_scenes() and `count` random scenes: smoother and rougher, stiffer and softer, with films on
// the floor, mixed, and free of asperities.
std::vector<Scene> paper_and_random_scenes(int count) {
  Sampler sampler(181);
  std::vector<Scene> scenes = paper_scenes();
  for (int i = 0; i < count; ++i) scenes.push_back(random_scene(sampler));
  return scenes;
}

// Each shape of contact in pure rolling: flooded, starved and nearly dry. The asperities make all
// of the friction, however little they carry.
std::vector<Scene> pure_rolling_scenes() {
  std::vector<Scene> scenes;
  for (const ContactShape shape : {ContactShape::circle, ContactShape::ellipse, ContactShape::line})
    for (const Supply& supply :
         {Supply{SupplyKind::flooded, 0}, Supply{SupplyKind::inlet_film_ratio, 4},
          Supply{SupplyKind::inlet_film, 1e-10}, Supply{SupplyKind::inlet_flow, 1e-7}}) {
      Scene scene = paper_scene(PaperSurface::smooth);
      if (shape == ContactShape::ellipse) scene.bodies = {107.9e9, 0, 1, 9.5e-3, 0.05};
      if (shape == ContactShape::line) {
        scene.bodies = {107.9e9, 0, 1, 9.5e-3, 0, 0.01};
        scene.closures.film = FilmFormula::dowson_toyoda_central;
      }
      scene.supply = supply;
      scene.closures.starvation = StarvationClosure::starved_inlet;
      scene.friction.slide_roll_ratio = 0;
      scenes.push_back(scene);
    }
  return scenes;
}

// Each output has the same bits alone, with one other output and among all outputs. 1 − A may
// differ by half an ulp of 1, where a bound sets it to 1.
TEST(OperatingPoints, OfAPartOfTheOutputsHaveTheBitsOfAll) {
  const std::vector<double> speeds = speeds_between(1e-4, 30, 41);
  std::vector<Scene> scenes = paper_and_random_scenes(30);
  for (const Scene& scene : pure_rolling_scenes()) scenes.push_back(scene);
  std::size_t hardly_carried = 0;
  for (const Scene& scene : scenes) {
    const MixedContact<double> contact(scene);
    const OperatingPoints all = solved(contact, speeds);
    if (scene.friction.slide_roll_ratio == 0)
      hardly_carried += static_cast<std::size_t>(
          std::count_if(all.friction.begin(), all.friction.end(),
                        [](double friction) { return friction > 0 && friction < 0x1p-58; }));
    for (const OutputInfo& first : output_infos)
      for (const OutputInfo& second : output_infos) {
        const OutputSet outputs = only({first.output, second.output});
        const OperatingPoints part = solved(contact, speeds, outputs);
        for (std::size_t k = 0; k < number_count; ++k) {
          const std::vector<double>& got = part.*arrays[k];
          if (!outputs.contains(output_infos[k].output)) {
            EXPECT_EQ(got.size(), 0u);
          } else if (output_infos[k].output == Output::fluid_load_share) {
            for (std::size_t i = 0; i < speeds.size(); ++i)
              EXPECT_TRUE(all.regime[i] == Regime::collapsed
                              ? std::isnan(got[i])
                              : std::fabs(got[i] - all.fluid_load_share[i]) <= 0x1p-53);
          } else {
            EXPECT_EQ(bits_of_all(got), bits_of_all(all.*arrays[k])) << output_infos[k].name;
          }
        }
        EXPECT_EQ(part.regime,
                  outputs.contains_any(balance_outputs()) ? all.regime : std::vector<Regime>());
        EXPECT_EQ(part.inlet, outputs.contains(Output::inlet) ? all.inlet : std::vector<Inlet>());
        EXPECT_EQ(part.speed, speeds);
      }
  }
  EXPECT_GT(hardly_carried, 10u);
}

TEST(OperatingPoints, ThatWereNotAskedForReadAsNothing) {
  const MixedContact<double> contact(paper_scene(PaperSurface::medium));
  const std::vector<double> speeds{0.01, 1};
  const OperatingPoints points = solved(contact, speeds, only({Output::film}));
  EXPECT_EQ(points.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const OperatingPoint<double> point = points[i];
    EXPECT_EQ(point.speed, speeds[i]);
    EXPECT_GT(point.film, 0);
    EXPECT_EQ(point.film_flooded + point.separation + point.film_parameter + point.friction, 0);
    EXPECT_EQ(point.regime, Regime::mixed);
  }
  OperatingPoints none = solved(contact, {});
  EXPECT_EQ(none.size(), 0u);
}

// One call gives the same points as many calls: point by point, or in parts of sizes near the
// engine's blocks of 512, the last part first. Every 37th point is beyond the engine's range.
TEST(OperatingPoints, BitsAndWorkDoNotDependOnParts) {
  std::vector<double> speeds = speeds_between(1e-5, 100, 2100);
  for (std::size_t i = 0; i < speeds.size(); i += 37) speeds[i] = i % 2 == 0 ? 1e-70 : 1e70;
  std::size_t left_to_newton = 0;
  std::vector<Scene> scenes{paper_scene(PaperSurface::rough), paper_scene(PaperSurface::smooth),
                            paper_and_random_scenes(9).back(), paper_scene(PaperSurface::rough)};
  scenes.back().surface.summit_plane_offset = 50;  // all its points are beyond the range
  for (const Scene& scene : scenes) {
    const MixedContact<double> contact(scene);
    const bool is_beyond = scene.surface.summit_plane_offset == 50;
    const auto all = std::span(speeds).first(is_beyond ? 1100 : speeds.size());
    on_each_instruction_set([&] {
      const auto [whole, whole_work] = counted(contact, all);
      left_to_newton += whole_work[Work::root_by_newton];
      std::size_t differing = 0;
      for (std::size_t i = 0; i < all.size(); i += is_beyond ? 7 : 1)
        differing += bits_of(contact.solve(all[i])) != bits_of(whole[i]) ? 1 : 0;
      EXPECT_EQ(differing, 0u) << "alone";
      for (const std::size_t size : {1, 7, 511, 512, 513, 777, 1025}) {
        if (is_beyond && size % 512 > 1) continue;
        OperatingPoints parts;
        parts.resize(all.size(), OutputSet::all());
        WorkCounts work;
        const std::size_t count = (all.size() + size - 1) / size;
        for (std::size_t part = count; part-- > 0;) {
          const std::size_t first = part * size;
          solve(contact, all.subspan(first, std::min(size, all.size() - first)), OutputSet::all(),
                parts, work, first);
        }
        EXPECT_EQ(work, whole_work) << size;
        differing = 0;
        for (std::size_t i = 0; i < all.size(); ++i)
          differing += bits_of(parts[i]) != bits_of(whole[i]) ? 1 : 0;
        EXPECT_EQ(differing, 0u) << size;
      }
      // A part changes nothing outside it. Its points are the same when the work is not counted.
      for (const int word : {0, 2})
        for (std::size_t count = 0; count <= 20; ++count) {
          OperatingPoints part;
          part.resize(20 + count + 20, OutputSet::all());
          for_each_number(part,
                          [](Output, auto& array) { std::fill(array.begin(), array.end(), -1.0); });
          std::fill(part.regime.begin(), part.regime.end(), static_cast<Regime>(word));
          std::fill(part.inlet.begin(), part.inlet.end(), static_cast<Inlet>(word));
          const auto untouched = bits_of(part[0]);
          solve(contact, all.subspan(1000, count), OutputSet::all(), part, 20);
          differing = 0;
          for (std::size_t i = 0; i < part.size(); ++i) {
            const bool is_inside = i >= 20 && i < 20 + count;
            differing +=
                bits_of(part[i]) != (is_inside ? bits_of(whole[980 + i]) : untouched) ? 1 : 0;
          }
          EXPECT_EQ(differing, 0u) << count;
        }
    });
  }
  EXPECT_GT(left_to_newton, 1100u);
}

// A range is filled in parts whose sizes are near those of blocks and chunks.
TEST(Speeds, OfARangeDoNotDependOnParts) {
  constexpr std::size_t count = 140000;
  for (const auto& [from, to] : {std::pair{1e-4, 3.0}, {1e-300, 1e300}})
    for (const Spacing spacing : {Spacing::log, Spacing::lin}) {
      const Speeds range{{}, from, to, count, spacing};
      std::vector<double> whole(count);
      range.fill(0, whole);
      EXPECT_EQ(whole.front(), from);
      EXPECT_EQ(whole.back(), to);
      std::size_t not_above = 0, not_even = 0, differing = 0;
      for (std::size_t i = 0; i < count; ++i) {
        const double t = static_cast<double>(i) / (count - 1);
        const double even = spacing == Spacing::lin
                                ? from * (1 - t) + to * t
                                : std::pow(10, (1 - t) * std::log10(from) + t * std::log10(to));
        not_above += i > 0 && !(whole[i] > whole[i - 1]) ? 1 : 0;
        not_even += std::abs(whole[i] / even - 1) <= 1e-12 ? 0 : 1;
        differing += i % 101 == 0 && range[i] != whole[i] ? 1 : 0;
      }
      EXPECT_EQ(not_above, 0u);
      EXPECT_EQ(not_even, 0u);
      for (const std::size_t size : {511, 512, 513, 2048, 65535, 65536, 65537})
        for (std::size_t first = 0; first < count; first += size) {
          std::vector<double> part(std::min(size, count - first));
          range.fill(first, part);
          differing += std::equal(part.begin(), part.end(),
                                  whole.begin() + static_cast<std::ptrdiff_t>(first))
                           ? 0
                           : 1;
        }
      EXPECT_EQ(differing, 0u);
    }
  const Speeds list{{3, 1, 2}, 0, 0, 0, Spacing::log};
  std::vector<double> part(2);
  list.fill(1, part);
  EXPECT_EQ(part, (std::vector<double>{1, 2}));
}

TEST(OperatingPointWork, WithoutASupplyHasNoStarvationRatios) {
  Scene scene = paper_scene(PaperSurface::medium);
  scene.supply = {SupplyKind::flooded, 0};
  const std::vector<double> speeds = speeds_between(1e-4, 3, 200);
  on_each_instruction_set([&] {
    const WorkCounts work = work_of(MixedContact<double>(scene), speeds);
    EXPECT_EQ(work[Work::starvation], 0u);
    EXPECT_EQ(work[Work::supply_is_flooded], 200u);
    EXPECT_EQ(work[Work::share], 200u);
    EXPECT_EQ(work[Work::moment], 400u);
    EXPECT_EQ(work[Work::shear_stress], 200u);
    EXPECT_EQ(work[Work::share_is_nothing], 0u);
    EXPECT_EQ(work[Work::share_not_asked], 0u);
    EXPECT_EQ(work[Work::root_by_newton], 0u);
    EXPECT_GE(work[Work::root_step], 200u);
    EXPECT_LE(work[Work::root_step], 600u);
  });
}

// Each film that has not collapsed takes one starvation ratio.
TEST(OperatingPointWork, WithASupplyHasAStarvationRatioAPoint) {
  const std::vector<double> speeds = speeds_between(1e-4, 3, 200);
  for (const Scene& scene : paper_scenes()) {
    if (scene.supply.kind == SupplyKind::flooded) continue;
    const MixedContact<double> contact(scene);
    on_each_instruction_set([&] {
      const auto [points, work] = counted(contact, speeds);
      const auto collapsed = static_cast<std::size_t>(
          std::count(points.inlet.begin(), points.inlet.end(), Inlet::collapsed));
      EXPECT_EQ(work[Work::starvation] + collapsed, 200u);
      EXPECT_EQ(work[Work::supply_is_flooded], 0u);
    });
  }
}

TEST(OperatingPointWork, OfTheFloodedFilmIsItsRootsAlone) {
  const std::vector<double> speeds = speeds_between(1e-4, 30, 1000);
  for (const Scene& scene : paper_scenes()) {
    const MixedContact<double> contact(scene);
    on_each_instruction_set([&] {
      const WorkCounts all = work_of(contact, speeds);
      const WorkCounts work = work_of(contact, speeds, only({Output::film_flooded}));
      for (const Work none : {Work::share, Work::moment, Work::starvation, Work::shear_stress,
                              Work::share_is_nothing, Work::supply_is_flooded})
        EXPECT_EQ(work[none], 0u) << work_infos[static_cast<std::size_t>(none)].name;
      EXPECT_EQ(work[Work::share_not_asked], 1000u);
      for (const Work same :
           {Work::root_step, Work::root_by_newton, Work::root_is_film, Work::root_is_floor})
        EXPECT_EQ(work[same], all[same]) << work_infos[static_cast<std::size_t>(same)].name;
    });
  }
}

// The shares, moments, stresses and starvation ratios that each single output takes for a point.
TEST(OperatingPointWork, IsOnlyWhatAnOutputNeeds) {
  struct Taken {
    Output output;
    std::uint64_t share, moment, stress, starvation;
  };
  const std::vector<double> speeds = speeds_between(1e-4, 0.01, 100);  // mixed; none collapsed
  const MixedContact<double> contact(paper_scene(PaperSurface::rough));
  for (const auto& [output, share, moment, stress, starvation] :
       {Taken{Output::film_flooded, 0, 0, 0, 0}, Taken{Output::film, 0, 0, 0, 1},
        Taken{Output::separation, 0, 0, 0, 1}, Taken{Output::film_parameter, 0, 0, 0, 1},
        Taken{Output::asperity_load_share, 1, 0, 0, 1}, Taken{Output::fluid_load_share, 1, 0, 0, 1},
        Taken{Output::real_area_ratio, 0, 1, 0, 1}, Taken{Output::summit_count, 0, 1, 0, 1},
        Taken{Output::friction, 1, 1, 1, 1}, Taken{Output::regime, 1, 0, 0, 1},
        Taken{Output::inlet, 0, 0, 0, 1}}) {
    const WorkCounts work = work_of(contact, speeds, only({output}));
    EXPECT_EQ(work[Work::share], 100 * share) << info(output).name;
    EXPECT_EQ(work[Work::share_not_asked], 100 * (1 - share)) << info(output).name;
    EXPECT_EQ(work[Work::moment], 100 * moment) << info(output).name;
    EXPECT_EQ(work[Work::shear_stress], 100 * stress) << info(output).name;
    EXPECT_EQ(work[Work::starvation], 100 * starvation) << info(output).name;
  }
}

// λ = λ₀ or λ = λ_b is taken at each speed where the bounds allow it, and at no other.
TEST(OperatingPointWork, SkipsRootsWhereTheBoundsSaySo) {
  std::uint64_t at_film = 0, at_floor = 0;
  const std::vector<double> speeds = speeds_between(1e-9, 1e4, 300);
  for (const Scene& scene : paper_and_random_scenes(40)) {
    const MixedContact<double> contact(scene);
    const LoadSharing<double>& sharing = contact.sharing();
    std::uint64_t film = 0, floor = 0;
    for (const double speed : speeds) {
      const double film0 = contact.flooded_film_parameter(speed);
      film += film0 >= sharing.surface().film_from ? 1 : 0;
      floor += sharing.has_floor() && film0 <= sharing.surface().floor_up_to ? 1 : 0;
    }
    on_each_instruction_set([&] {
      const WorkCounts work = work_of(contact, speeds, only({Output::film_flooded}));
      EXPECT_EQ(work[Work::root_is_film], film);
      EXPECT_EQ(work[Work::root_is_floor], floor);
      EXPECT_EQ(work[Work::root_by_newton], 0u);
      const std::uint64_t asked = speeds.size() - film - floor;
      EXPECT_GE(work[Work::root_step], asked);
      EXPECT_LE(work[Work::root_step], 4 * asked);
    });
    at_film += film;
    at_floor += floor;
  }
  EXPECT_GT(at_film, 1000u);
  EXPECT_GT(at_floor, 100u);
}

// Is A < 2^−54, by the bound of film_from?
bool is_free_of_asperities(const LoadSharing<double>& sharing, double film) {
  const double d = film - sharing.offset();
  const double limit = sharing.surface().film_from - sharing.offset();
  return d > 0 && d * d > limit * limit + 11.9 - 4 / 0.14 * sharing.film().sharing_power.value;
}

// Shares are not computed where A < 2^−54 and only 1 − A or the regime needs them: the exact 1 − A
// is 1 to half an ulp.
TEST(OperatingPointWork, SkipsSharesThatAreNothing) {
  std::uint64_t skipped = 0;
  const std::vector<double> speeds = speeds_between(1e-2, 100, 40);
  for (const Scene& scene : paper_and_random_scenes(40)) {
    const MixedContact<double> contact(scene);
    const MixedContact<long double> exact(scene);
    const OperatingPoints all = solved(contact, speeds);
    std::uint64_t expected = 0;
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      if (!is_free_of_asperities(contact.sharing(), all.film_parameter[i])) continue;
      ++expected;
      EXPECT_LT(exact.sharing().asperity_share(static_cast<long double>(all.film_parameter[i])),
                0x1p-54L)
          << speeds[i];
      EXPECT_EQ(all.regime[i], Regime::elastohydrodynamic);
    }
    for (const OutputSet outputs :
         {only({Output::fluid_load_share}), only({Output::regime}),
          only({Output::fluid_load_share, Output::regime, Output::film, Output::inlet})}) {
      const WorkCounts work = work_of(contact, speeds, outputs);
      EXPECT_EQ(work[Work::share_is_nothing], expected);
      EXPECT_EQ(work[Work::share], speeds.size() - expected);
      const OperatingPoints part = solved(contact, speeds, outputs);
      for (std::size_t i = 0; i < speeds.size(); ++i) {
        if (!is_free_of_asperities(contact.sharing(), all.film_parameter[i])) continue;
        EXPECT_EQ(part[i].fluid_load_share, outputs.contains(Output::fluid_load_share) ? 1 : 0);
        EXPECT_EQ(part[i].regime, Regime::elastohydrodynamic);
      }
    }
    EXPECT_EQ(work_of(contact, speeds)[Work::share_is_nothing], 0u);
    skipped += expected;
  }
  EXPECT_GT(skipped, 200u);
}

}  // namespace
}  // namespace tribo::verification
