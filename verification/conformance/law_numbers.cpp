// SPDX-License-Identifier: Apache-2.0
#include "conformance/law_numbers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <unsupported/Eigen/LevenbergMarquardt>
#include <utility>

#include "catalogue/ways_to_ask.hpp"
#include "conformance/expression.hpp"
#include "conformance/misread.hpp"
#include "conformance/mistake_entry.hpp"
#include "conformance/variable.hpp"
#include "tribo/starvation.hpp"
#include "tribo/viscosity_index.hpp"

namespace tribo::conformance {
namespace {

using catalogue::Arguments;
using Constants = std::span<const double>;
constexpr std::string_view kelvin = "K";

// --- Laws as formulas of their numbers

// "8/11", with parentheses as an exponent; "1/1.96e+08".
std::string fraction_in_words(double number, bool is_exponent) {
  const double size = std::abs(number);
  int denominator = 2;
  while (denominator < 100 && std::abs(std::remainder(size * denominator, 1)) > 1e-9) ++denominator;
  std::string text = number_in_words(size);
  if (denominator < 100)
    text = fmt::format("{:.0f}/{}", size * denominator, denominator);
  else if (is_of_few_digits(1 / size))
    text = fmt::format("1/{:.6g}", 1 / size);
  if (number < 0) text = "−" + text;
  return is_exponent ? '(' + text + ')' : text;
}

std::optional<Numbers> only(double value) {
  return std::isfinite(value) ? std::optional(Numbers{value}) : std::nullopt;
}

// A law by its terms, whose numbers are these, each of them the next one of this size; behind them
// stand `exponents` of norms as (aⁿ + bⁿ)^(1/n), each at all places of it and of its reciprocal.
// Numbers that have no few digits are fractions.
LawOfNumbers law_by_terms(Expression law, std::vector<double> right,
                          const std::vector<double>& exponents = {}) {
  struct Slot {
    Expression::Place place;
    double sign;
    std::size_t number;
    bool is_reciprocal = false;
  };
  std::vector<Slot> slots;
  LawOfNumbers found;
  std::vector<Expression::Place> places = law.places_of_numbers();
  for (const double number : right) {
    const auto place = std::find_if(places.begin(), places.end(), [&](const auto& one) {
      return std::abs(std::abs(law.number_at(one)) - std::abs(number)) <= 1e-12 * std::abs(number);
    });
    slots.push_back({*place, std::copysign(1.0, law.number_at(*place) * number), slots.size()});
    const Expression::Node& node = law.nodes[place->node];
    const bool is_exponent = node.kind == Expression::Op::product && place->slot >= 0;
    LawOfNumbers::NumberName& name = found.names[slots.size() - 1];
    if (is_exponent) {
      name.before = law.nodes[node.parts[static_cast<std::size_t>(place->slot)].of].name;
      if (!name.before.empty()) name.before += '^';
    }
    if (!is_of_few_digits(number)) name.right = fraction_in_words(number, !name.before.empty());
    places.erase(place);
  }
  for (const double number : exponents) {
    for (const Expression::Place& place : places)
      for (const bool is_reciprocal : {false, true})
        if (std::abs(law.number_at(place) / (is_reciprocal ? 1 / number : number) - 1) < 1e-12)
          slots.push_back({place, 1, right.size(), is_reciprocal});
    found.names[right.size()].right = fraction_in_words(number, false);
    right.push_back(number);
  }
  found.right = std::move(right);
  // The numbers are put into one copy, as many of them are tried.
  found.formula = [law = std::make_shared<Expression>(std::move(law)), slots](
                      const Arguments& arguments, Constants n) -> std::optional<Numbers> {
    for (const Slot& slot : slots)
      law->number_at(slot.place) =
          slot.sign * (slot.is_reciprocal ? 1 / n[slot.number] : n[slot.number]);
    return only(law->value(law->results[0], arguments));
  };
  return found;
}

// The numbers of a law, in the order of their places: coefficients without their signs.
std::vector<double> numbers_of(Expression law) {
  std::vector<double> numbers;
  for (const Expression::Place& place : law.places_of_numbers()) {
    const bool is_exponent =
        law.nodes[place.node].kind == Expression::Op::product && place.slot >= 0;
    const double number = law.number_at(place);
    numbers.push_back(is_exponent ? number : std::abs(number));
  }
  return numbers;
}

// The numbers of a law with few digits, or with few digits in the reciprocal. Simple fractions,
// such as 2 or 3/4, are left out.
std::vector<double> printed_numbers(const Expression& law) {
  std::vector<double> numbers = numbers_of(law);
  std::erase_if(numbers, [](double number) {
    const bool is_fraction = std::remainder(12 * number, 1) == 0 && std::abs(12 * number) < 100;
    return is_fraction || !(is_of_few_digits(number) || is_of_few_digits(1 / number));
  });
  return numbers;
}

// Those of C, a, b, c, m and n in h/R = C Uᵃ Gᵇ Wᶜ (1 − m e^{−nk}) that the law has.
std::vector<double> numbers_of_film(const FilmLaw& law) {
  std::vector<double> numbers;
  for (const Fraction& number : {law.constant, law.speed_exponent, law.material_exponent,
                                 law.load_exponent, law.side_leakage, law.side_decay})
    if (number.p != 0) numbers.push_back(static_cast<double>(number.p) / number.q);
  return numbers;
}

// Numbers: 10, 100 and 0.00715 of oils above 100, then each row of D2270's table, as it is printed.
LawOfNumbers index_law_of_numbers() {
  LawOfNumbers law{[](const Arguments& a, Constants n) -> std::optional<Numbers> {
                     const std::size_t row = detail::index_row(a[1]);
                     const double u = 1e6 * a[0], y = 1e6 * a[1];
                     const Constants c = n.subspan(3 + 6 * row, 6);
                     const double zero = (c[0] * y + c[1]) * y + c[2];
                     const double hundred = (c[3] * y + c[4]) * y + c[5];
                     if (u >= hundred) return only(n[1] * (zero - u) / (zero - hundred));
                     const double power = std::log(hundred / u) / std::log(y);
                     return only((std::pow(n[0], power) - 1) / n[2] + n[1]);
                   },
                   {10, 100, 0.00715},
                   {}};
  for (const detail::IndexRow& row : detail::index_rows)
    for (const auto& [number, places] : {std::pair{row.a, 1e5},
                                         {row.b, 1e4},
                                         {row.c, 1e3},
                                         {row.d, 1e5},
                                         {row.e, 1e4},
                                         {row.f, 1e3}})
      law.right.push_back(number / places);
  return law;
}

// Numbers: 2.7 of Wolveridge's y, then n₁ = 4√2/3, n₂ and n₃ of 1/r = y + n₁ψ^{n₂} y^{−n₃}.
std::optional<Numbers> starved_film(const Arguments& a, Constants n) {
  const auto closure = static_cast<StarvationClosure>(static_cast<int>(a[0]));
  if (closure == StarvationClosure::damiens) return std::nullopt;
  if (closure == StarvationClosure::flooded_inlet && a[1] >= 1) return only(0);
  const auto film_ratio = [&](double psi) { return std::atan(n[0] * psi) * 2 / std::numbers::pi; };
  const auto is_long = [&](double psi) {
    const double y = film_ratio(psi);
    const double power = closure == StarvationClosure::printed_exponents ? std::pow(y, -n[3]) : 1.0;
    const double other = closure == StarvationClosure::flooded_inlet ? 1 : y;
    return a[1] * (other + n[1] * std::pow(psi, n[2]) * power) > 1;
  };
  double low = -300, high = 60;  // ln ψ
  if (is_long(std::exp(low)) || !is_long(std::exp(high))) return std::nullopt;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (is_long(std::exp(middle)) ? high : low) = middle;
  }
  return only(film_ratio(std::exp((low + high) / 2)));
}

// Numbers: the exponent of λ = λ₀ (1 − A)^−e, and q of A = (K F)^q by each model.
std::optional<Numbers> shared_load(const Arguments& a, Constants n) {
  static const catalogue::Function* const function = catalogue::function_named("load_sharing");
  Question asked{nullptr, function, a};
  asked.sharing.film_exponent = n[0];
  asked.sharing.share_exponent = n[a[0] == 0 ? 1 : 2];
  return only(right_numbers(asked)[0]);
}

// Numbers: 6 of the density m₄/(6√3π m₂), 3/8 of the radius, 0.8968 and 4 of the heights.
std::optional<Numbers> summits(const Arguments& m, Constants n) {
  const double pi = std::numbers::pi, bandwidth = m[0] / m[1] * (m[2] / m[1]);
  const double excess = bandwidth - n[2];
  return Numbers{bandwidth, m[2] / (n[0] * pi * std::numbers::sqrt3 * m[1]),
                 n[1] * std::sqrt(pi / m[2]), std::sqrt(excess / bandwidth * m[0]),
                 n[3] / std::sqrt(pi * excess)};
}

// --- Numbers and factors that may be changed

int digits_of(double number) {
  int digits = 1;
  while (of_digits(number, digits) != number && digits < 17) ++digits;
  return digits;
}

// Whether a source may print the number in place of `other`: it has few digits, or as many.
bool is_printed_like(double value, double other) {
  const int digits = digits_of(other);
  return is_of_few_digits(value) ||
         (digits <= 6 && std::abs(of_digits(value, digits) - value) <= 1e-8 * std::abs(value));
}

// The digits of a number, without its exponent and zeros.
std::string digits_in(double value, int digits) {
  std::string written = fmt::format("{:.{}e}", std::abs(value), digits - 1);
  written.resize(written.find('e'));
  std::erase(written, '.');
  return written;
}

// Whether the number has the digits of another one in another order: "1.95" for "1.59".
bool has_exchanged_digits(double value, double other) {
  const int digits = digits_of(other);
  if (digits > 6 ||
      std::floor(std::log10(std::abs(value))) != std::floor(std::log10(std::abs(other))))
    return false;
  const std::string now = digits_in(value, digits), then = digits_in(other, digits);
  return now != then && std::is_permutation(now.begin(), now.end(), then.begin(), then.end()) &&
         is_printed_like(value, other);
}

// The numbers that come where two digits of a number are exchanged.
std::vector<double> with_exchanged_digits(double number) {
  std::vector<double> found;
  const int digits = digits_of(number);
  const std::string right = fmt::format("{:.{}e}", number, digits - 1);
  for (std::size_t i = 0; digits <= 6 && i < right.find('e'); ++i)
    for (std::size_t k = i + 1; k < right.find('e'); ++k) {
      std::string exchanged = right;
      std::swap(exchanged[i], exchanged[k]);
      if (exchanged != right && right[i] != '.' && right[k] != '.' && right[i] != '-')
        found.push_back(std::stod(exchanged));
    }
  return found;
}

struct Change {
  std::string symbol;
  std::size_t place;  // in the law's numbers, or in the function's arguments
  bool is_input;
  double right;           // 1 for the factor of an input
  bool is_added = false;  // to all temperatures, in K

  double value(double step) const {
    constexpr double kelvins = 100;
    if (is_added) return kelvins * step;
    return is_input ? std::exp(step) : right * (1 + step);
  }
  double step_of(double other) const { return is_added ? other / value(1) : other / right - 1; }
};

std::vector<Change> changes_of(const catalogue::Function& function, const LawOfNumbers& law) {
  std::vector<Change> all;
  for (std::size_t i = 0; i < law.right.size(); ++i)
    if (law.right[i] != 0) all.push_back({law.in_words(i, law.right[i]), i, false, law.right[i]});
  for (std::size_t i = 0; i < function.parameters.size(); ++i)
    if (function.parameters[i].words.empty() &&
        function.parameters[i].range == catalogue::Range::above_zero)
      all.push_back({symbol_of(function.parameters[i].meaning), i, true, 1});
  std::vector<std::string> temperatures;
  for (const catalogue::Parameter& one : function.parameters)
    if (one.unit == kelvin) temperatures.push_back(symbol_of(one.meaning));
  if (temperatures.size() > 1)
    all.push_back({fmt::format("each of {}", fmt::join(temperatures, ", ")), 0, true, 0, true});
  return all;
}

// The law with some of its numbers, or of its inputs, changed.
struct ChangedLaw {
  LawOfNumbers law;
  std::vector<Change> changes;

  double answer(const Question& asked, const Eigen::VectorXd& steps, std::size_t place) const {
    Arguments arguments = asked.arguments;
    std::vector<double> numbers = law.right;
    for (std::size_t i = 0; i < changes.size(); ++i) {
      const double value = changes[i].value(steps[static_cast<Eigen::Index>(i)]);
      if (changes[i].is_added) {
        for (std::size_t k = 0; k < asked.function->parameters.size(); ++k)
          if (asked.function->parameters[k].unit == kelvin) arguments[k] += value;
      } else if (changes[i].is_input)
        arguments[changes[i].place] *= value;
      else
        numbers[changes[i].place] = value;
    }
    const auto given = law.formula(arguments, numbers);
    return given ? (*given)[place] : unsaid;
  }
};

// The differences between the law's answers and the wrong ones, for Eigen's least squares.
struct Residuals : Eigen::DenseFunctor<double> {
  Residuals(const ChangedLaw& changed, const std::vector<Part::Number>& all, std::size_t of)
      : DenseFunctor(static_cast<int>(changed.changes.size()), static_cast<int>(all.size())),
        law(&changed),
        wrong(&all),
        place(of) {}

  int operator()(const InputType& steps, ValueType& left) const {
    for (std::size_t i = 0; i < wrong->size(); ++i) {
      const Part::Number& one = (*wrong)[i];
      const double given = law->answer(one.of->question, steps, place);
      if (!std::isfinite(given)) return -1;
      // The logarithm of an answer is nearly linear in exponents. It has a pole at 0, which the
      // search must pass to reach an answer of the wrong sign.
      const double got = one.answered->got, right = one.answered->expected->high;
      left[static_cast<Eigen::Index>(i)] = given / got > 0 && right / got > 0
                                               ? std::log(given / got)
                                               : (given - got) / (std::abs(got) + std::abs(right));
    }
    return 0;
  }
  int df(const InputType& steps, JacobianType& slopes) const {
    constexpr double width = 1e-6;
    ValueType above(values()), below(values());
    for (Eigen::Index i = 0; i < steps.size(); ++i) {
      InputType moved = steps;
      moved[i] = steps[i] + width;
      if ((*this)(moved, above) < 0) return -1;
      moved[i] = steps[i] - width;
      if ((*this)(moved, below) < 0) return -1;
      slopes.col(i) = (above - below) / (2 * width);
    }
    return 0;
  }

  const ChangedLaw* law;
  const std::vector<Part::Number>* wrong;
  std::size_t place;
};

constexpr double of_answers = 1e-6;  // how closely the wrong ones have to be met
constexpr double as_printed = 1e-6;  // relative; a nearer number is the right one
constexpr std::size_t most_in_pairs = 16, fewest_of_pairs = 4, fewest_of_three = 8;
// A search that finds the numbers converges quadratically. It is given up if some steps have not
// made the residual so much smaller.
constexpr int steps_at_most = 20, steps_that_show = 5, evaluations_at_most = 60;
constexpr double smaller_by_then = 0.1;
constexpr double probed = 1e-3;  // of a number, to see whether answers depend on it

// The steps with which the law gives these wrong answers, sought from `steps`. Empty: not found.
std::optional<Eigen::VectorXd> steps_to(const ChangedLaw& changed,
                                        const std::vector<Part::Number>& wrong, std::size_t place,
                                        Eigen::VectorXd steps) {
  Residuals residuals(changed, wrong, place);
  Eigen::VectorXd left(residuals.values());
  Eigen::LevenbergMarquardt<Residuals> search(residuals);
  search.setMaxfev(evaluations_at_most);
  if (search.minimizeInit(steps) == Eigen::LevenbergMarquardtSpace::ImproperInputParameters)
    return std::nullopt;
  const double at_first = search.fnorm();
  for (int i = 1; i <= steps_at_most; ++i) {
    if (search.minimizeOneStep(steps) != Eigen::LevenbergMarquardtSpace::Running) break;
    if (i >= steps_that_show && search.fnorm() > smaller_by_then * at_first) return std::nullopt;
  }
  if (!steps.allFinite() || residuals(steps, left) < 0 ||
      left.lpNorm<Eigen::Infinity>() > of_answers)
    return std::nullopt;
  return steps;
}

std::vector<Part::Number> least_off(std::vector<Part::Number> numbers, std::size_t count) {
  const auto off = [](const Part::Number& one) {
    return std::abs(std::log(std::abs(one.answered->got / one.answered->expected->high)));
  };
  std::stable_sort(numbers.begin(), numbers.end(),
                   [&](const Part::Number& a, const Part::Number& b) { return off(a) < off(b); });
  numbers.resize(count);
  return numbers;
}

std::optional<FittedNumbers> fitted(const LawOfNumbers& law, std::vector<Change> changes,
                                    const std::vector<Part::Number>& wrong, std::size_t place) {
  ChangedLaw changed{law, std::move(changes)};
  const Eigen::VectorXd none =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(changed.changes.size()));
  auto solved = steps_to(changed, wrong, place, none);
  // Near a pole of the law the search for one number first fits one answer, and the search for two
  // numbers those that are least off.
  for (std::size_t i = 0; i < 3 && !solved && changed.changes.size() == 1 && wrong.size() > 3; ++i)
    if (const auto one = steps_to(changed, {wrong[i * (wrong.size() - 1) / 2]}, place, none))
      solved = steps_to(changed, wrong, place, *one);
  if (!solved && changed.changes.size() == 2 && wrong.size() >= fewest_of_three)
    if (const auto near = steps_to(changed, least_off(wrong, wrong.size() / 3), place, none))
      solved = steps_to(changed, wrong, place, *near);
  if (!solved) return std::nullopt;
  Eigen::VectorXd& steps = *solved;
  FittedNumbers found{changed.changes.size(), true, true, {}, {}, {}};
  for (std::size_t i = 0; i < changed.changes.size(); ++i) {
    const Change& one = changed.changes[i];
    double& step = steps[static_cast<Eigen::Index>(i)];
    if (std::abs(step) < as_printed) return std::nullopt;
    const double value = one.value(step);
    const std::string now = one.is_added   ? fmt::format("{} {} {:.6g}", one.symbol,
                                                       value < 0 ? "−" : "+", std::abs(value))
                            : one.is_input ? times_in_words(value, one.symbol)
                                           : law.in_words(one.place, value);
    found.is_plausible = found.is_plausible && (one.is_added   ? is_of_few_digits(value)
                                                : one.is_input ? is_familiar(value)
                                                               : is_printed_like(value, one.right));
    found.is_exchange = found.is_exchange && !one.is_added &&
                        (one.is_input || has_exchanged_digits(value, one.right));
    found.values.push_back(value);
    // The rounded number that people write replaces the search's approximation.
    if (one.is_added || (!one.is_input && is_printed_like(value, one.right)))
      step = one.step_of(round_number(value));
    found.text += fmt::format("{}{} in place of {}", i == 0 ? "" : ", and ", now, one.symbol);
  }
  found.answer = [changed, steps = steps](const Question& asked, std::size_t of) {
    return changed.answer(asked, steps, of);
  };
  return found;
}

std::size_t inputs_that_vary(const std::vector<Part::Number>& numbers) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < numbers.front().of->question.function->parameters.size(); ++i)
    count += std::any_of(
                 numbers.begin(), numbers.end(),
                 [&](const Part::Number& one) { return one.input(i) != numbers.front().input(i); })
                 ? 1
                 : 0;
  return count;
}

// Single numbers that give all wrong answers. Factors of inputs are not tried.
std::vector<FittedNumbers> singles(const LawOfNumbers& law, const std::vector<Change>& changes,
                                   const std::vector<Part::Number>& wrong, std::size_t place) {
  std::vector<FittedNumbers> found;
  for (const Change& one : changes)
    if (!one.is_input)
      if (auto single = fitted(law, {one}, wrong, place)) found.push_back(std::move(*single));
  return found;
}

// Two numbers that each give some of the wrong answers alone, such as those of two rows of a table.
// The first is fitted to one answer, and the second to all answers that the first does not give.
std::vector<FittedNumbers> one_after_the_other(const LawOfNumbers& law,
                                               const std::vector<Change>& changes,
                                               const std::vector<Part::Number>& wrong,
                                               std::size_t place) {
  constexpr std::size_t looked_at = 8, fewest_of_each = 3;
  const std::size_t step = std::max<std::size_t>(1, wrong.size() / looked_at);
  for (const Change& one : changes)
    for (std::size_t i = 0; i < wrong.size() && !one.is_input; i += step) {
      const auto first = fitted(law, {one}, {wrong[i]}, place);
      if (!first || !first->is_plausible) continue;
      std::vector<Part::Number> rest;
      for (const Part::Number& number : wrong) {
        const double given = first->answer(number.of->question, place);
        if (!(std::abs(given - number.answered->got) <= of_answers * std::abs(given)))
          rest.push_back(number);
      }
      if (wrong.size() - rest.size() < fewest_of_each || rest.empty()) continue;
      LawOfNumbers changed = law;
      changed.right[one.place] = first->values.front();
      for (FittedNumbers& second : singles(changed, changes, rest, place)) {
        if (!second.is_plausible) continue;
        second.count = 2;
        second.text = first->text + ", and " + second.text;
        return {std::move(second)};
      }
    }
  return {};
}

// A number with two digits exchanged, and a familiar factor of an input. If all answers are off by
// one factor, these two explain more than an unfamiliar factor does.
std::vector<FittedNumbers> exchanges_with_factors(const LawOfNumbers& law,
                                                  const std::vector<Change>& changes,
                                                  const std::vector<Part::Number>& wrong,
                                                  std::size_t place) {
  std::vector<FittedNumbers> found;
  for (const Change& one : changes)
    for (const double value :
         one.is_input ? std::vector<double>() : with_exchanged_digits(one.right)) {
      LawOfNumbers changed = law;
      changed.right[one.place] = value;
      for (const Change& input : changes) {
        auto second = input.is_input ? fitted(changed, {input}, wrong, place) : std::nullopt;
        if (!second || !second->is_plausible) continue;
        second->count = 2;
        second->text = fmt::format("{} in place of {}, and {}", law.in_words(one.place, value),
                                   one.symbol, second->text);
        found.push_back(std::move(*second));
      }
    }
  return found;
}

// The law with a known mistake beside it, or the mistake's own formula. Empty: this formula has no
// numbers.
std::optional<LawOfNumbers> with_mistake(const catalogue::Function& function,
                                         const LawOfNumbers& law, const Mistake& mistake) {
  if (mistake.instead && !mistake.of_numbers) return std::nullopt;
  LawOfNumbers changed =
      mistake.instead ? LawOfNumbers{mistake.of_numbers, mistake.numbers, {}} : law;
  changed.formula = [formula = std::move(changed.formula), &function, &mistake](
                        const Arguments& arguments, Constants numbers) -> std::optional<Numbers> {
    Question asked{nullptr, &function, arguments};
    if (mistake.applies && !mistake.applies(asked)) return right_numbers(asked);
    if (mistake.before) mistake.before(asked);
    std::optional<Numbers> given = formula(asked.arguments, numbers);
    if (given && mistake.after) mistake.after(asked, *given);
    return given;
  };
  return changed;
}

// One number, or a factor of an input, beside a known mistake, or two numbers of the mistake's own
// formula. Film laws are left out.
std::vector<FittedNumbers> beside_mistakes(const catalogue::Function& function,
                                           const LawOfNumbers& law,
                                           const std::vector<Mistake>& mistakes,
                                           const std::vector<Part::Number>& wrong,
                                           std::size_t place) {
  std::vector<FittedNumbers> found;
  if (function.film_law != nullptr) return found;
  const std::vector<Part::Number> probes{wrong.front(), wrong[wrong.size() / 2], wrong.back()};
  for (const Mistake& mistake : mistakes)
    if (const auto changed = with_mistake(function, law, mistake)) {
      const std::vector<Change> changes = changes_of(function, *changed);
      const auto add = [&](const std::vector<Change>& beside) {
        if (!fitted(*changed, beside, probes, place)) return;
        auto numbers = fitted(*changed, beside, wrong, place);
        if (!numbers || !numbers->is_plausible) return;
        ++numbers->count;
        numbers->text = mistake.text + ", and " + numbers->text;
        found.push_back(std::move(*numbers));
      };
      for (std::size_t i = 0; i < changes.size(); ++i) {
        add({changes[i]});
        for (std::size_t k = 0; k < i && mistake.instead && wrong.size() >= fewest_of_three; ++k)
          if (!changes[i].is_input && !changes[k].is_input) add({changes[k], changes[i]});
      }
    }
  return found;
}

// Three numbers with exchanged digits.
std::vector<FittedNumbers> three_exchanges(const LawOfNumbers& law,
                                           const std::vector<Change>& changes,
                                           const std::vector<Part::Number>& wrong,
                                           std::size_t place) {
  constexpr std::size_t most_numbers = 8;
  std::vector<Change> numbers;
  for (const Change& one : changes)
    if (!one.is_input) numbers.push_back(one);
  std::vector<FittedNumbers> found;
  for (std::size_t i = 0; i < numbers.size() && numbers.size() <= most_numbers; ++i)
    for (std::size_t k = i + 1; k < numbers.size(); ++k)
      for (std::size_t m = k + 1; m < numbers.size(); ++m)
        if (auto three = fitted(law, {numbers[i], numbers[k], numbers[m]}, wrong, place);
            three && three->is_exchange)
          found.push_back(std::move(*three));
  return found;
}

}  // namespace

std::string LawOfNumbers::in_words(std::size_t place, double number) const {
  const auto known = names.find(place);
  const NumberName name = known == names.end() ? NumberName{} : known->second;
  const bool is_right = number == right[place] && !name.right.empty();
  return name.before + (is_right ? name.right : fmt::format("{:.6g}", number));
}

std::optional<LawOfNumbers> law_of_numbers(const catalogue::Function& function) {
  const auto by_terms = [&](std::vector<double> numbers) {
    return law_by_terms(*law_expression(function), std::move(numbers));
  };
  if (function.film_law != nullptr) return by_terms(numbers_of_film(*function.film_law));
  if (function.name == "regime_film")
    return by_terms({128, 0.131, 1.683, 2. / 3, 1.66, 2. / 3, 0.68, 141, 0.375, 0.0387, 8.70, 0.67,
                     0.85, 0.31, 3.42, 0.49, 0.17, 0.68});
  if (function.name == "moes_line")
    return law_by_terms(*law_expression(function), {3, 2.621, 1.287, 1.311}, {7. / 3, -3.5});
  if (function.name == "viscosity_index") return index_law_of_numbers();
  if (function.name == "starvation_ratio")
    return LawOfNumbers{starved_film,
                        {2.7, 4 * std::numbers::sqrt2 / 3, 1.5, 1.25},
                        {{1, {"", "4√2/3"}}, {2, {"", "3/2"}}, {3, {"", "5/4"}}}};
  if (function.name == "summits_from_spectral_moments")
    return LawOfNumbers{summits, {6, 0.375, 0.8968, 4}, {}};
  if (function.name == "load_sharing")
    return LawOfNumbers{shared_load,
                        {0.14, 0.5, 1},
                        {{0, {"the film's exponent ", ""}}, {1, {"q = ", ""}}, {2, {"q = ", ""}}}};
  const auto [formula, right] = formula_of_law(function.name);
  if (formula == nullptr) return std::nullopt;
  return LawOfNumbers{formula, {right.begin(), right.end()}, {}};
}

namespace {

std::vector<FittedNumbers> fitted_to_law(const Part& part, const std::vector<Part::Number>& wrong,
                                         const std::vector<Mistake>& mistakes, bool is_one_factor) {
  const auto law = law_of_numbers(*part.function());
  if (!law) return {};
  const catalogue::Function& function = *part.function();
  // The changes on which wrong answers depend.
  std::vector<Change> changes;
  for (Change& one : changes_of(function, *law)) {
    const ChangedLaw changed{*law, {one}};
    const Eigen::VectorXd step = Eigen::VectorXd::Constant(1, probed);
    const bool matters = std::any_of(wrong.begin(), wrong.end(), [&](const Part::Number& number) {
      const double with = changed.answer(number.of->question, step, part.place);
      return std::abs(with - number.answered->expected->high) > number.answered->allowed;
    });
    if (matters) changes.push_back(std::move(one));
  }
  std::vector<FittedNumbers> found = singles(*law, changes, wrong, part.place);
  const bool is_plausible = std::any_of(found.begin(), found.end(),
                                        [](const FittedNumbers& one) { return one.is_plausible; });
  if (!is_plausible && is_one_factor)
    return exchanges_with_factors(*law, changes, wrong, part.place);
  // Questions that differ in only one of several inputs do not tell two numbers apart.
  const std::size_t least = std::min<std::size_t>(2, function.parameters.size());
  if (is_plausible || wrong.size() < fewest_of_pairs || inputs_that_vary(wrong) < least)
    return found;
  for (std::size_t i = 0; i < changes.size() && changes.size() <= most_in_pairs; ++i)
    for (std::size_t k = i + 1; k < changes.size(); ++k)
      if (!changes[i].is_input || !changes[k].is_input)
        if (auto pair = fitted(*law, {changes[i], changes[k]}, wrong, part.place);
            pair && pair->is_plausible)
          found.push_back(std::move(*pair));
  if (changes.size() > most_in_pairs)
    for (FittedNumbers& pair : one_after_the_other(*law, changes, wrong, part.place))
      found.push_back(std::move(pair));
  for (FittedNumbers& one : beside_mistakes(function, *law, mistakes, wrong, part.place))
    found.push_back(std::move(one));
  if (found.empty() && wrong.size() >= fewest_of_three)
    found = three_exchanges(*law, changes, wrong, part.place);
  return found;
}

}  // namespace

std::vector<FittedNumbers> fitted_numbers(const Part& part, const std::vector<Mistake>& mistakes,
                                          bool is_one_factor) {
  return part.function() == nullptr ? std::vector<FittedNumbers>()
                                    : fitted_to_law(part, wrong_of(part), mistakes, is_one_factor);
}

namespace {

constexpr std::size_t most_screened = 8;

// The law of a part by its terms, if there are enough wrong answers for several changes. Empty:
// they are too few or alike, or the function has several results or no such law.
std::optional<Expression> terms_for_several(const Part& part,
                                            const std::vector<Part::Number>& wrong) {
  if (part.function() == nullptr || part.function()->results.size() > 1 ||
      wrong.size() < fewest_of_three || inputs_that_vary(wrong) == 0)
    return std::nullopt;
  return law_expression(*part.function());
}

// The fit of these changes, if it gives all wrong answers and is plausible. A first fit to few
// answers rules out nearly all changes.
std::optional<FittedNumbers> fitted_plausibly(const LawOfNumbers& law,
                                              const std::vector<Change>& changes,
                                              const std::vector<Part::Number>& wrong,
                                              std::size_t place) {
  if (!fitted(law, changes, far_apart(wrong, most_screened), place)) return std::nullopt;
  auto numbers = fitted(law, changes, wrong, place);
  return numbers && numbers->is_plausible ? std::move(numbers) : std::nullopt;
}

}  // namespace

std::vector<FittedNumbers> two_of_all_numbers(const Part& part) {
  std::vector<FittedNumbers> found;
  const std::vector<Part::Number> wrong = wrong_of(part);
  const auto terms = terms_for_several(part, wrong);
  if (!terms) return found;
  const LawOfNumbers law = law_by_terms(*terms, printed_numbers(*terms));
  const std::vector<Change> changes = changes_of(*part.function(), law);
  for (std::size_t i = 0; i < changes.size() && found.empty(); ++i)
    for (std::size_t k = i + 1; k < changes.size(); ++k)
      if (!changes[i].is_input || !changes[k].is_input)
        if (auto pair = fitted_plausibly(law, {changes[i], changes[k]}, wrong, part.place))
          found.push_back(std::move(*pair));
  return found;
}

std::vector<FittedNumbers> number_beside_cut(const Part& part) {
  const std::vector<Part::Number> wrong = wrong_of(part);
  if (part.function() == nullptr || wrong.size() < fewest_of_three) return {};
  const catalogue::Function& function = *part.function();
  auto law = law_of_numbers(function);
  if (const auto terms = law ? std::nullopt : terms_for_several(part, wrong))
    law = law_by_terms(*terms, numbers_of(*terms));
  if (!law) return {};
  constexpr std::size_t fewest_of_each = 3;
  const auto is_met = [&](const FittedNumbers& by, const Part::Number& one) {
    const double given = by.answer(one.of->question, part.place);
    return std::abs(given - one.answered->got) <= of_answers * std::abs(given);
  };
  std::vector<Change> inputs;
  for (std::size_t i = 0; i < function.parameters.size(); ++i)
    if (const catalogue::Parameter& input = function.parameters[i];
        input.words.empty() && input.range != catalogue::Range::half_order)
      inputs.push_back({symbol_of(input.meaning), i, true, 1});
  // The law with a number in place of its own, and an input that is cut off at this value.
  const auto both_of = [&](const LawOfNumbers& changed, const FittedNumbers& number,
                           const Change& input, double cut, bool is_above) {
    FittedNumbers both{
        2,
        false,
        true,
        {number.values.front(), cut},
        fmt::format("{}, and with {} = {:.6g} wherever it is {}: it is cut off there", number.text,
                    input.symbol, cut, is_above ? "greater" : "less"),
        {}};
    both.answer = [changed, cut, is_above, at = input.place](const Question& asked,
                                                             std::size_t place) {
      Arguments arguments = asked.arguments;
      arguments[at] = is_above ? std::min(arguments[at], cut) : std::max(arguments[at], cut);
      const auto answer = changed.formula(arguments, changed.right);
      return answer ? (*answer)[place] : unsaid;
    };
    return both;
  };
  for (const Change& one : changes_of(function, *law))
    for (const Part::Number& probe : far_apart(wrong, most_screened)) {
      const auto number = one.is_input ? std::nullopt : fitted(*law, {one}, {probe}, part.place);
      if (!number || !number->is_plausible) continue;
      std::vector<Part::Number> rest = wrong;
      std::erase_if(rest, [&](const Part::Number& other) { return is_met(*number, other); });
      if (wrong.size() - rest.size() < fewest_of_each || rest.size() < fewest_of_each) continue;
      LawOfNumbers changed = *law;
      changed.right[one.place] = round_number(number->values.front());
      for (const Change& input : inputs) {
        const double given = rest.front().input(input.place);
        const auto factor = fitted(changed, {input}, {rest.front()}, part.place);
        const double cut = factor ? round_number(factor->values.front() * given) : unsaid;
        if (!factor || !is_of_few_digits(cut)) continue;
        FittedNumbers both = both_of(changed, *number, input, cut, cut < given);
        if (std::all_of(wrong.begin(), wrong.end(),
                        [&](const Part::Number& all) { return is_met(both, all); }))
          return {std::move(both)};
      }
    }
  return {};
}

namespace {

// Three numbers of a law, or two beside a change of it. `left` is the sum of squares of the
// answers' logarithmic errors that stays, if the logarithms are linear in the numbers.
struct Several {
  const LawWithChange* beside;  // null: no change
  std::vector<Eigen::Index> numbers;
  double left;
};

// The slopes of the answers' logarithms: for each number a column of length 1, or 0.
Eigen::MatrixXd slopes_by_numbers(const LawOfNumbers& law, const std::vector<Change>& changes,
                                  const std::vector<Part::Number>& answers, std::size_t place) {
  Eigen::MatrixXd slopes(static_cast<Eigen::Index>(answers.size()),
                         static_cast<Eigen::Index>(law.right.size()));
  for (Eigen::Index k = 0; k < slopes.cols(); ++k) {
    const ChangedLaw changed{law, {changes[static_cast<std::size_t>(k)]}};
    for (Eigen::Index i = 0; i < slopes.rows(); ++i) {
      const Question& asked = answers[static_cast<std::size_t>(i)].of->question;
      slopes(i, k) = std::log(changed.answer(asked, Eigen::VectorXd::Constant(1, probed), place) /
                              changed.answer(asked, Eigen::VectorXd::Zero(1), place));
    }
    const double length = slopes.col(k).norm();
    slopes.col(k) =
        length > 0 ? Eigen::VectorXd(slopes.col(k) / length) : Eigen::VectorXd::Zero(slopes.rows());
  }
  return slopes;
}

// The part of `off`, the square of a vector, that two or three columns of length 1 do not explain.
// `products` are the products of all columns, `along` those with the vector. Infinite if a column
// is 0, or columns are alike within rounding (determinant or pivot below least_apart).
constexpr double least_apart = 1e-9;
double left_beyond(Eigen::Index i, Eigen::Index k, const Eigen::MatrixXd& products,
                   const Eigen::VectorXd& along, double off) {
  const double alike = products(i, k), apart = products(i, i) * products(k, k) - alike * alike;
  if (apart < least_apart) return INFINITY;
  return off -
         (along[i] * along[i] - 2 * alike * along[i] * along[k] + along[k] * along[k]) / apart;
}
double left_beyond(const std::array<Eigen::Index, 3>& columns, const Eigen::MatrixXd& products,
                   const Eigen::VectorXd& along, double off) {
  const Eigen::Matrix3d among = products(columns, columns);
  const Eigen::Vector3d of = along(columns);
  const Eigen::LDLT<Eigen::Matrix3d> solver(among);
  return solver.vectorD().minCoeff() < least_apart ? INFINITY : off - of.dot(solver.solve(of));
}

std::vector<Several> likely_ones(const std::vector<LawWithChange>& changed,
                                 const Eigen::MatrixXd& slopes,
                                 const std::vector<Part::Number>& answers, std::size_t place) {
  constexpr std::size_t most_tried = 40;
  constexpr double most_left = 0.05;  // of the square of what is off
  std::vector<Several> all;
  const Eigen::MatrixXd products = slopes.transpose() * slopes;
  double whole = 0;
  const auto add = [&](const LawWithChange* beside) {
    Eigen::VectorXd off(slopes.rows());
    for (Eigen::Index i = 0; i < off.size(); ++i) {
      const Part::Number& one = answers[static_cast<std::size_t>(i)];
      const double given = beside == nullptr ? one.answered->expected->high
                                             : beside->law.value(beside->law.results[place],
                                                                 one.of->question.arguments);
      off[i] = std::log(one.answered->got / given);
    }
    if (!off.allFinite()) return;
    if (beside == nullptr) whole = off.squaredNorm();
    const Eigen::VectorXd along = slopes.transpose() * off;
    const double square = off.squaredNorm(), most = most_left * whole;
    for (Eigen::Index i = 0; i < slopes.cols(); ++i)
      for (Eigen::Index k = 0; k < i; ++k)
        if (beside != nullptr) {
          const double left = left_beyond(k, i, products, along, square);
          if (left < most) all.push_back({beside, {k, i}, left});
        } else {
          for (Eigen::Index m = 0; m < k; ++m)
            if (const double left = left_beyond({m, k, i}, products, along, square); left < most)
              all.push_back({beside, {m, k, i}, left});
        }
  };
  add(nullptr);
  for (const LawWithChange& one : changed)
    if (whole > 0) add(&one);
  std::sort(all.begin(), all.end(),
            [](const Several& a, const Several& b) { return a.left < b.left; });
  all.resize(std::min(all.size(), most_tried));
  return all;
}

}  // namespace

std::vector<FittedNumbers> three_at_once(const Part& part) {
  const std::vector<Part::Number> wrong = wrong_of(part);
  auto terms = terms_for_several(part, wrong);
  constexpr std::size_t fewest_answers = 12, most_answers = 24;
  if (!terms || wrong.size() < fewest_answers) return {};
  const std::vector<Expression::Place> places = terms->places_of_numbers();
  const LawOfNumbers law = law_by_terms(*terms, numbers_of(*terms));
  const std::vector<Part::Number> some = far_apart(wrong, most_answers);
  const std::vector<LawWithChange> all = laws_with_one_change(part);
  const Eigen::MatrixXd slopes =
      slopes_by_numbers(law, changes_of(*part.function(), law), some, part.place);
  if (!slopes.allFinite()) return {};
  for (const Several& one : likely_ones(all, slopes, some, part.place)) {
    Expression changed = one.beside == nullptr ? *terms : one.beside->law;
    const std::vector<Expression::Place> now = changed.places_of_numbers();
    const LawOfNumbers of = law_by_terms(changed, numbers_of(changed));
    const std::vector<Change> changes = changes_of(*part.function(), of);
    std::vector<Change> chosen;
    for (const Eigen::Index number : one.numbers) {
      const Expression::Place& place = places[static_cast<std::size_t>(number)];
      for (std::size_t i = 0; i < now.size(); ++i)
        if (now[i].node == place.node && now[i].slot == place.slot) chosen.push_back(changes[i]);
    }
    if (chosen.size() < one.numbers.size()) continue;
    if (auto numbers = fitted_plausibly(of, chosen, wrong, part.place)) {
      numbers->count = 3;
      if (one.beside != nullptr) numbers->text = one.beside->text + ", and " + numbers->text;
      return {std::move(*numbers)};
    }
  }
  return {};
}

}  // namespace tribo::conformance
