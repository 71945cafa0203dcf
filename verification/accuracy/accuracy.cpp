// SPDX-License-Identifier: Apache-2.0
#include "accuracy/accuracy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "accuracy/reference_scene.hpp"
#include "catalogue/catalogue.hpp"
#include "scene/schema.hpp"
#include "tribo/mixed_contact.hpp"

namespace tribo::verification {
namespace {

QuantityResult result_of(std::string quantity, const Contract& contract) {
  QuantityResult result;
  result.quantity = std::move(quantity);
  result.allowed_ulp = contract.ulp;
  result.allowed_ulp_per_condition = contract.ulp_per_condition;
  return result;
}

void judge(QuantityResult& result, const ReferenceRow& row, double got) {
  const double error = row.error_in_ulp(got);
  const double condition = std::max(1.0, row.number("condition"));
  const double bound = std::max(result.allowed_ulp, result.allowed_ulp_per_condition * condition);
  ++result.cases;
  result.worst_ulp = std::max(result.worst_ulp, error);
  result.worst_ulp_per_condition = std::max(result.worst_ulp_per_condition, error / condition);
  if (error / bound <= result.worst_part_of_bound && !result.worst_row.empty()) return;
  result.worst_part_of_bound = error / bound;
  result.worst_row = row.text("id");
}

// The value of a function at the arguments of a row. The columns have the names of the parameters.
// If the function has several results, the column `output` names the result of the row.
double value_at(const catalogue::Function& function, const ReferenceRow& row) {
  catalogue::Arguments arguments{};
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const catalogue::Parameter& parameter = function.parameters[i];
    arguments[i] = parameter.words.empty() ? row.number(parameter.name)
                                           : place_of(row.text(parameter.name), parameter.words);
  }
  catalogue::Results results{};
  function.value(arguments, results);
  if (function.results.size() == 1) return results[0];
  for (std::size_t i = 0; i < function.results.size(); ++i)
    if (function.results[i].name == row.text("output")) return results[i];
  throw std::runtime_error(fmt::format("unknown output {}", row.text("output")));
}

QuantityResult of_function(const std::string& folder, const catalogue::Function& function) {
  QuantityResult result = result_of(std::string(function.name), function.contract);
  for (const ReferenceRow& row :
       read_reference_table(fmt::format("{}/{}.csv", folder, function.name)))
    judge(result, row, value_at(function, row));
  return result;
}

double onset_constant(const std::string& constant, StarvationClosure closure) {
  const InletLaw<double> law{closure, 3};
  const double r = law.at_film_maximum();
  if (constant == "flooded_over_inlet_at_maximum") return r;
  if (constant == "film_over_inlet_at_maximum") return r * law.film_ratio(r);
  if (constant == "flooded_over_inlet_at_departure_0.05") return law.at_departure(0.05);
  throw std::runtime_error(fmt::format("unknown constant {}", constant));
}

QuantityResult onset_constants(const std::string& folder) {
  QuantityResult result = result_of("onset_constant", starvation_ratio_contract);
  for (const ReferenceRow& row : read_reference_table(folder + "/onset_constant.csv")) {
    const double place = place_of(row.text("closure"), starvation_closure_words);
    const auto closure = static_cast<StarvationClosure>(static_cast<int>(place));
    judge(result, row, onset_constant(row.text("constant"), closure));
  }
  return result;
}

Scene scene_of(const ReferenceRow& row) {
  Scene scene;
  for_each_field(row, [&scene](std::size_t field, double value) {
    scene_detail::store_of(field)(scene, value);
  });
  return scene;
}

std::vector<QuantityResult> operating_points(const std::string& folder) {
  std::vector<QuantityResult> results;
  for (std::size_t k = 0; k < number_count; ++k)
    results.push_back(result_of(fmt::format("operating_point.{}", output_infos[k].name),
                                operating_point_contract));
  for (const ReferenceRow& row : read_reference_table(folder + "/operating_point.csv")) {
    const std::optional<Output> output = output_by_name(row.text("output"));
    if (!output) throw std::runtime_error(fmt::format("unknown output {}", row.text("output")));
    const OperatingPoint<double> point =
        MixedContact<double>(scene_of(row)).solve(row.number("speed"));
    const auto place = static_cast<std::size_t>(*output);
    const double number = numbers_of(point)[place];
    if (row.is_defined()) {
      judge(results[place], row, number);
    } else if (point.regime != Regime::collapsed || !std::isnan(number)) {
      throw std::runtime_error(
          fmt::format("row {} is undefined, the model gives a number", row.text("id")));
    }
  }
  return results;
}

}  // namespace

std::vector<QuantityResult> check_accuracy(const std::string& folder) {
  std::vector<QuantityResult> results;
  for (const catalogue::Function& function : catalogue::functions())
    results.push_back(of_function(folder, function));
  results.push_back(onset_constants(folder));
  for (QuantityResult& result : operating_points(folder)) results.push_back(std::move(result));
  return results;
}

}  // namespace tribo::verification
