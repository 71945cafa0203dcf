// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "conformance/mistake_entry.hpp"

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

// 0.61 as 61/100. Throws if the number is above 1000 or has more than six decimals.
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

// The changes that an entry makes to a film law.
struct LawChange {
  std::vector<std::pair<Fraction FilmLaw::*, Fraction>> numbers;
  std::vector<std::pair<int FilmLaw::*, int>> moduli;
  bool is_as_of_points = false;  // F/L in the place of F
  std::vector<std::string> touches;
};

LawChange change_to(const FilmLaw& other) {
  LawChange change;
  for (const auto& [name, number] : law_numbers) {
    change.numbers.emplace_back(number, other.*number);
    change.touches.push_back("law " + std::string(name));
  }
  return change;
}

// Reads the change of a law: the name of another law, or a table of numbers. A number replaces the
// law's own number; { times = -1 } multiplies it.
LawChange law_change(const json& written, const FilmLaw& own) {
  if (written.is_string()) {
    const Function* const other = catalogue::function_named(written.get<std::string>());
    if (other != nullptr && other->film_law != nullptr) return change_to(*other->film_law);
  }
  if (!written.is_object()) throw std::runtime_error("law: a table, another, or a film law's name");
  LawChange change;
  for (const auto& [name, value] : written.items()) {
    const auto number = member_of<Fraction FilmLaw::*>(law_numbers, name);
    const auto modulus = member_of<int FilmLaw::*>(law_moduli, name);
    const json times =
        value.is_object() && value.size() == 1 ? value.value("times", json()) : json();
    if (number && value.is_number())
      change.numbers.emplace_back(*number, fraction_of(value));
    else if (number && times.is_number() && times == std::round(times.get<double>()))
      change.numbers.emplace_back(*number,
                                  Fraction{(own.**number).p * times.get<int>(), (own.**number).q});
    else if (modulus && (value == 1 || value == 2 || value == 4))
      change.moduli.emplace_back(*modulus, value.get<int>());
    else if (name == "is_of_lines" && value == false)
      change.is_as_of_points = true;
    else
      throw std::runtime_error(fmt::format("law: {} is not allowed", name));
    change.touches.push_back("law " + name);
  }
  return change;
}

void add_law(const LawChange& change, Mistake& mistake) {
  mistake.touches.insert(mistake.touches.end(), change.touches.begin(), change.touches.end());
  mistake.before = [inner = std::move(mistake.before), change](Question& question) {
    if (inner) inner(question);
    FilmLaw law = question.law.value_or(*question.function->film_law);
    for (const auto& [member, number] : change.numbers) law.*member = number;
    for (const auto& [member, multiple] : change.moduli) law.*member = multiple;
    law.is_of_lines = law.is_of_lines && !change.is_as_of_points;
    law.sharing_exponent = law.speed_exponent - law.material_exponent;
    law.speed_power = law.speed_exponent;
    law.sharing_power = law.sharing_exponent;
    question.law = law;
  };
}

// One mistake for each other law of the same contacts that takes no more arguments.
std::vector<Mistake> other_laws_of(const Function& function, const MistakeEntry& entry) {
  std::vector<Mistake> all;
  const FilmLaw& own = *function.film_law;
  for (const Function& other : catalogue::functions()) {
    const FilmLaw* const law = other.film_law;
    if (law == nullptr || law == &own || law->is_of_lines != own.is_of_lines ||
        (own.material_exponent.p == 0 && law->material_exponent.p != 0))
      continue;
    all.push_back(titled(with_words(entry, other.name, function.name), function.name));
    add_law(change_to(*law), all.back());
  }
  return all;
}

constexpr std::pair<std::string_view, double SharingReading::*> sharing_numbers[] = {
    {"order", &SharingReading::order},
    {"share_exponent", &SharingReading::share_exponent},
    {"film_exponent", &SharingReading::film_exponent},
    {"offset_times", &SharingReading::offset_times},
    {"fit_constant", &SharingReading::fit_constant},
    {"fit_end", &SharingReading::fit_end},
    {"fit_exponent", &SharingReading::fit_exponent}};

struct ResultChange {
  std::size_t place;
  NumberChange change;
  // Places among the arguments, followed by the results.
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
  std::vector<std::pair<std::size_t, NumberChange>> inputs;  // by place
  for (const auto& [name, written] : entry.input) {
    const std::size_t place = place_of(function.parameters, name);
    NumberChange change = written;
    if (!change.by.empty() || !change.over.empty())
      throw std::runtime_error(name + ": by and over are for results");
    if (change.is) change.value = argument_of(function.parameters[place], *change.is);
    // Factors can be made together, other changes of the same input cannot.
    if (change.is || change.is_inverted) mistake.touches.push_back(name);
    inputs.emplace_back(place, std::move(change));
  }
  if (inputs.empty()) return;
  mistake.before = [inputs](Question& question) {
    for (const auto& [place, change] : inputs)
      question.arguments[place] = change.of(question.arguments[place]);
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
    if (change.is && !change.is->is_number())
      throw std::runtime_error("result." + name + ": is takes a number");
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
  mistake.instead = [formula, numbers = entry.numbers](const Question& question) {
    return formula(question.arguments, numbers);
  };
  if (!entry.numbers.empty()) mistake.of_numbers = formula;
  mistake.numbers = entry.numbers;
  mistake.touches.emplace_back("formula");
}

// One mistake for each pair of words of an argument.
std::vector<Mistake> swaps_of(const Function& function, const MistakeEntry& entry) {
  std::vector<Mistake> all;
  const std::size_t place = place_of(function.parameters, entry.swapped);
  const auto& words = function.parameters[place].words;
  for (std::size_t asked = 0; asked < words.size(); ++asked)
    for (std::size_t given = 0; given < words.size(); ++given) {
      if (asked == given) continue;
      Mistake swap = titled(with_words(entry, words[given], words[asked]), function.name);
      swap.touches = {entry.swapped};
      swap.applies = [place, asked](const Question& question) {
        return question.arguments[place] == static_cast<double>(asked);
      };
      swap.before = [place, given](Question& question) {
        question.arguments[place] = static_cast<double>(given);
      };
      all.push_back(std::move(swap));
    }
  if (words.size() != 2) return all;
  Mistake both = titled(with_words(entry, words[0], words[1]), function.name);
  both.name += "-and-the-reverse";
  both.text += ", and the reverse";
  both.touches = {entry.swapped};
  both.before = [place](Question& question) {
    question.arguments[place] = 1 - question.arguments[place];
  };
  all.push_back(std::move(both));
  return all;
}

}  // namespace

MistakeEntry with_words(MistakeEntry entry, std::string_view given, std::string_view asked) {
  for (std::string* const text : {&entry.name, &entry.text})
    for (const auto& [mark, word] : {std::pair{"{given}", given}, std::pair{"{asked}", asked}})
      if (const std::size_t at = text->find(mark); at != std::string::npos)
        text->replace(at, std::string_view(mark).size(), word);
  return entry;
}

Mistake titled(const MistakeEntry& entry, std::string_view function) {
  return {.function = std::string(function),
          .name = entry.name,
          .text = entry.text,
          .follows = entry.follows,
          .touches = {}};
}

std::vector<const Function*> functions_of(const MistakeEntry& entry) {
  if (entry.function != "film_laws") {
    const Function* const function = catalogue::function_named(entry.function);
    if (function == nullptr) throw std::runtime_error("no function " + entry.function);
    return {function};
  }
  const bool changes_material = entry.law.is_object() && (entry.law.contains("material_modulus") ||
                                                          entry.law.contains("material_exponent"));
  const bool is_for_points = entry.law.is_object() && entry.law.contains("side_leakage");
  const bool is_for_lines = entry.law.is_object() && entry.law.contains("is_of_lines");
  std::vector<const Function*> all;
  for (const Function& one : catalogue::functions()) {
    const auto has = [&](const auto& change) {
      return std::any_of(one.parameters.begin(), one.parameters.end(),
                         [&](const catalogue::Parameter& p) { return p.name == change.first; });
    };
    if (one.film_law != nullptr && std::all_of(entry.input.begin(), entry.input.end(), has) &&
        !(changes_material && one.film_law->material_exponent.p == 0) &&
        !(is_for_points && one.film_law->is_of_lines) &&
        !(is_for_lines && !one.film_law->is_of_lines))
      all.push_back(&one);
  }
  if (all.empty()) throw std::runtime_error("no film law has what is changed");
  return all;
}

std::vector<Mistake> mistakes_of(const Function& function, const MistakeEntry& entry) {
  if (!entry.swapped.empty()) return swaps_of(function, entry);
  Mistake mistake = titled(entry, function.name);
  add_where(function, entry, mistake);
  add_inputs(function, entry, mistake);
  add_results(function, entry, mistake);
  if (!entry.law.is_null()) {
    if (function.film_law == nullptr) throw std::runtime_error("law: only of film laws");
    if (entry.law == "another") return other_laws_of(function, entry);
    add_law(law_change(entry.law, *function.film_law), mistake);
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
