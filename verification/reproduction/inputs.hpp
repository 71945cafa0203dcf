// SPDX-License-Identifier: Apache-2.0
// The paper's scenes, and each of its inputs with its print precision and plausible range.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "reproduction/observation.hpp"
#include "tribo/scene.hpp"

namespace tribo::reproduction {

struct PaperScenes {
  PerContact<Scene> scene;         // rough, medium, smooth with GT; smooth with GW
  double film_constant_scale = 1;  // a factor on the film formula
  double speed_scale = 1;          // a factor on the speed in it

  double film_scale() const;
};

// From rough.toml, medium.toml, smooth.toml and smooth_gw.toml of a folder. Throws
// std::runtime_error with one line where a file cannot be read or lacks what readings need: among
// others a circle, the inputs of friction, h_oil/σ_s, and a range of speeds, the same in all four.
PaperScenes read_paper_scenes(const std::string& folder);

enum class Field : std::uint8_t {
  summit_density,
  summit_radius,
  summit_height_sd,
  summit_plane_offset,
  effective_modulus,
  reduced_radius,
  viscosity,
  pressure_viscosity,
  eyring_stress,
  load,
  inlet_film_ratio,
  boundary_coefficient,
  film_constant,  // a factor on the film formula
  speed,          // a factor on the speed in it
};
std::string_view name(Field field);

// One line of inputs.tsv.
struct Input {
  Field field;
  std::string surface;  // "rough", "medium", "smooth" or "all"
  double value, last_digit, low, high;
  std::string unit, reason;

  bool is_of(std::size_t contact) const;
};
// Reads inputs.tsv. Throws std::runtime_error with one line.
std::vector<Input> read_inputs(const std::string& path);

// Multiplies an input of one contact, or of all. Only scale_all() changes the two factors of the
// film formula, film_constant and speed: they belong to all contacts.
void scale(PaperScenes& scenes, std::size_t contact, Field field, double factor);
void scale_all(PaperScenes& scenes, Field field, double factor);

}  // namespace tribo::reproduction
