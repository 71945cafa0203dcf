// SPDX-License-Identifier: Apache-2.0
#include "conformance/function_mistakes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "conformance/mistake_formulas.hpp"

namespace tribo::conformance {
namespace {

using catalogue::Function;
using nlohmann::json;

// The place of a parameter or result.
template <class List>
std::size_t place_of(const List& list, const std::string& name) {
  for (std::size_t i = 0; i < list.size(); ++i)
    if (list[i].name == name) return i;
  throw std::runtime_error(fmt::format("the function has no {}", name));
}

// 0.61 as 610000/1000000. The laws' numbers have three decimals at most.
Fraction fraction_of(double number) {
  constexpr int denominator = 1'000'000;
  const double numerator = std::round(number * denominator);
  if (std::abs(numerator) > 1e9 || std::abs(numerator / denominator - number) > 1e-12)
    throw std::runtime_error(
        fmt::format("law: {} is not allowed; allowed: up to 1000, with six decimals", number));
  const int p = static_cast<int>(numerator), common = std::gcd(p, denominator);
  return {p / common, denominator / common};
}

constexpr std::pair<std::string_view, Fraction FilmLaw::*> law_numbers[] = {
    {"constant", &FilmLaw::constant},
    {"speed_exponent", &FilmLaw::speed_exponent},
    {"material_exponent", &FilmLaw::material_exponent},
    {"load_exponent", &FilmLaw::load_exponent},
    {"side_leakage", &FilmLaw::side_leakage},
    {"side_decay", &FilmLaw::side_decay}};
constexpr std::pair<std::string_view, int FilmLaw::*> law_moduli[] = {
    {"speed_modulus", &FilmLaw::speed_modulus},
    {"material_modulus", &FilmLaw::material_modulus},
    {"load_modulus", &FilmLaw::load_modulus},
    {"speed_multiple", &FilmLaw::speed_multiple}};

// Adds what an entry says of the law: another law by name, or numbers of the law that is used.
void add_law(const json& written, Mistake& mistake) {
  std::vector<std::pair<Fraction FilmLaw::*, Fraction>> numbers;
  std::vector<std::pair<int FilmLaw::*, int>> moduli;
  if (written == "hamrock_dowson_minimum") {
    for (const auto& [name, number] : law_numbers) {
      numbers.emplace_back(number, hamrock_dowson_minimum_law.*number);
      mistake.touches.push_back("law " + std::string(name));
    }
  } else if (!written.is_object()) {
    throw std::runtime_error("law: a table, or hamrock_dowson_minimum");
  } else {
    for (const auto& [name, value] : written.items()) {
      const auto number = member_of<Fraction FilmLaw::*>(law_numbers, name);
      const auto modulus = member_of<int FilmLaw::*>(law_moduli, name);
      if (value.is_number() && number)
        numbers.emplace_back(*number, fraction_of(value));
      else if (modulus && (value == 1 || value == 2 || value == 4))
        moduli.emplace_back(*modulus, value.get<int>());
      else
        throw std::runtime_error(fmt::format("law: {} is not allowed", name));
      mistake.touches.push_back("law " + name);
    }
  }
  mistake.before = [inner = std::move(mistake.before), numbers, moduli](Question& question) {
    if (inner) inner(question);
    FilmLaw law = question.law.value_or(hamrock_dowson_central_law);
    for (const auto& [member, number] : numbers) law.*member = number;
    for (const auto& [member, multiple] : moduli) law.*member = multiple;
    // a new row, so that its last members follow from these
    question.law =
        FilmLaw{law.constant,     law.speed_exponent, law.material_exponent, law.load_exponent,
                law.side_leakage, law.side_decay,     law.speed_modulus,     law.material_modulus,
                law.load_modulus, law.speed_multiple};
  };
}

constexpr std::pair<std::string_view, double SharingReading::*> sharing_numbers[] = {
    {"order", &SharingReading::order},
    {"share_exponent", &SharingReading::share_exponent},
    {"film_exponent", &SharingReading::film_exponent},
    {"offset_times", &SharingReading::offset_times},
    {"fit_constant", &SharingReading::fit_constant},
    {"fit_end", &SharingReading::fit_end},
    {"fit_exponent", &SharingReading::fit_exponent}};

struct ArgumentChange {
  std::size_t place;
  NumberChange change;
  std::optional<double> is;
};
struct ResultChange {
  std::size_t place;
  NumberChange change;
  // Places of arguments; those of results follow after them.
  std::optional<std::size_t> by, over;
};
struct Condition {
  std::size_t place;
  std::vector<double> values;
};

void add_where(const Function& function, const MistakeEntry& entry, Mistake& mistake) {
  std::vector<Condition> where;
  for (const auto& [name, values] : entry.where) {
    Condition one{place_of(function.parameters, name), {}};
    for (const json& value : values)
      one.values.push_back(argument_of(function.parameters[one.place], value));
    where.push_back(std::move(one));
  }
  if (where.empty()) return;
  mistake.applies = [where](const Question& question) {
    return std::all_of(where.begin(), where.end(), [&](const Condition& one) {
      return std::find(one.values.begin(), one.values.end(), question.arguments[one.place]) !=
             one.values.end();
    });
  };
}

void add_inputs(const Function& function, const MistakeEntry& entry, Mistake& mistake) {
  std::vector<ArgumentChange> inputs;
  for (const auto& [name, change] : entry.input) {
    ArgumentChange one{place_of(function.parameters, name), change, {}};
    if (!change.by.empty() || !change.over.empty())
      throw std::runtime_error(name + ": by and over are for results");
    if (change.is) one.is = argument_of(function.parameters[one.place], *change.is);
    // Factors can be made together, other changes of the same input cannot.
    if (one.is || change.is_inverted) mistake.touches.push_back(name);
    inputs.push_back(std::move(one));
  }
  if (inputs.empty()) return;
  mistake.before = [inputs](Question& question) {
    for (const ArgumentChange& one : inputs) {
      double& argument = question.arguments[one.place];
      argument = one.is ? *one.is : one.change.of(argument);
    }
  };
}

void add_results(const Function& function, const MistakeEntry& entry, Mistake& mistake) {
  std::vector<ResultChange> results;
  const std::size_t arguments = function.parameters.size();
  const auto factor = [&](const std::string& name) {
    const bool is_result = std::any_of(function.results.begin(), function.results.end(),
                                       [&](const auto& one) { return one.name == name; });
    return is_result ? arguments + place_of(function.results, name)
                     : place_of(function.parameters, name);
  };
  for (const auto& [name, change] : entry.result) {
    ResultChange one{place_of(function.results, name), change, {}, {}};
    if (!change.by.empty()) one.by = factor(change.by);
    if (!change.over.empty()) one.over = factor(change.over);
    if (one.change.is || one.change.is_inverted) mistake.touches.push_back("result " + name);
    results.push_back(std::move(one));
  }
  if (results.empty()) return;
  mistake.after = [results, arguments](const Question& question, Numbers& numbers) {
    const Numbers before = numbers;
    const auto factor_at = [&](std::size_t place) {
      return place < arguments ? question.arguments[place] : before[place - arguments];
    };
    for (const ResultChange& one : results) {
      double& result = numbers[one.place];
      result = one.change.is ? one.change.is->get<double>() : one.change.of(result);
      if (one.by) result *= factor_at(*one.by);
      if (one.over) result /= factor_at(*one.over);
    }
  };
}

void add_formula(const Function& function, const MistakeEntry& entry, Mistake& mistake) {
  const FunctionFormula formula = find_formula(function.name, entry.formula, entry.numbers.size());
  if (formula == nullptr)
    throw std::runtime_error(
        fmt::format("no formula {} of {} numbers", entry.formula, entry.numbers.size()));
  mistake.instead = [formula,
                     numbers = entry.numbers](const Question& question) -> std::optional<Numbers> {
    const std::optional<catalogue::Results> results = formula(question.arguments, numbers);
    if (!results) return std::nullopt;
    return numbers_of(*results);
  };
  mistake.touches.emplace_back("formula");
}

// One for each pair of words of an argument.
std::vector<Mistake> swaps_of(const Function& function, const MistakeEntry& entry) {
  std::vector<Mistake> all;
  const std::size_t place = place_of(function.parameters, entry.swapped);
  const auto& words = function.parameters[place].words;
  for (std::size_t asked = 0; asked < words.size(); ++asked)
    for (std::size_t given = 0; given < words.size(); ++given) {
      if (asked == given) continue;
      Mistake swap{.function = std::string(function.name),
                   .name = with_words(entry.name, words[given], words[asked]),
                   .text = with_words(entry.text, words[given], words[asked]),
                   .touches = {entry.swapped}};
      swap.applies = [place, asked](const Question& question) {
        return question.arguments[place] == static_cast<double>(asked);
      };
      swap.before = [place, given](Question& question) {
        question.arguments[place] = static_cast<double>(given);
      };
      all.push_back(std::move(swap));
    }
  return all;
}

}  // namespace

std::string with_words(std::string text, std::string_view given, std::string_view asked) {
  for (const auto& [mark, word] :
       {std::pair<std::string_view, std::string_view>{"{given}", given}, {"{asked}", asked}})
    if (const std::size_t at = text.find(mark); at != std::string::npos)
      text.replace(at, mark.size(), word);
  return text;
}

std::vector<Mistake> mistakes_of(const Function& function, const MistakeEntry& entry) {
  if (!entry.swapped.empty()) return swaps_of(function, entry);
  Mistake mistake{.function = std::string(function.name),
                  .name = entry.name,
                  .text = entry.text,
                  .follows = entry.follows,
                  .touches = {}};
  add_where(function, entry, mistake);
  add_inputs(function, entry, mistake);
  add_results(function, entry, mistake);
  if (!entry.law.is_null()) {
    if (function.name != "hamrock_dowson_central")
      throw std::runtime_error("law: only of hamrock_dowson_central");
    add_law(entry.law, mistake);
  }
  if (!entry.sharing.empty()) {
    if (function.name != "load_sharing") throw std::runtime_error("sharing: only of load_sharing");
    add_reading<SharingReading>("sharing", &Question::sharing, sharing_numbers, entry.sharing,
                                mistake);
  }
  if (!entry.formula.empty()) add_formula(function, entry, mistake);
  return {std::move(mistake)};
}

}  // namespace tribo::conformance
