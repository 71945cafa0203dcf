// SPDX-License-Identifier: Apache-2.0
#include "page/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

#include "page/comparison.hpp"
#include "page/drawing.hpp"
#include "page/environment.hpp"
#include "page/gates_section.hpp"
#include "page/ledger_section.hpp"
#include "page/page.hpp"
#include "page/paper_sections.hpp"
#include "page/paper_tables.hpp"
#include "page/pending_file.hpp"
#include "page/report_error.hpp"
#include "page/skipped_work.hpp"
#include "page/sweep_speed_section.hpp"
#include "page/verification_sections.hpp"
#include "page/work_precision_section.hpp"

namespace tribo::report {
namespace {

using Progress = std::function<void(std::string_view)>;

// In the order of the page, whose last section, what did not run, is always there.
constexpr std::array<std::string_view, 17> section_ids{
    "environment",    "claims",       "readings",       "requirements", "uncertainty",
    "sweep",          "misprints",    "figures",        "comparison",   "verification",
    "planted-faults", "worst-inputs", "work-precision", "skipped-work", "gates",
    "sweep-speed",    "inputs"};

class ReportWriter {
 public:
  ReportWriter(const ReportPlaces& places, const Progress& progress)
      : places_(places), draughtsman_(places, progress) {
    report.folder = places.out.string();
  }

  void write(const std::string& path, std::string_view content) {
    write_file(places_.out / path, content);
    report.written.push_back(path);
  }

  // The data of a section, and what is drawn from it.
  void write_files(Section& section) {
    for (const DataFile& file : section.data) {
      make_folder((places_.out / file.path).parent_path());
      write(file.path, file.content);
    }
    for (Figure& figure : section.figures) draw(figure, section);
  }

  Report report;

 private:
  void draw(Figure& figure, Section& section) {
    const bool gnuplot_was_there = draughtsman_.gnuplot_is_there();
    const std::string why = draughtsman_.draw(figure);
    if (why.empty()) {
      for (const std::string_view format : {"svg", "png"})
        report.written.push_back(picture_path(figure, format));
      return;
    }
    section.not_run.push_back({figure.heading, why, "gnuplot, and `make report`,"});
    if (draughtsman_.gnuplot_is_there())
      report.undrawn.push_back(why);
    else if (gnuplot_was_there)
      report.undrawn.push_back(why +
                               ": no figures, but data, page and table are "
                               "written (Debian: apt-get install gnuplot-nox)");
  }

  const ReportPlaces& places_;
  Draughtsman draughtsman_;
};

std::vector<SolvedCase> solve_all(const std::vector<Case>& cases, const Progress& progress) {
  std::vector<SolvedCase> solved;
  for (const Case& one : cases) {
    progress("solving " + one.file);
    solved.push_back(solve_case(one));
  }
  return solved;
}

Findings find(const ReportPlaces& places, const std::vector<Case>& cases,
              const Progress& progress) {
  ReportedValues reported(places);
  std::vector<SolvedCase> solved = solve_all(cases, progress);
  TwoSlopes slopes = two_slopes(find_solved(solved, "smooth", AsperityModel::greenwood_tripp));
  return {std::move(solved), std::move(slopes), std::move(reported)};
}

std::vector<std::string> introduction() {
  return {
      "D. Gasni (“Pengaruh kekasaran permukaan terhadap fenomena starvation pada point contact”, "
      "Universitas Andalas) computed film, load shares and friction of a starved, rough contact "
      "for three surfaces, with the asperity models of Greenwood and Tripp (GT) and of Greenwood "
      "and Williamson (GW). This page solves the same surfaces with the same models, the paper's "
      "misprints mended, and says how sure the numbers are."};
}

// Which sections are asked for: all, or some by their ids.
class Asked {
 public:
  explicit Asked(const std::vector<std::string>& ids) : ids_(ids) {
    for (const std::string& id : ids)
      if (std::find(section_ids.begin(), section_ids.end(), id) == section_ids.end())
        throw ReportError(
            fmt::format("--section: {} is not one of {}", id, fmt::join(section_ids, ", ")));
  }

  bool has(std::string_view id) const {
    return ids_.empty() || std::find(ids_.begin(), ids_.end(), id) != ids_.end();
  }
  bool has_any(std::initializer_list<std::string_view> ids) const {
    return std::any_of(ids.begin(), ids.end(), [this](std::string_view id) { return has(id); });
  }

 private:
  const std::vector<std::string>& ids_;
};

// The page's sections, in order. A part of the report is a function here that returns one.
std::vector<Section> sections(const ReportPlaces& places, const ReportOptions& options,
                              const Findings& findings,
                              const std::vector<ComparisonTable>& comparisons,
                              const Progress& progress) {
  const Asked asked(options.sections);
  std::vector<Section> all;
  const auto add = [&](std::string_view id, std::string_view step, const auto& make) {
    if (!asked.has(id)) return;
    if (!step.empty()) progress(step);
    all.push_back(make());
  };
  add("environment", "", [&] { return environment_section(places, options.commit); });
  // One ledger serves them all.
  if (asked.has_any({"claims", "readings", "requirements", "uncertainty", "sweep", "misprints"})) {
    progress("judging the paper's claims under every reading");
    std::vector<Section> of_ledger = ledger_sections(places);
    const bool is_excused = of_ledger.size() == 1;  // it stands for all of them
    for (Section& section : of_ledger)
      if (is_excused || asked.has(section.id)) all.push_back(std::move(section));
  }
  add("figures", "", [&] { return figures_section(findings, comparisons); });
  add("comparison", "", [&] { return comparison_section(findings, comparisons); });
  add("verification", "holding the model to the certified tables",
      [&] { return certified_section(places); });
  add("planted-faults", "", [&] { return planted_faults_section(places); });
  add("worst-inputs", "", [&] { return worst_inputs_section(places); });
  add("work-precision", "", [&] { return work_precision_section(places); });
  add("skipped-work", "counting work", [&] { return skipped_work_section(findings.solved); });
  add("gates", "", [&] { return gates_section(places); });
  add("sweep-speed", "", [&] { return sweep_speed_section(places); });
  add("inputs", "", [&] { return inputs_section(findings); });
  return all;
}

std::string tables_text(const std::vector<ComparisonTable>& comparisons) {
  std::string text;
  for (const ComparisonTable& comparison : comparisons)
    text += plain_table(text_table(comparison)) + '\n';
  return text;
}

}  // namespace

Report write_report(const ReportOptions& options,
                    const std::function<void(std::string_view)>& progress) {
  const ReportPlaces places = find_places(options);
  ReadCases read = read_cases(places);
  make_folder(places.out / "data");
  make_folder(places.out / "figures");
  const Findings findings = find(places, read.cases, progress);
  const std::vector<ComparisonTable> comparisons = compare(findings.solved, findings.reported);

  ReportWriter writer(places, progress);
  Page page{"Starvation and roughness in a point contact: the paper's figures, recomputed",
            introduction(), sections(places, options, findings, comparisons, progress)};
  for (Section& section : page.sections) writer.write_files(section);
  page.sections.push_back(not_run_section(page.sections));
  writer.write("report.json", json_page(page));
  writer.write("report.md", markdown_page(page));
  writer.write("index.html", html_page(page));
  writer.report.tables = tables_text(comparisons);
  writer.report.verdict = verdict_in_short(page);
  writer.report.warnings = std::move(read.warnings);
  return std::move(writer.report);
}

}  // namespace tribo::report
