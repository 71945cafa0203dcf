// SPDX-License-Identifier: Apache-2.0
// The group `paper`: the published scenes solved.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "page/comparison.hpp"
#include "page/data_files.hpp"
#include "page/groups.hpp"
#include "page/report_error.hpp"
#include "page/speed_search.hpp"
#include "page/two_slopes.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::report {
namespace {

using reproduction::Quantity;

// NaN becomes null.
Json point_json(const Point& point) {
  return {{"speed", point.speed},
          {"film", point.film},
          {"film_parameter", point.film_parameter},
          {"asperity_load_share", point.asperity_load_share},
          {"real_area_ratio", point.real_area_ratio},
          {"summit_count", point.summit_count},
          {"friction", point.friction}};
}
Json point_json(const std::optional<Point>& point) {
  return point ? point_json(*point) : Json(nullptr);
}

// The first speed at which the film carries half the load. The asperities' share falls with speed
// up to the onset, and rises beyond it.
std::optional<double> equal_share_speed(const SolvedCase& solved) {
  const double highest = solved.at_onset ? solved.at_onset->speed : solved.range.high;
  return first_speed(solved.range.low, highest, [&](double speed) {
    return solved.contact.solve(speed).asperity_load_share <= 0.5;
  });
}

std::optional<double> least_friction(const SolvedCase& solved) {
  std::optional<double> least;
  for (const Point& point : solved.curve)
    if (!std::isnan(point.friction) && (!least || point.friction < *least)) least = point.friction;
  // Between the points of the curve it is at the interior minimum.
  const Onset<double>& interior = solved.by(OnsetCriterion::friction_minimum);
  if (least && interior.exists)
    least = std::min(*least, solved.contact.solve(interior.speed).friction);
  return least;
}

Json scene_json(const SolvedCase& solved) {
  const Scene& scene = solved.source.scene;
  return {
      {"file", solved.source.file},
      {"surface", solved.source.surface},
      {"model", solved.source.short_model()},
      {"load", scene.load},
      {"supply",
       {{"kind", supply_words[static_cast<std::size_t>(scene.supply.kind)]},
        {"value", scene.supply.value}}},
      {"starvation", starvation_closure_words[static_cast<std::size_t>(scene.closures.starvation)]},
      {"slowest", point_json(solved.slowest)},
      {"fastest", point_json(solved.curve.back())},
      {"onset", point_json(solved.at_onset)},
      {"collapse", point_json(solved.at_collapse)},
      {"contact_share", std::min(1.0, solved.contact.sharing().asperity_share(0))},
      {"equal_share_speed", number(equal_share_speed(solved))},
      {"least_friction", number(least_friction(solved))}};
}

// An input of a scene: how it is read from there, and the misprint that changes it.
struct InputRow {
  std::string_view field;  // one of scene_fields()
  Json (*value)(const Scene&);
  std::string_view erratum = {};
};

// 0: not given. Values that follow from two bodies or from moments stand in the scene as well.
Json if_given(double value) {
  if (value == 0) return nullptr;
  return std::isinf(value) ? Json(value > 0 ? "inf" : "-inf") : Json(value);
}
// 0 is legal.
Json poisson_ratio(const Scene& scene, std::size_t body) {
  const Body& one = scene.bodies.bodies[body];
  return one.modulus > 0 ? Json(one.poisson_ratio) : Json();
}
Json ellipticity(const Scene& scene) {
  const bool is_circle = scene.bodies.shape() == ContactShape::circle;
  return is_circle ? Json(scene.bodies.ellipticity) : Json();
}

const InputRow input_rows[] = {
    {"surface.summit_density", [](const Scene& s) { return Json(s.surface.summit_density); }},
    {"surface.summit_radius", [](const Scene& s) { return Json(s.surface.summit_radius); }, "E17"},
    {"surface.summit_height_sd", [](const Scene& s) { return Json(s.surface.summit_height_sd); }},
    {"surface.summit_plane_offset",
     [](const Scene& s) { return Json(s.surface.summit_plane_offset); }},
    {"surface.m0", [](const Scene& s) { return if_given(s.surface.moments.m0); }},
    {"surface.m2", [](const Scene& s) { return if_given(s.surface.moments.m2); }},
    {"surface.m4", [](const Scene& s) { return if_given(s.surface.moments.m4); }},
    {"surface.offset_planes", [](const Scene& s) { return Json(s.surface.offset_planes); }, "E9"},
    {"bodies.effective_modulus", [](const Scene& s) { return Json(s.bodies.effective_modulus); },
     "E2"},
    {"bodies.reduced_radius", [](const Scene& s) { return if_given(s.bodies.reduced_radius); },
     "E18"},
    {"bodies.ellipticity", ellipticity},
    {"bodies.radius_x", [](const Scene& s) { return if_given(s.bodies.radius_x); }},
    {"bodies.radius_y", [](const Scene& s) { return if_given(s.bodies.radius_y); }},
    {"bodies.length", [](const Scene& s) { return if_given(s.bodies.length); }},
    {"bodies.first_modulus", [](const Scene& s) { return if_given(s.bodies.bodies[0].modulus); }},
    {"bodies.first_poisson_ratio", [](const Scene& s) { return poisson_ratio(s, 0); }},
    {"bodies.second_modulus", [](const Scene& s) { return if_given(s.bodies.bodies[1].modulus); }},
    {"bodies.second_poisson_ratio", [](const Scene& s) { return poisson_ratio(s, 1); }},
    {"bodies.first_radius_x", [](const Scene& s) { return if_given(s.bodies.bodies[0].radius_x); }},
    {"bodies.second_radius_x",
     [](const Scene& s) { return if_given(s.bodies.bodies[1].radius_x); }},
    {"bodies.first_radius_y", [](const Scene& s) { return if_given(s.bodies.bodies[0].radius_y); }},
    {"bodies.second_radius_y",
     [](const Scene& s) { return if_given(s.bodies.bodies[1].radius_y); }},
    {"lubricant.viscosity", [](const Scene& s) { return Json(s.lubricant.viscosity); }},
    {"lubricant.pressure_viscosity",
     [](const Scene& s) { return Json(s.lubricant.pressure_viscosity); }},
    {"lubricant.eyring_stress", [](const Scene& s) { return number(s.lubricant.eyring_stress); }},
    {"load", [](const Scene& s) { return Json(s.load); }},
    {"speed.from", [](const Scene& s) { return Json(detail::speed_span(s.speeds).low); }},
    {"speed.to", [](const Scene& s) { return Json(detail::speed_span(s.speeds).high); }},
    {"supply.inlet_film",
     [](const Scene& s) {
       return s.supply.kind == SupplyKind::inlet_film ? Json(s.supply.value) : Json();
     }},
    {"supply.inlet_film_ratio",
     [](const Scene& s) {
       return s.supply.kind == SupplyKind::inlet_film_ratio ? Json(s.supply.value) : Json();
     }},
    {"supply.inlet_flow",
     [](const Scene& s) {
       return s.supply.kind == SupplyKind::inlet_flow ? Json(s.supply.value) : Json();
     }},
    {"friction.boundary_coefficient",
     [](const Scene& s) { return number(s.friction.boundary_coefficient); }, "E20"},
    {"friction.slide_roll_ratio", [](const Scene& s) { return Json(s.friction.slide_roll_ratio); }},
    {"friction.fluid",
     [](const Scene& s) {
       return Json(fluid_shear_words[static_cast<std::size_t>(s.friction.fluid)]);
     },
     "E19"},
    {"friction.viscosity",
     [](const Scene& s) {
       return Json(viscosity_law_words[static_cast<std::size_t>(s.friction.viscosity)]);
     },
     "E20"},
    {"closures.asperity",
     [](const Scene& s) {
       return Json(asperity_model_words[static_cast<std::size_t>(s.closures.asperity)]);
     }},
    {"closures.starvation",
     [](const Scene& s) {
       return Json(starvation_closure_words[static_cast<std::size_t>(s.closures.starvation)]);
     },
     "E11"},
    {"closures.film",
     [](const Scene& s) {
       return Json(film_formula_words[static_cast<std::size_t>(s.closures.film)]);
     }},
};

// Those that a scene has a value of.
Json inputs_json(const std::vector<SolvedCase>& solved) {
  Json inputs = Json::array();
  for (const InputRow& row : input_rows) {
    const auto fields = scene_fields();
    const auto field = std::find_if(fields.begin(), fields.end(),
                                    [&](const FieldInfo& one) { return one.path == row.field; });
    Json values = Json::object();
    for (const SolvedCase& one : solved) {
      Json value = row.value(one.source.scene);
      if (!value.is_null()) values[one.source.stem()] = std::move(value);
    }
    if (values.empty()) continue;
    inputs.push_back({{"field", row.field},
                      {"unit", field->unit},
                      {"meaning", field->meaning},
                      {"erratum", row.erratum.empty() ? Json(nullptr) : Json(row.erratum)},
                      {"values", std::move(values)}});
  }
  return inputs;
}

Json row_json(const ComparisonRow& row) {
  Json object{
      {"surface", row.surface},
      {"model", row.model},
      {"criterion", row.criterion.empty() ? Json(nullptr) : Json(row.criterion)},
      {"computed", number(row.computed)},
      {"reported", row.claim == nullptr ? Json(nullptr) : Json(row.claim->reported)},
      {"factor", number(row.factor())},
      {"verdict", row.verdict() ? Json(reproduction::name(*row.verdict())) : Json(nullptr)}};
  if (!row.computed) object["none"] = row.none;
  return object;
}

// The criterion film_maximum counts alone of several onset criteria.
bool counts(const ComparisonRow& row) {
  return row.verdict() &&
         (row.criterion.empty() || row.criterion == name(OnsetCriterion::film_maximum));
}

void add_comparison(Group& group, Quantity quantity, const std::vector<ComparisonRow>& rows) {
  int counted = 0, agreeing = 0;
  std::vector<double> factors;
  Json table = Json::array();
  for (const ComparisonRow& row : rows) {
    if (row.quantity != quantity) continue;
    table.push_back(row_json(row));
    if (!counts(row)) continue;
    ++counted;
    agreeing += *row.verdict() == reproduction::Verdict::reproduced ? 1 : 0;
    factors.push_back(*row.factor());
  }
  Json found{{"rows", std::move(table)}, {"counted", counted}, {"agreeing", agreeing}};
  const auto [least, greatest] = std::minmax_element(factors.begin(), factors.end());
  found["factors"] = factors.empty() ? Json::array() : Json({*least, *greatest});
  const std::string id(reproduction::name(quantity));
  group.data["comparisons"][id] = std::move(found);
  group.findings.push_back({id, "comparison", About::paper,
                            counted == 0          ? Standing::absent
                            : agreeing == counted ? Standing::holds
                                                  : Standing::differs});
}

Json slopes_json(const TwoSlopes& slopes) {
  Json object{{"inlet_flow", slopes.inlet_flow}, {"knee", slopes.knee}, {"curves", Json::object()}};
  for (const SlopeCurve& curve : slopes.curves)  // NaN becomes null
    object["curves"][std::string(curve.name)] = {{"first_slope", curve.first_slope},
                                                 {"last_slope", curve.last_slope}};
  return object;
}

std::vector<reproduction::Item> read_claims(const ReportPlaces& places) {
  try {
    return reproduction::read_claims((places.scenes / "claims.tsv").string());
  } catch (const std::runtime_error& error) {
    throw ReportError(error.what());
  }
}

DataFile scene_file(const ReportPlaces& places, const Case& source) {
  const std::string name = source.stem() + ".toml";
  std::ifstream file(places.scenes / name, std::ios::binary);
  return {"data/scenes/" + name, std::string(std::istreambuf_iterator<char>(file), {})};
}

}  // namespace

Group paper_group(const ReportPlaces& places, const std::vector<SolvedCase>& solved) {
  const std::vector<reproduction::Item> claims = read_claims(places);
  const std::vector<ComparisonRow> rows = compare(solved, claims);
  const TwoSlopes slopes =
      two_slopes(find_solved(solved, "smooth", AsperityModel::greenwood_tripp));
  Group group;
  for (const SolvedCase& one : solved) group.data["scenes"][one.source.stem()] = scene_json(one);
  group.data["inputs"] = inputs_json(solved);
  group.data["departure"] = default_departure;
  for (const Quantity quantity :
       {Quantity::onset_speed, Quantity::onset_film_parameter, Quantity::slow_asperity_share})
    add_comparison(group, quantity, rows);
  group.data["two_slopes"] = slopes_json(slopes);
  group.files = data_files(solved, slopes, claims, rows);
  for (const SolvedCase& one : solved) group.files.push_back(scene_file(places, one.source));
  return group;
}

}  // namespace tribo::report
