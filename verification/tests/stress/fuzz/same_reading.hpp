// SPDX-License-Identifier: Apache-2.0
// Are two readings of a scene equal in every field and message?
#pragma once

#include <algorithm>
#include <tuple>
#include <vector>

#include "tribo/scene_reader.hpp"

namespace tribo::fuzz {

inline auto values_of(const Scene& scene) {
  const auto& [id, load, speeds, outputs, surface, bodies, lubricant, supply, friction, closures] =
      scene;
  const auto& [list, from, to, count, spacing] = speeds;
  const auto& [density, radius, height_sd, offset, planes, moments] = surface;
  const auto& [modulus, reduced_radius, ellipticity, radius_x, radius_y, length, both] = bodies;
  const auto of_body = [](const Body& body) {
    return std::tuple(body.modulus, body.poisson_ratio, body.radius_x, body.radius_y);
  };
  const auto& [viscosity, pressure_viscosity, eyring_stress] = lubricant;
  const auto& [boundary_coefficient, slide_roll_ratio, fluid, law] = friction;
  const auto& [asperity, starvation, damiens_exponent, film] = closures;
  return std::tuple_cat(
      std::tuple(id, load, list, from, to, count, spacing, density, radius, height_sd, offset),
      std::tuple(moments.m0, moments.m2, moments.m4),
      std::tuple(planes, modulus, reduced_radius, ellipticity, viscosity, pressure_viscosity),
      std::tuple(eyring_stress, supply.kind, supply.value, boundary_coefficient, slide_roll_ratio),
      std::tuple(fluid, law, asperity, starvation, damiens_exponent, film, radius_x, radius_y,
                 length),
      of_body(both[0]), of_body(both[1]));
}

inline bool same(const Scene& left, const Scene& right) {
  return values_of(left) == values_of(right) && left.outputs == right.outputs;
}

inline bool same_lines(const std::vector<InputProblem>& left,
                       const std::vector<InputProblem>& right) {
  return std::equal(
      left.begin(), left.end(), right.begin(), right.end(),
      [](const InputProblem& a, const InputProblem& b) { return a.line() == b.line(); });
}

inline bool same(const SceneReading& left, const SceneReading& right) {
  return left.id == right.id && same_lines(left.errors, right.errors) &&
         same_lines(left.warnings, right.warnings) &&
         left.scene.has_value() == right.scene.has_value() &&
         (!left.scene || same(*left.scene, *right.scene));
}

}  // namespace tribo::fuzz
