// SPDX-License-Identifier: Apache-2.0
// Where the scenes and the scripts of the page are, where the report goes, and files that appear
// whole or not at all: written beside their place, then renamed into it.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sweep/output_file.hpp"

namespace tribo::report {

// The error that stops a report: bad scenes, missing files. Exit code 2.
class ReportError : public std::runtime_error {
 public:
  explicit ReportError(const std::string& line) : std::runtime_error(line), lines_{line} {}
  explicit ReportError(std::vector<std::string> lines)
      : std::runtime_error(lines.empty() ? "unknown error" : lines.front()),
        lines_(std::move(lines)) {}

  // One problem a line.
  const std::vector<std::string>& lines() const { return lines_; }

 private:
  std::vector<std::string> lines_;
};

struct ReportOptions {
  std::filesystem::path out;               // empty: reports/out of the project
  std::filesystem::path scenes;            // empty: reference/published of the project
  std::string commit;                      // shown on the page; empty: not known
  std::vector<std::string> sections = {};  // ids of those to make; empty: all
};

struct ReportPlaces {
  std::filesystem::path out;        // absolute
  std::filesystem::path scenes;     // absolute
  std::filesystem::path render;     // absolute: the folder of the scripts that make the page
  std::filesystem::path root;       // the project's folder, or empty
  std::filesystem::path reference;  // absolute: the folder of exact/, baselines/ and scenes/
  std::filesystem::path templates;  // absolute: the folder of the solvers that `init` writes
  std::filesystem::path include;    // absolute: the folder of tribocheck_plugin.h

  // A file as provenance names it: from the project's root if it lies below it.
  std::string shown(const std::filesystem::path& file) const;
};

// The usual folders. The project is the nearest folder with reports/page/render and
// reference/published above the current folder, or else above the program. Where there is none, the
// program is taken as installed: its files are in share/tribocheck of its prefix. Throws
// ReportError where there is no current folder.
ReportPlaces usual_places();

// usual_places() with the folders that `options` names. Throws ReportError if the folder of the
// scenes or of the scripts does not exist.
ReportPlaces find_places(const ReportOptions& options);

// The folder of the certified tables: `given`, or reference/exact of the project if `given` is
// empty. Throws ReportError if the folder does not exist.
std::filesystem::path reference_tables(const std::filesystem::path& given);

// The files that judge somebody else's solver: the folder of the certified tables as above, the
// paper's scenes and the known mistakes. Scenes and mistakes are taken from their usual places if
// they exist there, else from beside the folder of the tables, as in a copy of reference/.
struct ReferenceFiles {
  std::string exact, published, mistakes;
};
ReferenceFiles reference_files(const std::filesystem::path& given);

// Writes the whole file or nothing. It replaces an existing file, or the file that a symbolic link
// leads to (output_behind_links()), if `replaceable` allows it. write_file() and make_folder()
// throw protocol::OutputFailed.
void write_file(const std::filesystem::path& target, std::string_view content,
                const sweep::Replaceable& replaceable = {.any = true, .only = {}});
void make_folder(const std::filesystem::path& folder);

}  // namespace tribo::report
