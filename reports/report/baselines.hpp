// SPDX-License-Identifier: Apache-2.0
// What the slow targets left in reference/baselines, with its commit, date and machine.
#pragma once

#include <exception>
#include <nlohmann/json.hpp>
#include <string>

#include "report/project_files.hpp"
#include "report/text_table.hpp"

namespace tribo::report {

// A baseline, or the reason why there is none.
struct Baseline {
  nlohmann::json content;
  std::string missing;
};

Baseline read_baseline(const ReportPlaces& places, const char* name);

// “Measured on 2026-11-21 at commit 0123abcd, in 600 s; …”
std::string provenance(const nlohmann::json& baseline);

// What a table says when its source cannot be used.
template <class Make>
TextTable made_or_excused(const char* caption, Make&& make) {
  try {
    return make();
  } catch (const std::exception& error) {
    return {caption, {}, {}, {}, error.what()};
  }
}

}  // namespace tribo::report
