// SPDX-License-Identifier: Apache-2.0
#include "page/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <utility>

#include "page/facts.hpp"
#include "page/project_files.hpp"
#include "page/rendering.hpp"
#include "tribo/batch.hpp"
#include "tribo/outputs.hpp"
#include "tribo/version.hpp"

namespace tribo::report {
namespace {

using Progress = std::function<void(std::string_view)>;

struct FactsMaker {
  std::string_view group;
  std::array<std::string_view, 3> sections;  // of the page that need them
  std::string_view step;                     // for the progress line; empty: it takes no time
  std::function<Json()> make;
};

std::vector<FactsMaker> makers(const ReportPlaces& places, const std::vector<Case>& cases) {
  return {
      {"paper", {"figures", "comparison", "model"}, "", [&] { return paper_facts(places, cases); }},
      {"contacts", {"contacts"}, "", [&] { return contacts_facts(places); }},
      {"ellipse_fits", {"work-precision"}, "", [&] { return ellipse_fits_facts(places); }},
      {"skipped_work",
       {"skipped-work"},
       "counting work",
       [&] { return skipped_work_facts(cases); }},
  };
}

bool is_needed(const FactsMaker& maker, const std::vector<std::string>& sections) {
  return sections.empty() ||
         std::any_of(sections.begin(), sections.end(), [&](const std::string& id) {
           return std::find(maker.sections.begin(), maker.sections.end(), id) !=
                  maker.sections.end();
         });
}

// The facts of which Python makes the groups of report.json, or why they are missing.
Json facts_json(const ReportPlaces& places, const std::vector<Case>& cases,
                const std::vector<std::string>& sections, const Progress& progress) {
  Json facts = Json::object();
  for (const FactsMaker& maker : makers(places, cases)) {
    if (!is_needed(maker, sections)) continue;
    if (!maker.step.empty()) progress(maker.step);
    Json& made = facts[std::string(maker.group)];
    try {
      made = maker.make();
    } catch (const ReportError&) {
      throw;
    } catch (const std::exception& error) {
      made = {{"missing", error.what()}};
    }
  }
  progress("");
  return facts;
}

// The columns of tables of points.
Json outputs_json() {
  Json outputs = Json::array();
  for (const OutputInfo& one : output_infos)
    outputs.push_back({{"name", one.name}, {"unit", one.unit}, {"meaning", one.meaning}});
  return outputs;
}

}  // namespace

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

std::string compiler_name() {
#ifdef __clang__
  return __VERSION__;
#else
  return "g++ " __VERSION__;
#endif
}

Report write_report(const ReportOptions& options, const Progress& progress) {
  const ReportPlaces places = find_places(options);
  ReadCases read = read_cases(places);
  const Json request{{"version", version},
                     {"commit", options.commit},
                     {"compiler", compiler_name()},
                     {"processor", processor_name()},
                     {"instruction_set", instruction_set()},
                     {"outputs", outputs_json()},
                     {"sections", options.sections},
                     {"facts", facts_json(places, read.cases, options.sections, progress)}};
  const nlohmann::json told =
      make_data(places, request.dump(-1, ' ', false, Json::error_handler_t::replace));

  Report report;
  report.folder = places.out.string();
  report.verdict = told["verdict"].get<std::string>();
  report.warnings = std::move(read.warnings);
  report.written = told["written"].get<std::vector<std::string>>();
  Rendering rendering = render(places);
  report.has_page = rendering.has_page;
  report.undrawn = std::move(rendering.undrawn);
  for (std::string& path : rendering.written) report.written.push_back(std::move(path));
  return report;
}

}  // namespace tribo::report
