// SPDX-License-Identifier: Apache-2.0
// tribocheck reproduce: which of the paper's numbers come out, under which reading.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "accuracy/reference_table.hpp"
#include "build_info.hpp"
#include "command.hpp"
#include "messages.hpp"
#include "page/ledger_tables.hpp"
#include "page/project_files.hpp"
#include "reproduction/ledger.hpp"
#include "table.hpp"

namespace tribo::cli {
namespace {

using namespace reproduction;
using report::TextTable;

struct ReproduceArguments {
  std::string published;  // empty: reference/published of the project
  std::string ledger;     // empty: reference/baselines/ledger.csv; "none": not compared
  std::string format = "table";
  std::vector<std::string> claims, readings, sections;
};

constexpr const char* section_names[] = {"claims",      "statements",   "ranking",     "switches",
                                         "identified",  "requirements", "uncertainty", "errata",
                                         "independent", "all"};

// The readings that --reading asks for, by their names or by their switches.
struct Asked {
  std::vector<std::string> names;
  std::vector<Reading> readings;

  bool everything() const { return names.empty() && readings.empty(); }
  bool has(const NamedReading& one) const {
    const std::string_view name =
        one.name.starts_with("best ") ? "best" : std::string_view(one.name);
    return std::find(names.begin(), names.end(), name) != names.end() ||
           std::find(readings.begin(), readings.end(), one.reading) != readings.end();
  }
};
Asked asked_readings(const std::vector<std::string>& arguments) {
  Asked asked;
  for (const std::string& argument : arguments) {
    if (argument == "corrected" || argument == "literal" || argument == "best") {
      asked.names.push_back(argument);
      continue;
    }
    Reading reading = corrected_reading();
    std::size_t from = 0;
    while (from <= argument.size()) {
      const std::size_t comma = std::min(argument.find(',', from), argument.size());
      set_switch(reading, argument.substr(from, comma - from));
      from = comma + 1;
    }
    asked.readings.push_back(reading);
  }
  return asked;
}

// The readings to show, each once, in the ledger's order; all of them when none were asked for.
std::vector<NamedReading> columns(const Ledger& ledger, const Asked& asked) {
  if (asked.everything()) return ledger.readings;
  std::vector<NamedReading> chosen;
  for (const NamedReading& reading : ledger.readings)
    if (asked.has(reading)) chosen.push_back(reading);
  return chosen;
}

// Refuses unknown claims, before anything is computed.
void check_claims(const std::string& published, const std::vector<std::string>& asked) {
  if (asked.empty()) return;
  const std::vector<std::string> known = claim_names(read_claims(published + "/claims.tsv"));
  for (const std::string& claim : asked)
    if (std::find(known.begin(), known.end(), claim) == known.end())
      throw std::invalid_argument(
          fmt::format("--claim: {} is not one of {}", claim, fmt::join(known, ", ")));
}

bool is_wanted(std::string_view section, const ReproduceArguments& arguments) {
  const std::vector<std::string>& asked = arguments.sections;
  if (!asked.empty())
    return std::any_of(asked.begin(), asked.end(),
                       [&](const std::string& one) { return one == "all" || one == section; });
  if (arguments.claims.empty()) return section == "claims" || section == "ranking";
  // Claims that were asked for are shown in depth: statements, and what would make them true.
  return section == "claims" || section == "statements" || section == "requirements";
}

std::vector<TextTable> tables(const Ledger& ledger, const std::vector<NamedReading>& readings,
                              const ReproduceArguments& arguments) {
  std::vector<TextTable> made;
  const auto add = [&](std::vector<TextTable> more) {
    for (TextTable& one : more) made.push_back(std::move(one));
  };
  const auto wants = [&](std::string_view section) { return is_wanted(section, arguments); };
  const std::vector<std::string>& claims = arguments.claims;
  if (wants("claims")) {
    add({report::verdict_table(ledger, readings, claims),
         report::readings_table(ledger, readings)});
    // Unless readings were asked for, only the corrected one is shown in detail.
    const std::size_t detailed = arguments.readings.empty() ? 1 : readings.size();
    for (std::size_t i = 0; i < detailed; ++i)
      add({report::reading_table(ledger, readings[i], claims)});
  }
  if (wants("statements")) add({report::statement_table(ledger, claims)});
  if (wants("ranking")) add({report::ranking_table(ledger), report::tolerance_table(ledger)});
  if (wants("switches")) add({report::switch_table()});
  if (wants("identified")) {
    add({report::identification_table(ledger)});
    add(report::argument_tables(ledger));
  }
  if (wants("requirements")) {
    add(report::requirement_tables(ledger, claims));
    // The departure table is about claim C1.
    if (claims.empty() || std::find(claims.begin(), claims.end(), "C1") != claims.end())
      add({report::departure_table(ledger)});
  }
  if (wants("uncertainty")) add({report::uncertainty_table(ledger)});
  if (wants("errata")) add(report::errata_tables(ledger));
  if (wants("independent")) add({report::independent_table(ledger)});
  return made;
}

// The width of the terminal, but at least 80 and at most 100 signs; 100 without a terminal.
std::size_t line_width() {
  constexpr std::size_t least = 80, most = 100;
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return most;
  return std::clamp<std::size_t>(size.ws_col, least, most);
}

void write(const Ledger& ledger, const std::vector<NamedReading>& readings,
           const ReproduceArguments& arguments, OutputStream& output) {
  Text& to = output.text();
  if (arguments.format == "json") {
    const auto told = report::ledger_json(ledger, readings, arguments.claims);
    return append(to, document("reproduce/1", told).dump(1) + "\n");
  }
  if (arguments.format == "csv") return append(to, ledger_csv(ledger, readings, arguments.claims));
  const NamedReading& corrected = ledger.readings.front();
  const std::size_t width = line_width();
  const std::string summary = fmt::format("{} (misprints mended but for E13 and E26, m = 1). {}",
                                          report::verdict_sentence(ledger, corrected),
                                          report::other_planes_sentence(ledger));
  for (const std::string& line : report::wrapped(summary, width)) append(to, line + "\n");
  for (const TextTable& table : tables(ledger, readings, arguments)) {
    append(to, "\n");
    if (arguments.format == "markdown") {
      append(to, report::markdown_table(table));
      continue;
    }
    append(to, report::plain_table(table, width));
    if (table.note.empty()) continue;
    for (const std::string& line : report::wrapped(table.note, width)) append(to, line + "\n");
  }
}

int compare(const Ledger& ledger, const std::vector<NamedReading>& readings,
            const ReproduceArguments& arguments, const std::string& path) {
  if (path == "none") return exit_done;
  const LedgerChanges changes = changes_since(path, ledger, readings, arguments.claims);
  for (const std::string& line : changes.numbers) complain("number moved: " + line);
  for (const std::string& line : changes.verdicts) complain("verdict changed: " + line);
  return changes.verdicts.empty() ? exit_done : exit_failed;
}

// JSON and CSV have no sections to choose from. Only some sections are about claims, and fewer
// about readings.
std::vector<Ignored> ignored_by(const ReproduceArguments& arguments) {
  const std::vector<std::string>& sections = arguments.sections;
  const auto has_any = [&](std::initializer_list<std::string_view> names) {
    return sections.empty() || std::any_of(sections.begin(), sections.end(), [&](const auto& one) {
             return one == "all" || std::find(names.begin(), names.end(), one) != names.end();
           });
  };
  return {{{"--section"},
           arguments.format == "json" || arguments.format == "csv",
           "with --format " + arguments.format},
          {{"--claim"},
           !has_any({"claims", "statements", "requirements"}),
           "without --section claims, statements or requirements"},
          {{"--reading"}, !has_any({"claims"}), "without --section claims"}};
}

int reproduce(const ReproduceArguments& arguments, OutputStream& output) {
  return answered_or_complained([&] {
    const report::ReportPlaces places = report::find_places({});
    LedgerOptions options;
    options.published = arguments.published.empty() ? places.scenes.string() : arguments.published;
    const Asked asked = asked_readings(arguments.readings);
    options.asked = asked.readings;
    options.requirements = arguments.format == "json" ||
                           (arguments.format != "csv" && is_wanted("requirements", arguments));
    check_claims(options.published, arguments.claims);
    const std::string committed = arguments.ledger.empty()
                                      ? (places.reference / "baselines" / "ledger.csv").string()
                                      : arguments.ledger;
    if (committed != "none") verification::read_reference_table(committed);
    const Ledger ledger = make_ledger(options);
    const std::vector<NamedReading> readings = columns(ledger, asked);
    write(ledger, readings, arguments, output);
    output.flush();
    return compare(ledger, readings, arguments, committed);
  });
}

constexpr const char* reproduce_footer =
    R"(Every claim of the paper, computed and judged, under the corrected reading with m = 1, 2 and two equal
faces, the literal one, the few of all combinations that reproduce most claims, or one of your own. Each verdict stands with its margin, the
distance to another verdict, and the numerical error of that; “(?)” marks a margin below its error. The
verdicts are held against reference/baselines/ledger.csv. Exit code 1: a verdict changed; stderr names it.

Example:
  tribocheck reproduce
  tribocheck reproduce --claim C1
  tribocheck reproduce --reading inlet=printed_exponents,speed=sum
  tribocheck reproduce --section all --format markdown > ledger.md)";

}  // namespace

Command add_reproduce(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "reproduce", "the paper's claims, each computed under each reading, with verdicts");
  app->footer(reproduce_footer);
  const auto arguments = std::make_shared<ReproduceArguments>();
  app->add_option("--claim", arguments->claims, "only this claim, C1 to C17; may be repeated");
  app->add_option("--reading", arguments->readings,
                  "corrected, literal, best, or SWITCH=CHOICE,… departing from corrected; may be "
                  "repeated (see --section switches)");
  app->add_option("--section", arguments->sections,
                  "what tables to write (default: claims and ranking); may be repeated")
      ->check(CLI::IsMember(
          std::vector<std::string>(std::begin(section_names), std::end(section_names))));
  app->add_option("--format", arguments->format,
                  "how to write it (default: table); json has all sections, csv the claims")
      ->check(CLI::IsMember({"table", "json", "csv", "markdown"}));
  app->add_option("--published", arguments->published,
                  "folder of claims, errata, inputs and scenes (default: reference/published)");
  app->add_option("--ledger", arguments->ledger,
                  "committed ledger to compare with, or none (default: "
                  "reference/baselines/ledger.csv)");
  return {app, [arguments](OutputStream& output) { return reproduce(*arguments, output); },
          [arguments] { return ignored_by(*arguments); }};
}

}  // namespace tribo::cli
