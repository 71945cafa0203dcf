// SPDX-License-Identifier: Apache-2.0
// tribocheck field: starts reports/field/field.py, which shows verdicts on solvers side by side.
#include <memory>
#include <string>
#include <vector>

#include "command.hpp"
#include "page/project_files.hpp"
#include "page_script.hpp"
#include "tribo/version.hpp"

namespace tribo::cli {
namespace {

struct FieldOptions {
  std::string folder, out = "field.html", format = "page";
  std::vector<std::string> days;
};

int write_field(const FieldOptions& options, OutputStream& output) {
  std::vector<std::string> arguments{std::string(version), options.folder, options.out,
                                     options.format};
  arguments.insert(arguments.end(), options.days.begin(), options.days.end());
  const auto reports = report::usual_places().render.parent_path().parent_path();
  return run_page_script(reports / "field/field.py", arguments, "matrix", output);
}

constexpr const char* field_footer =
    R"(The folder has two files for each verdict: FILE.json, what `tribocheck verify --subject … --format json`
writes, and FILE.toml, some lines about the solver: name, language and date (needed), address, commit,
licence, conventions, asked (the command that asked it) and group. Verdicts of one name and several dates
are the history of that solver; the newest one stands in the matrix.
Written are the page and, in a folder of its name, a page and a badge (SVG, and JSON for services that draw
badges) for each solver, and matrix.json. --format json writes matrix.json to stdout in place of these
files; --diff writes to stdout what changed between two days, separated by tabs.
Exit code 1: Jinja2 or cmarkgfm is missing, or a file cannot be written.

Example:
  mkdir -p verdicts
  tribocheck verify --subject 'python3 my_solver.py' --format json > verdicts/mine.json
  printf 'name = "mine"\nlanguage = "Python"\ndate = 2026-11-28\n' > verdicts/mine.toml
  tribocheck field verdicts -o field.html
  tribocheck field verdicts --diff 2026-11-01 2026-11-28)";

}  // namespace

Command add_field(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "field", "verdicts on many solvers side by side: a page, badges, data");
  app->footer(field_footer);
  const auto options = std::make_shared<FieldOptions>();
  app->add_option("DIR", options->folder, "folder of the verdicts")->required();
  CLI::Option* const out =
      app->add_option("-o,--out", options->out, "page to write (default: field.html)");
  CLI::Option* const format =
      app->add_option("--format", options->format, "what to make (default: page)")
          ->check(CLI::IsMember({"page", "json"}))
          ->excludes(out);
  app->add_option("--diff", options->days, "what changed between two days, as 2026-11-28")
      ->expected(2)
      ->excludes(out)
      ->excludes(format);
  return {app, [options](OutputStream& output) { return write_field(*options, output); }};
}

}  // namespace tribo::cli
