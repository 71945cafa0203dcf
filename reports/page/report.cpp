// SPDX-License-Identifier: Apache-2.0
#include "page/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>

#include "page/environment.hpp"
#include "page/groups.hpp"
#include "page/rendering.hpp"
#include "page/report_error.hpp"
#include "page/write_file.hpp"
#include "tribo/batch.hpp"
#include "tribo/outputs.hpp"
#include "tribo/scene_reader.hpp"
#include "tribo/version.hpp"

namespace tribo::report {
namespace {

using Progress = std::function<void(std::string_view)>;

// A section of the page with the groups that its template reads, in the order of the page
// (render/sections.py).
struct SectionNeeds {
  std::string_view id;
  std::array<std::string_view, 2> groups;
};
constexpr SectionNeeds all_sections[] = {
    {"figures", {"paper", "ledger"}},
    {"comparison", {"paper"}},
    {"claims", {"ledger"}},
    {"readings", {"ledger"}},
    {"requirements", {"ledger"}},
    {"uncertainty", {"ledger", "onset_uncertainty"}},
    {"misprints", {"ledger"}},
    {"model", {"paper", "ledger"}},
    {"contacts", {"contacts"}},
    {"film-solved", {"line_films"}},
    {"verification", {"certified"}},
    {"worst-inputs", {"stress"}},
    {"planted-faults", {"planted_faults"}},
    {"diagnosis", {"diagnosis"}},
    {"work-precision", {"work_precision", "ellipse_fits"}},
    {"skipped-work", {"skipped_work"}},
    {"gates", {"gates"}},
    {"sweep-speed", {"sweep_speed"}},
    {"environment", {"environment"}},
};

// The sections that are asked for, all if none is named, and the groups that they need.
struct Asked {
  std::vector<std::string_view> sections;
  std::set<std::string_view> groups;

  explicit Asked(const std::vector<std::string>& ids) {
    std::vector<std::string_view> known;
    for (const SectionNeeds& one : all_sections) {
      known.push_back(one.id);
      if (!ids.empty() && std::find(ids.begin(), ids.end(), one.id) == ids.end()) continue;
      sections.push_back(one.id);
      for (const std::string_view group : one.groups)
        if (!group.empty()) groups.insert(group);
    }
    for (const std::string& id : ids)
      if (std::find(known.begin(), known.end(), id) == known.end())
        throw ReportError(
            fmt::format("--section: {} is not one of {}", id, fmt::join(known, ", ")));
  }
};

std::string_view section_of(std::string_view group) {
  for (const std::size_t place : {0U, 1U})  // rather where the group comes first
    for (const SectionNeeds& one : all_sections)
      if (one.groups[place] == group) return one.id;
  return {};
}

std::string_view word(Standing standing) {
  return standing_words[static_cast<std::size_t>(standing)];
}

Json finding_json(const Finding& one) {
  Json finding{{"id", one.id},
               {"section", one.section},
               {"about", one.about == About::paper ? "paper" : "software"},
               {"standing", word(one.standing)}};
  if (!one.why.empty()) finding["why"] = one.why;
  return finding;
}

struct GroupMaker {
  std::string_view id;
  std::string_view step;                  // for the progress line; empty: it takes no time
  std::string_view how_to;                // Markdown: what gives the group where it is missing
  std::function<Group()> make = nullptr;  // null: Python makes it
  bool is_facts = false;                  // Python makes it of what is made here
};

std::vector<GroupMaker> makers(const ReportPlaces& places, const std::vector<Case>& cases) {
  return {
      {"paper", "solving the published scenes", "", [&] { return paper_facts(places, cases); },
       true},
      {"ledger", "judging the paper's claims under every reading", "`tribocheck reproduce`"},
      {"onset_uncertainty", "drawing onsets within the precision of Table 1",
       "`tribocheck sweep` of `reference/published/sweeps`"},
      {"contacts", "solving the contacts of machines", "The checkout's folder `reference/scenes`",
       [&] { return contacts_facts(places); }, true},
      {"line_films", "solving films of line contacts",
       "The checkout's folders `reference/ehl` and `reference/scenes`",
       [&] { return line_films_group(places); }},
      {"certified", "holding the model to the certified tables",
       "The checkout's folder `reference/exact`, or `make references`,"},
      {"stress", "", "`make stress`"},
      {"planted_faults", "", "`make faults`"},
      {"diagnosis", "", "`make diagnosis`"},
      {"work_precision", "", "`make work-precision`"},
      {"ellipse_fits", "", "The file `reference/mistakes.toml`",
       [&] { return ellipse_fits_group(places); }},
      {"skipped_work", "counting work", "", [&] { return skipped_work_group(cases); }},
      {"gates", "", "`make gate-proof`"},
      {"sweep_speed", "", "`make bench-sweep`"},
      {"environment", "", ""},
  };
}

// A group as groups/report.py takes it; its files of data are written.
Json group_json(const GroupMaker& maker, const ReportPlaces& places) {
  Json json{{"id", maker.id},
            {"section", section_of(maker.id)},
            {"step", maker.step},
            {"how_to", maker.how_to}};
  if (!maker.make) return json;
  Group group;
  try {
    group = maker.make();
    if (maker.is_facts) {
      json["facts"] = std::move(group.data);
      return json;
    }
  } catch (const ReportError&) {
    throw;
  } catch (const std::exception& error) {
    group.data = {{"missing", {{"why", error.what()}, {"how_to", maker.how_to}}}};
    group.findings = {{std::string(maker.id), std::string(section_of(maker.id)), About::software,
                       Standing::absent, error.what()}};
  }
  Json findings = Json::array(), not_run = Json::array(), files = Json::array();
  for (const Finding& one : group.findings) findings.push_back(finding_json(one));
  for (const NotRun& one : group.not_run)
    not_run.push_back({{"what", one.what}, {"why", one.why}, {"how_to", one.how_to}});
  for (const DataFile& file : group.files) {
    make_folder((places.out / file.path).parent_path());
    write_file(places.out / file.path, file.content);
    files.push_back(Json::array({file.path, nullptr}));
  }
  json["step"] = "";
  json["made"] = {{"data", std::move(group.data)},
                  {"findings", std::move(findings)},
                  {"not_run", std::move(not_run)},
                  {"files", std::move(files)}};
  return json;
}

}  // namespace

Report write_report(const ReportOptions& options, const Progress& progress) {
  const Asked asked(options.sections);
  const ReportPlaces places = find_places(options);
  ReadCases read = read_cases(places);
  make_folder(places.out / "data");
  make_folder(places.out / "figures");
  Json request{{"out", places.out.string()},
               {"root", places.root.string()},
               {"scenes", places.scenes.string()},
               {"reference", places.reference.string()},
               {"program", std::filesystem::read_symlink("/proc/self/exe").string()},
               {"version", version},
               {"commit", options.commit},
               {"compiler", compiler_name()},
               {"processor", processor_name()},
               {"instruction_set", instruction_set()},
               {"outputs", Json::array()},
               {"sections", asked.sections},
               {"groups", Json::array()}};
  for (const OutputInfo& one : output_infos)
    request["outputs"].push_back(
        {{"name", one.name}, {"unit", one.unit}, {"meaning", one.meaning}});
  for (const GroupMaker& maker : makers(places, read.cases)) {
    if (!asked.groups.contains(maker.id)) continue;
    if (maker.make && !maker.is_facts && !maker.step.empty()) progress(maker.step);
    request["groups"].push_back(group_json(maker, places));
  }
  progress("");
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
