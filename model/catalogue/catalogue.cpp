// SPDX-License-Identifier: Apache-2.0
#include "catalogue/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "catalogue/families.hpp"

namespace tribo::catalogue {
namespace {

std::string_view text_of(Range range) {
  switch (range) {
    case Range::above_zero:
      return "a number above 0";
    case Range::not_below_zero:
      return "a number not below 0";
    case Range::not_zero:
      return "a number other than 0";
    case Range::half_order:
      return "0, 0.5, 1, 1.5, 2 or 2.5";
    case Range::poisson_ratio:
      return "a number above -1 and at most 0.5";
    case Range::any:
      break;
  }
  return "a number";
}

}  // namespace

std::optional<double> place_of(std::string_view word, const Parameter& parameter) {
  const auto found = std::find(parameter.words.begin(), parameter.words.end(), word);
  if (found == parameter.words.end()) return std::nullopt;
  return static_cast<double>(found - parameter.words.begin());
}

std::string allowed_text(const Parameter& parameter) {
  std::string text;
  for (const std::string_view word : parameter.words)
    text += (text.empty() ? "" : ", ") + std::string(word);
  return text.empty() ? std::string(text_of(parameter.range)) : text;
}

std::string allowed_with_unit(const Parameter& parameter) {
  std::string text = allowed_text(parameter);
  if (!parameter.unit.empty()) text += ", in " + std::string(parameter.unit);
  return text;
}

std::string default_text(const Parameter& parameter) {
  if (parameter.words.empty()) return fmt::format("{}", *parameter.default_value);
  return std::string(parameter.words[static_cast<std::size_t>(*parameter.default_value)]);
}

bool is_physical(const Function& function, const Arguments& arguments) {
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const Parameter& one = function.parameters[i];
    if (one.words.empty() && !(arguments[i] >= one.least && arguments[i] <= one.greatest))
      return false;
  }
  return std::all_of(function.combinations.begin(), function.combinations.end(),
                     [&](const Combination& one) {
                       const double number = one.value(arguments);
                       return number >= one.least && number <= one.greatest;
                     });
}

std::span<const Function> functions() {
  static const std::vector<Function> all = [] {
    std::vector<Function> joined;
    for (const auto& family : {two_bodies(), rough_contact(), smooth_contact(), films(), inlets(),
                               load_sharing_rules(), liquids(), surfaces()})
      joined.insert(joined.end(), family.begin(), family.end());
    return joined;
  }();
  return all;
}

const Function* function_named(std::string_view name) {
  const std::span<const Function> all = functions();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Function& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace tribo::catalogue
