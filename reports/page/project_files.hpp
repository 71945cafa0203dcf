// SPDX-License-Identifier: Apache-2.0
// Where the scenes and the scripts of the page are, and where the report goes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tribo::report {

struct ReportOptions {
  std::filesystem::path out;               // empty: reports/out of the project
  std::filesystem::path scenes;            // empty: reference/published of the project
  std::string commit;                      // for the page to tell; empty: not known
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

// The project is the nearest folder with reports/page/render and reference/published above the
// current folder, or else above the program; an installed program has both in share/tribocheck
// beside it. Throws ReportError where there is no current folder.
ReportPlaces usual_places();

// usual_places() with the folders that `options` names. Throws ReportError if the folder of the
// scenes or of the scripts does not exist.
ReportPlaces find_places(const ReportOptions& options);

// The folder of the certified tables: the one given, or reference/exact of the project where that
// is empty. Throws ReportError where it is not there.
std::filesystem::path reference_tables(const std::filesystem::path& given);

}  // namespace tribo::report
