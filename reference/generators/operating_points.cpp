// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>
#include <optional>

#include "generators/operating_point.hpp"
#include "generators/sampler.hpp"
#include "generators/table.hpp"

namespace tribo::reference {
namespace {

// The first circle_count random scenes are circles with the default law; the others have any shape
// and law.
constexpr std::size_t circle_count = 320, scene_count = 480;

// Draws the shape of the contact, its film law and, except for a circle, its second dimension.
void choose_shape(Inputs& in, Sampler& sampler) {
  auto& v = in.value;
  in.shape = sampler.pick({Shape::circle, Shape::ellipse, Shape::line});
  in.film = sampler.pick({std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{3}});
  if (in.shape == Shape::line) in.film += 4;
  const double radius = v[Inputs::radius_x].nearest();
  if (in.shape == Shape::ellipse) v[Inputs::across] = radius * sampler.log_uniform(0.2, 50);
  if (in.shape == Shape::line) v[Inputs::across] = radius * sampler.log_uniform(0.05, 5);
}

Inputs random_inputs(Sampler& sampler) {
  Inputs in;
  auto& v = in.value;
  v[Inputs::load] = sampler.log_uniform(0.1, 1e4);
  v[Inputs::speed] = sampler.log_uniform(1e-5, 30);
  const double sd = sampler.log_uniform(5e-9, 1e-6), radius = sampler.log_uniform(1e-6, 1e-4);
  v[Inputs::sd] = sd;
  v[Inputs::radius] = radius;
  v[Inputs::density] = sampler.uniform(0.02 / (radius * sd), 0.08 / (radius * sd));
  v[Inputs::offset] = sampler.uniform(0, 1.5);
  in.planes = sampler.pick({0, 1, 2});
  v[Inputs::modulus] = sampler.log_uniform(1e10, 3e11);
  v[Inputs::radius_x] = sampler.log_uniform(1e-3, 0.1);
  v[Inputs::across] = sampler.uniform(0.5, 4);
  v[Inputs::viscosity] = sampler.log_uniform(1e-3, 1);
  v[Inputs::pressure_viscosity] = sampler.log_uniform(5e-9, 4e-8);
  v[Inputs::eyring_stress] = sampler.log_uniform(1e6, 1e7);
  in.supply_kind = sampler.pick(
      {Supply::flooded, Supply::inlet_film, Supply::inlet_film_ratio, Supply::inlet_flow});
  v[Inputs::supply] = in.supply_kind == Supply::inlet_film_ratio ? sampler.log_uniform(1, 50)
                      : in.supply_kind == Supply::inlet_film     ? sampler.log_uniform(1e-8, 1e-5)
                                                                 : sampler.log_uniform(1e-10, 1e-6);
  v[Inputs::boundary] = sampler.uniform(0.05, 0.2);
  v[Inputs::slide_roll] = sampler.uniform(0.01, 2);
  in.shear = sampler.pick({Shear::eyring, Shear::limiting});
  in.law = sampler.pick({Viscosity::barus, Viscosity::ambient, Viscosity::roelands});
  in.rough = sampler.pick({Rough::tripp, Rough::williamson});
  in.inlet = sampler.pick(
      {Inlet::flooded_inlet, Inlet::starved_inlet, Inlet::printed_exponents, Inlet::damiens});
  v[Inputs::inlet_exponent] = sampler.uniform(1, 5);
  return in;
}

// Adds neighbours: scenes that follow each other differ in one number, in one word, or in the kind
// and value of the supply.
void add_steps(std::vector<Inputs>& scenes, Shape shape, std::size_t film) {
  Inputs in;
  in.shape = shape;
  in.film = film;
  in.inlet = Inlet::damiens;
  in.supply_kind = Supply::inlet_film;
  const double across = shape == Shape::circle ? 1 : shape == Shape::ellipse ? 0.03 : 0.008;
  const double load = shape == Shape::line ? 2000 : 50;
  for (const Numbers& x : steps({load, 0.05, 1e11, 1e-5, 5e-8, 1, 1.1e11, 0.01, across, 0.05, 2e-8,
                                 5e6, 6e-8, 0.1, 0.5, 3},
                                {1.6 * load, 0.08, 8e10, 1.5e-5, 6e-8, 1.2, 1.6e11, 0.015,
                                 1.5 * across, 0.08, 1.5e-8, 8e6, 8e-8, 0.12, 0.8, 2})) {
    std::copy(x.begin(), x.end(), in.value.begin());
    scenes.push_back(in);
  }
  const auto exchange = [&](auto& one, auto another) {
    one = another;
    scenes.push_back(in);
  };
  exchange(in.planes, 0);
  exchange(in.rough, Rough::williamson);
  exchange(in.shear, Shear::limiting);
  exchange(in.law, Viscosity::roelands);
  exchange(in.inlet, Inlet::starved_inlet);
  if (shape != Shape::circle || film != 0) exchange(in.film, film + 1);
  in.supply_kind = Supply::inlet_flow;
  for (const double flow : {5e-9, 4e-9}) exchange(in.value[Inputs::supply], flow);
  in.supply_kind = Supply::inlet_film_ratio;
  for (const double ratio : {1.2, 0.9}) exchange(in.value[Inputs::supply], ratio);
}

// Adds two points at the ends of the range of friction. At the first one the exponent αp is next to
// 70, and every field that has a default keeps it. The second one is a starved film of constant
// viscosity, with η₀γ̇/τ₀ next to 1e4.
void add_ends(std::vector<Inputs>& scenes, Shape shape, std::size_t film) {
  Inputs in;
  in.shape = shape;
  in.film = film;
  in.planes = 1;
  in.inlet = Inlet::flooded_inlet;
  in.supply_kind = Supply::inlet_film;
  const double across = shape == Shape::circle ? 1 : shape == Shape::ellipse ? 0.03 : 0.008;
  const double load = shape == Shape::circle ? 102 : shape == Shape::ellipse ? 278 : 4112;
  const Numbers thick{load,   1,    1e10, 1e-5, 4e-8, 0,   3e11, 0.01,
                      across, 0.05, 4e-8, 5e6,  1e-5, 0.1, 1,    3};
  std::copy(thick.begin(), thick.end(), in.value.begin());
  scenes.push_back(in);
  in.inlet = Inlet::starved_inlet;
  in.law = Viscosity::ambient;
  const Numbers sheared{shape == Shape::line ? 2000.0 : 50.0,
                        20,
                        1e9,
                        1e-5,
                        4e-8,
                        0,
                        1.1e11,
                        0.01,
                        across,
                        2,
                        2e-8,
                        8.5e5,
                        5e-8,
                        0.1,
                        10,
                        3};
  std::copy(sheared.begin(), sheared.end(), in.value.begin());
  scenes.push_back(in);
}

// The random inputs, then those of add_steps() and add_ends(): for circles with two laws, and for
// ellipses and lines with one law each.
std::vector<Inputs> all_inputs() {
  std::vector<Inputs> scenes;
  Sampler sampler(505), shapes(507);
  while (scenes.size() < scene_count) {
    scenes.push_back(random_inputs(sampler));
    if (scenes.size() > circle_count) choose_shape(scenes.back(), shapes);
  }
  add_steps(scenes, Shape::circle, 0);
  add_steps(scenes, Shape::circle, 1);
  add_steps(scenes, Shape::ellipse, 0);
  add_steps(scenes, Shape::line, 4);
  add_ends(scenes, Shape::circle, 0);
  add_ends(scenes, Shape::circle, 1);
  add_ends(scenes, Shape::ellipse, 0);
  add_ends(scenes, Shape::line, 4);
  return scenes;
}

std::vector<std::string> words_of(const Inputs& in) {
  constexpr std::array roughs{"greenwood_tripp", "greenwood_williamson"};
  constexpr std::array supplies{"flooded", "inlet_film", "inlet_film_ratio", "inlet_flow"};
  constexpr std::array shears{"eyring", "limiting"};
  constexpr std::array viscosity_laws{"barus", "ambient", "roelands"};
  constexpr std::array shapes{"circle", "ellipse", "line"};
  return {roughs[static_cast<std::size_t>(in.rough)],
          name(in.inlet),
          supplies[static_cast<std::size_t>(in.supply_kind)],
          shears[static_cast<std::size_t>(in.shear)],
          viscosity_laws[static_cast<std::size_t>(in.law)],
          shapes[static_cast<std::size_t>(in.shape)],
          laws[in.film].name,
          std::to_string(in.planes)};
}

constexpr std::array output_names{"film_flooded",
                                  "film",
                                  "separation",
                                  "film_parameter",
                                  "asperity_load_share",
                                  "fluid_load_share",
                                  "real_area_ratio",
                                  "summit_count",
                                  "friction"};

// The sum of |d ln output/d ln input| over all inputs, by steps of 2^-100; it is at least 1.
Outputs conditions(const Inputs& in, const Outputs& base) {
  Outputs sum;
  const Ball h = pow(Ball(2), Ball(-100));
  for (std::size_t i = 0; i < Inputs::count; ++i) {
    Inputs moved = in;
    moved.value[i] = (in.value[i] * (1 + h)).midpoint();
    const Outputs there = solve(moved, first_way);
    for (std::size_t k = 0; k < base.size(); ++k)
      if (is_finite(base[k]) && !(base[k] == 0))
        sum[k] += (abs(there[k] / base[k] - 1) / h).midpoint();
  }
  for (Ball& s : sum)
    if (!(s > 1)) s = 1;
  return sum;
}

// The scene is solved once for all its outputs.
struct Solved {
  Outputs value, second, condition;
};

}  // namespace

std::vector<Table> operating_points() {
  Table table{
      {"operating_point", "all outputs of a scene at a speed (model/README.md)", "SI; film in m",
       "random scenes of steel, ceramics and polymers under 0.1 N to 10 kN at 1e-5 to 30 m/s; "
       "circles "
       "(across is k of the film's constant), ellipses (R_y) and lines (length)",
       "hypergeometric moments, root by Newton's method with a proof by signs",
       "moments by quadrature, roots and film ratios by bisection",
       "output,asperity,starvation,supply_kind,fluid,viscosity_law,shape,film,offset_planes,load,"
       "speed,"
       "summit_density,summit_radius,summit_height_sd,summit_plane_offset,effective_modulus,"
       "radius_x,across,viscosity,pressure_viscosity,eyring_stress,supply,"
       "boundary_coefficient,slide_roll_ratio,damiens_exponent"},
      "p"};
  for (int scene = 0; const Inputs& in : all_inputs()) {
    auto solved = std::make_shared<std::optional<Solved>>();
    for (std::size_t k = 0; k < output_names.size(); ++k)
      table.add(fmt::format("p{:04}.{}", scene, k), [=] {
        if (!*solved) {
          const Outputs value = solve(in, first_way);
          *solved = Solved{value, solve(in, second_way), conditions(in, value)};
        }
        std::vector<std::string> words = words_of(in);
        words.insert(words.begin(), output_names[k]);
        std::vector<double> numbers;
        for (const Ball& x : in.value) numbers.push_back(x.nearest());
        const bool floored = (*solved)->value[2] > (*solved)->value[1];
        const bool collapsed = (*solved)->value[1] == 0;
        const Ball& value = (*solved)->value[k];
        return Row{words,
                   numbers,
                   value,
                   (*solved)->second[k],
                   (*solved)->condition[k],
                   !is_finite(value) ? "undefined"
                   : collapsed       ? "collapsed"
                   : floored         ? "floor"
                                     : "film"};
      });
    ++scene;
  }
  return {table};
}

}  // namespace tribo::reference
