// SPDX-License-Identifier: Apache-2.0
// The entries of reference/mistakes.toml, before anything is computed.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tribo::conformance {

// A change of a number, or of a word: { times = 2 }, { is = "damiens" } …
struct NumberChange {
  double times = 1;
  bool is_inverted = false;
  std::optional<nlohmann::json> is;  // this number or word
  std::string by, over;              // arguments that a result is multiplied or divided by

  double of(double number) const { return (is_inverted ? 1 / number : number) * times; }
};
using NamedNumbers = std::vector<std::pair<std::string, double>>;
using NumberChanges = std::vector<std::pair<std::string, NumberChange>>;

struct MistakeEntry {
  std::string function;  // or film_laws: all of them that have what the entry changes
  std::string name, text, follows;
  std::vector<std::pair<std::string, std::vector<nlohmann::json>>> where;
  NumberChanges input, result, scene;
  std::string swapped;  // an argument, or a field of a scene
  std::string formula;
  std::vector<double> numbers;  // of the formula
  nlohmann::json law;           // the name of a law, or numbers of it
  std::vector<double> area;     // of points and of lines
  std::vector<double> stiffness;
  NamedNumbers sharing, friction;  // numbers of SharingReading and FrictionReading
};

// An entry of several functions is there for each of them. Throws std::runtime_error with one line:
// the file, the entry's name, what is wrong.
std::vector<MistakeEntry> read_mistake_file(const std::string& path);

}  // namespace tribo::conformance
