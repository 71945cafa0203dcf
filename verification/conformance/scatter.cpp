// SPDX-License-Identifier: Apache-2.0
#include "conformance/scatter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/statistics/bivariate_statistics.hpp>
#include <boost/math/statistics/univariate_statistics.hpp>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "conformance/expression.hpp"
#include "conformance/misread.hpp"
#include "conformance/variable.hpp"
#include "tribo/load_sharing.hpp"

namespace tribo::conformance {
namespace {

constexpr std::size_t fewest_scattered = 20;
constexpr double small_error = 1e-3;        // relative
constexpr double least_of_each_sign = 0.2;  // share of the errors
constexpr double least_changes = 0.25;      // share of neighbours with opposite signs
constexpr double least_changes_of_lost = 0.05;
constexpr double strong = 0.8;  // correlation of ranks

struct Error {
  double x, relative, absolute;
};

std::vector<double> ranks_in_order(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> ranks(values.size());
  for (std::size_t i = 0; i < order.size(); ++i) ranks[order[i]] = static_cast<double>(i);
  return ranks;
}

// Spearman's rank correlation of the sizes of the errors with the variable.
double correlation(const std::vector<Error>& errors) {
  std::vector<double> x, size;
  for (const Error& one : errors) {
    x.push_back(one.x);
    size.push_back(std::abs(one.relative));
  }
  const std::vector<double> of_x = ranks_in_order(x), of_size = ranks_in_order(size);
  return boost::math::statistics::correlation_coefficient(of_x, of_size);
}

std::size_t changes_of_sign(const std::vector<Error>& errors) {
  std::size_t changes = 0;
  for (std::size_t i = 1; i < errors.size(); ++i)
    changes += (errors[i].relative < 0) != (errors[i - 1].relative < 0) ? 1 : 0;
  return changes;
}

double share_of_changes(const std::vector<Error>& errors) {
  return static_cast<double>(changes_of_sign(errors)) / static_cast<double>(errors.size());
}

// The errors in the order of the variable. `least` = 0: those of wrong answers not explained. Else:
// all that are not explained and above `least`, relative and over the condition. Empty if the
// variable has no value for one of them, or 0 is expected there.
std::vector<Error> errors_along(const Part& part, const Variable& variable, double least = 0) {
  std::vector<Error> errors;
  for (const Part::Number& one : part.all) {
    const Expected& expected = *one.answered->expected;
    if (least == 0 ? !one.answered->is_left()
                   : one.answered->is_explained ||
                         std::abs(one.answered->error()) <=
                             least * expected.condition * std::abs(expected.high))
      continue;
    const double x = variable.value(one.of->asked);
    if (!std::isfinite(x) || one.answered->expected->high == 0) return {};
    const double off = one.answered->error();
    errors.push_back({x, off / one.answered->expected->high, std::abs(off)});
  }
  std::stable_sort(errors.begin(), errors.end(),
                   [](const Error& a, const Error& b) { return a.x < b.x; });
  return errors;
}

bool has_both_signs(const std::vector<Error>& errors) {
  const auto below = std::count_if(errors.begin(), errors.end(),
                                   [](const Error& one) { return one.relative < 0; });
  const double share = static_cast<double>(below) / static_cast<double>(errors.size());
  return share > least_of_each_sign && share < 1 - least_of_each_sign;
}

// The median size of the errors from place `first` to before `last`.
double middle_size(const std::vector<Error>& errors, std::size_t first, std::size_t last,
                   double Error::*of = &Error::relative) {
  std::vector<double> sizes;
  for (std::size_t i = first; i < last; ++i) sizes.push_back(std::abs(errors[i].*of));
  return boost::math::statistics::median(sizes);
}

// Whether the absolute errors keep their size while the right answer, their x, grows.
bool is_of_one_size(const std::vector<Error>& errors) {
  constexpr double of_answer = 30, of_size = 4;
  const std::size_t third = errors.size() / 3, last = errors.size() - third;
  const auto grown = [&](double Error::*of) {
    return middle_size(errors, last, errors.size(), of) / middle_size(errors, 0, third, of);
  };
  const double grows = grown(&Error::absolute);
  return grown(&Error::x) > of_answer && grows < of_size && grows > 1 / of_size;
}

// A sentence if the errors have both signs and one size, whatever the answer is; else empty.
std::string fixed_width(const Part& part) {
  const Variable answer{
      {}, false, [&part](const Question& asked) { return right_numbers(asked)[part.place]; }};
  const std::vector<Error> errors = errors_along(part, answer);
  if (errors.empty() || errors.front().x <= 0 || !has_both_signs(errors) || !is_of_one_size(errors))
    return {};
  double greatest = 0;
  for (const Error& one : errors) greatest = std::max(greatest, one.absolute);
  return fmt::format(
      "The errors are of both signs and of one size, at most {:.2g}, large or small as the answers "
      "are: as of an iteration that stops at a fixed width, or of rounding to a fixed step.",
      greatest);
}

constexpr double of_rounding = 1e-13;  // relative, over the condition
constexpr double nothing = 1e-5, many_times = 1e4, in_order = 0.95;
constexpr double beside = 2e-8;  // of the greatest error: smaller ones are noise
constexpr std::size_t fewest_in_order = 6;
constexpr double least_power_of_numerics = 3;

// The correlation with the falling variable. Equal errors get their ranks in its order.
double correlation_down(std::vector<Error> errors) {
  std::reverse(errors.begin(), errors.end());
  for (Error& one : errors) one.x = -one.x;
  return correlation(errors);
}

// The smaller of the correlations from 1 downwards and upwards; 0: too few errors on one side.
double correlation_from_one(const std::vector<Error>& errors) {
  constexpr std::ptrdiff_t fewest_of_each = 4;
  const auto one =
      std::find_if(errors.begin(), errors.end(), [](const Error& error) { return error.x >= 1; });
  if (errors.front().x <= 0 || one - errors.begin() < fewest_of_each ||
      errors.end() - one < fewest_of_each)
    return 0;
  return std::min(correlation_down({errors.begin(), one}), correlation({one, errors.end()}));
}

// The exponent of the power of the variable, or of its logarithm if `is_of_one`, with which the
// smallest third of the errors grows. Empty: they do not grow as a power.
std::optional<double> first_power(std::vector<Error> errors, bool is_of_one) {
  constexpr double closeness = 0.1, closeness_of_one = 0.5, greatest_power = 12;
  if (errors.front().x <= 0) return std::nullopt;
  std::sort(errors.begin(), errors.end(), [](const Error& a, const Error& b) {
    return std::abs(a.relative) < std::abs(b.relative);
  });
  const auto place = [&](const Error& one) { return is_of_one ? std::log(one.x) : one.x; };
  const Error &first = errors.front(), &last = errors[errors.size() / 3];
  const auto power_to = [&](const Error& one) {
    return std::log(std::abs(one.relative / first.relative)) /
           std::log(std::abs(place(one) / place(first)));
  };
  const double power = power_to(last), between = power_to(errors[errors.size() / 6]);
  if (!(std::abs(power - between) < (is_of_one ? closeness_of_one : closeness) &&
        std::abs(power) < greatest_power))
    return std::nullopt;
  return power;
}

// The numerical method of a function, which may stop too early. Empty: the function's values are
// sums and products of powers.
std::string_view numerics_of(const catalogue::Function& function) {
  if (function.name == "gaussian_moment") return "a quadrature or a series";
  if (function.name == "persson_contact_area") return "a series";
  if (function.name == "hertz_ellipse") return "a series or an iteration";
  if (function.name == "load_sharing" || function.name == "starvation_ratio") return "an iteration";
  const std::optional<Expression> law = law_expression(function);
  const bool is_given =
      law && std::none_of(law->nodes.begin(), law->nodes.end(), [&](const auto& one) {
        const bool is_input =
            std::any_of(function.parameters.begin(), function.parameters.end(),
                        [&](const auto& input) { return symbol_of(input.meaning) == one.name; });
        return one.kind == Expression::Op::given && !is_input && one.name != "π";
      });
  return is_given ? "" : "a quadrature, a series or an iteration";
}

// A sentence if all errors are small beside 1, but not beside small answers; else empty.
std::string approximation_of(const Part& part) {
  constexpr double small_beside_one = 1e-4, times_as_great = 10;
  double greatest = 0, relative = 0, answer = 0;
  for (const Part::Number& one : part.all) {
    const double right = std::abs(one.answered->expected->high);
    greatest = std::max(greatest, std::abs(one.answered->error()));
    if (right > 0) relative = std::max(relative, std::abs(one.answered->error()) / right);
    answer = std::max(answer, right);
  }
  if (!results_of(part.function())[part.place].unit.empty() || answer < 0.5 || answer > 1 ||
      greatest > small_beside_one || !(relative > times_as_great * greatest))
    return {};
  return fmt::format(
      "No error is above {:.2g}, while answers reach {:.3g}; of small answers it is up to {:.2g}: "
      "as of an approximation with few terms, or of a difference of numbers near 1.",
      greatest, answer, relative);
}

constexpr double grain = 1e-9;  // of the range: finer grids are not looked for
constexpr double least_grains = 300, lost_digits = 1e-10;
constexpr double on_grid = 0.01, most_off = 1.01, least_off = 0.05;  // of a step
constexpr std::size_t fewest_on_grid = 8;

// The greatest step of which all differences are multiples; 0: there is none.
double step_of(const std::vector<double>& values) {
  const double least = *std::min_element(values.begin(), values.end());
  const double range = *std::max_element(values.begin(), values.end()) - least;
  const double fine = grain * range;
  double step = 0;
  for (const double one : values) {
    if (one - least <= fine) continue;
    double a = std::max(step, one - least), b = std::min(step, one - least);
    while (b > fine) a = std::exchange(b, std::abs(std::remainder(a, b)));
    if (a < least_grains * fine) return 0;
    step = (one - least) /
           std::nearbyint((one - least) / a);  // without the rounding of the remainders
  }
  if (step == 0) return 0;
  const bool is_grid = std::all_of(values.begin(), values.end(), [&](double one) {
    const double steps = (one - least) / step;
    return std::abs(steps - std::nearbyint(steps)) <= on_grid;
  });
  return is_grid ? step : 0;
}

// ", which is 10/2^15: as of a bisection of a width of 10 that ends after 15 steps"; empty: the
// step is no round width over a power of 2.
std::string halved_width(double step, double range) {
  const int first = std::max(3, static_cast<int>(std::ceil(std::log2(range / step))));
  for (const bool is_any_digit : {false, true})
    for (int halvings = first; halvings < first + 8; ++halvings) {
      const double width = std::ldexp(step, halvings);
      const double rounded = of_digits(width, 1);
      const bool is_power_of_ten = std::abs(std::remainder(std::log10(rounded), 1)) < 1e-9;
      if (std::abs(rounded / width - 1) > 1e-6 || !(is_power_of_ten || is_any_digit)) continue;
      return fmt::format(
          ", which is {:g}/2^{}: as of a bisection of a width of {:g} that ends after "
          "{} steps",
          rounded, halvings, rounded, halvings);
    }
  return {};
}

// A sentence if, with one n, each wrong answer is a whole multiple of w/2^n, where w is 1, an input
// of its question, or 1 over an input. Empty: there is no such n.
std::string halved_bracket(const Part& part, const std::vector<const Part::Number*>& wrong) {
  constexpr int fewest_halvings = 4, most_halvings = 30;
  constexpr std::size_t fewest_of_each = 3;
  constexpr double of_part = 1e-6;
  struct Bracket {
    std::string symbol;
    std::function<double(const Question&)> width;
  };
  std::vector<Bracket> all{{"1", [](const Question&) { return 1.0; }}};
  for (const Variable& one : variables_of(part.function()))
    if (one.is_input)
      for (const bool is_inverse : {false, true})
        all.push_back(
            {(is_inverse ? "1/" : "") + one.symbol, [one, is_inverse](const Question& asked) {
               const double x = one.value(asked);
               return is_inverse ? 1 / x : x;
             }});
  for (int halvings = fewest_halvings; halvings <= most_halvings; ++halvings) {
    std::map<std::string, std::size_t> count;
    std::vector<std::string> symbols;  // met by at least 3 answers: fewer may be chance
    std::size_t odd = 0;
    const bool are_parts = std::all_of(wrong.begin(), wrong.end(), [&](const Part::Number* one) {
      for (const Bracket& bracket : all) {
        const double part_of = std::ldexp(bracket.width(one->of->asked), -halvings);
        const double parts = one->answered->got / part_of;
        if (!(part_of > 0) || std::abs(one->answered->error()) > 2 * part_of ||
            !(std::abs(std::remainder(parts, 1)) <= of_part))
          continue;
        odd += std::abs(std::remainder(parts, 2)) > 0.5;
        if (++count[bracket.symbol] == fewest_of_each) symbols.push_back(bracket.symbol);
        return true;
      }
      return false;
    });
    if (are_parts && odd >= fewest_on_grid && symbols.size() <= 2)
      return fmt::format(
          "All {} wrong answers are whole multiples of 1/2^{} of {}, and at most two such steps "
          "off: "
          "as of a bisection from 0 to there that ends after some {} steps.",
          wrong.size(), halvings, fmt::join(symbols, " or of "), halvings);
  }
  return {};
}

}  // namespace

std::string digits_lost_below_one(const Part& part) {
  constexpr double last_digits = 1e-13, far_below = 1e-6;
  double greatest = 0, answer = 0, wrong = 0;
  for (const Part::Number& one : part.all) {
    const double right = std::abs(one.answered->expected->high);
    answer = std::max(answer, right);
    if (!one.answered->is_left()) continue;
    wrong = std::max(wrong, right);
    greatest = std::max(greatest, std::abs(one.answered->error()));
  }
  if (answer < 0.5 || answer > 1 || wrong > far_below || greatest > last_digits) return {};
  return fmt::format(
      "No error is above {:.2g}, of the last digits of 1, while the right answers are far less: as "
      "of 1 less a number near 1, whose digits cancel.",
      greatest);
}

std::string grid_of(const Part& part) {
  std::vector<const Part::Number*> wrong;
  for (const Part::Number& one : part.all)
    if (one.answered->is_left()) wrong.push_back(&one);
  if (wrong.size() < fewest_on_grid) return {};
  // The answer itself, the answer less an input, or the answer over an input.
  std::vector<Variable> bases{{{}, false, [](const Question&) { return 0.0; }}};
  for (Variable& one : variables_of(part.function()))
    if (one.is_input && part.function() != nullptr) bases.push_back(std::move(one));
  for (const bool is_ratio : {false, true})
    for (const Variable& base : bases) {
      if (is_ratio && base.symbol.empty()) continue;
      std::vector<double> values;
      double off = 0;
      for (const Part::Number* const one : wrong) {
        const double by = base.value(one->of->asked), got = one->answered->got;
        // Next to a far greater input a step has no digits left.
        if (!is_ratio && lost_digits * std::abs(by) > std::abs(one->answered->error())) continue;
        values.push_back(is_ratio ? got / by : got - by);
        off = std::max(off, std::abs(one->answered->error() / (is_ratio ? by : 1)));
      }
      const bool is_enough = values.size() >= fewest_on_grid && 2 * values.size() >= wrong.size();
      if (!is_enough ||
          !std::all_of(values.begin(), values.end(), [](double one) { return std::isfinite(one); }))
        continue;
      const double step = round_number(step_of(values));
      if (step == 0 || off > most_off * step || off < least_off * step) continue;
      const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
      const std::string text = halved_width(step, *greatest - *least);
      if (text.empty() && !is_of_few_digits(step)) continue;
      return fmt::format(
          "{} wrong answers{} are whole steps of {:.4g} from each other, and at most one step "
          "off{}.",
          values.size(),
          base.symbol.empty() ? std::string() : (is_ratio ? " over " : " less ") + base.symbol,
          step, text.empty() ? ": they are rounded" : text);
    }
  return part.function() == nullptr ? std::string() : halved_bracket(part, wrong);
}

Growth growth_of(const Part& part) {
  Growth found;
  if (part.function() == nullptr) return found;
  found.text = approximation_of(part);
  if (!found.text.empty()) return found;
  double best = in_order;
  for (const Variable& variable : variables_of(part.function())) {
    std::vector<Error> errors = errors_along(part, variable, of_rounding);
    double to = 0;
    for (const Error& one : errors) to = std::max(to, std::abs(one.relative));
    std::erase_if(errors, [&](const Error& one) { return std::abs(one.relative) < beside * to; });
    // The greatest errors need not be in order.
    for (Error& one : errors) one.relative = std::clamp(one.relative, -to / 10, to / 10);
    const bool is_size = variable.symbol.starts_with('|');
    if (errors.size() < fewest_in_order || variable.is_result || is_size) continue;
    if (10 * changes_of_sign(errors) > 10 + errors.size() || errors.front().x == errors.back().x)
      continue;
    const double up = correlation(errors), down = correlation_down(errors);
    const bool is_of_one = std::max(up, down) <= in_order;
    const double with = is_of_one ? correlation_from_one(errors) : std::max(up, down);
    double from = to;
    for (const Error& one : errors) from = std::min(from, std::abs(one.relative));
    if (with <= best || from > nothing || to < many_times * from) continue;
    best = with;
    const char* const good = is_of_one ? "values near 1 of" : up > down ? "small" : "large";
    const std::optional<double> power = first_power(errors, is_of_one);
    // The errors of an iteration that ends after some steps may grow as any power.
    const std::string_view numerics = numerics_of(*part.function());
    found.is_numerics = !numerics.empty() && (numerics == "an iteration" || !power ||
                                              std::abs(*power) >= least_power_of_numerics);
    found.cause = fmt::format("{}: numerics along {}", part.function()->name, variable.symbol);
    found.text = fmt::format(
        "The errors are nearly 0 for {} {}, and grow smoothly beyond, from {:.2g} to {:.2g} of the "
        "value{}: as of {}a term that is left out, or is another one, and is small for {} {}.",
        good, variable.symbol, from, to,
        power && !is_of_one ? fmt::format(", at first as its power {:.1f}", *power) : "",
        found.is_numerics ? fmt::format("{} that stops too early, or of ", numerics) : "", good,
        variable.symbol);
  }
  return found;
}

namespace {

// Whether the errors come from lost digits: then the answers at one end of the variable have all
// digits of a double. An iteration that stops too early leaves errors at both ends.
bool are_digits_lost(const Part& part, const Variable& variable) {
  constexpr double all_digits = 1e-11;
  const std::vector<Error> errors = errors_along(part, variable, 1e-300);
  if (errors.size() < fewest_scattered) return true;  // the others are right to the last digit
  const std::size_t third = errors.size() / 3;
  return std::min(middle_size(errors, 0, third),
                  middle_size(errors, errors.size() - third, errors.size())) < all_digits;
}

// The greatest error if there are as many small errors as large ones, in no order along any
// variable; else 0. Errors are relative; with `is_of_one` they are absolute for values below 1.
double greatest_in_no_order(const Part& part, bool is_of_one) {
  double greatest = 0;
  for (const Variable& variable : variables_of(part.function())) {
    std::vector<Error> errors = errors_along(part, variable);
    if (errors.empty() || errors.front().x == errors.back().x) continue;
    std::vector<double> sizes;
    for (Error& one : errors) {
      if (is_of_one) one.relative *= std::min(1.0, one.absolute / std::abs(one.relative));
      sizes.push_back(std::abs(one.relative));
    }
    std::sort(sizes.begin(), sizes.end());
    const std::size_t tenth = errors.size() / 10;
    greatest = sizes.back();
    if (std::abs(correlation(errors)) > 0.5 || sizes[3 * tenth] > 0.5 * greatest ||
        sizes[7 * tenth] < 0.4 * greatest)
      return 0;
  }
  return greatest;
}

// A sentence about substitution in load sharing that stops early, or never: most wrong answers are
// next to λ₀/(1 − A)^e, nearly all others are far from it, and hardly one is between. Else empty.
std::string next_to_fixed_point(const Part& part) {
  // Where an iteration stops by the size of its step, most answers are off by nearly this size. A
  // wrong law is off by what the load of the asperities makes of it, over many decades.
  constexpr double least_middle = 0.4;   // the middle one of those that are near, over the greatest
  constexpr double far = 0.01;           // ten times what is near, small_error
  constexpr std::size_t fewest_far = 3;  // one or two may have another cause
  if (part.function()->name != "load_sharing") return {};
  const double exponent = ratio<double>(hamrock_dowson_central_law.sharing_exponent);
  std::vector<double> near;
  std::size_t are_far = 0;
  for (const Part::Number& one : wrong_of(part)) {
    const LoadSharing<double> sharing(static_cast<AsperityModel>(one.input(0)), one.input(2),
                                      one.input(3));
    const double got = one.answered->got, fluid = std::max(1 - sharing.asperity_share(got), 0.0);
    const double off = std::abs(one.input(1) * std::pow(fluid, -exponent) / got - 1);
    const double error = std::abs(one.answered->error()) / one.answered->expected->high;
    if (off < small_error) near.push_back(off);
    are_far += std::min(off, error) > far ? 1 : 0;
  }
  std::sort(near.begin(), near.end());
  const std::size_t count = part.wrong.size();
  if (are_far < fewest_far || 3 * near.size() < 2 * count ||
      20 * (near.size() + are_far) < 19 * count ||  // at most one of twenty is between
      near[near.size() / 2] < least_middle * near.back())
    return {};
  return fmt::format(
      "{} of {} wrong answers λ are within {:.2g} of λ₀/(1 − A)^e, with the share A at λ, and {} "
      "are far from it: as of an iteration that puts one into the other, stops where λ changes by "
      "no more, and does not converge everywhere.",
      near.size(), count, near.back(), are_far);
}

}  // namespace

std::string ended_early(const Part& part) {
  if (part.function() == nullptr || part.wrong.size() < fewest_scattered ||
      !numerics_of(*part.function()).ends_with("iteration"))
    return {};
  const bool has_unit = !results_of(part.function())[part.place].unit.empty();
  for (const bool is_of_one : {false, true}) {
    if (is_of_one && (has_unit || !fixed_width(part).empty())) continue;
    const double greatest = greatest_in_no_order(part, is_of_one);
    if (greatest == 0 || greatest > small_error) continue;
    return fmt::format(
        "No error is above {:.2g} of the value{}, and they are anything up to that, in no order: "
        "as of an iteration that stops where it changes by no more, or after some steps.",
        greatest, is_of_one ? ", or of 1 where the value is less" : "");
  }
  return next_to_fixed_point(part);
}

std::string scatter_of(const Part& part) {
  if (part.function() == nullptr || part.wrong.size() < fewest_scattered) return {};
  if (std::string fixed = fixed_width(part); !fixed.empty()) return fixed;
  double greatest = 0, best = 0;
  std::string grows;
  for (const Variable& variable : variables_of(part.function())) {
    const std::vector<Error> errors = errors_along(part, variable);
    if (errors.empty() || errors.front().x == errors.back().x) continue;
    const std::size_t third = errors.size() / 3;
    const double low = middle_size(errors, 0, third);
    const double high = middle_size(errors, errors.size() - third, errors.size());
    // If digits cancel until errors exceed the value, most errors may have one sign.
    const bool is_lost = std::max(low, high) > 100 * std::min(low, high) &&
                         share_of_changes(errors) > least_changes_of_lost;
    if (!is_lost && (!has_both_signs(errors) || share_of_changes(errors) < least_changes))
      return {};
    for (const Error& one : errors) greatest = std::max(greatest, std::abs(one.relative));
    const double with = correlation(errors);
    if (std::abs(with) < std::max(strong, best)) continue;
    best = std::abs(with);
    grows = fmt::format(
        "The errors are of both signs and in no order, and grow where {} is {}, from {:.2g} to "
        "{:.2g} of the value: as of {}.",
        variable.symbol, with < 0 ? "small" : "large", std::min(low, high), std::max(low, high),
        are_digits_lost(part, variable)
            ? "digits that cancel, or are rounded away"
            : "an iteration that stops too early, or of rounded numbers");
  }
  if (!grows.empty() || greatest == 0 || greatest > small_error) return grows;
  return fmt::format(
      "The errors are small, at most {:.2g} of the value, of both signs and in no order: as of an "
      "iteration that stops too early, or of rounded numbers.",
      greatest);
}

}  // namespace tribo::conformance
