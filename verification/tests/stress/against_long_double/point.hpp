// SPDX-License-Identifier: Apache-2.0
// The points at which the model in double is held against itself in long double. A point follows
// from seed and index alone, so that any of them can be looked at again, whatever number of threads
// found it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "support/enclosure.hpp"
#include "tribo/contract.hpp"
#include "tribo/scene.hpp"

namespace tribo::verification {

// What is tallied: a name, and what the model promises of it.
struct Row {
  std::string name;
  Contract contract;
};
const std::vector<Row>& rows();

enum class Kind : std::uint8_t {
  scene,          // of steel, as built
  extreme_scene,  // decades beyond what can be built
  load_sharing,   // K and λ₀ from 1e-300 to 1e300, and K about its critical value
  film_ratio,     // r from 1e-300 to 1e300, and about 1
  moment,         // d from −45 to 45, all orders, and the neighbours of every branch
};

struct Point {
  Kind kind = Kind::scene;
  Scene scene;                              // of a scene; of the others only the closures
  double first = 0, second = 0, third = 0;  // K, δ, λ₀ | r, γ | d
};

Point point_at(std::uint64_t seed, std::uint64_t index);

// Names and numbers that define the point.
std::vector<std::pair<std::string, double>> inputs_of(const Point& point);

// A number in both types, under its row.
struct Measured {
  std::size_t row = 0;
  double got = 0;
  long double expected = 0;
};

struct Evaluation {
  std::vector<Measured> numbers;
  bool states_differ = false;  // regime, inlet, whether friction is defined; a share beyond [0, 1]
  std::size_t state_row = 0;   // its row, where the point has states
  // The condition number of one of the numbers, at least 1; costs more than the rest.
  std::function<double(std::size_t)> condition;
};

Evaluation evaluate(const Point& point);

// The numbers of `evaluate` as enclosures, in its order. Throws std::runtime_error where a root has
// no proof; empty where a branch was not certain.
std::vector<Enclosure> enclose(const Point& point);

}  // namespace tribo::verification
