// SPDX-License-Identifier: Apache-2.0
#include "conformance/mistake.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "conformance/function_mistakes.hpp"
#include "conformance/point_mistakes.hpp"

namespace tribo::conformance {

bool Mistake::can_stand_beside(const Mistake& other) const {
  return std::none_of(touches.begin(), touches.end(), [&](const std::string& one) {
    return std::find(other.touches.begin(), other.touches.end(), one) != other.touches.end();
  });
}

std::optional<Numbers> numbers_with(std::span<const Mistake* const> mistakes,
                                    const Question& question) {
  const auto applies = [&](const Mistake* one) { return !one->applies || one->applies(question); };
  if (std::none_of(mistakes.begin(), mistakes.end(), applies)) return std::nullopt;
  Question misread = question;
  for (const Mistake* const one : mistakes)
    if (one->before && applies(one)) one->before(misread);
  std::optional<Numbers> numbers;
  for (const Mistake* const one : mistakes)
    if (one->instead && applies(one)) {
      numbers = one->instead(misread);
      if (!numbers) return std::nullopt;
    }
  if (!numbers) numbers = right_numbers(misread);
  for (const Mistake* const one : mistakes)
    if (one->after && applies(one)) one->after(misread, *numbers);
  return numbers;
}

std::vector<Mistake> read_mistakes(const std::string& path) {
  std::vector<Mistake> all, of_points;
  std::map<std::string, std::vector<Mistake>> of_films;  // by name: one of each law that has it
  for (const MistakeEntry& entry : read_mistake_file(path)) try {
      if (entry.function == "operating_point") {
        for (Mistake& one : point_mistakes_of(entry)) {
          one.follows = entry.follows;
          of_points.push_back(std::move(one));
        }
        continue;
      }
      for (const catalogue::Function* const function : functions_of(entry))
        for (Mistake& one : mistakes_of(*function, entry)) {
          if (std::find(film_formula_words.begin(), film_formula_words.end(), function->name) !=
              film_formula_words.end()) {
            of_films[one.name].push_back(one);
            of_films[one.name].back().follows = entry.follows;
          } else if (std::optional<Mistake> same = for_points(one)) {
            same->follows = entry.follows;
            of_points.push_back(std::move(*same));
          }
          all.push_back(std::move(one));
        }
    } catch (const std::exception& error) {
      throw std::runtime_error(
          fmt::format("{}: mistake \"{}\": {}", path, entry.name, error.what()));
    }
  for (const auto& [name, laws] : of_films) {
    of_points.push_back(with_film(laws));
    of_points.back().follows = laws.front().follows;
  }
  for (Mistake& one : of_points) all.push_back(std::move(one));
  for (const Mistake& one : all)
    if (!one.follows.empty() && std::none_of(all.begin(), all.end(), [&](const Mistake& other) {
          return other.name == one.follows;
        }))
      throw std::runtime_error(
          fmt::format("{}: mistake \"{}\": follows: no mistake {}", path, one.name, one.follows));
  return all;
}

}  // namespace tribo::conformance
