// SPDX-License-Identifier: Apache-2.0
// Limits of validity as texts and as JSON: the table "is the model valid here?", and the warning
// about limits that scenes go beyond.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "messages.hpp"
#include "tribo/validity.hpp"

namespace tribo::cli {

// A limit that is passed: "lubricant.viscosity 20.2 Pa·s (1e-5 Pa·s to 10 Pa·s; perhaps mPa·s was
// meant)", "hertz_pressure 6.8 GPa (at most 4 GPa)". The short form leaves out which results the
// limit touches, and the advice.
std::string passed_text(const Validity& limit, bool is_short = false);

// The table of a scene: assumption, value here, limit, whether it holds, and the word to accept it.
void append_validity(Text& to, std::string_view id, const std::vector<Validity>& limits);
// The same rows as JSON, in SI units.
nlohmann::ordered_json validity_json(const std::vector<Validity>& limits);

// The limits that the scenes of a command pass and do not accept.
class Warnings {
 public:
  // `source`: the file, as messages name it. `id`: of the scene.
  void add(std::string_view source, std::string_view id, const std::vector<Validity>& passed);
  bool any() const { return !scenes_.empty(); }
  // Writes all of them in their short form, in one line on stderr; nothing if there are none.
  // `where` says where these limits are explained.
  void tell(std::string_view where) const;
  // The member `warnings` of a document: an empty list where there are none.
  nlohmann::ordered_json json() const;

 private:
  struct OfScene {
    std::string source, id;
    std::vector<Validity> passed;
  };
  std::vector<OfScene> scenes_;
};

}  // namespace tribo::cli
