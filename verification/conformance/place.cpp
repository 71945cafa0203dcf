// SPDX-License-Identifier: Apache-2.0
#include "conformance/place.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "conformance/variable.hpp"
#include "scene/schema.hpp"

namespace tribo::conformance {
namespace {

// "from d = 2 to 5.1"; "at d = 2" where four digits do not tell the ends apart.
std::string stretch_in_words(const std::string& symbol, double low, double high) {
  const std::string first = fmt::format("{:.4g}", low), last = fmt::format("{:.4g}", high);
  return first == last ? fmt::format("at {} = {}", symbol, first)
                       : fmt::format("from {} = {} to {}", symbol, first, last);
}

// The parts that may lie on the wrong side of a border: of all cases, and of the right or the wrong
// ones, whichever are fewer.
constexpr double stray = 0.02, stray_of_few = 0.1;
constexpr std::size_t fewest_right = 3, most_single = 2;
// The greatest chance that the wrong answers meet a condition by accident: if it divides wrong
// answers from right ones, and if right answers are on both sides of it.
constexpr double chance_of_exact = 1e-2, chance_of_needed = 1e-3;
constexpr std::size_t most_conditions = 3, most_alike = 3;

struct Counted {
  const Part::Number* number;
  bool is_wrong;
};
using CountedNumbers = std::vector<Counted>;

CountedNumbers counted(const Part& part) {
  CountedNumbers all;
  for (const Part::Number& one : part.all)
    if (!one.answered->is_explained) all.push_back({&one, one.answered->is_wrong});
  return all;
}

std::size_t count_wrong(const CountedNumbers& numbers) {
  return static_cast<std::size_t>(std::count_if(numbers.begin(), numbers.end(),
                                                [](const Counted& one) { return one.is_wrong; }));
}

bool is_few(std::size_t misplaced, std::size_t all, std::size_t wrong) {
  const std::size_t fewer = std::min(wrong, all - wrong);
  return static_cast<double>(misplaced) <=
         std::min(stray * static_cast<double>(all), stray_of_few * static_cast<double>(fewer));
}

// --- Conditions: a word, a number that is a choice, inputs that are alike

struct Circumstance {
  std::string text;  // "`asperity` is greenwood_tripp"
  std::function<bool(const Question&)> holds;
};

void add_both(std::vector<Circumstance>& all, std::string text, std::string opposite,
              const std::function<bool(const Question&)>& holds) {
  all.push_back({std::move(text), holds});
  all.push_back(
      {std::move(opposite), [holds](const Question& question) { return !holds(question); }});
}

// "modulus" of first_modulus and second_modulus, "radius" of radius_x and radius_y.
std::string common_name(std::string_view name) {
  std::string text(name);
  for (const std::string_view part : {"first_", "second_", "_x", "_y"})
    if (const std::size_t at = text.find(part); at != std::string::npos)
      text.erase(at, part.size());
  return text;
}

std::vector<Circumstance> conditions_of(const catalogue::Function& function) {
  std::vector<Circumstance> all;
  const auto& parameters = function.parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const std::string name(parameters[i].name), symbol = symbol_of(parameters[i].meaning);
    for (std::size_t word = 0; word < parameters[i].words.size(); ++word)
      add_both(all, fmt::format("`{}` is {}", name, parameters[i].words[word]),
               fmt::format("`{}` is not {}", name, parameters[i].words[word]),
               [i, word](const Question& question) {
                 return question.arguments[i] == static_cast<double>(word);
               });
    if (!parameters[i].words.empty() || parameters[i].range == catalogue::Range::half_order)
      continue;
    add_both(all, symbol + " = 0", symbol + " is not 0",
             [i](const Question& question) { return question.arguments[i] == 0; });
    if (parameters[i].unit.empty())
      add_both(all, symbol + " is whole", symbol + " is not whole", [i](const Question& question) {
        return question.arguments[i] == std::floor(question.arguments[i]);
      });
    for (std::size_t k = 0; k < i; ++k) {
      if (common_name(parameters[k].name) != common_name(parameters[i].name)) continue;
      const std::string other = symbol_of(parameters[k].meaning);
      add_both(all, fmt::format("{} = {}", other, symbol),
               fmt::format("{} is not {}", other, symbol), [i, k](const Question& question) {
                 return question.arguments[k] == question.arguments[i];
               });
      add_both(all, fmt::format("{} < {}", symbol, other), fmt::format("{} ≥ {}", symbol, other),
               [i, k](const Question& question) {
                 return question.arguments[i] < question.arguments[k];
               });
      add_both(all, fmt::format("{} > {}", symbol, other), fmt::format("{} ≤ {}", symbol, other),
               [i, k](const Question& question) {
                 return question.arguments[i] > question.arguments[k];
               });
    }
  }
  return all;
}

// Conditions of points: a field has one of its words or whole numbers, or is given at all.
std::vector<Circumstance> conditions_of_points(const CountedNumbers& numbers) {
  std::vector<Circumstance> all;
  for (std::size_t place = 0; place < scene_fields().size(); ++place) {
    const FieldInfo& field = scene_fields()[place];
    if (field.type != FieldType::number && field.type != FieldType::integer &&
        field.type != FieldType::choice)
      continue;
    const auto value_of = [place](const Question& question) {
      return question.scene ? scene_detail::value_in(*question.scene, place) : std::nullopt;
    };
    std::set<double> values;
    bool is_missing = false;
    for (const Counted& one : numbers) {
      const auto value = value_of(one.number->of->asked);
      if (!value)
        is_missing = true;
      else
        values.insert(*value);
    }
    if (is_missing && !values.empty())
      add_both(all, fmt::format("`{}` is given", field.path),
               fmt::format("`{}` is not given", field.path),
               [value_of](const Question& question) { return value_of(question).has_value(); });
    const bool is_choice = field.type == FieldType::choice;
    if (values.size() < 2 || field.type == FieldType::number) continue;
    for (const double value : values) {
      const std::string text = is_choice
                                   ? std::string(field.choices[static_cast<std::size_t>(value)])
                                   : fmt::format("{:.6g}", value);
      add_both(all, fmt::format("`{}` is {}", field.path, text),
               fmt::format("`{}` is not {}", field.path, text),
               [value_of, value](const Question& question) { return value_of(question) == value; });
    }
  }
  return all;
}

struct Split {
  std::size_t wrong_in = 0, right_in = 0, wrong_out = 0, right_out = 0;

  std::size_t in() const { return wrong_in + right_in; }
  std::size_t out() const { return wrong_out + right_out; }
  std::size_t misplaced() const { return right_in + wrong_out; }
};

Split split_by(const CountedNumbers& numbers, const Circumstance& condition) {
  Split split;
  for (const Counted& one : numbers) {
    const bool is_in = condition.holds(one.number->of->asked);
    if (one.is_wrong)
      ++(is_in ? split.wrong_in : split.wrong_out);
    else
      ++(is_in ? split.right_in : split.right_out);
  }
  return split;
}

// The logarithm of the chance that all wrong answers of a split lie inside by accident.
double log_chance(const Split& split) {
  double sum = 0;
  for (std::size_t i = 0; i < split.wrong_in; ++i)
    sum += std::log(static_cast<double>(split.in() - std::min(i, split.in() - 1)) /
                    static_cast<double>(split.in() + split.out() - i));
  return sum;
}

bool is_no_accident(const Split& split, double chance, std::size_t tried) {
  return log_chance(split) <
         std::log(chance / static_cast<double>(std::max<std::size_t>(tried, 1)));
}

struct Found {
  WrongPlace place;
  std::size_t misplaced;
};

// The condition, with up to two others that hold in just the same cases.
std::string texts_alike(const CountedNumbers& numbers, const Circumstance& condition,
                        const std::vector<Circumstance>& conditions) {
  std::vector<std::string> texts{condition.text};
  for (const Circumstance& one : conditions) {
    const bool is_alike = std::all_of(numbers.begin(), numbers.end(), [&](const Counted& number) {
      const Question& asked = number.number->of->asked;
      return one.holds(asked) == condition.holds(asked);
    });
    if (is_alike && one.text != condition.text && texts.size() < most_alike)
      texts.push_back(one.text);
  }
  // "is not greenwood_tripp" says nothing beside "is greenwood_williamson".
  for (const std::string& one : std::vector<std::string>(texts))
    if (const std::size_t end = one.find(" is not "); end != std::string::npos)
      if (std::any_of(texts.begin(), texts.end(), [&](const std::string& other) {
            return other.starts_with(one.substr(0, end + 4)) && other.find("is not") > end + 1;
          }))
        std::erase(texts, one);
  return fmt::format("{}", fmt::join(texts, " or "));
}

std::string exact_text(const Split& split, const std::string& condition) {
  std::string text = split.right_in == 0
                         ? fmt::format("wrong in all {} cases where {}", split.in(), condition)
                         : fmt::format("wrong in {} of the {} cases where {}", split.wrong_in,
                                       split.in(), condition);
  if (split.wrong_out == 0) return text + ", right in all others";
  return text + fmt::format(", and in {} of the {} others", split.wrong_out, split.out());
}

// "wrong in all 68 cases where `friction.viscosity` is roelands, right in all others"
std::optional<Found> exact_condition(const CountedNumbers& numbers,
                                     const std::vector<Circumstance>& conditions) {
  const std::size_t wrong = count_wrong(numbers);
  std::optional<Found> best;
  for (const Circumstance& one : conditions) {
    const Split split = split_by(numbers, one);
    if (!is_few(split.misplaced(), numbers.size(), wrong) || split.wrong_in == 0) continue;
    if (!is_no_accident(split, chance_of_exact, conditions.size()) ||
        (best && best->misplaced <= split.misplaced()))
      continue;
    best = {{exact_text(split, texts_alike(numbers, one, conditions)), one.holds},
            split.misplaced()};
  }
  return best;
}

// "wrong only where `surface.offset_planes` is 2: in 96 of 130 such cases": all wrong answers meet
// one or several conditions, which right answers may meet, too.
std::optional<WrongPlace> needed_conditions(CountedNumbers numbers,
                                            const std::vector<Circumstance>& conditions) {
  const std::size_t wrong = count_wrong(numbers);
  std::vector<const Circumstance*> needed;
  while (needed.size() < most_conditions) {
    const Circumstance* best = nullptr;
    std::size_t most_excluded = 0;
    for (const Circumstance& one : conditions) {
      const Split split = split_by(numbers, one);
      if (split.wrong_out > 0 || split.right_out <= most_excluded) continue;
      if (!is_no_accident(split, chance_of_needed, conditions.size())) continue;
      best = &one;
      most_excluded = split.right_out;
    }
    if (best == nullptr) break;
    needed.push_back(best);
    std::erase_if(numbers, [&](const Counted& one) { return !best->holds(one.number->of->asked); });
  }
  if (needed.empty()) return std::nullopt;
  std::string text;
  std::vector<std::function<bool(const Question&)>> all;
  for (const Circumstance* const one : needed) {
    text += (text.empty() ? "" : " and ") + one->text;
    all.push_back(one->holds);
  }
  return WrongPlace{
      fmt::format("wrong only where {}: in {} of {} such cases", text, wrong, numbers.size()),
      [all](const Question& question) {
        return std::all_of(all.begin(), all.end(),
                           [&](const auto& holds) { return holds(question); });
      }};
}

// "wrong in lt0064, the only case where ν₂ = 0"
WrongPlace single_cases(const CountedNumbers& numbers,
                        const std::vector<Circumstance>& conditions) {
  std::string ids;
  for (const Counted& one : numbers)
    if (one.is_wrong) ids += (ids.empty() ? "" : " and ") + one.number->of->question.asked->id;
  std::string text = "wrong in " + ids;
  const auto found = std::find_if(
      conditions.begin(), conditions.end(),
      [&](const Circumstance& one) { return split_by(numbers, one).misplaced() == 0; });
  if (found == conditions.end()) return {text + " alone", {}};
  return {fmt::format("{}, {} where {}", text,
                      count_wrong(numbers) == 1 ? "the only case" : "the only cases", found->text),
          found->holds};
}

// --- Ranges

struct Sorted {
  double value;
  bool is_wrong;
};

// A stretch [first, last) in which answers are right (or wrong), and the number of cases that do
// not fit. best_stretch() finds the one with the fewest, by the greatest sum of a run.
struct Stretch {
  std::size_t first = 0, last = 0;
  std::size_t misplaced = 0;
};

Stretch best_stretch(const std::vector<Sorted>& points, bool of_wrong) {
  // +1 for a case that belongs inside, −1 for one that does not.
  Stretch best;
  long sum = 0, greatest = 0;
  std::size_t first = 0, belonging = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool belongs = points[i].is_wrong == of_wrong;
    belonging += belongs ? 1 : 0;
    sum += belongs ? 1 : -1;
    if (sum > greatest) {
      greatest = sum;
      best.first = first;
      best.last = i + 1;
    }
    if (sum < 0) {
      sum = 0;
      first = i + 1;
    }
  }
  best.misplaced = belonging - static_cast<std::size_t>(greatest);
  return best;
}

std::optional<Found> range_along(const CountedNumbers& numbers, const Variable& variable) {
  std::vector<Sorted> points;
  for (const Counted& one : numbers) {
    const double value = variable.value(one.number->of->asked);
    if (std::isnan(value)) return std::nullopt;
    points.push_back({value, one.is_wrong});
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const Sorted& a, const Sorted& b) { return a.value < b.value; });
  const Stretch right = best_stretch(points, false), wrong = best_stretch(points, true);
  const bool inside_is_wrong = wrong.misplaced < right.misplaced;
  const Stretch& inside = inside_is_wrong ? wrong : right;
  if (!is_few(inside.misplaced, points.size(), count_wrong(numbers))) return std::nullopt;
  const bool from_start = inside.first == 0, to_end = inside.last == points.size();
  if (from_start && to_end) return std::nullopt;
  const double low = points[inside.first].value, high = points[inside.last - 1].value;
  if (!from_start && !to_end && low == high) return std::nullopt;
  if (!from_start && points[inside.first - 1].value == low) return std::nullopt;
  if (!to_end && points[inside.last].value == high) return std::nullopt;
  const char* const word = inside_is_wrong ? "wrong" : "right";
  const char* const other = inside_is_wrong ? "right" : "wrong";
  const double before = from_start ? -INFINITY : points[inside.first - 1].value;
  const double after = to_end ? INFINITY : points[inside.last].value;
  const std::string& symbol = variable.symbol;
  std::string text;
  if (from_start)
    text = fmt::format("{} up to {} = {:.4g}, {} from {:.4g} on", word, symbol, high, other, after);
  else if (to_end)
    text = fmt::format("{} up to {} = {:.4g}, {} from {:.4g} on", other, symbol, before, word, low);
  else
    text =
        fmt::format("{} {}, {} below and beyond", word, stretch_in_words(symbol, low, high), other);
  // A question between the last right and the first wrong case may be either.
  const auto holds = [value = variable.value, inside_is_wrong, low, high, before,
                      after](const Question& question) {
    const double x = value(question);
    return inside_is_wrong ? x > before && x < after : !(x >= low && x <= high);
  };
  return Found{{std::move(text), holds}, inside.misplaced};
}

std::optional<Found> best_range(const CountedNumbers& numbers,
                                const catalogue::Function* function) {
  std::optional<Found> best;
  for (const Variable& one : variables_of(function)) {
    auto found = range_along(numbers, one);
    if (found && (!best || found->misplaced < best->misplaced)) best = std::move(found);
    if (best && best->misplaced == 0) break;
  }
  return best;
}

}  // namespace

std::optional<WrongPlace> place_of_wrong(const Part& part) {
  const CountedNumbers numbers = counted(part);
  const std::size_t wrong = count_wrong(numbers), right = numbers.size() - wrong;
  if (numbers.size() < fewest_cases || right < fewest_right || wrong == 0) return std::nullopt;
  const catalogue::Function* const function = part.function();
  const std::vector<Circumstance> conditions =
      function != nullptr ? conditions_of(*function) : conditions_of_points(numbers);
  if (wrong <= most_single) return single_cases(numbers, conditions);
  const std::optional<Found> exact = exact_condition(numbers, conditions);
  if (exact && exact->misplaced == 0) return exact->place;
  const std::optional<Found> range = best_range(numbers, function);
  if (range && (!exact || range->misplaced < exact->misplaced)) return range->place;
  if (exact) return exact->place;
  return needed_conditions(numbers, conditions);
}

}  // namespace tribo::conformance
