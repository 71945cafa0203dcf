// SPDX-License-Identifier: Apache-2.0
// The vector kernels behind batch.hpp, compiled for each instruction set and chosen at run time.
#include "tribo/batch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "batch.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "load_sharing_batch-inl.hpp"
#include "processor.hpp"
#include "sharing_method.hpp"

HWY_BEFORE_NAMESPACE();
namespace tribo::HWY_NAMESPACE {

// Lanes of a mask by a scalar function of the argument.
template <class D, class Function>
HWY_NOINLINE hn::Vec<D> mend(D d, hn::Vec<D> value, hn::Vec<D> argument, hn::Mask<D> lanes,
                             Function&& function) {
  HWY_ALIGN double values[hn::MaxLanes(D())];
  HWY_ALIGN double arguments[hn::MaxLanes(D())];
  HWY_ALIGN double selected[hn::MaxLanes(D())];
  hn::Store(value, d, values);
  hn::Store(argument, d, arguments);
  hn::Store(hn::IfThenElseZero(lanes, hn::Set(d, 1.0)), d, selected);
  for (std::size_t j = 0; j < hn::Lanes(d); ++j)
    if (selected[j] != 0) values[j] = function(arguments[j]);
  return hn::Load(d, values);
}

// kernel(x) of each argument, and scalar(x) where is_beyond(x): past the pieces, or no number.
template <class Kernel, class IsBeyond, class Scalar>
HWY_INLINE void transform(const double* argument, double* result, std::size_t count,
                          const Kernel& kernel, const IsBeyond& is_beyond, const Scalar& scalar) {
  const hn::ScalableTag<double> d;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto x = load(d, argument + i, count - i);
    auto value = kernel(d, x);
    const auto beyond = is_beyond(d, x);
    if (HWY_UNLIKELY(!hn::AllFalse(d, beyond))) value = mend(d, value, x, beyond, scalar);
    store(d, value, result + i, count - i);
  }
}

template <class D>
HWY_INLINE hn::Mask<D> is_past_pieces(D d, hn::Vec<D> x) {
  return hn::Not(hn::Lt(hn::Abs(x), hn::Set(d, pieces_end)));
}

void moments(Order n, const double* argument, double* result, std::size_t count) {
  transform(
      argument, result, count, [n](auto d, auto x) HWY_ATTR { return moment_vector(d, n, x); },
      [](auto d, auto x) HWY_ATTR { return hn::Not(hn::Gt(x, hn::Set(d, -pieces_end))); },
      [n](double x) { return gaussian_moment(n, x); });
}

void scaled_moments(Order n, const double* argument, double* result, std::size_t count) {
  transform(
      argument, result, count,
      [n](auto d, auto x) HWY_ATTR { return scaled_moment_vector(d, n, x); },
      [](auto d, auto x) HWY_ATTR { return is_past_pieces(d, x); },
      [n](double x) { return scaled_gaussian_moment(n, x); });
}

void log_moments(Order n, const double* argument, double* result, std::size_t count) {
  transform(
      argument, result, count,
      [n](auto d, auto x) HWY_ATTR {
        const auto half_square = hn::Mul(hn::Mul(hn::Set(d, 0.5), x), x);
        return hn::Sub(hn::Log(d, scaled_moment_vector(d, n, x)),
                       hn::IfThenElseZero(hn::Gt(x, hn::Zero(d)), half_square));
      },
      [](auto d, auto x) HWY_ATTR { return is_past_pieces(d, x); },
      // F_n itself may overflow a double
      [n](double x) {
        return static_cast<double>(log_gaussian_moment(n, static_cast<WiderType<double>>(x)));
      });
}

const char* target_name() { return hwy::TargetName(HWY_TARGET); }

}  // namespace tribo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace tribo {
namespace {

HWY_EXPORT(moments);
HWY_EXPORT(scaled_moments);
HWY_EXPORT(log_moments);
HWY_EXPORT(many_surfaces);
HWY_EXPORT(one_surface);
HWY_EXPORT(target_name);

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
    hwy::SetSupportedTargetsForTest(supported);
    hwy::GetChosenTarget().Update(supported);
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

// Before main, and so before any kernel is chosen.
[[maybe_unused]] const Names& found_before_main = names();

// kernel(first, count, roots), which returns its steps, for each block: the result may stand where
// an argument stood. What it leaves is NaN, and falls to Newton's method, newton(index).
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

void gaussian_moment(Order n, std::span<const double> d, std::span<double> moments) {
  HWY_DYNAMIC_DISPATCH(moments)(n, d.data(), moments.data(), d.size());
}
void scaled_gaussian_moment(Order n, std::span<const double> d, std::span<double> moments) {
  HWY_DYNAMIC_DISPATCH(scaled_moments)(n, d.data(), moments.data(), d.size());
}
void log_gaussian_moment(Order n, std::span<const double> d, std::span<double> logarithms) {
  HWY_DYNAMIC_DISPATCH(log_moments)(n, d.data(), logarithms.data(), d.size());
}

SharingWork film_parameter(AsperityModel model, std::span<const double> stiffness,
                           std::span<const double> offset, std::span<const double> flooded,
                           std::span<double> film_parameter) {
  return in_blocks(
      flooded.size(), film_parameter,
      [&](std::size_t first, std::size_t count, double* lambda) {
        return HWY_DYNAMIC_DISPATCH(many_surfaces)(load_order(model), &stiffness[first],
                                                   &offset[first], &flooded[first], lambda, count);
      },
      [&](std::size_t i) {
        return tribo::film_parameter(model, stiffness[i], offset[i], flooded[i]);
      });
}

SharingWork film_parameter(const LoadSharing<double>& sharing, std::span<const double> flooded,
                           std::span<double> film_parameter) {
  return in_blocks(
      flooded.size(), film_parameter,
      [&](std::size_t first, std::size_t count, double* lambda) {
        const std::size_t steps =
            HWY_DYNAMIC_DISPATCH(one_surface)(sharing.surface(), &flooded[first], lambda, count);
        for (std::size_t i = 0; i < count; ++i) lambda[i] = std::max(lambda[i], sharing.floor());
        return steps;
      },
      [&](std::size_t i) { return sharing.film_parameter(flooded[i]); });
}

std::string_view instruction_set() { return HWY_DYNAMIC_DISPATCH(target_name)(); }

std::string_view scalar_instruction_set() { return detail::has_fma() ? "FMA" : "no FMA"; }

std::span<const std::string_view> instruction_sets() {
  return std::span(names().names).first(names().count);
}

bool use_instruction_set(std::string_view name) {
  for (std::size_t i = 0; i < names().count; ++i) {
    if (names().names[i] != name) continue;
    hwy::SetSupportedTargetsForTest(names().targets[i]);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    return true;
  }
  return false;
}

}  // namespace tribo
#endif  // HWY_ONCE
