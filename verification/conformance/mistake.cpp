// SPDX-License-Identifier: Apache-2.0
#include "conformance/mistake.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "conformance/function_mistakes.hpp"
#include "conformance/point_mistakes.hpp"

namespace tribo::conformance {

std::vector<Mistake> read_mistakes(const std::string& path) {
  std::vector<Mistake> all, of_points;
  for (const MistakeEntry& entry : read_mistake_file(path)) try {
      if (entry.function == "operating_point") {
        for (Mistake& one : point_mistakes_of(entry)) of_points.push_back(std::move(one));
        continue;
      }
      const catalogue::Function* const function = catalogue::find(entry.function);
      if (function == nullptr) throw std::runtime_error("no function " + entry.function);
      for (const FunctionMistake& one : mistakes_of(*function, entry)) {
        all.push_back(for_cases(one));
        if (std::optional<Mistake> same = for_points(one)) of_points.push_back(std::move(*same));
      }
    } catch (const std::exception& error) {
      throw std::runtime_error(
          fmt::format("{}: mistake \"{}\": {}", path, entry.name, error.what()));
    }
  for (Mistake& one : of_points) all.push_back(std::move(one));
  return all;
}

}  // namespace tribo::conformance
