// SPDX-License-Identifier: Apache-2.0
// Reads tables of text: a line of column names, then rows; # begins a comment line. The certified
// tables of reference/exact are comma-separated, those of reference/published tab-separated.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tribo::verification {

using Columns = std::shared_ptr<const std::vector<std::string>>;

class ReferenceRow {
 public:
  ReferenceRow(Columns columns, std::string_view line, char separator);

  bool has(std::string_view column) const;
  const std::string& text(std::string_view column) const;  // throws where there is no such column
  double number(std::string_view column) const;            // hexfloat or decimal
  bool is_defined() const { return !text("value").empty(); }

  // |got − (high + low)| in units in the last place of `high` (one subnormal unit at least).
  double error_in_ulp(double got) const;

 private:
  Columns columns_;
  std::vector<std::string> cells_;
};

// The rows of a table. Throws std::runtime_error with one line that names the file and what is
// wrong with it.
std::vector<ReferenceRow> read_reference_table(const std::string& path, char separator = ',');

// Hands the rows of a tab-separated table to `take`, in their order. Throws as
// read_reference_table does; an error that `take` throws names the file too.
void each_published_row(const std::string& path,
                        const std::function<void(const ReferenceRow&)>& take);

}  // namespace tribo::verification
