// SPDX-License-Identifier: Apache-2.0
#include "report/reported.hpp"

#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <system_error>

#include "report/report_error.hpp"

namespace tribo::report {
namespace {

constexpr std::size_t columns = 7;
constexpr std::size_t longest_file = std::size_t{1} << 20;

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char sign : line) {
    if (sign == '\t')
      cells.emplace_back();
    else
      cells.back() += sign;
  }
  return cells;
}

std::optional<double> positive_number(const std::string& text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || !(value > 0 && value < 1e300)) return std::nullopt;
  return value;
}

Reported row_of(const std::string& line, const std::string& where) {
  const std::vector<std::string> cells = split(line);
  if (cells.size() != columns)
    throw ReportError(fmt::format("{}: {} columns, where {} tab-separated ones are expected", where,
                                  cells.size(), columns));
  const auto value = positive_number(cells[4]), last_digit = positive_number(cells[5]);
  if (!value || !last_digit)
    throw ReportError(fmt::format("{}: value and last_digit must be numbers above 0", where));
  return {cells[0], cells[1], cells[2], cells[3], *value, *last_digit, cells[6]};
}

}  // namespace

ReportedValues::ReportedValues(const ReportPlaces& places) {
  const std::filesystem::path path = places.scenes / "reported.tsv";
  file_ = places.shown(path);
  std::error_code error;
  const bool readable = std::filesystem::is_regular_file(path, error) &&
                        std::filesystem::file_size(path, error) <= longest_file;
  std::ifstream stream(path);
  if (!readable || !stream)
    throw ReportError(fmt::format("cannot read {}, the paper's own numbers", path.string()));
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number)
    if (!line.empty() && line[0] != '#')
      rows_.push_back(row_of(line, fmt::format("{}:{}", path.string(), number)));
}

std::optional<Reported> ReportedValues::find(std::string_view quantity, std::string_view surface,
                                             std::string_view model) const {
  for (const Reported& row : rows_)
    if (row.quantity == quantity && row.surface == surface &&
        (row.model == model || row.model == "both"))
      return row;
  return std::nullopt;
}

}  // namespace tribo::report
