// SPDX-License-Identifier: Apache-2.0
// tribocheck report: starts reports/page/groups/report.py, which asks the other commands.
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "bench_rows.hpp"
#include "command.hpp"
#include "page/project_files.hpp"
#include "page_script.hpp"
#include "tribo/batch.hpp"
#include "tribo/version.hpp"

namespace tribo::cli {
namespace {

int write_report(const report::ReportOptions& options, OutputStream& output) {
  const report::ReportPlaces places = report::find_places(options);
  std::vector<std::string> arguments{std::filesystem::read_symlink("/proc/self/exe"),
                                     places.out,
                                     places.scenes,
                                     places.reference,
                                     places.root,
                                     places.render,
                                     std::string(version),
                                     options.commit,
                                     compiler_name(),
                                     std::string(instruction_set())};
  arguments.insert(arguments.end(), options.sections.begin(), options.sections.end());
  return run_page_script(places.render.parent_path() / "groups/report.py", arguments, "report",
                         output);
}

constexpr const char* report_footer =
    R"(Reads rough.toml, medium.toml, smooth.toml, their _gw.toml twins and claims.tsv, and writes
index.html, report.md, report.json, data/*.tsv and, with gnuplot, figures/*.svg and *.png. Solves the
scenes of reference/scenes, shows what reference/exact and reference/baselines have, and says what is
missing. The folders' defaults lie in the project that the current folder, or else the program, is
part of.
A report does not replace one of more sections: where that is in the folder, it goes to a folder below,
named by its sections (reports/out/claims/index.html). The last line says where the page is.
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
  app->add_option("-o,--out", options->out, "folder to write to (default: reports/out)");
  app->add_option("--section", options->sections,
                  "only this section, by its id (claims, uncertainty, gates, …); may be repeated")
      ->allow_extra_args(false);
  app->add_option("--scenes", options->scenes,
                  "folder of the scenes (default: reference/published)");
  app->add_option("--commit", options->commit,
                  "what was built, for the page to tell; empty: not known")
      ->expected(0, 1);
  return {app, [options](OutputStream& output) { return write_report(*options, output); }};
}

}  // namespace tribo::cli
