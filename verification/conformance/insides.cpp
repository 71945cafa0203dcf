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

using Inner = Inside::Kind;

Inside::Other result_as(std::string name, Output output) {
  return {std::move(name), fmt::format("`{}`", info(output).name), [output](const Question& asked) {
            return right_numbers(asked)[static_cast<std::size_t>(output)];
          }};
}
Inside::Other fixed(std::string name, const char* symbol, double value) {
  return {std::move(name), symbol, [value](const Question&) { return value; }};
}

// A number of Hertz' contact.
Get of_contact(double HertzContact<double>::*number) {
  return [number](const Question& asked) {
    const Scene& scene = *asked.scene;
    return hertz_contact(scene.bodies.shape(), detail::numbers_of<double>(scene)).*number;
  };
}
Get of_sheared_film(double ShearedFilm::*number) {
  return [number](const Question& asked) {
    const std::optional<ShearedFilm> film = sheared_film(asked);
    return film ? (*film).*number : unsaid;
  };
}
// A constant of Roelands' law; NaN where another law is asked for.
Get of_roelands(double FrictionReading::*constant) {
  return [constant](const Question& asked) {
    return asked.scene->friction.viscosity == ViscosityLaw::roelands ? asked.friction.*constant
                                                                     : unsaid;
  };
}

void add_friction(std::vector<Inside>& all) {
  const auto add = [&](const char* symbol, Inner kind, Get get, auto FrictionReading::*member,
                       std::string_view choice = {}, std::vector<Inside::Other> others = {}) {
    all.push_back({symbol, kind, Output::friction, std::move(get),
                   [member](Question& asked, double value) { asked.friction.*member = value; },
                   choice, std::move(others)});
  };
  const auto mean = &HertzContact<double>::mean_pressure,
             peak = &HertzContact<double>::peak_pressure;
  const char* const peak_text = "Hertz' peak pressure";
  add("the fluid's pressure in friction", Inner::factor, of_sheared_film(&ShearedFilm::pressure),
      &FrictionReading::pressure, "friction.viscosity",
      {{"viscosity-at-whole-pressure", "the contact's mean pressure", of_contact(mean)},
       {"viscosity-at-peak-pressure", peak_text, of_contact(peak)}});
  add("9.67 in Roelands' law of friction", Inner::constant,
      of_roelands(&FrictionReading::roelands_log_viscosity),
      &FrictionReading::roelands_log_viscosity);
  add("1.96e8 Pa in Roelands' law of friction", Inner::constant,
      of_roelands(&FrictionReading::roelands_pressure), &FrictionReading::roelands_pressure);
  add("ln(η/η₀) in friction", Inner::cut_off, of_sheared_film(&ShearedFilm::log_viscosity),
      &FrictionReading::log_viscosity);
  add("the shear rate in friction", Inner::cut_off, of_sheared_film(&ShearedFilm::shear_rate),
      &FrictionReading::shear_rate);
  add("the gap in friction", Inner::cut_off, of_sheared_film(&ShearedFilm::gap),
      &FrictionReading::gap, {},
      {result_as("friction-of-film", Output::film),
       result_as("friction-of-flooded-film", Output::film_flooded)});
  add("`asperity_load_share` beside μ_b in friction", Inner::replaced,
      result_as({}, Output::asperity_load_share).get, &FrictionReading::boundary_share, {},
      {result_as("boundary-friction-by-area", Output::real_area_ratio),
       result_as("friction-share-swapped", Output::fluid_load_share),
       fixed("friction-boundary-unshared", "1", 1), fixed("friction-boundary-missing", "0", 0)});
  add("`real_area_ratio` in the sheared area of friction", Inner::replaced,
      result_as({}, Output::real_area_ratio).get, &FrictionReading::real_area, {},
      {result_as("sheared-area-by-asperities", Output::asperity_load_share),
       result_as("sheared-area-by-fluid", Output::fluid_load_share),
       fixed("friction-area-not-subtracted", "0", 0)});
  add("the mean pressure under τ in friction", Inner::replaced, of_contact(mean),
      &FrictionReading::mean_pressure, {},
      {{"shear-over-peak-pressure", peak_text, of_contact(peak)}});
  // The last one, as it is computed from the others.
  add("(ηγ̇/τ₀) in friction", Inner::factor, of_sheared_film(&ShearedFilm::shear_number),
      &FrictionReading::shear_number, "friction.fluid");
  all.push_back({"the mean pressure of the contact",
                 Inner::replaced,
                 Output::film_flooded,
                 of_contact(mean),
                 [own = of_contact(mean)](Question& asked, double value) {
                   scale_area(*asked.scene, own(asked) / value);
                 },
                 {},
                 {{"peak-for-mean-pressure", peak_text, of_contact(peak)}}});
}

// The argument of the scene's film law; laws of circles have R for R_x. Null: it has none.
double* argument_of_film(Question& film, std::string_view name) {
  const auto& parameters = film.function->parameters;
  std::size_t place = catalogue::place_in(parameters, name);
  if (name == "radius_x" && place == parameters.size())
    place = catalogue::place_in(parameters, "reduced_radius");
  return place < parameters.size() ? &film.arguments[place] : nullptr;
}

void add_film(std::vector<Inside>& all) {
  const auto add = [&](const std::string& symbol, std::string_view name,
                       std::vector<Inside::Other> others = {}) {
    const auto get = [name](const Question& asked) {
      Question film = film_question(*asked.scene);
      const double* const argument = argument_of_film(film, name);
      return argument != nullptr ? *argument : unsaid;
    };
    const auto set = [name](Question& asked, double value) {
      Question film = film_question(*asked.scene);
      const double right = right_numbers(film)[0];
      *argument_of_film(film, name) = value;
      const double factor = right_numbers(film)[0] / right;
      if (factor > 0 && std::isfinite(factor)) scale_film(*asked.scene, factor);
    };
    all.push_back({symbol + " in the film formula",
                   Inner::factor,
                   Output::film_flooded,
                   get,
                   set,
                   {},
                   std::move(others)});
  };
  const auto of_radii = [](double (*number)(double x, double y)) {
    return [number](const Question& asked) {
      const Bodies& bodies = asked.scene->bodies;
      return bodies.shape() == ContactShape::ellipse ? number(bodies.radius_x, bodies.radius_y)
                                                     : unsaid;
    };
  };
  add("R_x", "radius_x",
      {{"film-of-both-radii", "R of both axes",
        of_radii([](double x, double y) { return x * y / (x + y); })},
       {"film-of-radius-y", "R_y", of_radii([](double, double y) { return y; })}});
  add("k", "ellipticity",
      {{"film-of-ratio-of-radii", "R_y/R_x", of_radii([](double x, double y) { return y / x; })},
       fixed("point-film-of-circle", "1", 1)});
  add("E*", "effective_modulus");
  add("F", "load");
  add("F/L", "load_per_length",
      {{"film-of-whole-load", "F", [](const Question& asked) { return asked.scene->load; }}});
}

}  // namespace

const std::vector<Inside>& insides_of_points() {
  static const std::vector<Inside> all = [] {
    std::vector<Inside> insides;
    add_friction(insides);
    add_film(insides);
    // The a − b of a film law, of Uᵃ and Gᵇ.
    insides.push_back({"the film's exponent in load sharing", Inner::constant, Output::film_flooded,
                       [](const Question& asked) {
                         return MixedContact<double>(*asked.scene).film().sharing_power.value;
                       },
                       [](Question& asked, double value) { asked.sharing.film_exponent = value; },
                       "closures.film"});
    return insides;
  }();
  return all;
}

std::string in_place_of(const std::string& other, const std::string& symbol) {
  const std::size_t end = std::min(symbol.find(" in "), symbol.find(" beside "));
  return fmt::format("{} in place of {}{}{}", other, symbol.substr(0, end),
                     end < symbol.size() ? "," : "", symbol.substr(std::min(end, symbol.size())));
}

Mistake mistake_of_inside(std::string name, std::string text, const Inside& inside, Get value) {
  return {.function = std::string(operating_point_functions[0]),
          .name = std::move(name),
          .text = std::move(text),
          .touches = {inside.symbol},
          .before = [&inside, value = std::move(value)](Question& asked) {
            if (!asked.scene) return;
            const double other = value(asked), own = inside.get(asked);
            if (std::isfinite(other) && std::isfinite(own) && other != own)
              inside.set(asked, other);
          }};
}

std::vector<Mistake> mistakes_of_insides() {
  std::vector<Mistake> all;
  for (const Inside& inside : insides_of_points())
    for (const Inside::Other& other : inside.others)
      all.push_back(mistake_of_inside(other.name, in_place_of(other.symbol, inside.symbol), inside,
                                      other.get));
  const auto models = scene_fields()[*scene_detail::find_field("closures.asperity")].choices;
  for (std::size_t i = 0; i < models.size(); ++i)
    for (const auto& [symbol, member] : {std::pair{"number of summits", &Question::count_model},
                                         std::pair{"real area", &Question::area_model}})
      all.push_back({.function = std::string(operating_point_functions[0]),
                     .name = fmt::format("{} by {}", symbol, models[i]),
                     .text = fmt::format("the {} by `{}` where another asperity model is asked for",
                                         symbol, models[i]),
                     .touches = {symbol},
                     .before = [by = member, model = static_cast<AsperityModel>(i)](
                                   Question& asked) { asked.*by = model; }});
  return all;
}

}  // namespace tribo::conformance
