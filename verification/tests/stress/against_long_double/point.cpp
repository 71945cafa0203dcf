// SPDX-License-Identifier: Apache-2.0
#include "stress/against_long_double/point.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "support/condition.hpp"
#include "support/scenes.hpp"
#include "tribo/mixed_contact.hpp"

namespace tribo::verification {
namespace {

// Places in rows().
constexpr std::size_t scene_row = 0;
constexpr std::size_t extreme_row = scene_row + number_count + 1;
constexpr std::size_t sharing_row = extreme_row + number_count + 1;
constexpr std::size_t ratio_row = sharing_row + 2;
constexpr std::size_t moment_row = ratio_row + 4;

constexpr std::array orders{Order::zero,         Order::half, Order::one,
                            Order::three_halves, Order::two,  Order::five_halves};

std::uint64_t mixed(std::uint64_t x) {  // the finalizer of splitmix64
  x += 0x9e3779b97f4a7c15;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

Scene extreme_scene(Sampler& sampler) {
  Scene scene = random_scene(sampler);
  scene.load = sampler.log_uniform(1e-6, 1e8);
  scene.speeds.list = {sampler.log_uniform(1e-15, 1e6)};
  scene.surface.summit_height_sd = sampler.log_uniform(1e-12, 1e-3);
  scene.surface.summit_radius = sampler.log_uniform(1e-9, 1);
  scene.surface.summit_density = sampler.log_uniform(1e-4, 10) /
                                 (scene.surface.summit_radius * scene.surface.summit_height_sd);
  scene.surface.summit_plane_offset =
      sampler.pick({0, 1}) * sampler.uniform(0, 10) / std::max(1, scene.surface.offset_planes);
  scene.bodies = {sampler.log_uniform(1e4, 1e13), sampler.log_uniform(1e-7, 1e3),
                  sampler.log_uniform(1e-3, 50)};
  const bool roelands = scene.friction.viscosity == ViscosityLaw::roelands;
  scene.lubricant = {sampler.log_uniform(roelands ? 6.4e-5 : 1e-9, 1e6),
                     sampler.log_uniform(1e-12, 1e-6), sampler.log_uniform(1, 1e12)};
  scene.supply.value =
      scene.supply.kind == SupplyKind::inlet_film_ratio ? sampler.log_uniform(1e-6, 1e6)
      : scene.supply.kind == SupplyKind::inlet_film     ? sampler.log_uniform(1e-14, 1)
                                                        : sampler.log_uniform(1e-25, 1e3);
  scene.friction.boundary_coefficient = sampler.pick({0, 1, 1, 1}) * sampler.uniform(0, 10);
  scene.friction.slide_roll_ratio = sampler.pick({0, 1, 1, 1}) * sampler.log_uniform(1e-6, 1e3);
  scene.closures.damiens_exponent = sampler.log_uniform(0.1, 20);
  return scene;
}

double beside(Sampler& sampler, double x) {  // up to four places to either side
  for (int steps = sampler.pick({-4, -3, -2, -1, 0, 1, 2, 3, 4}); steps != 0;
       steps += steps < 0 ? 1 : -1)
    x = std::nextafter(x, steps < 0 ? -1e300 : 1e300);
  return x;
}

double near_one(Sampler& sampler) {
  return 1 + sampler.pick({-1, 1}) * sampler.log_uniform(1e-16, 0.5);
}

void draw_load_sharing(Sampler& sampler, Point& point) {
  point.scene.closures.asperity =
      sampler.pick({AsperityModel::greenwood_tripp, AsperityModel::greenwood_williamson});
  point.second = sampler.pick({0, 1, 1, 1}) * sampler.uniform(0, 10);
  const int region = sampler.pick({0, 0, 1, 2});
  if (region == 0) {  // everything
    point.first = sampler.log_uniform(1e-300, 1e300);
    point.third = sampler.log_uniform(1e-300, 1e300);
  } else if (region == 1) {  // where both sides of the equation matter
    point.first = sampler.log_uniform(1e-6, 1e6);
    point.third = sampler.log_uniform(1e-4, 100);
  } else {  // A(0) near 1
    point.first = near_one(sampler) /
                  gaussian_moment(load_order(point.scene.closures.asperity), -point.second);
    point.third = sampler.log_uniform(1e-10, 100);
  }
}

void draw_film_ratio(Sampler& sampler, Point& point) {
  point.scene.closures.starvation =
      sampler.pick({StarvationClosure::flooded_inlet, StarvationClosure::starved_inlet,
                    StarvationClosure::printed_exponents, StarvationClosure::damiens});
  const int region = sampler.pick({0, 1, 2});
  point.first = region == 0   ? sampler.log_uniform(1e-300, 1e300)
                : region == 1 ? sampler.log_uniform(1e-3, 1e3)
                              : near_one(sampler);
  point.second = sampler.log_uniform(0.1, 20);
}

void draw_moment(Sampler& sampler, Point& point) {
  const int region = sampler.pick({0, 0, 0, 0, 0, 0, 1, 2});
  // Ends of the series, the fraction and the factor of e^{−d²/2}; where they underflow.
  const double branch = sampler.pick({0.0, 0.0625, 0.5, 1.0, 10.0, 10.845, 25.0, 32.27553, 36.6,
                                      37.0, 37.3, 37.5, 38.0, 38.4, 38.6, 40.0, 45.0});
  const double sign = sampler.pick({-1.0, 1.0});
  point.first = region == 0   ? sampler.uniform(-45, 45)
                : region == 1 ? beside(sampler, sign * branch)
                              : sign * sampler.log_uniform(1e-300, 1);
}

bool is_share(double x) { return x >= 0 && x <= 1; }

Evaluation evaluate_scene(const Point& point) {
  struct Solved {
    explicit Solved(const Scene& s) : scene(s), contact(s) {}
    const Scene& scene;
    MixedContact<long double> contact;
    FloodedFilm<long double> film{};
    InletState<long double> inlet{};
    OperatingPoint<long double> point;
    std::optional<Conditions> conditions;
  };
  const auto solved = std::make_shared<Solved>(point.scene);
  const double speed = point.scene.speeds.list[0];
  solved->film = solved->contact.flooded(static_cast<long double>(speed));
  solved->inlet = solved->contact.inlet(solved->film);
  solved->point = solved->contact.complete(solved->film, solved->inlet, OutputSet::all());
  const OperatingPoint<long double>& truth = solved->point;
  const OperatingPoint<double> got = MixedContact<double>(point.scene).solve(speed);
  const auto values = numbers_of(got);
  const auto expected = numbers_of(truth);
  Evaluation evaluation;
  const std::size_t first = point.kind == Kind::scene ? scene_row : extreme_row;
  for (std::size_t i = 0; i < number_count; ++i)
    evaluation.numbers.push_back({first + i, values[i], expected[i]});
  evaluation.state_row = first + number_count;
  evaluation.states_differ = got.regime != truth.regime || got.inlet != truth.inlet ||
                             got.friction_undefined != truth.friction_undefined ||
                             !is_share(got.asperity_load_share) || !is_share(got.fluid_load_share);
  evaluation.condition = [solved](std::size_t i) {
    if (!solved->conditions)
      solved->conditions = operating_point_conditions(solved->scene, solved->contact, solved->film,
                                                      solved->inlet, solved->point);
    return (*solved->conditions)[i];
  };
  return evaluation;
}

Evaluation evaluate_load_sharing(const Point& point) {
  const AsperityModel model = point.scene.closures.asperity;
  const auto offset = static_cast<long double>(point.second);
  const LoadShares<long double> truth =
      LoadSharing<long double>(model, static_cast<long double>(point.first), offset)
          .solve(static_cast<long double>(point.third));
  const LoadShares<double> got =
      LoadSharing<double>(model, point.first, point.second).solve(point.third);
  Evaluation evaluation;
  const std::size_t row = sharing_row + static_cast<std::size_t>(model);
  evaluation.numbers.push_back({row, got.film_parameter, truth.film_parameter});
  evaluation.state_row = row;
  evaluation.states_differ = !is_share(got.asperity) || !is_share(got.fluid);
  evaluation.condition = [=](std::size_t) { return root_condition(model, offset, truth); };
  return evaluation;
}

Evaluation evaluate_film_ratio(const Point& point) {
  const StarvationClosure closure = point.scene.closures.starvation;
  Evaluation evaluation;
  evaluation.numbers.push_back({ratio_row + static_cast<std::size_t>(closure),
                                starvation_ratio(closure, point.first, point.second),
                                starvation_ratio(closure, static_cast<long double>(point.first),
                                                 static_cast<long double>(point.second))});
  evaluation.condition = [closure, r = point.first, gamma = point.second](std::size_t) {
    return film_ratio_condition(closure, r, gamma);
  };
  return evaluation;
}

Evaluation evaluate_moments(const Point& point) {
  Evaluation evaluation;
  for (const Order order : orders)
    evaluation.numbers.push_back({moment_row + static_cast<std::size_t>(order),
                                  gaussian_moment(order, point.first),
                                  gaussian_moment(order, static_cast<long double>(point.first))});
  evaluation.condition = [d = point.first](std::size_t i) {
    return moment_condition(orders[i], d);
  };
  return evaluation;
}

}  // namespace

const std::vector<Row>& rows() {
  static const std::vector<Row> all = [] {
    std::vector<Row> table;
    for (const char* family : {"operating_point", "extreme_operating_point"}) {
      for (std::size_t i = 0; i < number_count; ++i)
        table.push_back(
            {fmt::format("{}.{}", family, output_infos[i].name), operating_point_contract});
      table.push_back({fmt::format("{}.states", family), {0, 0}});
    }
    for (const char* model : {"greenwood_tripp", "greenwood_williamson"})
      table.push_back({fmt::format("load_sharing.{}", model), load_sharing_contract});
    for (const char* closure : {"flooded_inlet", "starved_inlet", "printed_exponents", "damiens"})
      table.push_back({fmt::format("starvation_ratio.{}", closure), starvation_ratio_contract});
    for (const char* order : {"0", "1/2", "1", "3/2", "2", "5/2"})
      table.push_back({fmt::format("gaussian_moment.{}", order), gaussian_moment_contract});
    return table;
  }();
  return all;
}

Point point_at(std::uint64_t seed, std::uint64_t index) {
  Sampler sampler(mixed(mixed(seed) + index));
  Point point;
  // A scene costs as much as a dozen of the functions it is made of.
  point.kind =
      sampler.pick({Kind::scene, Kind::scene, Kind::scene, Kind::extreme_scene, Kind::load_sharing,
                    Kind::load_sharing, Kind::film_ratio, Kind::moment});
  switch (point.kind) {
    case Kind::scene:
      point.scene = random_scene(sampler);
      break;
    case Kind::extreme_scene:
      point.scene = extreme_scene(sampler);
      break;
    case Kind::load_sharing:
      draw_load_sharing(sampler, point);
      break;
    case Kind::film_ratio:
      draw_film_ratio(sampler, point);
      break;
    case Kind::moment:
      draw_moment(sampler, point);
      break;
  }
  return point;
}

std::vector<std::pair<std::string, double>> inputs_of(const Point& point) {
  switch (point.kind) {
    case Kind::load_sharing:
      return {{"asperity", static_cast<double>(point.scene.closures.asperity)},
              {"stiffness", point.first},
              {"offset", point.second},
              {"flooded_film_parameter", point.third}};
    case Kind::film_ratio:
      return {{"starvation", static_cast<double>(point.scene.closures.starvation)},
              {"flooded_over_inlet", point.first},
              {"damiens_exponent", point.second}};
    case Kind::moment:
      return {{"argument", point.first}};
    default: {
      std::vector<std::pair<std::string, double>> all;
      for (const auto& [name, number] : describe_numbers(point.scene))
        all.emplace_back(name, number);
      return all;
    }
  }
}

Evaluation evaluate(const Point& point) {
  switch (point.kind) {
    case Kind::load_sharing:
      return evaluate_load_sharing(point);
    case Kind::film_ratio:
      return evaluate_film_ratio(point);
    case Kind::moment:
      return evaluate_moments(point);
    default:
      return evaluate_scene(point);
  }
}

std::vector<Enclosure> enclose(const Point& point) {
  reference::undecided_comparisons = 0;
  std::vector<Enclosure> numbers;
  switch (point.kind) {
    case Kind::load_sharing:
      numbers.push_back(
          LoadSharing<Enclosure>(point.scene.closures.asperity, point.first, point.second)
              .solve(point.third)
              .film_parameter);
      break;
    case Kind::film_ratio:
      numbers.push_back(starvation_ratio(point.scene.closures.starvation, Enclosure(point.first),
                                         Enclosure(point.second)));
      break;
    case Kind::moment:
      for (const Order order : orders)
        numbers.push_back(gaussian_moment(order, Enclosure(point.first)));
      break;
    default: {
      const MixedContact<Enclosure> contact(point.scene);
      const FloodedFilm<Enclosure> film = contact.flooded(point.scene.speeds.list[0]);
      const auto all = numbers_of(contact.complete(film, contact.inlet(film), OutputSet::all()));
      // A root that no ball tells from the floor: whichever of the two the text takes for the
      // greater, its ball holds both.
      if (point.scene.supply.kind == SupplyKind::flooded && contact.sharing().has_floor() &&
          film.shares.fluid < Enclosure(0x1p-200))
        reference::undecided_comparisons = 0;
      numbers.assign(all.begin(), all.end());
    }
  }
  if (reference::undecided_comparisons != 0) numbers.clear();
  return numbers;
}

}  // namespace tribo::verification
