// SPDX-License-Identifier: Apache-2.0
#include "page/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "page/groups.hpp"
#include "page/ledger_tables.hpp"
#include "page/rendering.hpp"
#include "page/report_error.hpp"
#include "page/write_file.hpp"
#include "reproduction/ledger.hpp"
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

  bool has_section(std::string_view id) const {
    return std::find(sections.begin(), sections.end(), id) != sections.end();
  }

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

// Slow work that several groups share, done where the first of them needs it.
class Sources {
 public:
  Sources(const ReportPlaces& places, const std::vector<Case>& cases, const Progress& progress)
      : places_(places), cases_(cases), progress_(progress) {}

  const std::vector<SolvedCase>& solved() {
    if (solved_.empty())
      for (const Case& one : cases_) {
        progress_("solving " + one.file);
        solved_.push_back(solve_case(one));
      }
    return solved_;
  }
  const reproduction::Ledger& ledger() {
    if (!ledger_) {
      progress_("judging the paper's claims under every reading");
      reproduction::LedgerOptions options;
      options.published = places_.scenes.string();
      ledger_ = reproduction::make_ledger(options);
    }
    return *ledger_;
  }

 private:
  const ReportPlaces& places_;
  const std::vector<Case>& cases_;
  const Progress& progress_;
  std::vector<SolvedCase> solved_;
  std::optional<reproduction::Ledger> ledger_;
};

template <class... Words>
std::string in_line(fmt::format_string<Words...> form, Words&&... words) {
  return printable(fmt::format(form, std::forward<Words>(words)...), std::string::npos) + '\n';
}

struct GroupMaker {
  std::string_view id;
  std::string_view step;    // for the progress line; empty: it takes no time
  std::string_view how_to;  // Markdown: what gives the group where it is missing
  std::function<Group()> make;
};

std::vector<GroupMaker> makers(const ReportPlaces& places, const std::string& commit,
                               Sources& sources) {
  return {
      {"paper", "", "", [&] { return paper_group(places, sources.solved()); }},
      {"ledger", "", "`tribocheck reproduce`",
       [&] { return ledger_group(places, sources.ledger()); }},
      {"onset_uncertainty", "drawing onsets within the precision of Table 1",
       "`tribocheck sweep` of `reference/published/sweeps`",
       [&] { return onset_uncertainty_group(places, sources.ledger()); }},
      {"contacts", "solving the contacts of machines", "The checkout's folder `reference/scenes`",
       [&] { return contacts_group(places); }},
      {"line_films", "solving films of line contacts",
       "The checkout's folders `reference/ehl` and `reference/scenes`",
       [&] { return line_films_group(places); }},
      {"certified", "holding the model to the certified tables",
       "The checkout's folder `reference/exact`, or `make references`,",
       [&] { return certified_group(places); }},
      {"stress", "", "`make stress`", [&] { return stress_group(places); }},
      {"planted_faults", "", "`make faults`", [&] { return planted_faults_group(places); }},
      {"diagnosis", "", "`make diagnosis`", [&] { return diagnosis_group(places); }},
      {"work_precision", "", "`make work-precision`", [&] { return work_precision_group(places); }},
      {"ellipse_fits", "", "The file `reference/mistakes.toml`",
       [&] { return ellipse_fits_group(places); }},
      {"skipped_work", "counting work", "",
       [&] { return skipped_work_group(places, sources.solved()); }},
      {"gates", "", "`make gate-proof`", [&] { return gates_group(places); }},
      {"sweep_speed", "", "`make bench-sweep`", [&] { return sweep_speed_group(places); }},
      {"environment", "", "", [&, commit] { return environment_group(places, commit); }},
  };
}

// report.json as it grows, and the files of data.
class ReportData {
 public:
  ReportData(const ReportPlaces& places, const Asked& asked) : places_(places), asked_(asked) {
    json_ = {{"tribocheck", std::string(version)},
             {"sections", asked.sections},
             {"findings", Json::array()},
             {"not_run", Json::array()},
             {"files", Json::array()}};
  }

  void add(const GroupMaker& maker) {
    Group group;
    try {
      group = maker.make();
    } catch (const ReportError&) {
      throw;
    } catch (const std::exception& error) {
      group.data = {{"missing", {{"why", error.what()}, {"how_to", maker.how_to}}}};
      group.findings = {{std::string(maker.id), std::string(section_of(maker.id)), About::software,
                         Standing::absent, error.what()}};
    }
    json_[std::string(maker.id)] = std::move(group.data);
    for (const Finding& one : group.findings)
      if (asked_.has_section(one.section)) add(one);
    for (const NotRun& one : group.not_run)
      json_["not_run"].push_back({{"what", one.what}, {"why", one.why}, {"how_to", one.how_to}});
    for (const DataFile& file : group.files) {
      make_folder((places_.out / file.path).parent_path());
      write(file.path, file.content);
      json_["files"].push_back(file.path);
    }
  }

  void finish() {
    write("report.json", json_.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
  }

  bool has_ledger() const {
    return json_.contains("ledger") && json_["ledger"].contains("summary");
  }

  std::string verdict_in_short() const {
    std::string text;
    if (has_ledger())
      text += in_line("The paper: {}.", json_["ledger"]["summary"].get<std::string>());
    std::map<std::string, int> count;
    std::string lines;
    for (const Json& one : json_["findings"]) {
      const auto standing = one["standing"].get<std::string>();
      if (one["about"] == "software") ++count[standing];
      if (standing == "fails" || standing == "missed" || standing == "absent")
        lines += in_line("  {}: {}: {}",
                         standing == "fails"    ? "FAILS"
                         : standing == "absent" ? "not run"
                                                : "missed",
                         one["id"].get<std::string>(), one.value("why", ""));
    }
    return text +
           fmt::format(
               "This software: {} checks hold, {} fail, {} missed a target, {} did not run.\n",
               count["holds"], count["fails"], count["missed"], count["absent"]) +
           lines;
  }

  std::vector<std::string> written;

 private:
  void add(const Finding& one) {
    Json finding{{"id", one.id},
                 {"section", one.section},
                 {"about", one.about == About::paper ? "paper" : "software"},
                 {"standing", word(one.standing)}};
    if (!one.why.empty()) finding["why"] = one.why;
    json_["findings"].push_back(std::move(finding));
  }
  void write(const std::string& path, std::string_view content) {
    write_file(places_.out / path, content);
    written.push_back(path);
  }

  const ReportPlaces& places_;
  const Asked& asked_;
  Json json_;
};

}  // namespace

Report write_report(const ReportOptions& options, const Progress& progress) {
  const Asked asked(options.sections);
  const ReportPlaces places = find_places(options);
  ReadCases read = read_cases(places);
  make_folder(places.out / "data");
  make_folder(places.out / "figures");
  Sources sources(places, read.cases, progress);
  ReportData data(places, asked);
  for (const GroupMaker& maker : makers(places, options.commit, sources)) {
    if (!asked.groups.contains(maker.id)) continue;
    if (!maker.step.empty()) progress(maker.step);
    data.add(maker);
  }
  data.finish();

  Report report;
  report.folder = places.out.string();
  report.verdict = data.verdict_in_short();
  if (data.has_ledger()) report.table = plain_table(headline_table(sources.ledger()));
  report.warnings = std::move(read.warnings);
  report.written = std::move(data.written);
  progress("");
  Rendering rendering = render(places);
  report.has_page = rendering.has_page;
  report.undrawn = std::move(rendering.undrawn);
  for (std::string& path : rendering.written) report.written.push_back(std::move(path));
  return report;
}

}  // namespace tribo::report
