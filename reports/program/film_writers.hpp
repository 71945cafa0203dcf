// SPDX-License-Identifier: Apache-2.0
// Solved films as a table, CSV or JSON.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "film_case.hpp"
#include "output.hpp"

namespace tribo::cli {

class FilmWriter {
 public:
  virtual ~FilmWriter() = default;
  virtual void add(const FilmCase& film) = 0;
  virtual void finish() {}
};

// format: "table", "csv" or "json". In CSV the rows of a profile are in place of those of films.
// `settings` must outlive the writer.
std::unique_ptr<FilmWriter> make_film_writer(std::string_view format, const FilmSettings& settings,
                                             bool with_profile, OutputStream& output);

// One film as the JSON has it.
nlohmann::ordered_json film_json(const FilmCase& film, const FilmSettings& settings,
                                 bool with_profile);

}  // namespace tribo::cli
