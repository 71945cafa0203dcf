// SPDX-License-Identifier: Apache-2.0
#include <iterator>
#include <utility>

#include "contenders/root_families.hpp"
#include "contenders/scipy_way.hpp"

namespace tribo::benchmarks {
namespace {

std::vector<RootContender> joined(std::vector<std::vector<RootContender>> families) {
  std::vector<RootContender> all;
  for (std::vector<RootContender>& family : families)
    std::move(family.begin(), family.end(), std::back_inserter(all));
  return all;
}

}  // namespace

std::vector<RootContender> wide_root_contenders(Settings settings) {
  return joined({bracketing_roots(settings), derivative_roots(settings), textbook_roots(settings),
                 scipy_roots(), own_wide_roots()});
}

std::vector<RootContender> one_surface_root_contenders(Settings settings) {
  return joined({bracketing_roots(settings), derivative_roots(settings), textbook_roots(settings),
                 inverse_tables(settings), scipy_roots(), own_one_surface_roots()});
}

}  // namespace tribo::benchmarks
