// SPDX-License-Identifier: Apache-2.0
// tribocheck report: the paper's scenes solved, its figures redrawn, one page, and a table.
#include "page/report.hpp"

#include <fmt/format.h>

#include <memory>
#include <string>

#include "command.hpp"
#include "messages.hpp"
#include "page/project_files.hpp"
#include "progress.hpp"
#include "table.hpp"

namespace tribo::cli {
namespace {

report::Report written_report(const report::ReportOptions& options) {
  StepLine steps;
  return report::write_report(options, [&](std::string_view step) { steps.show(step); });
}

int tell(const report::Report& done, OutputStream& output) {
  for (const std::string& line : done.warnings) complain("warning: " + line);
  for (const std::string& line : done.undrawn) complain(line);
  append(output.text(), done.verdict);
  append_line(output.text(),
              fmt::format("{}: {}/{} ({} files in all, data and pictures among them)",
                          done.has_page ? "The page" : "The data", done.folder,
                          done.has_page ? "index.html" : "report.json", done.written.size()));
  output.flush();
  return done.undrawn.empty() ? exit_done : exit_failed;
}

constexpr const char* report_footer =
    R"(Reads rough.toml, medium.toml, smooth.toml, their _gw.toml twins and claims.tsv, and writes
index.html, report.md, report.json, data/*.tsv and, with gnuplot, figures/*.svg and *.png. Solves the
scenes of reference/scenes, shows what reference/exact and reference/baselines have, and says what is
missing. The folders' defaults lie in the project that the current folder, or else the program, is
part of.
Exit code 1: python3 is missing, or figures are, because gnuplot is or because it failed.

Example:
  tribocheck report --out my_report
  tribocheck report --out my_claims --section claims)";

}  // namespace

Command add_report(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "report", "the paper's figures and onsets recomputed: a page, pictures, data");
  app->footer(report_footer);
  const auto options = std::make_shared<report::ReportOptions>();
  app->add_option("--out", options->out, "folder to write to (default: reports/out)");
  app->add_option("--section", options->sections,
                  "only this section, by its id (claims, uncertainty, gates, …); may be repeated")
      ->allow_extra_args(false);
  app->add_option("--scenes", options->scenes,
                  "folder of the scenes (default: reference/published)");
  app->add_option("--commit", options->commit,
                  "what was built, for the page to tell; empty: not known")
      ->expected(0, 1);
  return {app, [options](OutputStream& output) { return tell(written_report(*options), output); }};
}

}  // namespace tribo::cli
