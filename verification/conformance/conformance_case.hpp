// SPDX-License-Identifier: Apache-2.0
// The questions to a solver, and the answers that it should give: the certified values of each
// function of the catalogue and of operating points (reference/exact), and the paper's scenes.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue/catalogue.hpp"
#include "tribo/contract.hpp"

namespace tribo::conformance {

// The right value of one field of an answer: high + low, or a word for regime and inlet.
struct Expected {
  std::string field;
  double high = 0, low = 0;
  double condition = 1;
  std::string word{};
  // Whether a contact on earth can have the inputs (catalogue.hpp), and the value is large enough
  // to matter.
  bool is_physical = true;
  // "gaussian_moment", "hertz_point.radius", "operating_point.film". A function's only field is not
  // named.
  std::string quantity{};
  std::string_view unit{};             // empty: dimensionless
  std::optional<std::size_t> place{};  // index in Numbers (question.hpp); empty: no result
};

// No film or share in engineering is as small as this; moments beyond d = 11 are.
inline constexpr double least_of_engineering = 1e-30;

struct TestCase {
  std::string id;
  std::string function;   // "gaussian_moment", …, or a kind of operating point
  nlohmann::json inputs;  // the members of the question without its id
  Contract contract;      // of the strict tolerance
  std::vector<Expected> expected;
  bool is_extreme;  // beyond what code for engineering is made for
  const catalogue::Function* in_catalogue = nullptr;  // null: an operating point
  // If the case before gives inputs that this one omits: the inputs of that case. Else null.
  nlohmann::json before = nullptr;

  nlohmann::json request() const;  // the inputs with the id
  std::string line() const;        // the request as one line of JSON, without a line end
};

// Operating points of circles with the default film law, of circles with another one, of ellipses
// and of lines are functions of their own, because a solver may offer only some of them.
inline constexpr std::array<std::string_view, 4> operating_point_functions{
    "operating_point", "operating_point_of_other_film", "operating_point_of_ellipse",
    "operating_point_of_line"};
inline bool is_operating_point(std::string_view function) {
  return function.starts_with(operating_point_functions[0]);
}

struct CaseSources {
  std::string exact;      // the folder of certified tables
  std::string published;  // the folder of the paper's scenes and of independent.tsv
};
// The cases of these functions (TestCase::function), or of all if none is named. Throws
// std::runtime_error with one line, for example if there is no such function.
std::vector<TestCase> read_cases(const CaseSources& sources,
                                 const std::vector<std::string>& functions = {});

}  // namespace tribo::conformance
