// SPDX-License-Identifier: Apache-2.0
#include "junit.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "build_info.hpp"
#include "page/texts.hpp"
#include "tribo/scene_reader.hpp"

namespace tribo::cli {
namespace {

std::string time_attribute(const std::optional<double>& seconds) {
  return seconds ? fmt::format(" time=\"{:.3f}\"", *seconds) : "";
}

}  // namespace

std::string junit_xml(const JunitSuite& suite) {
  const auto text = [](const std::string& plain) { return report::escape_html(plain); };
  const auto count = [&](JunitTest::End end) {
    return std::count_if(suite.tests.begin(), suite.tests.end(),
                         [&](const JunitTest& one) { return one.end == end; });
  };
  std::string xml = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\"{}{}>\n",
      text(suite.name), suite.tests.size(), count(JunitTest::End::failure),
      count(JunitTest::End::error),
      suite.counts_skipped ? fmt::format(" skipped=\"{}\"", count(JunitTest::End::skipped)) : "",
      time_attribute(suite.seconds));
  if (!suite.properties.empty()) {
    xml += "  <properties>\n";
    for (const auto& [name, value] : suite.properties)
      xml += fmt::format("    <property name=\"{}\" value=\"{}\"/>\n", text(name), text(value));
    xml += "  </properties>\n";
  }
  for (const JunitTest& one : suite.tests) {
    xml += fmt::format("  <testcase classname=\"{}\" name=\"{}\"{}", suite.classname,
                       text(one.name), time_attribute(one.seconds));
    if (one.end == JunitTest::End::passed) {
      xml += "/>\n";
      continue;
    }
    const char* const kind = one.end == JunitTest::End::failure ? "failure"
                             : one.end == JunitTest::End::error ? "error"
                                                                : "skipped";
    xml += fmt::format("><{} message=\"{}\"", kind, text(one.message));
    xml += one.details.empty() ? "/>" : fmt::format(">{}</{}>", text(one.details), kind);
    xml += "</testcase>\n";
  }
  if (!suite.output.empty())
    xml += fmt::format("  <system-out>{}</system-out>\n", text(suite.output));
  if (!suite.errors.empty())
    xml += fmt::format("  <system-err>{}</system-err>\n", text(suite.errors));
  return xml + "</testsuite>\n";
}

std::string junit_of_error(const std::string& command, const std::string& why,
                           const std::vector<std::string>& errors) {
  JunitSuite suite{command == "bench" ? "speed" : "conformance"};
  suite.name = "tribocheck " + command;
  suite.properties = {{"version", version_line()}};
  suite.tests.push_back({"subject", JunitTest::End::error, printable(why, std::string::npos)});
  suite.errors = fmt::format("{}", fmt::join(errors, "\n"));
  return junit_xml(suite);
}

std::string markdown_of_error(const std::string& command, const std::string& why,
                              const std::vector<std::string>& errors) {
  return fmt::format("### tribocheck {}: NOTHING WAS JUDGED: {}\n\n{}", command,
                     report::escape_markdown(printable(why, std::string::npos)),
                     markdown_of_stderr(errors));
}

std::string markdown_of_stderr(const std::vector<std::string>& errors) {
  if (errors.empty()) return {};
  std::string fence = "````";  // longer than any fence in the text
  for (const std::string& line : errors)
    while (line.find(fence) != std::string::npos) fence += '`';
  std::string text = "- The last it wrote to stderr:\n\n  " + fence + "text\n";
  for (const std::string& line : errors) text += "  " + printable(line, std::string::npos) + "\n";
  return text + "  " + fence + "\n";
}

}  // namespace tribo::cli
