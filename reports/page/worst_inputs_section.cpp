// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "page/baselines.hpp"
#include "page/number_text.hpp"
#include "page/verification_sections.hpp"

namespace tribo::report {
namespace {

constexpr const char* file = "stress.json";

std::string output_name(const Json& output) {
  return fmt::format("`{}`", output.at("output").get<std::string>());
}

// Infinity is null in JSON.
std::string worst(const Json& of, const char* key) {
  const Json& value = of.at(key);
  return value.is_null() ? "∞" : rounded(value.get<double>(), 3);
}

std::string input_text(double value) {
  constexpr double longest = 1e6;
  const bool is_short = std::abs(value) < longest && value == std::trunc(value);
  return is_short ? fmt::format("{:.0f}", value) : rounded(value, 5);
}

std::string input_list(const Json& at) {
  std::string text;
  for (const auto& [name, value] : at.at("inputs").items())
    text += fmt::format("{}`{}` {}", text.empty() ? "" : ", ", name,
                        input_text(value.at(0).get<double>()));
  return text;
}

TextTable output_table(const Json& outputs) {
  TextTable table{"Random points through the whole model, double against long double",
                  {"output", "cases", "worst error, ulp", "worst error/condition, ulp",
                   "of the bound", "in balls, ulp", "beyond", "verdict"},
                  {false, true, true, true, true, true, true, false},
                  {},
                  "In balls: the worst error/condition once more, against an enclosure by ball "
                  "arithmetic. Beyond: points outside the contract. Where the condition is large, "
                  "so is the worst error."};
  for (const Json& output : outputs)
    table.rows.push_back({output_name(output), grouped(output.at("cases").get<std::size_t>()),
                          worst(output, "worst_ulp"), worst(output, "worst_ulp_per_condition"),
                          rounded(100 * output.at("worst_part_of_bound").get<double>(), 3) + " %",
                          worst(output.at("in_balls"), "worst_ulp_per_condition"),
                          grouped(output.at("beyond_contract").get<std::size_t>()),
                          output.at("held").get<bool>() ? "held" : "BROKEN"});
  return table;
}

// Nothing where every case was exact.
TextTable input_table(const Json& outputs, const std::string& seed) {
  TextTable table{
      "The worst input of each output",
      {"output", "worst error/condition, ulp", "point", "its inputs"},
      {false, true, true, false},
      {},
      fmt::format("The point follows from seed {} and its index; "
                  "`reference/baselines/{}` has its inputs to the bit. Names of options "
                  "stand as their numbers.",
                  seed, file)};
  for (const Json& output : outputs) {
    const Json& at = output.at("worst_ulp_per_condition_at");
    if (at.is_null()) continue;
    table.rows.push_back({output_name(output), worst(output, "worst_ulp_per_condition"),
                          at.at("index").dump(), input_list(at)});
  }
  return table;
}

Verdict verdict(const Json& baseline) {
  std::size_t held = 0, all = 0;
  double greatest = 0;
  for (const Json& output : baseline.at("outputs")) {
    ++all;
    held += output.at("held").get<bool>() ? 1 : 0;
    greatest = std::max(greatest, output.at("worst_part_of_bound").get<double>());
  }
  return {
      all > 0 && held == all ? Standing::holds : Standing::fails, "Random inputs",
      fmt::format("{} of {} outputs keep their declared accuracy at {} random points; the worst "
                  "error takes {} % of its bound. {}",
                  held, all, grouped(baseline.at("points").get<std::size_t>()),
                  rounded(100 * greatest, 3), measured_when(baseline))};
}

void fill(Section& section, const Json& baseline) {
  const Json& outputs = baseline.at("outputs");
  const std::string seed = baseline.at("seed").dump();
  section.paragraphs = {
      fmt::format("{} random points, seed {}: scenes as they are built and scenes far beyond. {}",
                  grouped(baseline.at("points").get<std::size_t>()), seed, provenance(baseline))};
  section.tables = {output_table(outputs), input_table(outputs, seed)};
  section.verdicts = {verdict(baseline)};
}

}  // namespace

Section worst_inputs_section(const ReportPlaces& places) {
  return from_baseline({"worst-inputs", "Worst inputs"}, places, file, fill);
}

}  // namespace tribo::report
