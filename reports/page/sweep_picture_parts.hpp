// SPDX-License-Identifier: Apache-2.0
// The pictures of a sweep, one by one.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "page/data_file.hpp"
#include "page/figure.hpp"
#include "sweep/result_file.hpp"

namespace tribo::report {

struct SweepPicture {
  Figure figure;
  DataFile data;
};

// A number to hold the onset speeds of a scene against, as it was printed.
struct ReportedOnset {
  std::string scene;
  double value, low, high;  // m/s; the ends are what rounds to the value
};

// Each picture is empty if the result does not hold its data.
std::optional<SweepPicture> onset_distribution(const sweep::SweepResult& result,
                                               const std::vector<ReportedOnset>& reported = {});
std::optional<SweepPicture> sensitivity(const sweep::SweepResult& result, std::string_view column);
std::optional<SweepPicture> curve_band(const sweep::SweepResult& result, std::string_view column);
// Throws std::runtime_error where the kept points cannot be read.
std::optional<SweepPicture> film_map(const sweep::SceneResult& scene, const std::string& path);

namespace sweep_picture {

// Below the report's folder. Pictures without a report have their data beside them instead.
inline constexpr const char* data_folder = "data/sweep";

// The colour of each scene, from the palette of Okabe and Ito. The paper's surfaces have the same
// colours as in its figures.
std::vector<std::uint32_t> colours(const sweep::SweepResult& result);
std::uint32_t pale(std::uint32_t colour);

// A text of the user's as a cell of a data file: on one line, at most `longest` signs.
std::string cell(std::string_view text, std::size_t longest = 40);
// Words for gnuplot's enhanced text as they are.
std::string plain_words(std::string_view text);
std::string in_words(std::string_view name);  // without its underscores
// "onset.film_maximum.speed" as "onset speed (film maximum)".
std::string column_words(std::string_view column);
std::string with_capital(std::string words);

struct Range {
  double low, high;
};
// The range of a logarithmic axis, with a little room at both ends.
Range with_room(Range range, double part);

SweepPicture make(const std::string& stem, const std::string& script, std::string heading,
                  std::string caption, std::string alternative, std::string subtitle, int height,
                  std::string blocks);

}  // namespace sweep_picture

}  // namespace tribo::report
