// SPDX-License-Identifier: Apache-2.0
#include "conformance/variable.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "scene/schema.hpp"
#include "tribo/mixed_contact.hpp"

namespace tribo::conformance {
namespace {

// A number of the function or of the scene by its parameter's name; the radius of a film law is "R"
// by any name. NaN: there is none.
double number_named(const Question& question, std::string_view name) {
  if (question.function == nullptr) {
    const bool is_of_film = name != "pressure" && name != "temperature_viscosity" &&
                            name != "thermal_conductivity" && name != "peak_pressure";
    const bool is_line = question.scene && question.scene->bodies.shape() == ContactShape::line;
    if (!question.scene || !is_of_film || (name == "load" && is_line) ||
        (name == "load_per_length" && !is_line))
      return unsaid;
    return number_of_film(*question.scene, name);
  }
  const auto& parameters = question.function->parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (parameters[i].name == name || (name == "R" && (parameters[i].name == "reduced_radius" ||
                                                       parameters[i].name == "radius_x")))
      return question.arguments[i];
  return unsaid;
}

// A group, of a function that has these parameters.
struct Group {
  std::string_view symbol;
  std::vector<std::string_view> parameters;
  double (*value)(std::span<const double> x);
};

double speed_group(double viscosity, double speed, double modulus, double radius) {
  return viscosity * speed / (2 * modulus * radius);
}

const std::vector<Group>& groups() {
  using Values = std::span<const double>;
  static const std::vector<Group> all{
      {"U",
       {"viscosity", "speed", "effective_modulus", "R"},
       [](Values x) { return speed_group(x[0], x[1], x[2], x[3]); }},
      {"G", {"pressure_viscosity", "effective_modulus"}, [](Values x) { return 2 * x[0] * x[1]; }},
      {"W",
       {"load", "effective_modulus", "R"},
       [](Values x) { return x[0] / (2 * x[1] * x[2] * x[2]); }},
      {"W",
       {"load_per_length", "effective_modulus", "R"},
       [](Values x) { return x[0] / (2 * x[1] * x[2]); }},
      {"M",
       {"load", "effective_modulus", "R", "viscosity", "speed"},
       [](Values x) {
         return x[0] / (2 * x[1] * x[2] * x[2]) *
                std::pow(2 * speed_group(x[3], x[4], x[1], x[2]), -0.75);
       }},
      {"M",
       {"load_per_length", "effective_modulus", "R", "viscosity", "speed"},
       [](Values x) {
         return x[0] / (2 * x[1] * x[2]) / std::sqrt(2 * speed_group(x[3], x[4], x[1], x[2]));
       }},
      {"L",
       {"pressure_viscosity", "effective_modulus", "R", "viscosity", "speed"},
       [](Values x) {
         return 2 * x[0] * x[1] * std::pow(2 * speed_group(x[3], x[4], x[1], x[2]), 0.25);
       }},
      {"L",
       {"temperature_viscosity", "viscosity", "speed", "thermal_conductivity"},
       [](Values x) { return x[0] * x[1] * x[2] * x[2] / x[3]; }},
      {"αp", {"pressure_viscosity", "pressure"}, [](Values x) { return x[0] * x[1]; }}};
  return all;
}

double value_of(const Group& group, const Question& question) {
  std::vector<double> values;
  for (const std::string_view one : group.parameters) values.push_back(number_named(question, one));
  return group.value(values);
}

bool has_all(const catalogue::Function& function, const Group& group) {
  return std::all_of(group.parameters.begin(), group.parameters.end(), [&](std::string_view name) {
    return std::any_of(function.parameters.begin(), function.parameters.end(), [&](const auto& p) {
      return p.name == name ||
             (name == "R" && (p.name == "reduced_radius" || p.name == "radius_x"));
    });
  });
}

void add_groups(const catalogue::Function* function, std::vector<Variable>& variables) {
  for (const Group& group : groups())
    if (function == nullptr || has_all(*function, group))
      variables.push_back({std::string(group.symbol), false, [&group](const Question& question) {
                             return value_of(group, question);
                           }});
}

bool is_number(const catalogue::Parameter& parameter) {
  return parameter.words.empty() && parameter.range != catalogue::Range::half_order;
}

// The share of the load that asperities carry, A of λ = λ₀ (1 − A)^−e.
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
  add_groups(&function, all);
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
         false, [i](const Question& question) { return right_numbers(question)[i]; }});
  return all;
}

// Numbers of a point that are not its fields, in the order of their symbols.
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
  add_groups(nullptr, all);
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

std::vector<Variable> variables_of(const catalogue::Function* function) {
  return function != nullptr ? variables_of_function(*function) : variables_of_points();
}

}  // namespace tribo::conformance
