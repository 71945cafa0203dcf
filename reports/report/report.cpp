// SPDX-License-Identifier: Apache-2.0
#include "report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <system_error>
#include <utility>

#include "report/comparison.hpp"
#include "report/data_files.hpp"
#include "report/gnuplot.hpp"
#include "report/page.hpp"
#include "report/pending_file.hpp"
#include "report/performance_tables.hpp"
#include "report/report_error.hpp"
#include "report/verification_tables.hpp"
#include "tribo/version.hpp"

namespace tribo::report {
namespace {

namespace fs = std::filesystem;

class ReportWriter {
 public:
  ReportWriter(const ReportPlaces& places, const std::function<void(std::string_view)>& progress)
      : places_(places), progress_(progress) {
    report.folder = places.out.string();
  }

  void write(const std::string& path, std::string_view content) {
    write_file(places_.out / path, content);
    report.written.push_back(path);
  }

  void draw(Figure& figure) {
    figure.drawn = gnuplot_is_there_;
    for (const std::string_view format : {"svg", "png"})
      figure.drawn = figure.drawn && draw_as(figure, format);
    if (!figure.drawn) forget(figure);
  }

  Report report;

 private:
  bool draw_as(const Figure& figure, std::string_view format) {
    const std::string path = picture_path(figure, format);
    progress_("drawing " + path);
    PendingFile file(places_.out / path);
    const GnuplotRun run = run_gnuplot(
        places_.gnuplot / "style.gp",
        {(places_.gnuplot / fmt::format("{}.gp", figure.stem)).string(), std::string(format),
         file.temporary().string(), (places_.out / "data").string(), std::string(figure.stem),
         std::to_string(figure.height), figure.heading(),
         fmt::format("{}; tribocheck {}", figure.scene, version)});
    if (run.end != GnuplotEnd::drawn) {
      gnuplot_is_there_ = run.end != GnuplotEnd::not_found;
      report.undrawn.push_back(run.end == GnuplotEnd::not_found
                                   ? run.message +
                                         ": no figures, but data, page and table are "
                                         "written (Debian: apt-get install gnuplot-nox)"
                                   : fmt::format("{}: {}", path, run.message));
      return false;
    }
    file.commit();
    report.written.push_back(path);
    return true;
  }

  // An old picture would not belong to the new data.
  void forget(const Figure& figure) {
    for (const std::string_view format : {"svg", "png"}) {
      const std::string path = picture_path(figure, format);
      std::error_code ignored;
      fs::remove(places_.out / path, ignored);
      std::erase(report.written, path);
    }
  }

  static std::string picture_path(const Figure& figure, std::string_view format) {
    return fmt::format("figures/{}.{}", figure.stem, format);
  }

  const ReportPlaces& places_;
  const std::function<void(std::string_view)>& progress_;
  bool gnuplot_is_there_ = true;
};

std::vector<SolvedCase> solve_all(const std::vector<Case>& cases,
                                  const std::function<void(std::string_view)>& progress) {
  std::vector<SolvedCase> solved;
  for (const Case& one : cases) {
    progress("solving " + one.file);
    solved.push_back(solve_case(one));
  }
  return solved;
}

Findings find(const ReportPlaces& places, const std::vector<Case>& cases,
              const std::function<void(std::string_view)>& progress) {
  ReportedValues reported(places);
  std::vector<SolvedCase> solved = solve_all(cases, progress);
  TwoSlopes slopes = two_slopes(find_solved(solved, "smooth", AsperityModel::greenwood_tripp));
  return {std::move(solved), std::move(slopes), std::move(reported)};
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
  for (const DataFile& file : data_files(findings, comparisons))
    writer.write(file.path, file.content);
  std::vector<std::string> data = writer.report.written;
  std::vector<Figure> drawn = figures(findings);
  for (Figure& figure : drawn) writer.draw(figure);
  progress("holding the model to the certified tables");
  const Page page = make_page(findings, comparisons, std::move(drawn), verification_tables(places),
                              performance_tables(places, findings.solved), std::move(data));
  writer.write("report.md", markdown_page(page));
  writer.write("index.html", html_page(page));
  writer.report.tables = tables_text(comparisons);
  writer.report.warnings = std::move(read.warnings);
  return std::move(writer.report);
}

}  // namespace tribo::report
