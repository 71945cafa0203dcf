// SPDX-License-Identifier: Apache-2.0
// Onsets of starvation as a table, CSV or JSON.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "output.hpp"
#include "tribo/onset.hpp"

namespace tribo::cli {

class OnsetWriter {
 public:
  virtual ~OnsetWriter() = default;
  // All onsets of one scene.
  virtual void add(const Scene& scene, const std::vector<Onset<double>>& onsets) = 0;
  virtual void finish() {}
};

// format: "table", "csv" or "json".
std::unique_ptr<OnsetWriter> make_onset_writer(std::string_view format, OutputStream& output);

}  // namespace tribo::cli
