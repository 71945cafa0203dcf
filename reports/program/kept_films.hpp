// SPDX-License-Identifier: Apache-2.0
// Films that are kept in a file as soon as they are solved, so that a stopped run goes on. The file
// begins with a line that marks it; then each film is a line of JSON, `contact`, `reason` and
// `text`. A line without its end was being written when the program was killed, and is removed.
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

  // The film of a contact, which is named by all that its text depends on; null: it is not kept.
  const KeptFilm* find(const std::string& contact) const;
  // Throws std::runtime_error where it cannot be written.
  void keep(const std::string& contact, const KeptFilm& film);

 private:
  void read();

  std::string path_;
  sweep::Descriptor file_;
  std::map<std::string, KeptFilm> films_;
};

}  // namespace tribo::cli
