// SPDX-License-Identifier: Apache-2.0
// Drawing the figures of the report, each as SVG and as PNG.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "page/figure.hpp"
#include "page/gnuplot.hpp"
#include "page/project_files.hpp"

namespace tribo::report {

// Below the report's folder.
std::string picture_path(const Figure& figure, std::string_view format);

// Draws one picture into `target`, whole or not at all. `scripts`: the folder of the gnuplot
// scripts; `data`: that of the .tsv files, in place of the drawing's own.
GnuplotRun draw_picture(const std::filesystem::path& scripts, const Drawing& drawing,
                        const std::filesystem::path& data, std::string_view format,
                        const std::filesystem::path& target);

class Draughtsman {
 public:
  Draughtsman(const ReportPlaces& places, const std::function<void(std::string_view)>& progress)
      : places_(places), progress_(progress) {}

  // Writes the pictures to figures/ and the SVG into the figure, or does neither. Returns an empty
  // text, or the reason why the figure is not drawn. If gnuplot was not found, later figures are
  // not tried.
  std::string draw(Figure& figure);

  bool gnuplot_is_there() const { return gnuplot_is_there_; }

 private:
  std::string draw_as(const Figure& figure, std::string_view format);

  const ReportPlaces& places_;
  const std::function<void(std::string_view)>& progress_;
  bool gnuplot_is_there_ = true;
};

}  // namespace tribo::report
