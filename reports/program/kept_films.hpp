// SPDX-License-Identifier: Apache-2.0
// Films are kept in a file as soon as they are solved, so that a stopped run can go on. The file
// begins with a line that marks it. Then each film is a line of JSON: `contact`, `reason`, `text`.
// A last line without a newline is one that a killed program did not finish, and is removed.
#pragma once

#include <map>
#include <string>

#include "sweep/disk.hpp"

namespace tribo::cli {

struct KeptFilm {
  std::string reason;  // as FilmCase has it
  std::string text;    // as it is printed
};

class KeptFilms {
 public:
  // Opens the file or makes it. Throws sweep::RunRefused where something else is there, where a
  // line is no kept film, or where another process uses the file; std::runtime_error where the file
  // cannot be read or made.
  explicit KeptFilms(const std::string& path);

  // The film of a contact; null if it is not kept. `contact`: all that the film's text depends on.
  const KeptFilm* find(const std::string& contact) const;
  // Throws std::runtime_error if the film cannot be written.
  void keep(const std::string& contact, const KeptFilm& film);

 private:
  void read();

  std::string path_;
  sweep::Descriptor file_;
  std::map<std::string, KeptFilm> films_;
};

}  // namespace tribo::cli
