// SPDX-License-Identifier: Apache-2.0
// Rows of numbers (contact_numbers.hpp) into lanes and back.
#include <hwy/highway.h>

#include "gaussian_moment-inl.hpp"
#include "tribo/contact_numbers.hpp"

#if defined(TRIBO_CONTACT_NUMBERS) == defined(HWY_TARGET_TOGGLE)
#ifdef TRIBO_CONTACT_NUMBERS
#undef TRIBO_CONTACT_NUMBERS
#else
#define TRIBO_CONTACT_NUMBERS
#endif

HWY_BEFORE_NAMESPACE();
namespace tribo::HWY_NAMESPACE {

// function(number) of each of their numbers, in order.
template <class T, class Function>
HWY_INLINE auto transformed(const detail::SurfaceNumbers<T>& s, Function&& function)
    -> detail::SurfaceNumbers<decltype(function(s.stiffness))> {
  return {function(s.stiffness), function(s.offset),
          function(s.floor),     function(s.floor_argument),
          function(s.hazard),    function(s.floor_up_to),
          function(s.film_from), function(s.film_at_unit_speed)};
}
template <class T, class Function>
HWY_INLINE auto transformed(const detail::ContactNumbers<T>& c, Function&& function)
    -> detail::ContactNumbers<decltype(function(c.radius))> {
  return {transformed(c.surface, function),
          function(c.summit_height_sd),
          function(c.area_factor),
          function(c.count_factor),
          function(c.supply),
          function(c.damiens_exponent),
          function(c.boundary_coefficient),
          function(c.slide_roll_ratio),
          function(c.eyring_stress),
          function(c.viscosity),
          function(c.pressure_viscosity),
          function(c.roelands_scale),
          function(c.roelands_exponent),
          function(c.radius),
          function(c.nominal_area),
          function(c.mean_pressure),
          function(c.approach)};
}
template <class T, class Function>
HWY_INLINE auto transformed(const detail::SceneNumbers<T>& s, Function&& function)
    -> detail::SceneNumbers<decltype(function(s.load))> {
  return {function(s.load),
          function(s.summit_density),
          function(s.summit_radius),
          function(s.summit_height_sd),
          function(s.summit_plane_offset),
          function(s.offset_planes),
          function(s.effective_modulus),
          function(s.reduced_radius),
          function(s.ellipticity),
          function(s.viscosity),
          function(s.pressure_viscosity),
          function(s.eyring_stress),
          function(s.supply),
          function(s.boundary_coefficient),
          function(s.slide_roll_ratio),
          function(s.damiens_exponent)};
}

// A row in every lane, and back from the first lane.
template <class D, class Numbers>
HWY_INLINE auto broadcast(D d, const Numbers& row) {
  return transformed(row, [d](double x) HWY_ATTR { return hn::Set(d, x); });
}
template <class Numbers>
HWY_INLINE auto first_lane(const Numbers& numbers) {
  return transformed(numbers, [](auto x) HWY_ATTR { return hn::GetLane(x); });
}

// Of each lane the row whose number is `index`, in `stride` doubles a row from `base` on.
template <template <class> class Numbers, class D>
HWY_INLINE Numbers<hn::Vec<D>> rows_of(D d, const double* base, Integers<D> index,
                                       std::size_t stride) {
  constexpr std::size_t count = sizeof(Numbers<double>) / sizeof(double);
  hn::Vec<D> numbers[count];
  load_rows(d, base, index, numbers, stride);
  std::size_t k = 0;
  return transformed(Numbers<double>{}, [&](double) HWY_ATTR { return numbers[k++]; });
}

}  // namespace tribo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // toggle
