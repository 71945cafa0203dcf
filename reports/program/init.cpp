// SPDX-License-Identifier: Apache-2.0
// `tribocheck init` writes one of two files: a solver that speaks the protocol and answers every
// question with a skip, with a function to fill in for each function of the catalogue; or a CI
// configuration that checks a solver. A language is offered if it has a row in
// templates/languages.tsv and its template lies in that folder; a CI system is offered for each
// .yml file in ci/.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <kainjow/mustache.hpp>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "accuracy/reference_table.hpp"
#include "catalogue/catalogue.hpp"
#include "command.hpp"
#include "messages.hpp"
#include "page/project_files.hpp"
#include "page/text_table.hpp"
#include "shell.hpp"
#include "table.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::cli {
namespace {

namespace fs = std::filesystem;
using kainjow::mustache::data;
using kainjow::mustache::mustache;

struct InitArguments {
  std::string what;
  std::string language;  // the language of a subject
  std::string system;    // the system of CI
  std::string out;       // if empty, the template's own name in the current folder
  bool force = false;
};

struct Language {
  std::string name;
  std::string file;     // the file to write; its template has this name and ".mustache"
  std::string program;  // the interpreter or compiler
  std::string package;  // Debian's package of the program
  // The command that builds {library}, in {folder}, from {file}; {include} is the folder of
  // tribocheck_plugin.h. A command without {library} starts the subject itself.
  std::string command;
};

fs::path template_of(const fs::path& templates, const Language& language) {
  return templates / (language.file + ".mustache");
}

std::vector<Language> read_languages(const fs::path& templates) {
  std::vector<Language> languages;
  const fs::path table = templates / "languages.tsv";
  std::error_code ignored;
  if (!fs::is_regular_file(table, ignored)) return languages;
  verification::each_published_row(table, [&](const verification::ReferenceRow& row) {
    const Language language{row.text("language"), row.text("file"), row.text("program"),
                            row.text("Debian package"), row.text("command")};
    if (fs::is_regular_file(template_of(templates, language), ignored))
      languages.push_back(language);
  });
  return languages;
}

std::optional<std::string> read_text(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file) return std::nullopt;
  return text;
}

std::string with(std::string text, std::string_view mark, const std::string& word) {
  const std::size_t place = text.find(mark);
  return place == std::string::npos ? text : text.replace(place, mark.size(), shell_word(word));
}

// The word that starts this program in a user's shell: its name if the shell finds the program by
// this name, else its path.
std::string own_name() {
  const fs::path self = fs::read_symlink("/proc/self/exe");
  std::error_code ignored;
  return fs::equivalent(found_by_shell("tribocheck"), self, ignored) ? "tribocheck" : self.string();
}

// The next command that the user types. It builds the library, if the language needs one, and runs
// `tribocheck verify` on the solver.
std::string next_line(const Language& language, const fs::path& include, const std::string& out) {
  // "./" keeps every command from reading a name that begins with "-" as an option.
  const std::string file = out.starts_with('-') ? "./" + out : out;
  const std::string verify = shell_word(own_name()) + " verify ";
  const std::string command = with(language.command, "{file}", file);
  if (command.find("{library}") == std::string::npos)
    return verify + "--subject " + shell_word(command);
  const fs::path path(file);
  const std::string library =
      (path.parent_path() / ("lib" + path.stem().string() + ".so")).string();
  const std::string folder = path.has_parent_path() ? path.parent_path().string() : ".";
  return with(with(with(command, "{include}", include.string()), "{library}", library), "{folder}",
              folder) +
         " && " + verify + "--plugin " + shell_word(library);
}

// --- The template's text, filled.

constexpr std::size_t widest_comment = 92;  // columns

// The lines of a text, for the section {{#about}}{{line}}{{/about}} in a comment of a template.
data lines_of(const std::string& text) {
  data lines(data::type::list);
  for (const std::string& line : report::wrapped(text, widest_comment)) lines << data("line", line);
  return lines;
}

// The template's variables for one item of a list: its name, its meaning, its unit, its number from
// 1 on, its place from 0 on, and whether it is the last item.
template <class Named>
data entry_of(const Named& named, std::size_t place, std::size_t count) {
  data entry;
  entry.set("name", std::string(named.name));
  entry.set("meaning", std::string(named.meaning));
  entry.set("in_unit", named.unit.empty() ? "" : fmt::format(", in {}", named.unit));
  entry.set("number", std::to_string(place + 1));
  entry.set("place", std::to_string(place));
  entry.set("last", data(place + 1 == count ? data::type::bool_true : data::type::bool_false));
  return entry;
}

// {{allowed}} is the allowed range, such as "a number above 0", or the list of the allowed words.
// In {{coded}} each of these words stands behind its code of tribocheck_plugin.h.
data parameters_of(const catalogue::Function& function) {
  data list(data::type::list);
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const catalogue::Parameter& parameter = function.parameters[i];
    data entry = entry_of(parameter, i, function.parameters.size());
    entry.set("allowed", catalogue::allowed_text(parameter));
    std::string coded;
    for (std::size_t code = 0; code < parameter.words.size(); ++code)
      coded += fmt::format("{}{} {}", code == 0 ? "" : ", ", code, parameter.words[code]);
    // The section {{#default}} is written only for a parameter that a question may leave out.
    if (parameter.default_value) {
      data defaults(data::type::list);
      const std::string quote = parameter.words.empty() ? "" : "\"";
      defaults << data("value", quote + catalogue::default_text(parameter) + quote);
      entry.set("default", defaults);
    }
    entry.set("coded", coded.empty() ? catalogue::allowed_text(parameter) : coded);
    list << entry;
  }
  return list;
}

data results_of(const catalogue::Function& function) {
  data list(data::type::list);
  for (std::size_t i = 0; i < function.results.size(); ++i)
    list << entry_of(function.results[i], i, function.results.size());
  return list;
}

data function_of(const catalogue::Function& function) {
  data entry;
  entry.set("name", std::string(function.name));
  entry.set("about", lines_of(fmt::format("{}: {}. Source: {}.", function.meaning,
                                          function.equation, function.source)));
  entry.set("parameters", parameters_of(function));
  entry.set("results", results_of(function));
  // Each of several results has a name; a single result is the answer itself.
  if (function.results.size() == 1) entry.set("only_result", results_of(function));
  return entry;
}

// Fills a Mustache template, in which a text between {{#functions}} and {{/functions}} is written
// once for each function of the catalogue. `text` is the content of the file `path`, and `next` is
// the command for {{next}}. Throws std::runtime_error with a message of one line if the text is not
// valid Mustache.
std::string filled_template(const std::string& text, const std::string& path,
                            const std::string& next) {
  mustache filled(text);
  if (!filled.is_valid()) throw std::runtime_error(path + ": " + filled.error_message());
  filled.set_custom_escape([](const std::string& plain) { return plain; });  // no HTML
  data functions(data::type::list);
  for (const catalogue::Function& function : catalogue::functions())
    functions << function_of(function);
  data all("functions", functions);
  all.set("next", next);
  return filled.render(all);
}

// --- The command.

constexpr const char* no_templates =
    "templates not found; run in the project, or install tribocheck: make install";

// Writes the file and says so. If the file exists already and --force is not given, it writes
// nothing, prints one line and returns false.
bool write_new_file(const InitArguments& arguments, const std::string& out, const std::string& text,
                    OutputStream& output) {
  std::error_code ignored;
  if (!arguments.force && fs::exists(fs::symlink_status(out, ignored))) {
    complain(out + ": is there already; --force overwrites it");
    return false;
  }
  if (const fs::path parent = fs::path(out).parent_path(); !parent.empty())
    report::make_folder(parent);
  report::write_file(out, text, {.any = arguments.force, .only = {}});
  append_line(output.text(), out + ": written");
  return true;
}

int init_subject(const InitArguments& arguments, OutputStream& output) {
  if (!arguments.system.empty())
    return fail(exit_bad, "--for is an option of ci; a subject has --language");
  const report::ReportPlaces places = report::usual_places();
  const fs::path& templates = places.templates;
  const std::vector<Language> languages = read_languages(templates);
  if (languages.empty()) return fail(exit_bad, no_templates);
  std::vector<std::string> names;
  for (const Language& one : languages) names.push_back(one.name);
  if (arguments.language.empty())
    return fail(exit_bad,
                fmt::format("--language is required; allowed: {}", fmt::join(names, ", ")));
  const auto found = std::find(names.begin(), names.end(), arguments.language);
  if (found == names.end())
    return fail(exit_bad, fmt::format("--language: no template for {}; allowed: {}",
                                      arguments.language, fmt::join(names, ", ")));
  const Language* const language = &languages[static_cast<std::size_t>(found - names.begin())];
  const fs::path path = template_of(templates, *language);
  const std::optional<std::string> text = read_text(path);
  if (!text) return fail(exit_failed, path.string() + ": cannot be read");
  const std::string out = arguments.out.empty() ? language->file : arguments.out;
  const std::string next = printable(next_line(*language, places.include, out), std::string::npos);
  if (!write_new_file(arguments, out, filled_template(*text, path.string(), next), output))
    return exit_bad;
  append(output.text(), "next:\n");
  append_line(output.text(), "  " + next);
  output.flush();
  if (found_by_shell(language->program).empty())
    complain(fmt::format(
        "no program {} is on PATH, and the line above needs it; on Debian: apt-get install {}",
        language->program, language->package));
  return exit_done;
}

// The names of the CI systems. Each one has a file ready to paste, NAME.yml.
std::vector<std::string> systems_in(const fs::path& folder) {
  std::vector<std::string> systems;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".yml") systems.push_back(entry.path().stem().string());
  std::sort(systems.begin(), systems.end());
  return systems;
}

int init_ci(const InitArguments& arguments, OutputStream& output) {
  if (arguments.system.empty()) return fail(exit_bad, "--for is required (see --help)");
  if (!arguments.language.empty())
    return fail(exit_bad, "--language is an option of subject; ci has --for");
  const fs::path folder = report::usual_places().templates.parent_path() / "ci";
  const std::vector<std::string> systems = systems_in(folder);
  if (systems.empty()) return fail(exit_bad, no_templates);
  const std::string name = arguments.system + ".yml";
  if (std::find(systems.begin(), systems.end(), arguments.system) == systems.end())
    return fail(exit_bad, fmt::format("--for: no file for {}; allowed: {}", arguments.system,
                                      fmt::join(systems, ", ")));
  const std::optional<std::string> text = read_text(folder / name);
  if (!text) return fail(exit_failed, (folder / name).string() + ": cannot be read");
  const std::string out = arguments.out.empty() ? name : arguments.out;
  if (!write_new_file(arguments, out, *text, output)) return exit_bad;
  append(output.text(),
         "next: put the file where its head says, if it is not there, change the variables marked "
         "CHANGE, make the baseline as its head says, and commit both files\n");
  output.flush();
  return exit_done;
}

int init(const InitArguments& arguments, OutputStream& output) {
  return arguments.what == "ci" ? init_ci(arguments, output) : init_subject(arguments, output);
}

constexpr const char* init_footer =
    R"(subject: the file answers every question of `tribocheck verify` with a skip until you fill in what you have;
until then the verdict is NOTHING, and the exit code 1. Its comments say what each function is and in
which units. The line that is printed builds it, where it has to be built, and puts it to the tests.

ci: the file has the gates of values and of speed for a system of CI, github or gitlab, ready to paste;
its head says where it goes.

Folders that --out names are made.

Example:
  tribocheck init subject --language python --out my_solver.py
  tribocheck verify --subject "python3 my_solver.py"
  tribocheck init ci --for github --out .github/workflows/tribocheck.yml)";

}  // namespace

Command add_init(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("init", "a solver of your own to start from, or a file for your CI");
  app->footer(init_footer);
  const auto arguments = std::make_shared<InitArguments>();
  app->add_option("what", arguments->what,
                  "subject: a solver for `verify --subject`; ci: a file that gates one")
      ->required()
      ->check(CLI::IsMember({"subject", "ci"}));
  app->add_option("--language", arguments->language,
                  "language of the solver: python, octave, c, fortran, cpp, javascript, rust");
  app->add_option("--for", arguments->system, "system of CI: github, gitlab");
  app->add_option("--out", arguments->out, "file to write (default: solver.py, github.yml, …)");
  app->add_flag("--force", arguments->force, "overwrite the file if it is there");
  return {app, [arguments](OutputStream& output) { return init(*arguments, output); }};
}

}  // namespace tribo::cli
