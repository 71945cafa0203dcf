// SPDX-License-Identifier: Apache-2.0
#include "conformance_writers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "report/markup.hpp"
#include "table.hpp"

namespace tribo::cli {
namespace {

using namespace conformance;

std::string margin(double part_of_bound) {
  return std::isfinite(part_of_bound) ? fmt::format("{:.3g}", part_of_bound) : "no number";
}
std::string error(double relative) {
  return std::isfinite(relative) ? fmt::format("{:.2g}", relative) : "-";
}

bool has_numbers(const QuantityVerdict& one) { return one.held + one.failed > 0; }

std::size_t count(const ConformanceResult& result, Status status) {
  return static_cast<std::size_t>(
      std::count_if(result.quantities.begin(), result.quantities.end(),
                    [&](const QuantityVerdict& one) { return one.status == status; }));
}

// What broke the protocol, and what a user should know of the run.
std::vector<std::string> remarks(const ConformanceResult& result) {
  std::vector<std::string> lines;
  if (result.violation_count > 0)
    lines.push_back(fmt::format("The protocol was broken {} times:", result.violation_count));
  for (const std::string& one : result.violations) lines.push_back("  " + one);
  if (result.violation_count > result.violations.size()) lines.emplace_back("  …");
  if (result.answers_at_end_of_input)
    lines.emplace_back(
        "It answers when its input ends only: it should flush its output after each line.");
  if (result.starts > 1)
    lines.push_back(
        fmt::format("It was started {} times, as it died or did not answer.", result.starts));
  if (!result.last_errors.empty() && result.overall != Overall::complete) {
    std::string tail = result.last_errors;
    while (tail.ends_with('\n')) tail.pop_back();
    const std::size_t line = tail.rfind('\n');
    lines.push_back("The last it wrote to stderr: " +
                    (line == std::string::npos ? tail : tail.substr(line + 1)));
  }
  return lines;
}

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace

std::string summary(const ConformanceResult& result) {
  const char* const word = result.overall == Overall::complete  ? "COMPLETE"
                           : result.overall == Overall::partial ? "PARTIAL"
                           : result.overall == Overall::failed  ? "FAILED"
                                                                : "NOTHING";
  std::string text = fmt::format("{}: {} of {} quantities held", word, count(result, Status::held),
                                 result.quantities.size());
  const auto add = [&](Status status, const char* what) {
    if (const std::size_t n = count(result, status); n > 0) text += fmt::format(", {} {}", n, what);
  };
  add(Status::partly_held, "held in part");
  add(Status::failed, "failed");
  add(Status::not_offered, "not offered");
  return text + fmt::format(" (tolerance: {}).", result.tolerance);
}

void append_subject_table(Text& to, const SubjectVerdict& verdict) {
  const std::vector<ColumnHead> heads{
      {"quantity", "", 36}, {"asked", "", 6},        {"held", "", 6},     {"failed", "", 6},
      {"skipped", "", 7},   {"worst_error", "", 11}, {"of_bound", "", 9}, {"verdict", "", 12}};
  append_heads(to, heads);
  for (const QuantityVerdict& one : verdict.result.quantities) {
    const std::string cells[] = {one.quantity,
                                 std::to_string(one.asked),
                                 std::to_string(one.held),
                                 std::to_string(one.failed),
                                 std::to_string(one.skipped),
                                 has_numbers(one) ? error(one.worst_relative) : "",
                                 has_numbers(one) ? margin(one.worst_part_of_bound) : "",
                                 std::string(name(one.status))};
    for (std::size_t i = 0; i < heads.size(); ++i) append_cell(to, cells[i], heads[i].width());
    append(to, "\n");
  }
  for (const QuantityVerdict& one : verdict.result.quantities)
    if (one.status == Status::failed)
      append(to, one_line(fmt::format("\n{}: {}", one.quantity, one.first_reason)));
  append(to, "\n");
  for (const Diagnosis& one : verdict.diagnoses)
    append(to, fmt::format("\nDiagnosis: {}\n", one.text));
  for (const std::string& line : remarks(verdict.result)) append(to, line + "\n");
  if (verdict.changes)
    for (const std::string& line : verdict.changes->worse)
      append(to, "Worse than the baseline: " + line + "\n");
  append(to, "\n" + summary(verdict.result) + "\n");
}

void append_subject_json(Text& to, const SubjectVerdict& verdict) {
  using Json = nlohmann::ordered_json;
  const ConformanceResult& result = verdict.result;
  const auto number = [](double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); };
  Json all{{"subject", result.subject},
           {"tolerance", result.tolerance},
           {"overall", name(result.overall)},
           {"summary", summary(result)},
           {"quantities", Json::array()},
           {"diagnoses", Json::array()},
           {"violation_count", result.violation_count},
           {"violations", result.violations},
           {"starts", result.starts},
           {"answers_at_end_of_input", result.answers_at_end_of_input},
           {"last_errors", result.last_errors}};
  for (const QuantityVerdict& one : result.quantities)
    all["quantities"].push_back({{"quantity", one.quantity},
                                 {"status", name(one.status)},
                                 {"asked", one.asked},
                                 {"held", one.held},
                                 {"failed", one.failed},
                                 {"skipped", one.skipped},
                                 {"worst_relative_error", number(one.worst_relative)},
                                 {"worst_part_of_bound", number(one.worst_part_of_bound)},
                                 {"worst_case", one.worst_case},
                                 {"reason", one.first_reason}});
  for (const Diagnosis& one : verdict.diagnoses)
    all["diagnoses"].push_back({{"quantity", one.quantity},
                                {"mistakes", one.mistakes},
                                {"explained", one.explained},
                                {"wrong", one.wrong},
                                {"text", one.text}});
  if (verdict.changes)
    all["baseline"] = {{"worse", verdict.changes->worse}, {"better", verdict.changes->better}};
  append(to, all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

void append_subject_markdown(Text& to, const SubjectVerdict& verdict) {
  const auto cell = [](const std::string& text) {
    std::string safe = report::to_markdown(one_line(text));
    return safe;
  };
  append(to, fmt::format("### tribocheck: {}\n\n", cell(summary(verdict.result))));
  append(to,
         "| quantity | verdict | held | failed | skipped | worst error | of its bound |\n"
         "|---|---|---:|---:|---:|---:|---:|\n");
  for (const QuantityVerdict& one : verdict.result.quantities)
    append(to,
           fmt::format("| `{}` | {} | {} | {} | {} | {} | {} |\n", one.quantity,
                       one.status == Status::failed ? "**FAILED**" : std::string(name(one.status)),
                       one.held, one.failed, one.skipped,
                       has_numbers(one) ? error(one.worst_relative) : "",
                       has_numbers(one) ? margin(one.worst_part_of_bound) : ""));
  append(to, "\n");
  for (const Diagnosis& one : verdict.diagnoses)
    append(to, fmt::format("- **Diagnosis.** {}\n", cell(one.text)));
  for (const std::string& line : remarks(verdict.result)) append(to, "- " + cell(line) + "\n");
  if (!verdict.changes) return;
  for (const std::string& line : verdict.changes->worse)
    append(to, "- **Worse than the baseline.** " + cell(line) + "\n");
  for (const std::string& line : verdict.changes->better)
    append(to, "- Better than the baseline: " + cell(line) + "\n");
}

std::string subject_junit(const SubjectVerdict& verdict) {
  const auto text = [](const std::string& plain) {
    std::string safe;
    for (const char c : report::escape_html(plain))  // XML knows no other control signs
      safe += static_cast<unsigned char>(c) >= 0x20 || c == '\t' || c == '\n' ? c : '?';
    return safe;
  };
  const ConformanceResult& result = verdict.result;
  std::string xml = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuite name=\"tribocheck verify\" tests=\"{}\" failures=\"{}\" skipped=\"{}\">\n",
      result.quantities.size() + 1,
      count(result, Status::failed) + (result.violation_count > 0 ? 1 : 0),
      count(result, Status::not_offered));
  for (const QuantityVerdict& one : result.quantities) {
    xml += fmt::format("  <testcase classname=\"conformance\" name=\"{}\"", text(one.quantity));
    if (one.status == Status::failed)
      xml += fmt::format("><failure message=\"{} of {}: {}\"/></testcase>\n", one.failed, one.asked,
                         text(one.first_reason));
    else if (one.status == Status::not_offered)
      xml += fmt::format("><skipped message=\"{}\"/></testcase>\n", text(one.first_reason));
    else
      xml += "/>\n";
  }
  xml += "  <testcase classname=\"conformance\" name=\"protocol\"";
  xml += result.violation_count == 0 ? "/>\n"
                                     : fmt::format("><failure message=\"{}\"/></testcase>\n",
                                                   text(result.violations.front()));
  return xml + "</testsuite>\n";
}

}  // namespace tribo::cli
