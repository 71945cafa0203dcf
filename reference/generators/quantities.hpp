// SPDX-License-Identifier: Apache-2.0
// The tables of reference/exact: their headers, and their rows one by one, so that any of them can
// be made again alone.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "generators/table.hpp"

namespace tribo::reference {

struct Table {
  Header header;
  std::vector<std::function<Row()>> rows;  // each independent of the others
};

Table gaussian_moments();
Table load_sharing_roots();
Table starvation_ratios();
Table onset_constants();
Table effective_moduli();
Table reduced_radii();
Table hertz_contacts();
Table elliptical_contact_values();
Table line_contact_values();
std::vector<std::string> film_laws();
Table film_table(const std::string& law);  // law: one of film_laws()
Table moes_lines();
Table regime_films();
Table thermal_reductions();
Table densities();
Table pressure_viscosities(const std::string& law);  // barus_viscosity, roelands_viscosity
Table temperature_viscosities();
Table summits_of_moments();
Table operating_points();

}  // namespace tribo::reference
