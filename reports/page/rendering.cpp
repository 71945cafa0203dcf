// SPDX-License-Identifier: Apache-2.0
#include "page/rendering.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <utility>

#include "conformance/child_process.hpp"
#include "page/project_files.hpp"
#include "protocol/bounded_json.hpp"
#include "protocol/text_streams.hpp"

namespace tribo::report {
namespace {

constexpr int missing_packages = 3;  // exit code of the scripts

}  // namespace

std::string python() {
  const char* const of_debian = "/usr/bin/python3";
  std::error_code ignored;
  return std::filesystem::exists(of_debian, ignored) ? of_debian : "python3";
}

Rendering run_script(const ReportPlaces& places, const std::string& script,
                     const std::vector<std::string>& arguments) {
  std::vector<std::string> command{python(), "-B", (places.render / script).string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  const conformance::ChildEnd end = conformance::run_child(std::move(command));
  Rendering rendering;
  const auto failed = [&](const std::string& why) {
    rendering.undrawn.push_back(why);
    return rendering;
  };
  if (end.start_error != 0)
    return failed(
        "python3 was not found: neither page nor pictures can be made (Debian: apt-get install "
        "python3)");
  if (end.exited_with(missing_packages))
    return failed(end.text.substr(0, end.text.find('\n')) +
                  ": neither page nor pictures can be made");
  const nlohmann::json said = protocol::parse_bounded_json(end.text);
  if (!end.succeeded() || said.is_discarded())
    return failed(fmt::format("{} failed: see above", script));
  rendering.written = said.at("written").get<std::vector<std::string>>();
  rendering.undrawn = said.at("undrawn").get<std::vector<std::string>>();
  return rendering;
}

}  // namespace tribo::report
