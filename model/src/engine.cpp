// SPDX-License-Identifier: Apache-2.0
// The engine: its kernels for one lane and for vectors, compiled for each instruction set and
// chosen at run time, and the functions of batch.hpp, which call them.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>

#include "tribo/batch.hpp"
#include "tribo/elementary.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "contact-inl.hpp"
#include "engine.hpp"
#include "operating_point-inl.hpp"
#include "processor.hpp"
#include "sharing_method.hpp"

HWY_BEFORE_NAMESPACE();
namespace tribo::HWY_NAMESPACE {

using OneLane = hn::CappedTag<double, 1>;
using Many = hn::ScalableTag<double>;

// function(x) of each argument.
template <class Function>
HWY_INLINE void transform(const double* argument, double* result, std::size_t count,
                          const Function& function) {
  const Many d;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d))
    store(d, function(d, load(d, argument + i, count - i)), result + i, count - i);
}

double moment(Order n, double argument) {
  return hn::GetLane(moment_of(OneLane(), n, hn::Set(OneLane(), argument)));
}
double scaled_moment(Order n, double argument) {
  return hn::GetLane(scaled_moment_of(OneLane(), n, hn::Set(OneLane(), argument)));
}

void moments(Order n, const double* argument, double* result, std::size_t count) {
  transform(argument, result, count, [n](auto d, auto x) HWY_ATTR { return moment_of(d, n, x); });
}

void scaled_moments(Order n, const double* argument, double* result, std::size_t count) {
  transform(argument, result, count,
            [n](auto d, auto x) HWY_ATTR { return scaled_moment_of(d, n, x); });
}

void log_moments(Order n, const double* argument, double* result, std::size_t count) {
  transform(argument, result, count, [n](auto d, auto x) HWY_ATTR {
    const auto half_square = hn::Mul(hn::Mul(hn::Set(d, 0.5), x), x);
    const auto value = hn::Sub(logarithm(d, scaled_moment_of(d, n, x)),
                               hn::IfThenElseZero(hn::Gt(x, hn::Zero(d)), half_square));
    const auto beyond = hn::Not(hn::Lt(hn::Abs(x), hn::Set(d, pieces_end)));
    if (HWY_LIKELY(hn::AllFalse(d, beyond))) return value;
    // F_n itself may overflow a double
    return mend(d, value, x, beyond, [n](double y) {
      return static_cast<double>(log_gaussian_moment(n, static_cast<WiderType<double>>(y)));
    });
  });
}

using One = hn::Vec<OneLane>;
HWY_INLINE One of(double x) { return hn::Set(OneLane(), x); }

double exponential_of(double x) { return hn::GetLane(exponential(OneLane(), of(x))); }
void exponentials_of(const double* x, double* result, std::size_t count) {
  transform(x, result, count, [](auto d, auto lanes) HWY_ATTR { return exponential(d, lanes); });
}
double logarithm_of(double x) { return hn::GetLane(logarithm(OneLane(), of(x))); }
void logarithms_of(const double* x, double* result, std::size_t count) {
  transform(x, result, count, [](auto d, auto lanes) HWY_ATTR { return logarithm(d, lanes); });
}
double power_of(double x, const Exponent& exponent) {
  return hn::GetLane(decimal_power(OneLane(), of(x), exponent));
}

detail::SurfaceNumbers<double> surface(Order order, const FilmLaw& law, double stiffness,
                                       double offset) {
  return first_lane(surface_of(OneLane(), order, law, of(stiffness), of(offset), of(0)));
}
double share(Order order, double stiffness, double argument) {
  return hn::GetLane(share_at(OneLane(), order, of(stiffness), of(argument)));
}
LoadShares<double> at_distance(Order order, const detail::SurfaceNumbers<double>& surface,
                               double distance) {
  const Shares<One> shares =
      shares_above_floor(OneLane(), order, broadcast(OneLane(), surface), of(distance));
  return {surface.floor + distance, hn::GetLane(shares.asperity), hn::GetLane(shares.fluid), 0};
}
double distance_at(Order order, const detail::SurfaceNumbers<double>& surface, double fluid) {
  const OneLane d;
  const auto all = broadcast(d, surface);
  return hn::GetLane(
      distance_above_floor(d, order, FloorSeries<OneLane>(d, order, all), all.hazard, of(fluid)));
}
LoadShares<double> at_root(Order order, const FilmLaw& law,
                           const detail::SurfaceNumbers<double>& surface, double flooded,
                           double lambda) {
  const Shares<One> shares =
      shares_at_root(OneLane(), order, law, broadcast(OneLane(), surface), of(flooded), of(lambda));
  return {lambda, hn::GetLane(shares.asperity), hn::GetLane(shares.fluid), 0};
}

// x, or the bound where x is below it; NaN stays.
template <class V>
HWY_INLINE V not_below(V x, V bound) {
  return hn::IfThenElse(hn::Lt(x, bound), bound, x);
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE Roots<V> roots_alone(D d, Order order, V film_power,
                                const detail::SurfaceNumbers<V>& surface, V flooded) {
  const SharingInputs<V> in{surface.stiffness, surface.offset, flooded};
  const auto start = root_start(d, film_power, surface, in);
  if (hn::AllFalse(d, start.is_open)) return {start.at.film_parameter, 0};
  const Roots<V> roots = roots_from(d, order, film_power, in, start.at,
                                    asperities(d, order, in, start.at.film_parameter));
  return {not_below(roots.film_parameter, surface.floor), roots.steps};
}

SharingRoot<double> root(Order order, const FilmLaw& law,
                         const detail::SurfaceNumbers<double>& surface, double flooded) {
  const Roots<One> found = roots_alone(OneLane(), order, of(law.sharing_power.inverse),
                                       broadcast(OneLane(), surface), of(flooded));
  return {hn::GetLane(found.film_parameter), found.steps};
}

// The root of a surface that is used once. Its floor is computed only where λ₀ may be below the
// floor; elsewhere the root, which is not below λ₀, does not need it.
double root_of_surface(Order order, const FilmLaw& law, double stiffness, double offset,
                       double flooded) {
  const OneLane d;
  const One film_power = of(law.sharing_power.inverse), film = of(flooded);
  const auto surface = surface_without_floor(d, law, of(stiffness), of(offset), of(0));
  const SharingInputs<One> in{surface.stiffness, surface.offset, film};
  const auto start = root_start(d, film_power, surface, in);
  if (hn::AllFalse(d, start.is_open)) return hn::GetLane(start.at.film_parameter);
  const auto at = asperities(d, order, in, film);
  if (hn::AllTrue(d, may_be_below_floor(d, law, at)))
    return root(order, law, first_lane(surface_of(d, order, law, in.stiffness, in.offset, of(0))),
                flooded)
        .film_parameter;
  return hn::GetLane(roots_from(d, order, film_power, in, start.at, at).film_parameter);
}

void prepare(const detail::ContactWords& words, const detail::SceneNumbers<double>* scenes,
             detail::ContactNumbers<double>* contacts, std::size_t count) {
  const Many d;
  const hn::RebindToUnsigned<Many> bits;
  if (count == 1) {
    contacts[0] = first_lane(contact_of(OneLane(), words, broadcast(OneLane(), scenes[0])));
    return;
  }
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const std::size_t some = std::min(hn::Lanes(d), count - i);
    const auto lane = hn::Iota(bits, 0);
    const auto index = hn::IfThenElse(hn::Lt(lane, hn::Set(bits, some)), lane, hn::Zero(bits));
    const auto contact =
        contact_of(d, words, rows_of<detail::SceneNumbers>(d, row_begin(scenes[i]), index));
    for (std::size_t k = 0; k < row_length<detail::ContactNumbers>; ++k) {
      HWY_ALIGN double lanes[hn::MaxLanes(Many())];
      hn::Store(row_begin(contact)[k], d, lanes);
      for (std::size_t j = 0; j < some; ++j) row_begin(contacts[i + j])[k] = lanes[j];
    }
  }
}

InletState<double> inlet(const detail::ContactWords& words,
                         const detail::ContactNumbers<double>& contact, double speed,
                         double film_parameter) {
  const OneLane d;
  const auto state =
      inlet_of(d, words, broadcast(d, contact), of(speed), of(film_parameter), false);
  return {hn::GetLane(state.starvation.film_ratio), hn::GetLane(state.flooded_over_inlet),
          hn::AllTrue(d, state.starvation.is_collapsed)};
}

detail::FilmOfSpeed film_of(const FilmLaw& law, const detail::ContactNumbers<double>& contact,
                            double speed, double log_stiffening) {
  const OneLane d;
  const auto numbers = broadcast(d, contact.film);
  const One s = log_speed_of(d, of(speed)), z = of(log_stiffening);
  const auto film =
      log_film_at(d, law, table_of(law), numbers, of(contact.surface.film_at_unit_speed), s, z);
  return {hn::AllTrue(d, film.is_known) ? hn::GetLane(exponential(d, film.value))
                                        : std::numeric_limits<double>::quiet_NaN(),
          {hn::GetLane(film.by_speed), hn::GetLane(film.by_sharing)}};
}

// Roots of a law without fixed exponents and their ln γ; contact_at(i) as in points_of_block.
template <class D, class ContactAt>
HWY_NOINLINE std::size_t stiffened_roots(D d, const detail::ContactWords& words,
                                         const ContactAt& contact_at, const double* speeds,
                                         double* lambda, double* log_stiffening,
                                         std::size_t count) {
  StiffenedRoots<D, ContactAt> roots(d, load_order(words.model), *words.film, contact_at);
  return roots.solve(speeds, lambda, log_stiffening, count);
}

struct StiffenedRoot {
  double film_parameter, log_stiffening;
  std::size_t steps;
};
StiffenedRoot stiffened_alone(const detail::ContactWords& words,
                              const detail::ContactNumbers<One>& contact, double speed) {
  const auto contact_at = [&](std::size_t) HWY_ATTR -> const auto& { return contact; };
  StiffenedRoot root;
  root.steps = stiffened_roots(OneLane(), words, contact_at, &speed, &root.film_parameter,
                               &root.log_stiffening, 1);
  return root;
}

LoadShares<double> stiffened(const detail::ContactWords& words,
                             const detail::ContactNumbers<double>& contact, double speed) {
  const OneLane d;
  const auto all = broadcast(d, contact);
  const StiffenedRoot root = stiffened_alone(words, all, speed);
  const One lambda = not_below(of(root.film_parameter), all.surface.floor);
  const auto shares = shares_at_stiffening(d, load_order(words.model), all.surface,
                                           of(root.log_stiffening), lambda);
  return {hn::GetLane(lambda), hn::GetLane(shares.asperity), hn::GetLane(shares.fluid),
          static_cast<int>(root.steps)};
}

double film_at(const FilmLaw& law, const detail::ContactNumbers<double>& contact, double speed) {
  return hn::GetLane(flooded_film_parameter(OneLane(), of(contact.surface.film_at_unit_speed),
                                            law.speed_power, of(speed)));
}

void completed(const detail::ContactWords& words, const detail::ContactNumbers<double>& numbers,
               const FloodedFilm<double>& film, const InletState<double>& inlet, OutputSet outputs,
               const detail::Destination& to) {
  const OneLane d;
  const auto contact = broadcast(d, numbers);
  const NeededParts needs(outputs, words.supply);
  const bool shares = needs_shares(d, needs, contact.surface);
  const Flooded<One> flooded{of(film.speed),
                             of(film.shares.film_parameter),
                             {of(film.shares.asperity), of(film.shares.fluid)}};
  Starvation<OneLane> state{of(inlet.film_ratio), of(0),
                            hn::Lt(of(0), of(inlet.collapsed ? 1 : 0))};
  if (needs.is_starved && shares && numbers.surface.hazard > 0)
    state.deficit =
        starvation(d, words, contact, of(film.speed), of(inlet.flooded_over_inlet), true).deficit;
  NoWork none;
  complete(d, words, contact, needs, shares, flooded, state, to, 0, 1, none);
}

double point_alone(const detail::ContactWords& words, const detail::ContactNumbers<double>& numbers,
                   double speed, OutputSet outputs, const detail::Destination& to) {
  const OneLane d;
  const auto contact = broadcast(d, numbers);
  One film0, lambda;
  if (words.film->has_fixed_exponents()) {
    film0 = flooded_film_parameter(d, contact.surface.film_at_unit_speed, words.film->speed_power,
                                   of(speed));
    lambda = roots_alone(d, load_order(words.model), of(words.film->sharing_power.inverse),
                         contact.surface, film0)
                 .film_parameter;
  } else {
    const StiffenedRoot root = stiffened_alone(words, contact, speed);
    film0 = of(root.log_stiffening);
    lambda = not_below(of(root.film_parameter), contact.surface.floor);
  }
  NoWork none;
  return hn::GetLane(complete_root(d, words, contact, NeededParts(outputs, words.supply), of(speed),
                                   film0, lambda, to, 0, 1, none));
}

template <bool one_contact, class ContactAt, class SurfaceAt, class Counter>
HWY_INLINE void points_of_block(const detail::ContactWords& words, const ContactAt& contact_at,
                                const SurfaceAt& surface_at, const double* speeds,
                                const NeededParts& needs, const detail::Destination& to,
                                double* lambda, std::size_t count, Counter& work) {
  const Many d;
  const Exponent speed_power = words.film->speed_power;  // a copy, which no write to film0 changes
  const bool is_by_power = words.film->has_fixed_exponents();
  HWY_ALIGN double film0[sharing_block];  // or ln γ of a law without fixed exponents
  std::size_t steps = 0;
  if (is_by_power) {
    for (std::size_t i = 0; i < count; i += hn::Lanes(d))
      store(d,
            flooded_film_parameter(d, surface_at(i).film_at_unit_speed, speed_power,
                                   load(d, speeds + i, count - i)),
            film0 + i, count - i);
    steps = roots_of_block<Many, one_contact>(d, load_order(words.model),
                                              words.film->sharing_power.inverse, surface_at, film0,
                                              lambda, count);
  } else {
    steps = stiffened_roots(d, words, contact_at, speeds, lambda, film0, count);
  }
  if constexpr (Counter::counts) {
    work.add(Work::root_step, steps);
    for (std::size_t i = 0; is_by_power && i < count; i += hn::Lanes(d)) {
      const auto& surface = surface_at(i);
      const auto film = load(d, film0 + i, count - i);
      const auto present = hn::FirstN(d, count - i);
      const auto is_film = hn::Ge(film, surface.film_from);
      const auto is_floor = hn::AndNot(is_film, hn::Le(film, surface.floor_up_to));
      work.add(Work::root_is_film, hn::CountTrue(d, hn::And(is_film, present)));
      work.add(Work::root_is_floor, hn::CountTrue(d, hn::And(is_floor, present)));
    }
  }
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const std::size_t left = count - i;
    const auto& contact = contact_at(i);
    const auto root = not_below(load(d, lambda + i, left), contact.surface.floor);
    const auto found = complete_root(d, words, contact, needs, load(d, speeds + i, left),
                                     load(d, film0 + i, left), root, to, i, left, work);
    if (words.closure == StarvationClosure::printed_exponents) store(d, found, lambda + i, left);
  }
}

template <class Counter>
void points_at(const detail::ContactWords& words, const detail::ContactNumbers<double>* contacts,
               const std::uint64_t* index, const double* speeds, OutputSet outputs,
               const detail::Destination& to, double* lambda, std::size_t count, Counter& work) {
  const Many d;
  const NeededParts needs(outputs, words.supply);
  if (index == nullptr) {
    const auto contact = broadcast(d, *contacts);
    points_of_block<true>(
        words, [&](std::size_t) HWY_ATTR -> const auto& { return contact; },
        [&](std::size_t) HWY_ATTR -> const auto& { return contact.surface; }, speeds, needs, to,
        lambda, count, work);
    return;
  }
  const hn::RebindToUnsigned<Many> bits;
  const auto rows_at = [&](std::size_t i) HWY_ATTR {
    HWY_ALIGN std::uint64_t rows[hn::MaxLanes(Many())];
    for (std::size_t j = 0; j < hn::Lanes(d); ++j) rows[j] = index[i + j < count ? i + j : i];
    return hn::Load(bits, rows);
  };
  const double* base = row_begin(*contacts);
  points_of_block<false>(
      words,
      [&](std::size_t i) HWY_ATTR { return rows_of<detail::ContactNumbers>(d, base, rows_at(i)); },
      [&](std::size_t i) HWY_ATTR {
        return rows_of<detail::SurfaceNumbers>(d, base, rows_at(i),
                                               row_length<detail::ContactNumbers>);
      },
      speeds, needs, to, lambda, count, work);
}

void points(const detail::ContactWords& words, const detail::ContactNumbers<double>* contacts,
            const std::uint64_t* index, const double* speeds, OutputSet outputs,
            const detail::Destination& to, double* lambda, std::size_t count, WorkCounts* work) {
  NoWork none;
  if (work == nullptr)
    points_at(words, contacts, index, speeds, outputs, to, lambda, count, none);
  else
    points_at(words, contacts, index, speeds, outputs, to, lambda, count, *work);
}

// Roots of one surface, or of as many as there are points.
std::size_t roots_of_one(Order order, const FilmLaw& law,
                         const detail::SurfaceNumbers<double>& surface, const double* flooded,
                         double* lambda, std::size_t count) {
  const Many d;
  const auto all = broadcast(d, surface);
  const std::size_t steps = roots_of_block<Many, true>(
      d, order, law.sharing_power.inverse, [&](std::size_t) HWY_ATTR -> const auto& { return all; },
      flooded, lambda, count);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d))
    store(d, not_below(load(d, lambda + i, count - i), all.floor), lambda + i, count - i);
  return steps;
}
std::size_t roots_of_many(Order order, const FilmLaw& law, const double* stiffness,
                          const double* offset, const double* flooded, double* lambda,
                          std::size_t count) {
  return roots_of_surfaces(Many(), order, law, stiffness, offset, flooded, lambda, count);
}

const char* target_name() { return hwy::TargetName(HWY_TARGET); }

const detail::Kernels& kernels() {
  static constexpr detail::Kernels all{
      .instruction_set = target_name,
      .is_fused = HWY_NATIVE_FMA != 0,
      .moment = moment,
      .scaled_moment = scaled_moment,
      .moments = moments,
      .scaled_moments = scaled_moments,
      .log_moments = log_moments,
      .exponential = exponential_of,
      .exponentials = exponentials_of,
      .logarithm = logarithm_of,
      .logarithms = logarithms_of,
      .power = power_of,
      .surface = surface,
      .share = share,
      .shares_above_floor = at_distance,
      .distance_above_floor = distance_at,
      .root = root,
      .root_of_surface = root_of_surface,
      .shares_at_root = at_root,
      .roots_of_one = roots_of_one,
      .roots_of_many = roots_of_many,
      .prepare = prepare,
      .film_of = film_of,
      .stiffened = stiffened,
      .flooded_film_parameter = film_at,
      .inlet = inlet,
      .complete = completed,
      .point = point_alone,
      .points = points,
  };
  return all;
}

}  // namespace tribo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace tribo {
namespace {

HWY_EXPORT(kernels);

// The chosen kernels. They are kept because choosing takes long compared with a kernel's call.
// Null: choose anew.
constinit std::atomic<const detail::Kernels*> chosen = nullptr;

void choose_from(std::int64_t targets) {
  hwy::SetSupportedTargetsForTest(targets);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  chosen = nullptr;
}

struct Names {
  std::array<std::string_view, 16> names{};
  std::array<std::int64_t, 16> targets{};
  std::size_t count = 0;
};

// In Highway's masks the better target has the lower bit.
Names find_names() {
  const std::int64_t found = hwy::SupportedTargets();
  const std::int64_t supported = found & ~detail::switched_off_targets();
  if (supported != found) {
    // DisableTargets() of Highway 1.0.3 lasts until SupportedTargets() is called; this lasts.
    choose_from(supported);
  }
  Names all;
  for (std::int64_t left = supported & HWY_TARGETS; left != 0; left &= left - 1) {
    all.targets[all.count] = left & -left;
    all.names[all.count++] = hwy::TargetName(left & -left);
  }
  return all;
}

const Names& names() {
  static const Names all = find_names();
  return all;
}

// The names are found before main() begins, and so before any kernel is chosen.
[[maybe_unused]] const Names& found_before_main = names();

// Calls kernel(first, count, roots), which returns its steps, for each block. The results go
// through a buffer, so that they may overwrite an argument. A root that the kernel leaves is NaN,
// and is left to Newton's method, newton(index).
template <class Kernel, class Newton>
SharingWork in_blocks(std::size_t count, std::span<double> film_parameter, const Kernel& kernel,
                      const Newton& newton) {
  std::array<double, sharing_block> lambda;
  SharingWork work;
  for (std::size_t first = 0; first < count; first += sharing_block) {
    const std::size_t some = std::min(sharing_block, count - first);
    work.steps += kernel(first, some, lambda.data());
    for (std::size_t i = 0; i < some; ++i) {
      if (!std::isnan(lambda[i])) continue;
      lambda[i] = newton(first + i);
      ++work.by_newton;
    }
    std::copy_n(lambda.begin(), some, film_parameter.begin() + static_cast<std::ptrdiff_t>(first));
  }
  return work;
}

}  // namespace

double gaussian_moment(Order n, double d) { return detail::engine().moment(n, d); }
double scaled_gaussian_moment(Order n, double d) { return detail::engine().scaled_moment(n, d); }

double moment_beyond_pieces(Order n, double d) {
  using Wide = WiderType<double>;
  if (d != d) return d;
  return static_cast<double>(d > 0 ? detail::far_above(n, static_cast<Wide>(d))
                                   : detail::far_below(n, static_cast<Wide>(-d)));
}

void gaussian_moment(Order n, std::span<const double> d, std::span<double> moments) {
  detail::engine().moments(n, d.data(), moments.data(), d.size());
}
void scaled_gaussian_moment(Order n, std::span<const double> d, std::span<double> moments) {
  detail::engine().scaled_moments(n, d.data(), moments.data(), d.size());
}
void log_gaussian_moment(Order n, std::span<const double> d, std::span<double> logarithms) {
  detail::engine().log_moments(n, d.data(), logarithms.data(), d.size());
}

namespace detail {

const Kernels& engine() {
  const Kernels* known = chosen.load(std::memory_order_relaxed);
  if (known == nullptr) [[unlikely]] {
    known = &HWY_DYNAMIC_DISPATCH(kernels)();
    chosen.store(known, std::memory_order_relaxed);
  }
  return *known;
}

bool is_within_engine(double stiffness, double offset) {
  return stiffness >= sharing_least_stiffness && stiffness <= sharing_greatest_stiffness &&
         offset >= 0 && offset <= sharing_greatest_offset;
}

}  // namespace detail

double film_parameter(AsperityModel model, double stiffness, double offset, double flooded,
                      const FilmLaw& film) {
  const double root =
      detail::engine().root_of_surface(load_order(model), film, stiffness, offset, flooded);
  if (root == root) return root;
  return LoadSharing<double>(model, stiffness, offset, film).film_parameter(flooded);
}

SharingWork film_parameter(AsperityModel model, std::span<const double> stiffness,
                           std::span<const double> offset, std::span<const double> flooded,
                           std::span<double> film_parameter, const FilmLaw& film) {
  return in_blocks(
      flooded.size(), film_parameter,
      [&](std::size_t first, std::size_t count, double* lambda) {
        return detail::engine().roots_of_many(load_order(model), film, &stiffness[first],
                                              &offset[first], &flooded[first], lambda, count);
      },
      [&](std::size_t i) {
        return LoadSharing<double>(model, stiffness[i], offset[i], film).film_parameter(flooded[i]);
      });
}

SharingWork film_parameter(const LoadSharing<double>& sharing, std::span<const double> flooded,
                           std::span<double> film_parameter) {
  return in_blocks(
      flooded.size(), film_parameter,
      [&](std::size_t first, std::size_t count, double* lambda) {
        return detail::engine().roots_of_one(load_order(sharing.model()), sharing.film(),
                                             sharing.surface(), &flooded[first], lambda, count);
      },
      [&](std::size_t i) { return sharing.film_parameter(flooded[i]); });
}

bool is_fused() { return detail::engine().is_fused; }

void exponential(std::span<const double> x, std::span<double> result) {
  detail::engine().exponentials(x.data(), result.data(), x.size());
}
void logarithm(std::span<const double> x, std::span<double> result) {
  detail::engine().logarithms(x.data(), result.data(), x.size());
}

std::string_view arithmetic() { return is_fused() ? "FMA" : "no FMA"; }

std::string_view instruction_set() { return detail::engine().instruction_set(); }

std::span<const std::string_view> instruction_sets() {
  return std::span(names().names).first(names().count);
}

bool use_instruction_set(std::string_view name) {
  for (std::size_t i = 0; i < names().count; ++i) {
    if (names().names[i] != name) continue;
    choose_from(names().targets[i]);
    return true;
  }
  return false;
}

}  // namespace tribo
#endif  // HWY_ONCE
