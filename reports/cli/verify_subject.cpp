// SPDX-License-Identifier: Apache-2.0
#include "verify_subject.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "bad_input.hpp"
#include "conformance_writers.hpp"
#include "exit_code.hpp"
#include "messages.hpp"
#include "progress.hpp"
#include "report/pending_file.hpp"
#include "report/project_files.hpp"

namespace tribo::cli {
namespace {

using namespace conformance;

// A word of a shell's command line.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) {
    if (c == '\'')
      text += "'\\''";
    else
      text += c;
  }
  return text + "'";
}

// A plug-in is asked through a process of its own, so that it cannot take the run with it.
std::string command_of(const SubjectArguments& arguments) {
  if (arguments.plugin.empty()) return arguments.command;
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  return "exec " + quoted(self) + " plugin-host " + quoted(arguments.plugin);
}

Tolerance tolerance_of(const std::string& text, const std::vector<Case>& cases) {
  if (text == "strict") return strict_tolerance();
  if (text == "engineering") return engineering_tolerance();
  return read_tolerance(text, cases);
}

void check_required(const SubjectArguments& arguments, const ConformanceResult& result) {
  for (const std::string& wanted : arguments.required)
    if (std::none_of(result.quantities.begin(), result.quantities.end(),
                     [&](const QuantityVerdict& one) { return one.quantity == wanted; }))
      throw std::invalid_argument(fmt::format("--require: {} is no quantity of the table", wanted));
}

// Is every quantity that was asked for by name held?
bool all_required(const SubjectArguments& arguments, const ConformanceResult& result) {
  bool all = true;
  for (const QuantityVerdict& one : result.quantities) {
    const bool wanted = std::find(arguments.required.begin(), arguments.required.end(),
                                  one.quantity) != arguments.required.end();
    if (!wanted || one.status == Status::held) continue;
    complain(fmt::format("required, but {}: {}", name(one.status), one.quantity));
    all = false;
  }
  return all;
}

void write(Text& to, const SubjectVerdict& verdict, const std::string& format) {
  if (format == "json")
    append_subject_json(to, verdict);
  else if (format == "markdown")
    append_subject_markdown(to, verdict);
  else
    append_subject_table(to, verdict);
}

// Compares with the baseline, and writes it anew where that was asked for.
void use_baseline(const SubjectArguments& arguments, SubjectVerdict& verdict) {
  if (arguments.baseline.empty()) return;
  const nlohmann::json before = read_conformance_baseline(arguments.baseline);
  try {
    if (!before.is_null()) verdict.changes = compare(verdict.result, before);
  } catch (const std::runtime_error& error) {
    if (!arguments.force)
      throw std::runtime_error(fmt::format("{}: {}", arguments.baseline, error.what()));
  } catch (const nlohmann::json::exception& error) {
    if (!arguments.force)
      throw std::runtime_error(
          fmt::format("{}: no baseline: {}", arguments.baseline, error.what()));
  }
  if (before.is_null() && !arguments.update_baseline)
    throw std::runtime_error(fmt::format(
        "{}: there is no such baseline; --update-baseline writes it", arguments.baseline));
  if (!arguments.update_baseline) return;
  const nlohmann::json kept = arguments.force ? nlohmann::json(nullptr) : before;
  report::write_file(arguments.baseline, baseline_of(verdict.result, kept).dump(1) + "\n");
  if (before.is_null()) complain("baseline written: " + arguments.baseline);
  if (!verdict.changes) return;
  for (const std::string& line : verdict.changes->better) complain("baseline improved: " + line);
  for (const std::string& line : verdict.changes->worse)
    complain((arguments.force ? "baseline lowered: " : "baseline kept: ") + line);
  if (arguments.force) verdict.changes->worse.clear();
}

int exit_code(const SubjectVerdict& verdict) {
  // With a baseline what failed then may fail now.
  if (verdict.changes) return verdict.changes->worse.empty() ? exit_done : exit_failed;
  const Overall overall = verdict.result.overall;
  return overall == Overall::failed || overall == Overall::nothing ? exit_failed : exit_done;
}

int verify(const SubjectArguments& arguments, OutputStream& output) {
  const report::ReportPlaces places = report::find_places({});
  std::vector<Case> cases =
      read_cases({arguments.exact.empty() ? (places.reference / "exact").string() : arguments.exact,
                  places.scenes.string()});
  const Tolerance tolerance = tolerance_of(arguments.tolerance, cases);
  cases = cases_for(std::move(cases), tolerance);
  if (arguments.sample > 0) cases = sampled(std::move(cases), arguments.sample);

  const auto milliseconds = [](double seconds) {
    return std::chrono::milliseconds(static_cast<long long>(1000 * seconds));
  };
  const Limits limits{milliseconds(arguments.case_timeout), milliseconds(arguments.timeout)};
  SubjectVerdict verdict;
  {
    Progress progress(cases.size(), {"cases", 1, true});
    const Conversation conversation =
        ask(command_of(arguments), cases, limits, [&](std::size_t) { progress.step(); });
    verdict.result = judge(arguments.plugin.empty() ? arguments.command : arguments.plugin, cases,
                           conversation, tolerance);
    verdict.diagnoses = diagnose(cases, conversation, tolerance);
  }
  check_required(arguments, verdict.result);
  use_baseline(arguments, verdict);
  write(output.text(), verdict, arguments.format);
  output.flush();
  if (!arguments.junit.empty()) report::write_file(arguments.junit, subject_junit(verdict));
  const bool required = all_required(arguments, verdict.result);
  return required ? exit_code(verdict) : exit_failed;
}

}  // namespace

int verify_subject(const SubjectArguments& arguments, OutputStream& output) {
  return answered_or_complained([&] { return verify(arguments, output); });
}

}  // namespace tribo::cli
