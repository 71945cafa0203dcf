// SPDX-License-Identifier: Apache-2.0
#include "functions_json.hpp"

#include "build_info.hpp"
#include "catalogue/ways_to_ask.hpp"

namespace tribo::cli {

using catalogue::Combination;
using catalogue::Function;
using catalogue::Parameter;
using catalogue::WayToAsk;
using nlohmann::ordered_json;

std::vector<std::string_view> names_of(std::span<const Parameter> parameters) {
  std::vector<std::string_view> names;
  for (const Parameter& one : parameters) names.push_back(one.name);
  return names;
}

ordered_json example_of(const Function& function) {
  ordered_json line{{"function", function.name}};
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const Parameter& parameter = function.parameters[i];
    ordered_json& argument = line[std::string(parameter.name)];
    if (parameter.words.empty())
      argument = function.example[i];
    else
      argument = parameter.words[static_cast<std::size_t>(function.example[i])];
  }
  return line;
}

namespace {

ordered_json json_of(const Function& function) {
  ordered_json parameters = ordered_json::array(), results = ordered_json::array();
  for (const Parameter& parameter : function.parameters) {
    ordered_json one{
        {"name", parameter.name}, {"meaning", parameter.meaning}, {"unit", parameter.unit}};
    if (parameter.words.empty()) {
      one["allowed"] = allowed_text(parameter);
      one["physical"] = {parameter.least, parameter.greatest};
    } else {
      one["words"] = parameter.words;
    }
    if (parameter.default_value && parameter.words.empty())
      one["default"] = *parameter.default_value;
    else if (parameter.default_value)
      one["default"] = default_text(parameter);
    parameters.push_back(std::move(one));
  }
  ordered_json combinations = ordered_json::array();
  for (const Combination& one : function.combinations)
    combinations.push_back({{"name", one.name},
                            {"meaning", one.meaning},
                            {"unit", one.unit},
                            {"physical", {one.least, one.greatest}}});
  ordered_json ways = ordered_json::array();
  for (const WayToAsk& way : catalogue::ways_to_ask())
    if (has_way(function, way))
      ways.push_back(
          {{"name", way.name}, {"in_place_of", way.in_place_of}, {"given", names_of(way.given)}});
  for (const catalogue::Result& result : function.results)
    results.push_back({{"name", result.name}, {"meaning", result.meaning}, {"unit", result.unit}});
  return {{"name", function.name},
          {"meaning", function.meaning},
          {"equation", function.equation},
          {"source", function.source},
          {"parameters", parameters},
          {"ways_to_ask", ways},
          {"combinations", combinations},
          {"results", results},
          {"contract",
           {{"ulp", function.contract.ulp},
            {"ulp_per_condition", function.contract.ulp_per_condition}}},
          {"example", example_of(function)}};
}

}  // namespace

ordered_json function_document(const Function& function) {
  return document("function/1", json_of(function));
}

ordered_json functions_document() {
  ordered_json all = ordered_json::array();
  for (const Function& function : catalogue::functions()) all.push_back(json_of(function));
  return document("functions/1", {{"functions", all}});
}

}  // namespace tribo::cli
