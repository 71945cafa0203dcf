// SPDX-License-Identifier: Apache-2.0
#include "conformance/variable.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>

#include "scene/schema.hpp"
#include "tribo/mixed_contact.hpp"

namespace tribo::conformance {
namespace {

// The number that a scene gives for this parameter of a film law.
double number_of_film(const Scene& scene, std::string_view parameter) {
  const auto numbers = detail::numbers_of<double>(scene);
  if (parameter == "speed") return scene.speeds[0];
  if (parameter == "viscosity") return numbers.viscosity;
  if (parameter == "pressure_viscosity") return numbers.pressure_viscosity;
  if (parameter == "load") return numbers.load;
  if (parameter == "load_per_length") return numbers.load / numbers.across;
  if (parameter == "effective_modulus") return numbers.effective_modulus;
  if (parameter == "ellipticity") return numbers.ellipticity;
  return numbers.radius_x;
}

const catalogue::Function& film_function(const Scene& scene) {
  return *catalogue::function_named(
      film_formula_words[static_cast<std::size_t>(scene.closures.film)]);
}

// Adds the groups of the function, and of others with the same arguments, such as laws of lines.
void add_groups(const catalogue::Function& function, std::vector<Variable>& variables) {
  const auto is_same = [](const auto& a, const auto& b) { return a.name == b.name; };
  for (const catalogue::Function& other : catalogue::functions()) {
    if (!std::ranges::equal(other.parameters, function.parameters, is_same)) continue;
    for (const catalogue::Combination& group : other.combinations) {
      const std::string symbol = symbol_of(group.meaning);
      const auto is_there = [&](const Variable& one) { return one.symbol == symbol; };
      if (std::any_of(variables.begin(), variables.end(), is_there)) continue;
      variables.push_back({symbol, false, [&group](const Question& question) {
                             return group.value(question.arguments);
                           }});
    }
  }
}

// U, G and W of a point: the groups that its film law is written in.
void add_groups_of_points(std::vector<Variable>& variables) {
  for (const std::string_view name : {"speed_number", "material_number", "load_number"}) {
    const auto group_of = [name](const catalogue::Function& law) {
      return std::find_if(law.combinations.begin(), law.combinations.end(),
                          [&](const catalogue::Combination& one) { return one.name == name; });
    };
    const auto value = [group_of](const Question& question) {
      if (!question.scene) return unsaid;
      const catalogue::Function& law = film_function(*question.scene);
      const auto group = group_of(law);
      return group == law.combinations.end()
                 ? unsaid
                 : group->value(film_question(*question.scene).arguments);
    };
    const auto& usual = *catalogue::function_named("hamrock_dowson_central");
    variables.push_back({symbol_of(group_of(usual)->meaning), false, value});
  }
}

bool is_number(const catalogue::Parameter& parameter) {
  return parameter.words.empty() && parameter.range != catalogue::Range::half_order;
}

// The share A of the load that the asperities carry, from λ = λ₀ (1 − A)^−e.
double share_of(const Question& question, double lambda) {
  const double exponent = hamrock_dowson_central_law.sharing_power.value;
  return -std::expm1(std::log(question.arguments[1] / lambda) / exponent);
}

std::vector<Variable> variables_of_function(const catalogue::Function& function) {
  std::vector<Variable> all;
  const auto& parameters = function.parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (is_number(parameters[i]))
      all.push_back({symbol_of(parameters[i].meaning), true,
                     [i](const Question& question) { return question.arguments[i]; }});
  add_groups(function, all);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (!is_number(parameters[i])) continue;
    if (parameters[i].range == catalogue::Range::any)
      all.push_back({'|' + symbol_of(parameters[i].meaning) + '|', false,
                     [i](const Question& question) { return std::abs(question.arguments[i]); }});
    for (std::size_t k = 0; k < i; ++k)
      if (is_number(parameters[k]) && !parameters[i].unit.empty() &&
          parameters[k].unit == parameters[i].unit)
        all.push_back({symbol_of(parameters[i].meaning) + '/' + symbol_of(parameters[k].meaning),
                       false, [i, k](const Question& question) {
                         return question.arguments[i] / question.arguments[k];
                       }});
  }
  if (function.name == "load_sharing") {
    all.push_back({"λ − δ", false, [](const Question& question) {
                     return right_numbers(question)[0] - question.arguments[3];
                   }});
    all.push_back({"A", false, [](const Question& question) {
                     return share_of(question, right_numbers(question)[0]);
                   }});
  }
  for (std::size_t i = 0; i < function.results.size(); ++i)
    all.push_back(
        {"the right " + (function.results.size() > 1 ? std::string(function.results[i].name)
                                                     : symbol_of(function.results[i].meaning)),
         false, [i](const Question& question) { return right_numbers(question)[i]; }, true});
  return all;
}

// Numbers of a point that are not fields of its scene. PointNumbers are in this order.
constexpr std::array point_symbols{"k",      "λ₀",          "αp̄",
                                   "η₀γ̇/τ₀", "the right λ", "the right asperity_load_share"};
using PointNumbers = std::array<double, point_symbols.size()>;

PointNumbers point_numbers(const Scene& scene) {
  const auto numbers = detail::numbers_of<double>(scene);
  const MixedContact<double> contact(scene);
  const double speed = scene.speeds[0], flooded = contact.flooded_film_parameter(speed);
  const double shear_rate =
      numbers.slide_roll_ratio * speed / (flooded * contact.summit_height_sd());
  const OperatingPoint<double> point = contact.solve(speed);
  return {numbers.ellipticity,
          flooded,
          numbers.pressure_viscosity * contact.hertz().mean_pressure,
          numbers.viscosity * shear_rate / numbers.eyring_stress,
          point.film_parameter,
          point.asperity_load_share};
}

// Solves each point once for all variables.
class PointMemory {
 public:
  const PointNumbers& at(const Question& question) {
    const auto [place, is_new] = known_.try_emplace(question.asked);
    if (is_new) place->second = point_numbers(*question.scene);
    return place->second;
  }

 private:
  std::map<const TestCase*, PointNumbers> known_;
};

std::vector<Variable> variables_of_points() {
  std::vector<Variable> all;
  for (std::size_t place = 0; place < scene_fields().size(); ++place) {
    const FieldInfo& field = scene_fields()[place];
    if (field.type != FieldType::number && field.type != FieldType::speeds) continue;
    all.push_back({std::string(field.path), true, [place](const Question& question) {
                     return question.scene
                                ? scene_detail::value_in(*question.scene, place).value_or(unsaid)
                                : unsaid;
                   }});
  }
  add_groups_of_points(all);
  const auto memory = std::make_shared<PointMemory>();
  for (std::size_t i = 0; i < point_symbols.size(); ++i)
    all.push_back({point_symbols[i], false, [memory, i](const Question& question) {
                     return question.scene ? memory->at(question)[i] : unsaid;
                   }});
  return all;
}

}  // namespace

std::string symbol_of(std::string_view meaning) {
  return std::string(meaning.substr(0, meaning.find_first_of(",; ")));
}

Question film_question(const Scene& scene) {
  Question question{nullptr, &film_function(scene), {}};
  const auto& parameters = question.function->parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    question.arguments[i] = number_of_film(scene, parameters[i].name);
  return question;
}

std::vector<Variable> variables_of(const catalogue::Function* function) {
  return function != nullptr ? variables_of_function(*function) : variables_of_points();
}

}  // namespace tribo::conformance
