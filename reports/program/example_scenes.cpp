// SPDX-License-Identifier: Apache-2.0
#include "example_scenes.hpp"

#include <filesystem>
#include <string_view>
#include <utility>

#include "page/project_files.hpp"
#include "page/report_error.hpp"

namespace tribo::cli {
namespace {

constexpr std::string_view usual = "reference/published";

std::string scenes_folder() {
  std::error_code ignored;
  if (std::filesystem::is_directory(usual, ignored)) return std::string(usual);
  try {
    return report::find_places({}).scenes.string();
  } catch (const report::ReportError&) {
    return std::string(usual);  // there are no scenes to name
  }
}

}  // namespace

std::function<std::string()> footer_with_scenes(std::string text) {
  return [text = std::move(text)] {
    const std::string folder = scenes_folder();
    std::string footer = text;
    for (std::size_t at = footer.find(usual); at != std::string::npos;
         at = footer.find(usual, at + folder.size()))
      footer.replace(at, usual.size(), folder);
    return footer;
  };
}

}  // namespace tribo::cli
