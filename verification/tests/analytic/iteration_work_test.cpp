// SPDX-License-Identifier: Apache-2.0
// The work of the formulas' iterations. A worse start, one step more, or a branch that is taken too
// early gives the same numbers for more work. No comparison of numbers shows that.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <string_view>

#include "support/condition.hpp"
#include "support/scenes.hpp"
#include "tribo/hertz_ellipse.hpp"
#include "tribo/interior_minimum.hpp"
#include "tribo/onset.hpp"

namespace tribo::verification {
namespace {

using enum StarvationClosure;

constexpr AsperityModel tripp = AsperityModel::greenwood_tripp;
constexpr AsperityModel williamson = AsperityModel::greenwood_williamson;

// The number of calls of e^x, ln x, S_n(d) and other such functions that `work` makes.
template <class Function>
double calls_of(Function&& work) {
  const std::size_t before = Dual::calls;
  work();
  return static_cast<double>(Dual::calls - before);
}

LoadSharing<Dual> surface(AsperityModel model, double least, double most, Sampler& sampler) {
  return {model, sampler.log_uniform(least, most), sampler.uniform(0, 3)};
}

double calls_of_root(AsperityModel model, double least, double most, Sampler& sampler) {
  const LoadSharing<Dual> sharing = surface(model, least, most, sampler);
  const double film0 = sampler.log_uniform(1e-4, 100);
  return calls_of([&] { sharing.root(film0); });
}

double steps_in_double(AsperityModel model, Sampler& sampler) {
  const LoadSharing<double> sharing{model, sampler.log_uniform(1e-6, 10), sampler.uniform(0, 3)};
  return sharing.root(sampler.log_uniform(1e-4, 100)).iterations;
}

Scene random_starved_scene(StarvationClosure closure, SupplyKind supply, Sampler& sampler) {
  Scene scene = paper_scene(sampler.pick({paper_surfaces[0], paper_surfaces[2]}));
  scene.load = sampler.log_uniform(5, 500);
  scene.surface.offset_planes = sampler.pick({0, 1, 2});
  scene.closures.starvation = closure;
  scene.supply = {supply, supply == SupplyKind::inlet_flow ? sampler.log_uniform(1e-9, 1e-7)
                                                           : sampler.log_uniform(1, 20)};
  return scene;
}

double calls_of_onset(OnsetCriterion criterion, StarvationClosure closure, Sampler& sampler) {
  const Scene scene = random_starved_scene(closure, SupplyKind::inlet_flow, sampler);
  const MixedContact<Dual> contact(scene);
  return calls_of([&] { onset(contact, scene, criterion, Dual(0.05)); });
}

// The number of calls in a walk to a speed, from walk.near() of this speed or of 1e-4 m/s.
double calls_of_walk(StarvationClosure closure, bool from_below, Sampler& sampler) {
  const MixedContact<Dual> contact(
      random_starved_scene(closure, SupplyKind::inlet_film_ratio, sampler));
  const StribeckWalk<Dual> walk(contact);
  const double speed = sampler.log_uniform(1e-4, 3);
  return calls_of(
      [&] { walk.walk_to(walk.near(from_below ? 1e-4 : speed), std::log(speed), 1e-9); });
}

double evaluations_of_golden_section(Sampler& sampler) {
  const double place = sampler.uniform(-1, 1);
  int evaluations = 0;
  const auto parabola = [&](double x) {
    ++evaluations;
    return (x - place) * (x - place);
  };
  golden_section_minimum(parabola, -1.0, 1.0, 1e-6);
  return evaluations;
}

struct Iteration {
  std::string_view name;
  int cases;
  double mean;  // the work of one case, as measured
  std::function<double(Sampler&)> work;
};

TEST(Iterations, TakeTheWorkThatWasMeasured) {
  const Iteration all[] = {
      {"root of load sharing, no floor", 300, 27.11,
       [](Sampler& s) { return calls_of_root(tripp, 1e-6, 0.1, s); }},
      {"root of load sharing above a floor", 300, 10.98,
       [](Sampler& s) { return calls_of_root(williamson, 100, 1e6, s); }},
      {"root in double, Greenwood and Tripp", 3000, 1.2997,
       [](Sampler& s) { return steps_in_double(tripp, s); }},
      {"root in double, Greenwood and Williamson", 3000, 1.049,
       [](Sampler& s) { return steps_in_double(williamson, s); }},
      {"floor", 300, 53.05,
       [](Sampler& s) { return calls_of([&] { surface(tripp, 10, 1e6, s); }); }},
      {"distance above the floor", 300, 20.61,
       [](Sampler& s) {
         const LoadSharing<Dual> sharing = surface(tripp, 100, 1e6, s);
         const double fluid = s.log_uniform(1e-12, 0.25);
         return calls_of([&] { sharing.distance_above_floor(fluid); });
       }},
      {"inlet, starved", 300, 81.41,
       [](Sampler& s) {
         const double r = s.log_uniform(1e-3, 1e3);
         return calls_of([&] { starvation_ratio(starved_inlet, Dual(r), Dual(2)); });
       }},
      {"inlet, exponents as printed", 300, 88.07,
       [](Sampler& s) {
         const double r = s.log_uniform(1e-3, 1e3);
         return calls_of([&] { starvation_ratio(printed_exponents, Dual(r), Dual(2)); });
       }},
      {"greatest film behind an inlet", 1, 138,
       [](Sampler&) {
         return calls_of([] { InletLaw<Dual>{flooded_inlet, Dual(3)}.at_film_maximum(); });
       }},
      {"ellipse of Hertz", 300, 33.91,
       [](Sampler& s) {
         const double ratio = s.log_uniform(1, 1e4);
         return calls_of([&] { ellipse_shape(Dual(ratio)); });
       }},
      {"walk to a speed", 100, 57.1,
       [](Sampler& s) { return calls_of_walk(flooded_inlet, false, s); }},
      {"walk up to a speed", 100, 94.18,
       [](Sampler& s) { return calls_of_walk(flooded_inlet, true, s); }},
      {"walk by the inlet's length to a speed", 100, 164.3,
       [](Sampler& s) { return calls_of_walk(starved_inlet, false, s); }},
      {"least value by golden section", 100, 31.74, evaluations_of_golden_section},
      {"onset by the film's maximum", 10, 27086,
       [](Sampler& s) { return calls_of_onset(OnsetCriterion::film_maximum, flooded_inlet, s); }},
      {"onset by the film's departure", 30, 1341,
       [](Sampler& s) { return calls_of_onset(OnsetCriterion::film_departure, starved_inlet, s); }},
      {"onset by the least friction", 10, 31463,
       [](Sampler& s) {
         return calls_of_onset(OnsetCriterion::friction_minimum, flooded_inlet, s);
       }},
  };
  for (const Iteration& one : all) {
    Sampler sampler(300);
    double sum = 0;
    for (int i = 0; i < one.cases; ++i) sum += one.work(sampler);
    const double mean = sum / one.cases;
    EXPECT_LE(std::fabs(mean / one.mean - 1), 0.01) << one.name << ": " << mean;
  }
}

}  // namespace
}  // namespace tribo::verification
