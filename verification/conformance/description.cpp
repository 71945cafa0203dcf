// SPDX-License-Identifier: Apache-2.0
#include "conformance/description.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "conformance/dependence.hpp"
#include "conformance/misread.hpp"
#include "conformance/place.hpp"
#include "conformance/scatter.hpp"
#include "conformance/variable.hpp"

namespace tribo::conformance {
namespace {

// --- Numbers as products of powers

// Numbers as a product of powers of a function's inputs, by least squares on logarithms.
struct PowerLaw {
  std::vector<double> exponents;  // of each parameter; 0 for those that were held fixed
  double constant = 0;            // with its sign
  double residual = 0;            // the greatest error of the logarithm
  std::string held = {};          // "k = 1" if only those cases are fitted
};

// The value that is fitted for a number: the answer, the expected value, a mistake's value, or a
// ratio.
using NumberOf = std::function<double(const AnsweredCase&, const AnsweredNumber&)>;

struct FittedNumber {
  const Part::Number* of;
  double number;
};

// The inputs that a power can be of: numbers above zero.
std::vector<std::size_t> powers_of(const catalogue::Function& function) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < function.parameters.size(); ++i)
    if (function.parameters[i].words.empty() &&
        function.parameters[i].range == catalogue::Range::above_zero)
      places.push_back(i);
  return places;
}

std::optional<PowerLaw> fit(const std::vector<FittedNumber>& samples,
                            std::vector<std::size_t> places, std::size_t parameters) {
  // An input with the same value everywhere has no exponent to fit.
  std::erase_if(places, [&](std::size_t place) {
    return std::all_of(samples.begin(), samples.end(), [&](const FittedNumber& one) {
      return one.of->input(place) == samples.front().of->input(place);
    });
  });
  const auto rows = static_cast<Eigen::Index>(samples.size());
  const auto columns = static_cast<Eigen::Index>(places.size() + 1);
  if (rows < columns + 3) return std::nullopt;
  Eigen::MatrixXd inputs(rows, columns);
  Eigen::VectorXd logarithms(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const FittedNumber& sample = samples[static_cast<std::size_t>(i)];
    inputs(i, 0) = 1;
    for (Eigen::Index k = 1; k < columns; ++k)
      inputs(i, k) = std::log(sample.of->input(places[static_cast<std::size_t>(k - 1)]));
    logarithms(i) = std::log(std::abs(sample.number));
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(inputs);
  if (solver.rank() < columns) return std::nullopt;
  const Eigen::VectorXd found = solver.solve(logarithms);
  PowerLaw law{std::vector<double>(parameters),
               std::copysign(std::exp(found(0)), samples[0].number),
               (inputs * found - logarithms).lpNorm<Eigen::Infinity>()};
  for (std::size_t k = 0; k < places.size(); ++k)
    law.exponents[places[k]] = found(static_cast<Eigen::Index>(k + 1));
  return law;
}

// The value of an argument that most samples have.
double commonest(const std::vector<FittedNumber>& samples, std::size_t place) {
  std::map<double, std::size_t> counts;
  for (const FittedNumber& one : samples) ++counts[one.of->input(place)];
  return std::max_element(counts.begin(), counts.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

// An input that does not enter as a power, such as the ellipticity in the film's constant, is held
// at the value that most cases have. Empty: there are too few cases, or the numbers are no
// product of powers, to `closeness` of the logarithm.
std::optional<PowerLaw> fit_power_law(const Part& part, const NumberOf& number_of,
                                      double closeness) {
  if (part.function() == nullptr) return std::nullopt;
  const catalogue::Function& function = *part.function();
  std::vector<FittedNumber> samples;
  for (const Part::Number& one : part.all) {
    const double value = number_of(*one.of, *one.answered);
    if (!std::isfinite(value) || value == 0) return std::nullopt;
    if (!samples.empty() && std::signbit(value) != std::signbit(samples.front().number))
      return std::nullopt;
    samples.push_back({&one, value});
  }
  const std::vector<std::size_t> places = powers_of(function);
  const auto is_close = [&](const std::optional<PowerLaw>& law) {
    return law && law->residual <= closeness;
  };
  if (const auto law = fit(samples, places, function.parameters.size()); is_close(law)) return law;
  for (const std::size_t held : places) {
    const double value = commonest(samples, held);
    std::vector<FittedNumber> of_value;
    std::copy_if(samples.begin(), samples.end(), std::back_inserter(of_value),
                 [&](const FittedNumber& one) { return one.of->input(held) == value; });
    if (auto law = fit(of_value, places, function.parameters.size()); is_close(law)) {
      law->held = fmt::format("{} = {:.4g}", symbol_of(function.parameters[held].meaning), value);
      return law;
    }
  }
  return std::nullopt;
}

// "F^+0.49", or "F^(+1/3)" where the exponent is such a fraction.
std::string power_in_words(const catalogue::Parameter& parameter, double exponent) {
  for (const int denominator : {1, 2, 3, 4, 6}) {
    const double numerator = exponent * denominator;
    if (std::abs(numerator - std::round(numerator)) > 1e-6 * denominator) continue;
    return denominator == 1 ? fmt::format("{}^{:+.0f}", symbol_of(parameter.meaning), numerator)
                            : fmt::format("{}^({:+.0f}/{})", symbol_of(parameter.meaning),
                                          numerator, denominator);
  }
  return fmt::format("{}^{:+.4g}", symbol_of(parameter.meaning), std::round(exponent * 1e5) / 1e5);
}

std::string powers_in_words(const catalogue::Function& function,
                            const std::vector<double>& exponents) {
  std::string text;
  for (std::size_t i = 0; i < exponents.size(); ++i)
    if (std::abs(exponents[i]) > 1e-4)
      text += (text.empty() ? "" : " ") + power_in_words(function.parameters[i], exponents[i]);
  return text;
}

// --- Words

// The inputs that are numbers: neither words nor the order of a moment.
std::vector<std::size_t> number_inputs(const Part& part) {
  std::vector<std::size_t> inputs;
  if (part.function() == nullptr) return inputs;
  const auto& parameters = part.function()->parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (parameters[i].words.empty() && parameters[i].range != catalogue::Range::half_order)
      inputs.push_back(i);
  return inputs;
}

// "27.5 % low", "1000 times too large".
std::string in_words(double ratio) {
  if (std::isinf(ratio)) return "beyond any double";
  if (ratio == 0) return "0 times the right value";
  if (std::abs(ratio + 1) < 1e-6) return "−1 times the right value";
  if (ratio < 0) return fmt::format("{:.4g} times the right value, of the wrong sign", ratio);
  if (ratio > 3) return fmt::format("{:.4g} times too large", ratio);
  if (ratio < 1.0 / 3) return fmt::format("{:.4g} times too small", 1 / ratio);
  return fmt::format("{:.3g} % {}", 100 * std::abs(ratio - 1), ratio < 1 ? "low" : "high");
}

// "It is too small by a factor of 2π.": a factor that people lose or gain. Empty: it is none.
std::string known_factor(double ratio) {
  if (std::abs(ratio + 1) < 1e-6) return "It has another sign convention.";
  const FamiliarFactor* const factor = familiar_factor(ratio, 1e-6);
  if (factor == nullptr) return {};
  return fmt::format("It is too {} by a factor of {}{}.", ratio > 1 ? "large" : "small",
                     factor->name, factor->origin);
}

// " It is h/R = 1.9 U^+0.67 …" for a film that is a law in U, G and W with E′ = 2E*; else empty.
std::string film_in_groups(const catalogue::Function& function, const PowerLaw& got) {
  if (function.film_law == nullptr) return {};
  // The exponents of u, η₀, α (not for soft bodies), F or F/L, E*, R.
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

// A sentence on a known mistake with the same exponents, but another constant; else empty.
std::string same_exponents(const Part& part, const PowerLaw& got,
                           const std::vector<Mistake>& mistakes) {
  for (const Mistake& mistake : mistakes) {
    const Mistake* const one = &mistake;
    const auto its = fit_power_law(
        part,
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
        powers_in_words(*part.function(), got.exponents), mistake.text,
        got.constant / its->constant);
  }
  return {};
}

// The exponents in a sentence: "It goes as F^+0.49; the law has F^-0.067."
std::string exponents_in_words(const Part& part, const std::vector<Mistake>& mistakes) {
  const auto fitted = [&](const NumberOf& number_of) {
    return fit_power_law(part, number_of, rounding);
  };
  const auto got = fitted([](const AnsweredCase&, const AnsweredNumber& one) { return one.got; });
  const auto law =
      fitted([](const AnsweredCase&, const AnsweredNumber& one) { return one.expected->high; });
  if (!got || !law) return {};
  const catalogue::Function& function = *part.function();
  std::vector<double> extra(got->exponents.size());
  for (std::size_t i = 0; i < extra.size(); ++i) extra[i] = got->exponents[i] - law->exponents[i];
  if (powers_in_words(function, extra).empty()) return {};
  std::string text = same_exponents(part, *got, mistakes);
  if (!text.empty()) return text;
  const std::string in_groups = film_in_groups(function, *got);
  for (std::size_t i = 0; i < extra.size(); ++i) {
    if (std::abs(extra[i]) <= 1e-4) continue;
    const catalogue::Parameter& input = function.parameters[i];
    // The exponents of E* and R follow from those of U, G and W.
    if (!in_groups.empty() && (input.name == "effective_modulus" || input.unit == "m")) continue;
    const std::string symbol = symbol_of(input.meaning);
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

// A sentence if the factor is that of "3.14 in place of π", to some power; else empty.
std::string rough_pi(double factor) {
  struct RoughPi {
    double value;
    const char* written;
  };
  constexpr RoughPi rough_pis[] = {{3, "3"},          {3.1, "3.1"},       {3.14, "3.14"},
                                   {3.142, "3.142"},  {3.1416, "3.1416"}, {3.14159, "3.14159"},
                                   {22.0 / 7, "22/7"}};
  constexpr double closeness = 1e-9;
  for (const RoughPi& one : rough_pis)
    for (const double power : {1.0, 2.0, 3.0, 1.0 / 2, 3.0 / 2, 1.0 / 3, 2.0 / 3}) {
      const double wanted = std::pow(one.value / std::numbers::pi, power);
      if (std::abs(factor - wanted) < closeness || std::abs(factor - 1 / wanted) < closeness)
        return fmt::format("It is off by one factor, as {} in place of π makes it.", one.written);
    }
  return {};
}

std::string constant_factor(const Part& part) {
  double least = INFINITY, greatest = -INFINITY;
  for (const AnsweredNumber* const one : part.wrong) {
    if (one->expected->high == 0) return {};
    least = std::min(least, one->got / one->expected->high);
    greatest = std::max(greatest, one->got / one->expected->high);
  }
  if (greatest - least >= 1e-9 * std::abs(greatest)) return {};
  if (std::string pi = rough_pi((least + greatest) / 2); !pi.empty()) return pi;
  const double off = (least + greatest) / 2 - 1;
  if (std::abs(off) < rounding && greatest - least < 0.01 * std::abs(off) &&
      part.wrong.size() >= fewest_cases)
    return fmt::format(
        "It is off by one factor, 1 {} {:.3g}, as a constant with too few digits makes it.",
        off < 0 ? "−" : "+", std::abs(off));
  return known_factor(least);
}

// "All answers are too large by 1e-09, large or small as they are: a sum is added." The sum may
// also be a number times one input. Empty: there is no such sum.
std::string constant_sum(const Part& part) {
  constexpr double one_sum = 1e-6, of_double = 1e-15;  // relative to the sum, to the answer
  if (part.wrong.size() < fewest_cases) return {};
  const auto off = [](const Part::Number& one) { return one.answered->error(); };
  const auto is_by = [&](const std::function<double(const Part::Number&)>& sum) {
    return std::all_of(part.all.begin(), part.all.end(), [&](const Part::Number& one) {
      const double left = std::abs(off(one) - sum(one));
      const double fine = one_sum * std::abs(sum(one)) + of_double * std::abs(one.answered->got);
      return one.answered->is_explained ||
             left <= (one.answered->is_wrong ? fine : std::max(fine, one.answered->allowed));
    });
  };
  // The answer that shows the sum best.
  const auto best = std::max_element(
      part.all.begin(), part.all.end(), [&](const Part::Number& a, const Part::Number& b) {
        return std::abs(off(a) / a.answered->got) < std::abs(off(b) / b.answered->got);
      });
  const auto in_words = [](double sum, const std::string& rest) {
    return fmt::format(
        "All answers are too {} by {:.6g}{}, large or small as they are: a sum is {}.",
        sum < 0 ? "small" : "large", std::abs(sum), rest, sum < 0 ? "missing" : "added");
  };
  const double sum = round_number(off(*best));
  const std::string_view unit = results_of(part.function())[part.place].unit;
  if (is_by([sum](const Part::Number&) { return sum; }))
    return in_words(sum, unit.empty() ? "" : " " + std::string(unit));
  for (const std::size_t input : number_inputs(part)) {
    const double times = round_number(off(*best) / best->input(input));
    if (std::isfinite(times) && times != 0 &&
        is_by([&](const Part::Number& one) { return times * one.input(input); }))
      return in_words(times, " times " + symbol_of(part.function()->parameters[input].meaning));
  }
  return {};
}

}  // namespace

std::function<double(const Question&)> power_factor(const Part& part) {
  const auto law = fit_power_law(
      part,
      [](const AnsweredCase&, const AnsweredNumber& one) { return one.got / one.expected->high; },
      rounding);
  if (!law || !law->held.empty()) return {};
  return [law = *law](const Question& question) {
    double factor = law.constant;
    for (std::size_t i = 0; i < law.exponents.size(); ++i)
      if (law.exponents[i] != 0) factor *= std::pow(question.arguments[i], law.exponents[i]);
    return factor;
  };
}

std::string pattern(const Part& part) {
  std::vector<double> ratios;
  for (const AnsweredNumber* const one : part.wrong)
    if (one->expected->high != 0) ratios.push_back(one->got / one->expected->high);
  if (ratios.empty()) return "wrong where it should be 0";
  std::sort(ratios.begin(), ratios.end());
  const double least = ratios.front(), greatest = ratios.back(), middle = ratios[ratios.size() / 2];
  const std::string where =
      part.wrong.size() == part.all.size()
          ? "everywhere"
          : fmt::format("in {} of {} cases", part.wrong.size(), part.all.size());
  if (least == 0 && greatest == 0) return "answered as 0 " + where;
  const double off = std::abs(middle - 1);
  if (greatest - least <= 2e-3 * off + std::min(1e-9, 1e-3 * off))
    return fmt::format("{} {}", in_words(middle), where);
  return fmt::format("off {}, between {} and {}; median: {}", where, in_words(least),
                     in_words(greatest), in_words(middle));
}

constexpr double log_chance_of_cache = -14;  // a millionth

// The inputs in which two cases differ: "surface.summit_density".
std::vector<std::string> different_inputs(const AnsweredCase& one, const AnsweredCase& other) {
  if (const catalogue::Function* const function = one.question.function) {
    std::vector<std::string> found;  // what a question leaves out has its default
    for (std::size_t i = 0; i < function->parameters.size(); ++i)
      if (one.question.arguments[i] != other.question.arguments[i])
        found.emplace_back(function->parameters[i].name);
    return found;
  }
  const nlohmann::json inputs = one.question.asked->inputs.flatten();
  const nlohmann::json others = other.question.asked->inputs.flatten();
  std::vector<std::string> found;
  for (const auto& [pointer, value] : inputs.items()) {
    if (others.value(pointer, nlohmann::json()) == value) continue;
    std::string name = pointer.substr(1);
    std::replace(name.begin(), name.end(), '/', '.');
    found.push_back(std::move(name));
  }
  return found;
}

// A sentence if all wrong answers are those of one value of the input, and nearly all answers at
// values beyond it are wrong: the input is cut off there. Else empty.
std::string cut_at(const Part& part, const std::string& input, const std::vector<double>& given) {
  const catalogue::Function* const function = part.function();
  const bool is_one =
      std::adjacent_find(given.begin(), given.end(), std::not_equal_to<>()) == given.end();
  if (function == nullptr || !is_one) return {};
  std::size_t place = 0;
  while (function->parameters[place].name != input) ++place;
  for (const bool is_below : {true, false}) {
    std::size_t beyond = 0, wrong = 0;
    bool is_cut = true;
    for (const Part::Number& one : part.all) {
      const double value = one.input(place);
      const bool is_beyond = is_below ? value < given.front() : value > given.front();
      beyond += is_beyond ? 1 : 0;
      wrong += one.answered->is_left() ? 1 : 0;
      is_cut = is_cut && (is_beyond || !one.answered->is_left());
    }
    if (is_cut && 10 * wrong >= 9 * beyond)  // close to the cut, answers may be within their bounds
      return fmt::format(
          "The answers are those of {} = {:.6g} wherever it is {}: it is cut off there", input,
          given.front(), is_below ? "less" : "greater");
  }
  return {};
}

// A sentence if each wrong answer is the right one of another case, which differs only in inputs of
// one set for all; the set has at most `most_inputs` inputs. Else empty.
std::string kept_answers(const Part& part, std::size_t most_inputs) {
  constexpr std::size_t fewest_of_two = 3;
  std::set<std::string> inputs;
  std::set<double> answers;
  std::string example;
  std::vector<double> given;  // the input of these cases, if it is only one
  for (const Part::Number& wrong : part.all) {
    if (!wrong.answered->is_left()) continue;
    const bool is_kept =
        std::any_of(part.all.begin(), part.all.end(), [&](const Part::Number& one) {
          if (one.answered->is_wrong || one.answered->got != wrong.answered->got) return false;
          const std::vector<std::string> different = different_inputs(*wrong.of, *one.of);
          std::set<std::string> all = inputs;
          all.insert(different.begin(), different.end());
          if (different.empty() || all.size() > most_inputs) return false;
          if (inputs.empty())
            example = fmt::format("{} is answered as {}", wrong.of->question.asked->id,
                                  one.of->question.asked->id);
          inputs = std::move(all);
          answers.insert(one.answered->got);
          if (part.function() != nullptr)
            for (std::size_t i = 0; i < part.function()->parameters.size(); ++i)
              if (part.function()->parameters[i].name == different[0])
                given.push_back(one.input(i));
          return true;
        });
    if (!is_kept) return {};
  }
  if (inputs.empty() || (inputs.size() > 1 && answers.size() < fewest_of_two)) return {};
  const std::string cut = inputs.size() == 1 ? cut_at(part, *inputs.begin(), given) : std::string();
  const std::string input = fmt::format("{}", fmt::join(inputs, " and "));
  if (!cut.empty() && given.size() >= fewest_cases) return cut + '.';
  if (!cut.empty())
    return fmt::format(
        "{}; or the solver keeps answers, as a cache does, and looks for them without {} ({}).",
        cut, input, example);
  return fmt::format(
      "This is the answer to a case that differs in {} alone ({}): the solver keeps answers, as a "
      "cache does, and looks for them without {}.",
      input, example, input);
}

// A sentence if only cases that differ from the case before in one input are wrong, and hardly by
// chance; else empty. It names the inputs at whose change wrong answers begin. A solver errs so if
// it keeps a part of the answer in a cache and looks for it without these inputs.
std::string kept_from_before(const Part& part) {
  std::vector<std::vector<std::string>> changed(part.all.size());
  double alike = 0, log_chance = 0, count = static_cast<double>(part.all.size());
  for (std::size_t i = 1; i < part.all.size(); ++i) {
    changed[i] = different_inputs(*part.all[i].of, *part.all[i - 1].of);
    alike += changed[i].size() == 1 ? 1 : 0;
  }
  std::set<std::string> begins;
  std::string first;
  for (std::size_t i = 0; i < part.all.size(); ++i) {
    if (!part.all[i].answered->is_left()) continue;
    if (changed[i].size() != 1) return {};
    log_chance += std::log(alike-- / count--);
    if (part.all[i - 1].answered->is_wrong) continue;
    begins.insert(changed[i].front());
    if (first.empty()) first = part.all[i].of->question.asked->id;
  }
  // A cache that is looked up without an input is wrong wherever that input alone changes.
  const auto begin_right = [&](std::size_t i) {
    return changed[i].size() == 1 && begins.contains(changed[i].front()) &&
           !part.all[i].answered->is_wrong && !part.all[i - 1].answered->is_wrong;
  };
  std::size_t right = 0;
  for (std::size_t i = 1; i < part.all.size(); ++i) right += begin_right(i) ? 1 : 0;
  if (5 * right > part.wrong.size()) return {};
  if (begins.empty() || log_chance > log_chance_of_cache) return {};
  return fmt::format(
      "It is wrong only in cases that differ from the case before in one input, first in {}, and "
      "begins where {} changes. The solver keeps something from case to case, as a cache does, and "
      "looks for it without {}.",
      first, fmt::join(begins, " or "), begins.size() == 1 ? "this input" : "these inputs");
}

Description described(const Part& part, const std::vector<Mistake>& mistakes, bool rests_on_wrong) {
  std::string text = pattern(part);
  std::function<bool(const Question&)> is_in_place;
  const auto with = [&](const std::string& misread) {
    return fmt::format(" The answers are the right ones with {} ({} of {} wrong answers).", misread,
                       part.wrong.size(), part.wrong.size());
  };
  // Another default comes first: it is a simpler cause than a cache, which may give the same.
  if (const std::string other = other_default(part); !other.empty())
    return {text + '.' + with(other), true, other, {}};
  for (const std::size_t inputs : {1, 2})
    if (const std::string kept = kept_answers(part, inputs); !kept.empty())
      return {text + ". " + kept, true, {}, {}};
  if (2 * part.wrong.size() < part.all.size())
    if (const std::string kept = kept_from_before(part); !kept.empty())
      return {text + ". " + kept, false, {}, {}};
  if (part.wrong.size() < part.all.size())
    if (const std::optional<WrongPlace> place = place_of_wrong(part)) {
      text += ": " + place->text;
      is_in_place = place->holds;
    }
  text += '.';
  if (const std::string lost = digits_lost_below_one(part); !lost.empty() && !rests_on_wrong)
    return {text + ' ' + lost, true, {}, is_in_place};
  const std::string factor = constant_factor(part);
  if (!factor.empty()) return {text + ' ' + factor, true, {}, is_in_place};
  if (const std::string form = form_of_right(part); !form.empty())
    return {text + ' ' + form, true, {}, is_in_place};
  if (const std::string sum = constant_sum(part); !sum.empty())
    return {text + ' ' + sum, true, {}, is_in_place};
  if (const std::optional<Misread> misread = misread_input(part, mistakes))
    return {text + with(misread->text), true, misread->text, is_in_place, misread->change};
  if (const std::string other = other_value(part); !other.empty())
    return {text + ' ' + other, true, {}, is_in_place};
  const std::string powers = exponents_in_words(part, mistakes);
  if (!powers.empty()) return {text + powers, true, {}, is_in_place};
  if (const std::optional<Misread> three = three_changes(part))
    return {text + with(three->text), true, three->text, is_in_place};
  if (const std::string form = form_of(part); !form.empty())
    return {text + ' ' + form, true, {}, is_in_place};
  if (const std::string grid = grid_of(part); !grid.empty())
    return {text + ' ' + grid, true, {}, is_in_place};
  const Growth growth = rests_on_wrong ? Growth{} : growth_of(part);
  if (!growth.text.empty() && growth.is_numerics)
    return {text + ' ' + growth.text, true, growth.cause, is_in_place};
  if (const std::string ended = ended_early(part); !ended.empty() && !rests_on_wrong)
    return {text + ' ' + ended, false, {}, is_in_place};
  if (const std::optional<Dependence> depends = dependence_of(part))
    return {text + ' ' + depends->text, false, {}, is_in_place};
  if (!growth.text.empty()) return {text + ' ' + growth.text, false, {}, is_in_place};
  if (const std::string scatter = scatter_of(part); !scatter.empty() && !rests_on_wrong)
    return {text + ' ' + scatter, false, {}, is_in_place};
  return {text, false, {}, is_in_place};
}

}  // namespace tribo::conformance
