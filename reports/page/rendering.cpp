// SPDX-License-Identifier: Apache-2.0
#include "page/rendering.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "conformance/child_process.hpp"
#include "page/project_files.hpp"
#include "page/sweep_tables.hpp"
#include "protocol/bounded_json.hpp"
#include "protocol/text_streams.hpp"

namespace tribo::report {
namespace {

constexpr int missing_packages = 3;  // exit code of the scripts

using nlohmann::ordered_json;

// A grid of one field alone whose film can be drawn as a map over speed and that field.
bool is_map(const sweep::SceneResult& scene) {
  const sweep::ColumnResult* const film = scene.column("film");
  return scene.design == "factorial" && scene.has_points && scene.inputs.size() == 1 &&
         scene.inputs.front().words.empty() && film != nullptr && film->values.size() >= 3 &&
         film->values.size() == scene.speeds.size();
}

// The field of each case, and its film at each speed.
ordered_json map_json(const sweep::SceneResult& scene, const sweep::ResultFile& result) {
  const auto field = result.input(scene.id, scene.inputs.front().path);
  const auto films = result.column(scene.id, "film");
  const std::size_t speeds = scene.speeds.size();
  if (films.size() != field.size() * speeds)
    throw std::runtime_error(result.path() + " has a torn film");
  ordered_json rows = ordered_json::array();
  for (auto first = films.begin(); first != films.end();
       first += static_cast<std::ptrdiff_t>(speeds))
    rows.push_back(std::vector(first, first + static_cast<std::ptrdiff_t>(speeds)));
  return {{"field", field}, {"film", std::move(rows)}};
}

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

Rendering draw_sweep_pictures(const sweep::SweepResult& result, const sweep::ResultFile& source,
                              const std::string& folder) {
  try {
    make_folder(folder);
    ordered_json json = sweep_json(result);
    for (std::size_t i = 0; i < result.scenes.size(); ++i)
      if (is_map(result.scenes[i])) json["scenes"][i]["map"] = map_json(result.scenes[i], source);
    const sweep::PartFile file(std::filesystem::path(folder) / "result.json");  // goes again
    file.write(json.dump(-1, ' ', false, ordered_json::error_handler_t::replace));
    return run_script(usual_places(), "sweep_pictures.py", {file.path(), folder});
  } catch (const std::runtime_error& error) {
    return {{}, {error.what()}};
  }
}

}  // namespace tribo::report
