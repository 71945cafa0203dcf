// SPDX-License-Identifier: Apache-2.0
#include "accuracy/reference_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace tribo::verification {
namespace {

std::vector<std::string> split(std::string_view line, char separator) {
  std::vector<std::string> cells;
  while (true) {
    const std::size_t end_of_cell = line.find(separator);
    cells.emplace_back(line.substr(0, end_of_cell));
    if (end_of_cell == std::string_view::npos) return cells;
    line.remove_prefix(end_of_cell + 1);
  }
}

}  // namespace

ReferenceRow::ReferenceRow(Columns columns, std::string_view line, char separator)
    : columns_(std::move(columns)), cells_(split(line, separator)) {
  if (cells_.size() != columns_->size())
    throw std::runtime_error(fmt::format("a row of {} cells under {} columns: {}", cells_.size(),
                                         columns_->size(), line));
}

bool ReferenceRow::has(std::string_view column) const {
  return std::find(columns_->begin(), columns_->end(), column) != columns_->end();
}

const std::string& ReferenceRow::text(std::string_view column) const {
  const auto found = std::find(columns_->begin(), columns_->end(), column);
  if (found == columns_->end()) throw std::runtime_error(fmt::format("no column {}", column));
  return cells_[static_cast<std::size_t>(found - columns_->begin())];
}

double ReferenceRow::number(std::string_view column) const {
  const std::string& cell = text(column);
  char* end = nullptr;
  const double value = std::strtod(cell.c_str(), &end);
  if (cell.empty() || *end != '\0')
    throw std::runtime_error(fmt::format("row {}: {} is no number in {}", cells_[0], cell, column));
  return value;
}

double ReferenceRow::error_in_ulp(double got) const {
  const double high = number("high");
  if (!std::isfinite(got)) return std::numeric_limits<double>::infinity();
  const double unit = std::max(std::numeric_limits<double>::denorm_min(),
                               std::ldexp(1.0, high == 0 ? -1074 : std::ilogb(high) - 52));
  return std::abs((got - high) - number("low")) / unit;
}

std::vector<ReferenceRow> read_reference_table(const std::string& path, char separator) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(fmt::format("{}: cannot be read", path));
  Columns columns;
  std::vector<ReferenceRow> rows;
  std::string line;
  try {
    while (std::getline(file, line)) {
      if (line.empty() || line.starts_with('#')) continue;
      if (!columns)
        columns = std::make_shared<const std::vector<std::string>>(split(line, separator));
      else
        rows.emplace_back(columns, line, separator);
    }
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}: {}", path, error.what()));
  }
  if (rows.empty()) throw std::runtime_error(fmt::format("{}: no rows", path));
  return rows;
}

void each_published_row(const std::string& path,
                        const std::function<void(const ReferenceRow&)>& take) {
  for (const ReferenceRow& row : read_reference_table(path, '\t')) try {
      take(row);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(fmt::format("{}: {}", path, error.what()));
    }
}

}  // namespace tribo::verification
