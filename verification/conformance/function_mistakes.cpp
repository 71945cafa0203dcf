// SPDX-License-Identifier: Apache-2.0
#include "conformance/function_mistakes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "conformance/mistake_formulas.hpp"
#include "tribo/film_thickness.hpp"

namespace tribo::conformance {
namespace {

using catalogue::Arguments;
using catalogue::Function;
using catalogue::Parameter;
using catalogue::Results;
using nlohmann::json;

// The place of a parameter or result.
template <class List>
std::size_t place_of(const List& list, const std::string& name) {
  for (std::size_t i = 0; i < list.size(); ++i)
    if (list[i].name == name) return i;
  throw std::runtime_error(fmt::format("the function has no {}", name));
}

double argument_of(const Parameter& parameter, const json& written) {
  if (parameter.words.empty() && written.is_number()) return written.get<double>();
  if (!parameter.words.empty() && written.is_string())
    if (const auto place = catalogue::place_of(written.get<std::string>(), parameter))
      return *place;
  throw std::runtime_error(fmt::format("{}: {} is not allowed", parameter.name, written.dump()));
}

// 0.61 as 610000/1000000. The laws' numbers have three decimals at most.
Fraction fraction_of(double number) {
  constexpr int denominator = 1'000'000;
  const double numerator = std::round(number * denominator);
  if (std::abs(numerator) > 1e9 || std::abs(numerator / denominator - number) > 1e-12)
    throw std::runtime_error(
        fmt::format("law: {} is not allowed; allowed: up to 1000, with six decimals", number));
  return {static_cast<int>(numerator), denominator};
}

FilmLaw law_of(const json& written) {
  if (written == "hamrock_dowson_minimum") return hamrock_dowson_minimum_law;
  FilmLaw law = hamrock_dowson_central_law;
  if (!written.is_object()) throw std::runtime_error("law: a table, or hamrock_dowson_minimum");
  const std::pair<const char*, Fraction*> numbers[] = {
      {"constant", &law.constant},
      {"speed_exponent", &law.speed_exponent},
      {"material_exponent", &law.material_exponent},
      {"load_exponent", &law.load_exponent},
      {"side_leakage", &law.side_leakage},
      {"side_decay", &law.side_decay}};
  for (const auto& entry : written.items()) {
    const std::string& name = entry.key();
    const json& value = entry.value();
    const auto* const found = std::find_if(std::begin(numbers), std::end(numbers),
                                           [&](const auto& one) { return one.first == name; });
    if (found == std::end(numbers) || !value.is_number())
      throw std::runtime_error(fmt::format("law: {} is not allowed", name));
    *found->second = fraction_of(value);
  }
  // a new row, so that its last members follow from these
  return {law.constant,      law.speed_exponent, law.material_exponent,
          law.load_exponent, law.side_leakage,   law.side_decay};
}

struct ArgumentChange {
  std::size_t place;
  NumberChange change;
  std::optional<double> is;
};
struct ResultChange {
  std::size_t place;
  NumberChange change;
  std::optional<std::size_t> by, over;  // places of arguments
};
struct Condition {
  std::size_t place;
  std::vector<double> values;
};

// An entry with its names looked up.
struct Wrong {
  const Function* function;
  std::vector<Condition> where;
  std::vector<ArgumentChange> inputs;
  std::vector<ResultChange> results;
  std::optional<FilmLaw> law;
  FunctionFormula formula = nullptr;
  std::vector<double> numbers;

  std::optional<Results> operator()(const Arguments& given) const {
    for (const Condition& one : where)
      if (std::find(one.values.begin(), one.values.end(), given[one.place]) == one.values.end())
        return std::nullopt;
    Arguments a = given;
    for (const ArgumentChange& one : inputs)
      a[one.place] = one.is ? *one.is : one.change.of(a[one.place]);
    Results found{};
    if (formula != nullptr) {
      const std::optional<Results> wrong = formula(a, numbers);
      if (!wrong) return std::nullopt;
      found = *wrong;
    } else if (law) {
      found[0] = film_thickness(*law, a[0], a[1], a[2], a[3], a[4], a[5], a[6]);
    } else {
      function->value(a, found);
    }
    for (const ResultChange& one : results) {
      double& result = found[one.place];
      result = one.change.is ? one.change.is->get<double>() : one.change.of(result);
      if (one.by) result *= given[*one.by];
      if (one.over) result /= given[*one.over];
    }
    return found;
  }
};

Wrong wrong_of(const Function& function, const MistakeEntry& entry) {
  Wrong wrong{&function, {}, {}, {}, {}, nullptr, entry.numbers};
  const auto parameter = [&](const std::string& name) {
    return place_of(function.parameters, name);
  };
  for (const auto& [name, values] : entry.where) {
    Condition one{parameter(name), {}};
    for (const json& value : values)
      one.values.push_back(argument_of(function.parameters[one.place], value));
    wrong.where.push_back(std::move(one));
  }
  for (const auto& [name, change] : entry.input) {
    ArgumentChange one{parameter(name), change, {}};
    if (!change.by.empty() || !change.over.empty())
      throw std::runtime_error(name + ": by and over are for results");
    if (change.is) one.is = argument_of(function.parameters[one.place], *change.is);
    wrong.inputs.push_back(std::move(one));
  }
  for (const auto& [name, change] : entry.result) {
    ResultChange one{place_of(function.results, name), change, {}, {}};
    if (!change.by.empty()) one.by = parameter(change.by);
    if (!change.over.empty()) one.over = parameter(change.over);
    wrong.results.push_back(std::move(one));
  }
  if (!entry.law.is_null()) {
    if (function.name != "hamrock_dowson_central")
      throw std::runtime_error("law: only of hamrock_dowson_central");
    wrong.law = law_of(entry.law);
  }
  if (!entry.formula.empty()) {
    wrong.formula = find_formula(function.name, entry.formula, entry.numbers.size());
    if (wrong.formula == nullptr)
      throw std::runtime_error(
          fmt::format("no formula {} of {} numbers", entry.formula, entry.numbers.size()));
  }
  return wrong;
}

// One for each pair of words of an argument.
std::vector<FunctionMistake> swaps_of(const Function& function, const MistakeEntry& entry) {
  std::vector<FunctionMistake> all;
  const std::size_t place = place_of(function.parameters, entry.swapped);
  const auto& words = function.parameters[place].words;
  for (std::size_t asked = 0; asked < words.size(); ++asked)
    for (std::size_t given = 0; given < words.size(); ++given) {
      if (asked == given) continue;
      Wrong wrong{&function, {{place, {static_cast<double>(asked)}}}, {}, {}, {}, nullptr, {}};
      wrong.inputs.push_back({place, {}, static_cast<double>(given)});
      all.push_back({&function, with_words(entry.name, words[given], words[asked]),
                     with_words(entry.text, words[given], words[asked]), std::move(wrong)});
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

std::vector<FunctionMistake> mistakes_of(const Function& function, const MistakeEntry& entry) {
  if (!entry.swapped.empty()) return swaps_of(function, entry);
  return {{&function, entry.name, entry.text, wrong_of(function, entry)}};
}

Mistake for_cases(const FunctionMistake& mistake) {
  return {std::string(mistake.function->name), mistake.name, mistake.text,
          [mistake](const json& inputs, std::string_view field) -> std::optional<double> {
            const Function& function = *mistake.function;
            Arguments arguments{};
            for (std::size_t i = 0; i < function.parameters.size(); ++i)
              arguments[i] = argument_of(function.parameters[i],
                                         inputs.at(std::string(function.parameters[i].name)));
            const std::optional<Results> results = mistake.results(arguments);
            if (!results) return std::nullopt;
            return (*results)[place_of(function.results, std::string(field))];
          }};
}

}  // namespace tribo::conformance
