// SPDX-License-Identifier: Apache-2.0
#include "conformance/question.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tribo/mixed_contact.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::conformance {
namespace {

// Solves ln λ − ln λ₀ + e ln(1 − A(λ)) = 0 by bisection where A(λ) < 1; A falls with λ.
double shared_film(const catalogue::Arguments& a, const SharingReading& reading) {
  const bool is_gt = a[0] == 0, is_fit = reading.fit_constant != 0;
  const double lambda0 = a[1], stiffness = a[2], offset = reading.offset_times * a[3];
  const double order = reading.order != 0 ? reading.order : is_gt ? 2.5 : 1.5;
  const double q = reading.share_exponent != 0 ? reading.share_exponent : is_gt ? 0.5 : 1;
  const double e = reading.film_exponent != 0 ? reading.film_exponent
                                              : hamrock_dowson_central_law.sharing_power.value;
  // If powers may leave the range of double, nothing is said.
  if (!(lambda0 > 1e-250 && lambda0 < 1e250 && stiffness < 1e301)) return unsaid;
  const auto moment = [&](double d) {
    if (!is_fit) return gaussian_moment(static_cast<Order>(static_cast<int>(2 * order)), d);
    return d < reading.fit_end
               ? reading.fit_constant * std::pow(reading.fit_end - d, reading.fit_exponent)
               : 0.0;
  };
  const auto share = [&](double lambda) {
    return std::pow(stiffness * moment(lambda - offset), q);
  };
  double floor = 0;
  if (share(0) >= 1) {
    double low = 0, high = std::max(offset, 0.0) + 50;
    for (int i = 0; i < 200; ++i) (share((low + high) / 2) >= 1 ? low : high) = (low + high) / 2;
    floor = high;
  }
  double low = floor, high = std::max(lambda0, floor) + std::max(offset, 0.0) + 60;
  const auto is_below = [&](double lambda) {
    const double asperities = share(lambda);
    return asperities >= 1 || std::log(lambda / lambda0) + e * std::log1p(-asperities) < 0;
  };
  for (int i = 0; i < 300; ++i) {
    const double middle = low > 0 && high > 4 * low ? std::sqrt(low * high) : (low + high) / 2;
    if (middle == low || middle == high) break;
    (is_below(middle) ? low : high) = middle;
  }
  const double lambda = (low + high) / 2;
  return is_fit && lambda - offset < -1 ? unsaid : lambda;  // fits are made for d from about 0
}

Numbers function_numbers(const Question& question) {
  catalogue::Results results{};
  const catalogue::Arguments& a = question.arguments;
  if (question.law)
    results[0] = catalogue::film_by(*question.law, *question.function, a);
  else if (!(question.sharing == SharingReading{}))
    results[0] = shared_film(a, question.sharing);
  else
    question.function->value(a, results);
  return numbers_of(results);
}

double mean_pressure_of(const Scene& scene) {
  return hertz_contact(scene.bodies.shape(), detail::numbers_of<double>(scene)).mean_pressure;
}

ShearedFilm sheared_film_of(const OperatingPoint<double>& point, const Scene& scene,
                            double mean_pressure, const FrictionReading& reading) {
  const Lubricant& oil = scene.lubricant;
  // Roelands' law with another p_R′ is the right law at αp_R′/p_R and p·p_R/p_R′. Barus' αp stays.
  const double times = reading.roelands_pressure / roelands_pressure<double>();
  const double pressure = reading.pressure.value_or(mean_pressure * point.fluid_load_share);
  const double log_viscosity = reading.log_viscosity.value_or(log_viscosity_ratio(
      scene.friction.viscosity,
      std::pow(oil.viscosity, reading.roelands_logarithm) *
          std::exp(reading.roelands_log_viscosity - roelands_log_viscosity<double>()),
      times * oil.pressure_viscosity, pressure / times));
  const double gap = reading.gap.value_or(0) > 0 ? *reading.gap : point.separation;
  const double newtonian = oil.viscosity * std::exp(log_viscosity);
  const double rate = reading.shear_rate.value_or(
      reading.shear_number ? *reading.shear_number * *oil.eyring_stress / newtonian
                           : scene.friction.slide_roll_ratio * point.speed / gap);
  return {pressure, log_viscosity, rate, gap, newtonian * rate / *oil.eyring_stress};
}

double friction_of(const OperatingPoint<double>& point, const Scene& scene,
                   const FrictionReading& reading) {
  const double mean_pressure = mean_pressure_of(scene);
  const auto [pressure, thickening, rate, gap, shear_number] =
      sheared_film_of(point, scene, mean_pressure, reading);
  const double viscosity = scene.lubricant.viscosity, yield = *scene.lubricant.eyring_stress;
  const double newtonian = shear_number * yield;
  const bool is_limiting = scene.friction.fluid == FluidShear::limiting;
  const double stress =
      !is_limiting && reading.eyring_by_line != 0       ? newtonian
      : is_limiting && reading.limiting_by_minimum != 0 ? std::min(newtonian, yield)
      : is_limiting && reading.limiting_by_tangent != 0
          ? yield * std::tanh(newtonian / yield)
          : fluid_shear_stress(scene.friction.fluid, yield, viscosity, thickening, rate * gap, gap);
  const double boundary = reading.boundary_share.value_or(point.asperity_load_share);
  const double sheared = std::max(0.0, 1 - reading.real_area.value_or(point.real_area_ratio));
  return *scene.friction.boundary_coefficient * boundary +
         reading.film * stress * sheared / reading.mean_pressure.value_or(mean_pressure);
}

}  // namespace

nlohmann::json::json_pointer pointer_to(std::string_view path) {
  std::string pointer = '/' + std::string(path);
  std::replace(pointer.begin(), pointer.end(), '.', '/');
  return nlohmann::json::json_pointer(pointer);
}
bool is_left_out(const nlohmann::json& inputs, std::string_view path) {
  return !inputs.contains(pointer_to(path));
}

double argument_of(const catalogue::Parameter& parameter, const nlohmann::json& written) {
  if (parameter.words.empty() && written.is_number()) return written.get<double>();
  if (!parameter.words.empty() && written.is_string())
    if (const auto place = catalogue::place_of(written.get<std::string>(), parameter))
      return *place;
  throw std::runtime_error(fmt::format("{}: {} is not allowed", parameter.name, written.dump()));
}

Question question_of(const TestCase& asked) {
  Question question{&asked, asked.in_catalogue};
  if (question.function == nullptr) {
    question.scene = parse_scene_json(asked.inputs.dump(), "case", SceneUse::one_speed).scene;
    return question;
  }
  const auto& parameters = question.function->parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto written = asked.inputs.find(std::string(parameters[i].name));
    const bool is_left_out = written == asked.inputs.end() && parameters[i].default_value;
    question.arguments[i] =
        is_left_out ? *parameters[i].default_value
                    : argument_of(parameters[i], asked.inputs.at(std::string(parameters[i].name)));
  }
  return question;
}

std::vector<ResultName> results_of(const catalogue::Function* function) {
  std::vector<ResultName> results;
  if (function != nullptr)
    for (const catalogue::Result& one : function->results) results.push_back({one.name, one.unit});
  else
    for (const OutputInfo& one : output_infos)
      if (!one.is_of_smooth_contact) results.push_back({one.name, one.unit});
  return results;
}

Numbers numbers_of(const catalogue::Results& results) {
  Numbers numbers{};
  std::copy(results.begin(), results.end(), numbers.begin());
  return numbers;
}

Numbers numbers_of(const OperatingPoint<double>& right_point, const Question& question) {
  OperatingPoint<double> point = right_point;
  const auto by_model = [&](const std::optional<AsperityModel>& model, double& number,
                            double (*value)(const AsperityContact<double>&, const double&)) {
    if (!model || *model == question.scene->closures.asperity) return;
    Scene scene = *question.scene;
    scene.closures.asperity = *model;
    number = value(MixedContact<double>(scene).asperities(),
                   point.separation / scene.surface.summit_height_sd);
  };
  by_model(question.area_model, point.real_area_ratio, tribo::real_area_ratio<double>);
  by_model(question.count_model, point.summit_count, tribo::summit_count<double>);
  point.summit_count *= question.summit_count_times;
  point.real_area_ratio *= question.real_area_times;
  Numbers numbers = tribo::numbers_of(point);  // some are NaN, so unsaid, if the film collapsed
  const bool is_friction_other = point.real_area_ratio != right_point.real_area_ratio ||
                                 question.friction != FrictionReading{};
  if (point.regime != Regime::collapsed && is_friction_other)
    numbers[static_cast<std::size_t>(Output::friction)] =
        friction_of(point, *question.scene, question.friction);
  return numbers;
}

std::optional<ShearedFilm> sheared_film(const Question& question) {
  if (!question.scene || !has_friction_inputs(*question.scene)) return std::nullopt;
  const auto point = MixedContact<double>(*question.scene).solve(question.scene->speeds[0]);
  if (point.regime == Regime::collapsed) return std::nullopt;
  return sheared_film_of(point, *question.scene, mean_pressure_of(*question.scene),
                         question.friction);
}

Numbers shared_point(const Question& question, const MixedContact<double>& contact, double lambda,
                     double exponent) {
  const double speed = question.scene->speeds[0];
  const double fluid = std::pow(contact.flooded_film_parameter(speed) / lambda, 1 / exponent);
  const FloodedFilm<double> flooded{speed, {lambda, 1 - fluid, fluid, 0}};
  const InletState<double> inlet = contact.inlet(flooded);
  Numbers numbers = numbers_of(contact.complete(flooded, inlet, OutputSet::all()), question);
  if (lambda < contact.sharing().floor())
    std::fill(numbers.begin() + static_cast<int>(Output::separation), numbers.end(), unsaid);
  return numbers;
}

Question sharing_question(const MixedContact<double>& contact, const Scene& scene) {
  return {nullptr,
          catalogue::function_named("load_sharing"),
          {static_cast<double>(scene.closures.asperity),
           contact.flooded_film_parameter(scene.speeds[0]), contact.sharing().stiffness(),
           contact.sharing().offset()}};
}

Numbers right_numbers(const Question& question) {
  if (question.function != nullptr) return function_numbers(question);
  Numbers nothing{};
  nothing.fill(unsaid);
  if (question.scene && question.sharing.film_exponent != 0) {
    const MixedContact<double> contact(*question.scene);
    Question sharing = sharing_question(contact, *question.scene);
    sharing.sharing = question.sharing;
    const double lambda = right_numbers(sharing)[0];
    return lambda > 0 ? shared_point(question, contact, lambda, question.sharing.film_exponent)
                      : nothing;
  }
  if (question.scene)
    return numbers_of(MixedContact<double>(*question.scene).solve(question.scene->speeds[0]),
                      question);
  return nothing;
}

}  // namespace tribo::conformance
