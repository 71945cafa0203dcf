// SPDX-License-Identifier: Apache-2.0
// Results as JUnit XML, which CI systems read. All elements and attributes are in the schema
// junit-10.xsd of Jenkins' xUnit plug-in, and in the schemas of other systems, too.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tribo::cli {

struct JunitTest {
  enum class End : std::uint8_t { passed, failure, skipped, error };
  std::string name;
  End end = End::passed;
  std::string message = {}, details = {};  // not written if it passed; details may be empty
  std::optional<double> seconds = {};      // that it took, where that is known
};

struct JunitSuite {
  std::string classname;  // of all tests
  std::vector<JunitTest> tests = {};
  bool counts_skipped = false;
  std::vector<std::pair<std::string, std::string>> properties = {};  // name and value
  std::string output = {}, errors = {};  // of the whole run; empty: none
  std::string name = "tribocheck verify";
  std::optional<double> seconds = {};  // of the whole run
};

std::string junit_xml(const JunitSuite& suite);

// The JUnit XML of a run of `command` ("verify" or "bench") that could judge nothing: one test that
// ended with the error `why`. `errors` are the last lines that the subject wrote to stderr. The
// second function gives the same in Markdown.
std::string junit_of_error(const std::string& command, const std::string& why,
                           const std::vector<std::string>& errors);
std::string markdown_of_error(const std::string& command, const std::string& why,
                              const std::vector<std::string>& errors);

// "- The last it wrote to stderr:" and the lines, in a code block; empty if there are none.
std::string markdown_of_stderr(const std::vector<std::string>& errors);

}  // namespace tribo::cli
