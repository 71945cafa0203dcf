// SPDX-License-Identifier: Apache-2.0
// A figure of the report: what stands over, under and beside it, and how gnuplot draws it.
#pragma once

#include <string>
#include <vector>

namespace tribo::report {

// The arguments of a gnuplot script of reports/page/gnuplot that shares a frame with others:
// style.gp for the paper's figures, work.gp for diagrams of error against work.
struct Drawing {
  std::string frame;     // "style.gp"
  std::string script;    // "figure_07.gp"
  std::string data;      // folder of its .tsv files, below the report's: "data"
  std::string name;      // of its data, or a prefix for the identifiers in an SVG
  std::string title;     // gnuplot's enhanced text
  std::string subtitle;  // likewise
  int height = 640;      // for a width of 960
};

struct Figure {
  std::string stem;               // "figure_07": of its pictures, and its id in the page
  std::string label;              // "Figure 7": short
  std::string heading;            // markup
  std::string caption;            // markup: what to see in it
  std::string alternative;        // plain: what it shows, for who cannot see it
  std::vector<std::string> data;  // what it is drawn from: .tsv files below the report's folder
  Drawing drawing;
  std::string svg = {};  // as gnuplot wrote it; empty: it is not drawn
};

}  // namespace tribo::report
