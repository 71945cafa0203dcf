// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "build_info.hpp"
#include "film_case.hpp"
#include "page/text_table.hpp"
#include "page/texts.hpp"
#include "protocol/answers.hpp"
#include "table.hpp"
#include "tribo/starvation.hpp"

namespace tribo::cli {
namespace {

using nlohmann::ordered_json;

struct Quantity {
  std::string_view name, words, unit;
  Measured FilmCase::*value;
  enum : std::uint8_t { of_film, of_supply, of_friction, of_spike } kind;
};
constexpr auto quantities = std::to_array<Quantity>({
    {"central_film", "central film", "m", &FilmCase::central, Quantity::of_film},
    {"minimum_film", "minimum film", "m", &FilmCase::minimum, Quantity::of_film},
    {"film_at_greatest_pressure", "film at the greatest pressure", "m",
     &FilmCase::at_greatest_pressure, Quantity::of_film},
    {"flooded_central_film", "central film, flooded inlet", "m", &FilmCase::flooded_central,
     Quantity::of_supply},
    {"film_ratio", "central film over that one", "-", &FilmCase::film_ratio, Quantity::of_supply},
    {"friction", "friction coefficient of the oil", "-", &FilmCase::friction,
     Quantity::of_friction},
    {"spike_pressure", "pressure of the spike", "Pa", &FilmCase::spike_pressure,
     Quantity::of_spike},
    {"spike_place", "place of the spike, x", "m", &FilmCase::spike_place, Quantity::of_spike},
});

// A number that is known before the solve: M, L, h_oil or one of Hertz' numbers. NaN if the contact
// has none.
struct Given {
  std::string_view name, words, unit;
  double FilmCase::*value;
};
constexpr auto given = std::to_array<Given>({
    {"load_number", "load number M", "-", &FilmCase::load_number},
    {"material_number", "material number L", "-", &FilmCase::material_number},
    {"half_width", "half-width by Hertz, b", "m", &FilmCase::half_width},
    {"ellipticity", "ellipticity by Hertz, a_y/a_x", "-", &FilmCase::ellipticity},
    {"peak_pressure", "peak pressure by Hertz", "Pa", &FilmCase::peak_pressure},
    {"inlet_film", "layer of oil at the inlet", "m", &FilmCase::inlet_film},
});

constexpr std::size_t signed_width = number_width + 1, deviation_width = 11;

// The number with as many digits as its error leaves, and one more; 3 to 12 digits.
std::string with_digits(const Measured& measured) {
  const double digits = std::ceil(std::log10(std::fabs(measured.value) / measured.error)) + 1;
  return fmt::format("{:#.{}g}", measured.value,
                     std::isfinite(digits) ? std::clamp(static_cast<int>(digits), 3, 12) : 12);
}

ordered_json profile_json(const FilmCase& film) {
  ordered_json x = ordered_json::array(), pressure = x, thickness = x;
  for (const ProfilePoint& point : film.profile) {
    x.push_back(point.x);
    pressure.push_back(point.pressure);
    thickness.push_back(point.film);
  }
  return {{"x", std::move(x)}, {"pressure", std::move(pressure)}, {"film", std::move(thickness)}};
}

void append_csv_heads(Text& to) {
  append(to, "id,speed");
  for (const Given& one : given) append(to, fmt::format(",{}", one.name));
  for (const Quantity& one : quantities) append(to, fmt::format(",{0},{0}_error", one.name));
  for (const std::string_view name : film_formula_names())
    append(to, fmt::format(",{0},{0}_deviation_percent,{0}_this_liquid_deviation_percent", name));
  for (const std::string_view name : starvation_closure_words)
    append(to, fmt::format(",{0}_film_ratio,{0}_deviation_percent", name));
  append(to,
         ",damiens_exponent,viscosity,density,tolerance,grids,cells,cells_across,newton_steps,no_"
         "spike,reason\n");
}

void append_csv_number(Text& to, double value) {
  to.push_back(',');
  if (std::isfinite(value)) protocol::append_number(to, value);
}

void append_csv(Text& to, const FilmCase& film) {
  append(to, report::csv_text(film.id));
  append_csv_number(to, film.speed);
  for (const Given& one : given) append_csv_number(to, film.*one.value);
  for (const Quantity& one : quantities) {
    append_csv_number(to, (film.*one.value).value);
    append_csv_number(to, (film.*one.value).error);
  }
  for (const std::string_view name : film_formula_names()) {
    const auto formula = std::ranges::find(film.formulas, name, &FormulaFilm::name);
    if (formula == film.formulas.end()) {
      append(to, ",,,");
      continue;
    }
    append_csv_number(to, formula->film);
    append_csv_number(to, 100 * formula->deviation);
    append_csv_number(to, 100 * formula->this_liquid_deviation);
  }
  for (std::size_t i = 0; i < starvation_closure_words.size(); ++i) {
    if (film.closures.empty()) {
      append(to, ",,");
      continue;
    }
    append_csv_number(to, film.closures[i].film_ratio);
    append_csv_number(to, 100 * film.closures[i].deviation);
  }
  append_csv_number(to, film.damiens_exponent);
  append(to, fmt::format(",{},{}", film.viscosity, film.density));
  append_csv_number(to, film.tolerance);
  append(to, fmt::format(",{},{},{},{},{},{}\n", film.grids, film.cells,
                         film.is_line() ? "" : std::to_string(film.cells_across), film.steps,
                         report::csv_text(film.no_spike), report::csv_text(film.reason)));
}

void append_csv_profile(Text& to, const FilmCase& film) {
  const std::string id = report::csv_text(film.id);
  for (const ProfilePoint& point : film.profile) {
    append(to, id);
    for (const double value :
         {film.speed, point.x, point.x / film.half_width, point.pressure, point.film})
      append_csv_number(to, value);
    to.push_back('\n');
  }
}

void append_formulas(Text& to, const FilmCase& film) {
  std::size_t longest = 24;
  for (const FormulaFilm& formula : film.formulas) longest = std::max(longest, formula.name.size());
  const std::vector<ColumnHead> heads{{"formula", "", longest},
                                      {"film", "[m]", number_width},
                                      {"deviation", "[%]", deviation_width},
                                      {"this liquid", "[%]", deviation_width},
                                      {"stands_for", "", 25},
                                      {"liquid of the fit", "", 22}};
  const auto per_cent = [](double off) {
    return std::isfinite(off) ? fmt::format("{:+.2f}", 100 * off) : "-";
  };
  to.push_back('\n');
  append_heads(to, heads);
  for (const FormulaFilm& formula : film.formulas)
    append_row(to, heads,
               {std::string(formula.name), readable(formula.film), per_cent(formula.deviation),
                per_cent(formula.this_liquid_deviation), std::string(formula.stands_for),
                std::string(formula.fitted_to)});
}

void append_closures(Text& to, const FilmCase& film) {
  const std::vector<ColumnHead> heads{{"closure", "", 24},
                                      {"film ratio", "[-]", number_width},
                                      {"deviation", "[%]", deviation_width}};
  to.push_back('\n');
  append_heads(to, heads);
  for (const ClosureRatio& one : film.closures)
    append_row(to, heads,
               {std::string(one.closure), readable(one.film_ratio),
                fmt::format("{:+.2f}", 100 * one.deviation)});
}

// A note with the central film of a real oil, computed back from a formula that was fitted to one.
// Without such a formula: which options solve a real oil.
std::string note_on_oil(const FilmCase& film) {
  constexpr std::string_view options = "`--viscosity roelands --density dowson_higginson`";
  const auto of_oil = std::ranges::find_if(film.formulas, [](const FormulaFilm& formula) {
    return formula.fitted_to == "roelands, compressible" && formula.stands_for == "central_film" &&
           std::isfinite(formula.deviation);
  });
  if (of_oil == film.formulas.end())
    return fmt::format("another liquid changes the film by far more than ±: {} solves a real oil",
                       options);
  const double oil_film = of_oil->film / (1 + of_oil->deviation);
  const double change = oil_film / film.central.value - 1;
  return fmt::format(
      "a real oil, which {} solves, has a central film of {} m, {:.1f} % {} than this one; how "
      "good "
      "a formula of such an oil is, its deviation says, and not the column `this liquid`",
      options, readable(oil_film), 100 * std::abs(change), change < 0 ? "thinner" : "thicker");
}

void append_notes(Text& to, const FilmCase& film) {
  const auto note = [&](const std::string& words) {
    const char* before = "  - ";
    for (const std::string& line : report::wrapped(words, 92))
      append(to, std::exchange(before, "    ") + line + "\n");
  };
  if (!film.is_solved) return note("not solved: " + film.reason);
  if (!film.no_spike.empty()) note("pressure of the spike: " + film.no_spike);
  if (!film.reason.empty()) note(film.reason);
  note(fmt::format(
      "solved for smooth bodies, {} and a steady, isothermal, Newtonian, "
      "{} liquid whose viscosity follows {}",
      film.is_starved() ? "a layer of oil at the inlet, which the gap conserves,"
                        : "a flooded inlet",
      film.density == "incompressible" ? "incompressible" : "compressible (Dowson and Higginson)",
      film.viscosity == "barus" ? "Barus" : "Roelands"));
  if (std::isfinite(film.friction.value))
    note(
        "friction: the shear stress by friction.fluid and lubricant.eyring_stress, of the liquid "
        "at "
        "each place's own pressure, summed over the contact; the film is that of a Newtonian "
        "liquid "
        "all the same");
  note(
      film.is_line()
          ? "deviation: the formula against the film solved for the liquid that it was fitted to, "
            "which is that of the last column, where it is known; this liquid: the formula against "
            "the film above"
          : fmt::format(
                "this liquid: the formula against the {}; deviation, from the film of the liquid "
                "that the formula was fitted to, is not known, because no text at hand names it",
                film.is_starved() ? "film with a flooded inlet" : "film above"));
  if (!film.closures.empty())
    note("closure: the starved film that it makes from the solved flooded one, over that one");
  if (std::isfinite(film.damiens_exponent))
    note(fmt::format("Damiens' closure gives the solved film ratio with the exponent {:.3g}",
                     film.damiens_exponent));
  if (!film.is_line())
    note("the minimum film lies in the constriction beside the middle or behind it");
  note(fmt::format(
      "± is what the numerical solution may be off by; {} grids, the finest of {} cells",
      film.grids,
      film.is_line() ? std::to_string(film.cells)
                     : fmt::format("{} × {}", film.cells, film.cells_across)));
  if (film.is_line() && (film.viscosity == "barus" || film.density == "incompressible"))
    note(note_on_oil(film));
}

void append_profile(Text& to, const FilmCase& film) {
  const std::vector<ColumnHead> heads{{"x", "[m]", signed_width},
                                      {film.is_line() ? "x/b" : "x/a_x", "[-]", signed_width},
                                      {"pressure", "[Pa]", signed_width},
                                      {"film", "[m]", signed_width}};
  to.push_back('\n');
  append_heads(to, heads);
  for (const ProfilePoint& point : film.profile)
    append_row(to, heads,
               {readable(point.x), readable(point.x / film.half_width), readable(point.pressure),
                readable(point.film)});
}

void append_table(Text& to, const FilmCase& film, bool with_profile) {
  append_title(to, fmt::format("{}: {} contact at {} m/s", film.id,
                               film.is_line() ? "line" : "point", readable(film.speed)));
  const auto add = [&](std::string_view words, const std::string& value, const std::string& error,
                       std::string_view unit, const std::string& part = {}) {
    append(to, fmt::format("  {:<30} {:>14} {:>9}  [{}]{}\n", words, value, error, unit, part));
  };
  for (const Given& one : given)
    if (!std::isnan(film.*one.value))
      add(film.is_line() || one.name != "half_width" ? one.words : "semi-axis by Hertz, a_x",
          readable(film.*one.value), "", one.unit);
  for (const Quantity& one : quantities) {
    const Measured& measured = film.*one.value;
    if (std::isfinite(measured.value))
      add(one.words, with_digits(measured), fmt::format("± {:.1e}", measured.error), one.unit,
          one.kind != Quantity::of_film
              ? ""
              : fmt::format(", ± {:.1g} %", 100 * measured.error / std::abs(measured.value)));
  }
  if (!film.formulas.empty()) append_formulas(to, film);
  if (!film.closures.empty()) append_closures(to, film);
  append_notes(to, film);
  if (with_profile && film.is_solved) append_profile(to, film);
}

// The JSON of one film. Numbers that are not finite are written as null.
ordered_json film_json(const FilmCase& film, bool with_profile) {
  ordered_json json{{"id", film.id}, {"speed", film.speed}};
  for (const Given& one : given)
    if (film.is_starved() || one.name != "inlet_film")
      json[std::string(one.name)] = film.*one.value;
  ordered_json undefined = ordered_json::object();
  for (const Quantity& one : quantities) {
    const std::string name(one.name);
    const Measured& measured = film.*one.value;
    if (one.kind == Quantity::of_supply && !film.is_starved()) continue;
    if (std::isfinite(measured.value)) {
      json[name] = {{"value", measured.value}, {"error", measured.error}};
      continue;
    }
    json[name] = nullptr;
    undefined[name] = !film.is_solved                     ? film.reason
                      : one.kind == Quantity::of_spike    ? film.no_spike
                      : one.kind == Quantity::of_friction ? film.no_friction
                                                          : film.reason;
  }
  json["formulas"] = ordered_json::array();
  for (const FormulaFilm& one : film.formulas)
    json["formulas"].push_back({{"name", one.name},
                                {"film", one.film},
                                {"stands_for", one.stands_for},
                                {"deviation_percent", 100 * one.deviation},
                                {"this_liquid_deviation_percent", 100 * one.this_liquid_deviation},
                                {"fitted_to", one.fitted_to}});
  if (film.is_starved()) {
    ordered_json closures = ordered_json::array();
    for (const ClosureRatio& one : film.closures)
      closures.push_back({{"name", one.closure},
                          {"film_ratio", one.film_ratio},
                          {"deviation_percent", 100 * one.deviation}});
    json["closures"] = std::move(closures);
    json["damiens_exponent"] = film.damiens_exponent;
  }
  json["assumptions"] = {
      {"viscosity", film.viscosity}, {"density", film.density},
      {"bodies", "smooth"},          {"inlet", film.is_starved() ? "starved" : "flooded"},
      {"temperature", "isothermal"}, {"liquid", "newtonian"},
      {"motion", "steady"}};
  json["tolerance"] = film.tolerance;
  json["grids"] = film.grids;
  json["cells"] = film.cells;
  if (!film.is_line()) json["cells_across"] = film.cells_across;
  json["newton_steps"] = film.steps;
  if (!film.reason.empty()) json["reason"] = film.reason;
  if (!undefined.empty()) json["undefined"] = std::move(undefined);
  if (with_profile && film.is_solved) json["profile"] = profile_json(film);
  return json;
}

}  // namespace

ordered_json film_picture_json(const FilmCase& film) {
  ordered_json json = film_json(film, true);
  if (!film.fields.x.empty())
    json["fields"] = {{"x", film.fields.x},
                      {"y", film.fields.y},
                      {"pressure", film.fields.pressure},
                      {"film", film.fields.film}};
  return json;
}

FilmWriter::FilmWriter(std::string_view format, bool with_profile, Text& text)
    : format_(format), with_profile_(with_profile), text_(text), before_("") {
  if (format == "json")
    append(text_, list_start("film/1", "films"));
  else if (format == "csv" && with_profile)
    append(text_, "id,speed,x,x_over_half_width,pressure,film\n");
  else if (format == "csv")
    append_csv_heads(text_);
}

std::string FilmWriter::text_of(const FilmCase& film) const {
  Text text;
  if (format_ == "json")
    append(text, film_json(film, with_profile_)
                     .dump(-1, ' ', false, ordered_json::error_handler_t::replace));
  else if (format_ == "table")
    append_table(text, film, with_profile_);
  else if (with_profile_)
    append_csv_profile(text, film);
  else
    append_csv(text, film);
  return fmt::to_string(text);
}

void FilmWriter::add(std::string_view film) {
  if (format_ != "csv")
    append(text_, std::exchange(before_, format_ == "table" ? "\n" : list_comma));
  append(text_, film);
}

void FilmWriter::finish(const ordered_json& warnings) {
  if (format_ == "json") append(text_, list_end_with({{"warnings", warnings}}));
}

}  // namespace tribo::cli
