// SPDX-License-Identifier: Apache-2.0
// Rows of numbers (contact_numbers.hpp) into lanes and back.
#include <hwy/highway.h>

#include <algorithm>
#include <iterator>

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

// How many numbers a row has, and a pointer to the first: a row holds these numbers of type T and
// nothing else.
template <template <class> class Numbers>
inline constexpr std::size_t row_length = sizeof(Numbers<double>) / sizeof(double);
template <template <class> class Numbers, class T>
HWY_INLINE T* row_begin(Numbers<T>& row) {
  static_assert(sizeof row == row_length<Numbers> * sizeof(T));
  return reinterpret_cast<T*>(&row);
}
template <template <class> class Numbers, class T>
HWY_INLINE const T* row_begin(const Numbers<T>& row) {
  return row_begin(const_cast<Numbers<T>&>(row));
}

// The row of function(number) for each number of a row, in order.
template <template <class> class Numbers, class T, class Function>
HWY_INLINE auto transformed(const Numbers<T>& row, Function&& function) {
  using Result = decltype(function(row_begin(row)[0]));
  Numbers<Result> result;
  // If the loop is unrolled, rows stay in registers, and numbers that nobody uses are not loaded.
#pragma GCC unroll 64
  for (std::size_t k = 0; k < row_length<Numbers>; ++k)
    row_begin(result)[k] = function(row_begin(row)[k]);
  return result;
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

// For each lane the row that begins index · stride doubles after `base`.
template <template <class> class Numbers, class D>
HWY_INLINE Numbers<hn::Vec<D>> rows_of(D d, const double* base, Integers<D> index,
                                       std::size_t stride = row_length<Numbers>) {
  hn::Vec<D> numbers[row_length<Numbers>];
  load_rows(d, base, index, numbers, stride);
  Numbers<hn::Vec<D>> rows;
  std::copy(std::begin(numbers), std::end(numbers), row_begin(rows));
  return rows;
}

}  // namespace tribo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif  // toggle
