// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "conformance/wrong_parts.hpp"
#include "reproduction/reading_model.hpp"

namespace tribo::conformance {
namespace {

using Value = std::optional<double>;

bool is_of_crook(StarvationClosure closure) { return closure != StarvationClosure::damiens; }

// With Crook's constant of a circular contact; the readings of the paper have it.
double with_circular_gap(StarvationClosure closure, double r) {
  reproduction::Reading reading = reproduction::corrected_reading();
  const auto set = [&](reproduction::Switch which, std::uint8_t choice) {
    reading.choice[static_cast<std::size_t>(which)] = choice;
  };
  set(reproduction::Switch::gap, 1);
  set(reproduction::Switch::inlet, static_cast<std::uint8_t>(closure));
  return reproduction::ReadInlet(reading).film_ratio(r);
}

}  // namespace

std::vector<WrongInlet> wrong_inlets() {
  std::vector<WrongInlet> all{
      {"inlet-times-r", "h*/h_oil answered for h*/h_ff",
       [](StarvationClosure closure, double r, double gamma) -> Value {
         return r * starvation_ratio(closure, r, gamma);
       }},
      {"inlet-over-r", "Wolveridge's ratio taken for h*/h_oil in place of h*/h_ff",
       [](StarvationClosure closure, double r, double gamma) -> Value {
         if (!is_of_crook(closure)) return std::nullopt;
         return starvation_ratio(closure, r, gamma) / r;
       }},
      {"inlet-circular-gap", "Crook's constant of a circular contact, 16√2/(3π), in place of 4√2/3",
       [](StarvationClosure closure, double r, double) -> Value {
         if (!is_of_crook(closure)) return std::nullopt;
         return with_circular_gap(closure, r);
       }},
      {"inlet-exponent-3/2", "ψ^{2/3} for ψ^{3/2} in Crook's gap",
       [](StarvationClosure closure, double r, double) -> Value {
         if (closure != StarvationClosure::flooded_inlet || r >= 1) return std::nullopt;
         return wolveridge_film_ratio(std::pow((1 / r - 1) * crook_constant<double>(), 1.5));
       }},
      {"inlet-inverted", "h_oil/h_ff in place of h_ff/h_oil",
       [](StarvationClosure closure, double r, double gamma) -> Value {
         return starvation_ratio(closure, 1 / r, gamma);
       }},
      {"inlet-never-starved", "the flooded film, whatever the supply",
       [](StarvationClosure, double, double) -> Value { return 1.0; }}};
  const auto& words = starvation_closure_words;
  for (std::size_t asked = 0; asked < words.size(); ++asked)
    for (std::size_t given = 0; given < words.size(); ++given) {
      if (asked == given) continue;
      all.push_back(
          {fmt::format("inlet-{}-for-{}", words[given], words[asked]),
           fmt::format("the closure `{}` where `{}` is asked for", words[given], words[asked]),
           [=](StarvationClosure closure, double r, double gamma) -> Value {
             if (closure != static_cast<StarvationClosure>(asked)) return std::nullopt;
             return starvation_ratio(static_cast<StarvationClosure>(given), r, gamma);
           }});
    }
  return all;
}

}  // namespace tribo::conformance
