// SPDX-License-Identifier: Apache-2.0
#include "report/report.hpp"

#include <fmt/format.h>

#include <utility>

#include "report/comparison.hpp"
#include "report/drawing.hpp"
#include "report/environment.hpp"
#include "report/gates_section.hpp"
#include "report/ledger_section.hpp"
#include "report/page.hpp"
#include "report/paper_sections.hpp"
#include "report/paper_tables.hpp"
#include "report/pending_file.hpp"
#include "report/skipped_work.hpp"
#include "report/sweep_speed_section.hpp"
#include "report/verification_sections.hpp"
#include "report/work_precision_section.hpp"

namespace tribo::report {
namespace {

using Progress = std::function<void(std::string_view)>;

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

// The page's sections, in order. A part of the report is a function here that returns one.
std::vector<Section> sections(const ReportPlaces& places, const ReportOptions& options,
                              const Findings& findings,
                              const std::vector<ComparisonTable>& comparisons,
                              const Progress& progress) {
  std::vector<Section> all;
  all.push_back(environment_section(places, options.commit));
  progress("judging the paper's claims under every reading");
  for (Section& section : ledger_sections(places)) all.push_back(std::move(section));
  all.push_back(figures_section(findings, comparisons));
  all.push_back(comparison_section(findings, comparisons));
  progress("holding the model to the certified tables");
  all.push_back(certified_section(places));
  all.push_back(planted_faults_section(places));
  all.push_back(worst_inputs_section(places));
  all.push_back(work_precision_section(places));
  progress("counting work");
  all.push_back(skipped_work_section(findings.solved));
  all.push_back(gates_section(places));
  all.push_back(sweep_speed_section(places));
  all.push_back(inputs_section(findings));
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
  writer.report.warnings = std::move(read.warnings);
  return std::move(writer.report);
}

}  // namespace tribo::report
