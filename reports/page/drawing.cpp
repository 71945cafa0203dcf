// SPDX-License-Identifier: Apache-2.0
#include "page/drawing.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <system_error>

#include "page/pending_file.hpp"

namespace tribo::report {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

std::string picture_path(const Figure& figure, std::string_view format) {
  return fmt::format("figures/{}.{}", figure.stem, format);
}

GnuplotRun draw_picture(const fs::path& scripts, const Drawing& drawing, const fs::path& data,
                        std::string_view format, const fs::path& target) {
  PendingFile file(target);
  GnuplotRun run =
      run_gnuplot(scripts / drawing.frame,
                  {drawing.script, std::string(format), file.temporary().string(), data.string(),
                   drawing.name, std::to_string(drawing.height), drawing.title, drawing.subtitle});
  if (run.end == GnuplotEnd::drawn) file.commit();
  return run;
}

std::string Draughtsman::draw_as(const Figure& figure, std::string_view format) {
  const std::string path = picture_path(figure, format);
  progress_("drawing " + path);
  const GnuplotRun run =
      draw_picture(places_.render.parent_path() / "gnuplot", figure.drawing, places_.out / figure.drawing.data, format,
                   places_.out / path);
  if (run.end == GnuplotEnd::drawn) return {};
  gnuplot_is_there_ = run.end != GnuplotEnd::not_found;
  return gnuplot_is_there_ ? fmt::format("{}: {}", path, run.message) : run.message;
}

std::string Draughtsman::draw(Figure& figure) {
  std::string why = gnuplot_is_there_ ? "" : "gnuplot was not found in PATH";
  for (const std::string_view format : {"svg", "png"})
    if (why.empty()) why = draw_as(figure, format);
  if (why.empty()) {
    figure.svg = content_of(places_.out / picture_path(figure, "svg"));
    return {};
  }
  // An old picture would not belong to the new data.
  std::error_code ignored;
  for (const std::string_view format : {"svg", "png"})
    fs::remove(places_.out / picture_path(figure, format), ignored);
  return why;
}

}  // namespace tribo::report
