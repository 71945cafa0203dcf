// SPDX-License-Identifier: Apache-2.0
// tribocheck reproduce: which of the paper's numbers come out, under which reading.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "bad_input.hpp"
#include "command.hpp"
#include "exit_code.hpp"
#include "messages.hpp"
#include "report/ledger_json.hpp"
#include "report/ledger_tables.hpp"
#include "report/markup.hpp"
#include "report/project_files.hpp"
#include "reproduction/ledger_file.hpp"
#include "table.hpp"

namespace tribo::cli {
namespace {

using namespace reproduction;
using report::TextTable;

struct ReproduceArguments {
  std::string published;  // empty: reference/published of the project
  std::string ledger;     // empty: reference/baselines/ledger.csv; none: no comparison
  std::string format = "table";
  std::vector<std::string> claims, readings, sections;
};

constexpr const char* section_names[] = {"claims",      "statements",   "ranking",     "switches",
                                         "identified",  "requirements", "uncertainty", "errata",
                                         "independent", "all"};

// What --reading asks for: named ones, and readings given by their switches.
struct Asked {
  std::vector<std::string> names;
  std::vector<Reading> readings;
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
    asked.names.push_back(departures(reading));
  }
  return asked;
}

// The columns to show, in the ledger's order; all of them when none were asked for.
std::vector<NamedReading> columns(const Ledger& ledger, const Asked& asked) {
  if (asked.names.empty()) return ledger.readings;
  std::vector<NamedReading> chosen;
  for (const NamedReading& reading : ledger.readings) {
    const bool wanted = std::any_of(asked.names.begin(), asked.names.end(), [&](const auto& name) {
      return reading.name == name || (name == "best" && reading.name.starts_with("best "));
    });
    const bool is_there = std::any_of(chosen.begin(), chosen.end(),
                                      [&](const auto& one) { return one.name == reading.name; });
    if (wanted && !is_there) chosen.push_back(reading);
  }
  return chosen;
}

void check_claims(const Ledger& ledger, const std::vector<std::string>& claims) {
  for (const std::string& claim : claims)
    if (std::find(ledger.claims.begin(), ledger.claims.end(), claim) == ledger.claims.end())
      throw std::invalid_argument(
          fmt::format("--claim: {} is not one of {}", claim, fmt::join(ledger.claims, ", ")));
}

class Sections {
 public:
  Sections(const Ledger& ledger, const std::vector<NamedReading>& readings,
           const ReproduceArguments& arguments)
      : ledger_(ledger), readings_(readings), arguments_(arguments) {}

  std::vector<TextTable> tables() const {
    std::vector<TextTable> made;
    const auto add = [&](std::vector<TextTable> more) {
      for (TextTable& one : more) made.push_back(std::move(one));
    };
    const std::vector<std::string>& claims = arguments_.claims;
    if (wants("claims")) {
      add({report::verdict_table(ledger_, claims)});
      // Unless readings were asked for, the corrected one in detail is enough.
      const std::size_t detailed = arguments_.readings.empty() ? 1 : readings_.size();
      for (std::size_t i = 0; i < detailed; ++i)
        add({report::reading_table(ledger_, readings_[i], claims,
                                   arguments_.format == "markdown")});
    }
    if (wants("statements")) add({report::statement_table(ledger_, claims)});
    if (wants("ranking")) add({report::ranking_table(ledger_)});
    if (wants("switches")) add({report::switch_table()});
    if (wants("identified")) {
      add({report::identification_table(ledger_)});
      add(report::argument_tables(ledger_));
    }
    if (wants("requirements")) {
      add(report::requirement_tables(ledger_, claims));
      add({report::departure_table(ledger_)});
    }
    if (wants("uncertainty")) add({report::uncertainty_table(ledger_)});
    if (wants("errata")) add({report::errata_table(ledger_)});
    if (wants("independent")) add({report::independent_table(ledger_)});
    return made;
  }

 private:
  bool wants(std::string_view section) const {
    const std::vector<std::string>& asked = arguments_.sections;
    if (asked.empty()) {
      // One claim is asked about in depth: what it says, and what would have to be true.
      if (!arguments_.claims.empty())
        return section == "claims" || section == "statements" || section == "requirements";
      return section == "claims" || section == "ranking";
    }
    return std::any_of(asked.begin(), asked.end(),
                       [&](const std::string& one) { return one == "all" || one == section; });
  }

  const Ledger& ledger_;
  const std::vector<NamedReading>& readings_;
  const ReproduceArguments& arguments_;
};

// A note, in lines of at most 100 signs.
void append_note(Text& to, const std::string& markup) {
  const std::string note = report::to_plain(markup);
  std::size_t column = 0;
  for (std::size_t from = 0; from < note.size();) {
    const std::size_t end = std::min(note.find(' ', from), note.size());
    const std::string word = note.substr(from, end - from);
    const std::size_t width = width_of(word);
    if (column > 0) append(to, column + 1 + width > 100 ? "\n" : " ");
    column = column == 0 || column + 1 + width > 100 ? width : column + 1 + width;
    append(to, word);
    from = end + 1;
  }
  append(to, "\n");
}

void write(const Ledger& ledger, const std::vector<NamedReading>& readings,
           const ReproduceArguments& arguments, OutputStream& output) {
  Text& to = output.text();
  if (arguments.format == "json")
    return append(to, report::ledger_json(ledger, readings, arguments.claims).dump(1) + "\n");
  if (arguments.format == "csv") return append(to, ledger_csv(ledger, readings, arguments.claims));
  bool first = true;
  for (const TextTable& table : Sections(ledger, readings, arguments).tables()) {
    if (!first) append(to, "\n");
    first = false;
    if (arguments.format == "markdown") {
      append(to, report::markdown_table(table));
      continue;
    }
    append(to, report::plain_table(table));
    if (!table.note.empty()) append_note(to, table.note);
  }
}

int compare(const Ledger& ledger, const std::vector<NamedReading>& readings,
            const ReproduceArguments& arguments, const std::string& path) {
  if (arguments.ledger == "none") return exit_done;
  const LedgerChanges changes = changes_since(path, ledger, readings, arguments.claims);
  for (const std::string& line : changes.numbers) complain("number moved: " + line);
  for (const std::string& line : changes.verdicts) complain("verdict changed: " + line);
  return changes.verdicts.empty() ? exit_done : exit_failed;
}

int reproduce(const ReproduceArguments& arguments, OutputStream& output) {
  return answered_or_complained([&] {
    const report::ReportPlaces places = report::find_places({});
    LedgerOptions options;
    options.published = arguments.published.empty() ? places.scenes.string() : arguments.published;
    const Asked asked = asked_readings(arguments.readings);
    options.asked = asked.readings;
    const Ledger ledger = make_ledger(options);
    check_claims(ledger, arguments.claims);
    const std::vector<NamedReading> readings = columns(ledger, asked);
    write(ledger, readings, arguments, output);
    output.flush();
    return compare(ledger, readings, arguments,
                   arguments.ledger.empty()
                       ? (places.reference / "baselines" / "ledger.csv").string()
                       : arguments.ledger);
  });
}

constexpr const char* footer =
    R"(Every claim of the paper, computed and judged, under the corrected reading, the literal one, the few of
all combinations that reproduce most claims, or one of your own. The verdicts are held against
reference/baselines/ledger.csv. Exit code 1: a verdict changed; stderr names it.

Example:
  tribocheck reproduce
  tribocheck reproduce --claim C1
  tribocheck reproduce --reading inlet=printed_exponents,speed=sum
  tribocheck reproduce --section all --format markdown > ledger.md)";

}  // namespace

Command add_reproduce(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "reproduce", "the paper's claims, each computed under each reading, with verdicts");
  app->footer(footer);
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
  return {app, [arguments](OutputStream& output) { return reproduce(*arguments, output); }};
}

}  // namespace tribo::cli
