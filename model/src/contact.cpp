// SPDX-License-Identifier: Apache-2.0
// LoadSharing<double> and MixedContact<double>: the engine's numbers, and beyond its range those of
// the template in long double, rounded.
#include <cmath>
#include <limits>

#include "engine.hpp"
#include "operating_points_arrays.hpp"
#include "tribo/load_sharing.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/onset.hpp"

namespace tribo {
namespace {

using Wide = WiderType<double>;

double narrow(Wide x) { return static_cast<double>(x); }

LoadShares<double> narrow(const LoadShares<Wide>& shares) {
  return {narrow(shares.film_parameter), narrow(shares.asperity), narrow(shares.fluid),
          shares.iterations};
}

FloodedFilm<Wide> widened(const FloodedFilm<double>& film) {
  return {Wide(film.speed),
          {Wide(film.shares.film_parameter), Wide(film.shares.asperity), Wide(film.shares.fluid),
           film.shares.iterations}};
}

LoadSharing<Wide> wide(AsperityModel model, const FilmLaw& film,
                       const detail::SurfaceNumbers<double>& surface) {
  return {model, Wide(surface.stiffness), Wide(surface.offset), film};
}

// Sets the floor, and the numbers about it, of a surface beyond the engine's range.
void set_floor(const LoadSharing<Wide>& sharing, detail::SurfaceNumbers<double>& surface) {
  surface.floor = narrow(sharing.floor());
  surface.floor_argument = sharing.has_floor() ? narrow(sharing.floor() - sharing.offset()) : 0;
  surface.hazard = 0;
  if (sharing.has_floor())
    surface.hazard =
        is_finite(surface.floor)
            ? narrow(-sharing.asperity_share_slope_above_floor(Wide(0)) / sharing.floor())
            : surface.floor;
  surface.floor_up_to = 0;
  surface.film_from = std::numeric_limits<double>::infinity();
}

detail::SurfaceNumbers<double> surface_of(AsperityModel model, const FilmLaw& film,
                                          double stiffness, double offset) {
  if (detail::is_within_engine(stiffness, offset))
    return detail::engine().surface(load_order(model), film, stiffness, offset);
  detail::SurfaceNumbers<double> surface{stiffness, offset, 0, 0, 0, 0, 0, 0};
  set_floor(wide(model, film, surface), surface);
  return surface;
}

}  // namespace

LoadSharing<double>::LoadSharing(AsperityModel model, double stiffness, double offset,
                                 const FilmLaw& film)
    : model_(model), film_(&film), surface_(surface_of(model, film, stiffness, offset)) {}

double LoadSharing<double>::asperity_share(double film_parameter) const {
  return detail::engine().share(load_order(model_), stiffness(), film_parameter - offset());
}

double LoadSharing<double>::asperity_share_slope(double film_parameter) const {
  const double argument = film_parameter - offset();
  const Order order = load_order(model_);
  const double hazard =
      detail::moment_hazard(order, scaled_gaussian_moment(order, argument), argument);
  return -film_parameter * sharing_exponent<double>(model_) * hazard;
}

double LoadSharing<double>::distance_above_floor(double fluid) const {
  return detail::engine().distance_above_floor(load_order(model_), surface_, fluid);
}

LoadShares<double> LoadSharing<double>::shares_above_floor(double distance) const {
  return detail::engine().shares_above_floor(load_order(model_), surface_, distance);
}

double LoadSharing<double>::flooded_film_parameter(double film_parameter,
                                                   double fluid_share) const {
  return film_parameter * detail::engine().power(fluid_share, film_->sharing_power);
}

SharingRoot<double> LoadSharing<double>::root(double flooded_film_parameter) const {
  const Root found =
      detail::engine().root(load_order(model_), *film_, surface_, flooded_film_parameter);
  if (found.film_parameter == found.film_parameter) return found;
  const auto exact = wide(model_, *film_, surface_).root(Wide(flooded_film_parameter));
  const double lambda = narrow(exact.film_parameter);
  return {lambda < floor() ? floor() : lambda, exact.iterations};
}

double LoadSharing<double>::film_parameter(double flooded_film_parameter) const {
  return root(flooded_film_parameter).film_parameter;
}

LoadShares<double> LoadSharing<double>::solve(double flooded_film_parameter) const {
  const Root found =
      detail::engine().root(load_order(model_), *film_, surface_, flooded_film_parameter);
  if (found.film_parameter == found.film_parameter) return shares_at(flooded_film_parameter, found);
  LoadShares<double> shares =
      narrow(wide(model_, *film_, surface_).solve(Wide(flooded_film_parameter)));
  if (shares.film_parameter < floor()) shares.film_parameter = floor();
  return shares;
}

LoadShares<double> LoadSharing<double>::shares_at(double flooded_film_parameter,
                                                  const Root& root) const {
  LoadShares<double> shares = detail::engine().shares_at_root(
      load_order(model_), *film_, surface_, flooded_film_parameter, root.film_parameter);
  shares.iterations = root.iterations;
  return shares;
}

namespace detail {

ContactWords words_of(const Scene& scene) { return words_of(scene, film_law(scene)); }
ContactWords words_of(const Scene& scene, const FilmLaw& film) {
  return {scene.bodies.shape(),
          scene.closures.asperity,
          scene.closures.starvation,
          scene.supply.kind,
          scene.friction.fluid,
          scene.friction.viscosity,
          &film,
          scene.lubricant.thermal};
}

namespace {

MixedContact<Wide> wide_contact(const ContactWords& words, const SceneNumbers<double>& scene) {
  auto numbers = numbers_in<Wide>(scene);
  if (words.shape == ContactShape::ellipse) numbers.set_ellipse();
  return MixedContact<Wide>(words, numbers);
}

// Sets the numbers of a contact beyond the engine's range.
void set_numbers(const MixedContact<Wide>& exact, ContactNumbers<double>& contact) {
  const AsperityContact<Wide>& asperities = exact.asperities();
  const HertzContact<Wide>& hertz = exact.hertz();
  contact.surface.stiffness = narrow(asperities.stiffness);
  contact.area_factor = narrow(asperities.area_factor);
  contact.count_factor = narrow(asperities.count_factor);
  contact.semi_axis_x = narrow(hertz.semi_axis_x);
  contact.nominal_area = narrow(hertz.nominal_area);
  contact.mean_pressure = narrow(hertz.mean_pressure);
  contact.approach = narrow(hertz.approach);
  set_floor(exact.sharing(), contact.surface);
}

}  // namespace

void prepare(const ContactWords& words, std::span<const SceneNumbers<double>> scenes,
             std::span<ContactNumbers<double>> contacts) {
  engine().prepare(words, scenes.data(), contacts.data(), scenes.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    SurfaceNumbers<double>& surface = contacts[i].surface;
    // The kernels have no heated inlet.
    if (words.thermal != ThermalInlet::none)
      surface.film_at_unit_speed = std::numeric_limits<double>::quiet_NaN();
    if (std::isnan(surface.film_at_unit_speed))
      set_numbers(wide_contact(words, scenes[i]), contacts[i]);
    else if (scenes[i].summit_density == 0)
      surface.film_from = film_from_of_smooth;
    else if (!is_within_engine(surface.stiffness, surface.offset))
      set_floor(wide(words.model, *words.film, surface), surface);
  }
}

}  // namespace detail

MixedContact<double>::MixedContact(const Scene& scene) : MixedContact(scene, film_law(scene)) {}

MixedContact<double>::MixedContact(const Scene& scene, const FilmLaw& film)
    : words_(detail::words_of(scene, film)), scene_(detail::numbers_of<double>(scene)) {
  detail::prepare(words_, std::span(&scene_, 1), std::span(&numbers_, 1));
}

HertzContact<double> MixedContact<double>::hertz() const {
  const double axis = numbers_.semi_axis_x, mean = numbers_.mean_pressure;
  HertzContact<double> contact{axis, axis,         numbers_.nominal_area,
                               mean, 3 * mean / 2, numbers_.approach};
  if (words_.shape == ContactShape::ellipse) contact.semi_axis_y = axis * scene_.ellipse.axes_ratio;
  if (words_.shape == ContactShape::line) {
    contact.semi_axis_y = scene_.across / 2;
    contact.peak_pressure = 2 * two_over_pi<double>() * mean;
  }
  return contact;
}

// Does the engine give λ₀ at this speed? Where it does not, it computes nothing else either.
bool MixedContact<double>::is_within_engine(double speed) const {
  return speed >= least_speed && speed <= greatest_speed &&
         !std::isnan(numbers_.surface.film_at_unit_speed);
}

double MixedContact<double>::inlet_film_parameter(double speed) const {
  if (!is_within_engine(speed)) return narrow(in<Wide>().inlet_film_parameter(Wide(speed)));
  if (supply() == SupplyKind::inlet_film_ratio) return numbers_.supply;
  const double film =
      supply() == SupplyKind::inlet_flow ? numbers_.supply / speed : numbers_.supply;
  return film / summit_height_sd();
}

double MixedContact<double>::flooded_film_parameter(double speed) const {
  if (!is_within_engine(speed)) return narrow(in<Wide>().flooded_film_parameter(Wide(speed)));
  if (!film().has_fixed_exponents())
    return detail::engine().film_of(film(), numbers_, speed, 0).film_parameter;
  return detail::engine().flooded_film_parameter(film(), numbers_, speed);
}

double MixedContact<double>::speed_at(double flooded_film_parameter) const {
  if (!film().has_fixed_exponents() || !is_within_engine(1))
    return narrow(in<Wide>().speed_at(Wide(flooded_film_parameter)));
  return detail::engine().power(flooded_film_parameter / numbers_.surface.film_at_unit_speed,
                                inverse(film().speed_exponent));
}

double MixedContact<double>::speed_at(const LoadShares<double>& shares) const {
  if (film().has_fixed_exponents())
    return speed_at(sharing().flooded_film_parameter(shares.film_parameter, shares.fluid));
  return narrow(in<Wide>().speed_at(widened({0, shares}).shares));
}

FilmExponents<double> MixedContact<double>::film_exponents(
    const FloodedFilm<double>& flooded) const {
  if (film().has_fixed_exponents())
    return {ratio<double>(film().speed_exponent), ratio<double>(film().sharing_exponent)};
  if (is_within_engine(flooded.speed) && flooded.shares.fluid > 0)
    return detail::engine()
        .film_of(film(), numbers_, flooded.speed, -detail::engine().logarithm(flooded.shares.fluid))
        .exponents;
  const FilmExponents<Wide> exponents = in<Wide>().film_exponents(widened(flooded));
  return {narrow(exponents.speed), narrow(exponents.sharing)};
}

FloodedFilm<double> MixedContact<double>::flooded(double speed) const {
  if (is_within_engine(speed) && film().has_fixed_exponents())
    return {speed, sharing().solve(flooded_film_parameter(speed))};
  if (is_within_engine(speed)) {
    const LoadShares<double> shares = detail::engine().stiffened(words_, numbers_, speed);
    if (!std::isnan(shares.film_parameter)) return {speed, shares};
  }
  return {speed, narrow(in<Wide>().flooded(Wide(speed)).shares)};
}

InletState<double> MixedContact<double>::inlet(const FloodedFilm<double>& film) const {
  if (!is_within_engine(film.speed)) {
    const InletState<Wide> state = in<Wide>().inlet(widened(film));
    return {narrow(state.film_ratio), narrow(state.flooded_over_inlet), state.collapsed};
  }
  return detail::engine().inlet(words_, numbers_, film.speed, film.shares.film_parameter);
}

OperatingPoint<double> MixedContact<double>::complete(const FloodedFilm<double>& flooded,
                                                      const InletState<double>& inlet,
                                                      OutputSet outputs) const {
  if (!is_within_engine(flooded.speed))
    return detail::in_double(in<Wide>().complete(
        widened(flooded), {Wide(inlet.film_ratio), Wide(inlet.flooded_over_inlet), inlet.collapsed},
        outputs));
  OperatingPoint<double> point;
  detail::engine().complete(words_, numbers_, flooded, inlet, outputs,
                            detail::destination(point, outputs));
  point.speed = flooded.speed;
  return point;
}

WalkPoint<double> StribeckWalk<double>::at(double log_speed) const {
  WalkPoint<double> point;
  point.flooded = contact_.flooded(detail::engine().exponential(log_speed));
  point.inlet = contact_.inlet(point.flooded);
  const LoadShares<double>& shares = point.flooded.shares;
  point.film_slope = detail::film_slope(
      contact_.film_exponents(point.flooded), shares,
      shares.asperity > 0 ? contact_.sharing().asperity_share_slope(shares.film_parameter) : 0.0);
  point.rate = 1;
  return point;
}

double StribeckWalk<double>::near(double speed) const { return detail::engine().logarithm(speed); }

template <>
double detail::log_flow_ratio(const MixedContact<double>& contact, const WalkPoint<double>& point) {
  return engine().logarithm(point.flooded.shares.film_parameter) +
         engine().logarithm(contact.summit_height_sd()) + engine().logarithm(point.flooded.speed) -
         engine().logarithm(contact.inlet_flow());
}

namespace {

// A point beyond the engine's range. It is not inlined, because most points are within the range.
[[gnu::noinline]] void solve_wide(const MixedContact<double>& contact, OutputSet outputs,
                                  OperatingPoint<double>& point) {
  point = detail::in_double(contact.in<Wide>().solve(Wide(point.speed), outputs));
}

}  // namespace

OperatingPoint<double> MixedContact<double>::solve(double speed, OutputSet outputs) const {
  OperatingPoint<double> point;
  const double film_parameter =
      detail::engine().point(words_, numbers_, speed, outputs, detail::destination(point, outputs));
  point.speed = speed;
  if (film_parameter != film_parameter) solve_wide(*this, outputs, point);
  return point;
}

}  // namespace tribo
