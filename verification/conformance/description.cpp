// SPDX-License-Identifier: Apache-2.0
#include "conformance/description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace tribo::conformance {
namespace {

constexpr double few = 0.03;  // of the wrong answers

// "27.5 % low", "1000 times too large".
std::string in_words(double ratio) {
  if (std::abs(ratio + 1) < 1e-6) return "−1 times the right value";
  if (ratio < 0) return fmt::format("{:.4g} times the right value, of the wrong sign", ratio);
  if (ratio > 3) return fmt::format("{:.4g} times too large", ratio);
  if (ratio < 1.0 / 3) return fmt::format("{:.4g} times too small", 1 / ratio);
  return fmt::format("{:.3g} % {}", 100 * std::abs(ratio - 1), ratio < 1 ? "low" : "high");
}

// A factor that people lose or gain.
std::string known_factor(double ratio) {
  struct Factor {
    double value;
    const char* name;
  };
  constexpr Factor factors[] = {{2, "2"},
                                {3.14159265358979, "π"},
                                {1.4142135623731, "√2"},
                                {1.5, "3/2"},
                                {1.33333333333333, "4/3"},
                                {2.506628274631, "√(2π)"},
                                {1.772453850905516, "√π"},
                                {1e3, "1000, as between m and mm"},
                                {1e6, "10⁶, as between m and µm"},
                                {1e9, "10⁹, as between m and nm"},
                                {100, "100, as with percent"},
                                {4, "4"},
                                {6.283185307179586, "2π"}};
  if (std::abs(ratio + 1) < 1e-6) return "It has another sign convention.";
  for (const Factor& one : factors) {
    if (std::abs(ratio / one.value - 1) < 1e-6)
      return fmt::format("It is too large by a factor of {}.", one.name);
    if (std::abs(ratio * one.value - 1) < 1e-6)
      return fmt::format("It is too small by a factor of {}.", one.name);
  }
  return {};
}

// " It is h/R = 1.9 U^+0.67 …" of a film that is a law in U, G and W with E′ = 2E*.
std::string film_in_groups(const catalogue::Function& function, const PowerLaw& got) {
  if (function.film_law == nullptr) return {};
  // of u, η₀, α (not of soft bodies), F or F/L, E*, R
  const std::vector<double>& e = got.exponents;
  const bool is_soft = function.parameters[2].name != "pressure_viscosity";
  const std::size_t load = is_soft ? 2 : 3;
  const double a = e[0], b = is_soft ? 0 : e[2], c = e[load];
  const double by_radius = function.film_law->is_of_lines ? 1 - a - c : 1 - a - 2 * c;
  const auto is = [](double x, double y) { return std::abs(x - y) <= 1e-4; };
  if (!is(e[1], a) || !is(e[load + 1], b - a - c) || !is(e[load + 2], by_radius)) return {};
  return fmt::format(" {} h/R = {:.6g} U^{:+.4g} G^{:+.4g} W^{:+.4g}.",
                     got.held.empty() ? "It is" : fmt::format("Where {}, it is", got.held),
                     got.constant * std::pow(2, a - b + c), a, std::round(b * 1e5) / 1e5 + 0.0, c);
}

// A known mistake whose exponents these are, with another constant.
std::string same_exponents(const Part& part, const PowerLaw& got,
                           const std::vector<AnsweredCase>& cases,
                           const std::vector<Mistake>& mistakes) {
  for (const Mistake& mistake : mistakes) {
    const Mistake* const one = &mistake;
    const auto its = fit_power_law(
        cases, part.branch, part.place,
        [&](const AnsweredCase& asked, const AnsweredNumber& number) {
          const std::optional<Numbers> given = numbers_with({&one, 1}, asked.question);
          return given ? (*given)[number.place] : unsaid;
        },
        rounding);
    if (!its) continue;
    bool is_same = true;
    for (std::size_t i = 0; i < got.exponents.size(); ++i)
      is_same = is_same && std::abs(its->exponents[i] - got.exponents[i]) <= 1e-4;
    if (!is_same) continue;
    return fmt::format(
        " Its exponents, {}, are those of this: {}. Its constant is {:.6g} times the one there.",
        powers_in_words(*cases.front().question.function, got.exponents), mistake.text,
        got.constant / its->constant);
  }
  return {};
}

// The exponents in a sentence: "It goes as F^+0.49; the law has F^-0.067."
std::string exponents_in_words(const Part& part, const std::vector<AnsweredCase>& cases,
                               const std::vector<Mistake>& mistakes) {
  const auto fitted = [&](const NumberOf& number_of) {
    return fit_power_law(cases, part.branch, part.place, number_of, rounding);
  };
  const auto got = fitted([](const AnsweredCase&, const AnsweredNumber& one) { return one.got; });
  const auto law =
      fitted([](const AnsweredCase&, const AnsweredNumber& one) { return one.expected->high; });
  if (!got || !law) return {};
  const catalogue::Function& function = *cases.front().question.function;
  std::vector<double> extra(got->exponents.size());
  for (std::size_t i = 0; i < extra.size(); ++i) extra[i] = got->exponents[i] - law->exponents[i];
  if (powers_in_words(function, extra).empty()) return {};
  std::string text = same_exponents(part, *got, cases, mistakes);
  if (!text.empty()) return text;
  const std::string in_groups = film_in_groups(function, *got);
  for (std::size_t i = 0; i < extra.size(); ++i) {
    if (std::abs(extra[i]) <= 1e-4) continue;
    const catalogue::Parameter& input = function.parameters[i];
    // The exponents of E* and R follow from those of U, G and W.
    if (!in_groups.empty() && (input.name == "effective_modulus" || input.unit == "m")) continue;
    const std::string symbol = symbol_of(input);
    if (std::abs(got->exponents[i]) <= 1e-4)
      text += fmt::format(" It does not depend on {}; the law has {}.", symbol,
                          power_in_words(input, law->exponents[i]));
    else if (std::abs(law->exponents[i]) <= 1e-4)
      text += fmt::format(" It goes as {}; the law does not depend on {}.",
                          power_in_words(input, got->exponents[i]), symbol);
    else
      text +=
          fmt::format(" It goes as {}; the law has {}.", power_in_words(input, got->exponents[i]),
                      power_in_words(input, law->exponents[i]));
  }
  if (!in_groups.empty()) return text + in_groups;
  return text + fmt::format(" In all an extra factor {}, times {:.6g}.",
                            powers_in_words(function, extra), got->constant / law->constant);
}

std::string constant_factor(const Part& part) {
  double least = INFINITY, greatest = -INFINITY;
  for (const AnsweredNumber* const one : part.wrong) {
    if (one->expected->high == 0) return {};
    least = std::min(least, one->got / one->expected->high);
    greatest = std::max(greatest, one->got / one->expected->high);
  }
  return greatest - least < 1e-9 * std::abs(greatest) ? known_factor(least) : "";
}

}  // namespace

std::vector<Part> parts_left(const std::vector<AnsweredCase>& cases) {
  std::map<std::pair<std::size_t, std::string>, Part> parts;
  std::map<std::string, std::pair<std::size_t, std::size_t>> counts;  // explained, left
  for (const AnsweredCase& one : cases)
    for (const AnsweredNumber& number : one.numbers) {
      Part& part = parts[{number.place, one.branch}];
      part.place = number.place;
      part.branch = one.branch;
      ++part.answered;
      if (number.is_left()) part.wrong.push_back(&number);
      counts[one.branch].first += number.is_wrong && number.is_explained ? 1 : 0;
      counts[one.branch].second += number.is_left() ? 1 : 0;
    }
  // After a named mistake, a few other wrong answers, such as near a border, are not told.
  std::vector<Part> all;
  for (auto& [key, part] : parts) {
    const auto [explained, rest] = counts[part.branch];
    const bool is_news = static_cast<double>(rest) > few * static_cast<double>(explained);
    if (!part.wrong.empty() && is_news) all.push_back(std::move(part));
  }
  return all;
}

std::string pattern(const Part& part) {
  std::vector<double> ratios;
  for (const AnsweredNumber* const one : part.wrong)
    if (one->expected->high != 0) ratios.push_back(one->got / one->expected->high);
  if (ratios.empty()) return "wrong where it should be 0";
  std::sort(ratios.begin(), ratios.end());
  const double least = ratios.front(), greatest = ratios.back(), middle = ratios[ratios.size() / 2];
  const std::string where =
      part.wrong.size() == part.answered
          ? "everywhere"
          : fmt::format("in {} of {} cases", part.wrong.size(), part.answered);
  if (least == 0 && greatest == 0) return "answered as 0 " + where;
  if (greatest - least <= 2e-3 * std::abs(middle - 1) + 1e-9)
    return fmt::format("{} {}", in_words(middle), where);
  return fmt::format("off {}, between {} and {}, in the middle {}", where, in_words(least),
                     in_words(greatest), in_words(middle));
}

Description described(const Part& part, const std::vector<AnsweredCase>& cases,
                      const std::vector<Mistake>& mistakes) {
  std::string text = pattern(part);
  if (part.wrong.size() < part.answered)
    if (const std::string where = where_wrong(cases, part.branch, part.place); !where.empty())
      text += ": " + where;
  text += '.';
  const std::string factor = constant_factor(part);
  if (!factor.empty()) return {text + ' ' + factor, true};
  const std::string powers = exponents_in_words(part, cases, mistakes);
  if (!powers.empty()) return {text + powers, true};
  if (std::string manner = manner_of_errors(cases, part.branch, part.place); !manner.empty()) {
    manner[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(manner[0])));
    text += ' ' + manner + '.';
  }
  return {text, false};
}

}  // namespace tribo::conformance
