// SPDX-License-Identifier: Apache-2.0
// A thin value type over Arb's real balls (FLINT): a ball is a midpoint and a radius, and the
// result of every operation encloses the exact result. Comparisons are certain: a < b is true only
// where every point of a is below every point of b. Where neither a comparison nor its opposite is
// certain, the comparison is false, and undecided_comparisons counts it.
#pragma once

#include <arb.h>
#include <arf.h>

#include <cstdint>
#include <string>

namespace tribo::reference {

inline constexpr slong ball_precision = 320;  // bits

// The number of comparisons in this thread that were not certain either way. Code for plain numbers
// takes one branch after such a comparison, perhaps the wrong one, so that its result may not
// enclose the true one.
inline thread_local std::uint64_t undecided_comparisons = 0;

class Ball {
 public:
  Ball() { arb_init(x_); }
  Ball(double value) : Ball() { arb_set_d(x_, value); }  // NOLINT: converts like built-in numbers
  Ball(int value) : Ball() { arb_set_si(x_, value); }    // NOLINT
  Ball(const Ball& other) : Ball() { arb_set(x_, other.x_); }
  Ball(Ball&& other) noexcept : Ball() { arb_swap(x_, other.x_); }
  Ball& operator=(const Ball& other) {
    if (this != &other) arb_set(x_, other.x_);
    return *this;
  }
  Ball& operator=(Ball&& other) noexcept {
    arb_swap(x_, other.x_);
    return *this;
  }
  ~Ball() { arb_clear(x_); }

  arb_ptr get() { return x_; }
  arb_srcptr get() const { return x_; }

  Ball& operator+=(const Ball& b) { return *this = *this + b; }
  Ball& operator-=(const Ball& b) { return *this = *this - b; }
  Ball& operator*=(const Ball& b) { return *this = *this * b; }
  Ball& operator/=(const Ball& b) { return *this = *this / b; }

  friend Ball operator+(const Ball& a, const Ball& b) { return binary(arb_add, a, b); }
  friend Ball operator-(const Ball& a, const Ball& b) { return binary(arb_sub, a, b); }
  friend Ball operator*(const Ball& a, const Ball& b) { return binary(arb_mul, a, b); }
  friend Ball operator/(const Ball& a, const Ball& b) { return binary(arb_div, a, b); }
  Ball operator-() const {
    Ball result;
    arb_neg(result.x_, x_);
    return result;
  }

  friend bool operator<(const Ball& a, const Ball& b) { return certain(arb_lt, arb_ge, a, b); }
  friend bool operator>(const Ball& a, const Ball& b) { return certain(arb_gt, arb_le, a, b); }
  friend bool operator<=(const Ball& a, const Ball& b) { return certain(arb_le, arb_gt, a, b); }
  friend bool operator>=(const Ball& a, const Ball& b) { return certain(arb_ge, arb_lt, a, b); }
  friend bool operator==(const Ball& a, const Ball& b) { return certain(arb_eq, arb_ne, a, b); }
  friend bool operator!=(const Ball& a, const Ball& b) { return certain(arb_ne, arb_eq, a, b); }

  friend bool overlaps(const Ball& a, const Ball& b) { return arb_overlaps(a.x_, b.x_) != 0; }
  friend bool is_finite(const Ball& a) { return arb_is_finite(a.x_) != 0; }

  // The midpoint with radius 0. It encloses nothing but itself.
  Ball midpoint() const {
    Ball result;
    arb_get_mid_arb(result.x_, x_);
    return result;
  }
  // The nearest double to the midpoint.
  double nearest() const { return arf_get_d(arb_midref(x_), ARF_RND_NEAR); }
  // A double that is an upper bound of the ball.
  double upper_bound() const {
    arf_t bound;
    arf_init(bound);
    arb_get_ubound_arf(bound, x_, 60);
    const double result = arf_get_d(bound, ARF_RND_CEIL);
    arf_clear(bound);
    return result;
  }
  // The bits of relative accuracy: n where the radius is 2^−n times the midpoint.
  slong accurate_bits() const { return arb_rel_accuracy_bits(x_); }
  // `digits` significant decimal digits, the last of which may be off by one.
  std::string decimal(slong digits) const {
    char* text = arb_get_str(x_, digits, ARB_STR_NO_RADIUS);
    std::string result(text);
    flint_free(text);
    return result;
  }

  template <class Function>
  friend Ball unary(Function&& function, const Ball& a) {
    Ball result;
    function(result.x_, a.x_, ball_precision);
    return result;
  }
  template <class Function>
  friend Ball binary(Function&& function, const Ball& a, const Ball& b) {
    Ball result;
    function(result.x_, a.x_, b.x_, ball_precision);
    return result;
  }

 private:
  using Comparison = int(const arb_t, const arb_t);
  static bool certain(Comparison* holds, Comparison* fails, const Ball& a, const Ball& b) {
    if (holds(a.x_, b.x_) != 0) return true;
    if (fails(a.x_, b.x_) == 0) ++undecided_comparisons;
    return false;
  }

  arb_t x_;
};

inline Ball exp(const Ball& x) { return unary(arb_exp, x); }
inline Ball expm1(const Ball& x) { return unary(arb_expm1, x); }
inline Ball log(const Ball& x) { return unary(arb_log, x); }
inline Ball log1p(const Ball& x) { return unary(arb_log1p, x); }
inline Ball sqrt(const Ball& x) { return unary(arb_sqrt, x); }
inline Ball atan(const Ball& x) { return unary(arb_atan, x); }
inline Ball acos(const Ball& x) { return unary(arb_acos, x); }
inline Ball tan(const Ball& x) { return unary(arb_tan, x); }
inline Ball asinh(const Ball& x) { return unary(arb_asinh, x); }
inline Ball gamma(const Ball& x) { return unary(arb_gamma, x); }
inline Ball pow(const Ball& x, const Ball& y) { return binary(arb_pow, x, y); }
inline Ball abs(const Ball& x) {
  Ball result;
  arb_abs(result.get(), x.get());
  return result;
}
inline Ball ball_pi() {
  Ball result;
  arb_const_pi(result.get(), ball_precision);
  return result;
}
inline Ball fraction(int p, int q) { return Ball(p) / Ball(q); }

}  // namespace tribo::reference
