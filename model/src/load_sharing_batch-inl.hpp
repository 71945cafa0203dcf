// SPDX-License-Identifier: Apache-2.0
// The roots of many points, a block at a time, by the steps of load_sharing-inl.hpp.
#include <hwy/highway.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "load_shares-inl.hpp"
#include "sharing_method.hpp"

#if defined(TRIBO_LOAD_SHARING_BATCH) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIBO_LOAD_SHARING_BATCH
#undef TRIBO_LOAD_SHARING_BATCH
#else
#define TRIBO_LOAD_SHARING_BATCH
#endif

HWY_BEFORE_NAMESPACE();
namespace tribo::HWY_NAMESPACE {

// The next `count` numbers, at most a vector; spare lanes repeat the first.
template <class D>
HWY_INLINE hn::Vec<D> load(D d, const double* from, std::size_t count) {
  const std::size_t lanes = hn::Lanes(d);
  if (count >= lanes) return hn::LoadU(d, from);
  HWY_ALIGN double buffer[hn::MaxLanes(D())];
  for (std::size_t j = 0; j < lanes; ++j) buffer[j] = from[j < count ? j : 0];
  return hn::Load(d, buffer);
}

template <class D>
HWY_INLINE void store(D d, hn::Vec<D> value, double* to, std::size_t count) {
  const std::size_t lanes = hn::Lanes(d);
  if (count >= lanes) return hn::StoreU(value, d, to);
  HWY_ALIGN double buffer[hn::MaxLanes(D())];
  hn::Store(value, d, buffer);
  for (std::size_t j = 0; j < count; ++j) to[j] = buffer[j];
}

// The lanes in which the kernels of the root may be used: nothing there overflows or loses digits.
template <class D>
HWY_INLINE hn::Mask<D> in_range(D d, const SharingInputs<hn::Vec<D>>& in) {
  const auto within = [&](hn::Vec<D> x, double low, double high) HWY_ATTR {
    return hn::And(hn::Ge(x, hn::Set(d, low)), hn::Le(x, hn::Set(d, high)));
  };
  return hn::And(hn::And(within(in.stiffness, sharing_least_stiffness, sharing_greatest_stiffness),
                         within(in.offset, 0, sharing_greatest_offset)),
                 within(in.flooded, sharing_least_film, sharing_greatest_film));
}

#if HWY_TARGET == HWY_AVX2
// For each mask of four lanes: the places of the halves (32 bits) of its lanes, in order.
struct CompressTable {
  alignas(32) std::int32_t halves[16][8];
};
constexpr CompressTable compress_table() {
  CompressTable table{};
  for (int mask = 0; mask < 16; ++mask) {
    int to = 0;
    for (int lane = 0; lane < 4; ++lane)
      if ((mask >> lane & 1) != 0) {
        table.halves[mask][to++] = 2 * lane;
        table.halves[mask][to++] = 2 * lane + 1;
      }
  }
  return table;
}
inline constexpr CompressTable compress_halves = compress_table();
#endif

// The lanes of a mask, moved to the front in order. The function of Highway 1.0.3 for this has a
// table of 2 kB, which g++ copies to the stack at each call.
template <class D>
HWY_INLINE hn::Vec<D> compressed([[maybe_unused]] D d, hn::Vec<D> value, hn::Mask<D> mask) {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
  return hn::Vec<D>{_mm512_maskz_compress_pd(mask.raw, value.raw)};
#elif HWY_TARGET == HWY_AVX2
  const auto* halves = compress_halves.halves[_mm256_movemask_pd(mask.raw)];
  const __m256i order = _mm256_load_si256(reinterpret_cast<const __m256i*>(halves));
  return hn::Vec<D>{_mm256_castps_pd(_mm256_permutevar8x32_ps(_mm256_castpd_ps(value.raw), order))};
#else
  HWY_ALIGN double values[hn::MaxLanes(D())];
  HWY_ALIGN double selected[hn::MaxLanes(D())];
  hn::Store(value, d, values);
  hn::Store(hn::IfThenElseZero(mask, hn::Set(d, 1.0)), d, selected);
  std::size_t count = 0;
  for (std::size_t j = 0; j < hn::Lanes(d); ++j) {
    values[count] = values[j];
    count += selected[j] != 0 ? 1 : 0;
  }
  return hn::Load(d, values);
#endif
}

// The place of a point, which is kept as the bits of a double.
HWY_INLINE std::size_t place_in(double bits) {
  return static_cast<std::size_t>(std::bit_cast<std::uint64_t>(bits));
}

// Up to sharing_block points whose roots are sought. Points that have reached their root are taken
// out, and the others move together, so that no lane waits for another.
template <class D, bool one_surface>
class Travellers {
 public:
  using V = hn::Vec<D>;

  HWY_INLINE Travellers(D d, double film_power) : d_(d), film_power_(film_power) {}
  // surface: that of all points; read only with one_surface.
  HWY_INLINE Travellers(D d, double film_power, const detail::SurfaceNumbers<V>& surface)
      : Travellers(d, film_power) {
    if constexpr (one_surface) {
      stiffness_[0] = hn::GetLane(surface.stiffness);
      offset_[0] = hn::GetLane(surface.offset);
    }
  }

  // Adds points at whose start A is known; they must be added before all others.
  HWY_INLINE void add(hn::Mask<D> mask, const SharingInputs<V>& in, const Iterate<V>& at, V place,
                      const Asperities<V>& known) {
    put(mask, known.share, share_);
    put(mask, known.hazard, hazard_);
    put(mask, known.slope, slope_);
    put(mask, known.bend, bend_);
    add(mask, in, at, place);
    known_ = count_;
  }

  HWY_INLINE void add(hn::Mask<D> mask, const SharingInputs<V>& in, const Iterate<V>& at, V place) {
    if constexpr (!one_surface) {
      put(mask, in.stiffness, stiffness_);
      put(mask, in.offset, offset_);
    }
    put(mask, in.flooded, flooded_);
    put(mask, at.film_parameter, film_parameter_);
    put(mask, at.log_rise, log_rise_);
    put(mask, place, place_);
    count_ += hn::CountTrue(d_, mask);
  }

  // Writes the roots, NaN where one needs more than max_sharing_steps. Returns the sum of steps.
  HWY_INLINE std::size_t travel(Order order, double* result) {
    std::size_t steps = 0;
    for (int step = 0; step < max_sharing_steps && count_ > 0; ++step) {
      steps += count_;
      move(order);
      leave(result);
    }
    for (std::size_t i = 0; i < count_; ++i)
      result[place_of(i)] = std::numeric_limits<double>::quiet_NaN();
    return steps;
  }

 private:
  HWY_INLINE SharingInputs<V> inputs(std::size_t i) const {
    const V flooded = hn::Load(d_, flooded_ + i);
    if constexpr (one_surface)
      return {hn::Set(d_, stiffness_[0]), hn::Set(d_, offset_[0]), flooded};
    else
      return {hn::Load(d_, stiffness_ + i), hn::Load(d_, offset_ + i), flooded};
  }
  HWY_INLINE Iterate<V> iterate(std::size_t i) const {
    return {hn::Load(d_, film_parameter_ + i), hn::Load(d_, log_rise_ + i)};
  }
  HWY_INLINE Asperities<V> asperities_at(std::size_t i) const {
    return {hn::Load(d_, share_ + i), hn::Load(d_, hazard_ + i), hn::Load(d_, slope_ + i),
            hn::Load(d_, bend_ + i)};
  }
  HWY_INLINE std::size_t place_of(std::size_t i) const { return place_in(place_[i]); }
  HWY_INLINE void put(hn::Mask<D> mask, V value, double* to) const {
    hn::StoreU(compressed(d_, value, mask), d_, to + count_);
  }
  template <class Visitor>
  HWY_INLINE void for_each_vector(const Visitor& visit, std::size_t first = 0) const {
    for (std::size_t i = first; i < count_; i += hn::Lanes(d_)) visit(i);
  }

  HWY_INLINE void move(Order order) {
    const V film_power = hn::Set(d_, film_power_);
    for_each_vector(
        [&](std::size_t i) HWY_ATTR {
          const auto at = asperities(d_, order, inputs(i), hn::Load(d_, film_parameter_ + i));
          hn::Store(at.share, d_, share_ + i);
          hn::Store(at.hazard, d_, hazard_ + i);
          hn::Store(at.slope, d_, slope_ + i);
          hn::Store(at.bend, d_, bend_ + i);
        },
        known_ - known_ % hn::Lanes(d_));
    known_ = 0;
    for_each_vector([&](std::size_t i) HWY_ATTR {
      hn::Store(film_share(d_, film_power, hn::Load(d_, log_rise_ + i)), d_, film_share_ + i);
    });
    for_each_vector([&](std::size_t i) HWY_ATTR {
      const V w = hn::Load(d_, film_share_ + i);
      const auto at = asperities_at(i);
      hn::Store(log_balance(d_, at.share, w, is_by_floor(d_, film_power, iterate(i), at, w)), d_,
                balance_ + i);
    });
    for_each_vector([&](std::size_t i) HWY_ATTR {
      const V w = hn::Load(d_, film_share_ + i);
      const Iterate<V> from = iterate(i);
      const Asperities<V> at = asperities_at(i);
      const Step<D> step =
          sharing_step(d_, film_power, hn::Load(d_, flooded_ + i), from, at, w,
                       is_by_floor(d_, film_power, from, at, w), hn::Load(d_, balance_ + i));
      hn::Store(step.base, d_, base_ + i);
      hn::Store(step.shift, d_, shift_ + i);
      hn::StoreMaskBits(d_, step.is_last, is_last_ + i);
      const auto below = is_below_floor(d_, at, from);
      if (hn::AllFalse(d_, below))
        hn::Store(step.log_rise, d_, log_rise_ + i);
      else
        jump(order, i, below, step);
    });
    for_each_vector([&](std::size_t i) HWY_ATTR {
      hn::Store(times_exp(d_, hn::Load(d_, base_ + i), hn::Load(d_, shift_ + i)), d_,
                film_parameter_ + i);
    });
  }

  HWY_NOINLINE void jump(Order order, std::size_t i, hn::Mask<D> below, const Step<D>& step) {
    const Iterate<V> at =
        jump_above_floor(d_, order, hn::Set(d_, film_power_), inputs(i), asperities_at(i));
    hn::Store(hn::IfThenElse(below, at.film_parameter, step.base), d_, base_ + i);
    hn::Store(hn::IfThenZeroElse(below, step.shift), d_, shift_ + i);
    hn::Store(hn::IfThenElse(below, at.log_rise, step.log_rise), d_, log_rise_ + i);
    hn::StoreMaskBits(d_, hn::AndNot(below, step.is_last), is_last_ + i);
  }

  HWY_INLINE void leave(double* result) {
    const std::size_t all = count_;
    count_ = 0;
    for (std::size_t i = 0; i < all; i += hn::Lanes(d_)) {
      const auto present = hn::FirstN(d_, all - i);
      const auto is_last = hn::LoadMaskBits(d_, is_last_ + i);
      const SharingInputs<V> in = inputs(i);
      const Iterate<V> at = iterate(i);
      const V place = hn::Load(d_, place_ + i);
      hn::StoreU(compressed(d_, at.film_parameter, hn::And(is_last, present)), d_, root_);
      hn::StoreU(compressed(d_, place, hn::And(is_last, present)), d_, root_place_);
      const std::size_t there = hn::CountTrue(d_, hn::And(is_last, present));
      for (std::size_t j = 0; j < there; ++j) result[place_in(root_place_[j])] = root_[j];
      add(hn::AndNot(is_last, present), in, at, place);
    }
  }

  static constexpr std::size_t lanes = hn::MaxLanes(D());
  static constexpr std::size_t room = sharing_block + lanes;
  static constexpr std::size_t surface_room = one_surface ? 1 : room;
  HWY_ALIGN std::uint8_t is_last_[room];  // within a step
  D d_;
  std::size_t count_ = 0;
  std::size_t known_ = 0;  // the number of first points with a known A
  double film_power_;
  HWY_ALIGN double stiffness_[surface_room];
  HWY_ALIGN double offset_[surface_room];
  HWY_ALIGN double flooded_[room];
  HWY_ALIGN double film_parameter_[room];
  HWY_ALIGN double log_rise_[room];
  HWY_ALIGN double place_[room];
  // within a step
  HWY_ALIGN double share_[room];
  HWY_ALIGN double hazard_[room];
  HWY_ALIGN double slope_[room];
  HWY_ALIGN double bend_[room];
  HWY_ALIGN double film_share_[room];
  HWY_ALIGN double balance_[room];
  HWY_ALIGN double base_[room];
  HWY_ALIGN double shift_[room];
  HWY_ALIGN double root_[lanes];
  HWY_ALIGN double root_place_[lanes];
};

// The roots of a vector of points, or where the search for them starts.
template <class D>
struct RootStart {
  Iterate<hn::Vec<D>> at;  // the root, or a start; NaN where it is left to Newton's method
  hn::Mask<D> is_open;     // not the root yet
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE RootStart<D> root_start(D d, V film_power, const detail::SurfaceNumbers<V>& surface,
                                   const SharingInputs<V>& in) {
  const auto is_smooth = hn::Lt(surface.film_from, hn::Zero(d));
  const auto good = hn::Or(in_range(d, in), is_smooth);
  const auto is_film = hn::Ge(in.flooded, surface.film_from);
  const auto is_floor = hn::Le(in.flooded, surface.floor_up_to);
  const auto open = hn::AndNot(hn::Or(is_film, is_floor), good);
  const auto below = hn::And(open, hn::Lt(in.flooded, surface.floor));
  const V lambda = hn::IfThenElse(is_floor, surface.floor, in.flooded);
  const V nan = hn::Set(d, std::numeric_limits<double>::quiet_NaN());
  RootStart<D> start{{hn::IfThenElse(good, lambda, nan), hn::Zero(d)}, open};
  if (hn::AllFalse(d, below)) return start;
  const Iterate<V> above =
      above_floor(d, film_power, surface.floor, surface.hazard, hn::Min(in.flooded, surface.floor));
  start.at.film_parameter = hn::IfThenElse(below, above.film_parameter, start.at.film_parameter);
  start.at.log_rise = hn::IfThenElse(below, above.log_rise, start.at.log_rise);
  return start;
}

// The roots for at most sharing_block λ₀. surface_at(i) gives the numbers of the surfaces for the
// vector of points that starts at i. A root that is left to Newton's method is NaN. Returns the
// number of steps.
template <class D, bool one_surface, class SurfaceAt>
HWY_INLINE std::size_t roots_of_block(D d, Order order, double film_power,
                                      const SurfaceAt& surface_at, const double* flooded,
                                      double* result, std::size_t count) {
  using V = hn::Vec<D>;
  const hn::RebindToSigned<D> integers;
  auto place = hn::Iota(integers, 0);
  Travellers<D, one_surface> travellers(d, film_power, surface_at(0));
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const std::size_t left = count - i;
    const detail::SurfaceNumbers<V>& surface = surface_at(i);
    const SharingInputs<V> in{surface.stiffness, surface.offset, load(d, flooded + i, left)};
    const auto start = root_start(d, hn::Set(d, film_power), surface, in);
    store(d, start.at.film_parameter, result + i, left);
    travellers.add(hn::And(start.is_open, hn::FirstN(d, left)), in, start.at,
                   hn::BitCast(d, place));
    place = hn::Add(place, hn::Set(integers, static_cast<std::int64_t>(hn::Lanes(d))));
  }
  return travellers.travel(order, result);
}

// May λ₀ be below a floor, where A > 1? The computed A may be off by some ulp.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> may_be_below_floor(D d, const FilmLaw& law, const Asperities<V>& at) {
  if (law.sharing_exponent.p == 0) [[unlikely]]  // the root is λ₀ or the floor
    return hn::Eq(at.share, at.share);
  return hn::Gt(at.share, hn::Set(d, 0.99));
}

// As roots_of_block(), with a surface for each point. A floor is computed only where λ₀ may be
// below it; elsewhere the root, which is not below λ₀, does not need the floor.
template <class D>
HWY_INLINE std::size_t roots_of_surfaces(D d, Order order, const FilmLaw& law,
                                         const double* stiffness, const double* offset,
                                         const double* flooded, double* result, std::size_t count) {
  using V = hn::Vec<D>;
  const hn::RebindToSigned<D> integers;
  const V film_power = hn::Set(d, law.sharing_power.inverse), zero = hn::Zero(d);
  HWY_ALIGN double lows[sharing_block + hn::MaxLanes(D())];  // places of the `low` points
  std::size_t low_count = 0;
  Travellers<D, false> travellers(d, law.sharing_power.inverse);
  const auto start_of = [&](const detail::SurfaceNumbers<V>& surface, V film) HWY_ATTR {
    return root_start(d, film_power, surface, {surface.stiffness, surface.offset, film});
  };
  auto place = hn::Iota(integers, 0);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const std::size_t left = count - i;
    const auto surface = surface_without_floor(d, law, load(d, stiffness + i, left),
                                               load(d, offset + i, left), zero);
    const SharingInputs<V> in{surface.stiffness, surface.offset, load(d, flooded + i, left)};
    const auto start = start_of(surface, in.flooded);
    store(d, start.at.film_parameter, result + i, left);
    const auto open = hn::And(start.is_open, hn::FirstN(d, left));
    const auto at = asperities(d, order, in, in.flooded);
    const auto low = hn::And(open, may_be_below_floor(d, law, at));
    const V places = hn::BitCast(d, place);
    travellers.add(hn::AndNot(low, open), in, start.at, places, at);
    hn::StoreU(compressed(d, places, low), d, lows + low_count);
    low_count += hn::CountTrue(d, low);
    place = hn::Add(place, hn::Set(integers, static_cast<std::int64_t>(hn::Lanes(d))));
  }
  HWY_ALIGN double floors[sharing_block + hn::MaxLanes(D())];
  for (std::size_t i = 0; i < low_count; i += hn::Lanes(d)) {
    const V places = load(d, lows + i, low_count - i);
    const auto index = hn::BitCast(integers, places);
    const auto present = hn::FirstN(d, low_count - i);
    const auto surface = surface_of(d, order, law, hn::GatherIndex(d, stiffness, index),
                                    hn::GatherIndex(d, offset, index), zero);
    const V film = hn::GatherIndex(d, flooded, index);
    const auto start = start_of(surface, film);
    hn::Store(surface.floor, d, floors + i);
    HWY_ALIGN double films[hn::MaxLanes(D())];
    hn::Store(start.at.film_parameter, d, films);
    for (std::size_t j = 0; j < hn::Lanes(d) && i + j < low_count; ++j)
      result[place_in(lows[i + j])] = films[j];
    travellers.add(hn::And(start.is_open, present), {surface.stiffness, surface.offset, film},
                   start.at, places);
  }
  const std::size_t steps = travellers.travel(order, result);
  for (std::size_t i = 0; i < low_count; ++i) {
    double& root = result[place_in(lows[i])];
    if (root < floors[i]) root = floors[i];
  }
  return steps;
}

}  // namespace tribo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // toggle
