// SPDX-License-Identifier: Apache-2.0
#include "page/project_files.hpp"

#include <fmt/format.h>

#include <exception>
#include <string>
#include <system_error>

#include "protocol/text_streams.hpp"
#include "sweep/output_file.hpp"

namespace tribo::report {
namespace {

namespace fs = std::filesystem;

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool is_project(const fs::path& folder) {
  return is_folder(folder / "reports/page/render") && is_folder(folder / "reference/published");
}

// `folder` or the nearest one above it that is the project; empty if none is.
fs::path project_above(fs::path folder) {
  while (!folder.empty()) {
    if (is_project(folder)) return folder;
    if (folder == folder.parent_path()) break;
    folder = folder.parent_path();
  }
  return {};
}

fs::path folder_of_program() {
  std::error_code ignored;
  return fs::read_symlink("/proc/self/exe", ignored).parent_path();
}

fs::path current_folder() {
  std::error_code error;
  fs::path folder = fs::current_path(error);
  if (error) throw ReportError("the current folder: " + error.message());
  return folder;
}

protocol::OutputFailed cannot_write(const std::filesystem::path& path, const std::string& why) {
  const std::string start = fmt::format("cannot write {}: ", path.string());
  return protocol::OutputFailed(why.starts_with(start) ? why : start + why);
}

}  // namespace

ReportPlaces usual_places() {
  const fs::path current = current_folder();
  fs::path root = project_above(current);
  if (root.empty()) root = project_above(folder_of_program());
  if (!root.empty())
    return {root / "reports/out",
            root / "reference/published",
            root / "reports/page/render",
            root,
            root / "reference",
            root / "verification/conformance/templates",
            root / "verification/conformance"};
  const fs::path prefix = folder_of_program().parent_path();
  const fs::path shared = prefix / "share/tribocheck";
  return {current / "reports/out", shared / "published", shared / "page/render", {}, shared,
          shared / "templates",    prefix / "include"};
}

fs::path reference_tables(const fs::path& given) {
  fs::path folder = given.empty() ? usual_places().reference / "exact" : given;
  if (is_folder(folder)) return folder;
  throw ReportError(given.empty()
                        ? "reference tables not found; pass --reference, or run in the project"
                        : "--reference: " + given.string() + " is not a folder");
}

ReferenceFiles reference_files(const fs::path& given) {
  const ReportPlaces usual = usual_places();
  const fs::path exact = reference_tables(given);
  const auto found = [&](const fs::path& place, const char* name) {
    return (fs::exists(place) ? place : (exact / ".." / name).lexically_normal()).string();
  };
  return {exact.string(), found(usual.scenes, "published"),
          found(usual.reference / "mistakes.toml", "mistakes.toml")};
}

std::string ReportPlaces::shown(const fs::path& file) const {
  if (root.empty()) return file.string();
  const fs::path inside = file.lexically_relative(root);
  return inside.empty() || *inside.begin() == ".." ? file.string() : inside.string();
}

ReportPlaces find_places(const ReportOptions& options) {
  ReportPlaces places = usual_places();
  if (!options.out.empty()) places.out = fs::absolute(options.out).lexically_normal();
  if (!options.scenes.empty()) places.scenes = fs::absolute(options.scenes).lexically_normal();
  if (!is_folder(places.render))
    throw ReportError(
        "no folder reports/page/render above the current one or above the program: "
        "run tribocheck report inside the project");
  if (!is_folder(places.scenes))
    throw ReportError(places.scenes.string() +
                      " is not a folder; --scenes names the one with "
                      "the scenes rough.toml, medium.toml, smooth.toml, …");
  return places;
}

void write_file(const std::filesystem::path& target, std::string_view content,
                const sweep::Replaceable& replaceable) {
  try {
    sweep::PartFile file(sweep::output_behind_links(target.string()));
    file.write(content);
    file.keep(replaceable);
  } catch (const std::exception& error) {
    throw cannot_write(target, error.what());
  }
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw cannot_write(folder, error.message());
}

}  // namespace tribo::report
