// SPDX-License-Identifier: Apache-2.0
// The films of a contact with smooth faces in a flooded inlet by each law of its shape, side by
// side.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tribo {
template <class T>
class MixedContact;
}

namespace tribo::catalogue {

struct LawFilm {
  std::string_view law;
  bool is_minimum;     // else the central film
  double film;         // m
  std::string beyond;  // why the contact is not in the range of the law; empty where it is
  bool is_known;       // is it known whether the contact is in that range?
  bool is_of_scene;    // is it closures.film?
  std::string_view source;
};

// The films of all laws of the contact's shape, points or lines, but for the tables of solved
// films, at a speed above 0 in m/s. Errors are within the contract of each law's function; NaN
// where the law is undefined at these numbers.
std::vector<LawFilm> law_films(const MixedContact<double>& contact, double speed);

}  // namespace tribo::catalogue
