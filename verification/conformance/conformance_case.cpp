// SPDX-License-Identifier: Apache-2.0
#include "conformance/conformance_case.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "accuracy/reference_table.hpp"
#include "sampling/sampler.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::conformance {
namespace {

using nlohmann::json;
using verification::read_reference_table;
using verification::ReferenceRow;

// Films and shares are never as small; moments beyond d = 11 are.
constexpr double least_of_engineering = 1e-30;

Expected expected(const std::string& field, const ReferenceRow& row) {
  if (!row.is_defined()) return {field, 0, 0, 1, true, {}};
  return {
      field, row.number("high"), row.number("low"), std::max(1.0, row.number("condition")), false,
      {}};
}

bool is_tiny(const Expected& one) {
  return one.word.empty() && !one.is_undefined && std::abs(one.high) < least_of_engineering;
}

std::vector<Case> moments(const std::string& folder) {
  std::vector<Case> cases;
  for (const ReferenceRow& row : read_reference_table(folder + "/gaussian_moment.csv")) {
    const Expected value = expected("value", row);
    cases.push_back({row.text("id"),
                     "gaussian_moment",
                     {{"function", "gaussian_moment"},
                      {"order", row.number("twice_n") / 2},
                      {"argument", row.number("argument")}},
                     gaussian_moment_contract,
                     {value},
                     is_tiny(value)});
  }
  return cases;
}

std::vector<Case> roots(const std::string& folder) {
  std::vector<Case> cases;
  for (const ReferenceRow& row : read_reference_table(folder + "/load_sharing.csv")) {
    const Expected value = expected("value", row);
    cases.push_back({row.text("id"),
                     "load_sharing",
                     {{"function", "load_sharing"},
                      {"asperity", row.text("asperity")},
                      {"flooded_film_parameter", row.number("flooded_film_parameter")},
                      {"stiffness", row.number("stiffness")},
                      {"offset", row.number("offset")}},
                     load_sharing_contract,
                     {value},
                     row.text("region") == "extreme" || is_tiny(value)});
  }
  return cases;
}

std::vector<Case> film_ratios(const std::string& folder) {
  std::vector<Case> cases;
  for (const ReferenceRow& row : read_reference_table(folder + "/starvation_ratio.csv"))
    cases.push_back({row.text("id"),
                     "starvation_ratio",
                     {{"function", "starvation_ratio"},
                      {"closure", row.text("closure")},
                      {"flooded_over_inlet", row.number("flooded_over_inlet")},
                      {"damiens_exponent", row.number("damiens_exponent")}},
                     starvation_ratio_contract,
                     {expected("value", row)},
                     row.text("region") == "far"});
  return cases;
}

// A row an output: those of one contact follow each other.
std::vector<Case> hertz_contacts(const std::string& folder) {
  std::vector<Case> cases;
  for (const ReferenceRow& row : read_reference_table(folder + "/hertz_point.csv")) {
    json inputs{{"function", "hertz_point"},
                {"load", row.number("load")},
                {"effective_modulus", row.number("effective_modulus")},
                {"reduced_radius", row.number("reduced_radius")}};
    if (cases.empty() || cases.back().inputs != inputs)
      cases.push_back(
          {row.text("id"), "hertz_point", std::move(inputs), hertz_contract, {}, false});
    cases.back().expected.push_back(expected(row.text("output"), row));
  }
  return cases;
}

// The film formula in long double, 64 bits of mantissa, for seeded contacts.
std::vector<Case> films() {
  std::vector<Case> cases;
  verification::Sampler sampler(17);
  for (int i = 0; i < 60; ++i) {
    const double speed = sampler.log_uniform(1e-4, 30), load = sampler.log_uniform(0.1, 1e4);
    const double viscosity = sampler.log_uniform(1e-3, 1), alpha = sampler.log_uniform(5e-9, 4e-8);
    const double modulus = sampler.log_uniform(1e10, 5e11);
    const double radius = sampler.log_uniform(1e-3, 0.3);
    const double ellipticity = i % 3 == 0 ? sampler.uniform(1, 8) : 1.0;
    const long double film = hamrock_dowson_central<long double>(speed, viscosity, alpha, load,
                                                                 modulus, radius, ellipticity);
    const auto high = static_cast<double>(film);
    cases.push_back({fmt::format("film{:04}", i),
                     "hamrock_dowson_central",
                     {{"function", "hamrock_dowson_central"},
                      {"speed", speed},
                      {"viscosity", viscosity},
                      {"pressure_viscosity", alpha},
                      {"load", load},
                      {"effective_modulus", modulus},
                      {"reduced_radius", radius},
                      {"ellipticity", ellipticity}},
                     Contract{20, 0},
                     {{"value",
                       high,
                       static_cast<double>(film - static_cast<long double>(high)),
                       1,
                       false,
                       {}}},
                     false});
  }
  return cases;
}

json scene_json(const ReferenceRow& row) {
  json scene{{"load", row.number("load")}, {"speed", row.number("speed")}};
  scene["surface"] = {{"summit_density", row.number("summit_density")},
                      {"summit_radius", row.number("summit_radius")},
                      {"summit_height_sd", row.number("summit_height_sd")},
                      {"summit_plane_offset", row.number("summit_plane_offset")},
                      {"offset_planes", static_cast<int>(row.number("offset_planes"))}};
  scene["bodies"] = {{"effective_modulus", row.number("effective_modulus")},
                     {"reduced_radius", row.number("reduced_radius")},
                     {"ellipticity", row.number("ellipticity")}};
  scene["lubricant"] = {{"viscosity", row.number("viscosity")},
                        {"pressure_viscosity", row.number("pressure_viscosity")},
                        {"eyring_stress", row.number("eyring_stress")}};
  if (row.text("supply_kind") != "flooded")
    scene["supply"] = {{row.text("supply_kind"), row.number("supply")}};
  scene["friction"] = {{"boundary_coefficient", row.number("boundary_coefficient")},
                       {"slide_roll_ratio", row.number("slide_roll_ratio")},
                       {"fluid", row.text("fluid")},
                       {"viscosity", row.text("viscosity_law")}};
  scene["closures"] = {{"asperity", row.text("asperity")},
                       {"starvation", row.text("starvation")},
                       {"damiens_exponent", row.number("damiens_exponent")}};
  return scene;
}

// Regime and inlet, from the shares and films of the same point, but within 1e-6 of a border.
void add_words(Case& point) {
  std::map<std::string, double> value;
  for (const Expected& one : point.expected) value[one.field] = one.high;
  const auto is_near = [](double x, double border) { return std::abs(x / border - 1) < 1e-6; };
  const double asperity = value["asperity_load_share"], fluid = value["fluid_load_share"];
  if (!is_near(asperity, 0.01) && !is_near(fluid, 0.01))
    point.expected.push_back(
        {"regime", 0, 0, 1, false, std::string(name(regime_of<double>(asperity, fluid)))});
  const double film = value["film"], flooded = value["film_flooded"];
  if (!is_near(film / flooded, 0.95))
    point.expected.push_back({"inlet", 0, 0, 1, false,
                              film == 0                ? "collapsed"
                              : film / flooded >= 0.95 ? "flooded"
                                                       : "starved"});
}

// Rows p0000.0 to p0000.8 are the outputs of one point.
std::vector<Case> operating_points(const std::string& folder) {
  std::vector<Case> cases;
  for (const ReferenceRow& row : read_reference_table(folder + "/operating_point.csv")) {
    const std::string id = row.text("id").substr(0, row.text("id").find('.'));
    if (cases.empty() || cases.back().id != id)
      cases.push_back(
          {id, "operating_point", scene_json(row), operating_point_contract, {}, false});
    cases.back().expected.push_back(expected(row.text("output"), row));
  }
  for (Case& point : cases) add_words(point);
  return cases;
}

json scene_json(const Scene& scene, double speed) {
  const bool is_gt = scene.closures.asperity == AsperityModel::greenwood_tripp;
  json made{{"load", scene.load}, {"speed", speed}};
  made["surface"] = {{"summit_density", scene.surface.summit_density},
                     {"summit_radius", scene.surface.summit_radius},
                     {"summit_height_sd", scene.surface.summit_height_sd},
                     {"summit_plane_offset", scene.surface.summit_plane_offset}};
  made["bodies"] = {{"effective_modulus", scene.bodies.effective_modulus},
                    {"reduced_radius", scene.bodies.reduced_radius}};
  made["lubricant"] = {{"viscosity", scene.lubricant.viscosity},
                       {"pressure_viscosity", scene.lubricant.pressure_viscosity},
                       {"eyring_stress", *scene.lubricant.eyring_stress}};
  made["supply"] = {{"inlet_film_ratio", scene.supply.value}};
  made["friction"] = {{"boundary_coefficient", *scene.friction.boundary_coefficient}};
  made["closures"] = {{"asperity", is_gt ? "greenwood_tripp" : "greenwood_williamson"}};
  return made;
}

// The paper's six surfaces at speeds over its range, by long double. 1e-12, as their conditions are
// not certified.
std::vector<Case> paper_points(const std::string& folder) {
  std::vector<Case> cases;
  for (const char* const stem :
       {"rough", "medium", "smooth", "rough_gw", "medium_gw", "smooth_gw"}) {
    const SceneReading reading =
        read_scene(fmt::format("{}/{}.toml", folder, stem), SceneUse::speeds);
    if (!reading.scene) throw std::runtime_error(reading.errors.front().line());
    const Scene& scene = *reading.scene;
    if (scene.supply.kind != SupplyKind::inlet_film_ratio || !has_friction_inputs(scene))
      throw std::runtime_error(fmt::format("{}/{}.toml: not the paper's scene", folder, stem));
    const MixedContact<long double> contact(scene);
    for (const double speed : {1e-4, 1e-3, 0.01, 0.03, 0.1, 0.2}) {
      const OperatingPoint<long double> point = contact.solve(speed);
      Case made{fmt::format("{}@{}", stem, speed),
                "operating_point",
                scene_json(scene, speed),
                Contract{4504, 0},
                {},
                false};
      const auto add = [&](const char* field, long double value) {
        const auto high = static_cast<double>(value);
        made.expected.push_back({field,
                                 high,
                                 static_cast<double>(value - static_cast<long double>(high)),
                                 1,
                                 false,
                                 {}});
      };
      add("film_flooded", point.film_flooded);
      add("film", point.film);
      add("film_parameter", point.film_parameter);
      add("asperity_load_share", point.asperity_load_share);
      add("fluid_load_share", point.fluid_load_share);
      add("real_area_ratio", point.real_area_ratio);
      add("summit_count", point.summit_count);
      add("friction", point.friction);
      add_words(made);
      cases.push_back(std::move(made));
    }
  }
  return cases;
}

}  // namespace

std::string Case::line() const {
  json asked = inputs;
  asked["id"] = id;
  return asked.dump();
}

std::string quantity_name(const Case& asked, const Expected& expected) {
  return expected.field == "value" ? asked.function
                                   : fmt::format("{}.{}", asked.function, expected.field);
}

std::vector<Case> read_cases(const CaseSources& sources) {
  std::vector<Case> all;
  for (std::vector<Case> part :
       {hertz_contacts(sources.exact), films(), film_ratios(sources.exact), moments(sources.exact),
        roots(sources.exact), paper_points(sources.published), operating_points(sources.exact)})
    for (Case& one : part) all.push_back(std::move(one));
  return all;
}

std::vector<Case> sampled(std::vector<Case> cases, std::size_t most) {
  std::map<std::string, std::size_t> count, seen;
  for (const Case& one : cases) ++count[one.function];
  std::vector<Case> kept;
  for (Case& one : cases) {
    const std::size_t i = seen[one.function]++, n = count[one.function];
    // The first, and whenever i·most/n reaches another whole number.
    if (n <= most || i == 0 || i * most / n != (i - 1) * most / n) kept.push_back(std::move(one));
  }
  return kept;
}

}  // namespace tribo::conformance
