// SPDX-License-Identifier: Apache-2.0
// Which reading a number of the paper identifies: the number with its print precision, and what
// each candidate gives.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reproduction/evaluation.hpp"

namespace tribo::reproduction {

struct Candidate {
  std::string name;
  std::optional<double> value;  // none: it gives no such number
  bool agrees;                  // within the reported interval
};

struct Argument {
  std::string question;
  std::string reported;  // "0.82/0.60 = 1.37"
  double low, high;      // by print precision
  std::vector<Candidate> candidates;

  std::size_t agreeing() const;  // one: the number identifies it
};

std::vector<Argument> arguments(const PaperScenes& scenes, const std::vector<Item>& items,
                                const std::vector<Input>& inputs);

}  // namespace tribo::reproduction
