// SPDX-License-Identifier: Apache-2.0
// The root of load sharing by a law without fixed exponents (stiffened_film-inl.hpp) in double,
// once for each instruction set, for one lane and for vectors: 1 − A(λ) = 1/γ. It is sought in z =
// ln γ, by the steps of load_sharing-inl.hpp. In each step the law counts as one of fixed exponents
// with a small curvature.
#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <limits>

#include "load_sharing_batch-inl.hpp"
#include "stiffened_film-inl.hpp"

#if defined(TRIBO_STIFFENED_ROOTS) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIBO_STIFFENED_ROOTS
#undef TRIBO_STIFFENED_ROOTS
#else
#define TRIBO_STIFFENED_ROOTS
#endif

HWY_BEFORE_NAMESPACE();
namespace tribo::HWY_NAMESPACE {

// ln u, NaN beyond the kernels' range.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V log_speed_of(D d, V speed) {
  const auto is_within =
      hn::And(hn::Ge(speed, hn::Set(d, least_speed)), hn::Le(speed, hn::Set(d, greatest_speed)));
  return hn::IfThenElse(is_within, logarithm(d, speed),
                        hn::Set(d, std::numeric_limits<double>::quiet_NaN()));
}

// Up to sharing_block points whose roots are sought. A step is split into functions of a vector of
// points. Each is called for all vectors with an open point before the next one, because a
// processor does not look ahead over the chain of all. contact_at(i) gives the numbers of the
// contacts for the vector of points that starts at i.
template <class D, class ContactAt>
class StiffenedRoots {
 public:
  using V = hn::Vec<D>;

  HWY_INLINE StiffenedRoots(D d, Order order, const FilmLaw& law, const ContactAt& contact_at)
      : d_(d), order_(order), law_(law), table_(table_of(law)), contact_at_(contact_at) {}

  // Each root λ and its ln γ; λ is NaN where it is left to the template. Returns the number of
  // steps.
  HWY_INLINE std::size_t solve(const double* speeds, double* film_parameter, double* log_stiffening,
                               std::size_t count) {
    start(speeds, count);
    std::size_t steps = 0;
    for (int step = 0; step < max_sharing_steps && vectors_ > 0; ++step) {
      for (std::size_t k = 0; k < vectors_; ++k) touch(places_[k]);
      const std::size_t all = vectors_;
      vectors_ = 0;
      for (std::size_t k = 0; k < all; ++k) {
        const std::size_t i = places_[k];
        const auto open = hn::LoadMaskBits(d_, is_open_ + i);
        steps += hn::CountTrue(d_, hn::And(open, hn::FirstN(d_, count - i)));
        if (move(i, open)) places_[vectors_++] = i;
      }
      for (std::size_t k = 0; k < vectors_; ++k) find_film(places_[k]);
    }
    const V nan = hn::Set(d_, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < count; i += hn::Lanes(d_)) {
      const V root = hn::Load(d_, root_ + i);
      // is_known tells of the last film that was computed: its ln γ is within 1e-5 of the root's.
      const auto is_known = hn::LoadMaskBits(d_, is_known_ + i);
      store(d_, hn::IfThenElse(is_known, root, nan), film_parameter + i, count - i);
      store(d_, hn::Load(d_, root_log_stiffening_ + i), log_stiffening + i, count - i);
    }
    return steps;
  }

 private:
  HWY_INLINE void start(const double* speeds, std::size_t count) {
    const V zero = hn::Zero(d_), one = hn::Set(d_, 1.0);
    const V nan = hn::Set(d_, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < count; i += hn::Lanes(d_)) {
      hn::Store(log_speed_of(d_, load(d_, speeds + i, count - i)), d_, log_speed_ + i);
      hn::Store(zero, d_, log_stiffening_ + i);
      hn::Store(zero, d_, root_log_stiffening_ + i);
      find_film(i);
    }
    for (std::size_t i = 0; i < count; i += hn::Lanes(d_)) {
      const auto& surface = contact_at_(i).surface;
      const V lambda = hn::Load(d_, film_parameter_ + i);
      const SharingInputs<V> in{surface.stiffness, surface.offset, lambda};
      hn::Store(lambda, d_, flooded_ + i);
      const auto good = hn::And(hn::Or(in_range(d_, in), hn::Lt(surface.film_from, zero)),
                                hn::Eq(lambda, lambda));
      const auto is_film = hn::Ge(lambda, surface.film_from);
      hn::Store(hn::IfThenElse(hn::And(good, is_film), lambda, nan), d_, root_ + i);
      const auto open = hn::AndNot(is_film, good);
      if (hn::AllFalse(d_, open)) continue;
      hn::StoreMaskBits(d_, open, is_open_ + i);
      places_[vectors_++] = i;
      const auto below = hn::And(open, hn::Lt(lambda, surface.floor));
      if (hn::AllFalse(d_, below)) continue;
      const V e = hn::Load(d_, exponent_ + i);
      jump(i, below,
           above_floor(d_, hn::Div(one, e), surface.floor, surface.hazard,
                       hn::Min(lambda, surface.floor)));
      find_film(i);
    }
  }

  HWY_INLINE void find_film(std::size_t i) {
    const auto& contact = contact_at_(i);
    const LogFilm<D> film =
        log_film_at(d_, law_, table_, contact.film, contact.surface.film_at_unit_speed,
                    hn::Load(d_, log_speed_ + i), hn::Load(d_, log_stiffening_ + i));
    // Where a film does not grow with γ, a NaN leaves the root to the template.
    const V e = hn::IfThenElse(hn::Gt(film.by_sharing, hn::Set(d_, 1e-6)), film.by_sharing,
                               hn::Set(d_, std::numeric_limits<double>::quiet_NaN()));
    hn::Store(e, d_, exponent_ + i);
    hn::Store(film.bend, d_, film_bend_ + i);
    hn::Store(exponential(d_, film.value), d_, film_parameter_ + i);
    hn::StoreMaskBits(d_, film.is_known, is_known_ + i);
  }

  HWY_INLINE SharingInputs<V> inputs(std::size_t i) const {
    const auto& surface = contact_at_(i).surface;
    return {surface.stiffness, surface.offset, hn::Load(d_, flooded_ + i)};
  }

  HWY_INLINE void touch(std::size_t i) {
    const auto at = asperities(d_, order_, inputs(i), hn::Load(d_, film_parameter_ + i));
    hn::Store(at.share, d_, share_ + i);
    hn::Store(at.hazard, d_, hazard_ + i);
    hn::Store(at.slope, d_, slope_ + i);
    hn::Store(at.bend, d_, bend_ + i);
  }

  // Takes film and asperities to the root or the next ln γ. Returns whether a lane is open.
  HWY_INLINE bool move(std::size_t i, hn::Mask<D> open) {
    const V one = hn::Set(d_, 1.0);
    const V z = hn::Load(d_, log_stiffening_ + i), lambda = hn::Load(d_, film_parameter_ + i);
    const Asperities<V> at{hn::Load(d_, share_ + i), hn::Load(d_, hazard_ + i),
                           hn::Load(d_, slope_ + i), hn::Load(d_, bend_ + i)};
    // In y = e z, with the exponent e at this film, the law has the power 1/p = e and a curvature.
    const V e = hn::Load(d_, exponent_ + i), p = hn::Div(one, e);
    const V film_bend = hn::Mul(hn::Mul(hn::Load(d_, film_bend_ + i), p), p);
    const Iterate<V> now{lambda, hn::Mul(e, z)};
    const V w = film_share(d_, one, z);
    const auto by_floor = is_by_floor(d_, p, now, at, w);
    const Step<D> step = step_by(d_, p, lambda, now, bent(rises_of(at, lambda), film_bend),
                                 at.share, w, by_floor, log_balance(d_, at.share, w, by_floor));
    const V rise = hn::Sub(step.log_rise, now.log_rise);
    const V next = hn::Mul(step.log_rise, p), dz = hn::Mul(rise, p);
    // The third derivative of ln λ in z, which the step leaves out, is below 1.
    const auto is_exact = hn::Lt(hn::Abs(hn::Mul(hn::Mul(dz, dz), dz)), hn::Set(d_, 0x1p-50));
    const auto below = hn::And(is_below_floor(d_, at, now), open);
    const auto arrives = hn::AndNot(below, hn::And(hn::And(step.is_last, is_exact), open));
    if (!hn::AllFalse(d_, arrives)) {
      const V change = hn::MulAdd(hn::Mul(hn::Set(d_, 0.5), film_bend), hn::Mul(rise, rise), rise);
      hn::Store(hn::IfThenElse(arrives, times_exp(d_, lambda, change), hn::Load(d_, root_ + i)), d_,
                root_ + i);
      hn::Store(hn::IfThenElse(arrives, next, hn::Load(d_, root_log_stiffening_ + i)), d_,
                root_log_stiffening_ + i);
      open = hn::AndNot(arrives, open);
    }
    if (hn::AllFalse(d_, open)) return false;
    hn::StoreMaskBits(d_, open, is_open_ + i);
    hn::Store(hn::IfThenElse(open, next, z), d_, log_stiffening_ + i);
    if (HWY_UNLIKELY(!hn::AllFalse(d_, below)))
      jump(i, below, jump_above_floor(d_, order_, p, inputs(i), at));
    return true;
  }

  HWY_INLINE void jump(std::size_t i, hn::Mask<D> lanes, const Iterate<V>& to) {
    const V z = hn::Div(to.log_rise, hn::Load(d_, exponent_ + i));
    hn::Store(hn::IfThenElse(lanes, z, hn::Load(d_, log_stiffening_ + i)), d_, log_stiffening_ + i);
  }

  // A vector has at most 8 lanes: with 8 more numbers each array has room for whole vectors.
  static constexpr std::size_t room = sharing_block + 8;
  static_assert(hn::MaxLanes(D()) <= 8);
  D d_;
  Order order_;
  const FilmLaw& law_;
  const FilmTable* table_;
  const ContactAt& contact_at_;
  std::size_t vectors_ = 0;
  std::size_t places_[room];  // where the vectors with an open point begin
  HWY_ALIGN double log_speed_[room];
  HWY_ALIGN double log_stiffening_[room];
  HWY_ALIGN double film_parameter_[room];
  HWY_ALIGN double flooded_[room];
  HWY_ALIGN double exponent_[room];
  HWY_ALIGN double film_bend_[room];
  HWY_ALIGN double root_[room];
  HWY_ALIGN double root_log_stiffening_[room];
  HWY_ALIGN double share_[room];
  HWY_ALIGN double hazard_[room];
  HWY_ALIGN double slope_[room];
  HWY_ALIGN double bend_[room];
  HWY_ALIGN std::uint8_t is_open_[room];
  HWY_ALIGN std::uint8_t is_known_[room];
};

// The shares at such a root: 1 − A = 1/γ, which an ulp of λ moves by about 8 ulp at most in a stiff
// film. Not inlined, so that the kernels of other laws keep their registers.
template <class D, class V = hn::Vec<D>>
HWY_NOINLINE Shares<V> shares_at_stiffening(D d, Order order,
                                            const detail::SurfaceNumbers<V>& surface,
                                            const V& log_stiffening, const V& lambda) {
  const V fluid = exponential(d, hn::Neg(log_stiffening));
  const V asperity = hn::Sub(hn::Set(d, 1.0), fluid);
  const auto by_film = hn::Or(hn::Lt(fluid, hn::Set(d, 0.5)),
                              is_stiff(d, order, surface, lambda, {asperity, fluid}, 8));
  return {hn::IfThenElse(by_film, asperity,
                         share_at(d, order, surface.stiffness, hn::Sub(lambda, surface.offset))),
          fluid};
}

}  // namespace tribo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // toggle
