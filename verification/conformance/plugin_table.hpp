// SPDX-License-Identifier: Apache-2.0
// The arrays that tribocheck_function() of tribocheck_plugin.h takes.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "catalogue/catalogue.hpp"
#include "conformance/tribocheck_plugin.h"

namespace tribo::conformance {

// Arguments and results of `count` cases of a function, a column each.
class PluginTable {
 public:
  PluginTable(const catalogue::Function& function, std::size_t count)
      : function_(&function),
        count_(count),
        numbers_((function.parameters.size() + function.results.size()) * count, nan) {
    for (std::size_t k = 0; k < function.parameters.size(); ++k)
      arguments_.push_back(&numbers_[k * count]);
    for (std::size_t k = 0; k < function.results.size(); ++k)
      results_.push_back(&numbers_[(function.parameters.size() + k) * count]);
  }
  PluginTable(const PluginTable&) = delete;
  PluginTable& operator=(const PluginTable&) = delete;

  std::span<double> argument(std::size_t place) { return {&numbers_[place * count_], count_}; }
  std::span<const double> result(std::size_t place) const { return {results_[place], count_}; }

  // False: the plug-in does not offer the function.
  bool call(decltype(&tribocheck_function) plugin, std::span<int> status) {
    // The names of the catalogue are literals: they end with 0.
    return plugin(function_->name.data(), count_, arguments_.data(), results_.data(),
                  status.data()) != 0;
  }

 private:
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();

  const catalogue::Function* function_;
  std::size_t count_;
  std::vector<double> numbers_;
  std::vector<const double*> arguments_;
  std::vector<double*> results_;
};

}  // namespace tribo::conformance
