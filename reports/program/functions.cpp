// SPDX-License-Identifier: Apache-2.0
// tribocheck functions: lists the functions that `stream` and users' solvers are asked for.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "catalogue/catalogue.hpp"
#include "catalogue/ways_to_ask.hpp"
#include "command.hpp"
#include "functions_json.hpp"
#include "messages.hpp"
#include "protocol/answers.hpp"
#include "scene/schema.hpp"

namespace tribo::cli {
namespace {

using catalogue::Combination;
using catalogue::Function;
using catalogue::Parameter;
using catalogue::WayToAsk;
using nlohmann::ordered_json;

struct FunctionsArguments {
  std::string name;  // empty: all
  std::string format = "text";
};

std::string unit_text(std::string_view unit) { return unit.empty() ? "-" : std::string(unit); }

// The range of a number in contacts on earth: "1e-06 to 100".
std::string range_text(double least, double greatest) {
  return fmt::format("{:g} to {:g}", least, greatest);
}

std::string answer_to(const ordered_json& question) {
  protocol::Text text;
  std::vector<Validity> passed;
  protocol::append_answer(text, question.dump(), 1, passed);
  return {text.data(), text.size()};
}

// "1 ulp", "4 ulp or 8.5 ulp × condition"
std::string contract_text(const Contract& contract) {
  std::string text = fmt::format("{} ulp", contract.ulp);
  if (contract.ulp_per_condition > 0)
    text += fmt::format(" or {} ulp × condition, whichever is more", contract.ulp_per_condition);
  return text;
}

void describe(const Function& function, OutputStream& output) {
  std::string text =
      fmt::format("{}: {}\n  {}\n\n", function.name, function.meaning, function.equation);
  text += "Arguments:\n";
  for (const Parameter& parameter : function.parameters) {
    text += fmt::format("  {:<24}{:<8}{}\n", parameter.name, unit_text(parameter.unit),
                        parameter.meaning);
    text += fmt::format("  {:<24}{:<8}allowed: {}", "", "", allowed_text(parameter));
    if (parameter.default_value) text += fmt::format(" (default: {})", default_text(parameter));
    text += '\n';
    if (parameter.words.empty())
      text += fmt::format("  {:<24}{:<8}of contacts on earth: {}\n", "", "",
                          range_text(parameter.least, parameter.greatest));
  }
  for (const WayToAsk& way : catalogue::ways_to_ask())
    if (has_way(function, way))
      text += fmt::format("  in place of {}: {} (verify: {})\n", fmt::join(way.in_place_of, ", "),
                          fmt::join(names_of(way.given), ", "), way.name);
  if (!function.combinations.empty()) text += "\nCombinations of them, of contacts on earth:\n";
  for (const Combination& one : function.combinations)
    text += fmt::format("  {:<24}{:<8}{}: {}\n", one.name, unit_text(one.unit), one.meaning,
                        range_text(one.least, one.greatest));
  text += "\nResults:\n";
  for (const catalogue::Result& result : function.results)
    text += fmt::format("  {:<24}{:<8}{}\n", result.name, unit_text(result.unit), result.meaning);
  text += fmt::format("\nError of this model: at most {}.\nSource: {}.\n",
                      contract_text(function.contract), function.source);
  const ordered_json example = example_of(function);
  text += fmt::format("\nExample, a line to `tribocheck stream` and its answer:\n  {}\n  {}",
                      example.dump(), answer_to(example));
  append(output.text(), text);
}

void list(OutputStream& output) {
  for (const Function& function : catalogue::functions())
    append(output.text(), fmt::format("{:<31}{}\n", function.name, function.meaning));
}

int unknown(const std::string& name) {
  std::vector<std::string_view> names;
  for (const Function& function : catalogue::functions()) names.push_back(function.name);
  const std::string_view nearest = scene_detail::nearest_choice(name, names);
  std::vector<std::string_view> neighbours;  // functions with the same beginning
  for (const std::string_view one : names)
    if (!name.empty() && one.starts_with(name)) neighbours.push_back(one);
  if (neighbours.empty() && !nearest.empty()) neighbours.push_back(nearest);
  return fail(exit_bad,
              fmt::format("there is no function \"{}\"; {}", printable(name),
                          neighbours.empty()
                              ? std::string("`tribocheck functions` lists all")
                              : fmt::format("did you mean {}?", fmt::join(neighbours, " or "))));
}

int show(const FunctionsArguments& arguments, OutputStream& output) {
  const Function* one = nullptr;
  if (!arguments.name.empty()) {
    one = catalogue::function_named(arguments.name);
    if (one == nullptr) return unknown(arguments.name);
  }
  if (arguments.format == "json") {
    const ordered_json told = one == nullptr ? functions_document() : function_document(*one);
    append(output.text(), told.dump(2) + '\n');
  } else if (one != nullptr) {
    describe(*one, output);
  } else {
    list(output);
  }
  return exit_done;
}

constexpr const char* functions_footer =
    R"(A function is asked by a line of JSON to `tribocheck stream`; `tribocheck verify` holds the model's
answers to certified values, and with --subject those of another solver.

Example:
  tribocheck functions
  tribocheck functions load_sharing
  tribocheck functions --format json | jq -r '.functions[].name')";

}  // namespace

Command add_functions(CLI::App& program) {
  CLI::App* app = program.add_subcommand("functions", "list the functions that can be asked");
  app->footer(functions_footer);
  const auto arguments = std::make_shared<FunctionsArguments>();
  app->add_option("NAME", arguments->name, "all about this one (default: a list of all)");
  app->add_option("--format", arguments->format, "text or json (default: text)")
      ->check(CLI::IsMember({"text", "json"}));
  return {app, [arguments](OutputStream& output) { return show(*arguments, output); }};
}

}  // namespace tribo::cli
