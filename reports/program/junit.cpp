// SPDX-License-Identifier: Apache-2.0
#include "junit.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "page/texts.hpp"

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
      "<testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\"{}{}>\n",
      text(suite.name), suite.tests.size(), count(JunitTest::End::failure),
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
    const char* const kind = one.end == JunitTest::End::failure ? "failure" : "skipped";
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

}  // namespace tribo::cli
