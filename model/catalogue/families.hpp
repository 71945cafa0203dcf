// SPDX-License-Identifier: Apache-2.0
// The entries of the catalogue; each family has a file.
#pragma once

#include <array>
#include <span>

#include "catalogue/catalogue.hpp"

namespace tribo::catalogue {

std::span<const Function> two_bodies();
std::span<const Function> rough_contact();
std::span<const Function> smooth_contact();
std::span<const Function> films();
std::span<const Function> inlets();
std::span<const Function> load_sharing_rules();
std::span<const Function> liquids();
std::span<const Function> surfaces();

}  // namespace tribo::catalogue
