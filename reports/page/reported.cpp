// SPDX-License-Identifier: Apache-2.0
#include "page/reported.hpp"

#include <stdexcept>

#include "page/report_error.hpp"
#include "reproduction/claims.hpp"

namespace tribo::report {

ReportedValues::ReportedValues(const ReportPlaces& places) {
  const std::filesystem::path path = places.scenes / "claims.tsv";
  file_ = places.shown(path);
  try {
    for (const reproduction::Item& item : reproduction::read_claims(path.string()))
      if (item.rule == reproduction::Rule::number)
        rows_.push_back({item.claim, std::string(reproduction::name(item.quantity)),
                         item.surface_text, item.model, item.reported, item.last_digit,
                         item.place});
  } catch (const std::runtime_error& error) {
    throw ReportError(error.what());
  }
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
