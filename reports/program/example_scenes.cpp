// SPDX-License-Identifier: Apache-2.0
#include "example_scenes.hpp"

#include <filesystem>
#include <string_view>
#include <utility>

#include "page/project_files.hpp"
#include "page/report_error.hpp"

namespace tribo::cli {
namespace {

// A folder that examples name, where it is.
std::string found(std::string_view usual,
                  std::filesystem::path (*place)(const report::ReportPlaces&)) {
  std::error_code ignored;
  if (std::filesystem::is_directory(usual, ignored)) return std::string(usual);
  try {
    return place(report::find_places({})).string();
  } catch (const report::ReportError&) {
    return std::string(usual);  // there are no scenes to name
  }
}

void replace_all(std::string& text, std::string_view usual, const std::string& folder) {
  for (std::size_t at = text.find(usual); at != std::string::npos;
       at = text.find(usual, at + folder.size()))
    text.replace(at, usual.size(), folder);
}

}  // namespace

std::function<std::string()> footer_with_scenes(std::string text) {
  return [text = std::move(text)] {
    std::string footer = text;
    replace_all(footer, "reference/published",
                found("reference/published",
                      [](const report::ReportPlaces& places) { return places.scenes; }));
    replace_all(footer, "reference/scenes",
                found("reference/scenes", [](const report::ReportPlaces& places) {
                  return places.reference / "scenes";
                }));
    return footer;
  };
}

}  // namespace tribo::cli
