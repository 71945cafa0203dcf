// SPDX-License-Identifier: Apache-2.0
// The group `line_films`: films that formulas give for a line contact beside the solved one, over
// the numbers of load and of material; and one contact of reference/scenes, solved.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "accuracy/reference_table.hpp"
#include "ehl/line_conditions.hpp"
#include "ehl/line_formulas.hpp"
#include "ehl/solved_film.hpp"
#include "page/contour_labels.hpp"
#include "page/facts.hpp"
#include "page/line_scenes.hpp"
#include "page/number_text.hpp"
#include "page/solved_films.hpp"

namespace tribo::report {
namespace {

using Formulas = std::array<double, ehl::line_formulas.size()>;

constexpr double map_speed_number = 1e-11;  // U: for the exponents that leave some of it
constexpr int load_steps = 60, material_steps = 45;
// Contours, per cent; the ones that should have a label first come first.
constexpr std::array contour_levels{0.,  -10., 10., -20., 20., -5.,  5., -30.,
                                    30., -50., 50., -2.,  2.,  -70., 70.};
constexpr std::string_view profile_scene = "gear_flank";
constexpr double profile_speed = 1;  // m/s
constexpr double profile_from = -3;  // x/b

constexpr std::array<std::string_view, 3> quantity_words{"central", "minimum",
                                                         "at_greatest_pressure"};

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Solved films of one liquid: those of the table of errors, the map through them and its other
// nodes, and films that the map is held to.
struct FilmsOfLiquid {
  std::vector<SolvedNumbers> table, checks;
  FilmMap map;
  double speed_number;     // U, at L of 1 where it grows
  double power_of_number;  // the power of L with which U grows

  double error_of(const ehl::LineFormula& formula, double load_number, double material_number,
                  double film) const {
    const double u = speed_number * std::pow(material_number, power_of_number);
    return ehl::film_number(formula, load_number, material_number, u) / film - 1;
  }
};

std::vector<SolvedNumbers> joined(std::vector<SolvedNumbers> some,
                                  const std::vector<SolvedNumbers>& more) {
  some.insert(some.end(), more.begin(), more.end());
  return some;
}

// Where the liquid is Barus' and incompressible, M and L fix the film, and U is chosen.
FilmsOfLiquid barus_films(const std::filesystem::path& folder) {
  const std::string file = (folder / "line_films.csv").string();
  const std::string between = (folder / "line_films_between.csv").string();
  std::vector<SolvedNumbers> table = read_solved_films(file);
  if (table.empty()) throw std::runtime_error("reference/ehl/line_films.csv has no films");
  const FilmMap map(joined(read_solved_films(between, "node"), table));
  return {std::move(table), read_solved_films(between, "check"), map, map_speed_number, 0};
}

// The compressible liquid is one liquid between bodies of one material: U grows with L⁴.
FilmsOfLiquid compressible_films(const std::filesystem::path& folder) {
  const std::string file = (folder / "line_films_compressible.csv").string();
  std::vector<SolvedNumbers> table = read_solved_films(file, "table");
  if (table.empty())
    throw std::runtime_error("reference/ehl/line_films_compressible.csv has no films");
  const verification::ReferenceRow first = verification::read_reference_table(file).front();
  const FilmMap map(joined(read_solved_films(file, "node"), table));
  return {std::move(table), read_solved_films(file, "check"), map,
          first.number("speed_number") / std::pow(first.number("material_number"), 4), 4};
}

// The films that each formula is held to: those of the liquid that it was fitted to; those of
// Barus' where no text tells which one that was.
struct SolvedFilms {
  FilmsOfLiquid barus, compressible;

  const FilmsOfLiquid& of(const ehl::LineFormula& formula) const {
    return formula.liquid == ehl::FitLiquid::roelands_compressible ? compressible : barus;
  }
};

struct ErrorAt {
  double error;
  const SolvedNumbers* at;
  Json json() const {
    return {{"error", error},
            {"load_number", at->load_number},
            {"material_number", at->material_number}};
  }
};

// A formula over the rows of the table with L > 0.
Json formula_json(const ehl::LineFormula& formula, const FilmsOfLiquid& films) {
  std::vector<ErrorAt> errors;
  std::vector<double> sizes;
  for (const SolvedNumbers& one : films.table) {
    if (one.material_number == 0) continue;
    errors.push_back(
        {films.error_of(formula, one.load_number, one.material_number, one.film_of(formula)),
         &one});
    sizes.push_back(std::fabs(errors.back().error));
  }
  if (errors.empty()) throw std::runtime_error("line_films.csv has no films with L > 0");
  const auto by_error = [](const ErrorAt& a, const ErrorAt& b) { return a.error < b.error; };
  const auto [least, greatest] = std::minmax_element(errors.begin(), errors.end(), by_error);
  std::vector<double> signed_errors;
  for (const ErrorAt& one : errors) signed_errors.push_back(one.error);
  return {{"name", formula.name},
          {"authors", formula.authors},
          {"quantity", quantity_words[static_cast<std::size_t>(formula.quantity)]},
          {"liquid", ehl::name(formula.liquid)},
          {"points", errors.size()},
          {"least", least->json()},
          {"median", median_of(signed_errors)},
          {"greatest", greatest->json()},
          {"median_size", median_of(sizes)}};
}

// Sums up the relative errors that the table states for its films.
Json solved_errors_json(const std::vector<SolvedNumbers>& table) {
  std::vector<double> all;
  std::size_t within = 0;
  ErrorAt worst{0, &table.front()};
  for (const SolvedNumbers& one : table)
    for (std::size_t i = 0; i < one.film.size(); ++i) {
      all.push_back(one.error[i] / one.film[i]);
      within += all.back() <= 1e-4 ? 1 : 0;
      if (all.back() > worst.error) worst = {all.back(), &one};
    }
  const std::size_t count = all.size();
  return {{"films", count},
          {"within_1e_4", within},
          {"median", median_of(std::move(all))},
          {"greatest", worst.json()}};
}

// The maps that formulas are held to, against films that are solved between their nodes: the
// greatest error of each quantity.
// Below `heavy_from` the central film has a kink, where the front of the stiffened liquid passes
// the middle of the contact; it is told apart.
Json interpolation_json(const SolvedFilms& films) {
  constexpr double heavy_from = 2;
  std::array<double, 3> greatest{}, greatest_light{};
  std::size_t points = 0;
  for (const FilmsOfLiquid* const one : {&films.barus, &films.compressible}) {
    points += one->checks.size();
    std::array<bool, 3> is_used{};
    for (const ehl::LineFormula& formula : ehl::line_formulas)
      if (&films.of(formula) == one) is_used[static_cast<std::size_t>(formula.quantity)] = true;
    for (const SolvedNumbers& solved : one->checks)
      for (std::size_t i = 0; i < solved.film.size(); ++i) {
        if (!is_used[i]) continue;
        const double film =
            one->map.surfaces[i].films(solved.load_number, {solved.material_number}).front();
        double& worst = (solved.load_number < heavy_from ? greatest_light : greatest)[i];
        worst = std::fmax(worst, std::fabs(film / solved.film[i] - 1));
      }
  }
  const auto json = [](const std::array<double, 3>& errors) {
    Json all = Json::object();
    for (std::size_t i = 0; i < errors.size(); ++i) all[std::string(quantity_words[i])] = errors[i];
    return all;
  };
  return {{"points", points},
          {"heavy_from", heavy_from},
          {"greatest", json(greatest)},
          {"greatest_light", json(greatest_light)}};
}

// A scene's way over the map with its speed.
struct Track {
  LineScene scene;
  bool is_of_report;
  bool is_on_map = false;
};

struct TrackPoint {
  double speed, load_number, material_number;
};

TrackPoint track_point(const LineScene& scene, double speed) {
  const ehl::LineContact contact = ehl::contact_of(ehl::conditions_of(scene.scene, speed));
  return {speed, contact.load_number, contact.material_number};
}

class MapFrame {
 public:
  explicit MapFrame(const FilmMap& map)
      : low_load_(map.load_numbers.front()),
        low_material_(map.material_numbers.front()),
        loads_(std::log(map.load_numbers.back() / low_load_)),
        materials_(std::log(map.material_numbers.back() / low_material_)) {}

  double load_at(double x) const { return low_load_ * std::exp(loads_ * x); }
  double material_at(double y) const { return low_material_ * std::exp(materials_ * y); }
  MapPlace place(const TrackPoint& point) const {
    return {std::log(point.load_number / low_load_) / loads_,
            std::log(point.material_number / low_material_) / materials_};
  }
  static bool contains(const MapPlace& place) {
    return place.x >= 0 && place.x <= 1 && place.y >= 0 && place.y <= 1;
  }

 private:
  double low_load_, low_material_, loads_, materials_;
};

std::string number_cell(double value) { return fmt::format("{:.5g}", value); }

// Blocks: each track, its name first; whole powers of ten of the speed have it in a fourth column.
std::string tracks_text(const MapFrame& frame, std::vector<Track>& tracks,
                        std::vector<MapPlace>& taken) {
  std::string text =
      "# line contacts over the numbers of load and of material, each a block\n"
      "# load number M\tmaterial number L\tspeed [m/s]\twhole power of ten of it [m/s]\tlabel\n";
  bool is_first = true;
  for (Track& track : tracks) {
    const auto [low, high] = track.scene.range;
    std::string block = fmt::format("\"{}\"\n", track.scene.name);
    // A straight line in the logarithms; the picture cuts it at the edge of the map.
    constexpr int steps = 40;
    for (int i = 0; i <= steps; ++i) {
      const TrackPoint point =
          track_point(track.scene, low * std::pow(high / low, static_cast<double>(i) / steps));
      if (MapFrame::contains(frame.place(point))) track.is_on_map = true;
      block += fmt::format("{}\t{}\t{}\tNaN\t\"\"\n", number_cell(point.load_number),
                           number_cell(point.material_number), number_cell(point.speed));
    }
    for (int power = -6; power <= 4; ++power) {
      const double speed = std::pow(10, power);
      const TrackPoint point = track_point(track.scene, speed);
      const MapPlace place = frame.place(point);
      if (speed < low || speed > high || !MapFrame::contains(place)) continue;
      // Its label stands to the right.
      const MapPlace label{place.x + 0.09, place.y};
      const bool has_room = label.x < 0.94 && is_clear(label, taken);
      taken.push_back(place);
      if (has_room) taken.push_back(label);
      block += fmt::format("{}\t{}\tNaN\t{}\t\"{}\"\n", number_cell(point.load_number),
                           number_cell(point.material_number), number_cell(speed),
                           has_room ? fmt::format("{} m/s", speed) : "");
    }
    if (!track.is_on_map) continue;
    text += (is_first ? "" : "\n\n") + block;
    is_first = false;
  }
  return text;
}

// Adds the errors over the map, and the labels of their contours.
void add_map(Json& files, const SolvedFilms& solved, const MapFrame& frame,
             const std::vector<MapPlace>& taken) {
  std::string text =
      "# errors of formulas for the film of a line contact against the solved film, of the liquid "
      "that each was fitted to [%]\n"
      "# load number M\tmaterial number L";
  for (const ehl::LineFormula& formula : ehl::line_formulas)
    text += fmt::format("\t{}", formula.name);
  text += '\n';
  std::vector<Eigen::MatrixXd> errors(ehl::line_formulas.size(),
                                      Eigen::MatrixXd(load_steps + 1, material_steps + 1));
  std::vector<double> materials;
  for (int l = 0; l <= material_steps; ++l)
    materials.push_back(frame.material_at(static_cast<double>(l) / material_steps));
  for (int m = 0; m <= load_steps; ++m) {
    const double load = frame.load_at(static_cast<double>(m) / load_steps);
    std::vector<std::vector<double>> films;  // a row for each formula
    for (const ehl::LineFormula& formula : ehl::line_formulas)
      films.push_back(
          solved.of(formula).map.surfaces[static_cast<std::size_t>(formula.quantity)].films(
              load, materials));
    for (int l = 0; l <= material_steps; ++l) {
      const auto at = static_cast<std::size_t>(l);
      text += number_cell(load) + '\t' + number_cell(materials[at]);
      for (std::size_t f = 0; f < errors.size(); ++f) {
        const ehl::LineFormula& formula = ehl::line_formulas[f];
        errors[f](m, l) =
            100 * solved.of(formula).error_of(formula, load, materials[at], films[f][at]);
        text += fmt::format("\t{:.4g}", errors[f](m, l));
      }
      text += '\n';
    }
    text += '\n';
  }

  std::string labels =
      "# labels of the contours, a block for each formula\n"
      "# load number M\tmaterial number L\terror [%]\ttext\n";
  for (std::size_t f = 0; f < errors.size(); ++f) {
    labels += fmt::format("{}\"{}\"\n", f == 0 ? "" : "\n\n", ehl::line_formulas[f].name);
    for (const ContourLabel& label :
         contour_labels(errors[f], {contour_levels.begin(), contour_levels.end()}, taken))
      labels += fmt::format("{}\t{}\t{}\t\"{}{} %\"\n", number_cell(frame.load_at(label.place.x)),
                            number_cell(frame.material_at(label.place.y)), label.level,
                            label.level > 0   ? "+"
                            : label.level < 0 ? "−"
                                              : "",
                            std::fabs(label.level));
  }
  files["data/line_film_errors.tsv"] = std::move(text);
  files["data/line_film_labels.blocks.tsv"] = std::move(labels);
}

Json tracks_json(const std::vector<Track>& tracks) {
  Json all = Json::array();
  for (const Track& track : tracks)
    all.push_back({{"name", track.scene.name},
                   {"file", track.scene.file},
                   {"slowest", track.scene.range.low},
                   {"fastest", track.scene.range.high},
                   {"is_of_report", track.is_of_report},
                   {"is_on_map", track.is_on_map}});
  return all;
}

Json estimate_json(const ehl::Estimate& estimate, double unit) {
  return {{"value", number(std::isfinite(estimate.value) ? std::optional(unit * estimate.value)
                                                         : std::nullopt)},
          {"error", number(std::isfinite(estimate.error) ? std::optional(unit * estimate.error)
                                                         : std::nullopt)}};
}

// Adds pressure and film across a contact, and returns what is read off them.
Json add_profile(Json& files, const std::vector<Track>& tracks) {
  const auto found = std::find_if(tracks.begin(), tracks.end(), [](const Track& one) {
    return one.scene.name == profile_scene && !one.is_of_report;
  });
  if (found == tracks.end())
    throw std::runtime_error(fmt::format("reference/scenes has no line contact {}", profile_scene));
  const ehl::LineConditions conditions = ehl::conditions_of(found->scene.scene, profile_speed);
  const ehl::LineScale scale = ehl::scale_of(conditions);
  const ehl::LineContact contact = ehl::contact_of(conditions);
  const ehl::SolvedFilm solved = ehl::solve_line_film(contact);
  if (solved.outcome != ehl::Outcome::solved) throw std::runtime_error(solved.reason);
  std::string text = fmt::format(
      "# pressure and film across the line contact of {} at {} m/s\n"
      "# x/b\tp/p0\tHertz' p/p0\tfilm [µm]\n",
      found->scene.file, profile_speed);
  // No two nodes that a picture does not tell apart.
  double last_x = 0, last_pressure = -1;
  for (std::size_t i = 0; i < solved.film.x.size(); ++i) {
    const double x = solved.film.x[i];
    const auto at = static_cast<Eigen::Index>(i);
    const double pressure = solved.film.pressure[at];
    if (x < profile_from) continue;
    if (std::fabs(x - last_x) < 0.005 && std::fabs(pressure - last_pressure) < 0.01) continue;
    last_x = x;
    last_pressure = pressure;
    text += fmt::format("{}\t{}\t{}\t{}\n", exact(x), exact(pressure),
                        exact(std::sqrt(std::fmax(0, 1 - x * x))),
                        exact(1e6 * scale.film * solved.film.film[at]));
  }
  files["data/line_film_profile.tsv"] = std::move(text);
  return {{"file", found->scene.file},
          {"speed", profile_speed},
          {"viscosity", conditions.viscosity_law == ViscosityLaw::roelands ? "roelands" : "barus"},
          {"load_number", contact.load_number},
          {"material_number", contact.material_number},
          {"half_width", scale.half_width},
          {"peak_pressure", scale.peak_pressure},
          {"cells", solved.film.x.size() - 1},
          {"central", estimate_json(solved.central, scale.film)},
          {"minimum", estimate_json(solved.minimum, scale.film)},
          {"spike_pressure", estimate_json(solved.spike_pressure, 1)},
          {"spike_place", estimate_json(solved.spike_place, 1)}};
}

}  // namespace

Json line_films_facts(const ReportPlaces& places) {
  const SolvedFilms films{barus_films(places.reference / "ehl"),
                          compressible_films(places.reference / "ehl")};
  const FilmMap& map = films.barus.map;
  const MapFrame frame(map);
  std::vector<Track> tracks;
  for (LineScene& one : line_scenes(places, places.reference / "scenes"))
    tracks.push_back({std::move(one), false});
  for (LineScene& one : line_scenes(places, places.scenes))
    tracks.push_back({std::move(one), true});

  Json files;
  std::vector<MapPlace> taken;
  files["data/line_film_tracks.blocks.tsv"] = tracks_text(frame, tracks, taken);
  add_map(files, films, frame, taken);
  Json data{{"speed_number", map_speed_number},
            {"least_load_number", map.load_numbers.front()},
            {"greatest_load_number", map.load_numbers.back()},
            {"least_material_number", map.material_numbers.front()},
            {"greatest_material_number", map.material_numbers.back()},
            {"solved", solved_errors_json(films.barus.table)},
            {"solved_compressible", solved_errors_json(films.compressible.table)},
            {"interpolation", interpolation_json(films)},
            {"formulas", Json::array()},
            {"scenes", tracks_json(tracks)}};
  for (const ehl::LineFormula& formula : ehl::line_formulas)
    data["formulas"].push_back(formula_json(formula, films.of(formula)));
  data["profile"] = add_profile(files, tracks);
  return {{"data", std::move(data)}, {"files", std::move(files)}};
}

}  // namespace tribo::report
