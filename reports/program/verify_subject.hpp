// SPDX-License-Identifier: Apache-2.0
// tribocheck verify --subject: somebody else's solver put to the tests.
#pragma once

#include <string>
#include <vector>

#include "output.hpp"

namespace tribo::cli {

struct SubjectArguments {
  std::string command;  // value of --subject
  std::string plugin;   // value of --plugin
  std::string exact;    // empty: reference/exact of the project
  std::string tolerance = "engineering";
  std::string format = "table";
  std::string junit;     // empty: none
  std::string baseline;  // empty: none
  bool update_baseline = false, force = false;
  std::vector<std::string> required;  // quantities that have to be held
  std::size_t sample = 0;             // cases of each function at most; 0: all
  double case_timeout = 10, start_timeout = 60, timeout = 600;  // s
  std::vector<std::string> shown;  // cases that are to be shown; empty: all are judged
  std::string saved_cases;         // the file of --save-cases; empty: none, "-": stdout
};

// Exit code 0: all that is offered holds; 1: something failed, or nothing is offered; 2: bad input,
// or a subject that never answers. Without a subject the cases are shown or saved, and nothing is
// judged.
int verify_subject(const SubjectArguments& arguments, OutputStream& output);

}  // namespace tribo::cli
