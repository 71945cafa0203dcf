// SPDX-License-Identifier: Apache-2.0
#include "conformance/misread.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "catalogue/ways_to_ask.hpp"
#include "conformance/expression.hpp"
#include "conformance/insides.hpp"
#include "conformance/law_numbers.hpp"
#include "conformance/variable.hpp"
#include "scene/schema.hpp"

namespace tribo::conformance {
namespace {

constexpr std::size_t fewest_wrong = 3, fewest_cut = 2;  // answers that decide
constexpr double of_change = 1e-4;     // tolerance, relative to the change of the answer
constexpr double one_value = 1e-9;     // relative tolerance of equal values
constexpr double missed = 0.02;        // part of the answers that may be missed
constexpr int digits_of_defaults = 2;  // at most, where one answer decides

// --- Inputs

enum class Kind : std::uint8_t {
  single,      // an input that is a number
  group,       // a number that several inputs make together, as αp: it may be cut off
  each_times,  // the first of several inputs of one unit, which are all multiplied by one number
  each_plus,   // … to which one number is added
  each_size,   // … of which each is taken without its sign
};

constexpr std::string_view dimensionless = "1";  // a function's inputs without a unit

struct Input {
  std::string symbol;
  // Inputs of one unit may be taken for each other. `name` is for a single input of the question.
  std::string_view unit, name;
  std::function<double(const Question&)> get;  // NaN: this question has none
  std::function<void(Question&, double)> set;
  Kind kind = Kind::single;

  double answer_with(Question& asked, double value, std::size_t place) const {
    set(asked, value);
    return right_numbers(asked)[place];
  }
};

void add_groups(const catalogue::Function& function, std::vector<Input>& all) {
  for (const catalogue::Combination& group : function.combinations) {
    const std::size_t place = catalogue::place_in(function.parameters, group.parameter);
    all.push_back({symbol_of(group.meaning),
                   group.unit,
                   {},
                   [&group](const Question& asked) { return group.value(asked.arguments); },
                   [&group, place](Question& asked, double value) {
                     // A group is a power of its input, which may be 0.
                     if (asked.arguments[place] == 0) asked.arguments[place] = 1;
                     const double now = group.value(asked.arguments);
                     catalogue::Arguments twice = asked.arguments;
                     twice[place] *= 2;
                     const double power = std::log2(group.value(twice) / now);
                     asked.arguments[place] *= std::pow(value / now, 1 / power);
                   },
                   Kind::group});
  }
}

// The inputs of one unit together: temperatures, viscosities, moduli.
void add_alike(const catalogue::Function& function, std::vector<Input>& all) {
  const std::size_t singles = all.size();
  for (std::size_t i = 0; i < singles; ++i) {
    std::vector<std::size_t> alike;
    std::vector<std::string> symbols;
    for (std::size_t k = 0; k < singles; ++k)
      if (all[k].unit == all[i].unit) {
        alike.push_back(catalogue::place_in(function.parameters, all[k].name));
        symbols.push_back(all[k].symbol);
      }
    if (all[i].unit.empty() || all[i].unit == dimensionless || alike.size() < 2 ||
        symbols.front() != all[i].symbol)
      continue;
    const auto first = all[i].get;
    const std::string names = fmt::format("each of {}", fmt::join(symbols, ", "));
    all.push_back({names,
                   {},
                   {},
                   first,
                   [alike, first](Question& asked, double value) {
                     const double factor = value / first(asked);
                     for (const std::size_t place : alike) asked.arguments[place] *= factor;
                   },
                   Kind::each_times});
    all.push_back({names,
                   {},
                   {},
                   first,
                   [alike, first](Question& asked, double value) {
                     const double more = value - first(asked);
                     for (const std::size_t place : alike) asked.arguments[place] += more;
                   },
                   Kind::each_plus});
    all.push_back({names,
                   {},
                   {},
                   first,
                   [alike](Question& asked, double) {
                     for (const std::size_t place : alike)
                       asked.arguments[place] = std::abs(asked.arguments[place]);
                   },
                   Kind::each_size});
  }
}

// A number inside of a point, which may be cut off.
Input input_of(const Inside& inside) {
  return {inside.symbol, {}, {}, inside.get, inside.set, Kind::group};
}

bool is_of(const Inside& inside, const Part& part) {
  return static_cast<std::size_t>(inside.place) == part.place;
}

std::vector<Input> inputs_of(const Part& part) {
  const catalogue::Function* const function = part.function();
  std::vector<Input> all;
  if (function == nullptr) {
    for (std::size_t i = 0; i < scene_fields().size(); ++i) {
      const FieldInfo& field = scene_fields()[i];
      if (field.type != FieldType::number && field.type != FieldType::speeds) continue;
      all.push_back({'`' + std::string(field.path) + '`', field.unit, field.path,
                     [i](const Question& asked) {
                       return scene_detail::value_in(*asked.scene, i).value_or(unsaid);
                     },
                     [store = scene_detail::store_of(i)](Question& asked, double value) {
                       store(*asked.scene, value);
                     }});
    }
    for (const Inside& inside : insides_of_points())
      if (is_of(inside, part) &&
          (inside.kind == Inside::Kind::cut_off || inside.kind == Inside::Kind::factor))
        all.push_back(input_of(inside));
    return all;
  }
  for (std::size_t i = 0; i < function->parameters.size(); ++i) {
    const catalogue::Parameter& one = function->parameters[i];
    if (!one.words.empty() || one.range == catalogue::Range::half_order) continue;
    const bool is_ratio = one.range == catalogue::Range::poisson_ratio;
    all.push_back({symbol_of(one.meaning),
                   is_ratio           ? "of Poisson"
                   : one.unit.empty() ? dimensionless
                                      : one.unit,
                   one.name, [i](const Question& asked) { return asked.arguments[i]; },
                   [i](Question& asked, double value) { asked.arguments[i] = value; }});
  }
  add_alike(*function, all);
  add_groups(*function, all);
  return all;
}

// The value of the input with which the right formula gives the answer, nearest to its own value on
// a logarithmic scale. Empty: there is none within a factor of 2e7.
std::optional<double> solved(const Part::Number& number, const Input& input, std::size_t place) {
  Question question = number.of->question;
  const double own = input.get(question), got = number.answered->got;
  if (!std::isfinite(own) || own == 0) return std::nullopt;
  const auto off = [&](double logarithm) {
    return input.answer_with(question, own * std::exp(logarithm), place) - got;
  };
  const double start = off(0);
  if (!std::isfinite(start)) return std::nullopt;
  constexpr double first_step = 0.1, farthest = 17;  // of ln(value/own): a factor of 2e7
  std::array before{0.0, 0.0}, off_before{start, start};
  std::array ended{false, false};
  for (double step = first_step; step < 2 * farthest; step *= 2)
    for (const std::size_t side : {0U, 1U}) {
      if (ended[side]) continue;
      const double at = std::min(step, farthest) * (side == 0 ? 1 : -1), value = off(at);
      if (!std::isfinite(value)) {
        ended[side] = true;
        continue;
      }
      if (value == 0) return own * std::exp(at);
      if ((value < 0) != (off_before[side] < 0)) {
        std::uintmax_t steps = 60;
        const bool is_up = side == 0;
        const auto [low, high] = boost::math::tools::toms748_solve(
            off, is_up ? before[side] : at, is_up ? at : before[side],
            is_up ? off_before[side] : value, is_up ? value : off_before[side],
            boost::math::tools::eps_tolerance<double>(48), steps);
        return own * std::exp((low + high) / 2);
      }
      before[side] = at;
      off_before[side] = value;
    }
  return std::nullopt;
}

// --- Misreadings

constexpr int rank_of_familiar = 1, rank_of_familiar_factor = 4, rank_of_odd = 7;
struct Misreading {
  int rank;  // the simplest reading has the least
  std::string text;
  std::function<double(Question, std::size_t place)> answer;
  std::size_t fewest = fewest_wrong;  // wrong answers that decide
  bool is_default = false;            // another value of an input that is left out
  std::function<void(Question&)> change = {};
};

// The right answer to the question that is changed so.
std::function<double(Question, std::size_t)> answer_after(std::function<void(Question&)> change) {
  return [change = std::move(change)](Question question, std::size_t place) {
    change(question);
    return right_numbers(question)[place];
  };
}

std::optional<std::string> familiar_times(double factor, const std::string& symbol) {
  constexpr double closeness = 1e-5;
  if (std::abs(factor - 1) < closeness) return symbol;
  if (std::abs(factor + 1) < closeness) return "−" + symbol;
  const FamiliarFactor* const familiar = familiar_factor(factor, closeness);
  if (familiar == nullptr) return std::nullopt;
  std::string name = familiar->name;
  if (name.find('/') != std::string::npos) name = '(' + name + ')';
  return factor > 1 ? fmt::format("{} {}", name, symbol) : fmt::format("{}/{}", symbol, name);
}

// Whether one input may be taken for the other: both are single, and have one unit.
bool is_of_unit(const Input& one, const Input& other) {
  return one.kind == Kind::single && other.kind == Kind::single && !one.unit.empty() &&
         one.unit == other.unit;
}

// Whether the question leaves the input out, so that its default holds.
bool is_without(const Input& input, const Question& question) {
  return !input.name.empty() && question.asked != nullptr &&
         is_left_out(question.asked->inputs, input.name);
}

// The number that the case before gives for the input; NaN: it gives none.
double number_before(const Input& input, const Question& question) {
  const nlohmann::json& before = question.asked->before;
  if (before.is_null() || is_left_out(before, input.name)) return unsaid;
  const nlohmann::json& value = before.at(pointer_to(input.name));
  return value.is_number() ? value.get<double>() : unsaid;
}

// Whether the number has at most so many digits, to a relative 1e-6.
bool is_of_digits(double value, int digits) {
  return std::abs(of_digits(value, digits) - value) <= 1e-6 * std::abs(value);
}

// Adds readings of the input that give one wrong answer, which is right with this `value`.
void add_misreadings(const std::vector<Input>& inputs, const Input& input, const Question& asked,
                     double value, std::vector<Misreading>& found) {
  const double own = input.get(asked);
  const auto add = [&](int rank, std::string text, std::function<double(const Question&)> taken,
                       std::size_t fewest = fewest_wrong, bool is_default = false) {
    const auto change = [taken = std::move(taken), &input](Question& question) {
      const double read = taken(question);
      if (std::isfinite(read) && read != input.get(question)) input.set(question, read);
    };
    found.push_back({rank, std::move(text), answer_after(change), fewest, is_default, change});
  };
  const double number = round_number(value), more = round_number(value - own);
  const int rank_of_number = is_of_few_digits(number) ? 3 : rank_of_odd;
  const std::string is_number = fmt::format("{} = {:.6g}", input.symbol, number);
  if (input.kind == Kind::single || input.kind == Kind::each_times) {
    const double factor = value / own;
    const std::string text = times_in_words(factor, input.symbol);
    if (text != input.symbol)  // else the factor is nearly 1
      add(familiar_times(factor, input.symbol) ? rank_of_familiar
          : is_of_few_digits(factor)           ? 5
                                               : 8,
          fmt::format("{} in place of {}", text, input.symbol),
          [factor, &input](const Question& question) { return factor * input.get(question); });
    if (const auto familiar = familiar_times(factor, input.symbol);
        familiar && text != input.symbol && !input.name.empty())
      add(rank_of_familiar + 1,
          fmt::format("{} in place of {} where it is given", *familiar, input.symbol),
          [factor, &input](const Question& question) {
            return (is_without(input, question) ? 1 : factor) * input.get(question);
          });
  }
  if (input.kind == Kind::single || input.kind == Kind::each_plus)
    add(4,
        fmt::format("{} {} {:.6g} in place of {}", input.symbol, more < 0 ? "−" : "+",
                    std::abs(more), input.symbol),
        [more, &input](const Question& question) { return more + input.get(question); });
  if (input.kind == Kind::single || input.kind == Kind::group) {
    // One answer decides where the number has few digits.
    const std::size_t fewest = is_of_digits(value, digits_of_defaults) ? 1
                               : is_of_few_digits(number)              ? fewest_cut
                                                                       : fewest_wrong;
    add(
        rank_of_number, is_number + " wherever it is greater: it is cut off there",
        [number, &input](const Question& question) {
          return std::min(number, input.get(question));
        },
        fewest);
    add(
        rank_of_number, is_number + " wherever it is less: it is cut off there",
        [number, &input](const Question& question) {
          return std::max(number, input.get(question));
        },
        fewest);
  }
  if (input.kind != Kind::single) return;
  const auto before = [&input](const Question& question) {
    return is_without(input, question) ? number_before(input, question) : unsaid;
  };
  if (std::abs(before(asked) - value) <= 1e-5 * std::abs(value))
    add(0, input.symbol + " of the question before where it is left out: it is kept", before, 1,
        true);
  if (is_without(input, asked))
    add(
        1, fmt::format("{} = {:.6g} where it is left out", input.symbol, number),
        [number, &input](const Question& question) {
          return is_without(input, question) ? number : unsaid;
        },
        is_of_digits(value, digits_of_defaults) ? 1 : fewest_cut, true);
  add(rank_of_number, is_number + " always, whatever it is given as",
      [number, &input](const Question& question) {
        return std::isfinite(input.get(question)) ? number : unsaid;
      });
  for (const Input& other : inputs) {
    if (&other == &input || !is_of_unit(other, input)) continue;
    const double ratio = value / other.get(asked);
    if (const auto words = familiar_times(ratio, other.symbol))
      add(*words == other.symbol ? 0 : 2, fmt::format("{} in place of {}", *words, input.symbol),
          [ratio, &other, &input](const Question& question) {
            return std::isfinite(input.get(question)) ? ratio * other.get(question) : unsaid;
          });
  }
}

// Adds two readings for each step: the input is rounded to whole steps, or answers are interpolated
// linearly between whole steps, as in a table that spans the wrong answers.
void add_steps(const Input& input, const std::vector<Part::Number>& wrong,
               std::vector<Misreading>& found) {
  double least = INFINITY, greatest = -INFINITY;
  for (const Part::Number& one : wrong) {
    const double value = input.get(one.of->question);
    if (!std::isfinite(value)) return;
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  constexpr double most_steps = 1e4;  // of a table that somebody makes
  if (!(greatest > least)) return;
  const double decade = std::pow(10, std::floor(std::log10(greatest - least)));
  for (double power = 1; power < most_steps; power *= 10)
    for (const double digit : {5.0, 2.5, 2.0, 1.0}) {
      const double step = digit * decade / power;
      const double from = std::floor(least / step), to = std::ceil(greatest / step);
      const auto add = [&](std::string text, auto between) {
        found.push_back({3, std::move(text),
                         [&input, step, from, to, between](Question question, std::size_t place) {
                           const double at = input.get(question) / step;
                           if (!(at >= from && at <= to)) return right_numbers(question)[place];
                           return between(at, [&](double whole) {
                             return input.answer_with(question, whole * step, place);
                           });
                         }});
      };
      add(fmt::format("{} rounded to steps of {:g} from {:.6g} to {:.6g}", input.symbol, step,
                      from * step, to * step),
          [](double at, auto answer) { return answer(std::nearbyint(at)); });
      add(fmt::format("straight lines between {} = {:.6g}, {:.6g} … {:.6g}, in place of the law",
                      input.symbol, from * step, (from + 1) * step, to * step),
          [](double at, auto answer) {
            const double below = std::floor(at), low = answer(below);
            return below == at ? low : low + (at - below) * (answer(below + 1) - low);
          });
    }
}

// Adds that the input is inverted, has another power, or is without its sign. solved() does not
// search so far from the right value.
void add_forms(const Input& input, std::vector<Misreading>& found) {
  struct InputForm {
    double (*of)(double);
    const char* text;
    bool is_about_one = false;  // of a ratio; one answer decides
  };
  constexpr std::array input_forms{
      InputForm{[](double x) { return 1 / x; }, "1/{}"},
      InputForm{[](double x) { return x * x; }, "{}²"},
      InputForm{[](double x) { return std::sqrt(x); }, "√{}"},
      InputForm{[](double x) { return x * x * x; }, "{}³"},
      InputForm{[](double x) { return std::cbrt(x); }, "∛{}"},
      InputForm{[](double x) { return std::abs(x); }, "|{}|"},
      InputForm{[](double x) { return -x; }, "−{}"},
      InputForm{[](double x) { return std::max(x, 0.0); }, "max({}, 0)"},
      InputForm{[](double x) { return std::max(x, 1 / x); }, "the greater of {0} and 1/{0}", true},
      InputForm{[](double x) { return std::min(x, 1 / x); }, "the less of {0} and 1/{0}", true}};
  for (const auto& [of, text, is_about_one] : input_forms) {
    if (is_about_one && input.unit != dimensionless) continue;
    const auto change = [&input, form = of](Question& question) {
      const double own = input.get(question), read = form(own);
      if (std::isfinite(read) && read != own) input.set(question, read);
    };
    found.push_back({2,
                     fmt::format("{} in place of {}", fmt::format(fmt::runtime(text), input.symbol),
                                 input.symbol),
                     answer_after(change), is_about_one ? 1 : fewest_wrong, false, change});
  }
}

// Adds that a power of the input, times a number, stands in its place, from two answers.
void add_power(const Input& input, const Part::Number& one, const Part::Number& other,
               std::size_t place, std::vector<Misreading>& found) {
  const double x = input.get(one.of->question), y = input.get(other.of->question);
  if (!(x > 0 && y > 0) || x == y) return;
  const auto at_x = solved(one, input, place), at_y = solved(other, input, place);
  if (!at_x || !at_y) return;
  const double power = round_number(std::log(*at_y / *at_x) / std::log(y / x));
  const double factor = round_number(*at_x / std::pow(x, power));
  if (!is_of_few_digits(power) || !is_of_digits(factor, 5) || power == 0 || power == 1) return;
  const auto change = [&input, power, factor](Question& question) {
    input.set(question, factor * std::pow(input.get(question), power));
  };
  found.push_back(
      {3,
       fmt::format("{}{}^{:.6g} in place of {}", factor == 1 ? "" : fmt::format("{:.6g} ", factor),
                   input.symbol, power, input.symbol),
       answer_after(change), fewest_wrong, false, change});
}

// Adds the readings of each input, solved for at the answers with the least and the greatest ratio
// to the right one, which determine the value best, and at a third one.
void add_misreadings_of(const std::vector<Input>& inputs, const std::vector<Part::Number>& wrong,
                        std::size_t place, std::vector<Misreading>& found) {
  const auto off = [](const Part::Number& one) {
    return one.answered->got / one.answered->expected->high;
  };
  const auto [least, greatest] = std::minmax_element(
      wrong.begin(), wrong.end(), [&](const auto& a, const auto& b) { return off(a) < off(b); });
  for (const Input& input : inputs) {
    if (input.kind == Kind::single) add_power(input, *least, *greatest, place, found);
    if (input.kind == Kind::each_size) {
      const auto change = [&input](Question& question) { input.set(question, 0); };
      found.push_back({2, "the size of " + input.symbol + ", without its sign",
                       answer_after(change), fewest_wrong, false, change});
      continue;
    }
    if (input.kind == Kind::single) add_steps(input, wrong, found);
    for (const auto& from : {least, greatest, wrong.begin() + std::ssize(wrong) / 2})
      if (const auto value = solved(*from, input, place))
        add_misreadings(inputs, input, from->of->question, *value, found);
    if (input.kind == Kind::single) add_forms(input, found);
    // Added without solving, because the answers may hardly depend on the input there.
    for (const Input& other : inputs)
      if (&other != &input && input.kind == Kind::single && is_of_unit(other, input))
        found.push_back({0, fmt::format("{} in place of {}", other.symbol, input.symbol),
                         [&input, &other](Question question, std::size_t of) {
                           return std::isfinite(input.get(question))
                                      ? input.answer_with(question, other.get(question), of)
                                      : right_numbers(question)[of];
                         }});
  }
}

// Does the misreading give all wrong answers, and leave the right ones right? A few of the right
// ones may become wrong, near a border.
bool gives(const Misreading& one, const Part& part) {
  std::size_t met = 0, off = 0, changed = 0;
  const auto most = static_cast<std::size_t>(missed * static_cast<double>(part.all.size()));
  for (const Part::Number& number : part.all) {
    const AnsweredNumber& answered = *number.answered;
    if (answered.is_explained) continue;
    const double given = one.answer(number.of->question, part.place);
    const double change = std::abs(given - answered.expected->high);
    const double allowed =
        std::max(answered.allowed_of(given), of_change * std::min(change, std::abs(given)));
    if (!std::isfinite(given) || std::abs(answered.got - given) > allowed) {
      if (++off > most || answered.is_wrong) return false;
      continue;
    }
    met += answered.is_wrong ? 1 : 0;
    changed += change > answered.allowed ? 1 : 0;
  }
  return met >= one.fewest && changed >= met;
}

// Whether the wrong answers are off by different factors. Any input can have one common factor.
bool vary(const Part& part) {
  double least = INFINITY, greatest = -INFINITY;
  for (const AnsweredNumber* const one : part.wrong) {
    const double ratio = one->got / one->expected->high;
    if (!std::isfinite(ratio)) return part.wrong.size() > 1;  // the right answer is 0
    least = std::min(least, ratio);
    greatest = std::max(greatest, ratio);
  }
  return greatest - least > 1e-5 * std::max(std::abs(least), std::abs(greatest));
}

bool is_same(double a, double b) { return std::abs(a - b) <= one_value * std::abs(b); }

bool all_of(const std::vector<Part::Number>& numbers,
            const std::function<bool(const Part::Number&)>& holds) {
  return std::all_of(numbers.begin(), numbers.end(), holds);
}

}  // namespace

double of_digits(double value, int digits) {
  return std::strtod(fmt::format("{:.{}e}", value, digits - 1).c_str(), nullptr);
}

double round_number(double value) {
  for (int digits = 1; digits <= 6; ++digits) {
    const double rounded = of_digits(value, digits);
    if (std::abs(rounded - value) <= 1e-6 * std::abs(value)) return rounded;
  }
  return value;
}

bool is_of_few_digits(double value) { return is_of_digits(value, 4); }

const FamiliarFactor* familiar_factor(double factor, double closeness) {
  static constexpr std::array factors{
      FamiliarFactor{2, "2"},
      FamiliarFactor{3.141592653589793, "π"},
      FamiliarFactor{1.4142135623730951, "√2"},
      FamiliarFactor{1.7320508075688772, "√3"},
      FamiliarFactor{3, "3", ", as a 3 that is lost, or √3 and 1/√3 exchanged"},
      FamiliarFactor{4, "4", ", as a 4 that is lost, or 2 and 1/2 exchanged"},
      FamiliarFactor{8, "8"},
      FamiliarFactor{1.5, "3/2"},
      FamiliarFactor{1.3333333333333333, "4/3", ", as a 4/3 that is lost, or 2 and 3/2 exchanged"},
      FamiliarFactor{2.5066282746310002, "√(2π)"},
      FamiliarFactor{1.772453850905516, "√π"},
      FamiliarFactor{6.283185307179586, "2π"},
      FamiliarFactor{12.566370614359172, "4π"},
      FamiliarFactor{1.2732395447351628, "4/π"},
      FamiliarFactor{100, "100", ", as with percent"},
      FamiliarFactor{1e3, "1000", ", as between m and mm, or Pa and kPa"},
      FamiliarFactor{1e6, "10⁶", ", as between m and µm, or Pa and MPa"},
      FamiliarFactor{1e9, "10⁹", ", as between m and nm, or Pa and GPa"}};
  const auto* const found = std::find_if(factors.begin(), factors.end(), [&](const auto& one) {
    return std::abs(factor / one.value - 1) < closeness ||
           std::abs(factor * one.value - 1) < closeness;
  });
  return found == factors.end() ? nullptr : found;
}

bool is_familiar(double factor) { return familiar_times(factor, {}).has_value(); }

std::string times_in_words(double factor, const std::string& symbol) {
  return familiar_times(factor, symbol).value_or(fmt::format("{:.6g} {}", factor, symbol));
}

std::string other_default(const Part& part) {
  const std::vector<Part::Number> wrong = wrong_of(part);
  if (wrong.empty()) return {};
  const std::vector<Input> inputs = inputs_of(part);
  for (const Input& input : inputs) {
    const bool is_where =
        std::all_of(part.all.begin(), part.all.end(), [&](const Part::Number& one) {
          return one.answered->is_explained ||
                 is_without(input, one.of->question) >= one.answered->is_wrong;
        });
    if (input.name.empty() || !is_where) continue;
    const auto value = solved(wrong.front(), input, part.place);
    std::vector<Misreading> all;
    if (value) add_misreadings(inputs, input, wrong.front().of->question, *value, all);
    for (const Misreading& one : all)
      if (one.is_default && gives(one, part)) return one.text;
  }
  return {};
}

std::optional<Misread> misread_input(const Part& part, const std::vector<Mistake>& mistakes) {
  const std::vector<Part::Number> wrong = wrong_of(part);
  if (wrong.empty()) return std::nullopt;
  // The readings keep the address of their inputs.
  const auto inputs = std::make_shared<const std::vector<Input>>(inputs_of(part));
  std::vector<Misreading> all;
  std::vector<std::string> texts;
  const Misreading* first = nullptr;
  const bool is_one = wrong.size() < fewest_cut, is_one_factor = !is_one && !vary(part);
  const auto add_numbers = [&](std::vector<FittedNumbers> numbers) {
    for (FittedNumbers& one : numbers)
      if (!is_one_factor || one.is_plausible)
        all.push_back({!one.is_plausible ? 7
                       : one.count == 1  ? 2
                                         : 4 + static_cast<int>(one.count),
                       std::move(one.text), std::move(one.answer)});
  };
  const auto add_changes = [&](std::size_t changes) {
    for (ChangedExpression& one : changed_expressions(part, changes, is_one_factor))
      all.push_back(
          {changes == 1 ? 3 : rank_of_odd - 1, std::move(one.text), std::move(one.answer)});
  };
  const auto find_simplest = [&] {
    std::stable_sort(all.begin(), all.end(),
                     [](const Misreading& a, const Misreading& b) { return a.rank < b.rank; });
    // If all wrong answers are one round number, an odd input that gives it is not reported.
    if (is_of_few_digits(wrong.front().answered->got) && floor_or_cap(part))
      std::erase_if(all, [](const Misreading& one) { return one.rank >= rank_of_odd; });
    for (const Misreading& one : all) {
      if (!texts.empty() && (one.rank > first->rank || texts.size() == 3)) break;
      if (std::find(texts.begin(), texts.end(), one.text) != texts.end() || !gives(one, part))
        continue;
      if (first == nullptr) first = &one;
      texts.push_back(one.text);
    }
  };
  if (!is_one) add_numbers(fitted_numbers(part, mistakes, is_one_factor));
  add_misreadings_of(*inputs, wrong, part.place, all);
  // Any input can have one common factor. So only familiar factors of inputs stay, and they come
  // after changes of the law.
  if (is_one_factor) {
    std::erase_if(all, [](const Misreading& one) {
      return one.change && (one.rank > rank_of_familiar || one.is_default);
    });
    for (Misreading& one : all)
      if (one.change) one.rank = rank_of_familiar_factor;
  }
  // Another right value, as of the other axis, is a simpler cause than a changed law.
  const bool is_of_law = !is_one && other_value(part).empty();
  if (is_of_law) add_changes(1);
  find_simplest();
  if (is_of_law && (first == nullptr || first->rank >= rank_of_odd)) {
    first = nullptr;
    texts.clear();
    add_changes(2);
    if (!is_one_factor) add_numbers(two_of_all_numbers(part));
    find_simplest();
    if (!is_one_factor && first == nullptr) {
      add_numbers(number_beside_cut(part));
      find_simplest();
    }
  }
  if (first == nullptr) return std::nullopt;
  return Misread{fmt::format("{}", fmt::join(texts, "; or with ")),
                 [inputs, answer = first->answer](const Question& asked, std::size_t place) {
                   return answer(asked, place);
                 },
                 first->change == nullptr
                     ? std::function<void(Question&)>()
                     : [inputs, change = first->change](Question& asked) { change(asked); }};
}

std::optional<Misread> three_changes(const Part& part) {
  if (wrong_of(part).empty() || !vary(part)) return std::nullopt;
  for (FittedNumbers& one : three_at_once(part))
    if (gives({rank_of_odd, one.text, one.answer}, part))
      return Misread{std::move(one.text), std::move(one.answer), {}};
  return std::nullopt;
}

std::vector<Mistake> solved_insides(const Part& part) {
  struct Solved {
    const Inside* inside;
    double number;                 // a factor, or the number in place of a constant
    std::optional<double> choice;  // the law's place in `inside->choice`; empty: all laws
    std::size_t count = 0;         // of answers
  };
  constexpr std::size_t most_solved = 100, fewest_alike = 2;
  std::vector<Solved> all;
  const auto count_one = [&](const Inside& inside, double number, std::optional<double> choice) {
    const auto is_it = [&](const Solved& one) {
      return one.inside == &inside && one.choice == choice &&
             std::abs(one.number / number - 1) < 1e-5;
    };
    const auto found = std::find_if(all.begin(), all.end(), is_it);
    ++(found != all.end() ? *found : all.emplace_back(Solved{&inside, number, choice})).count;
  };
  const std::vector<Part::Number> wrong = wrong_of(part);
  for (const Inside& inside : insides_of_points()) {
    const bool is_constant = inside.kind == Inside::Kind::constant;
    if (!is_of(inside, part) || !(is_constant || inside.kind == Inside::Kind::factor)) continue;
    for (std::size_t i = 0; i < wrong.size(); i += 1 + wrong.size() / most_solved) {
      const Question& asked = wrong[i].of->question;
      const auto value = solved(wrong[i], input_of(inside), part.place);
      const double number = value ? *value / (is_constant ? 1 : inside.get(asked)) : unsaid;
      // A factor of nearly 1, as of a rounded π, is none.
      if (!(is_of_few_digits(number) || is_familiar(number)) || std::abs(number - 1) < 1e-5)
        continue;
      count_one(inside, round_number(number), std::nullopt);
      if (const auto field = scene_detail::find_field(inside.choice))
        count_one(inside, round_number(number), scene_detail::value_in(*asked.scene, *field));
    }
  }
  std::vector<Mistake> mistakes;
  for (const Solved& one : all) {
    if (one.count < fewest_alike) continue;
    const bool is_constant = one.inside->kind == Inside::Kind::constant;
    const std::string symbol = one.inside->symbol.substr(0, one.inside->symbol.find(" in "));
    const auto field = scene_detail::find_field(one.inside->choice);
    std::string text = in_place_of(
        is_constant ? fmt::format("{:.6g}", one.number) : times_in_words(one.number, symbol),
        one.inside->symbol);
    if (one.choice)
      text += fmt::format(", where `{}` is {}", one.inside->choice,
                          scene_fields()[*field].choices[static_cast<std::size_t>(*one.choice)]);
    mistakes.push_back(mistake_of_inside(text, text, *one.inside, [=](const Question& asked) {
      if (one.choice && scene_detail::value_in(*asked.scene, *field) != one.choice) return unsaid;
      return is_constant ? one.number : one.number * one.inside->get(asked);
    }));
  }
  return mistakes;
}

namespace {

// The number that all wrong answers are, and beyond which no answer is right.
struct End {
  double number;
  bool is_floor;  // else a cap
};
std::optional<End> end_of(const Part& part, const std::vector<Part::Number>& wrong) {
  const double number = wrong.front().answered->got;
  for (const bool is_floor : {true, false}) {
    const auto is_beyond = [&](const Part::Number& one, double least) {
      const double right = one.answered->expected->high;
      return (is_floor ? number - right : right - number) > least;
    };
    if (all_of(wrong,
               [&](const Part::Number& one) {
                 const double got = one.answered->got;
                 return (got == number || is_same(got, number)) && is_beyond(one, 0);
               }) &&
        std::none_of(part.all.begin(), part.all.end(), [&](const Part::Number& one) {
          return !one.answered->is_wrong && is_beyond(one, one.answered->allowed);
        }))
      return End{number, is_floor};
  }
  return std::nullopt;
}

// "All 3 wrong answers are 0: a floor …"
std::string end_in_words(const Part& part, const std::vector<Part::Number>& wrong) {
  const std::optional<End> end = end_of(part, wrong);
  if (!end || part.all.size() < wrong.size() + fewest_wrong ||
      !(wrong.size() > 1 || is_of_digits(end->number, digits_of_defaults)))
    return {};
  return fmt::format("{} {:.7g}: a {}, at which the answer stops changing.",
                     wrong.size() == 1 ? std::string("The wrong answer is")
                                       : fmt::format("All {} wrong answers are", wrong.size()),
                     end->number + 0.0, end->is_floor ? "floor" : "cap");
}

// A sentence if the wrong answers are those of another function that needs no other inputs.
std::string other_function(const catalogue::Function& own, const std::vector<Part::Number>& wrong) {
  for (const catalogue::Function& other : catalogue::functions()) {
    if (&other == &own || other.results.size() > 1) continue;
    std::vector<std::size_t> places;
    for (const catalogue::Parameter& one : other.parameters)
      places.push_back(catalogue::place_in(own.parameters, one.name));
    const bool is_known = std::all_of(places.begin(), places.end(), [&](std::size_t place) {
      return place < own.parameters.size();
    });
    if (is_known && all_of(wrong, [&](const Part::Number& one) {
          Question asked{nullptr, &other};
          for (std::size_t i = 0; i < places.size(); ++i) asked.arguments[i] = one.input(places[i]);
          return std::abs(right_numbers(asked)[0] / one.answered->got - 1) <= 1e-6;
        }))
      return fmt::format("All {} wrong answers are those of {}.", wrong.size(), other.name);
  }
  return {};
}

}  // namespace

std::function<double(double right)> floor_or_cap(const Part& part) {
  const std::optional<End> end = end_of(part, wrong_of(part));
  if (!end) return {};
  return [end = *end](double right) {
    return end.is_floor ? std::max(end.number, right) : std::min(end.number, right);
  };
}

std::string other_value(const Part& part) {
  const std::vector<Part::Number> wrong = wrong_of(part);
  if (std::string end = end_in_words(part, wrong); !end.empty()) return end;
  if (wrong.size() < fewest_cut || !vary(part)) return {};
  const auto got = [](const Part::Number& one) { return one.answered->got; };
  const double first = got(wrong.front());
  if (all_of(wrong, [&](const auto& one) { return is_same(got(one), first); }))
    return fmt::format(
        "All {} wrong answers are {:.7g}: a floor, a cap, a guard or a default gives them.",
        wrong.size(), first + 0.0);
  if (wrong.size() < fewest_wrong) return {};
  for (const Input& input : inputs_of(part)) {
    const auto by = [&](const Part::Number& one) { return got(one) / input.get(one.of->question); };
    const double factor = by(wrong.front());
    if (!std::isfinite(factor) ||
        !all_of(wrong, [&](const auto& one) { return is_same(by(one), factor); }))
      continue;
    const std::string words = times_in_words(factor, input.symbol);
    if (words == input.symbol)
      return fmt::format("All {} wrong answers are {} itself: an early return or a guard gives it.",
                         wrong.size(), words);
    return fmt::format(
        "All {} wrong answers are {}: what {} is multiplied by is cut off, or constant.",
        wrong.size(), words, input.symbol);
  }
  if (part.function() != nullptr)
    if (std::string other = other_function(*part.function(), wrong); !other.empty()) return other;
  std::vector<Numbers> right;
  for (const Part::Number& one : wrong) right.push_back(right_numbers(one.of->question));
  std::vector<ResultName> names = results_of(part.function());
  names.resize(std::min(names.size(), right.front().size()));  // words follow the numbers
  for (std::size_t place = 0; place < names.size(); ++place) {
    if (place == part.place) continue;
    bool is_other = true;
    for (std::size_t i = 0; i < wrong.size() && is_other; ++i)
      is_other = std::isfinite(right[i][place]) &&
                 std::abs(got(wrong[i]) - right[i][place]) <= 1e-6 * std::abs(right[i][place]);
    if (is_other)
      return fmt::format("All {} wrong answers are the right {} of their cases.", wrong.size(),
                         names[place].name);
  }
  return {};
}

}  // namespace tribo::conformance
