// SPDX-License-Identifier: Apache-2.0
// reference/scene.schema.json says what the table of fields says, no more and no less: the schema
// is built from the table and compared with the committed file. The same is done for the table of
// ranges and defaults in model/README.md. To write both anew:
//   TRIBOCHECK_UPDATE_SCHEMA=1 build/release/verification/tests/json_schema_test
// reports/tests/test_schema.py then shows that schema and reader judge the same scenes alike.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "scene/units.hpp"
#include "tribo/film_thickness.hpp"
#include "tribo/scene_reader.hpp"
#include "tribo/validity.hpp"

namespace tribo {
namespace {

// Json::array and Json::object make lists and objects of one element: compilers differ on {{a, b}}.
using Json = nlohmann::ordered_json;

const char* const schema_file = TRIBOCHECK_SOURCE_DIR "/reference/scene.schema.json";

bool is_worded(const FieldInfo& field) {
  return field.type == FieldType::text || field.type == FieldType::outputs ||
         field.type == FieldType::limits;
}

std::string description_of(const FieldInfo& field) {
  std::string text(field.meaning);
  if (!field.unit.empty()) text += "; in " + std::string(field.unit);
  if (field.needed_by) text += "; only " + std::string(info(*field.needed_by).name) + " needs it";
  if (is_worded(field)) text += "; default: " + std::string(field.default_text);
  return text;
}

// Whole bounds are written as 0, not as 0.0.
Json bound(double value) {
  if (std::trunc(value) == value) return static_cast<std::int64_t>(value);
  return value;
}

// A number followed by a unit, as in "20.2 mPa s". JSON Schema applies a pattern to texts alone.
constexpr const char* number_with_unit =
    "^ *[-+]?([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][-+]?[0-9]+)? *[^ 0-9.].*$";

Json number_type(const FieldInfo& field) {
  Json type;
  type["type"] = field.type == FieldType::integer ? "integer" : "number";
  if (scene_detail::takes_units(field)) {
    type["type"] = Json::array({"number", "string"});
    type["pattern"] = number_with_unit;
  }
  if (field.is_radius_of_face) {
    type["not"] = Json::object({{"const", 0}});
    return type;
  }
  type[field.exclusive_minimum ? "exclusiveMinimum" : "minimum"] = bound(field.minimum);
  if (field.maximum) type["maximum"] = bound(*field.maximum);
  if (!field.takes_both_faces) return type;
  const Json faces = {{"type", "array"}, {"minItems", 2}, {"maxItems", 2}, {"items", type}};
  return Json::object({{"oneOf", Json::array({type, faces})}});
}

Json table_of(const std::string& section);

Json speeds_type(const FieldInfo& field) {
  FieldInfo element = field;
  element.type = FieldType::number;
  const Json list = {{"type", "array"}, {"minItems", 1}, {"items", number_type(element)}};
  return Json::object({{"oneOf", Json::array({number_type(element), list, table_of("speed")})}});
}

Json outputs_type() {
  Json names = Json::array();
  for (const OutputInfo& output : output_infos) names.push_back(output.name);
  return {{"type", "array"},
          {"minItems", 1},
          {"uniqueItems", true},
          {"items", Json::object({{"enum", names}})}};
}

Json limits_type() {
  return {{"type", "array"}, {"items", Json::object({{"enum", Json(limit_words())}})}};
}

// Two pairs of a temperature and a viscosity.
Json viscosities_type() {
  const auto list_of_two = [](const Json& items) {
    return Json{{"type", "array"}, {"minItems", 2}, {"maxItems", 2}, {"items", items}};
  };
  return list_of_two(list_of_two(number_type({.path = "", .unit = "m²/s"})));
}

Json type_of(const FieldInfo& field) {
  switch (field.type) {
    case FieldType::number:
    case FieldType::integer:
      return number_type(field);
    case FieldType::text:
      return Json::object({{"type", "string"}});
    case FieldType::choice:
      return Json::object({{"enum", Json(field.choices)}});
    case FieldType::speeds:
      return speeds_type(field);
    case FieldType::outputs:
      return outputs_type();
    case FieldType::limits:
      return limits_type();
    case FieldType::viscosities:
      return viscosities_type();
  }
  return {};
}

Json default_of(const FieldInfo& field) {
  if (field.type == FieldType::choice) return field.default_text;
  return Json::parse(field.default_text);
}

Json schema_of(const FieldInfo& field) {
  Json schema = Json::object({{"description", description_of(field)}});
  schema.update(type_of(field));
  if (!field.default_text.empty() && !is_worded(field)) schema["default"] = default_of(field);
  return schema;
}

std::string section_of(std::string_view path) {
  return std::string(path.substr(0, path.find('.')));
}
std::string name_of(std::string_view path) { return std::string(path.substr(path.find('.') + 1)); }

// All fields of exactly one of the group's sets are there, and no field that only others have.
Json group_rule(FieldGroup group) {
  Json sets = Json::array();
  for (const FieldSet& set : group) {
    Json required = Json::array(), barred = Json::array();
    std::vector<std::string_view> legal(set.fields.begin(), set.fields.end());
    legal.insert(legal.end(), set.optional.begin(), set.optional.end());
    for (const std::string_view path : set.fields) required.push_back(name_of(path));
    for (const FieldSet& other : group)
      for (const auto& paths : {other.fields, other.optional})
        for (const std::string_view path : paths) {
          const Json one = Json::object({{"required", Json::array({name_of(path)})}});
          const bool is_legal = std::find(legal.begin(), legal.end(), path) != legal.end();
          if (!is_legal && std::find(barred.begin(), barred.end(), one) == barred.end())
            barred.push_back(one);
        }
    Json legal_set = Json::object({{"required", required}});
    if (!barred.empty()) legal_set["not"] = Json::object({{"anyOf", barred}});
    sets.push_back(legal_set);
  }
  return Json::object({{"oneOf", sets}});
}

// Roughness is given in at most one way.
Json roughness_rule() {
  return Json::parse(R"({"not": {"anyOf": [
    {"required": ["m0", "rms_roughness"]}, {"required": ["m0", "average_roughness"]},
    {"required": ["rms_roughness", "average_roughness"]}]}})");
}

// The surface of smooth bodies: Rq or Ra, and no field of the summits.
Json roughness_alone() {
  Json roughness = Json::array(), summits = Json::array();
  for (const FieldInfo& field : scene_fields())
    if (section_of(field.path) == "surface")
      (field.takes_both_faces ? roughness : summits)
          .push_back(Json::object({{"required", Json::array({name_of(field.path)})}}));
  return {{"anyOf", roughness}, {"not", Json::object({{"anyOf", summits}})}};
}

Json table_of(const std::string& section) {
  Json required = Json::array(), properties = Json::object();
  for (const FieldInfo& field : scene_fields()) {
    if (!field.path.starts_with(section + '.')) continue;
    const std::string name(field.path.substr(section.size() + 1));
    properties[name] = schema_of(field);
    if (field.required) required.push_back(name);
  }
  Json table = {{"type", "object"}, {"additionalProperties", false}};
  if (!required.empty()) table["required"] = required;
  if (section == "supply") {
    table["description"] = "exactly one of these; no supply at all: fully flooded";
    table["minProperties"] = 1;
    table["maxProperties"] = 1;
  }
  table["properties"] = properties;
  for (const FieldGroup group : scene_field_groups())
    if (section_of(group.back().fields.front()) == section)
      table["allOf"].push_back(group_rule(group));
  if (section == "surface") table["allOf"][0]["oneOf"].push_back(roughness_alone());
  if (section == "surface") table["allOf"].push_back(roughness_rule());
  return table;
}

// if friction.viscosity is "roelands", then lubricant.viscosity > 6.315e-5
Json roelands_rule() {
  const Json condition = Json::parse(R"({"required": ["friction"], "properties": {"friction": {
    "required": ["viscosity"], "properties": {"viscosity": {"const": "roelands"}}}}})");
  const Json consequence = Json::parse(R"({"properties": {"lubricant": {"properties": {
    "viscosity": {"exclusiveMinimum": 6.315e-5}}}}})");
  return {{"if", condition}, {"then", consequence}};
}

// if the contact is a line, then closures.film is a law of lines, else a law of points
Json film_rule() {
  Json of_lines = Json::array(), of_points = Json::array();
  for (const NamedFilmLaw& named : named_film_laws) {
    if (named.of(true) != nullptr) of_lines.push_back(named.word);
    if (named.of(false) != nullptr) of_points.push_back(named.word);
  }
  const Json condition = Json::parse(R"({"properties": {"bodies": {"required": ["length"]}}})");
  const auto film = [](const Json& words) {
    return Json{{"properties",
                 {{"closures", {{"properties", {{"film", Json::object({{"enum", words}})}}}}}}}};
  };
  Json line = film(of_lines);
  line["required"] = Json::array({"closures"});
  line["properties"]["closures"]["required"] = Json::array({"film"});
  return {{"if", condition}, {"then", line}, {"else", film(of_points)}};
}

// if closures.film needs α, as the default law does, then lubricant.pressure_viscosity > 0
Json rise_rule() {
  Json without = Json::array();
  for (const NamedFilmLaw& named : named_film_laws)
    if (named.law->takes_constant_viscosity()) without.push_back(named.word);
  Json condition = Json::parse(R"({"not": {"required": ["closures"], "properties": {"closures": {
    "required": ["film"]}}}})");
  condition["not"]["properties"]["closures"]["properties"]["film"]["enum"] = without;
  const Json consequence = Json::parse(R"({"properties": {"lubricant": {"properties": {
    "pressure_viscosity": {"exclusiveMinimum": 0}}}}})");
  return {{"if", condition}, {"then", consequence}};
}

// if there are no summits, then no output and no supply is a ratio to their σ_s
Json smooth_rule() {
  const Json condition = Json::parse(R"({"not": {"required": ["surface"], "properties": {
    "surface": {"anyOf": [{"required": ["summit_density"]}, {"required": ["m0"]}]}}}})");
  const Json consequence = Json::parse(R"({"properties": {
    "outputs": {"not": {"contains": {"const": "film_parameter"}}},
    "supply": {"not": {"required": ["inlet_film_ratio"]}}}})");
  return {{"if", condition}, {"then", consequence}};
}

// if an output is asked for by name, then the fields that only it needs are required
Json output_rule(const OutputInfo& output) {
  Json required = Json::array(), properties = Json::object();
  for (const FieldInfo& field : scene_fields()) {
    if (field.needed_by != output.output) continue;
    const std::string section(field.path.substr(0, field.path.find('.')));
    if (!properties.contains(section)) required.push_back(section);
    properties[section]["required"].push_back(field.path.substr(section.size() + 1));
  }
  if (output.output == Output::lambda_ratio) {
    required.push_back("surface");
    properties = Json::parse(R"({"surface": {"anyOf": [{"required": ["rms_roughness"]},
      {"required": ["average_roughness"]}, {"required": ["m0"]}]}})");
  }
  if (required.empty()) return nullptr;
  const Json named = Json::object({{"contains", Json::object({{"const", output.name}})}});
  return {{"if",
           {{"required", Json::array({"outputs"})},
            {"properties", Json::object({{"outputs", named}})}}},
          {"then", {{"required", required}, {"properties", properties}}}};
}

Json schema_of_table() {
  Json required = Json::array(), properties = Json::object();
  for (const FieldInfo& field : scene_fields()) {
    const std::size_t dot = field.path.find('.');
    const std::string name(field.path.substr(0, dot));
    const bool in_table = dot != std::string_view::npos;
    if (!properties.contains(name)) properties[name] = in_table ? table_of(name) : schema_of(field);
    const bool listed = std::find(required.begin(), required.end(), name) != required.end();
    const bool has_group = std::any_of(scene_field_groups().begin(), scene_field_groups().end(),
                                       [&](FieldGroup group) {
                                         const auto fields = group.front().fields;
                                         return !fields.empty() && fields.front() == field.path;
                                       });
    const bool may_be_absent = name == "speed" || name == "surface";
    if ((field.required || has_group) && !listed && !may_be_absent) required.push_back(name);
  }
  Json rules = Json::array({roelands_rule(), film_rule(), rise_rule(), smooth_rule()});
  for (const OutputInfo& output : output_infos)
    if (const Json rule = output_rule(output); !rule.is_null()) rules.push_back(rule);
  return {
      {"$schema", "https://json-schema.org/draft/2020-12/schema"},
      {"title", "tribocheck scene"},
      {"description",
       "One contact, its lubricant, its supply of oil and the speeds it is asked at. SI units, or "
       "a text with a number and its unit: \"20.2 mPa s\"."},
      {"$comment",
       "Built from scene_fields() by verification/tests/scene/json_schema_test.cpp. What a schema "
       "cannot say: the unit of a text fits its field; speed is required but for onset; speed.to "
       "is above speed.from; numbers are "
       "finite in double and do not vanish; two faces meet at a point; m0 m4/m2² of a profile is "
       "above 0.8968."},
      {"type", "object"},
      {"additionalProperties", false},
      {"required", required},
      {"properties", properties},
      {"allOf", rules}};
}

TEST(JsonSchema, SaysWhatTheTableOfFieldsSays) {
  const Json wanted = schema_of_table();
  if (std::getenv("TRIBOCHECK_UPDATE_SCHEMA") != nullptr)
    std::ofstream(schema_file) << wanted.dump(2) << '\n';
  std::ifstream file(schema_file);
  ASSERT_TRUE(file) << schema_file;
  const Json committed = Json::parse(file, nullptr, false);
  ASSERT_FALSE(committed.is_discarded()) << schema_file << " is not JSON";
  EXPECT_EQ(committed, wanted) << schema_file << " does not follow the table of fields; with "
                               << "TRIBOCHECK_UPDATE_SCHEMA=1 in the environment this program "
                               << "writes it anew. The difference:\n"
                               << Json::diff(committed, wanted).dump(2);
}

// --- The ranges on the page of the model.

const char* const page_file = TRIBOCHECK_SOURCE_DIR "/model/README.md";

std::string text_of(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

std::string allowed_on_page(const FieldInfo& field) {
  std::string text;
  switch (field.type) {
    case FieldType::choice:
      for (const std::string_view word : field.choices)
        text += (text.empty() ? "`" : ", `") + std::string(word) + '`';
      return text;
    case FieldType::text:
      return "a text";
    case FieldType::outputs:
    case FieldType::limits:
      return "a list of words";
    case FieldType::viscosities:
      return "two pairs of numbers above 0";
    case FieldType::speeds:
      return "above 0, a list or a range";
    default:
      break;
  }
  if (field.is_radius_of_face) return "any but 0";
  const std::string least = text_of(field.minimum);
  if (field.maximum)
    return (field.exclusive_minimum ? "above " : "") + least + " to " + text_of(*field.maximum);
  return field.exclusive_minimum ? "above " + least : least + " or more";
}

// The range beyond which a scene gets a warning; empty where all allowed numbers are in it.
std::string usual_on_page(const FieldInfo& field) {
  const bool has_least = field.plausible_minimum != 0;
  const bool has_greatest = std::isfinite(field.plausible_maximum);
  if (has_greatest)
    return text_of(field.plausible_minimum) + " to " + text_of(field.plausible_maximum);
  return has_least ? "from " + text_of(field.plausible_minimum) : "";
}

std::string ranges_on_page() {
  std::string text = "| field | unit | allowed | usual | default |\n|---|---|---|---|---|\n";
  for (const FieldInfo& field : scene_fields()) {
    const std::string fallback = field.default_text.empty() ? field.required ? "required" : ""
                                                            : std::string(field.default_text);
    text += "| `" + std::string(field.path) + "` | " + std::string(field.unit) + " | " +
            allowed_on_page(field) + " | " + usual_on_page(field) + " | " + fallback + " |\n";
  }
  return text;
}

TEST(JsonSchema, ThePageOfTheModelHasTheRangesOfTheTable) {
  std::ostringstream page;
  page << std::ifstream(page_file).rdbuf();
  std::string text = page.str();
  const std::size_t head = text.find("| field | unit | allowed | usual | default |\n");
  ASSERT_NE(head, std::string::npos) << page_file;
  const std::size_t length = text.find("\n\n", head) + 1 - head;
  if (std::getenv("TRIBOCHECK_UPDATE_SCHEMA") != nullptr)
    std::ofstream(page_file) << text.replace(head, length, ranges_on_page());
  else
    EXPECT_EQ(text.substr(head, length), ranges_on_page())
        << page_file << " does not follow the table of fields; with TRIBOCHECK_UPDATE_SCHEMA=1 in "
        << "the environment this program writes it anew.";
}

TEST(JsonSchema, CoversEveryFieldOfTheTable) {
  const Json schema = schema_of_table();
  for (const FieldInfo& field : scene_fields()) {
    const std::size_t dot = field.path.find('.');
    const Json* node = &schema["properties"][std::string(field.path.substr(0, dot))];
    if (node->contains("oneOf") && dot != std::string_view::npos) node = &(*node)["oneOf"][2];
    if (dot != std::string_view::npos)
      node = &(*node)["properties"][std::string(field.path.substr(dot + 1))];
    ASSERT_TRUE(node->contains("description")) << field.path;
    const std::string description = (*node)["description"];
    EXPECT_EQ(description.substr(0, field.meaning.size()), field.meaning) << field.path;
  }
}

}  // namespace
}  // namespace tribo
