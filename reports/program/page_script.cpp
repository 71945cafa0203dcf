// SPDX-License-Identifier: Apache-2.0
#include "page_script.hpp"

#include "conformance/child_process.hpp"
#include "messages.hpp"
#include "page/rendering.hpp"

namespace tribo::cli {

int run_page_script(const std::filesystem::path& script, const std::vector<std::string>& arguments,
                    const char* made, OutputStream& output) {
  std::vector<std::string> command{report::python(), "-B", script.string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  const conformance::ChildEnd end = conformance::run_child(std::move(command));
  if (end.start_error != 0)
    return fail(exit_failed, std::string("python3 was not found: no ") + made +
                                 " can be made (Debian: apt-get install python3)");
  append(output.text(), end.text);
  output.flush();
  return end.exit_code >= 0
             ? end.exit_code
             : fail(exit_failed, script.filename().string() + " was ended by a signal");
}

}  // namespace tribo::cli
