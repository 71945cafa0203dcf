// SPDX-License-Identifier: Apache-2.0
// tribocheck contact: tells the numbers of a contact, before any curve is computed.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "build_info.hpp"
#include "catalogue/law_films.hpp"
#include "command.hpp"
#include "messages.hpp"
#include "options.hpp"
#include "page/text_table.hpp"
#include "page/texts.hpp"
#include "scene_arguments.hpp"
#include "table.hpp"
#include "tribo/contact_regime.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/onset.hpp"
#include "tribo/smooth_contact.hpp"
#include "tribo/thermal_reduction.hpp"

// Sources are compiled together: names that other sources have too are in their own namespace.
namespace tribo::cli::contact_account {
namespace {

using nlohmann::ordered_json;
using report::padded;

// Why something is undefined. `brief` stands in its line of the table. `sentence` stands once below
// the table, and in CSV and JSON; if it is empty, CSV and JSON have `brief`.
struct Reason {
  std::string_view brief, sentence = {};

  std::string_view whole() const { return sentence.empty() ? brief : sentence; }
};

// A number or a word about a contact, in SI units. If it is undefined, the value is null and
// `reason` says why. `note`: what the value means for the contact; may be empty.
struct Fact {
  std::string_view name, symbol, meaning;
  ordered_json value;
  std::string_view unit = {};
  Reason reason = {};
  std::string note = {};
};
using Facts = std::vector<Fact>;

struct AtSpeed {
  double speed;  // m/s
  Facts numbers, ratios;
  std::vector<catalogue::LawFilm> films;
};

struct ContactAccount {
  std::string_view id;
  bool is_line;
  Facts contact, surfaces, lubricant;
  std::vector<AtSpeed> speeds;
  std::vector<Validity> validity;
};

// A scene, and the objects from which all parts of its account are computed.
struct Asked {
  explicit Asked(const Scene& given) : scene(given), contact(given), smooth(contact) {}

  const detail::SceneNumbers<double>& numbers() const { return contact.scene_numbers(); }
  ContactShape shape() const { return scene.bodies.shape(); }
  bool is_line() const { return shape() == ContactShape::line; }

  const Scene& scene;
  MixedContact<double> contact;
  SmoothContact smooth;
};

// The fact of a number. It is undefined beyond the range of double, as for extreme contacts.
Fact number(std::string_view name, std::string_view symbol, std::string_view meaning, double value,
            std::string_view unit = {}) {
  if (std::isfinite(value)) return {name, symbol, meaning, value, unit};
  return {name, symbol, meaning, nullptr, unit, {protocol::beyond_double}};
}

constexpr Reason no_approach{"a line has none", "of a line it depends on the whole bodies"};
constexpr Reason no_roughness{
    "no Rq is given",
    "the scene has none of surface.rms_roughness, surface.average_roughness and surface.m0"};
constexpr Reason no_summits{"no summits are given"};

// The note of a value that the scene does not give.
constexpr std::string_view is_default = "the default";

Facts contact_of(const Asked& asked) {
  // In the order of ContactShape.
  constexpr std::array<std::string_view, 3> shapes{"circle", "ellipse", "line"};
  const auto& scene = asked.numbers();
  const HertzContact<double> hertz = asked.contact.hertz();
  Facts facts{
      {"shape", "", "shape of the contact", shapes[static_cast<std::size_t>(asked.shape())]},
      number("effective_modulus", "E*", "effective modulus", scene.effective_modulus, "Pa")};
  switch (asked.shape()) {
    case ContactShape::circle:
      facts.push_back(number("radius_x", "R", "reduced radius", scene.radius_x, "m"));
      facts.push_back(number("semi_axis_x", "a", "radius of the contact", hertz.semi_axis_x, "m"));
      break;
    case ContactShape::ellipse:
      if (std::abs(hertz.semi_axis_y / hertz.semi_axis_x - 1) < 1e-9)
        facts.front().note = "a circle, as both radii are alike";
      facts.push_back(
          number("radius_x", "R_x", "reduced radius along entrainment", scene.radius_x, "m"));
      facts.push_back(number("radius_y", "R_y", "reduced radius across it", scene.across, "m"));
      facts.push_back(number("semi_axis_x", "a_x", "half the contact's size along entrainment",
                             hertz.semi_axis_x, "m"));
      facts.push_back(number("semi_axis_y", "a_y", "half the contact's size across it",
                             hertz.semi_axis_y, "m"));
      break;
    case ContactShape::line:
      facts.push_back(
          number("radius_x", "R", "reduced radius along entrainment", scene.radius_x, "m"));
      facts.push_back(number("length", "L", "length of the line", scene.across, "m"));
      facts.push_back(
          number("semi_axis_x", "b", "half the width of the contact", hertz.semi_axis_x, "m"));
  }
  if (!asked.is_line())
    facts.push_back(number("ellipticity", "a_y/a_x", "ellipticity of the contact",
                           hertz.semi_axis_y / hertz.semi_axis_x));
  facts.push_back(number("nominal_area", "A_nom", "area of the contact", hertz.nominal_area, "m²"));
  facts.push_back(
      number("peak_pressure", "p₀", "greatest Hertz pressure", hertz.peak_pressure, "Pa"));
  facts.push_back(number("mean_pressure", "p_m", "mean Hertz pressure", hertz.mean_pressure, "Pa"));
  if (asked.is_line())
    facts.push_back({"approach", "", "approach of the bodies", nullptr, "m", no_approach});
  else
    facts.push_back(number("approach", "", "approach of the bodies", hertz.approach, "m"));
  return facts;
}

Facts surfaces_of(const Asked& asked) {
  const double sd = asked.contact.summit_height_sd(), roughness = asked.numbers().rms_roughness;
  const LoadSharing<double> sharing = asked.contact.sharing();
  Facts facts;
  constexpr std::string_view rms = "roughness of both faces together";
  if (roughness > 0)
    facts.push_back(number("rms_roughness", "Rq", rms, roughness, "m"));
  else
    facts.push_back({"rms_roughness", "Rq", rms, nullptr, "m", no_roughness});
  constexpr std::string_view heights = "standard deviation of the summits' heights";
  if (asked.scene.surface.is_smooth())
    facts.push_back({"summit_height_sd", "σ_s", heights, nullptr, "m", no_summits});
  else
    facts.push_back(number("summit_height_sd", "σ_s", heights, sd, "m"));
  if (asked.scene.surface.is_smooth()) return facts;
  facts.push_back(number("stiffness", "K", "stiffness of the summits", sharing.stiffness()));
  facts.push_back(
      number("offset", "δ", "plane of heights to plane of summits, over σ_s", sharing.offset()));
  if (asked.numbers().summit_plane_offset > 0) {
    const int planes = asked.scene.surface.offset_planes;
    facts.push_back({"offset_planes", "m", "faces that bring the offset of the summits", planes});
    const bool is_own = asked.scene.surface.gives_offset_planes;
    if (!is_own) facts.back().note = is_default;
    if (!is_own && asked.scene.closures.asperity == AsperityModel::greenwood_tripp)
      facts.back().note += ", of one face; where both faces are rough alike, both bring it";
  }
  const double share = sharing.asperity_share(0);
  facts.push_back(
      number("share_without_film", "A(0)", "load share of the summits without a film", share));
  if (share < 1)
    facts.back().note = fmt::format(
        "they carry at most {:.0f} % of the load, and friction at low speed comes out below the "
        "boundary coefficient",
        100 * share);
  facts.push_back(number("floor", "λ_b σ_s", "least film that the summits allow; 0: none",
                         sharing.floor() * sd, "m"));
  return facts;
}

// The oil at the temperature at which the contact runs; with ν and T if the scene has them.
Facts lubricant_of(const Asked& asked) {
  const Oil& oil = asked.scene.lubricant.oil;
  const auto& scene = asked.numbers();
  Facts facts;
  if (oil.is_given())
    facts.push_back(number("temperature", "T", "temperature of the contact", oil.temperature, "K"));
  if (oil.density > 0)
    facts.push_back(number("kinematic_viscosity", "ν", "kinematic viscosity there",
                           scene.viscosity / oil.density, "m²/s"));
  facts.push_back(
      number("viscosity", "η₀", "viscosity at ambient pressure", scene.viscosity, "Pa·s"));
  facts.push_back(number("pressure_viscosity", "α", "how pressure thickens the oil",
                         scene.pressure_viscosity, "1/Pa"));
  const bool is_heated = asked.scene.lubricant.thermal != ThermalInlet::none;
  if (is_heated || asked.scene.outputs.contains(Output::friction)) {
    facts.push_back(number(
        "slide_roll_ratio", "S",
        is_heated ? "sliding over speed, which heats the inlet" : "sliding over speed, of friction",
        scene.slide_roll_ratio));
    if (!asked.scene.friction.gives_slide_roll_ratio)
      facts.back().note = fmt::format("{}, as much sliding as rolling", is_default);
  }
  if (asked.scene.supply.kind != SupplyKind::flooded) {
    const StarvationClosure closure = asked.scene.closures.starvation;
    facts.push_back({"starvation", "", "law of the inlet with little oil",
                     starvation_words[static_cast<std::size_t>(closure)]});
    if (!asked.scene.closures.gives_starvation) facts.back().note = is_default;
  }
  return facts;
}

// The regime that common practice names for Λ.
std::string_view word_of_lambda(double ratio) {
  if (ratio < least_mixed_lambda_ratio) return "boundary or mixed lubrication";
  return ratio < least_full_film_lambda_ratio ? "mixed lubrication" : "full film";
}

AtSpeed account_at(const Asked& asked, double speed) {
  const auto& scene = asked.numbers();
  const SimilarityNumbers<double> numbers = similarity_of(asked.shape(), scene, speed);
  const MoesNumbers<double> moes = moes_numbers(numbers, asked.is_line());
  const LubricationRegime regime = regime_of(asked.shape(), scene, numbers);
  AtSpeed account{speed, {}, {}, catalogue::law_films(asked.contact, speed)};
  account.numbers = {
      number("speed_number", "U", "Hamrock and Dowson's number of the speed", numbers.speed),
      number("material_number", "G", "their number of the materials", numbers.material),
      number("load_number", "W", "their number of the load", numbers.load),
      number("moes_load_number", "M", "Moes' number of the load", moes.load),
      number("moes_material_number", "L", "Moes' number of the materials", moes.material)};
  if (!asked.is_line()) {
    const RegimeNumbers<double> map = regime_numbers(numbers);
    account.numbers.push_back(
        number("viscosity_parameter", "g_V", "number of the viscosity's rise", map.viscosity));
    account.numbers.push_back(
        number("elasticity_parameter", "g_E", "number of the bodies' flattening", map.elasticity));
  }
  account.numbers.push_back({"ehl_regime", "",
                             asked.is_line() ? "EHL regime, of the film (Moes' map)"
                                             : "EHL regime, of the film (Hamrock's map)",
                             name(regime)});
  OutputSet outputs;
  for (const Output output : {Output::film, Output::film_parameter, Output::inlet})
    outputs.insert(output);
  const OperatingPoint<double> point = asked.contact.solve(speed, outputs);
  if (asked.scene.lubricant.thermal != ThermalInlet::none)
    account.ratios.push_back(
        number("thermal_reduction", "φ_T", "film of the heated inlet over that of a cold one",
               gupta_thermal_reduction(asked.contact.hertz().peak_pressure, scene.effective_modulus,
                                       scene.slide_roll_ratio, scene.temperature_coefficient,
                                       scene.viscosity, speed, scene.conductivity)));
  account.ratios.insert(
      account.ratios.end(),
      {number("film", "h*", "the scene's film, with load sharing and its inlet", point.film, "m"),
       asked.scene.surface.is_smooth()
           ? Fact{"film_parameter", "λ", "h*/σ_s", nullptr, "", no_summits}
           : number("film_parameter", "λ", "h*/σ_s", point.film_parameter),
       number("minimum_film", "h_min", "least film, beside h*",
              asked.smooth.minimum_film(speed, point.film), "m")});
  const bool has_collapsed = point.inlet == Inlet::collapsed;
  if (has_collapsed) {
    const auto is_film = [](const Fact& fact) { return fact.name == "film"; };
    std::find_if(account.ratios.begin(), account.ratios.end(), is_film)->note =
        "the film has collapsed, as the inlet has too little oil";
  }
  if (scene.rms_roughness > 0) {
    const double ratio = asked.smooth.value(Output::lambda_ratio, speed, point.film);
    account.ratios.push_back(number("lambda_ratio", "Λ", "h_min/Rq", ratio));
    if (std::isfinite(ratio) && !has_collapsed) account.ratios.back().note = word_of_lambda(ratio);
  } else
    account.ratios.push_back({"lambda_ratio", "Λ", "h_min/Rq", nullptr, "", no_roughness});
  return account;
}

// The speeds that are told, from slow to fast, each once: all speeds of a scene that has at most
// four, else the slowest and the fastest. Empty if the scene has none.
std::vector<double> told_speeds(const Speeds& speeds) {
  constexpr std::size_t most = 4;
  std::vector<double> told;
  if (speeds.size() <= most) {
    for (std::size_t i = 0; i < speeds.size(); ++i) told.push_back(speeds[i]);
  } else {
    const detail::SpeedSpan span = detail::speed_span(speeds);
    told = {span.low, span.high};
  }
  std::sort(told.begin(), told.end());
  told.erase(std::unique(told.begin(), told.end()), told.end());
  return told;
}

ContactAccount account_of(const Asked& asked) {
  ContactAccount account{asked.scene.id,
                         asked.is_line(),
                         contact_of(asked),
                         surfaces_of(asked),
                         lubricant_of(asked),
                         {},
                         validity_of(asked.scene, SceneUse::onset)};
  for (const double speed : told_speeds(asked.scene.speeds))
    account.speeds.push_back(account_at(asked, speed));
  return account;
}

// --- Tables

// A number in the unit that people use for it: "1.077 GPa", "148.9 µm".
std::string usual(double value, std::string_view unit) {
  struct Scale {
    std::string_view unit, usual;
    double least, factor;
  };
  constexpr auto scales = std::to_array<Scale>({{"Pa", "GPa", 1e8, 1e-9},
                                                {"Pa", "MPa", 1e5, 1e-6},
                                                {"m", "m", 1, 1},
                                                {"m", "mm", 1e-3, 1e3},
                                                {"m", "µm", 1e-6, 1e6},
                                                {"m", "nm", 1e-10, 1e9},
                                                {"m²", "mm²", 1e-12, 1e6},
                                                {"m²/s", "mm²/s", 1e-9, 1e6},
                                                {"Pa·s", "Pa·s", 10, 1},
                                                {"Pa·s", "mPa·s", 1e-6, 1e3},
                                                {"1/Pa", "1/GPa", 1e-12, 1e9}});
  if (unit == "K") return fmt::format("{:.4g} °C", value - 273.15);
  for (const Scale& scale : scales)
    if (scale.unit == unit && std::abs(value) >= scale.least)
      return fmt::format("{:.4g} {}", value * scale.factor, scale.usual);
  return fmt::format("{:.4g}{}{}", value, unit.empty() ? "" : " ", unit);
}

std::string text_of(const Fact& fact) {
  if (fact.value.is_null()) return fmt::format("undefined: {}", fact.reason.brief);
  if (fact.value.is_string()) return fact.value.get<std::string>();
  return usual(fact.value.get<double>(), fact.unit);
}

void append_facts(Text& to, const Facts& facts) {
  for (const Fact& fact : facts) {
    std::string words(fact.meaning);
    if (!fact.symbol.empty()) words = fmt::format("{}, {}", fact.symbol, words);
    const std::string note = fact.note.empty() ? "" : ": " + fact.note;
    append_line(to, fmt::format("  {}  {}{}", padded(words, 53), text_of(fact), note));
  }
}

void append_films(Text& to, const std::vector<catalogue::LawFilm>& films) {
  append_line(to, fmt::format("  {}  {}  {}  {}", padded("film of smooth faces, flooded, by", 42),
                              padded("it is", 7), padded("film", 10), "inside its range"));
  for (const catalogue::LawFilm& film : films) {
    const std::string law =
        fmt::format("{}{}", film.law, film.is_of_scene ? " (this scene's)" : "");
    append_line(
        to,
        fmt::format(
            "  {}  {}  {}  {}", padded(law, 42), film.is_minimum ? "minimum" : "central",
            padded(std::isfinite(film.film) ? usual(film.film, "m") : "-", 10),
            film.beyond.empty() ? "yes" : (film.is_known ? "no: " : "not known: ") + film.beyond));
  }
}

// Each reason's sentence once, after the meaning of the first fact that has it.
void append_reasons(Text& to, const ContactAccount& account) {
  std::vector<const Fact*> told;
  const auto tell = [&](const Facts& facts) {
    for (const Fact& fact : facts) {
      const auto is_same = [&](const Fact* one) {
        return one->reason.sentence == fact.reason.sentence;
      };
      if (fact.reason.sentence.empty() || std::any_of(told.begin(), told.end(), is_same)) continue;
      if (told.empty()) append(to, "\n");
      told.push_back(&fact);
      append_line(to, fmt::format("  - {}: {}", fact.meaning, fact.reason.sentence));
    }
  };
  tell(account.contact);
  tell(account.surfaces);
  for (const AtSpeed& at : account.speeds) tell(at.ratios);
}

constexpr std::string_view film_hint =
    "  These formulas scatter: `tribocheck film` solves the line, and says how far off each is.";

constexpr std::string_view about_ratios =
    "  λ says how deep the summits reach into the film: the model's shares of the load follow from "
    "it.\n"
    "  Λ compares the least film, which is h* times the part that the law of the least film is of "
    "the\n"
    "  scene's law, with the roughness that a profiler measures: catalogues of bearings and gears "
    "mean\n"
    "  it. By common practice Λ below 1 is boundary or mixed lubrication, 1 to 3 mixed, and from 3 "
    "on a\n"
    "  full film. λ and Λ are different numbers.\n";

void append_table(Text& to, const ContactAccount& account) {
  append_title(to, fmt::format("{}: the dry, smooth contact (Hertz)", account.id));
  append_facts(to, account.contact);
  append(to, "\n");
  append_title(to, fmt::format("{}: the rough faces", account.id));
  append_facts(to, account.surfaces);
  append(to, "\n");
  append_title(to, fmt::format("{}: the oil", account.id));
  append_facts(to, account.lubricant);
  for (const AtSpeed& at : account.speeds) {
    append(to, "\n");
    append_title(to, fmt::format("{}: at {} m/s", account.id, readable(at.speed)));
    append_facts(to, at.numbers);
    append(to, "\n");
    append_films(to, at.films);
    if (account.is_line) append_line(to, film_hint);
    append(to, "\n");
    append_facts(to, at.ratios);
  }
  if (account.speeds.empty())
    append(to, "\n  Films and regimes need a speed, which this scene does not have.\n");
  else
    append(to, fmt::format("\n{}", about_ratios));
  append_reasons(to, account);
  append(to, "\n");
  append_validity(to, account.id, account.validity);
}

// --- CSV and JSON

void append_csv(Text& to, const ContactAccount& account) {
  const std::string id = report::csv_text(account.id);
  const auto add = [&](const std::string& speed, std::string_view part, const Facts& facts) {
    for (const Fact& fact : facts) {
      const std::string value = fact.value.is_number()   ? report::exact(fact.value.get<double>())
                                : fact.value.is_string() ? fact.value.get<std::string>()
                                                         : std::string();
      append(to,
             fmt::format("{},{},{},{},{},{},{},{}\n", id, speed, part, fact.name, value, fact.unit,
                         report::csv_text(fact.meaning), report::csv_text(fact.reason.whole())));
    }
  };
  add("", "contact", account.contact);
  add("", "surfaces", account.surfaces);
  add("", "lubricant", account.lubricant);
  for (const AtSpeed& at : account.speeds) {
    const std::string speed = report::exact(at.speed);
    add(speed, "numbers", at.numbers);
    for (const catalogue::LawFilm& film : at.films)
      append(to, fmt::format("{},{},films,{},{},m,{},{}\n", id, speed, film.law,
                             std::isfinite(film.film) ? report::exact(film.film) : "",
                             film.is_minimum ? "minimum film" : "central film",
                             report::csv_text(film.beyond)));
    add(speed, "ratios", at.ratios);
  }
}

ordered_json json_of(const Facts& facts) {
  ordered_json list = ordered_json::array();
  for (const Fact& fact : facts)
    list.push_back({{"name", fact.name},
                    {"symbol", fact.symbol},
                    {"value", fact.value},
                    {"unit", fact.unit},
                    {"meaning", fact.meaning},
                    {"undefined", fact.reason.whole()},
                    {"note", fact.note}});
  return list;
}

ordered_json json_of(const std::vector<catalogue::LawFilm>& films) {
  ordered_json list = ordered_json::array();
  for (const catalogue::LawFilm& film : films)
    list.push_back({{"law", film.law},
                    {"kind", film.is_minimum ? "minimum" : "central"},
                    {"film", std::isfinite(film.film) ? ordered_json(film.film) : nullptr},
                    {"is_inside_range",
                     film.is_known ? ordered_json(film.beyond.empty()) : ordered_json(nullptr)},
                    {"beyond", film.beyond},
                    {"is_of_scene", film.is_of_scene},
                    {"source", film.source}});
  return list;
}

void append_json(Text& to, const ContactAccount& account) {
  ordered_json speeds = ordered_json::array();
  for (const AtSpeed& at : account.speeds)
    speeds.push_back({{"speed", at.speed},
                      {"numbers", json_of(at.numbers)},
                      {"films", json_of(at.films)},
                      {"ratios", json_of(at.ratios)}});
  const ordered_json told{{"id", account.id},
                          {"contact", json_of(account.contact)},
                          {"surfaces", json_of(account.surfaces)},
                          {"lubricant", json_of(account.lubricant)},
                          {"speeds", std::move(speeds)},
                          {"validity", validity_json(account.validity)}};
  append(to, without_controls(told.dump(-1, ' ', false, ordered_json::error_handler_t::replace)));
}

struct ContactArguments : SceneArguments {
  double speed = 0;  // 0: the scene's
};

int tell_contacts(const ContactArguments& arguments, OutputStream& output) {
  const LoadedScenes loaded = load_scenes(
      arguments.paths, SceneUse::onset,
      [&arguments](Scene& scene) {
        if (arguments.speed > 0) scene.speeds = {.list = {arguments.speed}};
        return std::string();
      },
      arguments.format != "csv");
  if (loaded.scenes.empty()) return exit_bad;
  Text& text = output.text();
  const bool is_json = arguments.format == "json", is_csv = arguments.format == "csv";
  if (is_csv) append(text, "id,speed,part,name,value,unit,meaning,reason\n");
  std::string before = is_json ? list_start("contact/1", "scenes") : "";
  for (const Scene& scene : loaded.scenes) {
    append(text, std::exchange(before, is_json ? list_comma : is_csv ? "" : "\n"));
    (is_json ? append_json : is_csv ? append_csv : append_table)(text, account_of(Asked(scene)));
    output.end_row();
  }
  if (is_json) append(text, list_end_with({{"warnings", loaded.warnings.json()}}));
  return loaded.exit_code(arguments);
}

constexpr const char* footer =
    R"(Told are the size, pressures and approach of the dry, smooth contact (Hertz); the rough faces: Rq, σ_s,
and K, δ and the floor, the least distance that the summits allow; the oil at its temperature; and at
the speeds of a scene, of more than four at the slowest and the fastest, U, G and W, Moes' M and L,
the regime of the film, the film by each law of this shape of contact and whether it is inside the
range of that law, λ = h*/σ_s and Λ = h_min/Rq. A scene may be without a speed: then only what does
not depend on it is told.

The table has units that people use; CSV and JSON have SI units, and numbers that read back to the
same double. The regime is the one whose formula gives the film: of points the thickest by
Hamrock (1991), of lines by the map of Moes (1992), where bodies that give way thin the film.

To have these numbers at each speed, beside others: outputs = ["peak_pressure", "mean_pressure",
"minimum_film", "lambda_ratio"] in a scene, and `solve`, `curve`, `stream` or `sweep`.

Example:
  tribocheck contact reference/scenes/bearing_outer_ring.toml
  tribocheck contact reference/published/rough.toml --format json)";

}  // namespace
}  // namespace tribo::cli::contact_account

namespace tribo::cli {

Command add_contact(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("contact", "what a contact is: Hertz pressure, regime, films, Λ");
  app->footer(footer_with_scenes(contact_account::footer));
  const auto arguments = std::make_shared<contact_account::ContactArguments>();
  add_scene_arguments(*app, *arguments);
  add_speed_option(*app, [arguments](double speed) { arguments->speed = speed; });
  return {app, [arguments](OutputStream& output) {
            return contact_account::tell_contacts(*arguments, output);
          }};
}

}  // namespace tribo::cli
