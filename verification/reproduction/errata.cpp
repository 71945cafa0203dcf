// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "accuracy/reference_table.hpp"
#include "reproduction/ledger.hpp"
#include "tribo/film_thickness.hpp"
#include "tribo/hertz.hpp"
#include "tribo/spectral_moments.hpp"

namespace tribo::reproduction {
namespace {

constexpr std::size_t rough = 0, smooth = 2;

struct Evidence {
  std::string what;  // "quantity: first form; second form"
  std::optional<double> printed, right;
  std::string decided_by;
};

// The rough surface's share, computed with two forms.
Evidence slow_share(std::string_view forms, double printed, double right) {
  return {fmt::format("asperity share at the lowest speed, rough surface: {}", forms), printed,
          right, "C4: 0.82"};
}
Evidence share_under(const PaperScenes& scenes, Switch which, std::string_view forms) {
  return slow_share(forms, slow_asperity_share(scenes, with(which, 1), rough),
                    slow_asperity_share(scenes, corrected_reading(), rough));
}

// The film of the smooth surface at a speed, in m.
double film_at(const PaperScenes& scenes, const Reading& reading, double speed = 1) {
  const Scene& scene = scenes.scene[smooth];
  return ReadContact(scene, reading).flooded_film_parameter(speed) * scene.surface.summit_height_sd;
}
Evidence film_under(const PaperScenes& scenes, Switch which, std::string_view forms) {
  return {fmt::format("flooded film of the smooth surface at 1 m/s, m: {}", forms),
          film_at(scenes, with(which, 1)), film_at(scenes, corrected_reading()), ""};
}

double radius_of(const Scene& scene, double reduced_radius) {
  return hertz_point(scene.load, scene.bodies.effective_modulus, reduced_radius).radius;
}

std::optional<double> onset_film_parameter(const PaperScenes& scenes, const Reading& reading) {
  const auto onset = explicit_onset(ReadContact(scenes.scene[smooth], reading), ReadInlet(reading),
                                    {OnsetRule::film_maximum, 0});
  if (!onset) return std::nullopt;
  return onset->film_parameter;
}

// Friction of the smooth surface at 0.1 m/s.
double friction_under(const PaperScenes& scenes, const Reading& reading) {
  const ReadContact contact(scenes.scene[smooth], reading);
  return contact.friction(contact.point(0.1, ReadInlet(reading)), friction_law(reading));
}

Evidence evidence(const std::string& id, const PaperScenes& scenes) {
  const Scene& scene = scenes.scene[smooth];
  const Surface& surface = scene.surface;
  const double roughness =
      surface.summit_density * surface.summit_radius * surface.summit_height_sd;  // nβσ_s
  const Reading corrected = corrected_reading();
  constexpr double pi = std::numbers::pi;
  if (id == "E1") {
    const double compliance = (1 - 0.3 * 0.3) / 210e9;
    return {"1/E′ of two identical bodies, 210 GPa and 0.3, in 1/Pa: minus; plus",
            0.5 * (compliance - compliance), 0.5 * (compliance + compliance), "0 is a rigid body"};
  }
  if (id == "E2") {
    const Reading all_plain = with(
        Switch::speed_modulus, 1, with(Switch::material_modulus, 1, with(Switch::load_modulus, 1)));
    return {"flooded film of the smooth surface at 1 m/s, m: E* throughout; 2E* throughout",
            film_at(scenes, all_plain), film_at(scenes, corrected), ""};
  }
  if (id == "E3") return share_under(scenes, Switch::asperity_prefactor, "8√2/15; 16√2/15");
  if (id == "E4") return share_under(scenes, Switch::nominal_area, "a²; πa²");
  if (id == "E5")
    return {"∫ over s from λ = 2 up: of φ(s−λ); of (s−λ) φ(s)", gaussian_moment(Order::zero, 0.0),
            gaussian_moment(Order::one, 2.0), "the printed one is so at any λ"};
  if (id == "E6") {
    // The real area ratio, with lengths in units of 1/scale m.
    const auto area = [&](double scale, bool as_printed) {
      const double n = surface.summit_density / (scale * scale);
      const double beta = surface.summit_radius * scale, sd = surface.summit_height_sd * scale;
      const double moment = gaussian_moment(Order::two, 0.0);
      return as_printed ? pi * n * beta * sd * sd * moment
                        : std::pow(pi * n * beta * sd, 2) * moment;
    };
    return {"area ratio in mm over the same in m: as printed; right",
            area(1e3, true) / area(1, true), area(1e3, false) / area(1, false),
            "a ratio keeps its value"};
  }
  if (id == "E7")
    return {"real area ratio of the smooth surface at λ = 1: as printed, with F_1; with F_2",
            pi * roughness * gaussian_moment(Order::one, 1.0 - surface.summit_plane_offset),
            pi * pi * roughness * roughness *
                gaussian_moment(Order::two, 1.0 - surface.summit_plane_offset),
            ""};
  if (id == "E8")
    return {"D_d/σ_s from D_d = 0.82σ: σ_s = 1.4σ; σ = 1.4σ_s", 0.82 / 1.4, 0.82 * 1.4,
            "Table 1: 1.146"};
  if (id == "E9") return share_under(scenes, Switch::offset_planes, "offset 2D_d; D_d");
  if (id == "E10") {
    // ψ = a^{1/3} x/(2Rh)^exponent, with all lengths multiplied by `scale`.
    const auto length = [&](double scale, double exponent) {
      const double a = radius_of(scene, scene.bodies.reduced_radius) * scale;
      return std::cbrt(a) * a /
             std::pow(2 * scene.bodies.reduced_radius * 1e-7 * scale * scale, exponent);
    };
    return {"ψ in mm over ψ in m: exponent 3/2; 2/3", length(1e3, 1.5) / length(1, 1.5),
            length(1e3, 2.0 / 3) / length(1, 2.0 / 3), "ψ is dimensionless"};
  }
  if (id == "E11") {
    const ReadInlet inlet(with(Switch::inlet, 3));
    return {"h*/h_oil at the flooded film of 0.01 h_oil: as printed, which is so at any; right",
            0.01 * inlet.film_ratio(0.01), 0.01 * ReadInlet(corrected).film_ratio(0.01),
            "a starved film above the flooded one"};
  }
  if (id == "E13")
    return {"λ at the greatest film: line gap, as printed and kept; circular gap, right",
            onset_film_parameter(scenes, corrected),
            onset_film_parameter(scenes, with(Switch::gap, 1)), "C2: 1.4"};
  if (id == "E14")
    return {"constant of the film: 2.69(1 − 0.6 e^−0.73); 2.69(1 − 0.61 e^−0.73)",
            2.69 * (1 - 0.6 * std::exp(-0.73)), hamrock_dowson_constant(1.0), "1.22: 1.899"};
  if (id == "E15") {
    PaperScenes changed = scenes;
    scale(changed, rough, Field::summit_density,
          scene.lubricant.viscosity / scenes.scene[rough].surface.summit_density);
    return slow_share("the viscosity for n; n", slow_asperity_share(changed, corrected, rough),
                      slow_asperity_share(scenes, corrected, rough));
  }
  if (id == "E17") return share_under(scenes, Switch::summit_radius, "β = 0.1 µm; 10 µm");
  if (id == "E18")
    return {
        "contact radius over reduced radius: R in mm; in m",
        radius_of(scene, 1e-3 * scene.bodies.reduced_radius) / (1e-3 * scene.bodies.reduced_radius),
        radius_of(scene, scene.bodies.reduced_radius) / scene.bodies.reduced_radius,
        "Hertz: far below 1"};
  if (id == "E19")
    return {"friction of the smooth surface at 0.1 m/s: limiting stress; Eyring's law",
            friction_under(scenes, with(Switch::shear, 1)), friction_under(scenes, corrected), ""};
  if (id == "E20")
    return {"friction of the smooth surface at 0.1 m/s: ambient viscosity; Barus' law",
            friction_under(scenes, with(Switch::viscosity, 1)), friction_under(scenes, corrected),
            ""};
  if (id == "E21") {
    PaperScenes half = scenes;
    scale(half, smooth, Field::reduced_radius, 0.5);
    return {
        "flooded film of the smooth surface at 1 m/s, m: half the ball's radius; the ball's radius",
        film_at(half, corrected), film_at(scenes, corrected), ""};
  }
  if (id == "E23")
    return film_under(scenes, Switch::speed_modulus, "E* in U alone; 2E* throughout");
  if (id == "E24") return film_under(scenes, Switch::speed, "the sum of the speeds; their mean");
  if (id == "E25") {
    Evidence found = film_under(scenes, Switch::film_constant, "constant 2.69; 1.899");
    found.decided_by = "1.22: 1.899";
    return found;
  }
  if (id == "E26") {
    const Summits<double> any = summits_from_spectral_moments(1.0, 1.0, 2.0);
    return {"(D_d/σ_s) nβσ_s: of Table 1, kept; of an isotropic Gaussian face",
            surface.summit_plane_offset * roughness,
            any.summit_plane_offset * any.summit_density * any.summit_radius * any.summit_height_sd,
            "Nayak (1971), McCool (1987)"};
  }
  if (id == "E12" || id == "E16" || id == "E22") return {};
  throw std::runtime_error(fmt::format("{}: nothing computes this erratum", id));
}

}  // namespace

std::vector<Erratum> read_errata(const std::string& path, const PaperScenes& scenes) {
  std::vector<Erratum> errata;
  verification::each_published_row(path, [&](const auto& row) {
    const Evidence found = evidence(row.text("erratum"), scenes);
    errata.push_back({row.text("erratum"), row.text("place"), row.text("printed"),
                      row.text("right"), row.text("settled_by"), row.text("kind"),
                      row.text("switch_or_reason"), found.what, found.printed, found.right,
                      found.decided_by});
  });
  return errata;
}

}  // namespace tribo::reproduction
