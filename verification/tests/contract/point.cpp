// SPDX-License-Identifier: Apache-2.0
#include "contract/point.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/condition.hpp"
#include "support/film_laws.hpp"
#include "support/orders.hpp"
#include "support/scenes.hpp"
#include "tribo/batch.hpp"
#include "tribo/film_regimes.hpp"
#include "tribo/hertz_ellipse.hpp"
#include "tribo/hertz_line.hpp"
#include "tribo/liquids.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/moes_line.hpp"
#include "tribo/nijenbanning_venner_moes.hpp"
#include "tribo/spectral_moments.hpp"
#include "tribo/thermal_reduction.hpp"
#include "tribo/two_bodies.hpp"

namespace tribo::verification {
namespace {

// The rows of the kinds up to `moment` are counted here.
static_assert(stress_rows == 2 * (number_count + 1) + 2 + 4 + 4 + 6);

std::uint64_t mixed(std::uint64_t x) {  // the finalizer of splitmix64
  x += 0x9e3779b97f4a7c15;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

double about_one(Sampler& sampler) { return 1 + sampler.pick({-1, 1}) * sampler.uniform(0, 0.3); }

// If the surface has a floor, gives the scene a speed at which the flooded film is near the floor,
// and an inlet film of 0.3 to 1000 floors: from nearly collapsed to hardly starved.
void put_about_floor(Sampler& sampler, Scene& scene) {
  const MixedContact<double> contact(scene);
  const double floor = contact.sharing().floor();
  const FilmLaw& film = film_law(scene);
  if (!(floor > 0) || !film.has_fixed_exponents() || film.sharing_exponent.p == 0) return;
  const double speed = contact.speed_at(floor * about_one(sampler));
  if (!(speed > 1e-15 && speed < 1e6)) return;
  scene.speeds.list = {speed};
  scene.supply.kind = SupplyKind::inlet_film_ratio;
  scene.supply.value = floor * sampler.log_uniform(0.3, 1e3);
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
  const ContactShape shape = scene.bodies.shape();
  scene.bodies = {sampler.log_uniform(1e4, 1e13)};
  const double radius = sampler.log_uniform(1e-7, 1e3);
  (shape == ContactShape::circle ? scene.bodies.reduced_radius : scene.bodies.radius_x) = radius;
  if (shape == ContactShape::circle) scene.bodies.ellipticity = sampler.log_uniform(1e-3, 50);
  if (shape == ContactShape::ellipse)
    scene.bodies.radius_y = radius * sampler.log_uniform(1e-4, 1e4);
  if (shape == ContactShape::line) scene.bodies.length = radius * sampler.log_uniform(1e-3, 1e3);
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
  if (sampler.pick({0, 0, 1}) == 1) put_about_floor(sampler, scene);
  return scene;
}

double beside(Sampler& sampler, double x) {  // a neighbour of x, up to four doubles away
  for (int steps = sampler.pick({-4, -3, -2, -1, 0, 1, 2, 3, 4}); steps != 0;
       steps += steps < 0 ? 1 : -1)
    x = std::nextafter(x, steps < 0 ? -1e300 : 1e300);
  return x;
}

double near_one(Sampler& sampler) {
  return 1 + sampler.pick({-1, 1}) * sampler.log_uniform(1e-16, 0.5);
}

void draw_load_sharing(Sampler& sampler, Point& point) {
  if (sampler.pick({0, 0, 1}) == 1) point.film = sampler.pick(other_film_laws);
  point.scene.closures.asperity = sampler.pick(asperity_models);
  point.x[1] = sampler.pick({0, 1, 1, 1}) * sampler.uniform(0, 10);
  const int region = sampler.pick({0, 0, 1, 2});
  if (region == 0) {  // everything
    point.x[0] = sampler.log_uniform(1e-300, 1e300);
    point.x[2] = sampler.log_uniform(1e-300, 1e300);
  } else if (region == 1) {  // where neither side of the equation is small
    point.x[0] = sampler.log_uniform(1e-6, 1e6);
    point.x[2] = sampler.log_uniform(1e-4, 100);
  } else {  // A(0) near 1
    point.x[0] =
        near_one(sampler) / gaussian_moment(load_order(point.scene.closures.asperity), -point.x[1]);
    point.x[2] = sampler.log_uniform(1e-10, 100);
  }
}

// Draws a film about the floor of its surface, by a published law. The floor may be as high as
// floors get.
void draw_load_shares(Sampler& sampler, Point& point) {
  point.film = sampler.pick({&hamrock_dowson_central_law, &hamrock_dowson_minimum_law,
                             &hamrock_dowson_soft_central_law, &pan_hamrock_central_law});
  point.scene.closures.asperity = sampler.pick(asperity_models);
  point.x[0] = sampler.log_uniform(1, sampler.pick({1e6, 1e300}));
  point.x[1] = sampler.pick({0, 1}) * sampler.uniform(0, 10);
  const LoadSharing<double> sharing(point.scene.closures.asperity, point.x[0], point.x[1]);
  point.x[2] = (sharing.has_floor() ? sharing.floor() : 1) * about_one(sampler);
}

void draw_film_ratio(Sampler& sampler, Point& point) {
  point.scene.closures.starvation = sampler.pick(starvation_closures);
  const int region = sampler.pick({0, 1, 2});
  point.x[0] = region == 0   ? sampler.log_uniform(1e-300, 1e300)
               : region == 1 ? sampler.log_uniform(1e-3, 1e3)
                             : near_one(sampler);
  point.x[1] = sampler.log_uniform(0.1, 20);
}

void draw_moment(Sampler& sampler, Point& point) {
  const int region = sampler.pick({0, 0, 0, 0, 0, 0, 1, 2});
  // Arguments at which another formula of F_n begins, or at which e^{−d²/2} or F_n underflows.
  const double branch = sampler.pick({0.0, 0.0625, 0.5, 1.0, 10.0, 10.845, 25.0, 32.27553, 36.6,
                                      37.0, 37.3, 37.5, 38.0, 38.4, 38.6, 40.0, 45.0});
  const double sign = sampler.pick({-1.0, 1.0});
  point.x[0] = region == 0   ? sampler.uniform(-45, 45)
               : region == 1 ? beside(sampler, sign * branch)
                             : sign * sampler.log_uniform(1e-300, 1);
}

// E₁, ν₁, E₂, ν₂.
void draw_moduli(Sampler& sampler, Point& point) {
  const bool is_usual = sampler.pick({0, 1}) == 1;
  for (const std::size_t i : {0U, 2U}) {
    point.x[i] = is_usual ? sampler.log_uniform(1e5, 1e12) : sampler.log_uniform(1e-250, 1e250);
    point.x[i + 1] = is_usual                    ? sampler.uniform(0, 0.5)
                     : sampler.pick({0, 1}) == 1 ? sampler.uniform(-1, 0.5)
                                                 : sampler.log_uniform(1e-15, 1) - 1;
  }
}

// R₁x, R₂x, R₁y, R₂y of faces that meet at a point. Some faces nearly conform.
void draw_radii(Sampler& sampler, Point& point) {
  for (const std::size_t i : {0U, 2U}) {
    const bool is_usual = sampler.pick({0, 1}) == 1;
    double& first = point.x[i];
    double& second = point.x[i + 1];
    first = is_usual ? sampler.log_uniform(1e-6, 10) : sampler.log_uniform(1e-250, 1e250);
    const int face = sampler.pick({0, 1, 2, 3});  // convex, flat, two concave ones
    second = face == 0   ? sampler.log_uniform(1e-6, 10)
             : face == 1 ? 1e30
                         : -first * (1 + sampler.log_uniform(face == 2 ? 1e-15 : 1e-3, 100));
    if (sampler.pick({0, 1}) == 1) std::swap(first, second);
  }
}

// F, E*, R_x and R_y. Some ellipses are nearly circles, and some numbers are far from real bodies.
void draw_ellipse(Sampler& sampler, Point& point) {
  const bool is_usual = sampler.pick({0, 1}) == 1;
  const double far = is_usual ? 1 : 1e40;
  point.x = {sampler.log_uniform(1e-3 / far, 1e6 * far), sampler.log_uniform(1e5 / far, 1e12 * far),
             sampler.log_uniform(1e-6 / far, 1e3 * far)};
  point.x[3] =
      point.x[2] * (sampler.pick({0, 1}) == 1 ? 1 + sampler.log_uniform(1e-16, 1)
                                              : sampler.log_uniform(1e-4 / far, 1e4 * far));
  if (sampler.pick({0, 1}) == 1) std::swap(point.x[2], point.x[3]);
}

// u, η₀, α, F or F/L, E*, R, k
void draw_film(Sampler& sampler, Point& point) {
  point.film = sampler.pick({&hamrock_dowson_minimum_law, &hamrock_dowson_soft_central_law,
                             &hamrock_dowson_soft_minimum_law, &dowson_higginson_minimum_law,
                             &dowson_toyoda_central_law, &pan_hamrock_minimum_law,
                             &pan_hamrock_central_law, &ertel_grubin_law});
  point.x = {sampler.log_uniform(1e-6, 100),  sampler.log_uniform(1e-4, 10),
             sampler.log_uniform(1e-9, 1e-7), sampler.log_uniform(1e-3, 1e7),
             sampler.log_uniform(1e5, 1e12),  sampler.log_uniform(1e-6, 10),
             sampler.log_uniform(0.01, 20)};
}

// Draws p₀, E*, S, β, η₀, u, k_f. The numerator of φ_T is above 0, sometimes only just.
void draw_heated_inlet(Sampler& sampler, Point& point) {
  auto& x = point.x;
  x = {0,
       sampler.log_uniform(1e8, 1e12),
       sampler.pick({0, 1, 1}) * sampler.log_uniform(1e-4, 10),
       sampler.log_uniform(1e-3, 0.2),
       sampler.log_uniform(1e-4, 10),
       sampler.log_uniform(1e-4, 100),
       sampler.log_uniform(0.01, 10)};
  const double limit = x[1] / (6.6 * std::pow(x[3] * x[4] * x[5] * x[5] / x[6], 0.42));
  const bool is_near = sampler.pick({0, 0, 1}) == 1;
  x[0] = limit * (is_near ? 1 - sampler.log_uniform(1e-4, 0.1) : sampler.log_uniform(1e-6, 0.9));
}

bool is_share(double x) { return x >= 0 && x <= 1; }

// The absolute error of `value` = ln F is the relative error of F, at least ε: many ulp near 0.
double logarithm_condition(double value) {
  const double ulp = std::ldexp(1.0, std::max(std::ilogb(value), -1022) - 52);
  return std::max(1.0, std::abs(value)) * 0x1p-52 / ulp;
}

// All rows, and the place of the first row of each kind.
struct RowTable {
  std::vector<Row> rows;
  std::array<std::size_t, kind_count> first{};
};
const RowTable& row_table() {
  static const RowTable all = [] {
    RowTable table;
    Kind last = Kind::count;
    const auto add = [&](Kind kind, std::string_view family,
                         std::initializer_list<std::string_view> names, const Contract& contract) {
      if (kind != last) table.first[static_cast<std::size_t>(kind)] = table.rows.size();
      last = kind;
      for (const std::string_view name : names)
        table.rows.push_back({fmt::format("{}.{}", family, name), contract});
    };
    for (const auto& [kind, family] : {std::pair{Kind::scene, "operating_point"},
                                       {Kind::extreme_scene, "extreme_operating_point"}}) {
      for (std::size_t i = 0; i < number_count; ++i)
        add(kind, family, {output_infos[i].name}, operating_point_contract);
      add(kind, family, {"states"}, {0, 0});
    }
    add(Kind::load_sharing, "load_sharing", {"greenwood_tripp", "greenwood_williamson"},
        load_sharing_contract);
    for (const char* const model : {"greenwood_tripp", "greenwood_williamson"})
      add(Kind::load_shares, fmt::format("load_shares.{}", model), {"asperity", "fluid"},
          operating_point_contract);
    add(Kind::film_ratio, "starvation_ratio",
        {"flooded_inlet", "starved_inlet", "printed_exponents", "damiens"},
        starvation_ratio_contract);
    const auto by_order = {"0", "1/2", "1", "3/2", "2", "5/2"};
    for (const auto& order : by_order)
      add(Kind::moment, "gaussian_moment", {order}, gaussian_moment_contract);
    for (const auto& order : by_order) {
      add(Kind::scaled_moment, "scaled_gaussian_moment", {order}, gaussian_moment_contract);
      add(Kind::scaled_moment, "log_gaussian_moment", {order},
          {0, log_gaussian_moment_contract.ulp});
    }
    add(Kind::deficit, "starvation", {"deficit"}, starvation_ratio_contract);
    add(Kind::deficit, "starvation", {"departure_ratio"}, {0, starvation_ratio_contract.ulp});
    add(Kind::deficit, "starvation", {"slope"}, {450, 0});
    add(Kind::hertz, "hertz_point",
        {"radius", "nominal_area", "mean_pressure", "peak_pressure", "approach"}, hertz_contract);
    add(Kind::film, "hamrock_dowson_central", {"value"}, film_contract);
    add(Kind::rough_contact, "asperity_contact", {"stiffness", "area_factor", "count_factor"},
        {10, 0});
    add(Kind::viscosity, "log_viscosity_ratio", {"value"}, {450, 0});
    add(Kind::shear, "fluid_shear_stress", {"value"}, {0, 20});
    add(Kind::effective_modulus, "effective_modulus", {"value"}, effective_modulus_contract);
    add(Kind::reduced_radius, "reduced_radius", {"radius_x", "radius_y", "reduced_radius"},
        reduced_radius_contract);
    add(Kind::hertz_ellipse, "hertz_ellipse",
        {"semi_axis_x", "semi_axis_y", "ellipticity", "mean_pressure", "peak_pressure", "approach"},
        hertz_ellipse_contract);
    add(Kind::hertz_line, "hertz_line",
        {"half_width", "mean_pressure", "peak_pressure", "peak_shear"}, hertz_line_contract);
    add(Kind::film_law, "film_law", {"value"}, film_contract);
    add(Kind::moes_line, "moes_line", {"value"}, moes_line_contract);
    add(Kind::moes_point, "nijenbanning_venner_moes", {"value"}, nijenbanning_venner_moes_contract);
    add(Kind::film_regime, "regime_film", {"value"}, film_contract);
    add(Kind::thermal_reduction, "gupta_thermal_reduction", {"value"}, gupta_thermal_contract);
    add(Kind::density, "dowson_higginson_density", {"value"}, density_contract);
    add(Kind::pressure_viscosity, "viscosity_at", {"value"}, roelands_contract);
    add(Kind::astm_d341, "astm_d341_viscosity", {"value"}, astm_d341_contract);
    add(Kind::spectral_moments, "summits_from_spectral_moments",
        {"bandwidth", "summit_density", "summit_radius", "summit_height_sd", "summit_plane_offset"},
        spectral_moments_contract);
    return table;
  }();
  return all;
}

}  // namespace

std::span<const Row> rows() { return row_table().rows; }

std::size_t first_row(const Point& point) {
  const std::size_t first = row_table().first[static_cast<std::size_t>(point.kind)];
  if (point.kind == Kind::load_sharing)
    return first + static_cast<std::size_t>(point.scene.closures.asperity);
  if (point.kind == Kind::load_shares)
    return first + 2 * static_cast<std::size_t>(point.scene.closures.asperity);
  if (point.kind == Kind::film_ratio)
    return first + static_cast<std::size_t>(point.scene.closures.starvation);
  return first;
}

Point point_at(std::uint64_t seed, std::uint64_t index) {
  Sampler sampler(mixed(mixed(seed) + index));
  Point point;
  // A scene takes as much time as a dozen calls of single functions.
  point.kind =
      sampler.pick({Kind::scene, Kind::scene, Kind::scene, Kind::extreme_scene, Kind::load_sharing,
                    Kind::load_shares, Kind::film_ratio, Kind::moment});
  draw(sampler, point);
  return point;
}

void draw(Sampler& sampler, Point& point) {
  const auto numbers = [&](std::initializer_list<std::pair<double, double>> ranges) {
    std::size_t i = 0;
    for (const auto& [low, high] : ranges) point.x[i++] = sampler.log_uniform(low, high);
  };
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
    case Kind::load_shares:
      draw_load_shares(sampler, point);
      break;
    case Kind::film_ratio:
      draw_film_ratio(sampler, point);
      break;
    case Kind::deficit:
      draw_film_ratio(sampler, point);
      point.x = {point.scene.closures.starvation == StarvationClosure::flooded_inlet
                     ? sampler.log_uniform(1e-8, 1)
                     : sampler.log_uniform(1e-8, 1e8),
                 sampler.uniform(0.5, 6), sampler.uniform(0.001, 0.999)};
      break;
    case Kind::hertz:  // F, E*, R
      numbers({{1e-6, 1e6}, {1e6, 1e12}, {1e-6, 10}});
      break;
    case Kind::film:  // u, η₀, α, F, E*, R, k
      numbers(
          {{1e-6, 100}, {1e-4, 10}, {1e-9, 1e-7}, {1e-3, 1e5}, {1e8, 1e12}, {1e-4, 1}, {0.3, 10}});
      break;
    case Kind::rough_contact:  // n, β, σ_s, E*, A_nom, F
      numbers({{1e8, 1e13}, {1e-7, 1e-3}, {1e-9, 1e-5}, {1e8, 1e12}, {1e-10, 1e-4}, {1e-3, 1e5}});
      point.scene.closures.asperity =
          sampler.pick({AsperityModel::greenwood_tripp, AsperityModel::greenwood_williamson});
      break;
    case Kind::viscosity:  // η₀, α, p
      numbers({{1e-4, 10}, {1e-9, 5e-8}, {1, 4e9}});
      point.scene.friction.viscosity =
          sampler.pick({ViscosityLaw::barus, ViscosityLaw::ambient, ViscosityLaw::roelands});
      break;
    case Kind::shear:  // τ₀, η₀, S u, separation, ln(η/η₀)
      numbers({{1e5, 1e8}, {1e-4, 10}, {1e-6, 100}, {1e-10, 1e-5}});
      point.x[4] = sampler.uniform(0, 60);
      point.scene.friction.fluid = sampler.pick({FluidShear::eyring, FluidShear::limiting});
      break;
    case Kind::effective_modulus:
      draw_moduli(sampler, point);
      break;
    case Kind::reduced_radius:
      draw_radii(sampler, point);
      break;
    case Kind::hertz_ellipse:
      draw_ellipse(sampler, point);
      break;
    case Kind::hertz_line:  // F/L, E*, R
      numbers({{1e-60, 1e60}, {1e-60, 1e60}, {1e-60, 1e60}});
      break;
    case Kind::film_law:
    case Kind::moes_line:
      draw_film(sampler, point);
      break;
    case Kind::moes_point:  // as a film; then R_y, and two readings
      draw_film(sampler, point);
      point.x[6] = point.x[5] / sampler.log_uniform(1e-4, 1e4);
      point.x[7] = sampler.pick({0, 1});
      point.x[8] = sampler.pick({0, 1});
      break;
    case Kind::film_regime:  // g_V, g_E, α, k, and the regime
      numbers({{1e-12, 1e20}, {1e-12, 1e20}, {0.01, 100}, {0.01, 20}});
      point.x[4] = sampler.pick({0, 1, 2, 3, 4});
      break;
    case Kind::thermal_reduction:
      draw_heated_inlet(sampler, point);
      break;
    case Kind::density:
      numbers({{1e-3, 1e12}});
      break;
    case Kind::pressure_viscosity:  // η₀, α, p
      numbers({{1e-4, 10}, {1e-9, 5e-8}, {1, 4e9}});
      point.scene.friction.viscosity = sampler.pick({ViscosityLaw::barus, ViscosityLaw::roelands});
      break;
    case Kind::astm_d341:  // T₁, ν₁, T₂, ν₂, T
      numbers({{200, 300}, {1e-6, 1e-2}, {301, 500}, {4e-7, 1e-4}, {200, 600}});
      break;
    case Kind::spectral_moments:  // m₀, m₂, and m₄ of a bandwidth
      numbers({{1e-20, 1e-8}, {1e-8, 1}});
      point.x[2] = (0.8968 + sampler.log_uniform(1e-4, 1e3)) * point.x[1] * point.x[1] / point.x[0];
      break;
    default:
      draw_moment(sampler, point);
  }
}

std::vector<std::pair<std::string, double>> inputs_of(const Point& point) {
  switch (point.kind) {
    case Kind::load_sharing:
    case Kind::load_shares:
      return {{"asperity", static_cast<double>(point.scene.closures.asperity)},
              {"film law's a - b", point.film->sharing_power.value},
              {"stiffness", point.x[0]},
              {"offset", point.x[1]},
              {"flooded_film_parameter", point.x[2]}};
    case Kind::film_ratio:
      return {{"starvation", static_cast<double>(point.scene.closures.starvation)},
              {"flooded_over_inlet", point.x[0]},
              {"damiens_exponent", point.x[1]}};
    case Kind::moment:
      return {{"argument", point.x[0]}};
    default: {
      std::vector<std::pair<std::string, double>> all;
      for (const auto& [name, number] : describe_numbers(point.scene))
        all.emplace_back(name, number);
      if (point.kind > Kind::moment)  // these kinds use the words of the scene and x
        for (std::size_t i = 0; i < point.x.size(); ++i)
          all.emplace_back(fmt::format("x{}", i), point.x[i]);
      return all;
    }
  }
}

template <class T>
Values<T> values_of(const Point& point) {
  const auto x = [&](std::size_t i) { return T(point.x[i]); };
  const StarvationClosure closure = point.scene.closures.starvation;
  const AsperityModel model = point.scene.closures.asperity;
  switch (point.kind) {
    case Kind::load_sharing:
      return {{LoadSharing<T>(model, x(0), x(1), *point.film).solve(x(2)).film_parameter}};
    case Kind::load_shares: {
      const auto shares = LoadSharing<T>(model, x(0), x(1), *point.film).solve(x(2));
      return {{shares.asperity, shares.fluid}};
    }
    case Kind::film_ratio:
      return {{InletLaw<T>{closure, x(1)}.film_ratio(x(0))}};
    case Kind::deficit: {
      const InletLaw<T> law{closure, x(1)};
      return {{law.deficit(x(0)), law.at_departure(x(2)), law.slope(x(0))}};
    }
    case Kind::hertz: {
      const HertzPoint<T> hertz = hertz_point(x(0), x(1), x(2));
      return {{hertz.radius, hertz.nominal_area, hertz.mean_pressure, hertz.peak_pressure,
               hertz.approach}};
    }
    case Kind::film:
      return {{hamrock_dowson_central(x(0), x(1), x(2), x(3), x(4), x(5), x(6))}};
    case Kind::rough_contact: {
      const AsperityContact<T> contact =
          asperity_contact(model, x(0), x(1), x(2), T(1), x(3), x(4), x(5));
      return {{contact.stiffness, contact.area_factor, contact.count_factor}};
    }
    case Kind::viscosity:
      return {{log_viscosity_ratio(point.scene.friction.viscosity, x(0), x(1), x(2))}};
    case Kind::shear:
      return {{fluid_shear_stress(point.scene.friction.fluid, x(0), x(1), x(4), x(2), x(3))}};
    case Kind::effective_modulus:
      return {{effective_modulus(x(0), x(1), x(2), x(3))}};
    case Kind::reduced_radius: {
      const ReducedRadius<T> radii = reduced_radius(x(0), x(1), x(2), x(3));
      return {{radii.radius_x, radii.radius_y, radii.reduced_radius}};
    }
    case Kind::hertz_ellipse: {
      const HertzEllipse<T> hertz = hertz_ellipse(x(0), x(1), x(2), x(3));
      return {{hertz.semi_axis_x, hertz.semi_axis_y, hertz.ellipticity, hertz.mean_pressure,
               hertz.peak_pressure, hertz.approach}};
    }
    case Kind::hertz_line: {
      const HertzLine<T> hertz = hertz_line(x(0), x(1), x(2));
      return {{hertz.half_width, hertz.mean_pressure, hertz.peak_pressure, hertz.peak_shear}};
    }
    case Kind::film_law:
      return {{point.film->is_of_lines
                   ? line_film_thickness(*point.film, x(0), x(1), x(2), x(3), x(4), x(5))
                   : film_thickness(*point.film, x(0), x(1), x(2), x(3), x(4), x(5), x(6))}};
    case Kind::moes_line:
      return {{moes_line(x(0), x(1), x(2), x(3), x(4), x(5))}};
    case Kind::moes_point:
      return {{nijenbanning_venner_moes(x(0), x(1), x(2), x(3), x(4), x(5), x(6),
                                        static_cast<MoesExponent>(static_cast<int>(point.x[7])),
                                        static_cast<MoesBracket>(static_cast<int>(point.x[8])))}};
    case Kind::film_regime:
      return {{regime_film(static_cast<FilmRegime>(static_cast<int>(point.x[4])), x(0), x(1), x(2),
                           x(3))}};
    case Kind::thermal_reduction:
      return {{gupta_thermal_reduction(x(0), x(1), x(2), x(3), x(4), x(5), x(6))}};
    case Kind::density:
      return {{dowson_higginson_density(x(0))}};
    case Kind::pressure_viscosity:
      return {{viscosity_at(point.scene.friction.viscosity, x(0), x(1), x(2))}};
    case Kind::astm_d341:
      return {{astm_d341_viscosity(x(0), x(1), x(2), x(3), x(4))}};
    case Kind::spectral_moments: {
      const Summits<T> s = summits_from_spectral_moments(x(0), x(1), x(2));
      return {{s.bandwidth, s.summit_density, s.summit_radius, s.summit_height_sd,
               s.summit_plane_offset}};
    }
    case Kind::moment: {
      Values<T> values;
      for (const Order order : orders) values.numbers.push_back(gaussian_moment(order, x(0)));
      return values;
    }
    case Kind::scaled_moment: {
      Values<T> values;
      for (const Order order : orders) {
        values.numbers.push_back(scaled_gaussian_moment(order, x(0)));
        if constexpr (std::is_same_v<T, double>) {  // by the batch function
          double logarithm = 0;
          log_gaussian_moment(order, std::span(&point.x[0], 1), std::span(&logarithm, 1));
          values.numbers.push_back(logarithm);
        } else {
          values.numbers.push_back(log_gaussian_moment(order, x(0)));
        }
      }
      return values;
    }
    default: {
      const OperatingPoint<T> solved =
          MixedContact<T>(point.scene).solve(T(point.scene.speeds.list[0]));
      auto numbers = numbers_of(solved);
      // An undefined number has to be NaN. 0 stands for NaN here, because 0 equals itself.
      if (solved.regime == Regime::collapsed)
        for (const Output undefined :
             {Output::asperity_load_share, Output::fluid_load_share, Output::friction}) {
          T& number = numbers[static_cast<std::size_t>(undefined)];
          if constexpr (std::is_floating_point_v<T>) {
            if (std::isnan(number)) number = 0;
          } else {
            number = T(0);
          }
        }
      return {{numbers.begin(), numbers.end()},
              {static_cast<int>(solved.regime), static_cast<int>(solved.inlet)}};
    }
  }
}
template Values<float> values_of(const Point& point);
template Values<double> values_of(const Point& point);
template Values<long double> values_of(const Point& point);
template Values<Reference> values_of(const Point& point);

namespace {

// max(1, Σ|d ln value/d ln input|) for each value, by differences of the template in 50 digits.
std::vector<double> conditions_by_differences(const Point& point) {
  constexpr double step = 0x1p-26;
  const std::vector<Reference> before = values_of<Reference>(point).numbers;
  std::vector<double> sums(before.size());
  for (std::size_t i = 0; i < point.x.size(); ++i) {
    Point moved = point;
    moved.x[i] *= 1 + step;
    if (moved.x[i] == point.x[i]) continue;
    const std::vector<Reference> after = values_of<Reference>(moved).numbers;
    const double relative = moved.x[i] / point.x[i] - 1;
    for (std::size_t k = 0; k < sums.size(); ++k)
      sums[k] += std::abs(static_cast<double>(Reference(after[k] / before[k] - 1))) / relative;
  }
  for (double& sum : sums) sum = std::max(sum, 1.0);
  return sums;
}

}  // namespace

std::vector<double> conditions_of(const Point& point) {
  const StarvationClosure closure = point.scene.closures.starvation;
  switch (point.kind) {
    case Kind::scene:
    case Kind::extreme_scene: {
      const Conditions all = conditions_at(point.scene, point.scene.speeds.list[0]);
      return {all.begin(), all.end()};
    }
    case Kind::load_sharing:
      return {root_condition(point.scene.closures.asperity, point.x[0], point.x[1], point.x[2],
                             *point.film)};
    case Kind::load_shares: {
      const LoadShares<Dual> shares =
          LoadSharing<Dual>(point.scene.closures.asperity, Dual(point.x[0], 0), Dual(point.x[1], 1),
                            *point.film)
              .solve(Dual(point.x[2], 2));
      return {shares.asperity.condition(), shares.fluid.condition()};
    }
    case Kind::film_ratio:
      return {film_ratio_condition(closure, point.x[0], point.x[1])};
    case Kind::deficit:
      return {1, 1 / point.x[2] + 1 / (1 - point.x[2]), 1};
    case Kind::moment: {
      std::vector<double> all;
      for (const Order order : orders) all.push_back(moment_condition(order, point.x[0]));
      return all;
    }
    case Kind::scaled_moment: {
      std::vector<double> all;
      for (const Order order : orders) {
        all.push_back(1);
        all.push_back(logarithm_condition(log_gaussian_moment(order, point.x[0])));
      }
      return all;
    }
    case Kind::thermal_reduction:
    case Kind::pressure_viscosity:
    case Kind::astm_d341:
    case Kind::spectral_moments:
      return conditions_by_differences(point);
    case Kind::shear:  // the condition of e^x is x, here ln(η/η₀)
      return {1 + point.x[4]};
    default:
      return std::vector<double>(6, 1);
  }
}

Evaluation evaluate(const Point& point) {
  const Values<double> got = values_of<double>(point);
  const Values<long double> truth = values_of<long double>(point);
  Evaluation evaluation;
  const std::size_t row = first_row(point);
  for (std::size_t i = 0; i < got.numbers.size(); ++i)
    evaluation.numbers.push_back({row + i, got.numbers[i], truth.numbers[i]});
  if (point.kind == Kind::scene || point.kind == Kind::extreme_scene) {
    evaluation.state_row = row + number_count;
    evaluation.states_differ =
        got.states != truth.states || !is_share(got.numbers[4]) || !is_share(got.numbers[5]);
  }
  evaluation.condition = [point, known = std::vector<double>()](std::size_t i) mutable {
    if (known.empty()) known = conditions_of(point);
    return known[i];
  };
  return evaluation;
}

Values<Enclosure> enclose(const Point& point) {
  reference::undecided_comparisons = 0;
  Values<Enclosure> values = values_of<Enclosure>(point);
  // The root may be so near the floor that no ball tells them apart. The model then takes one of
  // the two, whose ball holds both.
  if (reference::undecided_comparisons != 0 && point.kind <= Kind::extreme_scene &&
      point.scene.supply.kind == SupplyKind::flooded) {
    const MixedContact<Enclosure> contact(point.scene);
    if (contact.sharing().has_floor() &&
        contact.flooded(point.scene.speeds.list[0]).shares.fluid < Enclosure(0x1p-200))
      reference::undecided_comparisons = 0;
  }
  if (reference::undecided_comparisons != 0) values.numbers.clear();
  return values;
}

double allowed_ulp(const Contract& contract, double condition) {
  return std::max(contract.ulp, contract.ulp_per_condition * condition);
}

bool is_at_the_ends(double got, long double expected) {
  const bool is_of_its_sign = got == 0 || std::signbit(got) == std::signbit(expected);
  return is_of_its_sign && ((std::abs(expected) < 1e-290L && std::abs(got) < 2e-290) ||
                            (std::isinf(got) && expected > 1e280L));
}

}  // namespace tribo::verification
