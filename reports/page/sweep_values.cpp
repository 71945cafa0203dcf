// SPDX-License-Identifier: Apache-2.0
#include "page/sweep_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tribo::report {

using sweep::ColumnResult;

const sweep::Quantile& quantile(const ColumnResult::Value& value, double level) {
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  static constexpr sweep::Quantile none{nan, nan, nan};
  const auto found = std::find(sweep::quantile_levels.begin(), sweep::quantile_levels.end(), level);
  const auto place = static_cast<std::size_t>(found - sweep::quantile_levels.begin());
  return place < value.quantiles.size() ? value.quantiles[place] : none;
}

// Three words are the places 0, 1, 2, so that their sum and their sum of squares tell how often
// each was there.
std::vector<std::uint64_t> word_counts(const ColumnResult::Value& value, std::size_t words) {
  const auto n = static_cast<double>(value.count);
  const double sum = value.count > 0 ? n * value.mean : 0;
  const double squares =
      sum * (value.count > 0 ? value.mean : 0) +
      (value.count > 1 ? value.sd * value.sd * static_cast<double>(value.count - 1) : 0);
  const auto twos = static_cast<std::uint64_t>(std::llround(std::max((squares - sum) / 2, 0.0)));
  const auto all = static_cast<std::uint64_t>(std::llround(sum));
  const std::uint64_t ones = all - std::min(all, 2 * twos);
  std::vector<std::uint64_t> counts{value.count - std::min(value.count, ones + twos), ones, twos};
  counts.resize(words);
  return counts;
}

ReadableUnit readable_unit(const ColumnResult& column) {
  double greatest = 0;
  for (const ColumnResult::Value& value : column.values)
    if (std::isfinite(value.greatest) && std::isfinite(value.least))
      greatest = std::max({greatest, std::abs(value.greatest), std::abs(value.least)});
  if (column.unit != "m" || greatest == 0 || greatest >= 1e-2) return {column.unit, 1};
  return greatest < 1e-5 ? ReadableUnit{"nm", 1e9} : ReadableUnit{"µm", 1e6};
}

std::string with_error(const sweep::SobolIndex& index) {
  if (!std::isfinite(index.value)) return "–";
  const auto fixed = [](double value) {
    const std::string text = fmt::format("{:.3f}", std::abs(value));
    return value < 0 && text != "0.000" ? "−" + text : text;
  };
  if (!std::isfinite(index.high)) return fixed(index.value);
  return fmt::format("{} ± {}", fixed(index.value), fixed(index.high - index.value));
}

std::pair<std::string_view, std::string_view> split_name(std::string_view column) {
  const std::size_t dot = column.rfind('.');
  if (dot == std::string_view::npos) return {"", column};
  return {column.substr(0, dot), column.substr(dot + 1)};
}

}  // namespace tribo::report
