// SPDX-License-Identifier: Apache-2.0
// The rows of `tribocheck bench` as a table, JSON, TSV, Markdown for a pull request, and JUnit XML.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "bench_rows.hpp"
#include "build_info.hpp"
#include "junit.hpp"
#include "page/text_table.hpp"
#include "page/texts.hpp"
#include "table.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::cli {
namespace {

using Json = nlohmann::ordered_json;
using Value = std::optional<double>;

// Three digits below 1000, a whole number below a million, else two digits and an exponent.
std::string short_number(double x) {
  if (x >= 1e6) return fmt::format("{:.1e}", x);
  return x >= 1000 ? fmt::format("{:.0f}", x) : fmt::format("{:.3g}", x);
}
std::string cell(const Value& x) { return x ? short_number(*x) : "-"; }

std::string cell(const std::optional<Ratio>& x) {
  if (!x) return "-";
  return fmt::format("{:.4g} ({:.4g} to {:.4g})", x->median, x->low, x->high);
}

template <double Ratio::*part>
Value part_of(const std::optional<Ratio>& ratio) {
  return ratio ? Value((*ratio).*part) : std::nullopt;
}

struct Field {
  const char* name;
  Value (*value)(const BenchRow&);
  bool is_count = false;
};
constexpr Field fields[] = {
    {"ns", [](const BenchRow& r) { return Value(r.ns); }},
    {"ratio", [](const BenchRow& r) { return r.ratio; }},
    {"max_ulp", [](const BenchRow& r) { return r.max_ulp; }},
    {"p99_ulp", [](const BenchRow& r) { return r.p99_ulp; }},
    {"mean_ulp", [](const BenchRow& r) { return r.mean_ulp; }},
    {"evaluations", [](const BenchRow& r) { return r.evaluations; }},
    {"failures", [](const BenchRow& r) { return r.failures; }, true},
    {"judged", [](const BenchRow& r) { return r.judged; }, true},
    {"over_control", [](const BenchRow& r) { return part_of<&Ratio::median>(r.over_control); }},
    {"over_control_low", [](const BenchRow& r) { return part_of<&Ratio::low>(r.over_control); }},
    {"over_control_high", [](const BenchRow& r) { return part_of<&Ratio::high>(r.over_control); }},
    {"over_base", [](const BenchRow& r) { return part_of<&Ratio::median>(r.over_base); }},
    {"over_base_low", [](const BenchRow& r) { return part_of<&Ratio::low>(r.over_base); }},
    {"over_base_high", [](const BenchRow& r) { return part_of<&Ratio::high>(r.over_base); }},
    {"wall_ns", [](const BenchRow& r) { return r.wall_ns; }},
    {"cases", [](const BenchRow& r) { return r.cases; }, true},
};

// A list of changes: its name in JSON, and the word for one of its rows in the table.
struct ChangeList {
  const char* name;
  const char* word;
  const char* sentence;  // starts a line of Markdown
  const std::vector<RowNote> BenchChanges::*notes;
  bool is_red;
};
constexpr auto change_lists = std::to_array<ChangeList>({
    {"worse", "WORSE", "Worse", &BenchChanges::worse, true},
    {"gone", "GONE", "Gone", &BenchChanges::gone, true},
    {"slower", "SLOWER", "Slower", &BenchChanges::slower, true},
    {"told", "a little slower", "A little slower, not red", &BenchChanges::told, false},
    {"better", "better", "Better", &BenchChanges::better, false},
    {"new", "new", "New", &BenchChanges::fresh, false},
});

// The first list that has the row; null where it is as before.
const ChangeList* change_of(const BenchChanges& changes, const std::string& key) {
  for (const ChangeList& list : change_lists)
    for (const RowNote& note : changes.*list.notes)
      if (note.key == key) return &list;
  return nullptr;
}

// "same", "SLOWER", …; "-" where nothing is compared.
std::string change_text(const BenchReport& report, const BenchRow& row) {
  const bool is_compared = report.changes && row.family != "control" &&
                           (row.family != base_family || !report.baseline.empty());
  if (!is_compared) return "-";
  const ChangeList* const list = change_of(*report.changes, row.key());
  return list == nullptr ? "same" : list->word;
}

// The width of the longest `text` of all rows.
std::size_t widest(const BenchReport& report, std::string BenchRow::*text) {
  std::size_t width = 0;
  for (const BenchJob& job : report.results.jobs)
    for (const BenchRow& row : job.rows)
      width = std::max(width, report::width_of(printable(row.*text, std::string::npos)));
  return width;
}

void append_contenders(Text& to, const BenchReport& report) {
  bool is_first = true;
  const std::size_t width = std::max<std::size_t>(38, 2 + widest(report, &BenchRow::name));
  for (const BenchJob& job : report.results.jobs) {
    if (!is_first) append(to, "\n");
    is_first = false;
    append_title(to, job.title);
    const auto add = [&](const auto&... cells) {
      append(to, fmt::format("{:<14}{:<{}}{:>10}{:>9}{:>10}{:>13}{:>11}", cells...));
    };
    const auto end = [&](const std::string& change) {
      append(to, report.changes ? fmt::format("  {}\n", change) : "\n");
    };
    add("family", "contender", width, "ns", "ratio", "max ulp", "evaluations", "failures");
    end("baseline");
    for (const BenchRow& row : job.rows) {
      add(row.family, row.name, width, short_number(row.ns), cell(row.ratio), cell(row.max_ulp),
          cell(row.evaluations),
          row.judged ? fmt::format("{} of {}", *row.failures, *row.judged) : "-");
      end(change_text(report, row));
    }
  }
}

void append_solvers(Text& to, const BenchReport& report) {
  std::vector<ColumnHead> heads{
      {"function", "", std::max<std::size_t>(24, widest(report, &BenchRow::job))},
      {"solver", "", std::max<std::size_t>(16, widest(report, &BenchRow::name))},
      {"family", "", 7},
      {"time", "ns", 9},
      {"over_control", "", 26},
      {"wall_time", "ns", 9},
      {"cases", "", 5},
      {"measured", "", 24}};
  const bool has_base = !report.results.base.empty();
  if (has_base) heads.emplace_back("over_base", "", 26);
  if (report.changes) heads.emplace_back("change", "", 15);
  append_heads(to, heads);
  for (const BenchJob& job : report.results.jobs)
    for (const BenchRow& row : job.rows) {
      std::vector<std::string> cells{row.job,
                                     row.name,
                                     row.family,
                                     short_number(row.ns),
                                     cell(row.over_control),
                                     cell(row.wall_ns),
                                     cell(row.cases),
                                     row.measured};
      if (has_base) cells.push_back(cell(row.over_base));
      if (report.changes) cells.push_back(change_text(report, row));
      append_row(to, heads, cells);
    }
}

void append_table(Text& to, const BenchReport& report) {
  if (report.results.is_of_solvers)
    append_solvers(to, report);
  else
    append_contenders(to, report);
  if (!report.changes) return;
  for (const RowNote& note : report.changes->gone) append_line(to, "GONE: " + note.line());
}

Json notes_json(const std::vector<RowNote>& notes) {
  Json all = Json::array();
  for (const RowNote& note : notes) all.push_back({{"row", note.key}, {"text", note.text}});
  return all;
}

Json comparison_json(const BenchReport& report) {
  if (!report.changes) return nullptr;
  const auto name = [](const std::string& text) { return text.empty() ? Json() : Json(text); };
  Json made{{"baseline", name(report.baseline)},
            {"base", name(report.results.base)},
            {"overall", report.changes->holds() ? "no worse" : "worse"},
            {"rows", report.changes->rows},
            {"compared", report.changes->compared},
            {"timed", report.changes->timed}};
  for (const ChangeList& list : change_lists)
    made[list.name] = notes_json((*report.changes).*list.notes);
  made["remarks"] = report.changes->remarks;
  return made;
}

void append_json(Text& to, const BenchReport& report) {
  Json all = document("bench/1", {{"commit", program_commit()}, {"rows", Json::array()}});
  for (const BenchJob& job : report.results.jobs)
    for (const BenchRow& row : job.rows) {
      Json object{{"job", row.job}, {"family", row.family}, {"name", row.name}};
      for (const Field& field : fields) {
        const Value value = field.value(row);
        object[field.name] = !value           ? Json()
                             : field.is_count ? Json(static_cast<long>(*value))
                                              : Json(*value);
      }
      object["measured"] = row.measured.empty() ? Json() : Json(row.measured);
      all["rows"].push_back(std::move(object));
    }
  all["left_out"] = report.results.left_out;
  all["kept"] = report.results.kept;
  all["comparison"] = comparison_json(report);
  append(to, all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

void append_tsv(Text& to, const BenchResults& results) {
  append(to, "job\tfamily\tname");
  for (const Field& field : fields) append(to, fmt::format("\t{}", field.name));
  append(to, "\tmeasured\n");
  for (const BenchJob& job : results.jobs)
    for (const BenchRow& row : job.rows) {
      append(to, fmt::format("{}\t{}\t{}", row.job, row.family, row.name));
      for (const Field& field : fields) {
        const Value value = field.value(row);
        append(to, value ? fmt::format("\t{}", *value) : "\t");
      }
      append(to, fmt::format("\t{}\n", row.measured));
    }
}

void append_markdown(Text& to, const BenchReport& report) {
  const auto text = [](const std::string& plain) { return report::escape_markdown(plain); };
  append(to, fmt::format("### tribocheck bench: {}\n\n",
                         report.changes ? text(report.verdict()) : "no gate was asked for"));
  append(to,
         "| row | ns | over the control | over the base | max ulp | failures | change |\n"
         "|---|---:|---:|---:|---:|---:|---|\n");
  for (const BenchJob& job : report.results.jobs)
    for (const BenchRow& row : job.rows)
      append(to, fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", text(row.key()),
                             short_number(row.ns), cell(row.over_control), cell(row.over_base),
                             cell(row.max_ulp),
                             row.judged ? fmt::format("{} of {}", *row.failures, *row.judged) : "-",
                             change_text(report, row)));
  append(to, "\n");
  for (const std::string& line : report.results.left_out)
    append(to, "- Left out: " + text(line) + "\n");
  for (const std::string& line : report.results.kept) append(to, "- " + text(line) + "\n");
  if (!report.changes) return;
  for (const ChangeList& list : change_lists)
    for (const RowNote& note : (*report.changes).*list.notes)
      append(to, fmt::format("- {}{}{}: {}\n", list.is_red ? "**" : "", list.sentence,
                             list.is_red ? "**" : "", text(note.line())));
  for (const std::string& line : report.changes->remarks) append(to, "- " + text(line) + "\n");
}

// The texts of the red notes on the row `key`; if it is empty, of those on no row.
std::string red_text(const BenchChanges& changes, const std::string& key) {
  std::string all;
  for (const ChangeList& list : change_lists)
    for (const RowNote& note : changes.*list.notes)
      if (list.is_red && note.key == key) all += (all.empty() ? "" : "; ") + note.text;
  return all;
}

}  // namespace

std::string BenchReport::verdict() const {
  const std::string against = !baseline.empty() ? baseline : results.base;
  return fmt::format("{} {}: {} of {} rows compared, the times of {}",
                     changes->holds() ? "PASSED, no worse than" : "FAILED, worse than", against,
                     changes->compared, changes->rows, changes->timed);
}

void append_bench(Text& to, const BenchReport& report, const std::string& format) {
  if (format == "json")
    append_json(to, report);
  else if (format == "tsv")
    append_tsv(to, report.results);
  else if (format == "markdown")
    append_markdown(to, report);
  else
    append_table(to, report);
}

std::string bench_junit(const BenchReport& report) {
  using End = JunitTest::End;
  JunitSuite suite{"speed", {}, true};
  suite.name = "tribocheck bench";
  const auto add = [&](const std::string& key) {
    const std::string why = report.changes ? red_text(*report.changes, key) : "";
    suite.tests.push_back({key, why.empty() ? End::passed : End::failure, why});
  };
  for (const BenchJob& job : report.results.jobs)
    for (const BenchRow& row : job.rows) add(row.key());
  if (report.changes) {
    for (const RowNote& note : report.changes->gone)  // rows of the second solver are there already
      if (std::ranges::find(suite.tests, note.key, &JunitTest::name) == suite.tests.end())
        add(note.key);
    if (const std::string why = red_text(*report.changes, ""); !why.empty())
      suite.tests.push_back({"comparison", End::failure, why});
    for (const RowNote& note : report.changes->told)
      suite.output += "a little slower, not red: " + note.line() + "\n";
    for (const std::string& line : report.changes->remarks) suite.output += line + "\n";
  }
  for (const std::string& line : report.results.kept) suite.output += line + "\n";
  for (const std::string& line : report.results.left_out) {
    const std::size_t end = std::min(line.find(": "), line.size());
    suite.tests.push_back({line.substr(0, end), End::skipped, line});
  }
  return junit_xml(suite);
}

}  // namespace tribo::cli
