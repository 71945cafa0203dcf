// SPDX-License-Identifier: Apache-2.0
#include "conformance/insides.hpp"

#include <fmt/format.h>

#include <cmath>

#include "catalogue/ways_to_ask.hpp"
#include "conformance/follow.hpp"
#include "conformance/mistake_entry.hpp"
#include "conformance/variable.hpp"
#include "scene/schema.hpp"
#include "tribo/mixed_contact.hpp"

namespace tribo::conformance {
namespace {

using Get = std::function<double(const Question&)>;

// A result of the point as the question has it.
template <Output output>
double result(const Question& question) {
  return right_numbers(question)[static_cast<std::size_t>(output)];
}

HertzContact<double> contact_of(const Question& question) {
  return hertz_contact(question.scene->bodies.shape(), detail::numbers_of<double>(*question.scene));
}
double mean_pressure(const Question& question) { return contact_of(question).mean_pressure; }
double peak_pressure(const Question& question) { return contact_of(question).peak_pressure; }

Get of_sheared_film(double (*number)(const ShearedFilm&, const Scene&)) {
  return [number](const Question& question) {
    const std::optional<ShearedFilm> film = sheared_film(question);
    return film ? number(*film, *question.scene) : unsaid;
  };
}
double shear_number(const ShearedFilm& film, const Scene& scene) {
  return scene.lubricant.viscosity * std::exp(film.log_viscosity) * film.shear_rate /
         *scene.lubricant.eyring_stress;
}

template <auto member>
void set_friction(Question& question, double value) {
  question.friction.*member = value;
}

// A constant of Roelands' law; NaN where another law is asked for.
template <auto member>
double roelands_constant(const Question& question) {
  return question.scene->friction.viscosity == ViscosityLaw::roelands ? question.friction.*member
                                                                      : unsaid;
}

void add_friction(std::vector<Inside>& all) {
  const auto add = [&](std::string symbol, Inside::Kind kind, Get get, auto set,
                       std::string_view choice, std::vector<Inside::Other> others) {
    all.push_back({std::move(symbol), kind, Output::friction, std::move(get), set, choice,
                   std::move(others)});
  };
  using Film = ShearedFilm;
  using Reading = FrictionReading;
  const Get shear = of_sheared_film(shear_number);
  add("(ηγ̇/τ₀) in friction", Inside::Kind::factor, shear,
      [shear](Question& question, double value) {
        question.friction.shear_number_times *= value / shear(question);
      },
      "friction.fluid", {});
  add("the fluid's pressure in friction", Inside::Kind::factor,
      of_sheared_film([](const Film& film, const Scene&) { return film.pressure; }),
      set_friction<&Reading::pressure>, "friction.viscosity", {});
  add("9.67 in Roelands' law of friction", Inside::Kind::constant,
      roelands_constant<&Reading::roelands_log_viscosity>,
      set_friction<&Reading::roelands_log_viscosity>, {}, {});
  add("1.96e8 Pa in Roelands' law of friction", Inside::Kind::constant,
      roelands_constant<&Reading::roelands_pressure>, set_friction<&Reading::roelands_pressure>, {},
      {});
  add("ln(η/η₀) in friction", Inside::Kind::cut_off,
      of_sheared_film([](const Film& film, const Scene&) { return film.log_viscosity; }),
      set_friction<&Reading::log_viscosity>, {}, {});
  add("the shear rate in friction", Inside::Kind::cut_off,
      of_sheared_film([](const Film& film, const Scene&) { return film.shear_rate; }),
      set_friction<&Reading::shear_rate>, {}, {});
  add("the gap in friction", Inside::Kind::cut_off,
      of_sheared_film([](const Film& film, const Scene&) { return film.gap; }),
      set_friction<&Reading::gap>, {},
      {{"friction-of-film", "`film`", result<Output::film>},
       {"friction-of-flooded-film", "`film_flooded`", result<Output::film_flooded>}});
  add("`asperity_load_share` beside μ_b in friction", Inside::Kind::replaced,
      result<Output::asperity_load_share>, set_friction<&Reading::boundary_share>, {},
      {{"boundary-friction-by-area", "`real_area_ratio`", result<Output::real_area_ratio>}});
  add("`real_area_ratio` in the sheared area of friction", Inside::Kind::replaced,
      result<Output::real_area_ratio>, set_friction<&Reading::real_area>, {},
      {{"sheared-area-by-asperities", "`asperity_load_share`", result<Output::asperity_load_share>},
       {"sheared-area-by-fluid", "`fluid_load_share`", result<Output::fluid_load_share>}});
  add("the mean pressure under τ in friction", Inside::Kind::replaced, mean_pressure,
      set_friction<&Reading::mean_pressure>, {},
      {{"shear-over-peak-pressure", "Hertz' peak pressure", peak_pressure}});
}

// The place of an argument of a film law; laws of circles have R for R_x. Empty: it has none.
std::optional<std::size_t> place_in_film(const Question& film, std::string_view name) {
  const auto& parameters = film.function->parameters;
  std::size_t place = catalogue::place_in(parameters, name);
  if (name == "radius_x" && place == parameters.size())
    place = catalogue::place_in(parameters, "reduced_radius");
  return place < parameters.size() ? std::optional(place) : std::nullopt;
}
Get argument_of_film(std::string_view name) {
  return [name](const Question& question) {
    const Question film = film_question(*question.scene);
    const auto place = place_in_film(film, name);
    return place ? film.arguments[*place] : unsaid;
  };
}

void add_film(std::vector<Inside>& all) {
  const auto add = [&](const std::string& symbol, std::string_view name,
                       std::vector<Inside::Other> others) {
    const auto set = [name](Question& question, double value) {
      Question film = film_question(*question.scene);
      const double right = right_numbers(film)[0];
      film.arguments[*place_in_film(film, name)] = value;
      const double factor = right_numbers(film)[0] / right;
      if (factor > 0 && std::isfinite(factor)) scale_film(*question.scene, factor);
    };
    all.push_back({symbol + " in the film formula",
                   Inside::Kind::factor,
                   Output::film_flooded,
                   argument_of_film(name),
                   set,
                   {},
                   std::move(others)});
  };
  const auto of_radii = [](double (*number)(double x, double y)) {
    return [number](const Question& question) {
      const Bodies& bodies = question.scene->bodies;
      return bodies.shape() == ContactShape::ellipse ? number(bodies.radius_x, bodies.radius_y)
                                                     : unsaid;
    };
  };
  const std::vector<Inside::Other> radii{
      {"film-of-both-radii", "R of both axes",
       of_radii([](double x, double y) { return x * y / (x + y); })},
      {"film-of-mean-radius", "√(R_xR_y)",
       of_radii([](double x, double y) { return std::sqrt(x * y); })},
      {"film-of-radius-y", "R_y", of_radii([](double, double y) { return y; })}};
  add("R_x", "radius_x", radii);
  add("k", "ellipticity",
      {{"film-of-ratio-of-radii", "R_y/R_x", of_radii([](double x, double y) { return y / x; })}});
  add("E*", "effective_modulus", {});
  add("F", "load", {});
  add("F/L", "load_per_length",
      {{"film-of-whole-load", "F", [](const Question& question) { return question.scene->load; }}});
}

}  // namespace

const std::vector<Inside>& insides_of_points() {
  static const std::vector<Inside> all = [] {
    std::vector<Inside> insides;
    add_friction(insides);
    add_film(insides);
    insides.push_back({"the mean pressure of the contact",
                       Inside::Kind::replaced,
                       Output::film_flooded,
                       mean_pressure,
                       [](Question& question, double value) {
                         scale_area(*question.scene, mean_pressure(question) / value);
                       },
                       {},
                       {{"peak-for-mean-pressure", "Hertz' peak pressure", peak_pressure}}});
    return insides;
  }();
  return all;
}

std::string in_place_of(const std::string& other, const std::string& symbol) {
  const std::size_t end = std::min(symbol.find(" in "), symbol.find(" beside "));
  if (end >= symbol.size()) return fmt::format("{} in place of {}", other, symbol);
  return fmt::format("{} in place of {},{}", other, symbol.substr(0, end), symbol.substr(end));
}

std::vector<Mistake> mistakes_of_insides() {
  std::vector<Mistake> all;
  const auto add = [&](std::string name, std::string text, std::string touches,
                       std::function<void(Question&)> change) {
    all.push_back({.function = std::string(operating_point_functions[0]),
                   .name = std::move(name),
                   .text = std::move(text),
                   .touches = {std::move(touches)},
                   .before = [change = std::move(change)](Question& question) {
                     if (question.scene) change(question);
                   }});
  };
  for (const Inside& inside : insides_of_points())
    for (const Inside::Other& other : inside.others)
      add("point-" + other.name, in_place_of(other.symbol, inside.symbol), inside.symbol,
          [&inside, &other](Question& question) {
            const double value = other.get(question), own = inside.get(question);
            if (std::isfinite(value) && std::isfinite(own) && value != own)
              inside.set(question, value);
          });
  const auto models = scene_fields()[*scene_detail::find_field("closures.asperity")].choices;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const auto model = static_cast<AsperityModel>(i);
    const auto add_model = [&](const char* name, const char* symbol,
                               std::optional<AsperityModel> Question::*member) {
      add(fmt::format("point-{}-of-{}", name, models[i]),
          fmt::format("{} by `{}` where another asperity model is asked for, too", symbol,
                      models[i]),
          symbol, [=](Question& question) { question.*member = model; });
    };
    add_model("count", "the number of summits", &Question::count_model);
    add_model("area", "the real area", &Question::area_model);
  }
  return all;
}

}  // namespace tribo::conformance
