// SPDX-License-Identifier: Apache-2.0
// The mistakes of single functions, from the parts gone wrong.
#include <algorithm>

#include "conformance/mistake.hpp"
#include "conformance/wrong_parts.hpp"

namespace tribo::conformance {
namespace {

using nlohmann::json;
using Value = std::optional<double>;

double number(const json& inputs, const char* name) { return inputs.at(name).get<double>(); }

Mistake of_film(const WrongFilm& wrong) {
  return {
      "hamrock_dowson_central", wrong.name, wrong.text,
      [film = wrong.film](const json& in, std::string_view) -> Value {
        return film({number(in, "speed"), number(in, "viscosity"), number(in, "pressure_viscosity"),
                     number(in, "load"), number(in, "effective_modulus"),
                     number(in, "reduced_radius"), number(in, "ellipticity")});
      }};
}

StarvationClosure closure_of(const std::string& word) {
  const auto& words = starvation_closure_words;
  return static_cast<StarvationClosure>(std::find(words.begin(), words.end(), word) -
                                        words.begin());
}

Mistake of_inlet(const WrongInlet& wrong) {
  return {"starvation_ratio", wrong.name, wrong.text,
          [ratio = wrong.ratio](const json& in, std::string_view) -> Value {
            return ratio(closure_of(in.at("closure").get<std::string>()),
                         number(in, "flooded_over_inlet"), number(in, "damiens_exponent"));
          }};
}

Mistake of_sharing(const WrongSharing& wrong) {
  return {"load_sharing", wrong.name, wrong.text,
          [film = wrong.film_parameter](const json& in, std::string_view) -> Value {
            const SharingInputs s{in.at("asperity") == "greenwood_tripp",
                                  number(in, "flooded_film_parameter"), number(in, "stiffness"),
                                  number(in, "offset")};
            // Where powers underflow a mistake tells nothing.
            if (!(s.film > 1e-250 && s.film < 1e250 && s.stiffness < 1e250)) return std::nullopt;
            return film(s);
          }};
}

}  // namespace

std::vector<Mistake> function_mistakes() {
  std::vector<Mistake> all;
  for (std::vector<Mistake> part : {hertz_mistakes(), moment_mistakes()})
    for (Mistake& one : part) all.push_back(std::move(one));
  for (const WrongFilm& one : wrong_films()) all.push_back(of_film(one));
  for (const WrongInlet& one : wrong_inlets()) all.push_back(of_inlet(one));
  for (const WrongSharing& one : wrong_sharings()) all.push_back(of_sharing(one));
  return all;
}

}  // namespace tribo::conformance
