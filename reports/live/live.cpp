// SPDX-License-Identifier: Apache-2.0
// The model as the page calls it, in WebAssembly. One scene is held at a time, and the calls ask
// about it. A call returns either a text, which consists of lines of cells with tabs between them
// and ends with a 0, or doubles, row by row. Both are valid until the next call. No call throws. A
// text for a call is written into the memory that live_room() returns.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue/catalogue.hpp"
#include "catalogue/law_films.hpp"
#include "live/least_films.hpp"
#include "protocol/output_values.hpp"
#include "scene/schema.hpp"
#include "scene/text.hpp"
#include "tribo/contact_regime.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/onset.hpp"
#include "tribo/scene_reader.hpp"
#include "tribo/smooth_contact.hpp"
#include "tribo/validity.hpp"

#define TRIBOCHECK_CALL(name) extern "C" __attribute__((export_name(#name)))

namespace {

using namespace tribo;

// A scene with its contact prepared.
struct Prepared {
  explicit Prepared(const Scene& given) : scene(given), contact(given), smooth(contact) {}

  bool is_line() const { return contact.words().shape == ContactShape::line; }

  Scene scene;
  MixedContact<double> contact;
  SmoothContact smooth;
};

std::string room, answer;
std::vector<double> answer_numbers;
std::optional<Prepared> held;

void cell(std::string_view text) { answer += text; }
void cell(const char* text) { answer += text; }
void cell(double number) { answer += scene_detail::number_text(number); }
void cell(bool is) { answer += is ? '1' : '0'; }

template <class First, class... Rest>
void line(const First& first, const Rest&... rest) {
  cell(first);
  ((answer += '\t', cell(rest)), ...);
  answer += '\n';
}

std::string_view type_of(FieldType type) {
  switch (type) {
    case FieldType::number:
      return "number";
    case FieldType::integer:
      return "integer";
    case FieldType::choice:
      return "choice";
    default:
      return "other";
  }
}

std::string joined(std::span<const std::string_view> words) {
  std::string text;
  for (const std::string_view word : words) text += (text.empty() ? "" : " ") + std::string(word);
  return text;
}

// The tables of starved films are not in the page.
constexpr std::string_view not_here =
    "\"solved\" needs the tables of solved starved films, which this page does not have: ask the "
    "program, tribocheck solve";

// --- Certified rows

constexpr std::string_view certified_rows =
#include "certified_rows.inc"
    ;

// Removes from `text` the part before the next separator, and the separator. Returns that part.
std::string_view cut(std::string_view& text, char separator) {
  const std::size_t end = std::min(text.find(separator), text.size());
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return part;
}

double number_of(std::string_view text) { return std::strtod(std::string(text).c_str(), nullptr); }

// The question of a row, kept for the rows after it that give no arguments.
struct Asked {
  catalogue::Arguments arguments{};
  std::optional<OperatingPoint<double>> point;
};

void ask(const catalogue::Function* function, std::string_view arguments, Asked& asked) {
  Scene scene;
  double speed = 0;
  while (!arguments.empty()) {
    std::string_view text = cut(arguments, ',');
    const std::string_view name = cut(text, '=');
    if (function != nullptr) {
      for (std::size_t i = 0; i < function->parameters.size(); ++i)
        if (function->parameters[i].name == name)
          asked.arguments[i] =
              catalogue::place_of(text, function->parameters[i]).value_or(number_of(text));
      continue;
    }
    const std::size_t field = scene_detail::field_at(name);
    const auto& choices = scene_fields()[field].choices;
    const auto word = std::find(choices.begin(), choices.end(), text);
    const double value =
        choices.empty() ? number_of(text) : static_cast<double>(word - choices.begin());
    if (name == "speed") speed = value;
    scene_detail::store_of(field)(scene, value);
  }
  if (function == nullptr) asked.point = MixedContact<double>(scene).solve(speed);
}

double result_of(const catalogue::Function* function, std::string_view output, const Asked& asked) {
  if (function == nullptr)
    return numbers_of(*asked.point)[static_cast<std::size_t>(*output_by_name(output))];
  catalogue::Results results{};
  function->value(asked.arguments, results);
  for (std::size_t i = 0; i < function->results.size(); ++i)
    if (function->results[i].name == output) return results[i];
  return results[0];
}

// |got − (high + low)| in units in the last place of `high`.
double error_in_ulp(double got, double high, double low) {
  const double spacing = std::nextafter(std::fabs(high), HUGE_VAL) - std::fabs(high);
  return std::fabs((got - high) - low) / spacing;
}

}  // namespace

// Room for a text of so many bytes.
TRIBOCHECK_CALL(live_room) char* live_room(std::size_t bytes) {
  room.assign(bytes, '\0');
  return room.data();
}

// The fields of a scene that are a number or a choice: path, type, unit, whether it takes per cent,
// least and greatest physical value, words, default, meaning, what is allowed.
TRIBOCHECK_CALL(live_fields) const char* live_fields() {
  answer.clear();
  for (const FieldInfo& field : scene_fields())
    if (type_of(field.type) != "other")
      line(field.path, type_of(field.type), field.unit, field.takes_per_cent,
           field.plausible_minimum, field.plausible_maximum, joined(field.choices),
           field.default_text, field.meaning, scene_detail::allowed_text(field));
  return answer.c_str();
}

// Reads the TOML text in the memory of live_room(). The cells of a line are "error" or "warning",
// the field, and the sentence. The scene is held if there is no line with "error"; else none is
// held.
TRIBOCHECK_CALL(live_read) const char* live_read() {
  answer.clear();
  held.reset();
  SceneReading reading = parse_scene_toml(room, "scene", SceneUse::speeds);
  for (const InputProblem& one : reading.errors) line("error", one.field, one.message());
  for (const InputProblem& one : reading.warnings) line("warning", one.field, one.message());
  if (!reading.scene) return answer.c_str();
  if (reading.scene->supply.kind != SupplyKind::flooded &&
      reading.scene->closures.starvation == StarvationClosure::solved)
    line("error", "closures.starvation", not_here);
  else
    held.emplace(*reading.scene);
  return answer.c_str();
}

// The numbers and words of the held scene, given or computed, a line each: path and value. The
// first lines are its id, its shape, and the ends of its range of speeds.
TRIBOCHECK_CALL(live_values) const char* live_values() {
  answer.clear();
  if (!held) return answer.c_str();
  constexpr auto shapes = std::to_array<std::string_view>({"circle", "ellipse", "line"});
  const auto shape = held->contact.words().shape;
  line("id", held->scene.id);
  line("shape", shapes[static_cast<std::size_t>(shape)]);
  const detail::SpeedSpan span = detail::speed_span(held->scene.speeds);
  line("low", span.low);
  line("high", span.high);
  for (std::size_t i = 0; i < scene_fields().size(); ++i) {
    const FieldInfo& field = scene_fields()[i];
    const auto value = scene_detail::value_in(held->scene, i);
    if (type_of(field.type) == "other" || !value) continue;
    if (field.choices.empty())
      line(field.path, *value);
    else
      line(field.path, field.choices[static_cast<std::size_t>(*value)]);
  }
  return answer.c_str();
}

// The contact before any speed: name, symbol, meaning, value, unit.
TRIBOCHECK_CALL(live_contact) const char* live_contact() {
  answer.clear();
  if (!held) return answer.c_str();
  const auto hertz = held->contact.hertz();
  line("semi_axis_x", held->is_line() ? "b" : "a_x", "half the contact's size along entrainment",
       hertz.semi_axis_x, "m");
  if (!held->is_line())
    line("semi_axis_y", "a_y", "half the contact's size across it", hertz.semi_axis_y, "m");
  if (!held->scene.surface.is_smooth()) {
    const LoadSharing<double> sharing = held->contact.sharing();
    line("share_without_film", "A(0)", "load share of the summits without a film",
         sharing.asperity_share(0), "");
    line("floor", "λ_b σ_s", "least film that the summits allow; 0: none",
         sharing.floor() * held->contact.summit_height_sd(), "m");
  }
  return answer.c_str();
}

// The outputs: name, unit, meaning, words.
TRIBOCHECK_CALL(live_outputs) const char* live_outputs() {
  answer.clear();
  for (const OutputInfo& output : output_infos)
    line(output.name, output.unit, output.meaning, joined(output.words));
  return answer.c_str();
}

// `count` points at even steps of the logarithm of the speed in m/s. The first speed is exactly
// `low`, the last exactly `high`. A row is the speed and then all outputs; a word is given by its
// place in the list of words. NaN: the output is undefined, or the scene lacks the inputs of
// friction. Null where no scene is held.
TRIBOCHECK_CALL(live_points) const double* live_points(double low, double high, std::size_t count) {
  answer_numbers.clear();
  if (!held) return nullptr;
  Speeds speeds;
  if (count == 1)
    speeds.list = {low};
  else
    speeds = {{}, low, high, count, Spacing::log};
  const bool has_friction = has_friction_inputs(held->scene);
  for (std::size_t i = 0; i < count; ++i) {
    const OperatingPoint<double> point = held->contact.solve(speeds[i]);
    answer_numbers.push_back(point.speed);
    for (const OutputInfo& output : output_infos) {
      const auto value = protocol::value_of(point, &held->smooth, output.output);
      const auto place = std::find(output.words.begin(), output.words.end(), value.word);
      const bool is_there =
          value.undefined.empty() && (output.output != Output::friction || has_friction);
      answer_numbers.push_back(!is_there ? quiet_nan<double>()
                               : value.word.empty()
                                   ? value.number
                                   : static_cast<double>(place - output.words.begin()));
    }
  }
  return answer_numbers.data();
}

// The outputs that are undefined at a speed, a line each: output, reason.
TRIBOCHECK_CALL(live_undefined) const char* live_undefined(double speed) {
  answer.clear();
  if (!held) return answer.c_str();
  const OperatingPoint<double> point = held->contact.solve(speed);
  for (const OutputInfo& output : output_infos)
    if (const auto value = protocol::value_of(point, &held->smooth, output.output);
        !value.undefined.empty())
      line(output.name, value.undefined);
  return answer.c_str();
}

// The onsets of starvation: criterion, meaning, speed, film, λ, and the reason if there is none.
TRIBOCHECK_CALL(live_onsets) const char* live_onsets() {
  answer.clear();
  if (!held) return answer.c_str();
  for (const CriterionInfo& info : onset_criteria) {
    const Onset<double> found =
        onset(held->contact, held->scene, info.criterion, default_departure);
    if (found.exists)
      line(info.name, info.meaning, found.speed, found.film, found.film_parameter, "");
    else
      line(info.name, info.meaning, "", "", "", found.reason);
  }
  return answer.c_str();
}

// The table "is the model valid here?" at a speed: word, assumption, value, least, greatest, unit,
// whether it holds, what it touches, advice, field, unit that was perhaps meant.
TRIBOCHECK_CALL(live_limits) const char* live_limits(double speed) {
  answer.clear();
  if (!held) return answer.c_str();
  Scene here = held->scene;
  here.speeds = {};
  here.speeds.list = {speed};
  for (const Validity& one : validity_of(here))
    line(one.word, one.assumption, one.value, one.least, one.greatest, one.unit, one.holds(),
         one.touches, one.advice, one.field, one.likely_unit);
  return answer.c_str();
}

// Films of smooth faces in a flooded inlet at a speed: law, whether it is of the least film, film
// in m, why the contact is beyond its range, whether it is the scene's. The last two lines,
// "solved", have the central and the least film of the solved tables.
TRIBOCHECK_CALL(live_films) const char* live_films(double speed) {
  answer.clear();
  if (!held) return answer.c_str();
  for (const catalogue::LawFilm& film : catalogue::law_films(held->contact, speed))
    line(film.law, film.is_minimum, film.film, film.beyond, film.is_of_scene);
  const FilmLaw& solved = film_law(FilmFormula::solved, held->is_line());
  const auto& scene = held->contact.scene_numbers();
  const ContactShape shape = held->contact.words().shape;
  const bool is_table = shape != ContactShape::ellipse && scene.pressure_viscosity > 0;
  const double film = is_table ? smooth_film(solved, shape, scene, speed) : quiet_nan<double>();
  const MoesNumbers<double> moes =
      moes_numbers(similarity_of(shape, scene, speed), held->is_line());
  const auto number = [log_load = std::log(moes.load), &moes](const FilmTable& table) {
    return is_within(table, log_load, moes.material)
               ? solved_film_number(table, log_load, moes.material).value
               : quiet_nan<double>();
  };
  const double least =
      film * number(live::least_film_table(held->is_line())) / number(film_table(solved));
  for (const bool is_minimum : {false, true}) {
    const double one = is_minimum ? least : film;
    line("solved", is_minimum, one,
         std::isfinite(one)               ? ""
         : shape == ContactShape::ellipse ? "the tables are of circles and of lines"
                                          : protocol::beyond_solved_films,
         !is_minimum && &solved == &held->contact.film());
  }
  return answer.c_str();
}

// The two numbers of the map of regimes at a speed (g_V and g_E of a point contact, M and L of a
// line contact), and the place of the regime there in the list of live_regimes(). Then the places
// of the regimes at the middles of count × count equal cells of the map, which reaches from x_low
// to x_high in the decimal logarithm of the first number, and from y_low to y_high in that of the
// second. The second number varies first.
TRIBOCHECK_CALL(live_map)
const double* live_map(double speed, double x_low, double x_high, double y_low, double y_high,
                       std::size_t count) {
  answer_numbers.clear();
  if (!held) return nullptr;
  const auto& scene = held->contact.scene_numbers();
  const ContactShape shape = held->contact.words().shape;
  const auto numbers = similarity_of(shape, scene, speed);
  const MoesNumbers<double> moes = moes_numbers(numbers, true);
  const RegimeNumbers<double> map = regime_numbers(numbers);
  answer_numbers = {held->is_line() ? moes.load : map.viscosity,
                    held->is_line() ? moes.material : map.elasticity,
                    static_cast<double>(regime_of(shape, scene, numbers))};
  const auto at = [count](double low, double high, std::size_t i) {
    return std::pow(
        10.0, low + (high - low) * (static_cast<double>(i) + 0.5) / static_cast<double>(count));
  };
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < count; ++j) {
      const double x = at(x_low, x_high, i), y = at(y_low, y_high, j);
      const LubricationRegime regime =
          held->is_line() ? line_regime(MoesNumbers<double>{x, y})
                          : point_regime(RegimeNumbers<double>{x, y}, radius_ratio_of(shape, scene),
                                         scene.ellipticity);
      answer_numbers.push_back(static_cast<double>(regime));
    }
  return answer_numbers.data();
}

// The words of the regimes on that map, in their order.
TRIBOCHECK_CALL(live_regimes) const char* live_regimes() {
  answer.clear();
  for (const std::string_view word : lubrication_regime_words) line(word);
  return answer.c_str();
}

// The parameters and then the results of the function whose name is in the memory of live_room(), a
// line each: "argument" or "result", name, unit, meaning. There are no lines where the catalogue
// has no such function.
TRIBOCHECK_CALL(live_function) const char* live_function() {
  answer.clear();
  const catalogue::Function* const function = catalogue::function_named(room);
  if (function == nullptr) return answer.c_str();
  for (const catalogue::Parameter& one : function->parameters)
    line("argument", one.name, one.unit, one.meaning);
  for (const catalogue::Result& one : function->results)
    line("result", one.name, one.unit, one.meaning);
  return answer.c_str();
}

// One result of a function, which the text in the memory of live_room() asks for in the form
// function,result,argument=number,…: NaN where there is no such function, and the first result
// where the function has none of that name.
TRIBOCHECK_CALL(live_value) double live_value() {
  std::string_view text = room;
  const catalogue::Function* const function = catalogue::function_named(cut(text, ','));
  if (function == nullptr) return quiet_nan<double>();
  const std::string_view output = cut(text, ',');
  Asked asked;
  ask(function, text, asked);
  return result_of(function, output, asked);
}

// The certified rows that this file includes, judged as `tribocheck verify` does. The cells of a
// line: function, output, number of rows, the greatest ratio of an error to its bound, and the row
// with that ratio. The bound is kept where the ratio is at most 1.
TRIBOCHECK_CALL(live_verify) const char* live_verify() {
  struct Judged {
    std::string_view function, output, worst_row;
    int rows = 0;
    double worst = 0;
  };
  std::vector<Judged> all;
  Asked asked;
  for (std::string_view rest = certified_rows; !rest.empty();) {
    std::string_view row = cut(rest, '\n');
    const std::string_view name = cut(row, ','), output = cut(row, ','), id = cut(row, ',');
    const double high = number_of(cut(row, ',')), low = number_of(cut(row, ',')),
                 condition = number_of(cut(row, ','));
    const catalogue::Function* const function = catalogue::function_named(name);
    if (!row.empty()) ask(function, row, asked);
    const Contract contract = function == nullptr ? operating_point_contract : function->contract;
    const double bound =
        std::max(contract.ulp, contract.ulp_per_condition * std::max(1.0, condition));
    const double part = error_in_ulp(result_of(function, output, asked), high, low) / bound;
    auto judged = std::find_if(all.begin(), all.end(), [&](const Judged& one) {
      return one.function == name && one.output == output;
    });
    if (judged == all.end()) judged = all.insert(all.end(), {name, output, id});
    ++judged->rows;
    if (part <= judged->worst || std::isnan(judged->worst)) continue;  // NaN is worse than any
    judged->worst = part;
    judged->worst_row = id;
  }
  answer.clear();
  for (const Judged& one : all)
    line(one.function, one.output, double(one.rows), one.worst, one.worst_row);
  return answer.c_str();
}
