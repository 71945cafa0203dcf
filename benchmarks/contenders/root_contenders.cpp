// SPDX-License-Identifier: Apache-2.0
#include <initializer_list>

#include "contenders/root_families.hpp"
#include "contenders/scipy_way.hpp"

namespace tribo::benchmarks {
namespace {

using Family = std::vector<RootContender> (*)();

std::vector<RootContender> joined(std::initializer_list<Family> families) {
  std::vector<RootContender> all;
  for (const Family family : families)
    for (RootContender& contender : family()) all.push_back(std::move(contender));
  return all;
}

}  // namespace

std::vector<RootContender> wide_root_contenders() {
  return joined({bracketing_roots, derivative_roots, textbook_roots, scipy_roots, own_wide_roots});
}

std::vector<RootContender> one_surface_root_contenders() {
  return joined({bracketing_roots, derivative_roots, textbook_roots, inverse_tables, scipy_roots,
                 own_one_surface_roots});
}

}  // namespace tribo::benchmarks
