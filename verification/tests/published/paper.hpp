// SPDX-License-Identifier: Apache-2.0
// The paper's scenes and claims, and the model's own onset, as all tests of the readings take them.
#pragma once

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "reproduction/ledger.hpp"
#include "sampling/sampler.hpp"
#include "support/judge.hpp"
#include "tribo/mixed_contact.hpp"
#include "tribo/onset.hpp"

namespace tribo::reproduction {

using verification::is_close;
using verification::is_within;
using verification::Sampler;

inline const std::string published = TRIBOCHECK_SOURCE_DIR "/reference/published";

inline const PaperScenes& scenes() {
  static const PaperScenes read = read_paper_scenes(published);
  return read;
}
inline const std::vector<Item>& items() {
  static const std::vector<Item> read = read_claims(published + "/claims.tsv");
  return read;
}
inline const Item& item(std::string_view id) {
  return *std::find_if(items().begin(), items().end(),
                       [&](const Item& one) { return one.id == id; });
}

inline Reading random_reading(Sampler& sampler) {
  return reading_at(
      static_cast<std::size_t>(sampler.uniform(0, static_cast<double>(reading_count()))));
}

inline Onset<double> model_onset(const Scene& scene,
                                 OnsetCriterion criterion = OnsetCriterion::film_maximum,
                                 double departure = 0.05) {
  return onset(MixedContact<double>(scene), scene, criterion, departure);
}

}  // namespace tribo::reproduction
