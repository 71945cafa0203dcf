// SPDX-License-Identifier: Apache-2.0
// The paper's figures, redrawn: what stands over, under and beside each.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/captions.hpp"

namespace tribo::report {

struct Figure {
  int number;             // in the paper
  std::string_view stem;  // "figure_07": of its script and its pictures
  std::string_view title;
  std::string scene;        // second line of the picture's title, in gnuplot's enhanced text
  std::string caption;      // markup
  std::string alternative;  // what the picture shows, for who cannot see it
  int height = 640;         // for a width of 960
  bool drawn = false;

  std::string heading() const;  // "Figure 7 redrawn: …"
};

std::vector<Figure> figures(const Findings& findings);

}  // namespace tribo::report
