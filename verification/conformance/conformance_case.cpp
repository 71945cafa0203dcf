// SPDX-License-Identifier: Apache-2.0
#include "conformance/conformance_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "accuracy/reference_scene.hpp"
#include "catalogue/catalogue.hpp"
#include "conformance/question.hpp"
#include "scene/schema.hpp"
#include "scene/text.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::conformance {
namespace {

using nlohmann::json;
using verification::read_reference_table;
using verification::ReferenceRow;

Expected expected(const std::string& field, const ReferenceRow& row) {
  return {field, row.number("high"), row.number("low"), std::max(1.0, row.number("condition")), {}};
}

// Whether a contact on earth can have the arguments of this point's film and load sharing.
bool is_physical(const Scene& scene) {
  const double speed = scene.speeds[0];
  const MixedContact<double> contact(scene);
  const auto numbers = detail::numbers_of<double>(scene);
  return is_physical(*catalogue::function_named("hamrock_dowson_central"),
                     {speed, numbers.viscosity, numbers.pressure_viscosity, numbers.load,
                      numbers.effective_modulus, numbers.radius_x, numbers.ellipticity}) &&
         is_physical(*catalogue::function_named("load_sharing"),
                     {0, contact.flooded_film_parameter(speed), contact.sharing().stiffness(),
                      contact.sharing().offset()});
}

bool is_tiny(const Expected& one) {
  return one.word.empty() && std::abs(one.high) < least_of_engineering;
}

// The certified cases of a function. If the function has several results, each row holds one of
// them, and the rows of the same arguments follow each other.
std::vector<TestCase> cases_of(const catalogue::Function& function,
                               const std::vector<ReferenceRow>& rows) {
  std::vector<TestCase> cases;
  const std::string name(function.name);
  for (const ReferenceRow& row : rows) {
    json inputs{{"function", name}};
    for (const catalogue::Parameter& parameter : function.parameters) {
      json& argument = inputs[std::string(parameter.name)];
      if (parameter.words.empty())
        argument = row.number(parameter.name);
      else
        argument = row.text(parameter.name);
    }
    const bool has_one = function.results.size() == 1;
    if (has_one || cases.empty() || cases.back().inputs != inputs)
      cases.push_back({row.text("id"),
                       name,
                       std::move(inputs),
                       function.contract,
                       {},
                       row.text("region") == "extreme" || row.text("region") == "far",
                       &function});
    TestCase& last = cases.back();
    last.expected.push_back(expected(has_one ? "value" : row.text("output"), row));
    // The film of a collapsed inlet is 0 in every program.
    if (row.text("region") != "collapsed") last.is_extreme |= is_tiny(last.expected.back());
  }
  return cases;
}

// Puts the number or word of a field into a scene's JSON.
void put(json& scene, std::size_t place, double value) {
  const FieldInfo& field = scene_fields()[place];
  json& to = scene[pointer_to(field.path)];
  if (field.type == FieldType::choice)
    to = field.choices[static_cast<std::size_t>(value)];
  else if (field.type == FieldType::integer)
    to = static_cast<int>(value);
  else
    to = value;
}

json certified_scene(const ReferenceRow& row) {
  json scene;
  verification::for_each_field(
      row, [&scene](std::size_t place, double value) { put(scene, place, value); });
  if (row.text("film") == film_formula_words[0]) scene["closures"].erase("film");
  return scene;
}

// Adds the words of regime and inlet, which follow from the shares and films of the point. Within
// 1e-6 of a border a word is not asked. A collapsed film without shares gets no regime.
void add_words(TestCase& point) {
  std::map<std::string, double> value;
  for (const Expected& one : point.expected) value[one.field] = one.high;
  const auto is_near = [](double x, double border) { return std::abs(x / border - 1) < 1e-6; };
  const double asperity = value["asperity_load_share"], fluid = value["fluid_load_share"];
  const bool is_balanced = asperity + fluid > 0;
  if (is_balanced && !is_near(asperity, 0.01) && !is_near(fluid, 0.01))
    point.expected.push_back(
        {"regime", 0, 0, 1, std::string(name(regime_of<double>(asperity, fluid)))});
  const double film = value["film"], flooded = value["film_flooded"];
  if (!is_near(film / flooded, 0.95))
    point.expected.push_back({"inlet", 0, 0, 1,
                              std::string(name(film == 0                ? Inlet::collapsed
                                               : film / flooded >= 0.95 ? Inlet::flooded
                                                                        : Inlet::starved))});
}

std::string point_function(const ReferenceRow& row) {
  const std::string& shape = row.text("shape");
  const bool is_default = shape == "circle" && row.text("film") == film_formula_words[0];
  const std::size_t place = is_default ? 0 : shape == "circle" ? 1 : shape == "ellipse" ? 2 : 3;
  return std::string(operating_point_functions[place]);
}

// Rows p0000.0 to p0000.8 are the outputs of one point. An output is undefined if nothing balances
// the load of a collapsed film. It is not asked, because a solver may give its limit, or nothing.
std::vector<TestCase> operating_points(const std::vector<ReferenceRow>& rows) {
  std::vector<TestCase> cases;
  for (const ReferenceRow& row : rows) {
    const std::string id = row.text("id").substr(0, row.text("id").find('.'));
    if (cases.empty() || cases.back().id != id)
      cases.push_back(
          {id, point_function(row), certified_scene(row), operating_point_contract, {}, false});
    if (row.is_defined()) cases.back().expected.push_back(expected(row.text("output"), row));
  }
  for (TestCase& point : cases) add_words(point);
  return cases;
}

// The case "f0000" once more, as "f0000d", without inputs that have their defaults.
TestCase asked_without(const TestCase& one, json inputs) {
  TestCase made = one;
  made.id += 'd';
  made.inputs = std::move(inputs);
  return made;
}

constexpr std::size_t most_without_defaults = 2;  // cases that omit the same inputs

// Cases once more, without inputs that have their defaults: a solver then uses its own default.
std::vector<TestCase> without_defaults(const catalogue::Function& function,
                                       const std::vector<TestCase>& cases) {
  std::vector<TestCase> made;
  std::map<std::string, std::size_t> count;
  for (const TestCase& one : cases) {
    if (one.is_extreme) continue;
    json inputs = one.inputs;
    std::string left_out;
    for (const catalogue::Parameter& parameter : function.parameters) {
      const std::string name(parameter.name);
      if (!parameter.words.empty()) left_out += inputs[name].get<std::string>() + ' ';
      if (!parameter.default_value) continue;
      const bool has_default = parameter.words.empty()
                                   ? inputs[name] == *parameter.default_value
                                   : inputs[name] == catalogue::default_text(parameter);
      if (!has_default) continue;
      inputs.erase(name);
      left_out += name + ' ';
    }
    if (inputs.size() < one.inputs.size() && count[left_out]++ < most_without_defaults)
      made.push_back(asked_without(one, std::move(inputs)));
  }
  return made;
}

// Points without their default fields, until each field is omitted twice in each kind of point.
std::vector<TestCase> without_defaults(const std::vector<TestCase>& points) {
  std::vector<TestCase> made;
  std::map<std::pair<std::string, std::string_view>, std::size_t> count;  // by kind and field
  for (const TestCase& one : points) {
    json inputs = one.inputs;
    bool is_new = false;
    for (const FieldInfo& field : scene_fields()) {
      const json::json_pointer place = pointer_to(field.path);
      if (field.default_text.empty() || !inputs.contains(place)) continue;
      const json& value = inputs[place];
      const std::string text = value.is_string() ? value.get<std::string>()
                                                 : scene_detail::number_text(value.get<double>());
      if (text != field.default_text) continue;
      json& section = inputs[place.parent_pointer()];
      section.erase(place.back());
      if (section.empty()) inputs.erase(place.parent_pointer().back());
      is_new |= count[{one.function, field.path}]++ < most_without_defaults;
    }
    if (is_new) made.push_back(asked_without(one, std::move(inputs)));
  }
  return made;
}

// Some points of each kind once more without sliding, which the certified ones lack. Their friction
// is that of the asperities alone, μ_b A, and nothing else depends on the sliding.
std::vector<TestCase> without_sliding(const std::vector<TestCase>& points) {
  constexpr std::size_t most_without_sliding = 4;  // of each kind
  constexpr double least_share_shown = 1e-3;
  std::vector<TestCase> made;
  std::map<std::string, std::size_t> count;
  for (const TestCase& one : points) {
    const auto find = [](TestCase& of, std::string_view field) {
      return std::find_if(of.expected.begin(), of.expected.end(),
                          [&](const Expected& expected) { return expected.field == field; });
    };
    TestCase still = one;
    const auto friction = find(still, "friction"), share = find(still, "asperity_load_share");
    if (friction == still.expected.end() || share == still.expected.end() ||
        share->high < least_share_shown || count[one.function]++ >= most_without_sliding)
      continue;
    still.id += 's';
    still.inputs["friction"]["slide_roll_ratio"] = 0;
    const auto boundary = still.inputs["friction"]["boundary_coefficient"].get<long double>();
    const long double value = boundary * (static_cast<long double>(share->high) + share->low);
    friction->high = static_cast<double>(value);
    friction->low = static_cast<double>(value - static_cast<long double>(friction->high));
    friction->condition = share->condition;
    made.push_back(std::move(still));
  }
  return made;
}

// How many inputs differ, or are in only one of the two.
std::size_t count_of_others(const json& flat, const json& other) {
  std::size_t count = 0;
  for (const auto& [path, value] : flat.items())
    count += !other.contains(path) || other[path] != value;
  for (const auto& [path, value] : other.items()) count += !flat.contains(path);
  return count;
}

// Puts each case without defaults behind another case of its function: the one that gives other
// values to most of the omitted inputs. A solver that keeps these values then answers wrong.
// Neighbours that differ in only one input stay together, because they show a solver that forgets
// this input.
void put_between(std::vector<TestCase>& cases, std::vector<TestCase> without) {
  std::map<std::string, const json*> whole;  // the inputs with their defaults, by the case's name
  std::vector<json> given;
  for (const TestCase& one : cases) {
    given.push_back(one.inputs.flatten());
    whole[one.id + 'd'] = &one.inputs;
  }
  std::vector<bool> is_free(cases.size(), true);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    std::size_t next = i + 1;
    while (next < cases.size() && cases[next].function != cases[i].function) ++next;
    is_free[i] = next == cases.size() || count_of_others(given[i], given[next]) > 1;
  }
  std::vector<const TestCase*> behind(cases.size(), nullptr);
  std::vector<const TestCase*> last;
  for (TestCase& made : without) {
    const json all = whole.at(made.id)->flatten(), left = made.inputs.flatten();
    std::size_t most = 0, place = 0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
      if (cases[i].function != made.function || !is_free[i]) continue;
      std::size_t others = 0;
      for (const auto& [path, value] : all.items())
        others += !left.contains(path) && given[i].contains(path) && given[i][path] != value;
      if (others > most) {
        most = others;
        place = i;
      }
    }
    (most > 0 ? behind[place] : last.emplace_back()) = &made;
    if (most == 0) continue;
    made.before = cases[place].inputs;
    is_free[place] = false;
  }
  std::vector<TestCase> put;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    put.push_back(std::move(cases[i]));
    if (behind[i] != nullptr) put.push_back(*behind[i]);
  }
  for (const TestCase* const one : last) put.push_back(*one);
  cases = std::move(put);
}

// The fields that do not have their defaults, the asperity model, and the speed.
json published_scene(const Scene& scene, double speed) {
  json made;
  for (std::size_t place = 0; place < scene_fields().size(); ++place) {
    const FieldInfo& field = scene_fields()[place];
    const std::optional<double> value = scene_detail::value_in(scene, place);
    if (!value || scene_detail::section_of(field.path) == "speed") continue;
    const std::string text = field.type == FieldType::choice
                                 ? std::string(field.choices[static_cast<std::size_t>(*value)])
                                 : scene_detail::number_text(*value);
    if (text != field.default_text || field.path == "closures.asperity") put(made, place, *value);
  }
  made["speed"] = speed;
  return made;
}

// The paper's six surfaces at speeds over its range, computed in long double. The strict bound is
// 4504 ulp, a relative error of 1e-12, because the conditions of these points are not certified.
std::vector<TestCase> paper_points(const std::string& folder) {
  std::vector<TestCase> cases;
  for (const char* const stem :
       {"rough", "medium", "smooth", "rough_gw", "medium_gw", "smooth_gw"}) {
    const SceneReading reading =
        read_scene(fmt::format("{}/{}.toml", folder, stem), SceneUse::speeds);
    if (!reading.scene) throw std::runtime_error(reading.errors.front().line());
    const Scene& scene = *reading.scene;
    if (scene.supply.kind != SupplyKind::inlet_film_ratio || !has_friction_inputs(scene))
      throw std::runtime_error(fmt::format("{}/{}.toml: not the paper's scene", folder, stem));
    const MixedContact<long double> contact(scene);
    for (const double speed : {1e-4, 1e-3, 0.01, 0.03, 0.1, 0.2}) {
      const OperatingPoint<long double> point = contact.solve(speed);
      TestCase made{fmt::format("{}@{}", stem, speed),
                    "operating_point",
                    published_scene(scene, speed),
                    Contract{4504, 0},
                    {},
                    false};
      const auto values = numbers_of(point);
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (output_infos[i].output == Output::separation) continue;
        const auto high = static_cast<double>(values[i]);
        const auto low = static_cast<double>(values[i] - static_cast<long double>(high));
        made.expected.push_back({std::string(output_infos[i].name), high, low, 1, {}});
      }
      add_words(made);
      cases.push_back(std::move(made));
    }
  }
  return cases;
}

// Asperities or a film with a smaller share of the load do not matter in a point.
constexpr double least_share = 1e-9;

// Completes the expected fields by what follows from the case's function and inputs: quantity,
// unit, place, and whether they are physical.
void complete(TestCase& one) {
  const Question question = question_of(one);
  const std::vector<ResultName> results = results_of(question.function);
  const bool has_physical_inputs = question.function != nullptr
                                       ? is_physical(*question.function, question.arguments)
                                       : question.scene && is_physical(*question.scene);
  std::map<std::string, double> value;
  for (const Expected& expected : one.expected) value[expected.field] = expected.high;
  const bool is_point = question.function == nullptr;
  const double asperity = value["asperity_load_share"], fluid = value["fluid_load_share"];
  const bool is_balanced = is_point && asperity + fluid > 0;
  const bool without_asperities = is_balanced && asperity < least_share;
  const bool without_film = is_balanced && fluid < least_share;
  for (Expected& expected : one.expected) {
    const std::string& field = expected.field;
    expected.quantity = field == "value" ? one.function : fmt::format("{}.{}", one.function, field);
    const auto result = std::find_if(results.begin(), results.end(),
                                     [&](const ResultName& known) { return known.name == field; });
    if (result != results.end()) {
      expected.unit = result->unit;
      expected.place = static_cast<std::size_t>(result - results.begin());
    }
    const bool is_of_asperities =
        field == "asperity_load_share" || field == "real_area_ratio" || field == "summit_count";
    expected.is_physical = has_physical_inputs && (expected.high == 0 || !is_tiny(expected)) &&
                           !(without_asperities && is_of_asperities) &&
                           !(without_film && field == "fluid_load_share");
  }
}

}  // namespace

json TestCase::request() const {
  json asked = inputs;
  asked["id"] = id;
  return asked;
}

std::string TestCase::line() const { return request().dump(); }

std::vector<TestCase> read_cases(const CaseSources& sources,
                                 const std::vector<std::string>& functions) {
  const auto is_wanted = [&](std::string_view name) {
    return functions.empty() ||
           std::find(functions.begin(), functions.end(), name) != functions.end();
  };
  for (const std::string& name : functions)
    if (catalogue::function_named(name) == nullptr &&
        std::find(operating_point_functions.begin(), operating_point_functions.end(), name) ==
            operating_point_functions.end())
      throw std::runtime_error(
          fmt::format("no function is called \"{}\"; `tribocheck functions` lists all, and "
                      "operating_point is one, too",
                      printable(name)));
  std::vector<TestCase> all;
  const auto add = [&](std::vector<TestCase> part) {
    for (TestCase& one : part) all.push_back(std::move(one));
  };
  const auto table = [&](std::string_view name) {
    return read_reference_table(fmt::format("{}/{}.csv", sources.exact, name));
  };
  for (const catalogue::Function& function : catalogue::functions()) {
    if (!is_wanted(function.name)) continue;
    std::vector<TestCase> cases = cases_of(function, table(function.name));
    put_between(cases, without_defaults(function, cases));
    add(std::move(cases));
  }
  if (std::any_of(operating_point_functions.begin(), operating_point_functions.end(), is_wanted)) {
    add(paper_points(sources.published));
    std::vector<TestCase> points = operating_points(table("operating_point"));
    std::vector<TestCase> still = without_sliding(points);
    put_between(points, without_defaults(points));
    add(std::move(points));
    add(std::move(still));
    std::erase_if(all, [&](const TestCase& one) { return !is_wanted(one.function); });
  }
  for (TestCase& one : all) complete(one);
  return all;
}

}  // namespace tribo::conformance
