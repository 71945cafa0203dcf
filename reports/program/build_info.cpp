// SPDX-License-Identifier: Apache-2.0
#include "build_info.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <nlohmann/json.hpp>

#include "build_commit.hpp"
#include "tribo/batch.hpp"
#include "tribo/scene_reader.hpp"
#include "tribo/version.hpp"

namespace tribo::cli {

std::string_view program_commit() {
  const std::string_view commit = build_commit;
  return commit.empty() ? "unknown" : commit;
}

std::string version_line() {
  return fmt::format("tribocheck {} (commit {}, instruction set {})", version, program_commit(),
                     instruction_set());
}

std::string today() { return fmt::format("{:%F}", fmt::gmtime(std::time(nullptr))); }

std::string document_head(std::string_view schema) {
  return fmt::format(R"("schema": "{}", "version": "{}")", schema, version);
}

nlohmann::ordered_json document(std::string_view schema, const nlohmann::ordered_json& members) {
  nlohmann::ordered_json made{{"schema", schema}, {"version", version}};
  made.update(members);
  return made;
}

std::string list_start(std::string_view schema, std::string_view member) {
  return fmt::format("{{{}, \"{}\": [\n", document_head(schema), member);
}

std::string list_end_with(const nlohmann::ordered_json& members) {
  std::string text = "\n]";
  for (const auto& [name, value] : members.items())
    text += fmt::format(", \"{}\": {}", name,
                        without_controls(value.dump(
                            -1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)));
  return text + "}\n";
}

}  // namespace tribo::cli
