// SPDX-License-Identifier: Apache-2.0
#include "conformance/insides.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "catalogue/ways_to_ask.hpp"
#include "conformance/follow.hpp"
#include "conformance/mistake_entry.hpp"
#include "conformance/variable.hpp"
#include "scene/schema.hpp"
#include "tribo/bracketed_root.hpp"
#include "tribo/gaussian_moment.hpp"
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
      &FrictionReading::shear_rate, {},
      {{"shear-rate-of-speed", "u/h, without the slide-roll ratio,", [](const Question& asked) {
          const auto film = sheared_film(asked);
          return film ? film->shear_rate / asked.scene->friction.slide_roll_ratio : unsaid;
        }}});
  add("the gap in friction", Inner::cut_off, of_sheared_film(&ShearedFilm::gap),
      &FrictionReading::gap, {},
      {result_as("friction-of-film", Output::film),
       result_as("friction-of-flooded-film", Output::film_flooded),
       {"friction-of-smooth-film", "h₀, before the load is shared,", smooth_film}});
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
  // This number of the sheared film comes last, because it is computed from the ones before.
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

// The named argument of a film law; R_x is R in laws of circles. Null: the law has none.
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
  // Fits of k by authors of film laws (readings.cpp), and the simplest: B. J. Hamrock, D. Brewe:
  // Simplified solution for stresses and deformations. J. Lubr. Technol. 105 (1983) 171.
  add("k", "ellipticity",
      {{"film-of-ratio-of-radii", "R_y/R_x", of_radii([](double x, double y) { return y / x; })},
       {"film-of-fit-1.03", "1.03 (R_y/R_x)^0.64",
        of_radii([](double x, double y) { return 1.03 * std::pow(y / x, 0.64); })},
       {"film-of-fit-1.0339", "1.0339 (R_y/R_x)^0.636",
        of_radii([](double x, double y) { return 1.0339 * std::pow(y / x, 0.636); })},
       {"film-of-power-of-radii", "(R_y/R_x)^(2/π)",
        of_radii([](double x, double y) { return std::pow(y / x, 2 / std::numbers::pi); })},
       fixed("point-film-of-circle", "1", 1)});
  add("E*", "effective_modulus");
  add("F", "load");
  add("F/L", "load_per_length",
      {{"film-of-whole-load", "F", [](const Question& asked) { return asked.scene->load; }}});
}

double film_of_oil(const Question& asked) {
  const MixedContact<double> contact(*asked.scene);
  return contact.supply() == SupplyKind::flooded
             ? unsaid
             : contact.inlet_film_parameter(asked.scene->speeds[0]) * contact.summit_height_sd();
}

// The film divided by the flooded film; NaN if the inlet is flooded.
double film_ratio(const Question& asked) {
  const MixedContact<double> contact(*asked.scene);
  return contact.supply() == SupplyKind::flooded
             ? unsaid
             : contact.inlet(contact.flooded(asked.scene->speeds[0])).film_ratio;
}

// Changes the supply to give this film ratio. At 0 or less it is dry, at about 1 or more flooded.
void supply_for(Question& asked, double ratio) {
  const MixedContact<double> contact(*asked.scene);
  const double now = contact.inlet(contact.flooded(asked.scene->speeds[0])).flooded_over_inlet;
  const InletLaw<double> law = contact.inlet_law();
  constexpr double flooded = -30, dry = 30;  // ln r, along which the ratio falls from 1 to 0
  double log_r = ratio > 0 ? flooded : dry;
  if (ratio > 0 && ratio < law.film_ratio(std::exp(flooded)))
    log_r = bracketed_root<double>([&](double x) { return law.film_ratio(std::exp(x)) - ratio; },
                                   flooded, dry, 0);
  asked.scene->supply.value *= now / std::exp(log_r);
}

void add_inlet(std::vector<Inside>& all) {
  const auto flow = [](const Question& asked) {
    const Supply& supply = asked.scene->supply;
    return supply.kind == SupplyKind::inlet_flow ? supply.value : unsaid;
  };
  const auto ratio_times = [](Get film) -> Get {
    return [film = std::move(film)](const Question& asked) {
      const Supply& supply = asked.scene->supply;
      return supply.kind == SupplyKind::inlet_film_ratio ? supply.value * film(asked) : unsaid;
    };
  };
  const auto for_smooth_film = [](const Question& asked) {
    const MixedContact<double> contact(*asked.scene);
    const double speed = asked.scene->speeds[0];
    return film_of_oil(asked) * contact.flooded(speed).shares.film_parameter /
           contact.flooded_film_parameter(speed);
  };
  all.push_back(
      {"h_oil in the inlet",
       Inner::factor,
       Output::film,
       film_of_oil,
       [](Question& asked, double value) {
         asked.scene->supply.value *= value / film_of_oil(asked);
       },
       {},
       {{"inlet-of-flow", "`supply.inlet_flow`", flow},
        {"inlet-ratio-of-flooded-film", "`supply.inlet_film_ratio` h_ff",
         ratio_times(result_as({}, Output::film_flooded).get)},
        {"inlet-ratio-of-unshared-film", "`supply.inlet_film_ratio` h₀", ratio_times(smooth_film)},
        {"inlet-ratio-of-smooth-film", "h_oil h_ff/h₀, as h₀/h_oil for r makes it,",
         for_smooth_film}}});
  all.push_back({"the film over the flooded one in the inlet", Inner::cut_off, Output::film,
                 film_ratio, supply_for, "closures.starvation"});
}

void add_stiffness(std::vector<Inside>& all) {
  const auto stiffness = [](const Question& asked) {
    return MixedContact<double>(*asked.scene).sharing().stiffness();
  };
  all.push_back({"K in load sharing", Inner::factor, Output::film_flooded, stiffness,
                 [stiffness](Question& asked, double value) {
                   asked.summit_count_times *=
                       scale_stiffness(*asked.scene, value / stiffness(asked));
                 },
                 "closures.asperity"});
}

// --- Mistakes that are not one other number

Mistake of_points(std::string name, std::string text, std::vector<std::string> touches) {
  return {.function = std::string(operating_point_functions[0]),
          .name = std::move(name),
          .text = std::move(text),
          .touches = std::move(touches)};
}

// The load shares of the flooded film where the inlet is starved.
Mistake shares_of_flooded_film() {
  Mistake mistake =
      of_points("shares-at-flooded-film",
                "the shares of the load at the flooded film, where it is starved", {"formula"});
  mistake.instead = [](const Question& asked) -> std::optional<Numbers> {
    if (!asked.scene || asked.scene->supply.kind == SupplyKind::flooded) return std::nullopt;
    const MixedContact<double> contact(*asked.scene);
    const FloodedFilm<double> flooded = contact.flooded(asked.scene->speeds[0]);
    const InletState<double> inlet = contact.inlet(flooded);
    const LoadShares<double>& shares = flooded.shares;
    // This overload takes any load shares, also those of another film.
    const FloodedFilm<long double> same{flooded.speed,
                                        {shares.film_parameter, shares.asperity, shares.fluid, 0}};
    const auto point = contact.in<long double>().complete(
        same, {inlet.film_ratio, inlet.flooded_over_inlet, inlet.collapsed}, same.shares,
        OutputSet::all());
    return numbers_of(detail::in_double(point), asked);
  };
  return mistake;
}

// The film in place of the separation where asperities alone keep the faces apart.
Mistake without_floor() {
  Mistake mistake =
      of_points("separation-without-floor",
                "no floor: the film for the separation, where asperities carry all", {"formula"});
  mistake.instead = [](const Question& asked) -> std::optional<Numbers> {
    if (!asked.scene) return std::nullopt;
    const MixedContact<double> contact(*asked.scene);
    OperatingPoint<double> point = contact.solve(asked.scene->speeds[0]);
    if (!(point.separation > point.film)) return std::nullopt;
    Question closer = asked;
    point.separation = point.film;
    point.real_area_ratio = real_area_ratio(contact.asperities(), point.film_parameter);
    point.summit_count = summit_count(contact.asperities(), point.film_parameter);
    closer.friction.gap = point.film;
    return numbers_of(point, closer);
  };
  return mistake;
}

// F_5/2 in place of F_3/2 in the asperity load of Greenwood and Williamson. If the film is starved,
// or the asperities carry all the load, the results that follow from it are NaN.
Mistake sharing_by_other_moment() {
  Mistake mistake = of_points(
      "points-by-other-moment",
      "F_5/2 in place of F_3/2 with Greenwood and Williamson, in the load of the asperities",
      {"formula"});
  mistake.instead = [](const Question& asked) -> std::optional<Numbers> {
    if (!asked.scene || asked.scene->closures.asperity != AsperityModel::greenwood_williamson)
      return std::nullopt;
    const MixedContact<double> contact(*asked.scene);
    Question other = asked;
    other.sharing.order = 2.5;
    other.sharing.film_exponent = contact.film().sharing_power.value;
    Numbers numbers = right_numbers(other);
    const double lambda = numbers[static_cast<std::size_t>(Output::film_parameter)];
    const bool is_at_floor =
        contact.sharing().stiffness() *
            gaussian_moment(Order::five_halves, lambda - contact.sharing().offset()) >=
        1;
    const bool is_starved = asked.scene->supply.kind != SupplyKind::flooded;
    for (const OutputInfo& one : output_infos)
      if (const auto place = static_cast<std::size_t>(one.output);
          place < numbers.size() && place > static_cast<std::size_t>(Output::film) &&
          (is_at_floor || is_starved) && one.output != Output::film_parameter)
        numbers[place] = unsaid;
    return numbers;
  };
  return mistake;
}

// Hertz' peak pressure wherever friction needs the mean one.
Mistake peak_pressure_in_friction() {
  Mistake mistake =
      of_points("friction-at-peak-pressure",
                "Hertz' peak pressure in place of the mean one, everywhere in friction",
                {"the fluid's pressure in friction", "the mean pressure under τ in friction"});
  mistake.before = [](Question& asked) {
    const auto film = asked.scene ? sheared_film(asked) : std::nullopt;
    if (!film) return;
    const double peak = of_contact(&HertzContact<double>::peak_pressure)(asked);
    asked.friction.pressure =
        film->pressure * peak / of_contact(&HertzContact<double>::mean_pressure)(asked);
    asked.friction.mean_pressure = peak;
  };
  return mistake;
}

// The real area or the number of summits with another power of nβσ_s, by Greenwood and Tripp.
Mistake power_of_roughness(const std::string& name, std::string text, double Question::*times,
                           double factor) {
  Mistake mistake = of_points(name, std::move(text), {name});
  mistake.before = [=](Question& asked) {
    if (!asked.scene || asked.scene->closures.asperity != AsperityModel::greenwood_tripp) return;
    const Surface& face = asked.scene->surface;
    asked.*times /= factor * face.summit_density * face.summit_radius * face.summit_height_sd;
  };
  return mistake;
}

// Another value where a scene has this one, as by a program that takes 0 for a field that is left
// out, takes 2 for a yes, or mixes numbers up.
Mistake other_for(double given, const char* path, double value) {
  const auto field = *scene_detail::find_field(path);
  Mistake mistake =
      of_points(fmt::format("{} = {:g} for {:g}", path, value, given),
                fmt::format("`{}` = {:g} where it is {:g}", path, value, given), {path});
  mistake.before = [given, field, value](Question& asked) {
    if (asked.scene && scene_detail::value_in(*asked.scene, field) == given)
      scene_detail::store_of(field)(*asked.scene, value);
  };
  return mistake;
}

// The real area or the number of summits by another moment of the heights.
struct Counted {
  const char* symbol;
  double Question::*times;
  Order (*order)(AsperityModel);
};
Mistake by_other_moment(const Counted& counted, AsperityModel model, std::string_view word,
                        Order other) {
  const Order right = counted.order(model);
  const auto moment = [](Order order) {
    return twice(order) % 2 == 0 ? fmt::format("F_{}", twice(order) / 2)
                                 : fmt::format("F_{}/2", twice(order));
  };
  Mistake mistake = of_points(fmt::format("{} by {} of {}", counted.symbol, moment(other), word),
                              fmt::format("{} in place of {} in the {}, by `{}`", moment(other),
                                          moment(right), counted.symbol, word),
                              {counted.symbol});
  mistake.before = [=, times = counted.times](Question& asked) {
    if (!asked.scene || asked.scene->closures.asperity != model) return;
    const double separation = right_numbers(asked)[static_cast<std::size_t>(Output::separation)];
    const double d = separation / asked.scene->surface.summit_height_sd -
                     MixedContact<double>(*asked.scene).sharing().offset();
    const double factor = gaussian_moment(other, d) / gaussian_moment(right, d);
    if (std::isfinite(factor)) asked.*times *= factor;
  };
  return mistake;
}

}  // namespace

double smooth_film(const Question& asked) {
  const MixedContact<double> contact(*asked.scene);
  return contact.flooded_film_parameter(asked.scene->speeds[0]) * contact.summit_height_sd();
}

const std::vector<Inside>& insides_of_points() {
  static const std::vector<Inside> all = [] {
    std::vector<Inside> insides;
    add_friction(insides);
    add_film(insides);
    add_stiffness(insides);
    add_inlet(insides);
    // a − b of a film law with Uᵃ Gᵇ.
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
  all.push_back(shares_of_flooded_film());
  all.push_back(without_floor());
  all.push_back(sharing_by_other_moment());
  all.push_back(peak_pressure_in_friction());
  all.push_back(power_of_roughness("area-with-roughness-once",
                                   "πnβσ_s in place of (πnβσ_s)² in the real area",
                                   &Question::real_area_times, std::numbers::pi));
  all.push_back(power_of_roughness("count-without-roughness",
                                   "nA in place of nA nβσ_s in the number of summits",
                                   &Question::summit_count_times, 1));
  Mistake whole_area =
      of_points("count-of-square-metre", "n in place of nA in the number of summits",
                {"count-of-square-metre"});
  whole_area.before = [](Question& asked) {
    if (asked.scene)
      asked.summit_count_times *=
          of_contact(&HertzContact<double>::mean_pressure)(asked) / asked.scene->load;
  };
  all.push_back(std::move(whole_area));
  for (const double given : {0.0, 1.0, 2.0})
    for (const double taken : {0.0, 1.0, 2.0})
      if (given != taken) all.push_back(other_for(given, "surface.offset_planes", taken));
  all.push_back(other_for(0, "friction.slide_roll_ratio", 1));
  const auto models = scene_fields()[*scene_detail::find_field("closures.asperity")].choices;
  for (const Counted& counted :
       {Counted{"real area", &Question::real_area_times, area_order},
        Counted{"number of summits", &Question::summit_count_times, count_order}})
    for (std::size_t i = 0; i < models.size(); ++i)
      for (const Order other :
           {Order::zero, Order::one, Order::three_halves, Order::two, Order::five_halves})
        if (const auto model = static_cast<AsperityModel>(i); other != counted.order(model))
          all.push_back(by_other_moment(counted, model, models[i], other));
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
