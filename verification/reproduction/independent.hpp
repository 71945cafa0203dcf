// SPDX-License-Identifier: Apache-2.0
// Film and Hertz contact beside another library's numbers, reference/published/independent.tsv.
#pragma once

#include <string>
#include <vector>

namespace tribo::reproduction {

struct IndependentNumber {
  std::string case_name;  // "u = 1 m/s, F = 20 N"
  std::string quantity, unit;
  double reported, computed;
  double digits;    // of the reported number
  bool reproduced;  // to half a unit of its last digit, but for the films' documented constant
};
std::vector<IndependentNumber> independent_numbers(const std::string& path);

}  // namespace tribo::reproduction
