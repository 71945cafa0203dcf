// SPDX-License-Identifier: Apache-2.0
#include "page/environment.hpp"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <charconv>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string_view>

#include "page/baselines.hpp"
#include "page/number_text.hpp"
#include "tribo/batch.hpp"
#include "tribo/version.hpp"

namespace tribo::report {
namespace {

namespace chrono = std::chrono;

#ifdef __clang__
constexpr std::string_view compiler = __VERSION__;
#else
constexpr std::string_view compiler = "g++ " __VERSION__;
#endif

chrono::sys_days today() {
  const char* const epoch = std::getenv("SOURCE_DATE_EPOCH");
  const std::string_view text = epoch == nullptr ? "" : epoch;
  long long seconds = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), seconds);
  if (text.empty() || read.ptr != text.data() + text.size())
    return chrono::floor<chrono::days>(chrono::system_clock::now());
  return chrono::floor<chrono::days>(chrono::sys_seconds(chrono::seconds(seconds)));
}

std::string iso(chrono::sys_days day) {
  const chrono::year_month_day date(day);
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
}

// Of "2026-11-21".
std::optional<chrono::sys_days> day_of(const std::string& text) {
  int year = 0;
  unsigned month = 0, day = 0;
  if (std::sscanf(text.c_str(), "%4d-%2u-%2u", &year, &month, &day) != 3) return std::nullopt;
  const chrono::year_month_day date{chrono::year(year), chrono::month(month), chrono::day(day)};
  if (!date.ok()) return std::nullopt;
  return chrono::sys_days(date);
}

std::string age(const std::string& date, chrono::sys_days now) {
  const auto day = day_of(date);
  if (!day) return "unknown";
  const auto days = (now - *day).count();
  if (days < 0) return "dated after this page";
  return days == 0 ? "today" : fmt::format("{} {}", days, days == 1 ? "day" : "days");
}

std::string kernel() {
  utsname name{};
  if (::uname(&name) != 0) return "unknown";
  return fmt::format("{} {} {}", name.sysname, name.release, name.machine);
}

TextTable machine_table(const std::string& commit, chrono::sys_days now) {
  return {"This page",
          {"what", "value"},
          {false, false},
          {{"tribocheck", std::string(version)},
           {"commit", commit.empty() ? "not told" : fmt::format("`{}`", commit)},
           {"compiler", compiler_name()},
           {"processor", processor_name()},
           {"instruction set", std::string(instruction_set())},
           {"kernel", kernel()},
           {"date", iso(now)}},
          {}};
}

std::string text_of(const Json& of, const char* key) {
  return of.contains(key) && of.at(key).is_string() ? of.at(key).get<std::string>() : "unknown";
}

std::vector<std::string> baseline_row(const ReportPlaces& places, const BaselineKind& kind,
                                      chrono::sys_days now) {
  const std::string name = fmt::format("`{}`", kind.file), target = target_of(kind.file);
  try {
    const Json baseline = read_baseline(places, kind.file);
    const std::string date = text_of(baseline, "date");
    const Json machine = baseline.value("environment", Json::object());
    return {name,
            std::string(kind.what),
            target,
            fmt::format("`{}`", short_commit(text_of(baseline, "commit"))),
            date,
            age(date, now),
            fmt::format("{}; {}", text_of(machine, "cpu"), text_of(machine, "compiler"))};
  } catch (const std::exception& error) {
    return {name,
            std::string(kind.what),
            target,
            "–",
            "–",
            "–",
            fmt::format("not here: {}", error.what())};
  }
}

TextTable baselines_table(const ReportPlaces& places, chrono::sys_days now) {
  TextTable table{"What slow targets left in `reference/baselines`",
                  {"file", "what", "made by", "commit", "date", "age", "machine"},
                  {false, false, false, false, false, false, false},
                  {},
                  "Their results are shown below as they were left, not measured again."};
  for (const BaselineKind& kind : baseline_kinds)
    table.rows.push_back(baseline_row(places, kind, now));
  return table;
}

}  // namespace

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

std::string compiler_name() { return std::string(compiler); }

Section environment_section(const ReportPlaces& places, const std::string& commit) {
  const chrono::sys_days now = today();
  Section section{"environment", "Environment"};
  section.paragraphs = {
      "All else on this page follows from its inputs: made again from the same inputs, it is the "
      "same "
      "byte for byte but for this section."};
  section.tables = {machine_table(commit, now), baselines_table(places, now)};
  return section;
}

}  // namespace tribo::report
