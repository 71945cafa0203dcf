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
#include "page/groups.hpp"
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

// Reads "2026-11-21".
std::optional<chrono::sys_days> day_of(const std::string& text) {
  int year = 0;
  unsigned month = 0, day = 0;
  if (std::sscanf(text.c_str(), "%4d-%2u-%2u", &year, &month, &day) != 3) return std::nullopt;
  const chrono::year_month_day date{chrono::year(year), chrono::month(month), chrono::day(day)};
  if (!date.ok()) return std::nullopt;
  return chrono::sys_days(date);
}

std::string kernel() {
  utsname name{};
  if (::uname(&name) != 0) return "unknown";
  return fmt::format("{} {} {}", name.sysname, name.release, name.machine);
}

std::string text_of(const Json& of, const char* key) {
  return of.contains(key) && of.at(key).is_string() ? of.at(key).get<std::string>() : "unknown";
}

// The baseline that a slow target left, and its age in days; or why its file cannot be read.
Json baseline_json(const ReportPlaces& places, const BaselineKind& kind, chrono::sys_days now) {
  Json row{{"file", kind.file}, {"what", kind.what}, {"target", kind.target}};
  try {
    const Json baseline = read_baseline(places, kind.file);
    const Json machine = baseline.value("environment", Json::object());
    const std::string date = text_of(baseline, "date");
    const auto day = day_of(date);
    row["commit"] = text_of(baseline, "commit");
    row["date"] = date;
    row["age_in_days"] = day ? Json((now - *day).count()) : Json(nullptr);
    row["processor"] = text_of(machine, "cpu");
    row["compiler"] = text_of(machine, "compiler");
  } catch (const std::exception& error) {
    row["missing"] = error.what();
  }
  return row;
}

}  // namespace

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

std::string compiler_name() { return std::string(compiler); }

Group environment_group(const ReportPlaces& places, const std::string& commit) {
  const chrono::sys_days now = today();
  Group group;
  group.data = {{"version", std::string(version)},
                {"commit", commit.empty() ? Json(nullptr) : Json(commit)},
                {"compiler", compiler_name()},
                {"processor", processor_name()},
                {"instruction_set", std::string(instruction_set())},
                {"kernel", kernel()},
                {"date", iso(now)},
                {"baselines", Json::array()}};
  for (const BaselineKind& kind : baseline_kinds)
    group.data["baselines"].push_back(baseline_json(places, kind, now));
  return group;
}

}  // namespace tribo::report
