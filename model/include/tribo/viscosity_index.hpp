// SPDX-License-Identifier: Apache-2.0
// The viscosity index of an oil from its kinematic viscosities at 40 and 100 °C, and the viscosity
// at 100 °C from the index. Source: ASTM D2270-10, Standard practice for calculating viscosity
// index from kinematic viscosity at 40 and 100 °C (also ISO 2909): equations 3, 6 and 7, and the
// quadratic equations of its table X2.1, which are within 0.1 % of its table 1.
#pragma once

#include <array>

#include "tribo/bracketed_root.hpp"
#include "tribo/contract.hpp"
#include "tribo/real.hpp"

namespace tribo {

inline constexpr Contract viscosity_index_contract{8, 4};

// Viscosities in mm²/s at 100 °C: the least for which the index is defined, and the greatest that
// viscosity_at_100_celsius() gives.
inline constexpr int least_viscosity_with_index = 2, greatest_viscosity_with_index = 1000;

// Temperatures in K of the index's viscosities.
inline constexpr double lower_index_temperature = 313.15, upper_index_temperature = 373.15;

namespace detail {

// L = aY² + bY + c and H = dY² + eY + f for Y above `from`, in m²/s, up to the `from` of the next
// row. a and d are in 10⁻⁵, b and e in 10⁻⁴, c and f in 10⁻³.
struct IndexRow {
  double from;
  int a, b, c, d, e, f;
};
inline constexpr auto index_rows =
    std::to_array<IndexRow>({{2e-6, 114673, 17576, -109, 84155, 15521, -77},
                             {3.8e-6, 338095, -154952, 33196, 78571, 17929, -183},
                             {4.4e-6, 250000, -72143, 13812, 82143, 15679, 119},
                             {5e-6, 10100, 166350, -45469, 4985, 91613, -18557},
                             {6.4e-6, 335714, -235643, 78466, 22619, 77369, -16656},
                             {7e-6, 1191, 214750, -72870, 79762, -7321, 14610},
                             {7.7e-6, 41858, 161558, -56040, 5794, 105156, -28240},
                             {9e-6, 88779, 75527, -16600, 26665, 67015, -10810},
                             {12e-6, 76720, 107972, -38180, 20073, 84658, -22490},
                             {15e-6, 97305, 53135, -2200, 28889, 59741, -4930},
                             {18e-6, 97256, 52500, -980, 24504, 74160, -16730},
                             {22e-6, 91413, 74759, -21820, 20323, 91267, -34230},
                             {28e-6, 87031, 97157, -50770, 18411, 101015, -46750},
                             {40e-6, 84703, 126752, -133310, 17029, 114866, -80620},
                             {55e-6, 85921, 111009, -83190, 17130, 113680, -76940},
                             {70e-6, 83531, 146731, -216246, 16841, 118493, -96947}});

// Viscosities at 40 °C in mm²/s of the oils of index 0 and 100 whose ν at 100 °C is at_100 in m²/s.
template <class T>
struct IndexOils {
  T zero, hundred;  // L, H
};
// The row that holds at this viscosity at 100 °C, in m²/s.
template <class T>
std::size_t index_row(const T& at_100) {
  std::size_t row = index_rows.size() - 1;
  while (row > 0 && at_100 <= T(index_rows[row].from)) --row;
  return row;
}
template <class T>
IndexOils<T> index_oils(const T& at_100, std::size_t row) {
  const auto& [from, a, b, c, d, e, f] = index_rows[row];
  const T y = 1000000 * at_100;
  const auto quadratic = [&y](int second, int first, int constant) {
    return T((T(second) / 100000 * y + T(first) / 10000) * y + T(constant) / 1000);
  };
  return {quadratic(a, b, c), quadratic(d, e, f)};
}
template <class T>
IndexOils<T> index_oils(const T& at_100) {
  return index_oils(at_100, index_row(at_100));
}

// VI between or beyond these oils, from ν at 40 °C and at 100 °C in m²/s.
template <class T>
T index_among(const T& at_40, const T& at_100, const IndexOils<T>& oils) {
  using std::exp;
  using std::log;
  const T u = 1000000 * at_40;
  if (u >= oils.hundred) return 100 * (oils.zero - u) / (oils.zero - oils.hundred);
  const T power = log(T(oils.hundred / u)) / log(T(1000000 * at_100));
  return (exp(T(power * log(T(10)))) - 1) / (T(715) / 100000) + 100;
}

// N of equation 6 for VI above 100: 10^N = 1 + 0.00715 (VI − 100), and H = U Y^N.
template <class T>
T index_power(const T& index) {
  using std::log;
  return log(T(1 + T(715) / 100000 * (index - 100))) / log(T(10));
}

}  // namespace detail

// VI from ν at 40 °C and at 100 °C, in m²/s: the first above the second, which is 2 mm²/s or more;
// NaN otherwise. VI is below 0 where the oil is thicker at 40 °C than the oil of index 0. At the
// end of a range the quadratic equations of the lower range hold, as in the standard's table 1 up
// to 70 mm²/s; the index has a step of some tenths there. The standard rounds the index to a whole
// number. Error against the quadratic equations: viscosity_index_contract; against table 1 less
// than 0.3.
template <class T>
T viscosity_index(const T& at_40, const T& at_100) {
  if (!(at_100 >= T(detail::index_rows[0].from) && at_40 > at_100)) return quiet_nan<T>();
  return detail::index_among(at_40, at_100, detail::index_oils(at_100));
}

// ν at 100 °C in m²/s from ν at 40 °C in m²/s and the index, 0 to 400: the inverse of
// viscosity_index(). NaN where the result would not lie from 2 to 1000 mm²/s. Error: some 10 ε, and
// up to 0.1 % by the quadratic equations, which do not quite meet at the ends of their ranges.
template <class T>
T viscosity_at_100_celsius(const T& at_40, const T& index) {
  using std::log;
  const T u = 1000000 * at_40;
  const auto excess = [&](const T& y) {  // rises with y
    const detail::IndexOils<T> oils = detail::index_oils(T(y / 1000000));
    if (index <= 100) return T(oils.zero - index / 100 * (oils.zero - oils.hundred) - u);
    return T(log(T(oils.hundred / u)) - detail::index_power(index) * log(y));
  };
  return bracketed_root(excess, T(least_viscosity_with_index), T(greatest_viscosity_with_index),
                        T(0)) /
         1000000;
}

}  // namespace tribo
