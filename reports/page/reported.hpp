// SPDX-License-Identifier: Apache-2.0
// What the paper reports, from claims.tsv beside the scenes.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "page/project_files.hpp"

namespace tribo::report {

struct Reported {
  std::string claim;
  std::string quantity;
  std::string surface;
  std::string model;  // GT, GW or both
  double value;
  double last_digit;  // unit of the last printed digit
  std::string place;
};

class ReportedValues {
 public:
  // Throws ReportError.
  explicit ReportedValues(const ReportPlaces& places);

  std::optional<Reported> find(std::string_view quantity, std::string_view surface,
                               std::string_view model) const;
  const std::string& file() const { return file_; }

 private:
  std::string file_;
  std::vector<Reported> rows_;
};

}  // namespace tribo::report
