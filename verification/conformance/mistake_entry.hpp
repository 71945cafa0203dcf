// SPDX-License-Identifier: Apache-2.0
// The entries of reference/mistakes.toml, and their mistakes in single functions and in operating
// points. For a point, the scene is misread, or one part of the model is wrong.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "conformance/mistake.hpp"

namespace tribo::conformance {

// A change of a number, or of a word: { times = 2 }, { is = "damiens" } …
struct NumberChange {
  double times = 1;
  bool is_inverted = false;
  std::optional<nlohmann::json> is;  // the number or word that is taken in its place
  std::optional<double> value = {};  // `is` as a number; a word by its place in the list
  std::string by, over;              // inputs or results that multiply or divide a result

  double of(double number) const {
    return value ? *value : (is_inverted ? 1 / number : number) * times;
  }
};
using NamedNumbers = std::vector<std::pair<std::string, double>>;
using NumberChanges = std::vector<std::pair<std::string, NumberChange>>;

struct MistakeEntry {
  std::string function;  // or film_laws: all of them that have what the entry changes
  std::string name, text, follows;
  std::vector<std::pair<std::string, std::vector<nlohmann::json>>> where;
  NumberChanges input, result, scene;
  std::string swapped;   // an argument, or a field of a scene
  std::string left_out;  // a field of a scene
  std::string formula;
  std::vector<double> numbers;  // of the formula
  nlohmann::json law;           // the name of a law, or numbers of it
  std::vector<double> area;     // of points and of lines
  std::vector<double> stiffness;
  NamedNumbers sharing, friction;  // numbers of SharingReading and FrictionReading
};

// The member of this name in a list; empty where there is no such name.
template <class Member>
std::optional<Member> member_of(std::span<const std::pair<std::string_view, Member>> members,
                                std::string_view name) {
  for (const auto& [known, member] : members)
    if (known == name) return member;
  return std::nullopt;
}

// Adds numbers of a reading to what a mistake misreads; `members` names them. Throws
// std::runtime_error for another name.
template <class Reading>
void add_reading(const std::string& kind, Reading Question::*reading,
                 std::span<const std::pair<std::string_view, double Reading::*>> members,
                 const std::vector<std::pair<std::string, double>>& numbers, Mistake& mistake) {
  std::vector<std::pair<double Reading::*, double>> changes;
  for (const auto& [name, value] : numbers) {
    const auto member = member_of(members, name);
    if (!member) throw std::runtime_error(kind + ": " + name + " is not allowed");
    changes.emplace_back(*member, value);
    mistake.touches.push_back(kind + ' ' + name);
  }
  mistake.before = [reading, changes, inner = std::move(mistake.before)](Question& question) {
    if (inner) inner(question);
    for (const auto& [member, value] : changes) question.*reading.*member = value;
  };
}

// A wrong formula that entries name, for mistakes that are no change of an argument, of a result or
// of the film's numbers. It gives the results of a function at its arguments, with the numbers of
// the entry. Empty: the formula says nothing of these arguments.
using FunctionFormula = std::optional<Numbers> (*)(const catalogue::Arguments& arguments,
                                                   std::span<const double> numbers);
// Null where the function has no formula of this name that takes this count of `numbers`.
FunctionFormula find_formula(std::string_view function, std::string_view name, std::size_t numbers);

// The formula that is the function's law with these numbers, as its source prints them; null: the
// function has no such formula among those of mistakes.
std::pair<FunctionFormula, std::span<const double>> formula_of_law(std::string_view function);

// The functions of an entry: the one that it names, or for film_laws all film laws with the
// arguments and exponents that it changes. Throws std::runtime_error if there is none.
std::vector<const catalogue::Function*> functions_of(const MistakeEntry& entry);

// The mistakes of an entry: one, or with `swapped` one for each pair of words, or with the law
// `another` one for each other film law. Throws std::runtime_error with what is wrong in the entry.
std::vector<Mistake> mistakes_of(const catalogue::Function& function, const MistakeEntry& entry);

// The entry with the two words in its name and text: "inlet-{given}-for-{asked}".
MistakeEntry with_words(MistakeEntry entry, std::string_view given, std::string_view asked);

// A mistake of the function with the entry's name and text, which changes nothing yet.
Mistake titled(const MistakeEntry& entry, std::string_view function);

// The mistakes of an entry for operating_point: one, or with `swapped` one for each pair of words,
// or with `left_out` one for each word that is no default.
// Throws std::runtime_error that says what is wrong with the entry.
std::vector<Mistake> point_mistakes_of(const MistakeEntry& entry);

// The same mistake in the inlet or the load sharing of an operating point; empty for other
// functions.
std::optional<Mistake> for_points(const Mistake& mistake);

// Multiplies the film formula of a scene by a factor: changes the speed, but keeps the sliding
// speed and the supply as they are.
void scale_film(Scene& scene, double factor);
// Multiplies the nominal area of the contact by a factor, with the film formula left as it is.
void scale_area(Scene& scene, double factor);
// Multiplies the stiffness K of the asperities by a factor, with the real area left as it is.
// Returns the factor that takes the number of summits back to what it was.
double scale_stiffness(Scene& scene, double factor);

// The mistake of several film laws, in the film of an operating point with any of these laws.
Mistake with_film(const std::vector<Mistake>& laws);

// The same for one law, with its wrong exponents of U and G in the load sharing, too.
Mistake with_film_and_sharing(const Mistake& law);

// A wrong function of Hertz in the points with its contact. It changes their area and pressure, and
// the ellipticity in the film.
Mistake with_contact(const Mistake& wrong);

}  // namespace tribo::conformance
