// SPDX-License-Identifier: Apache-2.0
// The film of a contact, taken as smooth and flooded, by each film law for its shape.
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
  std::string beyond;  // why the contact is not in the range of the law; empty if it is
  bool is_known;       // is it known whether the contact is in that range?
  bool is_of_scene;    // is it closures.film?
  std::string_view source;
};

// The films at a speed above 0 in m/s by all laws for the contact's shape, points or lines, except
// the tables of solved films. Errors are within the contract of each law's function. A film is NaN
// if its law is undefined at these numbers.
std::vector<LawFilm> law_films(const MixedContact<double>& contact, double speed);

}  // namespace tribo::catalogue
