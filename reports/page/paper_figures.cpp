// SPDX-License-Identifier: Apache-2.0
#include "page/paper_figures.hpp"

#include <fmt/format.h>

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "page/number_text.hpp"
#include "tribo/version.hpp"

namespace tribo::report {
namespace {

// gnuplot's enhanced text takes these signs for orders.
std::string enhanced(std::string_view text) {
  constexpr std::string_view orders = "\\_^{}@&~";
  std::string escaped;
  for (const char sign : text) {
    if (orders.find(sign) != std::string_view::npos) escaped += '\\';
    escaped += sign;
  }
  return escaped;
}

std::string supply(const Scene& scene) {
  switch (scene.supply.kind) {
    case SupplyKind::flooded:
      return "no supply";
    case SupplyKind::inlet_film:
      return fmt::format("h_{{oil}} = {} m", exact(scene.supply.value));
    case SupplyKind::inlet_film_ratio:
      return fmt::format("h_{{oil}} = {} σ_s", exact(scene.supply.value));
    case SupplyKind::inlet_flow:
      return fmt::format("h_{{oil}}u = {} m²/s", exact(scene.supply.value));
  }
  return {};
}

std::string scene_text(const Scene& scene) {
  return fmt::format("F = {} N, {}, inlet closure {}", exact(scene.load), supply(scene),
                     enhanced(closure_name(scene.closures.starvation)));
}

std::string three_surfaces(const Findings& findings) {
  return "scenes rough, medium, smooth: " + scene_text(findings.gt("rough").source.scene);
}

std::string with_gw(const Findings& findings) {
  return "scenes rough, medium, smooth, smooth\\_gw: " +
         scene_text(findings.gt("rough").source.scene);
}

std::string smooth_pair(const Findings& findings) {
  return "scenes smooth, smooth\\_gw: " + scene_text(findings.gt("smooth").source.scene);
}

// The curves of these scenes, the marks on them, and what else a figure is drawn from.
std::vector<std::string> files(std::initializer_list<std::string_view> scenes,
                               std::initializer_list<std::string_view> more = {}) {
  std::vector<std::string> paths;
  for (const std::string_view scene : scenes)
    paths.push_back(fmt::format("data/curve_{}.tsv", scene));
  paths.emplace_back("data/marks.tsv");
  for (const std::string_view name : more) paths.push_back(fmt::format("data/{}.tsv", name));
  return paths;
}

struct PaperFigure {
  int number;
  std::string_view title;
  std::string scene;  // in gnuplot's enhanced text
  std::string caption;
  std::string alternative;
  std::vector<std::string> data;
  int height = 640;
};

Figure figure(PaperFigure&& of) {
  const std::string heading = fmt::format("Figure {} redrawn: {}", of.number, of.title);
  const std::string stem = fmt::format("figure_{:02}", of.number);
  return {stem,
          fmt::format("Figure {}", of.number),
          heading,
          std::move(of.caption),
          std::move(of.alternative),
          std::move(of.data),
          {"style.gp", stem + ".gp", "data", stem, heading,
           fmt::format("{}; tribocheck {}", of.scene, version), of.height}};
}

}  // namespace

std::vector<Figure> paper_figures(const Findings& findings) {
  return {
      figure(
          {4, "film against speed, flooded and starved",
           fmt::format("scene smooth: {}; constant flow q = {} m²/s",
                       scene_text(findings.gt("smooth").source.scene),
                       rounded(findings.slopes.inlet_flow, 3)),
           two_slopes_caption(findings),
           "Film against speed on logarithmic axes for the smooth surface: a flooded inlet, two "
           "closures under a constant flow of oil, and the paper's own closure at constant inlet "
           "film, with guide lines of slope 0.67 and −1.",
           files({"smooth"}, {"figure_04_flooded", "figure_04_starved_inlet", "figure_04_damiens",
                              "figure_04_guides", "figure_04_marks"})}),
      figure({7, "real area of contact", with_gw(findings), area_caption(findings),
              "Real over nominal area of contact against speed, logarithmic speed axis: "
              "Greenwood–Tripp on three surfaces and Greenwood–Williamson on the smooth one, with "
              "the onset of starvation and the collapse of the film marked.",
              files({"rough", "medium", "smooth", "smooth_gw"})}),
      figure({8, "summits in contact", with_gw(findings), summits_caption(findings),
              "Number of summits in contact against speed on logarithmic axes: Greenwood–Tripp on "
              "three surfaces and Greenwood–Williamson on the smooth one.",
              files({"rough", "medium", "smooth", "smooth_gw"})}),
      figure({9, "load shares of fluid and asperities", three_surfaces(findings),
              shares_caption(findings),
              "Shares of the load carried by fluid and by asperities against speed, logarithmic "
              "speed axis, for three surfaces with Greenwood–Tripp.",
              files({"rough", "medium", "smooth"})}),
      figure({10, "starved film", three_surfaces(findings), film_caption(findings),
              "Starved film against speed on logarithmic axes for three surfaces, with the maximum "
              "and the collapse of each marked, and the onset speeds that the paper reports.",
              files({"rough", "medium", "smooth"})}),
      figure({11, "starved film, GT against GW", smooth_pair(findings), models_caption(findings),
              "Starved film of the smooth surface against speed on logarithmic axes, "
              "Greenwood–Tripp and Greenwood–Williamson, and below it the ratio of the two.",
              files({"smooth", "smooth_gw"}, {"figure_11_ratio"}), 860}),
      figure({12, "friction and film parameter", with_gw(findings), stribeck_caption(findings),
              "Two panels over one logarithmic speed axis: the friction coefficient above, the "
              "film parameter λ below; Greenwood–Tripp on three surfaces, Greenwood–Williamson on "
              "the smooth one.",
              files({"rough", "medium", "smooth", "smooth_gw"}, {"comparison"}), 860}),
  };
}

}  // namespace tribo::report
