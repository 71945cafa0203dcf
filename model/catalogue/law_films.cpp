// SPDX-License-Identifier: Apache-2.0
#include "catalogue/law_films.hpp"

#include <fmt/format.h>

#include <cmath>

#include "catalogue/catalogue.hpp"
#include "tribo/contact_regime.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/smooth_contact.hpp"
#include "tribo/validity.hpp"

namespace tribo::catalogue {
namespace {

// Is it known whether a film law was fitted to this ellipticity? Every law of points was fitted to
// circles.
bool is_range_known(const FilmLaw& law, double ellipticity) {
  return ellipticity == 1 || law.least_ellipticity > 0;
}

// Why the contact is not in the range of a film law, or why that is not known; empty if it is.
std::string beyond_of(const FilmLaw& law, double ellipticity, LubricationRegime regime,
                      double factor) {
  if (!(ellipticity >= least_fitted_ellipticity(law) && ellipticity <= law.greatest_ellipticity))
    return fmt::format("k is {:.5g}, and it was fitted to {:.5g} to {:.5g}", ellipticity,
                       law.least_ellipticity, law.greatest_ellipticity);
  const LubricationRegime own = regime_of(law);
  if (own != regime) {
    const std::string_view near = factor <= greatest_factor_of_regimes
                                      ? ", next to the border: films of both regimes are alike"
                                      : "";
    return fmt::format("the law is of {} contacts{}", name(own), near);
  }
  if (!is_range_known(law, ellipticity))
    return fmt::format("k is {:.5g}, and the range that it was fitted to is not known",
                       ellipticity);
  return {};
}

bool is_of_minimum(const Function& function) {
  return function.results.front().meaning.starts_with("h_min");
}

}  // namespace

std::vector<LawFilm> law_films(const MixedContact<double>& contact, double speed) {
  const auto& scene = contact.scene_numbers();
  const ContactShape shape = contact.words().shape;
  const bool is_line = shape == ContactShape::line;
  const auto numbers = similarity_of(shape, scene, speed);
  const LubricationRegime regime = regime_of(shape, scene, numbers);
  std::vector<LawFilm> films;
  for (const Function& function : functions()) {
    const FilmLaw* const law = function.film_law;
    const bool is_of_shape = law != nullptr && law->is_of_lines == is_line;
    if (is_of_shape && scene.pressure_viscosity == 0 && law->material_exponent.p != 0)
      films.push_back({function.name, is_of_minimum(function), std::nan(""),
                       "it has no film where the viscosity does not rise with pressure", true,
                       false, function.source});
    else if (is_of_shape) {
      const double ellipticity = is_line ? 1 : scene.ellipticity;
      const bool is_known = regime_of(*law) != regime || is_range_known(*law, ellipticity);
      const double factor = factor_between(regime, regime_of(*law), shape, scene, numbers);
      films.push_back({function.name, is_of_minimum(function),
                       smooth_film(*law, shape, scene, speed),
                       beyond_of(*law, ellipticity, regime, factor), is_known,
                       law == &contact.film(), function.source});
    }
  }
  // The laws without fixed exponents hold in all regimes.
  for (const NamedFilmLaw& named : named_film_laws)
    if (!named.law->has_fixed_exponents() && !named.law->is_solved() &&
        named.law->is_of_lines == is_line)
      films.push_back({named.word,
                       false,
                       smooth_film(*named.law, shape, scene, speed),
                       {},
                       true,
                       named.law == &contact.film(),
                       function_named(named.word)->source});
  return films;
}

}  // namespace tribo::catalogue
